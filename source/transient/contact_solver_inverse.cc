// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/transient/contact_solver.h>

#include <algorithm>

namespace squeal
{
  namespace
  {
    /** More changed nodes than this, as a share of all, are no low rank. */
    constexpr double largest_share = 0.25;
  } // namespace



  void
  ContactSolver::set_jacobian(const unsigned int                        j,
                              const NodeRows                           &r,
                              Eigen::Ref<KeptInverse<double>::Jacobian> J) const
  {
    const auto  &W     = kept_operator().W;
    const double rho_n = kept_operator().rho_normal[j],
                 rho_t = kept_operator().rho_tangential[j];
    J.setZero();
    if (r.status == ContactStatus::open)
      {
        J.middleCols<3>(3 * j).setIdentity();
        return;
      }
    // W is symmetric, and its columns lie together.
    J.row(0) = rho_n * W.col(3 * j).transpose();
    if (r.status == ContactStatus::stick)
      {
        J.bottomRows<2>() = rho_t * W.middleCols<2>(3 * j + 1).transpose();
        return;
      }
    // d(lambda_t - mu p_n x/|x|) with p_n = lambda_n - rho_n g and
    // x = lambda_t + rho_t s; where mu rises with s, x takes part along it.
    const Eigen::Vector2d &d = r.direction;
    const Eigen::Matrix2d  by_x =
      r.turning * (Eigen::Matrix2d::Identity() - d * d.transpose()) +
      r.along * d * d.transpose();
    for (unsigned int c = 0; c < 2; ++c)
      J.row(1 + c) = (r.friction * rho_n * d[c] * W.col(3 * j) +
                      rho_t * by_x(c, 0) * W.col(3 * j + 1) +
                      rho_t * by_x(c, 1) * W.col(3 * j + 2))
                       .transpose();
    J.block<2, 1>(1, 3 * j) -= r.friction * d;
    J.block<2, 2>(1, 3 * j + 1) += Eigen::Matrix2d::Identity() - by_x;
  }



  void
  ContactSolver::invert()
  {
    base    = rows;
    updated = rows;
    kept    = {};
    set_inverse();
    has_inverse = true;
    ++n_inverted;
    set_update();
  }



  void
  ContactSolver::set_inverse()
  {
    KeptInverse<double>::Jacobian J(now.W.rows(), now.W.cols());
    for (Eigen::Index j = 0; j < gap.size(); ++j)
      set_jacobian(j, base[j], J.middleRows<3>(3 * j));
    if (is_single)
      single.invert(J, base);
    else
      full.invert(J, base);
  }



  void
  ContactSolver::set_update()
  {
    changed.clear();
    single.clear();
    full.clear();
    std::vector<unsigned int> nodes;
    for (Eigen::Index j = 0; j < gap.size(); ++j)
      if (!updated[j].is_near(base[j]))
        nodes.push_back(j);
    extend_update(nodes);
  }



  void
  ContactSolver::extend_update(const std::vector<unsigned int> &nodes)
  {
    std::vector<unsigned int>     places;
    KeptInverse<double>::Jacobian difference(3 * nodes.size(), now.W.cols()),
      before(3, now.W.cols());
    for (std::size_t k = 0; k < nodes.size(); ++k)
      {
        const unsigned int j = nodes[k];
        set_jacobian(j, updated[j], difference.middleRows<3>(3 * k));
        set_jacobian(j, base[j], before);
        difference.middleRows<3>(3 * k) -= before;
        const auto found = std::find(changed.begin(), changed.end(), j);
        places.push_back(found - changed.begin());
        if (found == changed.end())
          changed.push_back(j);
      }
    if (is_single)
      single.extend(difference, places, changed);
    else
      full.extend(difference, places, changed);
  }



  void
  ContactSolver::adapt(const bool renew)
  {
    std::vector<unsigned int> nodes;
    for (Eigen::Index j = 0; has_inverse && j < gap.size(); ++j)
      if (renew ? !rows[j].is_near(updated[j])
                : rows[j].status != updated[j].status)
        nodes.push_back(j);
    if (has_inverse && nodes.empty() && !renew)
      return;
    for (const unsigned int j : nodes)
      updated[j] = rows[j];
    if (!has_inverse ||
        changed.size() + nodes.size() > largest_share * gap.size())
      {
        // Nodes that have come back to what they were count no more.
        unsigned int n_changed = 0;
        for (Eigen::Index j = 0; has_inverse && j < gap.size(); ++j)
          n_changed += !rows[j].is_near(base[j]);
        if (!has_inverse || n_changed > 0.8 * largest_share * gap.size())
          return invert();
        updated = rows;
        return set_update();
      }
    extend_update(nodes);
  }
} // namespace squeal
