// SPDX-License-Identifier: LGPL-2.1-or-later

// Meshes that stand in or off one another are refused by every formulation,
// and faces that touch within rounded coordinates are taken.

#include "scenes.h"

#include <squeal/base/exceptions.h>

#include <deal.II/base/mpi.h>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  using Formulation = ContactParameters::Formulation;
  using Layout      = ContactParameters::SpringLayout;

  /** A block of 10 mm whose foot is @p depth, m, inside a larger one. */
  void
  build(const Formulation formulation, const Layout layout, const double depth)
  {
    SceneParameters s;
    s.bodies = {
      make_block("floor", {{0., 0., -.01}}, {{.05, .05, .01}}, {{3, 3, 1}}),
      make_block("pad", {{0., 0., -depth}}, {{.01, .01, .01}}, {{2, 2, 1}})};
    s.supports = {make_clamp("floor", "z_min"), make_clamp("pad", "z_max")};
    ContactParameters c;
    c.name        = "pad on floor";
    c.source_body = "pad";
    c.source_face = "z_min";
    c.target_body = "floor";
    c.target_face = "z_max";
    c.formulation = formulation;
    c.layout      = layout;
    c.grid        = {{3, 3}};
    s.contacts    = {c};
    const Discretization d(s, {}, 2, MPI_COMM_SELF);
    linearized_system(d, assemble_bodies(d));
  }
} // namespace

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (const auto &[name, formulation, layout] :
       {std::make_tuple("grid", Formulation::springs, Layout::grid),
        {"quadrature", Formulation::springs, Layout::quadrature},
        {"node to surface", Formulation::node_to_surface, Layout::grid},
        {"mortar", Formulation::mortar, Layout::grid}})
    {
      for (const double depth : {0., 1e-8, -1e-8})
        build(formulation, layout, depth);
      check(true, std::string(name) + ": rounding is taken");
      for (const double depth : {3e-3, 1e-3, 1e-5})
        check_throws<InputError>(
          [&]() { build(formulation, layout, depth); },
          formulation == Formulation::mortar ? "pad on floor"
                                             : "mm inside body 'floor'",
          std::string(name) + ": a pad in the floor is refused");
      for (const double depth : {-1e-3, -1e-5})
        check_throws<InputError>([&]() { build(formulation, layout, depth); },
                                 "pad on floor",
                                 std::string(name) +
                                   ": a pad above the floor is refused");
    }
}
