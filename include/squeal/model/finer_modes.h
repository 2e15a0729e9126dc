// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_model_finer_modes_h
#define squeal_model_finer_modes_h

#include <squeal/model/model.h>

#include <Eigen/Core>

#include <string>
#include <vector>

namespace squeal
{
  /** Names of the bodies whose volume hardly changes: Poisson ratio above 0.45
   * or, of any material, a bulk compliance below a tenth of the sum of those
   * along its axes. The errors that estimate_mode_errors() finds cell by cell
   * do not hold for their modes. */
  std::vector<std::string> nearly_incompressible_bodies(
    const SceneParameters &scene);

  /**
   * Errors (f_h - f) / f of the lowest modes of @p model, from a solution on
   * the same mesh with one degree more: what it gains times (p + 1)/2, as in
   * estimate_mode_errors(). Modes are paired in order. It has
   * ((p + 1)/p)^3 times as many unknowns.
   *
   * @param omega_squared (rad/s)^2, ascending, all modes below @p limit;
   * those below 1e-9 of the limit are rigid and have no error
   * @param limit of omega^2, the upper edge of the band
   */
  Eigen::VectorXd errors_by_next_degree(const Model           &model,
                                        const Eigen::VectorXd &omega_squared,
                                        const double           limit,
                                        Timers                &timers);
} // namespace squeal

#endif
