// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_damage_subsurface_h
#define squeal_tribology_damage_subsurface_h

#include <squeal/results/contact_history.h>
#include <squeal/tribology/criteria/multiaxial.h>
#include <squeal/tribology/damage/history_damage.h>

#include <functional>
#include <vector>

namespace squeal::tribology
{
  /** One point below a node. */
  struct SubsurfacePoint
  {
    std::size_t                 node         = 0;
    double                      depth        = 0.; /**< m */
    bool                        is_near_edge = false;
    std::vector<CriterionValue> values; /**< one for each criterion */
  };

  /**
   * Stress below every node at every depth from the tractions of the last
   * samples of a history (uniform on each nodal cell, with the nodal force of
   * the tributary area), and the criteria on it. Points nearer to an edge of
   * the face than three depths are flagged: there a half-space says nothing.
   * Ordered by node, then depth.
   */
  std::vector<SubsurfacePoint> evaluate_subsurface(
    const HistoryReader                    &reader,
    const HistoryWindow                    &window,
    const SubsurfaceParameters             &subsurface,
    const FatigueParameters                &fatigue,
    const ContactGrid                      &grid,
    const std::function<void(std::size_t)> &progress = {});

  /** Six rows for each point (node, depth), three columns (traction x, y,
   * pressure) for each node. */
  Eigen::MatrixXd subsurface_influence(const ContactGrid         &grid,
                                       const std::vector<double> &depths,
                                       double poisson_ratio);
} // namespace squeal::tribology

#endif
