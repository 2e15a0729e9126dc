// SPDX-License-Identifier: LGPL-2.1-or-later

// The kept inverse of a contact Jacobian against a factorisation of the
// present one: through changes of the rows of many nodes and back again, before
// and after the whole inverse is made, in both precisions, and set up again to
// the same bits.

#include "worst.h"

#include <squeal/transient/kept_inverse.h>

#include <random>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  using Rows =
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

  /** A Jacobian of contact nodes with statuses of their own. */
  struct Contact
  {
    Contact(const unsigned int n_nodes, const unsigned int seed)
      : generator(seed)
      , nodes(n_nodes)
      , J(3 * n_nodes, 3 * n_nodes)
    {
      for (unsigned int j = 0; j < n_nodes; ++j)
        set(j, static_cast<ContactStatus>((j + seed) % 3));
    }

    double
    number()
    {
      return std::uniform_real_distribution<double>(-1., 1.)(generator);
    }

    Eigen::RowVectorXd
    some_row(const Eigen::Index i)
    {
      Eigen::RowVectorXd row(J.cols());
      for (double &x : row)
        x = .5 * number() / std::sqrt(double(J.cols()));
      row[i] += 2.;
      return row;
    }

    /** Rows of node @p j by its status, as the contact solver has them. */
    void
    set(const unsigned int j, const ContactStatus status)
    {
      NodeRows &node       = nodes[j];
      node                 = NodeRows();
      node.status          = status;
      const Eigen::Index i = 3 * j;
      J.middleRows(i, 3).setZero();
      for (int c = 0; c < 3; ++c)
        if (status == ContactStatus::open)
          J(i + c, i + c) = 1.;
        else if (status == ContactStatus::stick || c == 0)
          J.row(i + c) = some_row(i + c);
      if (status != ContactStatus::slip)
        return;
      const double angle   = 3. * number();
      node.friction        = .3 + .2 * number();
      node.direction       = Eigen::Vector2d(std::cos(angle), std::sin(angle));
      const auto        &d = node.direction;
      Eigen::RowVectorXd along  = node.friction * J.row(i);
      Eigen::RowVectorXd across = some_row(i + 1);
      along.segment(i, 3) += Eigen::RowVector3d(-node.friction, d[0], d[1]);
      J.row(i + 1) = d[0] * along - d[1] * across;
      J.row(i + 2) = d[1] * along + d[0] * across;
    }

    std::mt19937          generator;
    std::vector<NodeRows> nodes;
    Rows                  J;
  };

  Eigen::VectorXd
  some_vector(const Eigen::Index n)
  {
    Eigen::VectorXd v(n);
    for (Eigen::Index i = 0; i < n; ++i)
      v[i] = std::sin(1.7 * i + .3);
    return v;
  }

  /** Residual of J x = v over the sizes of both. */
  double
  residual(const Rows &J, const Eigen::VectorXd &x, const Eigen::VectorXd &v)
  {
    return (J * x - v).norm() / (J.norm() * x.norm() + v.norm());
  }

  template <typename Scalar>
  void
  test_changes(const unsigned int n_nodes,
               const double       tolerance,
               const std::string &name)
  {
    Contact               contact(n_nodes, 1);
    const Rows            first = contact.J;
    const Eigen::VectorXd v     = some_vector(3 * n_nodes);
    KeptInverse<Scalar>   kept;
    Worst                 worst;
    kept.invert(contact.J, contact.nodes);
    kept.clear();
    worst.add(residual(contact.J, kept.apply(v), v), "at first");

    // One node after the other gets another status, some of them again, and
    // every fourth its old rows back.
    std::vector<unsigned int> changed;
    const auto                update = [&](const unsigned int j) {
      auto place = std::find(changed.begin(), changed.end(), j);
      if (place == changed.end())
        place = changed.insert(changed.end(), j);
      const Rows rows =
        contact.J.middleRows(3 * j, 3) - first.middleRows(3 * j, 3);
      kept.extend(rows, {unsigned(place - changed.begin())}, changed);
    };
    for (unsigned int step = 0; step < 3 * n_nodes; ++step)
      {
        const unsigned int j = (5 * step) % n_nodes;
        if (step % 4 == 3)
          contact.J.middleRows(3 * j, 3) = first.middleRows(3 * j, 3);
        else
          contact.set(j, static_cast<ContactStatus>((j + step) % 3));
        update(j);
        worst.add(residual(contact.J, kept.apply(v), v),
                  "step " + std::to_string(step));
      }
    // Long enough for the whole inverse.
    while (kept.n_applied() < 70)
      kept.apply(v);
    worst.add(residual(contact.J, kept.apply(v), v), "whole inverse");

    // All back: the first one again.
    for (const unsigned int j : std::vector<unsigned int>(changed))
      {
        contact.J.middleRows(3 * j, 3) = first.middleRows(3 * j, 3);
        update(j);
      }
    worst.add(residual(first, kept.apply(v), v), "all changes taken back");
    // A new start from rows that fit their statuses.
    Contact other(n_nodes, 2);
    kept.invert(other.J, other.nodes);
    kept.clear();
    check(kept.n_applied() == 0 && kept.changed_columns().cols() == 0,
          "a new start forgets");
    worst.add(residual(other.J, kept.apply(v), v), "inverted again");
    check_within(
      worst, tolerance, name + ", " + std::to_string(n_nodes) + " nodes");
  }

  /** Set up again from what it was made of: the same bits. */
  void
  test_restore(const unsigned int n_applied)
  {
    Contact                   contact(5, 1);
    const Rows                first = contact.J;
    const auto                nodes = contact.nodes;
    const Eigen::VectorXd     v     = some_vector(15);
    KeptInverse<float>        kept, again;
    std::vector<unsigned int> changed;
    kept.invert(first, nodes);
    kept.clear();
    for (const unsigned int j : {3, 1, 4})
      {
        contact.set(j, ContactStatus::stick);
        changed.push_back(j);
        kept.extend(contact.J.middleRows(3 * j, 3) - first.middleRows(3 * j, 3),
                    {unsigned(changed.size() - 1)},
                    changed);
      }
    for (unsigned int i = 0; i < n_applied; ++i)
      kept.apply(v);
    Rows differences(9, 15);
    for (unsigned int k = 0; k < 3; ++k)
      differences.middleRows(3 * k, 3) =
        contact.J.middleRows(3 * changed[k], 3) -
        first.middleRows(3 * changed[k], 3);
    again.invert(first, nodes);
    again.clear();
    again.extend(differences, {0, 1, 2}, changed);
    again.restore(
      kept.changed_columns(), kept.change_matrix(), kept.n_applied());
    check(again.n_applied() == kept.n_applied(), "as often applied");
    for (unsigned int i = 0; i < 70; ++i)
      check(kept.apply(v) == again.apply(v), "the same bits");
  }

  void
  test_edges()
  {
    KeptInverse<double> none;
    none.invert(Rows(0, 0), {});
    none.clear();
    check(none.apply(Eigen::VectorXd(0)).size() == 0, "no nodes");

    Contact open(3, 0);
    for (unsigned int j = 0; j < 3; ++j)
      open.set(j, ContactStatus::open);
    KeptInverse<double> identity;
    identity.invert(open.J, open.nodes);
    identity.clear();
    const Eigen::VectorXd v = some_vector(9);
    check(identity.apply(v) == v, "all open: what comes in goes out");

    // Rows of sizes six decades apart.
    Contact stiff(4, 1);
    for (unsigned int j = 0; j < 4; ++j)
      stiff.set(j, ContactStatus::stick);
    for (Eigen::Index i = 0; i < 12; ++i)
      stiff.J.row(i) *= std::pow(10., i % 7 - 3.);
    KeptInverse<double> scaled;
    scaled.invert(stiff.J, stiff.nodes);
    scaled.clear();
    const Eigen::VectorXd w        = some_vector(12);
    const Eigen::VectorXd expected = stiff.J.fullPivLu().solve(w);
    check((scaled.apply(w) - expected).norm() <= 1e-11 * expected.norm(),
          "rows of very different sizes");
  }

  void
  test_nearness()
  {
    NodeRows a;
    a.status    = ContactStatus::slip;
    a.friction  = .4;
    a.direction = {1., 0.};
    NodeRows b  = a;
    check(a.is_near(b), "the same rows");
    b.friction = .402;
    check(!a.is_near(b), "another friction coefficient");
    b           = a;
    b.direction = {std::cos(.2), std::sin(.2)};
    check(!a.is_near(b), "another direction");
    b.status = a.status = ContactStatus::stick;
    check(a.is_near(b), "which a sticking node has not");
    b.status = ContactStatus::open;
    check(!a.is_near(b), "another status");
  }
} // namespace



int
main()
{
  for (const unsigned int n_nodes : {1, 2, 8})
    {
      test_changes<double>(n_nodes, 1e-13, "double");
      test_changes<float>(n_nodes, 2e-5, "float");
    }
  test_restore(3);
  test_restore(65);
  test_edges();
  test_nearness();
}
