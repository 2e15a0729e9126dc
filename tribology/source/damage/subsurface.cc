// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/tribology/damage/subsurface.h>
#include <squeal/tribology/subsurface/pad_block.h>

#include <algorithm>
#include <cmath>

namespace squeal::tribology
{
  namespace
  {
    constexpr double unresolved = 2.; // finest cells
    // The correction is smooth inside: cells in distances of the nodes.
    constexpr double coarseness = 4.;

    /** Six rows for each point, three columns for each patch. */
    Eigen::MatrixXd
    half_space_influence(const std::vector<Patch>      &patches,
                         const std::vector<BlockPoint> &points,
                         const double                   poisson_ratio)
    {
      Eigen::MatrixXd influence(6 * points.size(), 3 * patches.size());
      for (std::size_t k = 0; k < patches.size(); ++k)
        for (std::size_t i = 0; i < points.size(); ++i)
          influence.block<6, 3>(6 * i, 3 * k) = patch_influence(patches[k],
                                                                points[i][0],
                                                                points[i][1],
                                                                points[i][2],
                                                                poisson_ratio);
      return influence;
    }



    bool
    is_flagged(const double                distance,
               const double                depth,
               const SubsurfaceParameters &p,
               const bool                  in_block)
    {
      const double rim = unresolved * p.finest_cell * (1. - 1e-9);
      return in_block ? distance < rim && depth < rim
                      : is_near_edge(distance, depth);
    }
  } // namespace



  bool
  is_block(const ContactGrid &grid, const SubsurfaceParameters &p)
  {
    return grid.is_grid() && p.pad_thickness > 0.;
  }



  Eigen::MatrixXd
  subsurface_influence(const ContactGrid &grid, const SubsurfaceParameters &p)
  {
    const std::size_t       n = grid.n_nodes();
    std::vector<Patch>      patches;
    std::vector<BlockPoint> points;
    double                  distance = 0.; // of the nodes
    for (std::size_t k = 0; k < n; ++k)
      {
        patches.push_back(grid.cell(k));
        const auto [x, y] = grid.place(k);
        for (const double depth : p.depths)
          points.push_back({{x, y, depth}});
        distance = std::max(distance, std::sqrt(grid.area(k)));
      }
    Eigen::MatrixXd influence =
      half_space_influence(patches, points, p.poisson_ratio);
    // The back is moved home by forces at points of the patches.
    if (is_block(grid, p) && p.pad_thickness < 2. * distance)
      throw InputError("'Subsurface/Pad thickness' is less than two distances "
                       "of the contact nodes");
    if (is_block(grid, p))
      influence += block_correction({grid.face(),
                                     p.pad_thickness,
                                     p.poisson_ratio,
                                     p.finest_cell,
                                     coarseness * distance},
                                    patches,
                                    points);
    for (std::size_t k = 0; k < n; ++k)
      influence.middleCols<3>(3 * k) *=
        grid.area(k) / ((patches[k].x_max - patches[k].x_min) *
                        (patches[k].y_max - patches[k].y_min));
    return influence;
  }



  std::vector<SubsurfacePoint>
  evaluate_subsurface(const HistoryReader                    &reader,
                      const HistoryWindow                    &window,
                      const SubsurfaceParameters             &p,
                      const FatigueParameters                &fatigue,
                      const ContactGrid                      &grid,
                      const std::function<void(std::size_t)> &progress)
  {
    const std::size_t   n         = grid.n_nodes();
    const HistoryWindow seen      = subsurface_window(window, p);
    const std::uint64_t n_samples = seen.n;
    HistorySamples      s;
    reader.read(seen.first, n_samples, s);
    Eigen::MatrixXd tractions(3 * n, n_samples);
    for (std::size_t i = 0; i < n_samples; ++i)
      for (std::size_t k = 0; k < n; ++k)
        {
          const std::size_t at    = i * n + k;
          tractions(3 * k, i)     = s.traction[2 * at];
          tractions(3 * k + 1, i) = s.traction[2 * at + 1];
          tractions(3 * k + 2, i) = s.pressure[at];
        }
    tractions *= fatigue.plateau_factor;
    const Eigen::MatrixXd stress   = subsurface_influence(grid, p) * tractions;
    const bool            in_block = is_block(grid, p);

    const MaterialLimits limits = material_limits(p, fatigue.reference_stress);
    std::vector<SubsurfacePoint> points;
    StressHistory                history(n_samples);
    for (std::size_t node = 0; node < n; ++node)
      {
        for (std::size_t d = 0; d < p.depths.size(); ++d)
          {
            const std::size_t row = 6 * points.size();
            for (std::size_t i = 0; i < n_samples; ++i)
              for (unsigned int c = 0; c < 6; ++c)
                history[i][c] = stress(row + c, i);
            SubsurfacePoint point;
            point.node        = node;
            point.depth       = p.depths[d];
            point.is_in_block = in_block;
            point.is_near_edge =
              is_flagged(grid.edge_distance(node), p.depths[d], p, in_block);
            for (const auto criterion : p.criteria)
              point.values.push_back(
                evaluate_criterion(criterion, history, limits, p.plane_step));
            points.push_back(point);
          }
        if (progress)
          progress(1);
      }
    return points;
  }
} // namespace squeal::tribology
