// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tests_scenes_h
#define squeal_tests_scenes_h

#include "check.h"

#include <squeal/contact/contact_terms.h>
#include <squeal/eigen/certified_solver.h>

#include <deal.II/distributed/tria.h>

#include <deal.II/fe/mapping.h>

#include <memory>
#include <string>

namespace squeal
{
  namespace testing
  {
    /** From @p lambda to the nearest of @p all, relative. */
    inline double
    distance(const Eigen::VectorXcd &all, const std::complex<double> lambda)
    {
      return (all.array() - lambda).abs().minCoeff<Eigen::PropagateNaN>() /
             std::abs(lambda);
    }

    inline BodyParameters
    make_block(const std::string                 &name,
               const Vector3                     &position,
               const Vector3                     &size,
               const std::array<unsigned int, 3> &cells)
    {
      BodyParameters body;
      body.name     = name;
      body.position = position;
      body.size     = size;
      body.cells    = cells;
      return body;
    }

    inline BodyParameters
    make_annulus(const std::array<unsigned int, 3> &cells,
                 const double                       height = 0.01)
    {
      BodyParameters body;
      body.name     = "disc";
      body.shape    = BodyParameters::Shape::annulus;
      body.height   = height;
      body.position = {{0., 0., -height}};
      body.cells    = cells;
      return body;
    }

    inline SupportParameters
    make_clamp(const std::string &body, const std::string &face)
    {
      SupportParameters support;
      support.name = "clamp of " + body;
      support.body = body;
      support.face = face;
      return support;
    }

    inline TieParameters
    make_tie(const std::string        &source,
             const std::string        &source_face,
             const std::string        &target,
             const std::string        &target_face,
             const TieParameters::Kind kind = TieParameters::Kind::automatic)
    {
      TieParameters tie;
      tie.name        = source + " to " + target;
      tie.source_body = source;
      tie.source_face = source_face;
      tie.target_body = target;
      tie.target_face = target_face;
      tie.kind        = kind;
      return tie;
    }

    /** Pad and heavy support pressed on a clamped disc, coarse meshes; springs
     * hold the support in x and y. */
    inline SceneParameters
    coarse_brake(const double friction)
    {
      SceneParameters s;
      s.bodies = {
        make_annulus({{16, 3, 1}}),
        make_block("pad", {{.1075, 0., 0.}}, {{.01, .01, .01}}, {{2, 2, 2}}),
        make_block(
          "support", {{.1075, 0., .01}}, {{.01, .01, .1}}, {{2, 2, 6}})};
      s.bodies[0].young_modulus = 217e9;
      s.bodies[1].young_modulus = 2.5e10;
      s.bodies[1].density       = 2500.;
      s.bodies[2].young_modulus = 1.67e12;
      s.bodies[2].density       = 6.86e4;
      s.ties     = {make_tie("pad", "z_max", "support", "z_min")};
      s.supports = {make_clamp("disc", "inner")};
      for (const double z : {.035, .085})
        for (const double y : {-.005, .005})
          for (const bool along_y : {true, false})
            {
              SpringParameters spring;
              spring.name        = "row";
              spring.body        = "support";
              spring.first_point = {{.1025, y, z}};
              spring.last_point  = {{.1125, y, z}};
              spring.number      = 11;
              spring.direction   = {{along_y ? 0. : 1., along_y ? 1. : 0., 0.}};
              spring.stiffness   = along_y ? 8.422e6 : 24.4e3 / 44.;
              s.springs.push_back(spring);
            }
      s.damping.model             = DampingParameters::Model::whole_model;
      s.damping.mass_damping      = .02;
      s.damping.stiffness_damping = 1e-7;
      ContactParameters contact;
      contact.name                 = "pad on disc";
      contact.source_body          = "pad";
      contact.source_face          = "z_min";
      contact.target_body          = "disc";
      contact.target_face          = "top";
      contact.friction_coefficient = friction;
      s.contacts                   = {contact};
      return s;
    }

