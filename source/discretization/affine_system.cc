// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/base/unknown_choice.h>
#include <squeal/discretization/affine_system.h>
#include <squeal/discretization/carried_damping.h>
#include <squeal/discretization/face_quadrature.h>
#include <squeal/discretization/point_evaluator.h>
#include <squeal/scene/turning.h>

namespace squeal
{
  namespace
  {
    using Row = Functionals::Row;

    /** Factor of the mass matrix of body @p b: its density, kg/m^3; 1 of a
     * rigid body. */
    std::function<double(const SceneParameters &)>
    density_of(const SceneParameters &scene, const unsigned int b)
    {
      const bool rigid = scene.bodies[b].shape == BodyParameters::Shape::rigid;
      return [b, rigid](const SceneParameters &s) {
        return rigid ? 1. : s.bodies[b].density;
      };
    }

    AffineTerm
    mass_term(const SceneParameters &scene,
              const unsigned int     b,
              const BodyMatrices    &matrices)
    {
      return {"mass of " + scene.bodies[b].name,
              matrices.mass,
              [b, density = density_of(scene, b)](const SceneParameters &s) {
                const double m = density(s);
                return TermCoefficients{m, mass_damping_of(s, b) * m, 0.};
              }};
    }

    /** The material is damped by the rate of strain that it sees; mass damping
     * is that of the surroundings, which do not turn. */
    void
    add_carried_damping(const Discretization &d,
                        const unsigned int    b,
                        const BodyMatrices   &matrices,
                        AffineSystem         &system)
    {
      const auto damping = [b](const SceneParameters &s) {
        return elastic_coefficients(s, s.bodies[b]).damping *
               carrier_of(s, b).rotation_speed;
      };
      const std::string name = "damping carried by " + d.scene().bodies[b].name;
      // Ranks can not share the entries that eliminated contacts ask for.
      if (d.space()->n_ranks() > 1 && damping(d.scene()) == 0.)
        system.terms.push_back(
          {name, matrices.mass, [damping, name](const SceneParameters &s) {
             if (damping(s) != 0.)
               throw InputError("stiffness damping of a body with a 'Rotation "
                                "speed' that is 0 at first (" +
                                name +
                                "): run without mpirun, or give it a value in "
                                "'Scene' too");
             return TermCoefficients();
           }});
      else
        system.terms.push_back({name,
                                carried_stiffness(d, b, matrices.stiffness),
                                [damping](const SceneParameters &s) {
                                  return TermCoefficients{0., 0., damping(s)};
                                }});
    }

    void
    add_body_terms(const Discretization &d,
                   const unsigned int    b,
                   const BodyMatrices   &matrices,
                   AffineSystem         &system)
    {
      const auto &scene   = d.scene();
      const auto &body    = scene.bodies[b];
      const auto  density = density_of(scene, b);
      system.terms.push_back(mass_term(scene, b, matrices));
      if (matrices.stiffness)
        system.terms.push_back({"stiffness of " + body.name,
                                matrices.stiffness,
                                [b](const SceneParameters &s) {
                                  return elastic_coefficients(s, s.bodies[b]);
                                }});
      if (matrices.gyroscopic)
        {
          system.terms.push_back(
            {"gyroscopic of " + body.name,
             matrices.gyroscopic,
             [b, density](const SceneParameters &s) {
               return TermCoefficients{
                 0., density(s) * carrier_of(s, b).rotation_speed, 0.};
             }});
          system.terms.push_back(
            {"convective of " + body.name,
             matrices.convective,
             [b, density](const SceneParameters &s) {
               const double speed = carrier_of(s, b).rotation_speed;
               return TermCoefficients{0., 0., density(s) * speed * speed};
             }});
          add_carried_damping(d, b, matrices, system);
        }
    }



    using Displacements = std::vector<std::array<Row, 3>>;

