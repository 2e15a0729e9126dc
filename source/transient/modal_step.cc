// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/transient/modal_step.h>

#include <unsupported/Eigen/MatrixFunctions>

#include <Eigen/Cholesky>

#include <cmath>

namespace squeal
{
  namespace
  {
    /** The columns of exp(A dt) that carry position, velocity, force and its
     * rate of one mode over a step. */
    Eigen::Matrix4d
    propagator(const double omega_squared,
               const double damping,
               const double dt)
    {
      // In units of the step, so that the entries are of one size.
      Eigen::Matrix4d A = Eigen::Matrix4d::Zero();
      A(0, 1)           = 1.;
      A(1, 0)           = -omega_squared * dt * dt;
      A(1, 1)           = -damping * dt;
      A(1, 2)           = 1.;
      A(2, 3)           = 1.;
      return A.exp();
    }

    /** Steps of which the second half tells the growth of a motion, and the
     * growth a step from which it counts. */
    constexpr unsigned int n_trial_steps  = 400;
    constexpr double       largest_growth = 1.0005;
  } // namespace



  ModalStep::ModalStep(const ReducedContactModel &model, const double dt)
  {
    const Eigen::Index n = model.n_modes();
    for (auto *x : {&q_q, &q_v, &q_f0, &q_f1, &v_q, &v_v, &v_f0, &v_f1})
      x->resize(n);
    for (Eigen::Index k = 0; k < n; ++k)
      {
        const Eigen::Matrix4d E =
          propagator(model.omega_squared[k], model.damping[k], dt);
        q_q[k]  = E(0, 0);
        q_v[k]  = dt * E(0, 1);
        q_f1[k] = dt * dt * E(0, 3);
        q_f0[k] = dt * dt * E(0, 2) - q_f1[k];
        v_q[k]  = E(1, 0) / dt;
        v_v[k]  = E(1, 1);
        v_f1[k] = dt * E(1, 3);
        v_f0[k] = dt * E(1, 2) - v_f1[k];
      }
  }

  Eigen::MatrixXd
  ModalStep::delassus(const ReducedContactModel &model) const
  {
    const Eigen::MatrixXd &Psi = model.participation;
    return Psi * q_f1.asDiagonal() * Psi.transpose() + model.flexibility;
  }



  bool
  is_stable_step(const ReducedContactModel &model, const double dt)
  {
    const ModalStep                   step(model, dt);
    const Eigen::MatrixXd            &Psi = model.participation;
    const Eigen::LLT<Eigen::MatrixXd> W(step.delassus(model));
    if (W.info() != Eigen::Success)
      return false;
    const Eigen::Index n = model.n_modes();
    // A motion that has part in all.
    Eigen::VectorXd q      = Eigen::VectorXd::Zero(n), v(n),
                    lambda = Eigen::VectorXd::Zero(Psi.rows());
    for (Eigen::Index k = 0; k < n; ++k)
      v[k] = std::cos(1. + 2.3 * k);
    double size_of_half = 0., largest = 0.;
    for (unsigned int i = 0; i < n_trial_steps; ++i)
      {
        const Eigen::VectorXd f0   = -(Psi.transpose() * lambda);
        const Eigen::VectorXd free = step.q_q.cwiseProduct(q) +
                                     step.q_v.cwiseProduct(v) +
                                     step.q_f0.cwiseProduct(f0);
        lambda                   = W.solve(Psi * free);
        const Eigen::VectorXd f1 = -(Psi.transpose() * lambda);
        v = (step.v_q.cwiseProduct(q) + step.v_v.cwiseProduct(v) +
             step.v_f0.cwiseProduct(f0) + step.v_f1.cwiseProduct(f1))
              .eval();
        q       = free + step.q_f1.cwiseProduct(f1);
        largest = std::max(largest, v.norm());
        if (!(largest < 1e30))
          return false;
        if (i + 1 == n_trial_steps / 2)
          {
            size_of_half = largest;
            largest      = 0.;
          }
      }
    return largest <=
           size_of_half * std::pow(largest_growth, n_trial_steps / 2);
  }



  double
  largest_stable_step(const ReducedContactModel &model, const double asked)
  {
    if (is_stable_step(model, asked))
      return asked;
    double low = asked, high = asked;
    while (!is_stable_step(model, low))
      {
        high = low;
        low *= 0.5;
      }
    while (high > 1.01 * low)
      {
        const double middle                          = std::sqrt(low * high);
        (is_stable_step(model, middle) ? low : high) = middle;
      }
    return low;
  }
} // namespace squeal
