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
    if (is_single)
      {
        append(single.small);
        append(single.inverse);
      }
    else
      {
        append(full.small);
        append(full.inverse);
      }
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
    const Eigen::Index    n = 3 * nodes.size();
    const Eigen::MatrixXd small =
      Eigen::Map<const Eigen::MatrixXd>(&*next, n, n);
    next += small.size();
    AssertDimension(memory.end() - next, W.size());
    const Eigen::MatrixXd inverse =
      Eigen::Map<const Eigen::MatrixXd>(&*next, W.rows(), W.cols());
    has_inverse = true;
    changed.clear();
    // The small matrix has grown bit by bit: it is taken as it was.
    const auto take = [&](auto &op) {
      using Matrix = std::decay_t<decltype(op.inverse)>;
      op.inverse   = inverse.cast<typename Matrix::Scalar>();
      op.clear();
      extend_update(nodes);
      op.small = small.cast<typename Matrix::Scalar>();
      op.factorize();
    };
    if (is_single)
      take(single);
    else
      take(full);
  }
} // namespace squeal