    Displacements
    displacements_at(const PointEvaluator                &evaluator,
                     const SceneParameters               &scene,
                     const SpringParameters              &spring,
                     const std::string                   &body,
                     const std::vector<dealii::Point<3>> &points)
    {
      // A bed lies between two faces, whose facets may differ a little.
      const bool is_bed = spring.kind == SpringParameters::Kind::area;
      const auto found =
        is_bed ? evaluator.displacements(body_index(scene, body), points, 1e-4)
               : evaluator.displacements(body_index(scene, body), points);
      for (const bool inside : found.found)
        if (!inside)
          throw InputError(
            "Scene/Spring " + spring.name +
            (is_bed ? "/Other body: a part of the face does not lie on body '"
                    : ": a point of it lies outside body '") +
            body + (is_bed ? "'" : "': change First point or Last point"));
      return found.rows;
    }



    /** Adds equal springs at points with @p weights along @p direction.
     * @p values: stiffness and dashpot of a scene. */
    void
    add_springs_along(
      const Discretization  &d,
      const std::string     &name,
      const unsigned int     number,
      const Displacements   &motion,
      const Eigen::VectorXd &weights,
      const Vector3         &direction,
      const std::function<std::pair<double, double>(const SpringParameters &)>
                   &values,
      AffineSystem &system)
    {
      std::vector<Row> rows;
      for (const auto &u : motion)
        rows.push_back(combine({{direction[0], &u[0]},
                                {direction[1], &u[1]},
                                {direction[2], &u[2]}}));
      const auto functionals =
        std::make_shared<const Functionals>(d.space(), std::move(rows));
      system.terms.push_back(
        {name,
         std::make_shared<LowRankMatrix>(functionals, weights, functionals),
         [number, values](const SceneParameters &s) {
           const auto &p                   = s.springs[number];
           const auto [stiffness, dashpot] = values(p);
           TermCoefficients c              = elastic_coefficients(
             s, stiffness, p.stiffness_damping, p.structural_damping);
           c.damping += dashpot;
           return c;
         }});
    }



    void
    add_spring_term(const Discretization &d,
                    const PointEvaluator &evaluator,
                    const unsigned int    number,
                    AffineSystem         &system)
    {
      const auto                   &scene  = d.scene();
      const auto                   &spring = scene.springs[number];
      std::vector<dealii::Point<3>> points;
      Eigen::VectorXd               weights;
      if (spring.kind == SpringParameters::Kind::points)
        {
          points  = spring_points(spring);
          weights = Eigen::VectorXd::Ones(points.size());
        }
      else
        {
          const FaceQuadrature face = face_quadrature(
            d, face_id(d.coarse_mesh(), scene, spring.body, spring.face));
          points  = face.points;
          weights = Eigen::Map<const Eigen::VectorXd>(face.areas.data(),
                                                      face.areas.size());
        }
      Displacements motion =
        displacements_at(evaluator, scene, spring, spring.body, points);
      if (spring.other_body != "ground")
        {
          const Displacements other = displacements_at(
            evaluator, scene, spring, spring.other_body, points);
          for (std::size_t i = 0; i < motion.size(); ++i)
            for (unsigned int c = 0; c < 3; ++c)
              motion[i][c] =
                combine({{1., &motion[i][c]}, {-1., &other[i][c]}});
        }
      // All four, as a sweep may give a value to what is 0 here.
      add_springs_along(
        d,
        "spring " + spring.name,
        number,
        motion,
        weights,
        spring.direction,
        [](const SpringParameters &p) {
          return std::make_pair(p.stiffness, p.dashpot);
        },
        system);
      for (unsigned int c = 0; c < 3; ++c)
        {
          Vector3 along{{0., 0., 0.}};
          along[c] = 1.;
          add_springs_along(
            d,
            "spring " + spring.name + " along " + "xyz"[c],
            number,
            motion,
            weights,
            along,
            [c](const SpringParameters &p) {
              return std::make_pair(p.stiffnesses[c], p.dashpots[c]);
            },
            system);
        }
    }



    /** Throws InputError for a point outside the body. */
    AffineTerm
    lumped_mass_term(const Discretization &d,
                     const PointEvaluator &evaluator,
                     const unsigned int    number)
    {
      const auto        &scene = d.scene();
      const auto        &mass  = scene.lumped_masses[number];
      const unsigned int body  = body_index(scene, mass.body);
      const auto found = evaluator.displacements(body, {place_of(scene, mass)});
      if (!found.found[0])
        throw InputError("Scene/Lumped mass " + mass.name +
                         "/Point lies outside body '" + mass.body + "'");
      const auto functionals = std::make_shared<const Functionals>(
        d.space(),
        std::vector<Row>(found.rows[0].begin(), found.rows[0].end()));
      return {"lumped mass " + mass.name,
              std::make_shared<LowRankMatrix>(
                functionals, Eigen::VectorXd::Ones(3), functionals),
              [number, body](const SceneParameters &s) {
                const double m = s.lumped_masses[number].mass;
                return TermCoefficients{m, mass_damping_of(s, body) * m, 0.};
              }};
    }
  } // namespace



