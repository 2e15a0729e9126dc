// SPDX-License-Identifier: LGPL-2.1-or-later

// What checkpoints keep of a contact solver.

#include <squeal/transient/contact_solver.h>

#include <limits>
#include <type_traits>

namespace squeal
{
  namespace
  {
    constexpr std::size_t last_status =
      static_cast<std::size_t>(ContactStatus::slip);

    NamedNumbers
    numbers_of(const std::vector<NodeRows> &rows)
    {
      std::vector<double> status, friction, turning, along, direction;
      for (const NodeRows &r : rows)
        {
          status.push_back(static_cast<double>(r.status));
          friction.push_back(r.friction);
          turning.push_back(r.turning);
          along.push_back(r.along);
          direction.push_back(r.direction[0]);
          direction.push_back(r.direction[1]);
        }
      NamedNumbers result;
      result.set("status", status);
      result.set("friction", friction);
      result.set("turning", turning);
      result.set("along", along);
      result.set("direction", direction);
      return result;
    }

    std::vector<NodeRows>
    rows_from(const NamedNumbers &numbers, const std::size_t n)
    {
      const auto           &status    = numbers.get("status", n);
      const auto           &friction  = numbers.get("friction", n);
      const auto           &turning   = numbers.get("turning", n);
      const auto           &along     = numbers.get("along", n);
      const auto           &direction = numbers.get("direction", 2 * n);
      std::vector<NodeRows> rows(n);
      for (std::size_t j = 0; j < n; ++j)
        {
          rows[j].status = static_cast<ContactStatus>(
            whole_number(status[j], last_status, "status"));
          rows[j].friction = friction[j];
          rows[j].turning  = turning[j];
          rows[j].along    = along[j];
          rows[j].direction =
            Eigen::Vector2d(direction[2 * j], direction[2 * j + 1]);
        }
      return rows;
    }
  } // namespace



  NamedNumbers
  ContactSolver::memory() const
  {
    NamedNumbers result;
    result.set("has_inverse", has_inverse ? 1. : 0.);
    result.set("n_inversions", static_cast<double>(n_inverted));
    if (!has_inverse)
      return result;
    result.set("base", numbers_of(base));
    result.set("updated", numbers_of(updated));
    result.set("is_single", is_single ? 1. : 0.);
    result.set("changed_nodes",
               std::vector<double>(changed.begin(), changed.end()));
    const auto keep = [&](const auto &op) {
      result.set("n_applied", static_cast<double>(op.n_applied()));
      result.set("changed_columns",
                 Eigen::MatrixXd(op.changed_columns().template cast<double>()));
      result.set("change_matrix",
                 Eigen::MatrixXd(op.change_matrix().template cast<double>()));
    };
    if (is_single)
      keep(single);
    else
      keep(full);
    result.set("kept_operator", kept.W);
    return result;
  }



  void
  ContactSolver::restore(const NamedNumbers &memory)
  {
    constexpr std::size_t any = std::numeric_limits<unsigned int>::max();
    const std::size_t     n   = gap.size();
    const unsigned int    n_inversions = memory.count("n_inversions", any);
    if (memory.count("has_inverse", 1) == 0)
      {
        n_inverted = n_inversions;
        return;
      }
    base      = rows_from(memory.group("base"), n);
    updated   = rows_from(memory.group("updated"), n);
    is_single = memory.count("is_single", 1) == 1;
    std::vector<unsigned int> nodes;
    for (const double node : memory.get("changed_nodes"))
      nodes.push_back(whole_number(node, n - 1, "changed_nodes"));
    const unsigned int    n_applied = memory.count("n_applied", any);
    const Eigen::Index    n_rows = now.W.rows(), n_changed = 3 * nodes.size();
    const Eigen::MatrixXd columns =
      memory.matrix("changed_columns", n_rows, n_changed);
    const Eigen::MatrixXd small =
      memory.matrix("change_matrix", n_changed, n_changed);
    kept        = memory.get("kept_operator").empty()
                    ? Operator()
                    : Operator(memory.matrix("kept_operator", n_rows, n_rows), ratio);
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
    n_inverted = n_inversions;
  }
} // namespace squeal
