// SPDX-License-Identifier: LGPL-2.1-or-later
#include "harmonic_balance_law.h"

#include <squeal/base/exceptions.h>
#include <squeal/base/worst_of.h>

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
    constexpr double largest_frequency_change = 0.1;
  } // namespace



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
          const Eigen::MatrixXd &Psi = b.model.participation;
          const Eigen::MatrixXcd q =
            b.receptance(k, m) * Psi.transpose().cast<Complex>();
          const Eigen::MatrixXd re = Psi * q.real() + b.model.flexibility,
                                im = Psi * q.imag();
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
      const Eigen::Index     at = rhs.size() - 2;
      const Eigen::VectorXcd response =
        std::conj(direction) *
        (b.receptance(1, m) * b.model.participation.transpose().cast<Complex>())
          .row(mode);
      Eigen::VectorXcd by = Eigen::VectorXcd::Zero(rhs.size());
      for (std::size_t c = 0; c < closed.size(); ++c)
        {
          const Complex turn =
            -std::polar(1. / b.n, -2. * M_PI * closed[c].sample / b.n);
          by.segment<3>(3 * c) = turn * response.segment<3>(3 * closed[c].node);
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
        double share = std::min(
          1., largest_frequency_change / std::abs(step[step.size() - 2]));
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
