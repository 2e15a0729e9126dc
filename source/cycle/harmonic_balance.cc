// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/base/worst_of.h>
#include <squeal/cycle/harmonic_balance.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <string>

namespace squeal
{
  namespace
  {
    using Complex = std::complex<double>;

    constexpr Eigen::Index largest_matrix = 6000;
    /** Of a difference quotient over a frequency or a damping. */
    constexpr double increment = 1e-7;
    /** A step is shortened where the residual grows by more than this. */
    constexpr double       accepted_growth = 2.;
    constexpr unsigned int halvings        = 4;
    /** The frequency changes by no more than this share in an iteration. */
    constexpr double largest_change = 0.1;

    /** Values at n equal parts of the period from harmonics. */
    Eigen::MatrixXd
    values_of(const Eigen::MatrixXcd &harmonics, const unsigned int n)
    {
      Eigen::MatrixXd result(harmonics.rows(), n);
      for (unsigned int i = 0; i < n; ++i)
        {
          Eigen::VectorXd x = harmonics.col(0).real();
          for (Eigen::Index k = 1; k < harmonics.cols(); ++k)
            x += 2. * (harmonics.col(k) *
                       std::polar(1., 2. * M_PI * double(k * i % n) / n))
                        .real();
          result.col(i) = x;
        }
      return result;
    }

    /** Harmonics of the rate. */
    Eigen::MatrixXcd
    rates_of(Eigen::MatrixXcd harmonics, const double omega)
    {
      for (Eigen::Index k = 0; k < harmonics.cols(); ++k)
        harmonics.col(k) *= Complex(0., k * omega);
      return harmonics;
    }
  } // namespace



  Eigen::MatrixXcd
  harmonics_of(const Eigen::MatrixXd &values)
  {
    const Eigen::Index n = values.cols(), H = (n - 1) / 2;
    Eigen::MatrixXcd   basis(n, H + 1);
    for (Eigen::Index i = 0; i < n; ++i)
      for (Eigen::Index k = 0; k <= H; ++k)
        basis(i, k) = std::polar(1. / n, -2. * M_PI * double(k * i % n) / n);
    return values * basis;
  }

  Eigen::MatrixXd
  resampled(const Eigen::MatrixXd &values, const unsigned int n)
  {
    return values.cols() == n ? values : values_of(harmonics_of(values), n);
  }



  HarmonicMotion
  harmonic_start(const ReducedContactModel &model, const PeriodicMotion &motion)
  {
    const unsigned int n = motion.orbit.n_steps();
    HarmonicMotion     result;
    result.omega = 2. * M_PI / motion.period;
    result.forces.resize(3 * model.n_nodes(), n);
    Eigen::VectorXd mean = Eigen::VectorXd::Zero(model.n_modes());
    for (unsigned int i = 0; i < n; ++i)
      {
        result.forces.col(i) = motion.orbit.states[i].forces;
        mean += motion.orbit.states[i].coordinates / n;
      }
    std::vector<double> positions;
    for (unsigned int k = 0; k < model.n_modes(); ++k)
      if (model.omega_squared[k] == 0.)
        positions.push_back(mean[k]);
    result.positions =
      Eigen::Map<Eigen::VectorXd>(positions.data(), positions.size());
    return result;
  }



  double
  PeriodLedger::imbalance() const
  {
    return std::abs(driving - friction - damping - numerical) /
           std::max(std::abs(driving), std::numeric_limits<double>::min());
  }



  /** The projected law at a node and how it changes. */
  struct HarmonicBalance::Law
  {
    ContactStatus   status = ContactStatus::open;
    Eigen::Vector3d missed = Eigen::Vector3d::Zero(); /**< lambda - P, N */
    /** By lambda, u and its rate. */
    Eigen::Matrix3d by_force  = Eigen::Matrix3d::Identity(),
                    by_motion = Eigen::Matrix3d::Zero(),
                    by_rate   = Eigen::Matrix3d::Zero();
  };



  HarmonicBalance::HarmonicBalance(const ReducedContactModel &m,
                                   CycleFriction              f,
                                   const double               nodal_force,
                                   const unsigned int         n_samples)
    : model(m)
    , friction(std::move(f))
    , force(nodal_force)
    , n(n_samples)
  {
    if (n < 3 || n % 2 == 0)
      throw InputError("harmonic balance needs an odd number of samples from "
                       "3 on, not " +
                       std::to_string(n));
    for (unsigned int k = 0; k < m.n_modes(); ++k)
      if (m.omega_squared[k] == 0.)
        free.push_back(k);
  }



