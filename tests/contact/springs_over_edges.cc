// SPDX-License-Identifier: LGPL-2.1-or-later

// Springs at the quadrature points of a face and elastic beds stand for the
// area round every point: a face that hangs over the edge of its target by more
// than 2 % of a cell is refused even where all of its points have a target, and
// one that does not goes on.

#include <squeal/base/exceptions.h>
#include <squeal/contact/contact_faces.h>

#include "scenes.h"

using namespace squeal;
using namespace squeal::testing;

namespace
{
  constexpr double length = .06; // of the pad along x, m

  /** A pad of one cell on a slab that ends at x = 50 mm, the pad's end being
   * @p overhang beyond; the slab turned, as no plain block is. */
  SceneParameters
  pad_on_slab(const double overhang, const double angle = 3.)
  {
    SceneParameters s;
    s.bodies = {
      make_block("slab", {{0., 0., 0.}}, {{.1, .1, .04}}, {{1, 1, 1}}),
      make_block("pad",
                 {{.05 + overhang - length / 2., 0., .04}},
                 {{length, .04, .02}},
                 {{1, 1, 1}})};
    s.bodies[0].angle = angle;
    return s;
  }

  SceneParameters
  with_contact(SceneParameters s)
  {
    ContactParameters contact;
    contact.name        = "c";
    contact.source_body = "pad";
    contact.source_face = "z_min";
    contact.target_body = "slab";
    contact.target_face = "z_max";
    contact.layout      = ContactParameters::SpringLayout::quadrature;
    contact.normal_stiffness_per_area = 1e10;
    s.contacts                        = {contact};
    return s;
  }

  SceneParameters
  with_bed(SceneParameters s)
  {
    SpringParameters bed;
    bed.name       = "b";
    bed.kind       = SpringParameters::Kind::area;
    bed.body       = "pad";
    bed.face       = "z_min";
    bed.other_body = "slab";
    bed.stiffness  = 1e10;
    s.springs      = {bed};
    return s;
  }

  void
  look(const SceneParameters &scene, const unsigned int degree)
  {
    check_contact_faces(Discretization(scene, {}, degree, MPI_COMM_SELF));
  }

  void
  refused(const SceneParameters &scene,
          const unsigned int     degree,
          const std::string     &part,
          const std::string     &text)
  {
    check_throws<InputError>([&]() { look(scene, degree); }, part, text);
  }

  void
  accepted(const SceneParameters &scene,
           const unsigned int     degree,
           const std::string     &text)
  {
    look(scene, degree);
    check(true, text);
  }

  /** Two rings with equal rims whose cells end at other places. */
  SceneParameters
  rings(const unsigned int n_slab, const unsigned int n_pad)
  {
    SceneParameters s;
    s.bodies = {make_annulus({{n_slab, 3, 1}}), make_annulus({{n_pad, 3, 1}})};
    s.bodies[0].name     = "slab";
    s.bodies[1].name     = "pad";
    s.bodies[1].position = {{0., 0., 0.}};
    return s;
  }

  void
  check_both(const SceneParameters &scene,
             const unsigned int     degree,
             const std::string     &share,
             const std::string     &text)
  {
    const std::string part = share +
                             " % of the cell's face there has no target "
                             "opposite";
    refused(with_contact(scene), degree, part, "contact, " + text);
    refused(with_bed(scene), degree, part, "bed, " + text);
  }
} // namespace



int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize init(argc, argv, 1);
  // The points of p = 1 begin at 21 % of the cell, those of p = 3 at 7 %.
  check_both(pad_on_slab(length / 6., 0.), 1, "16.7", "a sixth over the edge");
  check_both(pad_on_slab(.05 * length, 0.), 3, "5", "a twentieth, p = 3");
  refused(with_contact(pad_on_slab(length / 6.)),
          1,
          "Scene/Contact c: the faces do not meet",
          "contact over the edge of a turned block");
  refused(with_bed(pad_on_slab(length / 6.)),
          1,
          "Scene/Spring b: the faces do not meet",
          "bed over the edge of a turned block");
  for (const double angle : {0., 3.})
    {
      const auto inside = pad_on_slab(-.01, angle);
      accepted(with_contact(inside), 1, "contact, all of it on the slab");
      accepted(with_bed(inside), 1, "bed, all of it on the slab");
    }
  accepted(with_contact(pad_on_slab(.01 * length, 0.)), 1, "a hundredth over");

  SceneParameters sunk       = with_bed(pad_on_slab(-.01));
  sunk.bodies[1].position[2] = .02;
  accepted(sunk, 1, "a bed inside the other body");

  SceneParameters round         = with_contact(rings(24, 31));
  round.contacts[0].source_face = "bottom";
  round.contacts[0].target_face = "top";
  round.contacts[0].friction_direction =
    ContactParameters::FrictionDirection::slip;
  accepted(round, 2, "rims of two meshes of one circle");

  round.bodies[1].outer_radius *= 1.02;
  refused(round, 2, "has no target opposite", "a rim beyond the other");
  return 0;
}
