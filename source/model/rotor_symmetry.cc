// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/number_text.h>
#include <squeal/base/run_log.h>
#include <squeal/model/model.h>
#include <squeal/model/rotor_symmetry.h>
#include <squeal/scene/layer_mesh.h>
#include <squeal/scene/turning.h>

#include <deal.II/base/quadrature_lib.h>

#include <deal.II/fe/fe_values.h>

#include <deal.II/grid/tria.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numeric>
#include <set>

namespace squeal
{
  namespace
  {
    constexpr unsigned int highest_order = 64;
    constexpr double       significant   = 2e-3;

    using Vector = dealii::Tensor<1, 3>;

    /** Masses round an axis: sums of m cos(n angle) and m sin(n angle) over
     * what is added, kg, for the orders n up to the highest. */
    class AngularMoments
    {
    public:
      AngularMoments(const Vector3 &direction, const Vector3 &centre)
        : origin(centre[0], centre[1], centre[2])
      {
        const Vector line({direction[0], direction[1], direction[2]});
        axis = line / line.norm();
        Vector other;
        other[std::abs(axis[0]) < 0.6 ? 0 : 1] = 1.;
        first = dealii::cross_product_3d(axis, other);
        first /= first.norm();
        second = dealii::cross_product_3d(axis, first);
      }

      void
      add(const dealii::Point<3> &x, const double mass)
      {
        const Vector r     = x - origin;
        const double angle = std::atan2(r * second, r * first);
        for (unsigned int n = 0; n <= highest_order; ++n)
          {
            values[2 * n] += mass * std::cos(n * angle);
            values[2 * n + 1] += mass * std::sin(n * angle);
          }
      }

      /** The same of a point mass, which has no angle on the axis. */
      void
      add_point(const dealii::Point<3> &x, const double mass)
      {
        const Vector r = x - origin;
        if (std::hypot(r * first, r * second) > on_axis)
          add(x, mass);
        else
          values[0] += mass;
      }

      /** A rigid body: its mass at its centre of gravity, in order 2 what its
       * inertia J about two axes across differs by, in order 1 the products of
       * inertia that tilt it, both over J about the axis. */
      void
      add_rigid(const BodyParameters &body)
      {
        add_point(centre_of_gravity(body), body.mass);
        const auto   J     = turned_tensor(body, body.inertia);
        const double share = body.mass / (axis * (J * axis));
        values[2] -= share * (first * (J * axis));
        values[3] -= share * (second * (J * axis));
        values[4] += share * (second * (J * second) - first * (J * first));
        values[5] -= 2. * share * (first * (J * second));
      }

      /** Whether what was added has an order @p n > 0 that is above @p part
       * of its mass. */
      bool
      has_order(const unsigned int n, const double part) const
      {
        return std::hypot(values[2 * n], values[2 * n + 1]) > part * values[0];
      }

      void
      sum_over_ranks(const MPI_Comm communicator)
      {
        MPI_Allreduce(MPI_IN_PLACE,
                      values.data(),
                      static_cast<int>(values.size()),
                      MPI_DOUBLE,
                      MPI_SUM,
                      communicator);
      }

    private:
      static constexpr double on_axis = 1e-9; /**< m */

      dealii::Point<3>                            origin;
      Vector                                      axis, first, second;
      std::array<double, 2 * (highest_order + 1)> values{};
    };

    /** Whether a rigid body is the same at all angles about an axis. */
    bool
    is_round_about(const BodyParameters &rigid,
                   const Vector3        &axis,
                   const Vector3        &centre)
    {
      AngularMoments moments(axis, centre);
      moments.add_rigid(rigid);
      return !moments.has_order(1, 1e-9) && !moments.has_order(2, 1e-9);
    }

    /** The body and all that ties glue to it. */
    std::vector<unsigned int>
    glued_to(const SceneParameters &scene, const std::string &body)
    {
      std::set<std::string> names{body};
      for (std::size_t n = 0; n != names.size();)
        {
          n = names.size();
          for (const auto &[a, b] : glued_bodies(scene))
            if (names.count(a) + names.count(b) == 1)
              names.insert({a, b});
        }
      std::vector<unsigned int> result;
      for (const auto &name : names)
        result.push_back(body_index(scene, name));
      return result;
    }

