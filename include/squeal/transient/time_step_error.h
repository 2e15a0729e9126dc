// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_transient_time_step_error_h
#define squeal_transient_time_step_error_h

#include <squeal/transient/linearized_motion.h>

namespace squeal
{
  /** @name What steps of @p dt seconds add to lambda = sigma + i omega of the
   * linear motion, 1/s, to leading order in dt: doc/theory/steady_sliding.md.
   * @p by_slope, @p by_viscosity: as in LinearizedMotion. A coefficient of friction that falls
   * with the slip rate is that of the step before. */
  //@{
  /** Of the reduced integrator, for every pair of @p linear: contact forces
   * that are linear within a step, and slip rates of viscous forces that are
   * those of the middle of a step. */
  Eigen::VectorXcd reduced_step_error(const ReducedContactModel &model,
                                      const LinearizedMotion    &linear,
                                      const double               dt);

  /** Of the implicit integrator: (lambda dt)^2 / 12 of lambda. */
  std::complex<double> implicit_step_error(
    const std::complex<double> lambda,
    const double               dt,
    const std::complex<double> by_slope = 0.);

  /** Of the explicit integrator, without what the lag of the bodies' damping
   * adds. */
  std::complex<double> explicit_step_error(
    const std::complex<double> lambda,
    const double               dt,
    const double               beta_2,
    const std::complex<double> by_slope     = 0.,
    const std::complex<double> by_viscosity = 0.);
  //@}
} // namespace squeal

#endif
