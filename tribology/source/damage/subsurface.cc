// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/tribology/damage/subsurface.h>

#include <algorithm>

namespace squeal::tribology
{
  Eigen::MatrixXd
  subsurface_influence(const ContactGrid         &grid,
                       const std::vector<double> &depths,
                       const double               poisson_ratio)
  {
    const std::size_t n = grid.n_nodes();
    Eigen::MatrixXd   influence(6 * n * depths.size(), 3 * n);
    for (std::size_t source = 0; source < n; ++source)
      {
        const Patch &cell  = grid.cell(source);
        const double share = grid.area(source) / ((cell.x_max - cell.x_min) *
                                                  (cell.y_max - cell.y_min));
        for (std::size_t node = 0; node < n; ++node)
          {
            const auto [x, y] = grid.place(node);
            for (std::size_t d = 0; d < depths.size(); ++d)
              influence.block<6, 3>(6 * (node * depths.size() + d),
                                    3 * source) =
                share * patch_influence(cell, x, y, depths[d], poisson_ratio);
          }
      }
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
    const std::size_t   n = grid.n_nodes();
    const std::uint64_t n_samples =
      std::min<std::uint64_t>(p.n_samples, window.n);
    HistorySamples s;
    reader.read(window.first + window.n - n_samples, n_samples, s);
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
    const Eigen::MatrixXd stress =
      subsurface_influence(grid, p.depths, p.poisson_ratio) * tractions;

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
            point.node  = node;
            point.depth = p.depths[d];
            point.is_near_edge =
              is_near_edge(grid.edge_distance(node), p.depths[d]);
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