    /** By its shape alone, or as a rigid body of the @p rotor, with nothing
     * fixed to it. */
    bool
    is_of_revolution(const SceneParameters &scene,
                     const unsigned int     number,
                     const BodyParameters  &rotor)
    {
      const BodyParameters &body = scene.bodies[number];
      return (body.shape == BodyParameters::Shape::annulus ||
              body.shape == BodyParameters::Shape::cylinder ||
              (body.shape == BodyParameters::Shape::rigid &&
               is_round_about(
                 body, rotor.rotation_axis, rotor.centre_of_rotation()))) &&
             std::none_of(
               scene.lumped_masses.begin(),
               scene.lumped_masses.end(),
               [&](const auto &mass) { return mass.body == body.name; });
    }
  } // namespace



  std::vector<unsigned int>
  angular_orders(const Discretization            &d,
                 const std::vector<unsigned int> &bodies,
                 const Vector3                   &axis,
                 const Vector3                   &centre)
  {
    AngularMoments          moments(axis, centre);
    const dealii::QGauss<3> quadrature(d.degree() + 1);
    dealii::FEValues<3>     values(d.mapping(),
                               d.dof_handler().get_fe(),
                               quadrature,
                               dealii::update_quadrature_points |
                                 dealii::update_JxW_values);
    for (const auto &cell : d.dof_handler().active_cell_iterators())
      if (cell->is_locally_owned() &&
          std::count(bodies.begin(), bodies.end(), cell->material_id()) > 0)
        {
          values.reinit(cell);
          const double density = d.scene().bodies[cell->material_id()].density;
          for (unsigned int q = 0; q < quadrature.size(); ++q)
            moments.add(values.quadrature_point(q), density * values.JxW(q));
        }
    moments.sum_over_ranks(d.space()->communicator());
    for (const auto &mass : d.scene().lumped_masses)
      if (std::count(
            bodies.begin(), bodies.end(), body_index(d.scene(), mass.body)) > 0)
        moments.add_point(place_of(d.scene(), mass), mass.mass);
    for (const unsigned int b : bodies)
      if (d.scene().bodies[b].shape == BodyParameters::Shape::rigid)
        moments.add_rigid(d.scene().bodies[b]);
    std::vector<unsigned int> orders;
    for (unsigned int n = 1; n <= highest_order; ++n)
      if (moments.has_order(n, significant))
        orders.push_back(n);
    return orders;
  }



  namespace
  {
    /** Whether the target of a contact turns: a block on which friction has a
     * direction that is fixed in space slides straight, but bodies of other
     * shapes may be discs seen at the pad only. */
    bool
    target_turns(const SceneParameters &scene, const ContactParameters &contact)
    {
      const auto &body = scene.bodies[body_index(scene, contact.target_body)];
      return body.shape != BodyParameters::Shape::block ||
             contact.friction_direction ==
               ContactParameters::FrictionDirection::slip ||
             body.rotation_speed != 0.;
    }
  } // namespace



  std::string
  frozen_rotors(const Discretization &d)
  {
    const auto           &scene = d.scene();
    std::set<std::string> seen;
    std::string           text;
    for (const auto &contact : scene.contacts)
      {
        if (contact.target_body == "ground" ||
            contact.state == ContactParameters::State::stick ||
            !target_turns(scene, contact) ||
            !seen.insert(contact.target_body).second)
          continue;
        const auto  rotor = glued_to(scene, contact.target_body);
        const auto &body = scene.bodies[body_index(scene, contact.target_body)];
        if (std::all_of(rotor.begin(), rotor.end(), [&](const unsigned int b) {
              return is_of_revolution(scene, b, body);
            }))
          continue;
        const auto orders = angular_orders(
          d, rotor, body.rotation_axis, body.centre_of_rotation());
        if (orders.empty())
          continue;
        unsigned int common = 0;
        for (const unsigned int n : orders)
          common = std::gcd(common, n);
        text += (text.empty() ? "" : "; ") + std::string("body ") + body.name +
                " is no body of revolution and stands still at one angle: this "
                "is one sample of what it does while it turns. It repeats "
                "every " +
                rounded_text(360. / common, 5) +
                " deg; 'Analysis = angles' goes over that";
      }
    return text;
  }



  void
  warn_of_frozen_rotors(const Model &model, RunLog &log)
  {
    const Discretization *const d = model.discretization();
    if (d == nullptr || !d->has_mesh())
      return;
    const std::string text = frozen_rotors(*d);
    if (!text.empty())
      log.warning(text);
  }
} // namespace squeal
