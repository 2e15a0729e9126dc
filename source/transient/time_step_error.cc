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
    const Eigen::Index n = model.n_modes(), n_s = linear.left.cols() - 2 * n;
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
        // A force across the sliding at the end of a step belongs to the slip
        // rate of its middle.
        const Complex by_lag = (linear.left.row(k).tail(n_s) * linear.across *
                                linear.right.col(k).tail(n_s))
                                 .value();
        result[k] = lambda * dt * (lambda * dt / 12. * by_force + 0.5 * by_lag);
      }
    return result;
  }

  Complex
  implicit_step_error(const Complex lambda, const double dt)
  {
    return lambda * lambda * lambda * dt * dt / 12.;
  }

  Complex
  explicit_step_error(const Complex lambda,
                      const double  dt,
                      const double  beta_2)
  {
    return lambda * lambda * dt * (0.5 * (beta_2 - 0.5) - lambda * dt / 24.);
  }
} // namespace squeal
