// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_damage_subsurface_h
#define squeal_tribology_damage_subsurface_h

#include <squeal/results/contact_history.h>
#include <squeal/tribology/criteria/multiaxial.h>
#include <squeal/tribology/damage/history_damage.h>

#include <functional>
#include <string>
#include <vector>

namespace squeal::tribology
{
  /** One point below a node. */
  struct SubsurfacePoint
  {
    std::size_t                 node         = 0;
    double                      depth        = 0.; /**< m */
    bool                        is_near_edge = false;
    bool                        is_in_block  = false; /**< else half-space */
    std::vector<CriterionValue> values; /**< one for each criterion */
  };

  /**
   * Stress below every node at every depth from the tractions of the last
   * samples of a history (uniform on each nodal cell, with the nodal force of
   * the tributary area), and the criteria on it. With a thickness of the pad
   * the stress is that in a block, see block_correction(); points nearer to the
   * rim of the face than two cells are flagged. Without, it is that in a
   * half-space, which says nothing about points nearer to an edge than three
   * depths: those are flagged. Ordered by node, then depth.
   */
  std::vector<SubsurfacePoint> evaluate_subsurface(
    const HistoryReader                    &reader,
    const HistoryWindow                    &window,
    const SubsurfaceParameters             &subsurface,
    const FatigueParameters                &fatigue,
    const ContactGrid                      &grid,
    const std::function<void(std::size_t)> &progress = {});

  /** The last samples of @p window, on which the criteria are evaluated. */
  HistoryWindow subsurface_window(const HistoryWindow        &window,
                                  const SubsurfaceParameters &subsurface);

  /** One line where these samples leave out more than 2 % of the largest range
   * that a traction or pressure of a node has in the whole window, as where
   * they hold no period or the vibration ends before; else nothing. Reads the
   * window in pieces of @p n_chunk samples. */
  std::string note_on_subsurface_window(const HistoryReader        &reader,
                                        const HistoryWindow        &window,
                                        const SubsurfaceParameters &subsurface,
                                        std::size_t                 n_chunk);

  /** Six rows for each point (node, depth), three columns (traction x, y,
   * pressure) for each node: of a half-space, or of a block. */
  Eigen::MatrixXd subsurface_influence(const ContactGrid          &grid,
                                       const SubsurfaceParameters &subsurface);

  /** Whether the stress is that in a block: a rectangular grid of nodes and a
   * thickness are needed. */
  bool is_block(const ContactGrid          &grid,
                const SubsurfaceParameters &subsurface);
} // namespace squeal::tribology

#endif
