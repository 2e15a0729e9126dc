// SPDX-License-Identifier: LGPL-2.1-or-later

// Names of a brake whose bodies come from mesh files: its disc has nodal
// circles and diameters as an annulus has, wherever the brake lies and however
// few curved cells it has; what is no flat ring is no disc.

#include <squeal/discretization/assembly.h>
#include <squeal/discretization/ring_remarks.h>
#include <squeal/eigen/mode_naming.h>

#include <deal.II/base/mpi.h>

#include "../contact/placed_scene.h"
#include "../scene/gmsh_annulus.h"

using namespace squeal;
using namespace squeal::testing;

namespace
{
  constexpr double highest = 6000.; // Hz

  /** A pad, clamped at its back, on a disc that is clamped at its bore. */
  SceneParameters
  brake()
  {
    SceneParameters s;
    s.bodies = {
      make_annulus({{24, 3, 1}}),
      make_block("pad", {{.1, 0., 0.}}, {{.02, .016, .01}}, {{2, 2, 1}})};
    s.bodies[1].young_modulus = 2e9;
    s.supports = {make_clamp("disc", "inner"), make_clamp("pad", "z_max")};
    ContactParameters contact;
    contact.name                      = "pad on disc";
    contact.source_body               = "pad";
    contact.source_face               = "z_min";
    contact.target_body               = "disc";
    contact.target_face               = "top";
    contact.layout                    = Layout::quadrature;
    contact.normal_stiffness_per_area = 1e13;
    s.contacts                        = {contact};
    return s;
  }

  /** The same from mesh files whose nodes go through @p placing. */
  SceneParameters
  meshed(SceneParameters s, const Placing &placing)
  {
    BodyParameters &disc = s.bodies[0];
    AnnulusFile(disc, 27).write_2("disc.msh", [&](auto x) {
      const Vector3 y = placing.point({{x[0], x[1], x[2]}});
      for (unsigned int c = 0; c < 3; ++c)
        x[c] = y[c];
      return x;
    });
    disc.shape                 = BodyParameters::Shape::gmsh;
    disc.mesh_file             = "disc.msh";
    disc.position              = {{0., 0., 0.}};
    s.bodies[1]                = placed_block(s.bodies[1], placing);
    ContactParameters &contact = s.contacts[0];
    contact.target_face        = "z_max";
    contact.friction_direction = Direction::given;
    contact.sliding_direction  = placing.direction({{0., 1., 0.}});
    return s;
  }

  std::vector<std::string>
  names_of(const SceneParameters &scene)
  {
    const Model         model(scene, 2, highest);
    const UndampedModes modes = undamped_modes(model.pencil, model.inverse);
    const Block         shapes =
      model.linearized.expand(Block(modes.shapes.leftCols(modes.n_certified)));
    const auto      bodies = assemble_bodies(model.discretization);
    Eigen::MatrixXd shares(2, shapes.cols());
    for (unsigned int b = 0; b < 2; ++b)
      shares.row(b) =
        scene.bodies[b].density *
        shapes.cwiseProduct(bodies[b].mass->multiply(shapes)).colwise().sum();
    std::vector<std::string> result;
    for (const ModeName &name :
         ModeNamer(model.discretization).name(shapes, shares))
      result.push_back(name.text);
    return result;
  }

  std::string
  joined(const std::vector<std::string> &names)
  {
    std::string text;
    for (const std::string &name : names)
      text += name + ", ";
    return text;
  }

  void
  as_an_annulus()
  {
    const std::vector<std::string> expected = names_of(brake());
    unsigned int                   n_discs  = 0;
    for (const std::string &name : expected)
      n_discs += name[0] == '(';
    check(n_discs > 8, "the annulus has names: " + joined(expected));
    const std::pair<std::string, Placing> placings[] = {
      {"in place", {}},
      {"with its axis along y", turned(M_PI / 2., {1., 0., 0.})},
      {"with its axis along x", turned(-M_PI / 2., {0., 1., 0.})},
      {"turned about its axis", turned(.7, {0., 0., 1.})},
      {"upside down", turned(M_PI, {1., 0., 0.})},
      {"anyhow", turned(1.1, {1., 2., -.5})}};
    for (const auto &[text, placing] : placings)
      {
        const auto found = names_of(meshed(brake(), placing));
        check(found == expected,
              "names of a mesh " + text + ": " + joined(found));
      }
  }

