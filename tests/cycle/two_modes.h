// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tests_cycle_two_modes_h
#define squeal_tests_cycle_two_modes_h

#include "transient/hand_made.h"

#include <squeal/cycle/period_map.h>
#include <squeal/transient/steady_sliding.h>

#include <Eigen/Eigenvalues>

#include <cmath>

namespace squeal
{
  namespace testing
  {
    /** 1 kg that moves along and normal to the belt, on springs of @p along and
     * 0.5 N/m that couple both by @p coupling, N/m; the contact gives way like 1
     * N/m. */
    inline ReducedContactModel
    two_modes(const double along = 1.5, const double coupling = -.3)
    {
      ReducedContactModel m = empty_model(1, 3);
      Eigen::MatrixXd     K(2, 2);
      K << along, coupling, coupling, .5;
      const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes(K);
      m.omega_squared << modes.eigenvalues(), 2.;
      m.damping = Eigen::Vector3d::Constant(.05);
      for (unsigned int k = 0; k < 2; ++k)
        {
          m.participation(0, k) = -modes.eigenvectors()(1, k);
          m.participation(1, k) = -modes.eigenvectors()(0, k);
          m.load[k]             = -modes.eigenvectors()(1, k);
        }
      m.participation(2, 2) = -1.;
      m.flexibility         = Eigen::Vector3d(1., .05, .05).asDiagonal();
      return m;
    }

    /** The same with a dashpot that couples the two modes. */
    inline ReducedContactModel
    two_coupled_modes()
    {
      ReducedContactModel m = two_modes();
      m.damping << .03, .08, .05;
      m.damping_coupling       = Eigen::Matrix3d::Zero();
      m.damping_coupling(0, 1) = m.damping_coupling(1, 0) = .03;
      return m;
    }

    struct Figures
    {
      double frequency = 0., mean = 0., rms = 0.;
    };

    inline Figures
    figures_of(const Orbit &orbit)
    {
      Figures f;
      double  square = 0.;
      for (unsigned int i = 1; i <= orbit.n_steps(); ++i)
        {
          f.mean += orbit.states[i].forces[0] / orbit.n_steps();
          square += std::pow(orbit.states[i].forces[0], 2) / orbit.n_steps();
        }
      f.rms       = std::sqrt(square - f.mean * f.mean);
      f.frequency = 1. / (orbit.step * orbit.n_steps());
      return f;
    }

    inline MotionState
    disturbed(const SteadySliding &steady)
    {
      MotionState s{steady.coordinates,
                    Eigen::VectorXd::Zero(steady.coordinates.size()),
                    steady.forces};
      s.velocities[0] += .02;
      return s;
    }

    /** The state after @p time in steps of @p step. */
    inline MotionState
    later(const PeriodMap &map,
          MotionState      s,
          const double     time,
          const double     step)
    {
      return map.run(s, time, std::lround(time / step)).end();
    }
  } // namespace testing
} // namespace squeal

#endif
