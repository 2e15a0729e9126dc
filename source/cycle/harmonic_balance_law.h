// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_cycle_harmonic_balance_law_h
#define squeal_cycle_harmonic_balance_law_h

#include <squeal/cycle/harmonic_balance.h>

#include <complex>
#include <utility>

namespace squeal
{
  /** Coordinates of the modes by forces on them in one harmonic: mode by mode,
   * or of all together where damping couples them. */
  class HarmonicBalance::Receptance
  {
  public:
    using Complex = std::complex<double>;

    explicit Receptance(Eigen::VectorXcd mode_by_mode)
      : factors(std::move(mode_by_mode))
    {
    }
    explicit Receptance(const Eigen::MatrixXcd &dynamic_stiffness)
      : coupled(dynamic_stiffness)
    {
    }

    Eigen::MatrixXcd
    operator*(const Eigen::MatrixXcd &forces) const
    {
      if (factors.size() == 0)
        return coupled.solve(forces);
      return factors.asDiagonal() * forces;
    }

  private:
    Eigen::VectorXcd                      factors;
    Eigen::PartialPivLU<Eigen::MatrixXcd> coupled;
  };



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
} // namespace squeal

#endif
