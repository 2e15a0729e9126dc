// SPDX-License-Identifier: LGPL-2.1-or-later

// Refinement by the errors of modes works on mortar ties and on mortar contacts
// of unlike meshes: their source faces get cells of one size, also where a face
// is a part of a side and the cells beside it are coarser.

#include "scenes.h"

#include <squeal/base/exceptions.h>
#include <squeal/base/run_log.h>
#include <squeal/base/timers.h>
#include <squeal/contact/mortar.h>
#include <squeal/discretization/even_faces.h>
#include <squeal/model/mode_solution.h>

#include <deal.II/base/mpi.h>

#include <fstream>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  /** A short pad on a clamped base; its free ends make refinement local. */
  Parameters
  pad_on_base()
  {
    Parameters p;
    auto      &s = p.scene;
    s.bodies     = {
          make_block("base", {{0., 0., -.01}}, {{.06, .03, .01}}, {{3, 2, 1}}),
          make_block("pad", {{.015, 0., 0.}}, {{.03, .03, .01}}, {{4, 3, 1}})};
    s.bodies[1].young_modulus = 1e10;
    s.supports                = {make_clamp("base", "x_min")};
    p.eigen.highest_frequency = 8000.;
    auto &d                   = p.discretization;
    d.degree                  = 2;
    d.refinement     = DiscretizationParameters::Refinement::eigenvalue_error;
    d.tolerance      = 1e-4;
    d.maximum_cycles = 3;
    return p;
  }

  Parameters
  tied_pad()
  {
    Parameters p = pad_on_base();
    p.scene.ties = {
      make_tie("pad", "z_min", "base", "z_max", TieParameters::Kind::mortar)};
    return p;
  }

  Parameters
  pressed_pad()
  {
    Parameters p = pad_on_base();
    auto      &s = p.scene;
    s.supports.push_back(make_clamp("pad", "z_max"));
    s.contacts.resize(1);
    auto &c                   = s.contacts[0];
    c.name                    = "c";
    c.source_body             = "pad";
    c.source_face             = "z_min";
    c.target_body             = "base";
    c.target_face             = "z_max";
    c.formulation             = ContactParameters::Formulation::mortar;
    c.friction_coefficient    = .3;
    p.eigen.highest_frequency = 12000.;
    return p;
  }

  void
  test_refinement(const std::string &name, const Parameters &p)
  {
    Timers        timers;
    RunLog        log(false);
    squeal::Model model(p, timers);
    Table         steps({{"mesh", Table::Type::integer, "", ""},
                         {"unknowns", Table::Type::integer, "", ""},
                         {"error", Table::Type::real, "", ""},
                         {"cpu", Table::Type::real, "", ""}});
    solve_modes_adaptively(model, log, timers, &steps);
    check(steps.n_rows() == p.discretization.maximum_cycles,
          name + ": all cycles");
    for (std::size_t i = 0; i < steps.n_rows(); ++i)
      std::cout << name << ": " << steps.real(i, "unknowns")
                << " unknowns, error " << steps.real(i, "error") << '\n';
    check(model.discretization()->triangulation().has_hanging_nodes(),
          name + ": the refinement is local");
    check(steps.real(steps.n_rows() - 1, "error") < .5 * steps.real(0, "error"),
          name + ": and lowers the errors");
  }

  /** Three cells in a row, 10 mm each; the lower face of the middle one is
   * "glue". */
  void
  write_row(const std::string &name)
  {
    std::ofstream out(name);
    out << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n3\n"
           "2 1 \"glue\"\n2 2 \"rest\"\n3 9 \"row\"\n$EndPhysicalNames\n"
           "$Nodes\n16\n";
    for (unsigned int i = 0; i < 16; ++i)
      out << i + 1 << ' ' << .01 * (i / 4) << ' ' << .01 * (i % 2) << ' '
          << .01 * (i / 2 % 2) << '\n';
    out << "$EndNodes\n$Elements\n6\n";
    for (unsigned int c = 0; c < 3; ++c)
      {
        const unsigned int v = 4 * c + 1;
        out << 2 * c + 1 << " 3 2 " << (c == 1 ? "1 1 " : "2 2 ") << v << ' '
            << v + 4 << ' ' << v + 5 << ' ' << v + 1 << '\n'
            << 2 * c + 2 << " 5 2 9 1";
        for (const unsigned int k : {0, 4, 5, 1, 2, 6, 7, 3})
          out << ' ' << v + k;
        out << '\n';
      }
    out << "$EndElements\n";
  }

  void
  test_face_that_is_a_part_of_a_side()
  {
    write_row("row.msh");
    SceneParameters s;
    s.bodies = {
      make_block("row", {{0., 0., 0.}}, {{.01, .01, .01}}, {{1, 1, 1}}),
      make_block("base", {{.015, .005, -.01}}, {{.03, .01, .01}}, {{2, 1, 1}})};
    s.bodies[0].shape     = BodyParameters::Shape::gmsh;
    s.bodies[0].mesh_file = "row.msh";
    s.ties                = {
                     make_tie("row", "glue", "base", "z_max", TieParameters::Kind::mortar)};
    const auto refine = [](Discretization &d, const auto &whole) {
      std::vector<double> marks(d.triangulation().n_active_cells(), 0.);
      for (const auto &cell : d.dof_handler().active_cell_iterators())
        if (cell->material_id() == 0 &&
            std::abs(cell->center()[0] - .015) < .005)
          marks[cell->active_cell_index()] = 1.;
      d.refine(marks, .99, whole);
    };
    Discretization d(s, {}, 2, MPI_COMM_SELF), loose(s, {}, 2, MPI_COMM_SELF);
    for (unsigned int step = 0; step < 2; ++step)
      {
        refine(d, even_faces(d));
        const MortarCoupling m    = make_tie_coupling(d, PointEvaluator(d), 0);
        double               area = 0.;
        for (const double w : m.weights)
          area += w;
        check_close(area, 1e-4, 1e-12, "the face is tied as a whole");
      }
    refine(loose, std::vector<unsigned int>());
    check_throws<InputError>(
      [&] { make_tie_coupling(loose, PointEvaluator(loose), 0); },
      "hanging nodes",
      "without care for it its border has hanging nodes");
  }
} // namespace



int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test_refinement("tie", tied_pad());
  test_refinement("contact", pressed_pad());
  test_face_that_is_a_part_of_a_side();
}