  AffineSystem
  friction_terms(const AffineSystem &system)
  {
    AffineSystem result;
    result.space = system.space;
    std::copy_if(system.terms.begin(),
                 system.terms.end(),
                 std::back_inserter(result.terms),
                 [](const AffineTerm &term) { return term.is_friction; });
    return result;
  }



  double
  mass_damping_of(const SceneParameters &scene, const unsigned int body)
  {
    switch (scene.damping.model)
      {
      case DampingParameters::Model::whole_model:
        return scene.damping.mass_damping;
      case DampingParameters::Model::per_part:
        return scene.bodies[body].mass_damping;
      case DampingParameters::Model::none:
        return 0.;
      }
    unknown_choice("damping model");
  }



  std::vector<dealii::Point<3>>
  spring_points(const SpringParameters &spring)
  {
    std::vector<dealii::Point<3>> points;
    for (unsigned int i = 0; i < spring.number; ++i)
      {
        const double s =
          spring.number > 1 ? double(i) / (spring.number - 1) : 0.;
        dealii::Point<3> x;
        for (unsigned int c = 0; c < 3; ++c)
          x[c] = (1. - s) * spring.first_point[c] + s * spring.last_point[c];
        points.push_back(x);
      }
    return points;
  }



  TermCoefficients
  elastic_coefficients(const SceneParameters &scene, const BodyParameters &body)
  {
    const double modulus =
      body.material_model == BodyParameters::MaterialModel::isotropic
        ? body.young_modulus
        : 1.;
    TermCoefficients c = elastic_coefficients(
      scene, modulus, body.stiffness_damping, body.structural_damping);
    // What is measured of a material is there whatever the damping model is,
    // and in place of the loss factor that the model gives all bodies.
    if (body.has_modulus_table())
      c.stiffness.imag(body.table_loss_factor * modulus);
    return c;
  }

  TermCoefficients
  elastic_coefficients(const SceneParameters &scene,
                       const double           k,
                       const double           part_beta,
                       const double           part_eta)
  {
    double beta = 0., eta = 0.;
    if (scene.damping.model == DampingParameters::Model::whole_model)
      {
        beta = scene.damping.stiffness_damping;
        eta  = scene.damping.structural_damping;
      }
    else if (scene.damping.model == DampingParameters::Model::per_part)
      {
        beta = part_beta;
        eta  = part_eta;
      }
    return {0., beta * k, {k, eta * k}};
  }



  AffineSystem
  body_system(const Discretization &d, const std::vector<BodyMatrices> &bodies)
  {
    AffineSystem system;
    system.space      = d.space();
    const auto &scene = d.scene();
    for (unsigned int b = 0; b < bodies.size(); ++b)
      add_body_terms(d, b, bodies[b], system);
    const PointEvaluator evaluator(d);
    for (unsigned int i = 0; i < scene.springs.size(); ++i)
      add_spring_term(d, evaluator, i, system);
    for (unsigned int i = 0; i < scene.lumped_masses.size(); ++i)
      system.terms.push_back(lumped_mass_term(d, evaluator, i));
    return system;
  }



  std::vector<BodyInertia>
  inertia_of_bodies(const Discretization            &d,
                    const std::vector<BodyMatrices> &bodies)
  {
    std::vector<BodyInertia> result;
    const auto              &scene = d.scene();
    for (unsigned int b = 0; b < bodies.size(); ++b)
      result.push_back({b, mass_term(scene, b, bodies[b])});
    if (scene.lumped_masses.empty())
      return result;
    const PointEvaluator evaluator(d);
    for (unsigned int i = 0; i < scene.lumped_masses.size(); ++i)
      result.push_back({body_index(scene, scene.lumped_masses[i].body),
                        lumped_mass_term(d, evaluator, i)});
    return result;
  }
} // namespace squeal
