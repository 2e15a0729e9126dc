// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tests_contact_placed_scene_h
#define squeal_tests_contact_placed_scene_h

#include "turned_block.h"

namespace squeal
{
  namespace testing
  {
    using Formulation = ContactParameters::Formulation;
    using Layout      = ContactParameters::SpringLayout;
    using Direction   = ContactParameters::FrictionDirection;

    /** How a scene is placed: x becomes factor R x, an orthogonal R. */
    struct Placing
    {
      Eigen::Matrix3d R      = Eigen::Matrix3d::Identity();
      double          factor = 1.;

      Vector3
      direction(const Vector3 &v) const
      {
        const Eigen::Vector3d w = R * Eigen::Vector3d(v[0], v[1], v[2]);
        return {{w[0], w[1], w[2]}};
      }

      Vector3
      point(const Vector3 &v) const
      {
        Vector3 w = direction(v);
        for (double &c : w)
          c *= factor;
        return w;
      }
    };

    /** A block whose mesh file is written where @p placing puts it. */
    inline BodyParameters
    placed_block(const BodyParameters &block, const Placing &placing)
    {
      BodyParameters     body = make_turned_block(block, 0.);
      std::ifstream      in(body.mesh_file);
      std::ostringstream out;
      out.precision(17);
      bool is_node = false;
      for (std::string line; std::getline(in, line);)
        {
          if (line[0] == '$')
            is_node = line == "$Nodes";
          std::istringstream words(line);
          int                number;
          Vector3            x;
          if (is_node && words >> number >> x[0] >> x[1] >> x[2])
            {
              for (unsigned int c = 0; c < 3; ++c)
                x[c] += block.position[c];
              x = placing.point(x);
              out << number << ' ' << x[0] << ' ' << x[1] << ' ' << x[2]
                  << '\n';
            }
          else
            out << line << '\n';
        }
      in.close();
      std::ofstream(body.mesh_file) << out.str();
      body.position = {{0., 0., 0.}};
      return body;
    }

    struct Options
    {
      Formulation formulation = Formulation::springs;
      Layout      layout      = Layout::grid;
      Direction   direction   = Direction::given;
      double      mu          = 1.;
      bool        above = true, below = false;
      bool        is_reversed = false; /**< order of the pairs */
      double      y           = 0.004; /**< of the pads */
      double      sense       = 1.;    /**< of the sliding direction */
      double      load        = 0.;    /**< N, that presses each pad on */
    };

    /** Pads on three springs each, on a plate that one edge holds. */
    inline SceneParameters
    scene_of(const Options &o, const Placing &placing = {})
    {
      SceneParameters s;
      const double    L         = placing.factor;
      s.bodies                  = {placed_block(
        make_block("plate", {{.1, 0., -.01}}, {{.06, .05, .01}}, {{3, 2, 1}}),
        placing)};
      s.bodies[0].rotation_axis = placing.direction({{0., 0., o.sense}});
      s.supports                = {make_clamp("plate", "x_min")};
      const auto add            = [&](const std::string &name, const double z) {
        const bool is_above = z >= 0.;
        s.bodies.push_back(placed_block(
          make_block(name, {{.105, o.y, z}}, {{.02, .015, .01}}, {{2, 2, 1}}),
          placing));
        s.bodies.back().young_modulus = 2e10;
        s.bodies.back().density       = 2500.;
        for (unsigned int c = 0; c < 3; ++c)
          {
            SpringParameters spring;
            spring.name = name + std::to_string(c);
            spring.body = name;
            spring.first_point =
              placing.point({{.1, o.y, is_above ? .01 : -.02}});
            spring.last_point =
              placing.point({{.11, o.y, is_above ? .01 : -.02}});
            spring.number    = 2;
            spring.direction = placing.direction(
              {{double(c == 0), double(c == 1), double(c == 2)}});
            spring.stiffness = 3e7 * (1. + c) / L;
            s.springs.push_back(spring);
            if (!(o.load > 0.))
              continue;
            // Beside that line, so that no motion is free without contact.
            spring.name += " aside";
            spring.first_point = spring.last_point = placing.point(
              {{.105, o.y + (o.y > 0. ? .006 : -.006), is_above ? .01 : -.02}});
            spring.number = 1;
            s.springs.push_back(spring);
          }
        ContactParameters contact;
        contact.name                      = name + " on plate";
        contact.source_body               = name;
        contact.source_face               = is_above ? "z_min" : "z_max";
        contact.target_body               = "plate";
        contact.target_face               = is_above ? "z_max" : "z_min";
        contact.formulation               = o.formulation;
        contact.layout                    = o.layout;
        contact.grid                      = {{4, 4}};
        contact.normal_stiffness          = 2e7 / L;
        contact.normal_stiffness_per_area = 1e12 / (L * L * L);
        contact.friction_coefficient      = o.mu;
        contact.friction_direction        = o.direction;
        if (o.direction == Direction::given)
          contact.sliding_direction = placing.direction({{0., o.sense, 0.}});
        contact.transverse_slip_term = true;
        contact.sliding_speed        = L;
        contact.normal_force         = 10.;
        if (o.load > 0.)
          {
            LoadParameters load;
            load.name = name;
            load.body = name;
            load.face = is_above ? "z_max" : "z_min";
            load.force =
              placing.direction({{0., 0., is_above ? -o.load : o.load}});
            s.loads.push_back(load);
          }
        s.contacts.push_back(contact);
      };
      if (o.above)
        add("upper", 0.);
      if (o.below)
        add("lower", -.02);
      if (o.is_reversed)
        std::reverse(s.contacts.begin(), s.contacts.end());
      for (BodyParameters &body : s.bodies)
        {
          // Newton, second and the unit of length: E in N/L^2, rho in N
          // s^2/L^4.
          body.young_modulus /= L * L;
          body.density /= L * L * L * L;
        }
      s.damping.model             = DampingParameters::Model::whole_model;
      s.damping.mass_damping      = 1.;
      s.damping.stiffness_damping = 1e-9;
      return s;
    }

    inline Placing
    turned(const double angle, const Eigen::Vector3d &axis)
    {
      return {Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix(),
              1.};
    }
  } // namespace testing
} // namespace squeal

#endif
