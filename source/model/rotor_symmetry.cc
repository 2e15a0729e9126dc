// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/base/number_text.h>
#include <squeal/base/run_log.h>
#include <squeal/base/unknown_choice.h>
#include <squeal/discretization/element_matrices.h>
#include <squeal/model/model.h>
#include <squeal/model/rotor_symmetry.h>
#include <squeal/parameters/checks.h>
#include <squeal/parameters/glued_bodies.h>
#include <squeal/scene/turning.h>

#include <deal.II/base/quadrature_lib.h>

#include <deal.II/fe/fe_values.h>

#include <deal.II/grid/tria.h>

#include <Eigen/Core>

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
    constexpr int    highest_order = 64, highest_spin = 4;
    constexpr double significant = 2e-3, rounding = 1e-9;
    /** Share of the volume in the orders 1 and 2 of what has no axis. */
    constexpr double out_of_round = .05;

    using Vector  = dealii::Tensor<1, 3>;
    using Complex = std::complex<double>;

    /** A point and the directions that angles about an axis are measured by:
     * first, second and axis are right-handed. */
    struct AxisFrame
    {
      AxisFrame(const Vector3 &direction, const Vector3 &centre)
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

      dealii::Point<3> origin;
      Vector           axis, first, second;
    };

    /** Masses round an axis: sums of m exp(i n angle) over what is added, kg,
     * for the orders n up to the highest and the spins of elastic constants
     * beyond. Of volumes, m^3. */
    class AngularMoments
    {
    public:
      explicit AngularMoments(const AxisFrame &f)
        : frame(f)
      {
      }

      void
      add(const dealii::Point<3> &x, const double mass)
      {
        const Vector r     = x - frame.origin;
        const double angle = std::atan2(r * frame.second, r * frame.first);
        for (std::size_t n = 0; n < values.size(); ++n)
          values[n] += mass * std::polar(1., n * angle);
      }

      void
      add(const AngularMoments &other, const double factor)
      {
        for (std::size_t n = 0; n < values.size(); ++n)
          values[n] += factor * other.values[n];
      }

      /** The same of a point mass, which has no angle on the axis. */
      void
      add_point(const dealii::Point<3> &x, const double mass)
      {
        const Vector r = x - frame.origin;
        if (std::hypot(r * frame.first, r * frame.second) > on_axis)
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
        const auto &[origin, axis, first, second] = frame;

        const auto   J     = turned_tensor(body, body.inertia);
        const double share = body.mass / (axis * (J * axis));
        values[1] -= share * Complex(first * (J * axis), second * (J * axis));
        values[2] +=
          share * Complex(second * (J * second) - first * (J * first),
                          -2. * (first * (J * second)));
      }

      /** Of the order @p n, which may be negative. */
      Complex
      at(const int n) const
      {
        return n < 0 ? std::conj(values[-n]) : values[n];
      }

      /** Whether what was added has an order @p n > 0 that is above @p part
       * of its mass. */
      bool
      has_order(const int n, const double part) const
      {
        return std::abs(at(n)) > part * values[0].real();
      }

      void
      sum_over_ranks(const MPI_Comm communicator)
      {
        MPI_Allreduce(MPI_IN_PLACE,
                      values.data(),
                      static_cast<int>(2 * values.size()),
                      MPI_DOUBLE,
                      MPI_SUM,
                      communicator);
      }

    private:
      static constexpr double on_axis = 1e-9; /**< m */

      AxisFrame                                             frame;
      std::array<Complex, highest_order + highest_spin + 1> values{};
    };

    /**
     * Elastic constants round an axis, Pa: C(e_a, e_b, e_c, e_d) along
     * e_+ = (first + i second) / sqrt 2, e_- and the axis. At the angle t the
     * same along the radial and the tangential direction is exp(-i s t) times
     * it, with the spin s: how many of a, b, c, d are + less how many are -.
     */
    class SpinComponents
    {
    public:
      static constexpr int size = 81;

      SpinComponents(const BodyParameters &body, const AxisFrame &frame)
      {
        Eigen::Matrix3cd e;
        for (unsigned int c = 0; c < 3; ++c)
          {
            e(0, c) = M_SQRT1_2 * Complex(frame.first[c], frame.second[c]);
            e(1, c) = std::conj(e(0, c));
            e(2, c) = frame.axis[c];
          }
        const auto   tensor = elastic_tensor(body);
        const double scale  = elastic_scale(body);
        Matrix9      Q, C;
        for (unsigned int i = 0; i < 9; ++i)
          for (unsigned int j = 0; j < 9; ++j)
            {
              Q(i, j) = e(i / 3, j / 3) * e(i % 3, j % 3);
              C(i, j) = scale * tensor[i][j];
            }
        values = Q * C * Q.transpose();
      }

      Complex
      value(const int k) const
      {
        return values(k / 9, k % 9);
      }

      static int
      spin(const int k)
      {
        const auto of = [](const int index) {
          return index == 0 ? 1 : index == 1 ? -1 : 0;
        };
        return of(k / 27) + of(k / 9 % 3) + of(k / 3 % 3) + of(k % 3);
      }

      double
      largest() const
      {
        return values.cwiseAbs().maxCoeff();
      }

      /** Isotropic, or transversely isotropic about the axis. */
      bool
      are_same_at_all_angles() const
      {
        for (int k = 0; k < size; ++k)
          if (spin(k) != 0 && std::abs(value(k)) > rounding * largest())
            return false;
        return true;
      }

    private:
      using Matrix9 = Eigen::Matrix<Complex, 9, 9>;

      /** Of elastic_tensor(), which leaves out an isotropic modulus. */
      static double
      elastic_scale(const BodyParameters &body)
      {
        switch (body.material_model)
          {
          case BodyParameters::MaterialModel::isotropic:
            return body.young_modulus;
          case BodyParameters::MaterialModel::orthotropic:
            return 1.;
          }
        unknown_choice("material model");
      }

      Matrix9 values;
    };

    /** Whether a rigid body is the same at all angles about an axis. */
    bool
    is_round_about(const BodyParameters &rigid,
                   const Vector3        &axis,
                   const Vector3        &centre)
    {
      AngularMoments moments(AxisFrame(axis, centre));
      moments.add_rigid(rigid);
      return !moments.has_order(1, rounding) && !moments.has_order(2, rounding);
    }

    /** Whether a round mesh has the axis of the @p rotor and is of a material
     * that is the same at all angles about it. */
    bool
    is_round_mesh_on_axis(const BodyParameters &body,
                          const BodyParameters &rotor)
    {
      if (body.shape != BodyParameters::Shape::annulus &&
          body.shape != BodyParameters::Shape::cylinder)
        return false;
      BodyParameters own     = body;
      const auto     x       = turned_position(body);
      own.rotation_centre    = Vector3{{x[0], x[1], x[2]}};
      const Vector3 &axis    = rotor.rotation_axis;
      const bool     on_axis = axis[0] == 0. && axis[1] == 0. &&
                           prm::have_centres_on_one_axis(rotor, own);
      return on_axis &&
             SpinComponents(body, AxisFrame(axis, rotor.centre_of_rotation()))
               .are_same_at_all_angles();
    }

    /** A body of the @p rotor that is the same at all angles by its shape and
     * material alone, with nothing fixed to it. */
    bool
    is_of_revolution(const SceneParameters &scene,
                     const unsigned int     number,
                     const BodyParameters  &rotor)
    {
      const BodyParameters &body = scene.bodies[number];
      return (is_round_mesh_on_axis(body, rotor) ||
              (body.shape == BodyParameters::Shape::rigid &&
               is_round_about(
                 body, rotor.rotation_axis, rotor.centre_of_rotation()))) &&
             std::none_of(
               scene.lumped_masses.begin(),
               scene.lumped_masses.end(),
               [&](const auto &mass) { return mass.body == body.name; });
    }



    /** Moments of the volume of each of some bodies, none of rigid ones. */
    std::vector<AngularMoments>
    volume_moments(const Discretization            &d,
                   const std::vector<unsigned int> &bodies,
                   const AxisFrame                 &frame)
    {
      std::vector<AngularMoments> result(bodies.size(), AngularMoments(frame));
      const dealii::QGauss<3>     quadrature(d.degree() + 1);
      dealii::FEValues<3>         values(d.mapping(),
                                 d.dof_handler().get_fe(),
                                 quadrature,
                                 dealii::update_quadrature_points |
                                   dealii::update_JxW_values);
      for (const auto &cell : d.dof_handler().active_cell_iterators())
        {
          const auto found =
            std::find(bodies.begin(), bodies.end(), cell->material_id());
          if (!cell->is_locally_owned() || found == bodies.end())
            continue;
          values.reinit(cell);
          for (unsigned int q = 0; q < quadrature.size(); ++q)
            result[found - bodies.begin()].add(values.quadrature_point(q),
                                               values.JxW(q));
        }
      for (auto &moments : result)
        moments.sum_over_ranks(d.space()->communicator());
      return result;
    }

    /** The moments of the mass of some bodies with @p volumes. */
    AngularMoments
    mass_moments(const SceneParameters             &scene,
                 const std::vector<unsigned int>   &bodies,
                 const std::vector<AngularMoments> &volumes,
                 const AxisFrame                   &frame)
    {
      AngularMoments result(frame);
      for (std::size_t i = 0; i < bodies.size(); ++i)
        if (const auto &body = scene.bodies[bodies[i]];
            body.shape == BodyParameters::Shape::rigid)
          result.add_rigid(body);
        else
          result.add(volumes[i], body.density);
      for (const auto &mass : scene.lumped_masses)
        if (std::count(
              bodies.begin(), bodies.end(), body_index(scene, mass.body)) > 0)
          result.add_point(place_of(scene, mass), mass.mass);
      return result;
    }

    /** The orders that an elastic constant along the radial, tangential and
     * axial directions has above part of the largest of all: of a component of
     * spin s the order n is that of the volume of the order n - s. */
    std::set<unsigned int>
    elastic_orders(const SceneParameters             &scene,
                   const std::vector<unsigned int>   &bodies,
                   const std::vector<AngularMoments> &volumes,
                   const AxisFrame                   &frame)
    {
      std::vector<SpinComponents>         constants;
      std::vector<const AngularMoments *> moments;
      double                              whole = 0.;
      for (std::size_t i = 0; i < bodies.size(); ++i)
        if (const auto &body = scene.bodies[bodies[i]];
            body.shape != BodyParameters::Shape::rigid)
          {
            constants.emplace_back(body, frame);
            moments.push_back(&volumes[i]);
            whole += constants.back().largest() * volumes[i].at(0).real();
          }
      std::set<unsigned int> orders;
      for (int n = 1; n <= highest_order; ++n)
        for (int k = 0; k < SpinComponents::size; ++k)
          {
            Complex sum = 0.;
            for (std::size_t i = 0; i < constants.size(); ++i)
              sum += constants[i].value(k) *
                     moments[i]->at(n - SpinComponents::spin(k));
            if (std::abs(sum) > significant * whole)
              orders.insert(n);
          }
      return orders;
    }
  } // namespace



  std::vector<unsigned int>
  angular_orders(const Discretization            &d,
                 const std::vector<unsigned int> &bodies,
                 const Vector3                   &axis,
                 const Vector3                   &centre)
  {
    const AxisFrame frame(axis, centre);
    const auto      volumes = volume_moments(d, bodies, frame);
    const auto      masses  = mass_moments(d.scene(), bodies, volumes, frame);
    auto            orders  = elastic_orders(d.scene(), bodies, volumes, frame);
    for (int n = 1; n <= highest_order; ++n)
      if (masses.has_order(n, significant))
        orders.insert(n);
    return {orders.begin(), orders.end()};
  }



  namespace
  {
    /** Whether the target of a contact turns: that of a pair at rest, an anchor
     * or an abutment, does not; a block on which friction has a direction that
     * is fixed in space slides straight, but bodies of other shapes may be
     * discs seen at the pad only. */
    bool
    target_turns(const SceneParameters &scene, const ContactParameters &contact)
    {
      const auto &body = scene.bodies[body_index(scene, contact.target_body)];
      return body.rotation_speed != 0. ||
             (contact.sliding_speed != 0. &&
              (body.shape != BodyParameters::Shape::block ||
               contact.friction_direction ==
                 ContactParameters::FrictionDirection::slip));
    }

    /** The bodies that turn: with a `Rotation speed` of their own, and targets
     * of contacts. */
    std::vector<unsigned int>
    turning_bodies(const SceneParameters &scene)
    {
      std::set<unsigned int> result;
      for (unsigned int b = 0; b < scene.bodies.size(); ++b)
        if (scene.bodies[b].rotation_speed != 0.)
          result.insert(b);
      for (const auto &contact : scene.contacts)
        if (contact.target_body != "ground" &&
            contact.state != ContactParameters::State::stick &&
            target_turns(scene, contact))
          result.insert(body_index(scene, contact.target_body));
      return {result.begin(), result.end()};
    }
  } // namespace



  void
  refuse_turning_without_axis(const Discretization &d)
  {
    const auto &scene = d.scene();
    for (unsigned int b = 0; b < scene.bodies.size(); ++b)
      {
        const auto &body = scene.bodies[b];
        if (body.rotation_speed == 0. || is_of_revolution(scene, b, body))
          continue;
        const AxisFrame frame(body.rotation_axis, body.centre_of_rotation());
        const auto      volume = volume_moments(d, {b}, frame).front();
        if (volume.has_order(1, out_of_round) ||
            volume.has_order(2, out_of_round))
          throw InputError(
            "'Scene/Body " + body.name +
            "/Rotation speed' = " + rounded_text(body.rotation_speed, 6) +
            " rad/s is for bodies of revolution, vanes and holes aside; the "
            "mesh of this one has no axis of symmetry at its 'Rotation "
            "centre': set 0");
      }
  }



  std::string
  frozen_rotors(const Discretization &d)
  {
    const auto           &scene = d.scene();
    std::set<std::string> seen;
    std::string           text;
    for (const unsigned int number : turning_bodies(scene))
      {
        const auto &body = scene.bodies[number];
        if (!seen.insert(body.name).second)
          continue;
        std::vector<unsigned int> rotor;
        for (const auto &name : glued_to(scene, body.name))
          {
            rotor.push_back(body_index(scene, name));
            seen.insert(name);
          }
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
                " is no body of revolution in shape and material and stands "
                "still at one angle: this is one sample of what it does while "
                "it turns. It repeats every " +
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
