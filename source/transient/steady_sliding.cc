// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/transient/steady_sliding.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace squeal
{
  namespace
  {
    /** Stiffness that stands in for that of rigid motions while they are
     * solved for; what it holds goes back into the load. */
    constexpr double auxiliary_frequency = 3.; // Hz

    [[noreturn]] void
    throw_none(const bool without_friction, const double reached)
    {
      if (without_friction)
        throw ComputationError("there is no steady sliding: nothing presses "
                               "the bodies of the contact together");
      throw ComputationError(
        "there is no steady sliding beyond mu = " + std::to_string(reached) +
        ": the friction wedges or sprags");
    }
  } // namespace



  unsigned int
  SteadySliding::n_closed() const
  {
    return std::count_if(status.begin(), status.end(), [](const auto s) {
      return s != ContactStatus::open;
    });
  }

  Eigen::Vector3d
  SteadySliding::resultant() const
  {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (Eigen::Index i = 0; i < forces.size(); i += 3)
      sum += forces.segment<3>(i);
    return sum;
  }



  SteadySliding
  steady_sliding(const ReducedContactModel &model,
                 const double               friction,
                 const double               load_factor)
  {
    const double    auxiliary = std::pow(2. * M_PI * auxiliary_frequency, 2);
    Eigen::VectorXd held      = Eigen::VectorXd::Zero(model.n_modes());
    Eigen::VectorXd compliance(model.n_modes());
    for (unsigned int k = 0; k < model.n_modes(); ++k)
      {
        if (model.omega_squared[k] == 0.)
          held[k] = auxiliary;
        compliance[k] = 1. / (model.omega_squared[k] + held[k]);
      }
    const Eigen::MatrixXd &Psi = model.participation;
    const Eigen::MatrixXd  W =
      Psi * compliance.asDiagonal() * Psi.transpose() + model.flexibility;

    // The target slides so far that the slip has its direction.
    ContactStep step;
    step.previous_motion = Eigen::VectorXd::Zero(Psi.rows());
    step.duration        = 1e6;
    step.friction        = friction;
    step.speed           = 1.;
    // The size of forces: that of the load on the rigid motions or, held
    // bodies, of what would close the gap.
    const Eigen::VectorXd load_motion =
      Psi * compliance.cwiseProduct(model.load) + model.load_motion;
    double approach = 0., flexibility = 0.;
    for (unsigned int j = 0; j < model.n_nodes(); ++j)
      {
        approach = std::max(approach, load_factor * load_motion[3 * j]);
        for (unsigned int i = 0; i < model.n_nodes(); ++i)
          flexibility = std::max(flexibility, std::abs(W(3 * j, 3 * i)));
      }
    const double force =
      std::max(approach / flexibility, 1e-12) / model.n_nodes();
    ContactSolver solver(W, model.initial_gap, model.speed_ratio, force, 1e-10);

    SteadySliding result;
    result.forces           = Eigen::VectorXd::Zero(Psi.rows());
    result.coordinates      = Eigen::VectorXd::Zero(model.n_modes());
    const Eigen::VectorXd f = load_factor * model.load;
    // One solution with what the auxiliary stiffness held in the load; false
    // where there is none near the forces at hand.
    const auto solve = [&](SteadySliding &state) {
      for (unsigned int i = 0; i < 100; ++i)
        {
          const Eigen::VectorXd q_free =
            compliance.cwiseProduct(f + held.cwiseProduct(state.coordinates));
          step.free_motion = Psi * q_free + load_factor * model.load_motion;
          if (!solver.newton(step, state.forces, state.report))
            return false;
          const Eigen::VectorXd q =
            q_free - compliance.cwiseProduct(Psi.transpose() * state.forces);
          const double change = held.cwiseProduct(q - state.coordinates).norm();
          state.coordinates   = q;
          if (change <= 1e-11 * f.norm())
            return true;
          if (!(change < 1e6 * f.norm()))
            return false;
        }
      return false;
    };
    // Friction comes in steps, from the solution without it, which is unique.
    double reached = 0., increment = friction;
    for (bool first = true; first || reached < friction; first = false)
      {
        step.friction = first ? 0. : std::min(reached + increment, friction);
        SteadySliding next   = result;
        const bool    solved = solve(next);
        if (!solved && (first || increment < 1e-3 * friction))
          throw_none(first, reached);
        if (!solved)
          {
            increment *= 0.5;
            continue;
          }
        result  = next;
        reached = step.friction;
      }
    result.motion = solver.motion();
    result.status = solver.status();
    return result;
  }



  namespace
  {
    /** Rows of component @p c (normal, along, across) of the closed nodes. */
    Eigen::MatrixXd
    closed_rows(const Eigen::MatrixXd &all,
                const SteadySliding   &steady,
                const int              c)
    {
      std::vector<int> rows;
      for (std::size_t j = 0; j < steady.status.size(); ++j)
        if (steady.status[j] != ContactStatus::open)
          rows.push_back(3 * j + c);
      return all(rows, Eigen::all);
    }

    /** Eigenvalues of x' = A x, x = (q, v, ...) with @p n positions. */
    LinearizedMotion
    left_vectors(Eigen::MatrixXd A, const unsigned int n)
    {
      // Every state in the unit that makes row and column alike.
      Eigen::VectorXd unit = Eigen::VectorXd::Ones(A.rows());
      for (unsigned int pass = 0; pass < 8; ++pass)
        for (Eigen::Index i = 0; i < A.rows(); ++i)
          {
            const double diagonal = std::abs(A(i, i));
            const double row      = A.row(i).cwiseAbs().sum() - diagonal,
                         column   = A.col(i).cwiseAbs().sum() - diagonal;
            if (row <= 0. || column <= 0.)
              continue;
            const double factor = std::sqrt(row / column);
            A.row(i) /= factor;
            A.col(i) *= factor;
            unit[i] *= factor;
          }
      const Eigen::EigenSolver<Eigen::MatrixXd> solver(A);
      const Eigen::MatrixXcd inverse = solver.eigenvectors().inverse();
      std::vector<int>       kept;
      for (Eigen::Index k = 0; k < A.rows(); ++k)
        if (solver.eigenvalues()[k].imag() >= 0.)
          kept.push_back(k);
      std::sort(kept.begin(), kept.end(), [&](const int a, const int b) {
        return solver.eigenvalues()[a].imag() < solver.eigenvalues()[b].imag();
      });
      LinearizedMotion result;
      result.lambda.resize(kept.size());
      result.left.resize(kept.size(), A.rows());
      for (std::size_t i = 0; i < kept.size(); ++i)
        {
          result.lambda[i] = solver.eigenvalues()[kept[i]];
          const Eigen::VectorXcd x =
            unit.asDiagonal() * solver.eigenvectors().col(kept[i]);
          result.left.row(i) = x.segment(n, n).norm() / std::sqrt(2.) *
                               inverse.row(kept[i]) *
                               unit.cwiseInverse().asDiagonal();
        }
      return result;
    }
  } // namespace



  Eigen::VectorXcd
  LinearizedMotion::amplitudes(const SteadySliding   &steady,
                               const Eigen::VectorXd &q,
                               const Eigen::VectorXd &v,
                               const Eigen::VectorXd &forces) const
  {
    Eigen::VectorXd x(left.cols());
    x.head(2 * q.size()) << q - steady.coordinates, v;
    if (left.cols() > 2 * q.size())
      x.tail(left.cols() - 2 * q.size()) =
        closed_rows(forces - steady.forces, steady, 2);
    return left * x;
  }



  LinearizedMotion
  linearize(const ReducedContactModel &model,
            const SteadySliding       &steady,
            const double               friction,
            const double               speed)
  {
    const unsigned int    m = steady.n_closed(), n = model.n_modes();
    const Eigen::MatrixXd Psi_n = closed_rows(model.participation, steady, 0),
                          Psi_t = closed_rows(model.participation, steady, 1),
                          Psi_s = closed_rows(model.participation, steady, 2);
    const auto flexibility      = [&](const int row, const int column) {
      return closed_rows(
               closed_rows(model.flexibility, steady, row).transpose(),
               steady,
               column)
        .transpose()
        .eval();
    };
    // (G_nn + mu G_nt) lambda_n + G_ns lambda_s = Psi_n q.
    const Eigen::PartialPivLU<Eigen::MatrixXd> factor(
      Eigen::MatrixXd(flexibility(0, 0) + friction * flexibility(0, 1)));
    const Eigen::MatrixXd n_by_q = factor.solve(Psi_n);
    const Eigen::MatrixXd n_by_s =
      -factor.solve(Eigen::MatrixXd(flexibility(0, 2)));
    const Eigen::MatrixXd drag = -(Psi_n + friction * Psi_t).transpose();

    // States q, v and, with friction, lambda_s = rate d/dt u_s.
    const Eigen::Index n_s  = friction > 0. ? m : 0;
    const Eigen::Index size = 2 * n + n_s;
    Eigen::MatrixXd    A    = Eigen::MatrixXd::Zero(size, size);
    A.block(0, n, n, n).setIdentity();
    A.block(n, 0, n, n) = drag * n_by_q;
    A.block(n, 0, n, n).diagonal() -= model.omega_squared;
    A.block(n, n, n, n).diagonal() -= model.damping;
    if (n_s > 0)
      {
        const Eigen::MatrixXd H =
          flexibility(2, 0) + friction * flexibility(2, 1);
        const Eigen::MatrixXd E = flexibility(2, 2) + H * n_by_s;
        Eigen::VectorXd       inverse_rate(m);
        for (unsigned int j = 0, i = 0; j < model.n_nodes(); ++j)
          if (steady.status[j] != ContactStatus::open)
            inverse_rate[i++] =
              speed * model.speed_ratio[j] /
              (friction * std::max(steady.forces[3 * j],
                                   1e-6 * steady.resultant()[0] / m));
        Eigen::MatrixXd right(m, n + m);
        right << Psi_s - H * n_by_q,
          Eigen::MatrixXd((-inverse_rate).asDiagonal());
        A.block(2 * n, n, m, n + m) = E.partialPivLu().solve(right);
        A.block(n, 2 * n, n, m)     = drag * n_by_s - Psi_s.transpose();
      }
    return left_vectors(A, n);
  }
} // namespace squeal
