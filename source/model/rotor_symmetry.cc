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

    /** Two unit vectors across an axis. */
    std::array<Vector, 2>
    across(const Vector &axis)
    {
      Vector other;
      other[std::abs(axis[0]) < 0.6 * axis.norm() ? 0 : 1] = 1.;
      Vector first = dealii::cross_product_3d(axis, other);
      first /= first.norm();
      return {{first, dealii::cross_product_3d(axis / axis.norm(), first)}};
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

    /** By its shape alone, with nothing fixed to it. */
    bool
    is_of_revolution(const SceneParameters &scene, const unsigned int number)
    {
      const BodyParameters &body = scene.bodies[number];
      return (body.shape == BodyParameters::Shape::annulus ||
              body.shape == BodyParameters::Shape::cylinder ||
              body.shape == BodyParameters::Shape::rigid) &&
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
    const auto [e, f] = across(Vector({axis[0], axis[1], axis[2]}));
    const dealii::Point<3>  origin(centre[0], centre[1], centre[2]);
    const dealii::QGauss<3> quadrature(d.degree() + 1);
    dealii::FEValues<3>     values(d.mapping(),
                               d.dof_handler().get_fe(),
                               quadrature,
                               dealii::update_quadrature_points |
                                 dealii::update_JxW_values);
    std::array<double, 2 * (highest_order + 1)> moments{};
    const auto add = [&](const dealii::Point<3> &x, const double mass) {
      const Vector r     = x - origin;
      const double angle = std::atan2(r * f, r * e);
      for (unsigned int n = 0; n <= highest_order; ++n)
        {
          moments[2 * n] += mass * std::cos(n * angle);
          moments[2 * n + 1] += mass * std::sin(n * angle);
        }
    };
    for (const auto &cell : d.dof_handler().active_cell_iterators())
      if (cell->is_locally_owned() &&
          std::count(bodies.begin(), bodies.end(), cell->material_id()) > 0)
        {
          values.reinit(cell);
          const double density = d.scene().bodies[cell->material_id()].density;
          for (unsigned int q = 0; q < quadrature.size(); ++q)
            add(values.quadrature_point(q), density * values.JxW(q));
        }
    MPI_Allreduce(MPI_IN_PLACE,
                  moments.data(),
                  static_cast<int>(moments.size()),
                  MPI_DOUBLE,
                  MPI_SUM,
                  d.space()->communicator());
    // On the axis a mass has no angle.
    for (const auto &mass : d.scene().lumped_masses)
      if (const Vector r = place_of(d.scene(), mass) - origin;
          std::count(bodies.begin(),
                     bodies.end(),
                     body_index(d.scene(), mass.body)) > 0 &&
          std::hypot(r * e, r * f) > 1e-9)
        add(place_of(d.scene(), mass), mass.mass);
    std::vector<unsigned int> orders;
    for (unsigned int n = 1; n <= highest_order; ++n)
      if (std::hypot(moments[2 * n], moments[2 * n + 1]) >
          significant * moments[0])
        orders.push_back(n);
    return orders;
  }



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
            !seen.insert(contact.target_body).second)
          continue;
        const auto  rotor = glued_to(scene, contact.target_body);
        const auto &body = scene.bodies[body_index(scene, contact.target_body)];
        if (std::all_of(rotor.begin(), rotor.end(), [&](const unsigned int b) {
              return is_of_revolution(scene, b);
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
