// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/discretization/point_evaluator.h>
#include <squeal/scene/turning.h>

#include <deal.II/distributed/tria.h>

#include <deal.II/fe/mapping.h>

#include <algorithm>
#include <map>

namespace squeal
{
  namespace
  {
    /** Sends the rows that one rank found to all: counts, columns, weights. */
    void
    share_rows(std::vector<std::array<Functionals::Row, 3>> &rows,
               const std::vector<bool>                      &mine,
               const MPI_Comm                                comm)
    {
      std::vector<double> packed;
      for (unsigned int p = 0; p < rows.size(); ++p)
        if (mine[p])
          for (unsigned int c = 0; c < 3; ++c)
            for (const auto &[column, weight] : rows[p][c])
              packed.insert(packed.end(),
                            {double(p), double(c), double(column), weight});
      int n_ranks;
      MPI_Comm_size(comm, &n_ranks);
      int              size = static_cast<int>(packed.size());
      std::vector<int> sizes(n_ranks), offsets(n_ranks, 0);
      MPI_Allgather(&size, 1, MPI_INT, sizes.data(), 1, MPI_INT, comm);
      for (int r = 1; r < n_ranks; ++r)
        offsets[r] = offsets[r - 1] + sizes[r - 1];
      std::vector<double> all(offsets.back() + sizes.back());
      MPI_Allgatherv(packed.data(),
                     size,
                     MPI_DOUBLE,
                     all.data(),
                     sizes.data(),
                     offsets.data(),
                     MPI_DOUBLE,
                     comm);
      for (auto &row : rows)
        row = {};
      for (std::size_t k = 0; k < all.size(); k += 4)
        rows[static_cast<std::size_t>(all[k])]
            [static_cast<std::size_t>(all[k + 1])]
              .emplace_back(static_cast<unsigned int>(all[k + 2]), all[k + 3]);
    }
  } // namespace



  Functionals::Row
  combine(const std::vector<std::pair<double, const Functionals::Row *>> &parts)
  {
    std::map<unsigned int, double> sum;
    for (const auto &[factor, row] : parts)
      for (const auto &[column, weight] : *row)
        if (factor * weight != 0.)
          sum[column] += factor * weight;
    return Functionals::Row(sum.begin(), sum.end());
  }



  PointEvaluator::PointEvaluator(const Discretization &d)
    : discretization(d)
    , boxes(d.scene().bodies.size())
  {
    if (!d.has_mesh())
      return;
    for (const auto &cell : d.dof_handler().active_cell_iterators())
      if (cell->is_locally_owned())
        {
          CellBox box{
            cell, {{1e300, 1e300, 1e300}}, {{-1e300, -1e300, -1e300}}};
          // Curved cells bulge beyond their vertices.
          const double margin = 0.2 * cell->diameter();
          for (const unsigned int v : cell->vertex_indices())
            for (unsigned int c = 0; c < 3; ++c)
              {
                box.lower[c] =
                  std::min(box.lower[c], cell->vertex(v)[c] - margin);
                box.upper[c] =
                  std::max(box.upper[c], cell->vertex(v)[c] + margin);
              }
          boxes[cell->material_id()].push_back(box);
        }
  }



  bool
  PointEvaluator::evaluate_in(const CellBox                   &box,
                              const dealii::Point<3>          &point,
                              const double                     tolerance,
                              std::array<Functionals::Row, 3> &rows) const
  {
    for (unsigned int c = 0; c < 3; ++c)
      if (point[c] < box.lower[c] || point[c] > box.upper[c])
        return false;
    dealii::Point<3> unit;
    try
      {
        unit =
          discretization.mapping().transform_real_to_unit_cell(box.cell, point);
      }
    catch (const dealii::Mapping<3, 3>::ExcTransformationFailed &)
      {
        return false;
      }
    for (unsigned int c = 0; c < 3; ++c)
      if (unit[c] < -tolerance || unit[c] > 1. + tolerance)
        return false;

    const auto                                  &fe = box.cell->get_fe();
    std::vector<dealii::types::global_dof_index> dofs(fe.n_dofs_per_cell());
    box.cell->get_dof_indices(dofs);
    std::array<std::map<unsigned int, double>, 3> sums;
    for (unsigned int i = 0; i < dofs.size(); ++i)
      {
        const double value = fe.shape_value(i, unit);
        if (std::abs(value) < 1e-14)
          continue;
        const unsigned int c = fe.system_to_component_index(i).first;
        for (const auto &[row, weight] : discretization.expansion(dofs[i]))
          sums[c][row] += weight * value;
      }
    for (unsigned int c = 0; c < 3; ++c)
      rows[c].assign(sums[c].begin(), sums[c].end());
    return true;
  }



  PointEvaluator::Result
  PointEvaluator::rigid(const unsigned int                   body,
                        const std::vector<dealii::Point<3>> &points) const
  {
    const dealii::Point<3> x0 =
      centre_of_gravity(discretization.scene().bodies[body]);
    Result result;
    for (const auto &x : points)
      {
        std::array<Functionals::Row, 3> rows;
        const auto                      add = [&](const unsigned int c,
                             const unsigned int motion,
                             const double       weight) {
          const unsigned int row = discretization.rigid_row(body, motion);
          if (row != -1u && weight != 0.)
            rows[c].emplace_back(row, weight);
        };
        const double dx = x[0] - x0[0], dy = x[1] - x0[1], dz = x[2] - x0[2];
        for (unsigned int c = 0; c < 3; ++c)
          add(c, c, 1.);
        add(0, 4, dz);
        add(0, 5, -dy);
        add(1, 5, dx);
        add(1, 3, -dz);
        add(2, 3, dy);
        add(2, 4, -dx);
        result.rows.push_back(rows);
        result.found.push_back(true);
      }
    return result;
  }



  PointEvaluator::Result
  PointEvaluator::displacements(const unsigned int                   body,
                                const std::vector<dealii::Point<3>> &points,
                                const double tolerance) const
  {
    if (discretization.scene().bodies[body].shape ==
        BodyParameters::Shape::rigid)
      return rigid(body, points);

    Result result;
    result.rows.resize(points.size());
    const MPI_Comm   comm = discretization.space()->communicator();
    const int        rank = discretization.space()->rank();
    const int        none = 1 << 30;
    std::vector<int> owner(points.size(), none);
    for (unsigned int p = 0; p < points.size(); ++p)
      for (const auto &box : boxes[body])
        if (evaluate_in(box, points[p], tolerance, result.rows[p]))
          {
            owner[p] = rank;
            break;
          }
    // Several ranks may hold a point on a common face: the lowest one counts.
    MPI_Allreduce(MPI_IN_PLACE,
                  owner.data(),
                  static_cast<int>(owner.size()),
                  MPI_INT,
                  MPI_MIN,
                  comm);
    std::vector<bool> mine(points.size());
    for (unsigned int p = 0; p < points.size(); ++p)
      {
        mine[p] = owner[p] == rank;
        result.found.push_back(owner[p] != none);
      }
    share_rows(result.rows, mine, comm);
    return result;
  }
} // namespace squeal
