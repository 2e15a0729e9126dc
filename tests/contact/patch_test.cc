// SPDX-License-Identifier: LGPL-2.1-or-later

// Patch test: a block pressed on another one by an even pressure is under that
// pressure everywhere, whatever their meshes, tied or in contact without
// friction.

#include "contact/turned_block.h"
#include "worst.h"

#include <squeal/contact/mortar.h>
#include <squeal/discretization/face_quadrature.h>
#include <squeal/discretization/load_vector.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>

#include <deal.II/fe/fe_values.h>

#include <cstdio>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  constexpr double pressure = 2e6, width = .03, depth = .02;

  /** Source on target; three sides hold without stress. */
  SceneParameters
  pressed_blocks(const std::array<unsigned int, 3> &source,
                 const std::array<unsigned int, 3> &target,
                 const bool                         tied)
  {
    SceneParameters s;
    s.bodies = {
      make_block("target", {{.01, .02, -.01}}, {{width, depth, .01}}, target),
      make_block("source", {{.01, .02, 0.}}, {{width, depth, .01}}, source)};
    for (auto &body : s.bodies)
      {
        body.young_modulus = 7e10;
        for (const auto &[face, axis] :
             {std::pair<const char *, const char *>{"x_min", "x"},
              {"y_min", "y"}})
          {
            SupportParameters support;
            support.name       = body.name + " " + face;
            support.body       = body.name;
            support.face       = face;
            support.kind       = SupportParameters::Kind::components;
            support.components = {axis};
            s.supports.push_back(support);
          }
      }
    s.supports.push_back(s.supports.front());
    s.supports.back().name       = "foot";
    s.supports.back().face       = "z_min";
    s.supports.back().components = {"z"};
    LoadParameters load;
    load.name  = "press";
    load.body  = "source";
    load.face  = "z_max";
    load.force = {{0., 0., -pressure * width * depth}};
    s.loads    = {load};
    if (tied)
      s.ties = {make_tie(
        "source", "z_min", "target", "z_max", TieParameters::Kind::mortar)};
    else
      {
        // Without friction each body widens on its own.
        s.bodies[1].young_modulus = 2e10;
        s.bodies[1].poisson_ratio = .2;
        ContactParameters contact;
        contact.name        = "contact";
        contact.source_body = "source";
        contact.source_face = "z_min";
        contact.target_body = "target";
        contact.target_face = "z_max";
        contact.formulation = ContactParameters::Formulation::mortar;
        s.contacts          = {contact};
      }
    return s;
  }

  /** A ring on a disc, with arcs of other radii. Without lateral contraction
   * the inner edges hold without stress. */
  SceneParameters
  pressed_rings(const bool tied)
  {
    SceneParameters s = pressed_blocks({{1, 1, 1}}, {{1, 1, 1}}, tied);
    for (unsigned int b = 0; b < 2; ++b)
      {
        const std::string name    = s.bodies[b].name;
        const double      modulus = s.bodies[b].young_modulus;
        s.bodies[b]               = make_annulus({{10, b == 0 ? 2u : 3u, 1}});
        s.bodies[b].name          = name;
        s.bodies[b].young_modulus = modulus;
        s.bodies[b].poisson_ratio = 0.;
        s.bodies[b].position      = {{0., 0., b == 0 ? -.01 : 0.}};
      }
    for (auto &support : s.supports)
      support.face = support.name == "foot" ? "bottom" : "inner";
    const auto rename = [](auto &pair) {
      pair.source_face = "bottom";
      pair.target_face = "top";
    };
    for (auto &tie : s.ties)
      rename(tie);
    for (auto &contact : s.contacts)
      rename(contact);
    s.loads[0].face = "top";
    return s;
  }

  /** Largest difference of the stresses at Gauss points from sigma_zz = -p and
   * zero, over p. */
  double
  stress_error(const Discretization &d, const Eigen::VectorXd &u)
  {
    const dealii::QGauss<3> gauss(d.degree() + 1);
    const auto             &fe = d.dof_handler().get_fe();
    dealii::FEValues<3>     values(
      d.mapping(), fe, gauss, dealii::update_gradients);
    std::vector<dealii::types::global_dof_index> dofs(fe.n_dofs_per_cell());
    Worst                                        worst;
    for (const auto &cell : d.dof_handler().active_cell_iterators())
      {
        values.reinit(cell);
        cell->get_dof_indices(dofs);
        const auto  &body = d.scene().bodies[cell->material_id()];
        const double shear =
          body.young_modulus / (2. * (1. + body.poisson_ratio));
        const double volume =
          2. * shear * body.poisson_ratio / (1. - 2. * body.poisson_ratio);
        for (unsigned int q = 0; q < gauss.size(); ++q)
          {
            Eigen::Matrix3d gradient = Eigen::Matrix3d::Zero();
            for (unsigned int i = 0; i < dofs.size(); ++i)
              {
                double value = 0.;
                for (const auto &[row, weight] : d.expansion(dofs[i]))
                  value += weight * u[row];
                for (unsigned int k = 0; k < 3; ++k)
                  gradient(fe.system_to_component_index(i).first, k) +=
                    value * values.shape_grad(i, q)[k];
              }
            Eigen::Matrix3d stress =
              shear * (gradient + gradient.transpose()) +
              volume * gradient.trace() * Eigen::Matrix3d::Identity();
            stress(2, 2) += pressure;
            worst.add(stress.cwiseAbs().maxCoeff<Eigen::PropagateNaN>());
          }
      }
    return worst.largest() / pressure;
  }

  double
  solved_error(const Discretization &d)
  {
    const auto   system = linearized_system(d, assemble_bodies(d));
    const Pencil pencil(system.system, d.scene());
    const Block  force = system.restrict_forces(
      load_vector(d, PointEvaluator(d), d.scene().loads[0]));
    const ShiftedInverse inverse(pencil, 0.);
    Block                v = inverse.solve(force);
    v += inverse.solve(force - pencil.multiply_undamped_stiffness(v));
    return stress_error(d, system.expand(v).col(0));
  }

  void
  check_pair(const SceneParameters &scene,
             const unsigned int     degree,
             const std::string     &name,
             const bool             with_hanging_nodes = false)
  {
    SceneParameters loaded = scene;
    Discretization  d(loaded, {}, degree, MPI_COMM_SELF);
    // The polynomial arcs of a ring enclose a little less than the circles.
    loaded.loads[0].force[2] =
      -pressure *
      face_quadrature(
        d, face_id(d.coarse_mesh(), scene, "source", scene.loads[0].face), 8)
        .total_area();
    if (with_hanging_nodes)
      {
        refine_one_cell(d, 0, .008, .018);
        refine_one_cell(d, 0, .004, .016);
      }
    check_below(solved_error(d),
                1e-10,
                name + ", p = " + std::to_string(degree) +
                  ": the stress is even, over the pressure");
  }
} // namespace



int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize init(argc, argv, 1);
  for (const unsigned int degree : {1, 2})
    for (const bool tied : {true, false})
      {
        const std::string kind = tied ? "tied" : "contact";
        check_pair(pressed_blocks({{3, 3, 1}}, {{4, 4, 1}}, tied),
                   degree,
                   kind + ", 3 x 3 on 4 x 4");
        check_pair(pressed_blocks({{5, 4, 1}}, {{2, 3, 1}}, tied),
                   degree,
                   kind + ", 5 x 4 on 2 x 3");
        check_pair(pressed_blocks({{3, 3, 1}}, {{4, 4, 1}}, tied),
                   degree,
                   kind + ", hanging nodes on the target",
                   true);
        SceneParameters turned = pressed_blocks({{3, 3, 1}}, {{4, 4, 1}}, tied);
        turned.bodies[0]       = make_turned_block(turned.bodies[0], -.05);
        turned.bodies[1]       = make_turned_block(turned.bodies[1], .14);
        check_pair(
          turned, degree, kind + ", meshes turned by 8 and -3 degrees");
        check_pair(pressed_rings(tied),
                   degree + 1,
                   kind + ", a ring of 3 on one of 2 cells along the radius");
      }
  return 0;
}
