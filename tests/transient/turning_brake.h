// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tests_transient_turning_brake_h
#define squeal_tests_transient_turning_brake_h

// A pressed brake whose disc turns with its mesh.

#include "transient/pressed_brake.h"

#include <squeal/contact/turning_contacts.h>
#include <squeal/transient/explicit_transient.h>
#include <squeal/transient/implicit_transient.h>

#include <cmath>

namespace squeal
{
  namespace testing
  {
    constexpr double mu = .3, fast = 20.; // m/s

    inline SceneParameters
    turning_brake(const std::array<unsigned int, 3> &disc,
                  const unsigned int                 pad)
    {
      SceneParameters s = pressed_brake(mu);
      s.bodies[0].cells = disc;
      s.bodies[1].cells = {{pad, pad, 2}};
      s.bodies[2].cells = {{pad, pad, 4}};
      s.contacts[0].friction_direction =
        ContactParameters::FrictionDirection::slip;
      s.contacts[0].sliding_speed = fast;
      return s;
    }

    inline std::shared_ptr<TurningContact>
    turning_contact(const Reduced &r, const unsigned int knots_per_cell)
    {
      return std::make_shared<TurningContact>(r.discretization,
                                              r.scene.contacts[0],
                                              r.separated.contacts[0],
                                              r.separated.reduce,
                                              knots_per_cell);
    }

    inline TransientDrive
    drive(const double ramp_time)
    {
      TransientDrive d;
      d.friction = [](double) { return mu; };
      d.speed    = [](double) { return fast; };
      d.load     = [ramp_time](const double t) {
        return t < ramp_time ? .5 * (1. - std::cos(M_PI * t / ramp_time)) : 1.;
      };
      return d;
    }

    inline double
    stable_step(const Reduced &r)
    {
      const auto            pencil = std::make_shared<const Pencil>(r.pencil);
      Block                 ones = Block::Ones(r.pencil.space()->n_owned(), 1);
      const Eigen::VectorXd mass = r.pencil.multiply_mass(ones);
      return .9 * critical_step(largest_frequency(*pencil, mass),
                                r.scene.damping.mass_damping,
                                r.scene.damping.stiffness_damping,
                                .5);
    }
  } // namespace testing
} // namespace squeal

#endif
