// SPDX-License-Identifier: LGPL-2.1-or-later

// Loads, springs, guides and couplings as brakes have them: a pressure does the
// work p dV, springs by components are as many single ones, a bed between two
// bodies feels their relative motion only, a face tied to a rigid body moves as
// that does, and a guide works along any axis.

#include "scenes.h"
#include "worst.h"

#include <squeal/discretization/load_vector.h>
#include <squeal/discretization/point_evaluator.h>
#include <squeal/eigen/undamped_modes.h>

#include <deal.II/base/mpi.h>

#include <deal.II/dofs/dof_tools.h>

#include <Eigen/Eigenvalues>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  LoadParameters
  make_pressure(const std::string &body,
                const std::string &face,
                const double       pressure)
  {
    LoadParameters load;
    load.name     = face;
    load.body     = body;
    load.face     = face;
    load.pressure = pressure;
    return load;
  }

  /** Nodal values of a linear motion u = A x of all free unknowns. */
  Block
  linear_motion(const Discretization &d, const Eigen::Matrix3d &A)
  {
    Block u = Block::Zero(d.space()->n_owned(), 1);
    std::map<dealii::types::global_dof_index, dealii::Point<3>> points;
    dealii::DoFTools::map_dofs_to_support_points(
      d.mapping(), d.dof_handler(), points);
    std::vector<dealii::types::global_dof_index> dofs(
      d.dof_handler().get_fe().n_dofs_per_cell());
    for (const auto &cell : d.dof_handler().active_cell_iterators())
      {
        cell->get_dof_indices(dofs);
        for (unsigned int i = 0; i < dofs.size(); ++i)
          {
            const unsigned int c =
              d.dof_handler().get_fe().system_to_component_index(i).first;
            const auto &x = points.at(dofs[i]);
            for (const auto &[row, weight] : d.expansion(dofs[i]))
              u(row, 0) = A(c, 0) * x[0] + A(c, 1) * x[1] + A(c, 2) * x[2];
          }
      }
    return u;
  }

  void
  test_pressure_does_work_on_the_volume()
  {
    SceneParameters s;
    s.bodies = {make_annulus({{24, 3, 2}}, .02)};
    const Discretization d(s, {}, 3, MPI_COMM_SELF);
    const PointEvaluator evaluator(d);
    const double         p = 3e5;
    Block                f = Block::Zero(d.space()->n_owned(), 1);
    for (const std::string face : {"inner", "outer", "bottom", "top"})
      f += load_vector(d, evaluator, make_pressure("disc", face, p));
    const double volume = M_PI * (.12 * .12 - .05 * .05) * .02;
    for (unsigned int k = 0; k < 9; ++k)
      {
        Eigen::Matrix3d A = Eigen::Matrix3d::Zero();
        A(k / 3, k % 3)   = 1.;
        const double work = (f.transpose() * linear_motion(d, A))(0, 0);
        check_close(work,
                    k % 4 == 0 ? -p * volume : 0.,
                    1e-7,
                    "pressure all round: work on strain " + std::to_string(k),
                    p * volume);
      }
    const Block push =
      load_vector(d, evaluator, make_pressure("disc", "top", p));
    double resultant = 0.;
    for (Eigen::Index i = 0; i < push.rows(); ++i)
      resultant += push(i, 0);
    check_close(resultant,
                -p * volume / .02,
                1e-7,
                "pressure on the upper face pushes down");
  }



  SceneParameters
  two_blocks(const double gap = 0.)
  {
    SceneParameters s;
    s.bodies = {
      make_block("low", {{0., 0., 0.}}, {{.02, .02, .01}}, {{2, 2, 1}}),
      make_block("top", {{0., 0., .01 + gap}}, {{.02, .02, .01}}, {{1, 3, 1}})};
    return s;
  }

  Eigen::MatrixXd
  stiffness(const SceneParameters &s, const unsigned int degree = 2)
  {
    const Discretization d(s, {}, degree, MPI_COMM_SELF);
    const auto           bodies = assemble_bodies(d);
    const auto           system = linearized_system(d, bodies);
    const Pencil         pencil(system.system, s);
    const unsigned int   n = pencil.space()->n_owned();
    return pencil.apply(ComplexBlock::Identity(n, n)).stiffness.real();
  }

  void
  test_springs_by_components()
  {
    for (const auto kind :
         {SpringParameters::Kind::points, SpringParameters::Kind::area})
      {
        const bool       is_bed = kind == SpringParameters::Kind::area;
        SpringParameters spring;
        spring.name         = "mount";
        spring.kind         = kind;
        spring.body         = "top";
        spring.face         = is_bed ? "z_min" : "";
        spring.other_body   = "low";
        spring.first_point  = {{.002, -.003, .01}};
        spring.last_point   = {{.008, .004, .01}};
        spring.number       = is_bed ? 1 : 3;
        SceneParameters one = two_blocks(), three = two_blocks();
        spring.stiffnesses = {{1e13, 2e13, 5e13}};
        one.springs        = {spring};
        spring.stiffnesses = {{0., 0., 0.}};
        for (unsigned int c = 0; c < 3; ++c)
          {
            spring.direction    = {{0., 0., 0.}};
            spring.direction[c] = 1.;
            spring.stiffness    = c == 0 ? 1e13 : c == 1 ? 2e13 : 5e13;
            three.springs.push_back(spring);
          }
        const Eigen::MatrixXd A = stiffness(one), B = stiffness(three);
        check_below((A - B).norm() / B.norm(),
                    1e-14,
                    std::string(is_bed ? "bed" : "points") +
                      ": three components are three springs");
        check((A - stiffness(two_blocks())).norm() > 1e-6 * A.norm(),
              "and they are there");
      }
  }

  void
  test_a_bed_feels_relative_motion()
  {
    SceneParameters  s = two_blocks();
    SpringParameters bed;
    bed.name        = "shim";
    bed.kind        = SpringParameters::Kind::area;
    bed.body        = "top";
    bed.face        = "z_min";
    bed.other_body  = "low";
    bed.stiffnesses = {{2e11, 3e11, 7e11}};
    s.springs       = {bed};
    const Discretization d(s, {}, 2, MPI_COMM_SELF);
    const Pencil         pencil(body_system(d, assemble_bodies(d)), s);
    for (unsigned int c = 0; c < 3; ++c)
      {
        Block all = Block::Zero(d.space()->n_owned(), 1), upper = all;
        std::vector<dealii::types::global_dof_index> dofs(
          d.dof_handler().get_fe().n_dofs_per_cell());
        for (const auto &cell : d.dof_handler().active_cell_iterators())
          {
            cell->get_dof_indices(dofs);
            for (unsigned int i = 0; i < dofs.size(); ++i)
              if (d.dof_handler().get_fe().system_to_component_index(i).first ==
                  c)
                for (const auto &[row, weight] : d.expansion(dofs[i]))
                  {
                    all(row, 0) = 1.;
                    if (cell->material_id() == 1)
                      upper(row, 0) = 1.;
                  }
          }
        const auto energy = [&](const Block &u) {
          return (u.cast<std::complex<double>>().adjoint() *
                  pencil.apply(u.cast<std::complex<double>>()).stiffness)(0, 0)
            .real();
        };
        const double k = bed.stiffnesses[c] * .02 * .02;
        check_close(energy(upper), k, 1e-9, "a bed pulls on relative motion");
        check_close(energy(all), 0., 1e-9, "and not on a common one", k);
      }
  }



  /** A rod of Poisson ratio 0, clamped at x = 0, with a rigid body at its end:
   * axial modes obey kL tan(kL) = m_rod / m_tip. */
  void
  test_rigid_coupling_against_the_rod_with_a_tip_mass()
  {
    SceneParameters s;
    s.bodies = {
      make_block("rod", {{.05, 0., 0.}}, {{.1, .01, .01}}, {{4, 1, 1}})};
    s.bodies[0].poisson_ratio = 0.;
    BodyParameters tip;
    tip.name     = "tip";
    tip.shape    = BodyParameters::Shape::rigid;
    tip.position = {{.12, 0., .005}};
    tip.mass     = .05;
    tip.inertia  = {{1e-5, 2e-5, 2e-5}};
    s.bodies.push_back(tip);
    s.ties     = {make_tie("rod", "x_max", "tip", "")};
    s.supports = {make_clamp("rod", "x_min")};
    const Discretization d(s, {}, 4, MPI_COMM_SELF);
    const auto           system = linearized_system(d, assemble_bodies(d));
    const Pencil         pencil(system.system, s);
    const double E = s.bodies[0].young_modulus, rho = s.bodies[0].density,
                 ratio = rho * 1e-5 / tip.mass, speed = std::sqrt(E / rho);
    const UndampedModes modes =
      undamped_modes(pencil, std::pow(2. * M_PI * 80e3, 2));
    for (unsigned int n = 0; n < 3; ++n)
      {
        double low = n * M_PI + 1e-9, high = (n + .5) * M_PI - 1e-9;
        for (unsigned int k = 0; k < 100; ++k)
          {
            const double middle = .5 * (low + high);
            (middle * std::tan(middle) < ratio ? low : high) = middle;
          }
        const double omega = low / .1 * speed;
        check_below((modes.omega_squared.array().sqrt() / omega - 1.)
                      .abs()
                      .minCoeff<Eigen::PropagateNaN>(),
                    n == 0 ? 1e-9 : 1e-6,
                    "axial mode " + std::to_string(n) + " with a tip mass");
      }
    const Block                   full = system.expand(modes.shapes);
    const PointEvaluator          evaluator(d);
    std::vector<dealii::Point<3>> corners;
    for (const double y : {-.005, .005})
      for (const double z : {0., .005, .01})
        corners.emplace_back(.1, y, z);
    const auto on_rod = evaluator.displacements(0, corners),
               on_tip = evaluator.displacements(1, corners);
    Worst worst;
    for (std::size_t i = 0; i < corners.size(); ++i)
      for (unsigned int c = 0; c < 3; ++c)
        worst.add((Functionals(d.space(), {on_rod.rows[i][c]}).apply(full) -
                   Functionals(d.space(), {on_tip.rows[i][c]}).apply(full))
                    .norm() /
                  full.norm());
    check_below(worst.largest(), 1e-13, "the end moves as the rigid body does");
  }

  void
  test_load_on_a_rigid_body()
  {
    SceneParameters s;
    BodyParameters  b;
    b.name   = "mass";
    b.shape  = BodyParameters::Shape::rigid;
    s.bodies = {b};
    LoadParameters load;
    load.name   = "push";
    load.body   = "mass";
    load.force  = {{1., 2., 3.}};
    load.moment = {{4., 5., 6.}};
    const Discretization d(s, {}, 1, MPI_COMM_SELF);
    const Block          f = load_vector(d, PointEvaluator(d), load);
    for (unsigned int c = 0; c < 6; ++c)
      check(f(d.rigid_row(0, c), 0) == c + 1.,
            "force and moment on a rigid body");
  }

  /** A block between a guide and a clamp, with the same sizes along any axis.
   */
  void
  test_guides_along_any_axis()
  {
    Eigen::VectorXd reference;
    for (const unsigned int axis : {2u, 0u, 1u})
      {
        Vector3 size{{.03, .03, .03}}, position{{0., 0., 0.}};
        std::array<unsigned int, 3> cells{{2, 2, 2}};
        size[axis]  = .05;
        cells[axis] = 3;
        SceneParameters s;
        s.bodies = {make_block("block", position, size, cells)};
        const std::string letter(1, "xyz"[axis]);
        s.supports         = {make_clamp("block", letter + "_max")};
        s.supports[0].kind = SupportParameters::Kind::guided;
        const Discretization  d(s, {}, 2, MPI_COMM_SELF);
        const Pencil          pencil(body_system(d, assemble_bodies(d)), s);
        const unsigned int    n   = pencil.space()->n_owned();
        const auto            all = pencil.apply(ComplexBlock::Identity(n, n));
        const Eigen::VectorXd values =
          Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd>(
            all.stiffness.real(), all.mass.real(), Eigen::EigenvaluesOnly)
            .eigenvalues();
        if (axis == 2)
          reference = values;
        else
          check_below((values - reference).norm() / reference.norm(),
                      1e-11,
                      "guided along " + letter + " as along z");
      }
  }
} // namespace



int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test_pressure_does_work_on_the_volume();
  test_springs_by_components();
  test_a_bed_feels_relative_motion();
  test_rigid_coupling_against_the_rod_with_a_tip_mass();
  test_load_on_a_rigid_body();
  test_guides_along_any_axis();
}
