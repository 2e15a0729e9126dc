// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/transient/time_step_error.h>

namespace squeal
{
  using Complex = std::complex<double>;

  Eigen::VectorXcd
  reduced_step_error(const ReducedContactModel &model,
                     const LinearizedMotion    &linear,
                     const double               dt)
  {
    const Eigen::Index n = model.n_modes();
    Eigen::VectorXcd   result(linear.lambda.size());
    for (Eigen::Index k = 0; k < result.size(); ++k)
      {
        const Complex lambda = linear.lambda[k];
        // A force e^(lambda t) between straight lines acts on a motion of its
        // own lambda as (sinh(z/2)/(z/2))^2 = 1 + z^2/12 of it, z = lambda dt;
        // the contact's forces are (lambda^2 + lambda D + Omega^2) q.
        const Eigen::VectorXcd q = linear.right.col(k).head(n);
        const Complex          by_force =
          (linear.left.row(k).segment(n, n) *
           (lambda * (lambda * q + model.damping_forces(q)) +
            model.omega_squared.cwiseProduct(q)))
            .value();
        // A viscous force at the end of a step belongs to the slip rate of its
        // middle. Falling friction there follows the mean slip rate of the step
        // before, whose middle is 3/2 steps back.
        const Complex z = lambda * dt;
        result[k] =
          z * z / 12. * by_force +
          linear.by_viscosity[k] * (std::exp(-0.5 * z) - 1.) +
          linear.by_slope[k] * (std::exp(-1.5 * z) * (1. + z * z / 24.) - 1.);
      }
    return result;
  }

  Complex
  implicit_step_error(const Complex lambda,
                      const double  dt,
                      const Complex by_slope)
  {
    // Forces and slip rates are those of the middle of a step; its mean slip
    // rate is the scheme's own.
    return lambda * lambda * lambda * dt * dt / 12. +
           by_slope * (std::exp(-lambda * dt) - 1.);
  }

  Complex
  explicit_step_error(const Complex lambda,
                      const double  dt,
                      const double  beta_2,
                      const Complex by_slope,
                      const Complex by_viscosity)
  {
    // Forces act at the start of a step, half a step after the middle of the
    // one before. Of its mean slip rate, z^2/24 too large, nothing is left: an
    // acceleration that is z^2/12 too large takes as much off. Viscous forces
    // belong to the slip rate of the middle of the step.
    return lambda * lambda * dt * (0.5 * (beta_2 - 0.5) - lambda * dt / 24.) +
           by_slope * (std::exp(-0.5 * lambda * dt) - 1.) +
           by_viscosity * (std::exp(0.5 * lambda * dt) - 1.);
  }
} // namespace squeal
