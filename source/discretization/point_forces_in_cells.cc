// SPDX-License-Identifier: LGPL-2.1-or-later
#include "point_forces_in_cells.h"

#include <deal.II/distributed/tria.h>

#include <deal.II/fe/mapping.h>

namespace squeal
{
  namespace
  {
    using Force = CellErrorProblem::Force;
  } // namespace



  bool
  find_in_cell(const Discretization               &d,
               const Discretization::CellIterator &cell,
               const dealii::Point<3>             &point,
               dealii::Point<3>                   &unit)
  {
    try
      {
        unit = d.mapping().transform_real_to_unit_cell(cell, point);
      }
    catch (const dealii::Mapping<3, 3>::ExcTransformationFailed &)
      {
        return false;
      }
    for (unsigned int c = 0; c < 3; ++c)
      if (unit[c] < -1e-6 || unit[c] > 1. + 1e-6)
        return false;
    return true;
  }



  ForcesInCells
  forces_in_cells(const Discretization           &d,
                  const std::vector<PointForces> &all_forces)
  {
    const unsigned int n_cells = d.triangulation().n_active_cells();
    ForcesInCells      result{std::vector<std::vector<Force>>(n_cells),
                         std::vector<bool>(n_cells, false)};
    for (const auto &set : all_forces)
      {
        struct Hit
        {
          unsigned int     cell, point;
          dealii::Point<3> unit;
        };
        std::vector<Hit> hits;
        Eigen::MatrixXd n_holders = Eigen::MatrixXd::Zero(set.points.size(), 1);
        dealii::Point<3> unit;
        for (const auto &cell : d.dof_handler().active_cell_iterators())
          {
            if (cell->is_artificial() || cell->material_id() != set.body)
              continue;
            const unsigned int k        = cell->active_cell_index();
            const double       diameter = cell->diameter();
            const auto         centre   = cell->center();
            const bool         small =
              diameter / std::sqrt(3.) < d.degree() * set.spacing;
            for (unsigned int p = 0; p < set.points.size(); ++p)
              if (set.points[p].distance(centre) < diameter &&
                  find_in_cell(d, cell, set.points[p], unit))
                {
                  if (small)
                    result.pointwise[k] = true;
                  if (cell->is_locally_owned())
                    {
                      hits.push_back({k, p, unit});
                      n_holders(p, 0) += 1.;
                    }
                }
          }
        d.space()->sum(n_holders);
        for (const auto &hit : hits)
          result.forces[hit.cell].push_back(
            {hit.unit,
             set.forces.middleRows(3 * hit.point, 3) /
               n_holders(hit.point, 0)});
      }
    return result;
  }
} // namespace squeal
