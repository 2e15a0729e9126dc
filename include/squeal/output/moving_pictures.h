// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_output_moving_pictures_h
#define squeal_output_moving_pictures_h

#include <squeal/model/mode_solution.h>
#include <squeal/output/cea_quantities.h>
#include <squeal/results/html_report.h>
#include <squeal/run/run_context.h>

namespace squeal
{
  /** @name Surfaces that move in the report
   * Collective; nothing is added without `Output/Report`, on scenes without
   * meshes and where three.js is not installed (see MotionView). */
  //@{

  /** The pairs that grow, loudest first, at most eight; without one the first
   * pairs of the band. */
  void show_pairs(RunContext           &context,
                  const Model          &model,
                  const ComplexPairs   &pairs,
                  const PairQuantities &quantities,
                  HtmlReport           &report);

  /** The first modes of the band, at most eight. */
  void show_modes(RunContext         &context,
                  const Model        &model,
                  const ModeSolution &solution,
                  HtmlReport         &report);

  /** Moments of a transient: deviations of the columns of @p motion (expanded
   * unknowns) from their mean. */
  void show_frames(RunContext        &context,
                   const Model       &model,
                   const Block       &motion,
                   const std::string &name,
                   HtmlReport        &report);
  //@}
} // namespace squeal

#endif
