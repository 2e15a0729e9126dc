// SPDX-License-Identifier: LGPL-2.1-or-later
#include "harmonic_balance_law.h"

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



  HarmonicBalance::Receptance
  HarmonicBalance::receptance(const unsigned int    k,
                              const HarmonicMotion &m) const
  {
    Eigen::VectorXcd stiffness(model.n_modes());
    const double     w = k * m.omega;
    for (Eigen::Index j = 0; j < stiffness.size(); ++j)
      stiffness[j] =
        Complex(model.omega_squared[j] - w * w,
                w * (model.damping[j] + (k > 0 ? m.excess_damping : 0.)));
    if (k > 0 && model.has_coupled_damping())
      {
        Eigen::MatrixXcd coupled = Complex(0., w) * model.damping_coupling;
        coupled.diagonal() += stiffness;
        return Receptance(coupled);
      }
    for (Eigen::Index j = 0; j < stiffness.size(); ++j)
      if (k == 0 && model.omega_squared[j] == 0.)
        stiffness[j] = 0.;
      else
        stiffness[j] = 1. / stiffness[j];
    return Receptance(std::move(stiffness));
  }

  Eigen::MatrixXcd
  HarmonicBalance::modal_harmonics(const HarmonicMotion &m) const
  {
    Eigen::MatrixXcd q =
      -(model.participation.transpose() * harmonics_of(m.forces));
    q.col(0) += model.load;
    for (Eigen::Index k = 0; k < q.cols(); ++k)
      q.col(k) = receptance(k, m) * q.col(k);
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
      e.damping +=
        period * 2. * std::pow(k * m.omega, 2) *
        (q.col(k).dot(model.damping_forces(Eigen::VectorXcd(q.col(k)))) +
         m.excess_damping * q.col(k).squaredNorm())
          .real();
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
} // namespace squeal