    /** A scene with its matrices, its factor and its undamped modes. */
    struct Model
    {
      Model(const SceneParameters &s,
            const unsigned int     degree,
            const double           highest_frequency,
            const MPI_Comm         communicator = MPI_COMM_SELF,
            const unsigned int     refinements  = 0)
        : scene(s)
        , discretization(scene, parameters(refinements), degree, communicator)
        , linearized(
            linearized_system(discretization, assemble_bodies(discretization)))
        , pencil(linearized.system, scene)
        , inverse(pencil, std::pow(2. * M_PI * highest_frequency, 2))
      {
      }

      static DiscretizationParameters
      parameters(const unsigned int refinements)
      {
        DiscretizationParameters p;
        p.refinements = refinements;
        return p;
      }

      ComplexPairs
      solve(const CertifiedOptions &options)
      {
        const UndampedModes modes = undamped_modes(pencil, inverse);
        CertifiedSolver     solver(pencil, inverse, modes);
        return solver.solve(options);
      }

      SceneParameters  scene;
      Discretization   discretization;
      LinearizedSystem linearized;
      Pencil           pencil;
      ShiftedInverse   inverse;
    };

    inline CertifiedOptions
    band(const double lowest, const double highest)
    {
      CertifiedOptions options;
      options.lowest_frequency  = lowest;
      options.highest_frequency = highest;
      return options;
    }

    /** Values of the free unknowns of a serial discretisation for a
     * displacement field u(x), zero outside @p body (-1: all bodies). */
    template <typename Field>
    Eigen::VectorXd
    interpolate(const Discretization &d,
                const Field          &field,
                const int             body = -1)
    {
      const auto     &fe     = d.dof_handler().get_fe();
      Eigen::VectorXd result = Eigen::VectorXd::Zero(d.space()->n_global());
      std::vector<dealii::types::global_dof_index> dofs(fe.n_dofs_per_cell());
      for (const auto &cell : d.dof_handler().active_cell_iterators())
        {
          if (body >= 0 && cell->material_id() != unsigned(body))
            continue;
          cell->get_dof_indices(dofs);
          for (unsigned int i = 0; i < dofs.size(); ++i)
            if (const Combination &c = d.expansion(dofs[i]);
                c.size() == 1 && c[0].second == 1.)
              result[c[0].first] =
                field(d.mapping().transform_unit_to_real_cell(
                  cell,
                  fe.unit_support_point(
                    i)))[fe.system_to_component_index(i).first];
        }
      return result;
    }

    /** The six rigid motions. */
    inline Block
    rigid_motions(const Discretization &d)
    {
      Block R(d.space()->n_global(), 6);
      for (unsigned int k = 0; k < 6; ++k)
        R.col(k) = interpolate(d, [k](const dealii::Point<3> &x) {
          dealii::Tensor<1, 3> u, axis;
          if (k < 3)
            u[k] = 1.;
          else
            {
              axis[k - 3] = 1.;
              u           = dealii::cross_product_3d(axis, x);
            }
          return u;
        });
      return R;
    }

    /** A matrix as a dense one, through its entries. */
    inline Eigen::MatrixXd
    dense(const LinearOperator &A, const unsigned int n)
    {
      Triplets t;
      A.append_to(t, 1., false);
      Eigen::MatrixXd result = Eigen::MatrixXd::Zero(n, n);
      for (std::size_t k = 0; k < t.values.size(); ++k)
        result(t.rows[k], t.columns[k]) += t.values[k];
      return result;
    }

    inline std::string
    number(const double x)
    {
      char text[32];
      std::snprintf(text, sizeof text, "%.3g", x);
      return text;
    }

    /** check(value <= limit) that prints both. */
    inline void
    check_below(const double value, const double limit, const std::string &text)
    {
      check(value <= limit,
            text + ": " + number(value) + " <= " + number(limit));
    }
  } // namespace testing
} // namespace squeal

#endif
