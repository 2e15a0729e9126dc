// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tests_shape_scene_h
#define squeal_tests_shape_scene_h

#include <squeal/discretization/discretization.h>

#include <deal.II/distributed/tria.h>

#include <deal.II/fe/fe_values.h>

#include <Eigen/Dense>

#include <memory>

namespace squeal
{
  namespace testing
  {
    /** A disc, a pad that touches it, a support tied to the pad, and a rigid
     * body beside them. */
    inline SceneParameters
    shape_scene()
    {
      SceneParameters scene;
      scene.bodies.resize(4);
      auto &disc        = scene.bodies[0];
      disc.name         = "disc";
      disc.shape        = BodyParameters::Shape::annulus;
      disc.position     = {{0., 0., -0.01}};
      disc.inner_radius = 0.05;
      disc.outer_radius = 0.12;
      disc.height       = 0.01;
      disc.cells        = {{12, 3, 1}};
      auto &pad         = scene.bodies[1];
      pad.name          = "pad";
      pad.size          = {{0.02, 0.03, 0.01}};
      pad.position      = {{0.085, 0., 0.}};
      pad.cells         = {{2, 2, 2}};
      auto &support     = scene.bodies[2];
      support           = pad;
      support.name      = "support";
      support.position  = {{0.085, 0., 0.01}};
      auto &mass        = scene.bodies[3];
      mass.name         = "mass <1>";
      mass.shape        = BodyParameters::Shape::rigid;
      mass.position     = {{0.2, 0., 0.}};
      TieParameters tie;
      tie.name        = "glue";
      tie.source_body = "pad";
      tie.source_face = "z_max";
      tie.target_body = "support";
      tie.target_face = "z_min";
      scene.ties.push_back(tie);
      return scene;
    }

    /** Uniform, then one cell of the pad cut into eight: hanging nodes. */
    inline std::unique_ptr<Discretization>
    refined(const SceneParameters &scene, const unsigned int degree)
    {
      auto result = std::make_unique<Discretization>(
        scene, DiscretizationParameters(), degree, MPI_COMM_WORLD);
      std::vector<double> indicators;
      for (const auto &cell : result->triangulation().active_cell_iterators())
        indicators.push_back(
          cell->material_id() == 1 && cell->center()[0] > 0.085 &&
              cell->center()[1] > 0. && cell->center()[2] < 0.005
            ? 1.
            : 0.);
      result->refine(indicators, 0.9);
      return result;
    }

    /** Motions linear in x: the tied bodies share one, the disc and the rigid
     * body (which can only turn) have their own. */
    struct LinearMotion
    {
      std::array<Eigen::Matrix3d, 3> gradient;
      std::array<Eigen::Vector3d, 3> shift;

      explicit LinearMotion(const double seed)
      {
        for (unsigned int k = 0; k < 3; ++k)
          for (unsigned int i = 0; i < 3; ++i)
            {
              shift[k][i] = 0.02 * std::sin(seed + 5. * k + i);
              for (unsigned int j = 0; j < 3; ++j)
                gradient[k](i, j) =
                  std::cos(seed * (1. + k) + 2. * i + 3.3 * j);
            }
        const Eigen::Matrix3d a = gradient[2];
        gradient[2]             = a - a.transpose();
      }

      Eigen::Vector3d
      at(const unsigned int body, const Eigen::Vector3d &x) const
      {
        const unsigned int k = body == 0 ? 0 : body == 3 ? 2 : 1;
        return shift[k] + gradient[k] * x;
      }
    };

    /** The free unknowns of a motion. */
    inline Block
    unknowns(const Discretization &discretization, const LinearMotion &motion)
    {
      const auto        &space = *discretization.space();
      Block              u     = Block::Zero(space.n_owned(), 1);
      const unsigned int first = space.first_owned();
      const auto         set = [&](const unsigned int row, const double value) {
        if (row >= first && row < first + space.n_owned())
          u(row - first, 0) = value;
      };

      const auto         &fe = discretization.dof_handler().get_fe();
      dealii::FEValues<3> values(
        discretization.mapping(),
        fe,
        dealii::Quadrature<3>(fe.get_unit_support_points()),
        dealii::update_quadrature_points);
      std::vector<dealii::types::global_dof_index> dofs(fe.n_dofs_per_cell());
      for (const auto &cell :
           discretization.dof_handler().active_cell_iterators())
        if (cell->is_locally_owned())
          {
            values.reinit(cell);
            cell->get_dof_indices(dofs);
            for (unsigned int i = 0; i < dofs.size(); ++i)
              {
                const auto &free = discretization.expansion(dofs[i]);
                const auto &x    = values.quadrature_point(i);
                if (free.size() == 1 && free[0].second == 1.)
                  set(free[0].first,
                      motion.at(cell->material_id(),
                                {x[0],
                                 x[1],
                                 x[2]})[fe.system_to_component_index(i).first]);
              }
          }

      const auto           &p = discretization.scene().bodies[3].position;
      const Eigen::Vector3d centre(p[0], p[1], p[2]);
      const Eigen::Vector3d shift = motion.at(3, centre);
      const auto           &W     = motion.gradient[2];
      const Eigen::Vector3d turn(W(2, 1), W(0, 2), W(1, 0));
      for (unsigned int c = 0; c < 3; ++c)
        {
          set(discretization.rigid_row(3, c), shift[c]);
          set(discretization.rigid_row(3, 3 + c), turn[c]);
        }
      return u;
    }
  } // namespace testing
} // namespace squeal

#endif
