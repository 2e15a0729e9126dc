// SPDX-License-Identifier: LGPL-2.1-or-later

// What checkpoints keep of a contact solver.

#include <squeal/transient/contact_solver.h>

#include <deal.II/base/exceptions.h>

#include <type_traits>

namespace squeal
{
  std::vector<double>
  ContactSolver::memory() const
  {
    std::vector<double> result;
    for (const auto *list : {&base, &updated})
      for (const NodeRows &r : *list)
        for (const double value : {static_cast<double>(r.status),
                                   r.friction,
                                   r.turning,
                                   r.direction[0],
                                   r.direction[1]})
          result.push_back(value);
    const auto append = [&](const auto &matrix) {
      result.insert(result.end(), matrix.data(), matrix.data() + matrix.size());
    };
    if (!has_inverse)
      return result;
    result.push_back(is_single ? 1. : 0.);
    result.push_back(changed.size());
    result.insert(result.end(), changed.begin(), changed.end());
    const auto keep = [&](const auto &op) {
      result.push_back(op.n_applied());
      append(op.changed_columns());
      append(op.change_matrix());
    };
    if (is_single)
      keep(single);
    else
      keep(full);
    append(kept.W);
    return result;
  }

  void
  ContactSolver::restore(const std::vector<double> &memory)
  {
    if (memory.empty())
      return;
    auto next = memory.begin();
    for (auto *list : {&base, &updated})
      {
        list->resize(gap.size());
        for (NodeRows &r : *list)
          {
            r.status    = static_cast<ContactStatus>(int(*next++));
            r.friction  = *next++;
            r.turning   = *next++;
            r.direction = Eigen::Vector2d(next[0], next[1]);
            next += 2;
          }
      }
    is_single = *next++ == 1.;
    std::vector<unsigned int> nodes(static_cast<std::size_t>(*next++));
    for (unsigned int &node : nodes)
      node = static_cast<unsigned int>(*next++);
    const Eigen::Index    n         = 3 * nodes.size();
    const unsigned int    n_applied = static_cast<unsigned int>(*next++);
    const Eigen::Index    n_rows    = now.W.rows();
    const double         *rest      = memory.data() + (next - memory.begin());
    const Eigen::MatrixXd columns =
                            Eigen::Map<const Eigen::MatrixXd>(rest, n_rows, n),
                          small = Eigen::Map<const Eigen::MatrixXd>(
                            rest + columns.size(), n, n);
    const double *before = rest + (n_rows + n) * n;
    kept                 = {};
    if (before != memory.data() + memory.size())
      {
        AssertDimension(memory.data() + memory.size() - before,
                        n_rows * n_rows);
        kept =
          Operator(Eigen::Map<const Eigen::MatrixXd>(before, n_rows, n_rows));
      }
    has_inverse = true;
    changed.clear();
    set_inverse();
    const auto take = [&](auto &op) {
      using Matrix = std::decay_t<decltype(op.change_matrix())>;
      using Scalar = typename Matrix::Scalar;
      op.clear();
      extend_update(nodes);
      op.restore(columns.cast<Scalar>(), small.cast<Scalar>(), n_applied);
    };
    if (is_single)
      take(single);
    else
      take(full);
  }
} // namespace squeal
