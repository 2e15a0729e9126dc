// SPDX-License-Identifier: LGPL-2.1-or-later
#include "turned_rotor.h"

#include <squeal/parameters/number_access.h>
#include <squeal/scene/coarse_mesh.h>
#include <squeal/scene/turning.h>

#include <algorithm>

namespace squeal
{
  namespace
  {
    /** Turns points and directions as the rotor turns. */
    class Turn
    {
    public:
      Turn(const BodyParameters &rotor, const double angle)
        : about_axis(rotor)
      {
        about_axis.angle             = angle;
        about_axis.rotation_centre   = rotor.centre_of_rotation();
        about_origin                 = about_axis;
        about_origin.rotation_centre = Vector3{{0., 0., 0.}};
      }

      Vector3
      point(const Vector3 &x) const
      {
        return turned(about_axis, x);
      }

      Vector3
      direction(const Vector3 &d) const
      {
        return turned(about_origin, d);
      }

    private:
      static Vector3
      turned(const BodyParameters &body, const Vector3 &x)
      {
        const dealii::Point<3> y = turned_point(body, {x[0], x[1], x[2]});
        return {{y[0], y[1], y[2]}};
      }

      BodyParameters about_axis, about_origin;
    };

    bool
    turns(const Parameters &p, const std::string &name)
    {
      if (name == "ground")
        return false;
      const auto &bodies  = p.angles.bodies;
      const auto &carrier = carrier_of(p.scene, body_index(p.scene, name));
      return std::count(bodies.begin(), bodies.end(), carrier.name) > 0;
    }

    /** What one spring is when it has turned. */
    std::vector<SpringParameters>
    turned_springs(const SpringParameters &spring, const Turn &turn)
    {
      SpringParameters along = spring;
      along.first_point      = turn.point(spring.first_point);
      along.last_point       = turn.point(spring.last_point);
      along.direction        = turn.direction(spring.direction);
      along.stiffnesses = along.dashpots = {{0., 0., 0.}};
      std::vector<SpringParameters> result{along};
      for (unsigned int c = 0; c < 3; ++c)
        if (spring.stiffnesses[c] != 0. || spring.dashpots[c] != 0.)
          {
            Vector3 axis{{0., 0., 0.}};
            axis[c]         = 1.;
            along.name      = spring.name + " along turned " + "xyz"[c];
            along.direction = turn.direction(axis);
            along.stiffness = spring.stiffnesses[c];
            along.dashpot   = spring.dashpots[c];
            result.push_back(along);
          }
      return result;
    }
  } // namespace



  Parameters
  turned_rotor(const Parameters &p, const double angle)
  {
    std::vector<std::string> paths;
    std::vector<double>      angles;
    for (const auto &name : p.angles.bodies)
      {
        paths.push_back("Scene/Body " + name + "/Angle");
        angles.push_back(get_number(p, paths.back()) + angle);
      }
    Parameters result = with_values(p, paths, angles);
    if (angle == 0.)
      return result;

    SceneParameters &scene = result.scene;
    const Turn turn(scene.bodies[body_index(scene, p.angles.bodies[0])], angle);
    for (auto &body : scene.bodies)
      if (body.material_model == BodyParameters::MaterialModel::orthotropic &&
          turns(p, body.name))
        {
          body.material_axis_1 = turn.direction(body.material_axis_1);
          body.material_axis_2 = turn.direction(body.material_axis_2);
        }
    scene.springs.clear();
    for (const auto &spring : p.scene.springs)
      if (turns(p, spring.body) && turns(p, spring.other_body))
        for (const auto &turned : turned_springs(spring, turn))
          scene.springs.push_back(turned);
      else
        scene.springs.push_back(spring);
    return result;
  }
} // namespace squeal