  void
  rings()
  {
    const auto ring_of = [](const SceneParameters &scene) {
      const Discretization d(scene, {}, 1, MPI_COMM_SELF);
      return disc_rings(d)[0];
    };
    const auto turned_ring =
      ring_of(meshed(brake(), turned(M_PI / 2., {1., 0., 0.})));
    check(turned_ring.has_value(), "a turned disc has a ring");
    check_below(std::abs(turned_ring->inner_radius - .05) +
                  std::abs(turned_ring->outer_radius - .12) +
                  std::abs(std::abs(turned_ring->directions[2][1]) - 1.) +
                  std::abs(std::abs(turned_ring->other_side) - .01) +
                  turned_ring->centre.norm(),
                1e-12,
                "of its radii, axis, thickness and centre");

    SceneParameters alone = meshed(brake(), {});
    alone.bodies.pop_back();
    alone.supports.pop_back();
    alone.contacts.clear();
    check(ring_of(alone).has_value(), "a disc alone has a ring");

    // A face that is a cone, and one with corners.
    SceneParameters cone = meshed(brake(), {});
    AnnulusFile(brake().bodies[0], 27).write_2("disc.msh", [](auto x) {
      x[2] += .01 * std::hypot(x[0], x[1]);
      return x;
    });
    check(!ring_of(cone), "a cone is no disc");
    SceneParameters plate = scene_of({});
    check(!ring_of(plate), "a plate is no disc");
  }

  /** Curved cells are a ring however few there are; straight ones cut off a
   * part, and a run says what that means. */
  void
  rings_of_few_cells()
  {
    const auto of = [](const unsigned int n_cells, const unsigned int n_nodes) {
      SceneParameters s;
      s.bodies             = {make_annulus({{n_cells, 1, 1}})};
      BodyParameters &disc = s.bodies[0];
      AnnulusFile(disc, n_nodes).write_2("few.msh");
      disc.shape     = BodyParameters::Shape::gmsh;
      disc.mesh_file = "few.msh";
      disc.position  = {{0., 0., 0.}};
      return s;
    };
    for (const unsigned int n_cells : {6, 8, 11, 16})
      for (const unsigned int n_nodes : {8, 20, 27})
        {
          const SceneParameters    scene = of(n_cells, n_nodes);
          DiscretizationParameters p;
          const std::string text = std::to_string(n_cells) + " cells of " +
                                   std::to_string(n_nodes) + " nodes: ";
          for (const unsigned int n_refinements : {0, 1})
            {
              p.refinements = n_refinements;
              const Discretization d(scene, p, 2, MPI_COMM_SELF);
              const auto           ring     = disc_rings(d)[0];
              const auto           remarks  = remarks_on_rings(d);
              const bool           is_round = n_nodes > 8 || n_cells >= 12;
              check(ring.has_value() == is_round, text + "a ring or none");
              // Both sides of a disc of straight cells are nearly rings.
              check(remarks.size() == (is_round ? 0 : 2),
                    text + "what is nearly a ring is told");
              if (n_cells == 8 && !is_round)
                check(remarks[0].find("covers 90.0 % of a flat ring") !=
                        std::string::npos,
                      text + remarks[0]);
              if (is_round)
                check_below(std::abs(ring->inner_radius - .05) +
                              std::abs(ring->outer_radius - .12) +
                              std::hypot(ring->centre[0], ring->centre[1]) +
                              std::abs(std::abs(ring->other_side) - .01),
                            1e-12,
                            text + "of its radii, centre and thickness");
            }
        }
  }
} // namespace

int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  as_an_annulus();
  rings();
  rings_of_few_cells();
}