  Eigen::VectorXcd
  HarmonicBalance::receptance(const unsigned int    k,
                              const HarmonicMotion &m) const
  {
    Eigen::VectorXcd result(model.n_modes());
    const double     w = k * m.omega;
    for (Eigen::Index j = 0; j < result.size(); ++j)
      if (k == 0 && model.omega_squared[j] == 0.)
        result[j] = 0.;
      else
        result[j] =
          1. /
          Complex(model.omega_squared[j] - w * w,
                  w * (model.damping[j] + (k > 0 ? m.excess_damping : 0.)));
    return result;
  }

  Eigen::MatrixXcd
  HarmonicBalance::modal_harmonics(const HarmonicMotion &m) const
  {
    Eigen::MatrixXcd q =
      -(model.participation.transpose() * harmonics_of(m.forces));
    q.col(0) += model.load;
    for (Eigen::Index k = 0; k < q.cols(); ++k)
      q.col(k) = q.col(k).cwiseProduct(receptance(k, m)).eval();
    for (std::size_t i = 0; i < free.size(); ++i)
      q(free[i], 0) = m.positions[i];
    return q;
  }

  Eigen::MatrixXcd
  HarmonicBalance::relative_motion(const Eigen::MatrixXcd &q,
                                   const Eigen::MatrixXcd &lambda) const
  {
    return model.participation * q - model.flexibility * lambda;
  }



  HarmonicBalance::Law
  HarmonicBalance::law_at(const unsigned int     j,
                          const Eigen::Vector3d &lambda,
                          const Eigen::Vector3d &u,
                          const Eigen::Vector3d &rate,
                          const double           omega) const
  {
    double normal_give = model.flexibility(3 * j, 3 * j), give = 0.;
    for (unsigned int c = 1; c < 3; ++c)
      give = std::max(give, model.flexibility(3 * j + c, 3 * j + c));
    for (unsigned int k = 0; k < model.n_modes(); ++k)
      {
        const double stiffness =
          std::max(model.omega_squared[k], omega * omega);
        const auto psi = model.participation.col(k).segment<3>(3 * j);
        normal_give += psi[0] * psi[0] / stiffness;
        give += std::max(psi[1] * psi[1], psi[2] * psi[2]) / stiffness;
      }
    const double rho = 1. / normal_give, rho_rate = 1. / (give * omega);
    const double p = lambda[0] - rho * (model.initial_gap[j] - u[0]);
    Law          law;
    if (p <= 0.)
      {
        law.missed = lambda;
        return law;
      }
    const Eigen::Vector2d rate_t(
      rate[1] + friction.speed * model.speed_ratio[j], rate[2]);
    const Eigen::Vector2d tried = lambda.tail<2>() + rho_rate * rate_t;
    const double          size = tried.norm(), mu = friction.kinetic[j];
    law.missed[0]       = lambda[0] - p;
    law.by_force(0, 0)  = 0.;
    law.by_motion(0, 0) = -rho;
    if (size > friction.limit_at_rest(j) * p)
      {
        const Eigen::Vector2d d = tried / size;
        const Eigen::Matrix2d turning =
          mu * p / size * (Eigen::Matrix2d::Identity() - d * d.transpose());
        law.status           = ContactStatus::slip;
        law.missed.tail<2>() = lambda.tail<2>() - mu * p * d;
        law.by_force.bottomRightCorner<2, 2>() -= turning;
        law.by_force.block<2, 1>(1, 0)        = -mu * d;
        law.by_motion.block<2, 1>(1, 0)       = -mu * rho * d;
        law.by_rate.bottomRightCorner<2, 2>() = -rho_rate * turning;
      }
    else
      {
        law.status           = ContactStatus::stick;
        law.missed.tail<2>() = -rho_rate * rate_t;
        law.by_force.bottomRightCorner<2, 2>().setZero();
        law.by_rate.bottomRightCorner<2, 2>() =
          -rho_rate * Eigen::Matrix2d::Identity();
      }
    return law;
  }



