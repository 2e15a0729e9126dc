// SPDX-License-Identifier: LGPL-2.1-or-later

// Observed motions of a pair against rigid motions: the centre of a ring or a
// shoe, where no material is, moves with the body; the face of the load that
// presses is the same motion whether a force, a pressure or a tilted force
// does; and a shoe has no far face.

#include "scenes.h"
#include "worst.h"

#include <squeal/model/observed_motions.h>
#include <squeal/model/pressed_model.h>

#include <deal.II/base/mpi.h>

#include <deal.II/fe/mapping.h>

#include <fstream>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  using Vector = dealii::Tensor<1, 3>;

  /** Unknowns of the field @p u of the places of the nodes. */
  template <typename Field>
  Block
  unknowns_of(const Discretization &d, const Field &u)
  {
    Block       result = Block::Zero(d.space()->n_owned(), 1);
    const auto &fe     = d.dof_handler().get_fe();
    std::vector<dealii::types::global_dof_index> dofs(fe.dofs_per_cell);
    for (const auto &cell : d.dof_handler().active_cell_iterators())
      {
        cell->get_dof_indices(dofs);
        for (unsigned int i = 0; i < dofs.size(); ++i)
          {
            const Vector value = u(d.mapping().transform_unit_to_real_cell(
              cell, fe.unit_support_point(i)));
            for (const auto &[row, weight] : d.expansion(dofs[i]))
              result(row, 0) = value[fe.system_to_component_index(i).first];
          }
      }
    return result;
  }

  /** One point of the source at @p x, under which the target looks along @p
   * normal. */
  ContactGeometry
  point_at(const dealii::Point<3> &x, const Vector &normal)
  {
    ContactGeometry g;
    ContactFrame    frame;
    frame.normal     = normal;
    frame.sliding    = Vector({0., 1., 0.});
    frame.transverse = dealii::cross_product_3d(frame.sliding, normal);
    g.points         = {x};
    g.areas          = {1e-4};
    g.frames         = {frame};
    g.speed_ratio    = {1.};
    g.source_rows.resize(1);
    g.target_rows.resize(1);
    return g;
  }

  ContactNodes
  nodes_of(const std::string &source, const ContactGeometry &g)
  {
    ContactParameters contact;
    contact.name        = "contact";
    contact.source_body = source;
    contact.target_body = "ground";
    return ContactNodes({contact}, {g});
  }

  /** The centre of a body against three translations and turning about it. */
  void
  check_centre(const Discretization   &d,
               const Block            &l,
               const dealii::Point<3> &centre,
               const std::string      &claim)
  {
    Worst worst;
    for (unsigned int c = 0; c < 3; ++c)
      {
        Vector unit;
        unit[c]            = 1.;
        const Block moved  = unknowns_of(d, [&](const auto &) { return unit; }),
                    turned = unknowns_of(d, [&](const auto &x) {
                      return dealii::cross_product_3d(unit, x - centre) / .1;
                    });
        for (unsigned int k = 0; k < 3; ++k)
          {
            const auto of = l.col(PressedModel::centre_x + k);
            worst.add(std::abs(of.dot(moved.col(0)) - (k == c ? 1. : 0.)));
            worst.add(std::abs(of.dot(turned.col(0))));
          }
      }
    check_within(worst, 1e-10, claim);
  }

  void
  ring()
  {
    SceneParameters s;
    s.bodies         = {make_annulus({{12, 1, 1}})};
    s.bodies[0].name = "ring";
    const Discretization d(s, {}, 2, MPI_COMM_SELF);
    const auto           bodies = assemble_bodies(d);
    const auto           l      = observed_motions(
      d,
      nodes_of("ring", point_at({.08, 0., -.01}, Vector({0., 0., 1.}))),
      bodies);
    check_centre(
      d, l, bodies[0].centre, "the centre of a ring moves and turns with it");
    const Block up = unknowns_of(d, [](const auto &) {
      return Vector({0., 0., 1.});
    });
    check_close(l.col(PressedModel::far_face).dot(up.col(0)),
                1.,
                1e-10,
                "its far face is there");
  }

  /** Half a cylinder's wall of cells between radii of 80 and 90 mm. */
  void
  write_shoe(const std::string &file)
  {
    constexpr unsigned int n = 8;
    std::ofstream          out(file);
    out.precision(17);
    out << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n2\n"
           "2 1 \"out\"\n3 2 \"solid\"\n$EndPhysicalNames\n$Nodes\n"
        << 4 * (n + 1) << "\n";
    for (unsigned int i = 0; i <= n; ++i)
      for (unsigned int k = 0; k < 4; ++k)
        {
          const double a = M_PI * (double(i) / n - .5),
                       r = k % 2 == 0 ? .08 : .09;
          out << 4 * i + k + 1 << ' ' << r * std::cos(a) << ' '
              << r * std::sin(a) << ' ' << (k / 2 == 0 ? 0. : .01) << "\n";
        }
    out << "$EndNodes\n$Elements\n" << 2 * n << "\n";
    for (unsigned int i = 0; i < n; ++i)
      {
        const unsigned int a = 4 * i + 1, b = a + 4;
        out << 2 * i + 1 << " 3 2 1 1 " << a + 1 << ' ' << b + 1 << ' ' << b + 3
            << ' ' << a + 3 << "\n"
            << 2 * i + 2 << " 5 2 2 1 " << a << ' ' << a + 1 << ' ' << b + 1
            << ' ' << b << ' ' << a + 2 << ' ' << a + 3 << ' ' << b + 3 << ' '
            << b + 2 << "\n";
      }
    out << "$EndElements\n";
  }

  void
  shoe()
  {
    write_shoe("shoe.msh");
    SceneParameters s;
    s.bodies              = {make_block("shoe", {{0., 0., 0.}}, {}, {})};
    s.bodies[0].shape     = BodyParameters::Shape::gmsh;
    s.bodies[0].mesh_file = "shoe.msh";
    const Discretization d(s, {}, 2, MPI_COMM_SELF);
    const auto           bodies = assemble_bodies(d);
    check(bodies[0].centre[0] < .06, "the centre lies beside the shoe");
    const auto l = observed_motions(
      d,
      nodes_of("shoe", point_at({.09, 0., .005}, Vector({-1., 0., 0.}))),
      bodies);
    check_centre(
      d, l, bodies[0].centre, "the centre of a shoe moves and turns with it");
    check(l.col(PressedModel::far_face).array().isNaN().all(),
          "what has no far face has no motion of one");
  }

  Eigen::VectorXd
  loaded_face(const std::vector<LoadParameters> &loads)
  {
    SceneParameters s;
    s.bodies = {
      make_block("pad", {{0., 0., 0.}}, {{.01, .01, .01}}, {{2, 2, 1}})};
    s.loads = loads;
    const Discretization d(s, {}, 2, MPI_COMM_SELF);
    return observed_motions(
             d,
             nodes_of("pad", point_at({0., 0., 0.}, Vector({0., 0., 1.}))),
             assemble_bodies(d))
      .col(PressedModel::loaded_face);
  }

  /** Loads that hold a block against its target by nothing but a moment, along
   * the face, or not at all. */
  void
  loads_that_do_not_press()
  {
    LoadParameters load;
    load.name = "load";
    load.body = "pad";
    load.face = "y_min";
    check(loaded_face({}).array().isNaN().all(), "no load");
    load.moment = {{1., 0., 0.}};
    check(loaded_face({load}).array().isNaN().all(), "a moment");
    load.force = {{0., 100., 1e-13}};
    check(loaded_face({load}).array().isNaN().all(), "along the face");
    load.force = {{0., 0., 100.}};
    check(loaded_face({load}).array().isNaN().all(), "off the face");
    load.force = {{0., 100., -1.}};
    check(loaded_face({load}).norm() > 0., "one that presses a little");
  }

  /** Loads on the top of a block, and one on its side that does not press. */
  void
  loads()
  {
    LoadParameters force, pressure, both, tilted, side;
    force.force       = {{0., 0., -100.}};
    pressure.pressure = 1e6;
    both.force        = {{0., 0., -50.}};
    both.pressure     = .5e6;
    tilted.force      = {{0., 30., -100.}};
    for (LoadParameters *load : {&force, &pressure, &both, &tilted})
      {
        load->name = "press";
        load->body = "pad";
        load->face = "z_max";
      }
    side.name  = "side";
    side.body  = "pad";
    side.face  = "y_min";
    side.force = {{0., 200., -1.}};
    std::vector<Eigen::VectorXd> motions;
    for (const LoadParameters &load : {force, pressure, both, tilted})
      {
        SceneParameters s;
        s.bodies = {
          make_block("pad", {{0., 0., 0.}}, {{.01, .01, .01}}, {{2, 2, 1}})};
        s.loads = {side, load};
        const Discretization d(s, {}, 2, MPI_COMM_SELF);
        motions.push_back(
          observed_motions(
            d,
            nodes_of("pad", point_at({0., 0., 0.}, Vector({0., 0., 1.}))),
            assemble_bodies(d))
            .col(PressedModel::loaded_face));
        const auto field = [](const auto &x) {
          return Vector({7., 5., 3. * x[2] / .01});
        };
        check_close(motions.back().dot(unknowns_of(d, field).col(0)),
                    3.,
                    1e-10,
                    "the loaded face moves along the normal of the pair");
      }
    for (const auto &motion : motions)
      check((motion - motions[0]).norm() < 1e-12 * motions[0].norm(),
            "a force, a pressure, both, and a tilted force act on one motion");
  }
} // namespace

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  ring();
  shoe();
  loads();
  loads_that_do_not_press();
}
