// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tests_transient_hand_made_h
#define squeal_tests_transient_hand_made_h

#include <squeal/transient/transient_integrator.h>

#include <Eigen/Eigenvalues>

#include <cmath>

namespace squeal
{
  namespace testing
  {
    /** A model without modes and flexibility. */
    inline ReducedContactModel
    empty_model(const unsigned int n_nodes, const unsigned int n_modes)
    {
      ReducedContactModel m;
      m.omega_squared = Eigen::VectorXd::Zero(n_modes);
      m.damping       = Eigen::VectorXd::Zero(n_modes);
      m.participation = Eigen::MatrixXd::Zero(3 * n_nodes, n_modes);
      m.flexibility   = Eigen::MatrixXd::Zero(3 * n_nodes, 3 * n_nodes);
      m.load          = Eigen::VectorXd::Zero(n_modes);
      m.load_motion   = Eigen::VectorXd::Zero(3 * n_nodes);
      m.initial_gap   = Eigen::VectorXd::Zero(n_nodes);
      m.speed_ratio   = Eigen::VectorXd::Ones(n_nodes);
      return m;
    }

    /** A rigid block of mass @p mass on a floor: its motions along z, y and x.
     * The contact gives way a little: on no flexibility at all the scheme, in
     * which forces change linearly, is not stable. */
    inline ReducedContactModel
    rigid_block(const double mass, const double dt)
    {
      ReducedContactModel m = empty_model(1, 3);
      m.flexibility         = dt * dt / mass * Eigen::MatrixXd::Identity(3, 3);
      // Floor minus block, mass-normalised.
      for (unsigned int c = 0; c < 3; ++c)
        m.participation(c, c) = -1. / std::sqrt(mass);
      return m;
    }

    /** A mass of 1 kg on a spring of 1 N/m along y, 0.1 kg of it a foot on the
     * belt behind a stiff spring, 0.0225 kg/dt^2, whose motion is damped
     * critically: where the force of a foot jumps, one without damping would
     * ring for ever. Modes: along z and x, the two along y. */
    inline ReducedContactModel
    foot_on_belt(const double dt)
    {
      const double        foot = .1, stiffness = .0225 / (dt * dt);
      ReducedContactModel m = empty_model(1, 4);
      m.flexibility         = dt * dt / foot * Eigen::MatrixXd::Identity(3, 3);
      Eigen::MatrixXd K(2, 2),
        M = Eigen::Vector2d(1. - foot, foot).asDiagonal();
      K << 1. + stiffness, -stiffness, -stiffness, stiffness;
      // Of any size: what the core has compiled.
      const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> modes(K,
                                                                            M);
      m.omega_squared << 0., 0., modes.eigenvalues();
      m.damping[3]          = 2. * std::sqrt(m.omega_squared[3]);
      m.participation(0, 0) = m.participation(2, 1) = -1.;
      m.participation.block(1, 2, 1, 2) = -modes.eigenvectors().row(1);
      m.load[0]                         = -1.;
      return m;
    }

    inline TransientDrive
    steady_drive(const double mu, const double speed)
    {
      TransientDrive d;
      d.friction = [mu](double) { return mu; };
      d.speed    = [speed](double) { return speed; };
      d.load     = [](double) { return 1.; };
      return d;
    }

    /** A mass of 1 kg on a spring of 1 N/m along y, pressed on the belt. */
    inline ReducedContactModel
    oscillator(const double dt)
    {
      ReducedContactModel m = rigid_block(1., dt);
      m.omega_squared[1]    = 1.;
      m.load[0]             = -1.;
      return m;
    }

    /** mu from @p at_rest down to @p kinetic, by exp(-v / @p decay_speed). */
    inline ContactParameters
    falling(const double kinetic,
            const double at_rest,
            const double decay_speed)
    {
      ContactParameters c;
      c.friction_law         = ContactParameters::FrictionLaw::exponential;
      c.friction_coefficient = kinetic;
      c.static_friction_coefficient = at_rest;
      c.decay_speed                 = decay_speed;
      return c;
    }

    inline TransientDrive
    drive_by(const ContactParameters &contact, const double belt_speed)
    {
      TransientDrive d = steady_drive(0., belt_speed);
      d.laws = std::make_shared<const FrictionLaws>(FrictionLaw(contact));
      return d;
    }
  } // namespace testing
} // namespace squeal

#endif
