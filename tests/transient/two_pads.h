// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tests_transient_two_pads_h
#define squeal_tests_transient_two_pads_h

#include "scenes.h"

#include <squeal/analyses/transient/transient_results.h>
#include <squeal/base/timers.h>
#include <squeal/contact/contact_resultant.h>

#include <string>
#include <tuple>
#include <vector>

namespace squeal
{
  namespace testing
  {
    inline ContactParameters
    make_contact(const std::string &source,
                 const std::string &source_face,
                 const std::string &target,
                 const std::string &target_face,
                 const double       mu)
    {
      ContactParameters c;
      c.name                 = source + "_" + target;
      c.source_body          = source;
      c.source_face          = source_face;
      c.target_body          = target;
      c.target_face          = target_face;
      c.formulation          = ContactParameters::Formulation::mortar;
      c.friction_coefficient = mu;
      c.friction_direction   = ContactParameters::FrictionDirection::given;
      c.sliding_speed        = .5;
      c.transverse_slip_term = true;
      c.normal_force         = 10.;
      return c;
    }

    inline LoadParameters
    make_load(const std::string &body,
              const std::string &face,
              const Vector3     &force)
    {
      LoadParameters load;
      load.name  = body;
      load.body  = body;
      load.face  = face;
      load.force = force;
      return load;
    }

    /** Springs at the four corners of a level rectangle in the body. */
    inline void
    add_springs(SceneParameters   &s,
                const std::string &body,
                const Vector3     &centre,
                const Vector3     &stiffness)
    {
      for (const double side : {-1., 1.})
        for (unsigned int c = 0; c < 3; ++c)
          {
            SpringParameters spring;
            spring.name =
              body + "_" + std::to_string(c) + (side > 0 ? "b" : "a");
            spring.body        = body;
            spring.first_point = spring.last_point = centre;
            spring.first_point[0] -= .005;
            spring.last_point[0] += .005;
            spring.first_point[1] += .004 * side;
            spring.last_point[1] += .004 * side;
            spring.number       = 2;
            spring.direction    = {{0., 0., 0.}};
            spring.direction[c] = 1.;
            spring.stiffness    = stiffness[c];
            s.springs.push_back(spring);
          }
    }

    inline Parameters
    parameters_of(const SceneParameters &scene, const unsigned int degree = 1)
    {
      Parameters p;
      p.scene                   = scene;
      p.discretization.degree   = degree;
      p.eigen.lowest_frequency  = 500.;
      p.eigen.highest_frequency = 12e3;
      p.transient.cut_off       = 30e3;
      return p;
    }

    /** A parameter set with its open contact and its steady sliding. */
    struct Pressed
    {
      explicit Pressed(const Parameters &given)
        : p(given)
        , model(p, timers, {}, squeal::Model::Contacts::open)
        , about(PressedModel(p,
                             *model.discretization(),
                             model.body_matrices(),
                             p.transient.cut_off,
                             timers)
                  .steady(1e-12, timers))
      {
      }

      /** Normal, along and across the sliding of pair @p i, N. */
      Eigen::Vector3d
      resultant(const unsigned int i) const
      {
        const ContactPair &pair = pressed.nodes().pairs()[i];
        const auto f = resultant_force(pair.geometry, pair.part(steady.forces));
        return {f[2], f[1], f[0]};
      }

      const Parameters     p;
      Timers               timers;
      squeal::Model        model;
      SteadyModel          about;
      const PressedModel  &pressed = about.pressed;
      const SteadySliding &steady  = about.sliding;
    };



    /** Two pads on two sides of a clamped disc, each pressed on. */
    inline SceneParameters
    disc_brake(const double mu)
    {
      SceneParameters s;
      s.bodies                  = {make_annulus({{20, 3, 1}})};
      s.bodies[0].young_modulus = 2.1e11;
      s.supports                = {make_clamp("disc", "inner")};
      for (const auto &[name, z, top] :
           {std::make_tuple(std::string("upper"), 0., 1.),
            std::make_tuple(std::string("lower"), -.03, -1.)})
        {
          s.bodies.push_back(
            make_block(name, {{.1, 0., z}}, {{.02, .02, .02}}, {{2, 2, 2}}));
          s.bodies.back().young_modulus = 5e10;
          s.bodies.back().density       = 2500.;
          const double far              = top > 0. ? .02 : -.03;
          add_springs(s, name, {{.1, 0., far}}, {{2e6, 1e6, 1e6}});
          s.contacts.push_back(make_contact(name,
                                            top > 0. ? "z_min" : "z_max",
                                            "disc",
                                            top > 0. ? "top" : "bottom",
                                            mu));
          s.contacts.back().friction_direction =
            ContactParameters::FrictionDirection::slip;
          s.contacts.back().sliding_speed = 1.;
          s.loads.push_back(make_load(
            name, top > 0. ? "z_max" : "z_min", {{0., 0., -200. * top}}));
        }
      s.damping.model             = DampingParameters::Model::whole_model;
      s.damping.mass_damping      = 10.;
      s.damping.stiffness_damping = 1e-7;
      return s;
    }
  } // namespace testing
} // namespace squeal

#endif
