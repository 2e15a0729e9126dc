// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/transient/modal_step.h>

#include <unsupported/Eigen/MatrixFunctions>

#include <Eigen/Cholesky>

#include <array>
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

    /**
     * exp(A) and its integrals for all modes at once, A the rates of the
     * coordinates and of their rates in units of the step:
     *   by_start = exp(A), by_force = phi_1(A) E, by_ramp = phi_2(A) E
     * with E the columns of forces. By Taylor's series on a part of the step,
     * doubled until it is the whole (Al-Mohy and Higham 2011,
     * doi:10.1137/100788860, for the doubling).
     */
    struct CoupledPropagator
    {
      CoupledPropagator(const ReducedContactModel &model, const double dt)
        : n(model.n_modes())
      {
        damping = dt * model.damping_coupling;
        damping.diagonal() += dt * model.damping;
        stiffness = dt * dt * model.omega_squared;
        const double size =
          std::max({1.,
                    stiffness.maxCoeff(),
                    damping.cwiseAbs().rowwise().sum().maxCoeff()});
        const int doublings =
          std::max(0, int(std::ceil(std::log2(size / largest_part))));
        const double part = std::ldexp(1., -doublings);

        by_start = Eigen::MatrixXd::Identity(2 * n, 2 * n);
        by_force = by_ramp = by_start.rightCols(n);
        by_ramp *= 0.5;
        Eigen::MatrixXd term = by_start;
        for (unsigned int k = 1; k <= n_terms; ++k)
          {
            term = part / k * rates(term);
            by_start += term;
            by_force += term.rightCols(n) / (k + 1.);
            by_ramp += term.rightCols(n) / ((k + 1.) * (k + 2.));
          }
        // phi_1 and phi_2 of a part of the step; forces of the whole one act
        // in (part) and (part)^2 of it.
        for (int i = 0; i < doublings; ++i)
          {
            by_ramp  = 0.25 * (by_start * by_ramp + by_force + by_ramp).eval();
            by_force = 0.5 * (by_start * by_force + by_force).eval();
            by_start = (by_start * by_start).eval();
          }
      }

      /** A x. */
      Eigen::MatrixXd
      rates(const Eigen::MatrixXd &x) const
      {
        Eigen::MatrixXd result(x.rows(), x.cols());
        result.topRows(n) = x.bottomRows(n);
        result.bottomRows(n) =
          -(stiffness.asDiagonal() * x.topRows(n)) - damping * x.bottomRows(n);
        return result;
      }

      Eigen::MatrixXd by_start, by_force, by_ramp;

    private:
      static constexpr double       largest_part = 0.25;
      static constexpr unsigned int n_terms      = 16;
      const Eigen::Index            n;
      Eigen::MatrixXd               damping;   /**< D dt */
      Eigen::VectorXd               stiffness; /**< (omega dt)^2 */
    };

    /** Steps of which the second half tells the growth of a motion, and the
     * growth a step from which it counts. */
    constexpr unsigned int n_trial_steps  = 400;
    constexpr double       largest_growth = 1.0005;
    /** Of the step that is asked for: one below is none to compute with. */
    constexpr double least_share_of_step = 1e-9;
  } // namespace



  ModalStep::ModalStep(const ReducedContactModel &model, const double dt)
  {
    if (model.has_coupled_damping())
      set_coupled(model, dt);
    else
      set_mode_by_mode(model, dt);
  }

  void
  ModalStep::set_mode_by_mode(const ReducedContactModel &model, const double dt)
  {
    const Eigen::Index             n = model.n_modes();
    std::array<Eigen::VectorXd, 8> x;
    x.fill(Eigen::VectorXd(n));
    for (Eigen::Index k = 0; k < n; ++k)
      {
        const Eigen::Matrix4d E =
          propagator(model.omega_squared[k], model.damping[k], dt);
        x[0][k] = E(0, 0);
        x[1][k] = dt * E(0, 1);
        x[3][k] = dt * dt * E(0, 3);
        x[2][k] = dt * dt * E(0, 2) - x[3][k];
        x[4][k] = E(1, 0) / dt;
        x[5][k] = E(1, 1);
        x[7][k] = dt * E(1, 3);
        x[6][k] = dt * E(1, 2) - x[7][k];
      }
    const std::array<ModalOperator *, 8> all = {
      &q_q, &q_v, &q_f0, &q_f1, &v_q, &v_v, &v_f0, &v_f1};
    for (std::size_t i = 0; i < all.size(); ++i)
      *all[i] = ModalOperator(std::move(x[i]));
  }

  void
  ModalStep::set_coupled(const ReducedContactModel &model, const double dt)
  {
    const Eigen::Index      n = model.n_modes();
    const CoupledPropagator p(model, dt);
    const auto              part = [n](const Eigen::MatrixXd &from,
                          const Eigen::Index     row,
                          const Eigen::Index     column) {
      return from.block(row * n, column * n, n, n);
    };
    const auto set = [](ModalOperator &x, const Eigen::MatrixXd &value) {
      x = ModalOperator(value);
    };
    set(q_q, part(p.by_start, 0, 0));
    set(q_v, dt * part(p.by_start, 0, 1));
    set(q_f0, dt * dt * (part(p.by_force, 0, 0) - part(p.by_ramp, 0, 0)));
    set(q_f1, dt * dt * part(p.by_ramp, 0, 0));
    set(v_q, part(p.by_start, 1, 0) / dt);
    set(v_v, part(p.by_start, 1, 1));
    set(v_f0, dt * (part(p.by_force, 1, 0) - part(p.by_ramp, 1, 0)));
    set(v_f1, dt * part(p.by_ramp, 1, 0));
  }

  Eigen::MatrixXd
  ModalStep::delassus(const ReducedContactModel &model) const
  {
    const Eigen::MatrixXd &Psi = model.participation;
    Eigen::MatrixXd        W =
      Psi * (q_f1 * Eigen::MatrixXd(Psi.transpose())) + model.flexibility;
    if (const Eigen::MatrixXd fill = fill_of_null_space(model, W);
        fill.size() > 0)
      W += fill;
    return W;
  }



  bool
  is_stable_step(const ReducedContactModel &model, const double dt)
  {
    const ModalStep        step(model, dt);
    const Eigen::MatrixXd &Psi      = model.participation;
    Eigen::MatrixXd        delassus = step.delassus(model);
    fill_where_held(delassus, model.speed_ratio);
    const Eigen::LLT<Eigen::MatrixXd> W(delassus);
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
        const Eigen::VectorXd f0 = -(Psi.transpose() * lambda);
        const Eigen::VectorXd free =
          step.q_q * q + step.q_v * v + step.q_f0 * f0;
        lambda                   = W.solve(Psi * free);
        const Eigen::VectorXd f1 = -(Psi.transpose() * lambda);
        v = (step.v_q * q + step.v_v * v + step.v_f0 * f0 + step.v_f1 * f1)
              .eval();
        q       = free + step.q_f1 * f1;
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
        if (low < least_share_of_step * asked)
          throw ComputationError(
            "the contact gives way nowhere in some direction, so that no time "
            "step is stable: lower 'Transient/Cut-off', or free the nodes of "
            "the contact that a support holds along their normals");
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