  void
  HarmonicBalance::evaluate(HarmonicMotion &m) const
  {
    const Eigen::MatrixXcd lambda = harmonics_of(m.forces);
    Eigen::MatrixXcd       u      = relative_motion(modal_harmonics(m), lambda);
    u.col(0) += model.load_motion;
    m.motion   = values_of(u, n);
    m.rate     = values_of(rates_of(u, m.omega), n);
    m.residual = 0.;
    m.status.assign(n, std::vector<ContactStatus>(model.n_nodes()));
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < model.n_nodes(); ++j)
        {
          const Law law  = law_at(j,
                                 m.forces.col(i).segment<3>(3 * j),
                                 m.motion.col(i).segment<3>(3 * j),
                                 m.rate.col(i).segment<3>(3 * j),
                                 m.omega);
          m.status[i][j] = law.status;
          m.residual =
            worst_of(m.residual, worst_of(law.missed.cwiseAbs()) / force);
        }
  }



  double
  HarmonicBalance::violation_between(const HarmonicMotion &m,
                                     const unsigned int    factor) const
  {
    const unsigned int     fine   = factor * n;
    const Eigen::MatrixXcd lambda = harmonics_of(m.forces);
    Eigen::MatrixXcd       u      = relative_motion(modal_harmonics(m), lambda);
    u.col(0) += model.load_motion;
    const Eigen::MatrixXd f = values_of(lambda, fine), x = values_of(u, fine),
                          v = values_of(rates_of(u, m.omega), fine);
    double worst            = 0.;
    for (unsigned int i = 0; i < fine; ++i)
      for (unsigned int j = 0; j < model.n_nodes(); ++j)
        worst = worst_of(worst,
                         worst_of(law_at(j,
                                         f.col(i).segment<3>(3 * j),
                                         x.col(i).segment<3>(3 * j),
                                         v.col(i).segment<3>(3 * j),
                                         m.omega)
                                    .missed.cwiseAbs()) /
                           force);
    return worst;
  }



  PeriodLedger
  HarmonicBalance::ledger(const HarmonicMotion &m) const
  {
    PeriodLedger           e;
    const double           period = 2. * M_PI / m.omega, dt = period / n;
    const Eigen::MatrixXcd q = modal_harmonics(m);
    for (Eigen::Index k = 1; k < q.cols(); ++k)
      e.damping += period * 2. * std::pow(k * m.omega, 2) *
                   (model.damping.array() + m.excess_damping)
                     .matrix()
                     .dot(q.col(k).cwiseAbs2());
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < model.n_nodes(); ++j)
        {
          const Eigen::Vector3d f = m.forces.col(i).segment<3>(3 * j),
                                v = m.rate.col(i).segment<3>(3 * j);
          const double way        = friction.speed * model.speed_ratio[j];
          e.driving += dt * f[1] * way;
          e.friction += dt * (f[1] * (way + v[1]) + f[2] * v[2]);
          e.numerical += dt * f[0] * v[0];
        }
    return e;
  }



  /** The linear problem of a Newton iteration: closed forces, then the mean
   * positions, the frequency and the excess damping in shares of omega. */
  struct HarmonicBalance::Jacobian
  {
    struct Closed
    {
      unsigned int sample, node;
    };
    const HarmonicBalance &b;
    const HarmonicMotion  &m;
    std::vector<Closed>    closed;
    std::vector<Law>       laws;
    Eigen::MatrixXd        A;
    Eigen::VectorXd        rhs;

    /** By the parts of a period between force and motion. */
    std::vector<Eigen::MatrixXd> by_force, rate_by_force;

    Jacobian(const HarmonicBalance &balance, const HarmonicMotion &motion)
      : b(balance)
      , m(motion)
    {
      Eigen::MatrixXd open = Eigen::MatrixXd::Zero(m.forces.rows(), b.n);
      for (unsigned int i = 0; i < b.n; ++i)
        for (unsigned int j = 0; j < b.model.n_nodes(); ++j)
          {
            const Law law = b.law_at(j,
                                     m.forces.col(i).segment<3>(3 * j),
                                     m.motion.col(i).segment<3>(3 * j),
                                     m.rate.col(i).segment<3>(3 * j),
                                     m.omega);
            if (law.status == ContactStatus::open)
              open.col(i).segment<3>(3 * j) =
                -m.forces.col(i).segment<3>(3 * j);
            else
              {
                closed.push_back({i, j});
                laws.push_back(law);
              }
          }
      const Eigen::Index n_rows = 3 * closed.size() + b.free.size() + 2;
      if (n_rows > largest_matrix)
        throw InputError("harmonic balance: a matrix of " +
                         std::to_string(n_rows) + " rows, at most " +
                         std::to_string(largest_matrix) +
                         "; fewer samples or contact nodes");
      A   = Eigen::MatrixXd::Zero(n_rows, n_rows);
      rhs = Eigen::VectorXd::Zero(n_rows);
      set_kernels();
      set_forces();
      set_laws(open);
    }

    void
    set_kernels()
    {
      const Eigen::Index H = (b.n - 1) / 2, rows = m.forces.rows();
      by_force.assign(b.n, Eigen::MatrixXd::Zero(rows, rows));
      rate_by_force = by_force;
      for (Eigen::Index k = 0; k <= H; ++k)
        {
          const Eigen::VectorXcd d   = b.receptance(k, m);
          const Eigen::MatrixXd &Psi = b.model.participation;
          Eigen::MatrixXd        re =
            Psi * d.real().asDiagonal() * Psi.transpose() + b.model.flexibility;
          Eigen::MatrixXd im = Psi * d.imag().asDiagonal() * Psi.transpose();
          for (unsigned int s = 0; s < b.n; ++s)
            {
              const double angle = 2. * M_PI * double(k * s % b.n) / b.n;
              const double share = (k == 0 ? 1. : 2.) / b.n;
              const double c     = share * std::cos(angle),
                           z     = share * std::sin(angle);
              by_force[s] -= c * re - z * im;
              rate_by_force[s] += k * m.omega * (z * re + c * im);
            }
        }
    }

    void
    set_forces()
    {
      for (std::size_t r = 0; r < closed.size(); ++r)
        {
          A.block<3, 3>(3 * r, 3 * r) += laws[r].by_force;
          for (std::size_t c = 0; c < closed.size(); ++c)
            {
              const unsigned int s =
                (closed[r].sample + b.n - closed[c].sample) % b.n;
              A.block<3, 3>(3 * r, 3 * c) +=
                laws[r].by_motion * by_force[s].block<3, 3>(
                                      3 * closed[r].node, 3 * closed[c].node) +
                laws[r].by_rate * rate_by_force[s].block<3, 3>(
                                    3 * closed[r].node, 3 * closed[c].node);
            }
        }
    }

    /** How the law changes with other motions at all samples. */
    Eigen::VectorXd
    law_by(const Eigen::MatrixXd &u, const Eigen::MatrixXd &rate) const
    {
      Eigen::VectorXd result(3 * closed.size());
      for (std::size_t r = 0; r < closed.size(); ++r)
        result.segment<3>(3 * r) =
          laws[r].by_motion *
            u.col(closed[r].sample).segment<3>(3 * closed[r].node) +
          laws[r].by_rate *
            rate.col(closed[r].sample).segment<3>(3 * closed[r].node);
      return result;
    }

    /** The same motion with another frequency or damping, per share of
     * omega. */
    Eigen::VectorXd
    law_by_number(const double omega_share, const double damping_share) const
    {
      HarmonicMotion other = m;
      other.omega *= 1. + increment * omega_share;
      other.excess_damping += increment * damping_share * m.omega;
      b.evaluate(other);
      return law_by((other.motion - m.motion) / increment,
                    (other.rate - m.rate) / increment);
    }

    void
    set_laws(const Eigen::MatrixXd &open)
    {
      const Eigen::Index n_laws = 3 * closed.size(), n_free = b.free.size();
      for (std::size_t r = 0; r < closed.size(); ++r)
        rhs.segment<3>(3 * r) = -laws[r].missed;
      // Forces of open nodes go to zero and take their motion along.
      HarmonicMotion without = m;
      without.forces += open;
      b.evaluate(without);
      rhs.head(n_laws) -=
        law_by(without.motion - m.motion, without.rate - m.rate);
      const Eigen::MatrixXd still = Eigen::MatrixXd::Zero(m.forces.rows(), b.n);
      for (Eigen::Index i = 0; i < n_free; ++i)
        {
          const auto psi                 = b.model.participation.col(b.free[i]);
          A.col(n_laws + i).head(n_laws) = law_by(psi.replicate(1, b.n), still);
          for (std::size_t c = 0; c < closed.size(); ++c)
            A.row(n_laws + i).segment<3>(3 * c) =
              psi.segment<3>(3 * closed[c].node).transpose() / b.n;
          rhs[n_laws + i] =
            b.model.load[b.free[i]] - psi.dot(without.forces.rowwise().mean());
        }
      A.col(n_laws + n_free).head(n_laws)     = law_by_number(1., 0.);
      A.col(n_laws + n_free + 1).head(n_laws) = law_by_number(0., 1.);
    }

    /** The first harmonic of mode @p mode is to be @p size along @p direction
     * (where @p held asks for that), with nothing across it. */
    void
    set_conditions(const unsigned int mode,
                   const Complex      direction,
                   const double       size_wanted,
                   const Held         held)
    {
      const Eigen::Index at  = rhs.size() - 2;
      const Complex response = b.receptance(1, m)[mode] * std::conj(direction);
      Eigen::VectorXcd by    = Eigen::VectorXcd::Zero(rhs.size());
      for (std::size_t c = 0; c < closed.size(); ++c)
        {
          const Complex turn =
            -response *
            std::polar(1. / b.n, -2. * M_PI * closed[c].sample / b.n);
          by.segment<3>(3 * c) =
            turn *
            b.model.participation.col(mode).segment<3>(3 * closed[c].node);
        }
      const auto component = [&](const HarmonicMotion &x) {
        return std::conj(direction) * b.modal_harmonics(x)(mode, 1);
      };
      HarmonicMotion without = m;
      for (unsigned int i = 0; i < b.n; ++i)
        for (unsigned int j = 0; j < b.model.n_nodes(); ++j)
          if (m.status[i][j] == ContactStatus::open)
            without.forces.col(i).segment<3>(3 * j).setZero();
      const Complex  now    = component(m);
      HarmonicMotion faster = m, damped = m;
      faster.omega *= 1. + increment;
      damped.excess_damping += increment * m.omega;
      by[at]              = (component(faster) - now) / increment;
      by[at + 1]          = (component(damped) - now) / increment;
      const Complex rest  = component(without);
      const double  scale = std::max(std::abs(now), size_wanted);
      A.row(at)           = by.imag() / scale;
      rhs[at]             = -rest.imag() / scale;
      switch (held)
        {
        case Held::amplitude:
          A.row(at + 1) = by.real() / scale;
          rhs[at + 1]   = (size_wanted - rest.real()) / scale;
          break;
        case Held::frequency:
          A(at + 1, at) = 1.;
          break;
        case Held::no_excess:
          A(at + 1, at + 1) = 1.;
          rhs[at + 1]       = -m.excess_damping / m.omega;
          break;
        }
    }

    /** m + share of the step. */
    HarmonicMotion
    moved(const Eigen::VectorXd &step, const double share) const
    {
      HarmonicMotion next = m;
      for (unsigned int i = 0; i < b.n; ++i)
        for (unsigned int j = 0; j < b.model.n_nodes(); ++j)
          if (m.status[i][j] == ContactStatus::open)
            next.forces.col(i).segment<3>(3 * j) *= 1. - share;
      for (std::size_t c = 0; c < closed.size(); ++c)
        next.forces.col(closed[c].sample).segment<3>(3 * closed[c].node) +=
          share * step.segment<3>(3 * c);
      next.positions += share * step.segment(3 * closed.size(), b.free.size());
      next.omega *= 1. + share * step[step.size() - 2];
      next.excess_damping += share * m.omega * step[step.size() - 1];
      b.evaluate(next);
      return next;
    }
  };



  HarmonicMotion
  HarmonicBalance::solve(HarmonicMotion     m,
                         const Held         held,
                         const double       tolerance,
                         const unsigned int iterations) const
  {
    m.forces = resampled(m.forces, n);
    if (m.positions.size() != static_cast<Eigen::Index>(free.size()))
      m.positions = Eigen::VectorXd::Zero(free.size());
    m.converged  = false;
    m.iterations = 0;
    evaluate(m);
    const Eigen::VectorXcd first = modal_harmonics(m).col(1);
    Eigen::Index           mode;
    first.cwiseAbs().maxCoeff(&mode);
    const double  size_wanted = std::abs(first[mode]);
    const Complex direction =
      size_wanted > 0. ? first[mode] / size_wanted : Complex(1.);
    for (; m.iterations < iterations;)
      {
        Jacobian J(*this, m);
        J.set_conditions(mode, direction, size_wanted, held);
        const Eigen::VectorXd step = J.A.partialPivLu().solve(J.rhs);
        if (!step.allFinite())
          return m;
        double share =
          std::min(1., largest_change / std::abs(step[step.size() - 2]));
        HarmonicMotion best = J.moved(step, share);
        for (unsigned int i = 0;
             i < halvings && !(best.residual < accepted_growth * m.residual);
             ++i)
          {
            share *= .5;
            HarmonicMotion next = J.moved(step, share);
            if (!(next.residual > best.residual))
              best = std::move(next);
          }
        best.iterations = m.iterations + 1;
        m               = std::move(best);
        if (m.residual <= tolerance && step.tail(2).norm() <= 1e-2 &&
            worst_of(step.tail(2).cwiseAbs()) <= std::sqrt(tolerance))
          {
            m.converged = true;
            return m;
          }
      }
    return m;
  }
} // namespace squeal
