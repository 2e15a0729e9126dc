// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Faces in contact must lie on each other, the source within the target, and
// what this version cannot compute is refused.
#include <squeal/parameters/face_geometry.h>

#include "example_scene.h"

using namespace squeal;
using namespace squeal::testing;

namespace
{
  const std::string contact = "Scene/Contact pad_disc/";
  const std::string pad     = "Scene/Body pad/";

  /** The example without support and springs: only the pad can be wrong. */
  void
  write_pad_on_disc()
  {
    write_text("pad.prm",
               "subsection Scene\n"
               "  set Bodies = disc, pad\n"
               "  set Contacts = pad_disc\n"
               "  subsection Body disc\n"
               "    set Shape = annulus\n"
               "    set Position = 0, 0, -0.01\n"
               "  end\n"
               "  subsection Body pad\n"
               "    set Position = 0.1075, 0, 0\n"
               "    set Size = 0.01, 0.01, 0.01\n"
               "  end\n"
               "  subsection Contact pad_disc\n"
               "    set Source body = pad\n"
               "    set Source face = z_min\n"
               "    set Target body = disc\n"
               "    set Target face = top\n"
               "  end\n"
               "end\n");
  }



  void
  check_change_refused(const std::vector<std::string> &overrides,
                       const std::vector<std::string> &parts)
  {
    check_override_refused("pad.prm", overrides, parts, overrides.back());
  }

  void
  check_change_accepted(const std::vector<std::string> &overrides)
  {
    const std::string message =
      message_of([&]() { read_parameters("pad.prm", overrides).check(); });
    check(message.empty(), overrides.back() + ": is accepted " + message);
  }



  void
  faces_meet()
  {
    check_change_accepted({pad + "Position = 0.1075, 0, 0"});
    check_change_refused({pad + "Position = 0.1075, 0, 0.001"},
                         {"contact pad_disc: faces do not meet",
                          "z = 0.001 m",
                          "z = 0 m",
                          "'Scene/Body pad/Position'"});
    check_change_refused({contact + "Target face = bottom"},
                         {"faces do not meet", "look along -z"});
    check_change_refused({contact + "Source face = x_min"},
                         {"faces do not meet", "normal to x"});
    // rounding of the input stays below 1e-6 of the size, 0.24 m
    check_change_accepted({pad + "Position = 0.1075, 0, 1e-8"});
    check_change_refused({pad + "Position = 0.1075, 0, 1e-6"},
                         {"faces do not meet"});
  }



  void
  pads_beside_the_disc()
  {
    check_change_refused(
      {pad + "Position = 0.116, 0, 0"},
      {"contact pad_disc: faces do not meet", "0.05 to 0.12 m"});
    check_change_refused({pad + "Position = 0, 0.052, 0"}, {"0.05 to 0.12"});
    check_change_refused({pad + "Position = 0.2, 0, 0"}, {"side by side"});
    check_change_refused({pad + "Position = 0, 0, 0"}, {"side by side"});
    // the far corners (+-0.005, -0.119) are at a radius of 0.1191
    check_change_accepted({pad + "Position = 0, -0.114, 0"});

    const std::string round  = pad + "Shape = cylinder";
    const std::string face   = contact + "Source face = bottom";
    const std::string points = contact + "Spring layout = quadrature";
    check_change_accepted({round,
                           face,
                           points,
                           pad + "Outer radius = 0.01",
                           pad + "Position = 0.0777, 0.0777, 0"});
    check_change_refused({round,
                          face,
                          pad + "Outer radius = 0.011",
                          pad + "Position = 0.0777, 0.0777, 0"},
                         {"0.05 to 0.12 m"});
  }



  void
  blocks_on_blocks()
  {
    const std::string block = "Scene/Body disc/Shape = block";
    const std::string face  = contact + "Target face = z_max";
    const std::string size  = "Scene/Body disc/Size = 0.3, 0.02, 0.01";
    check_change_accepted({block, face, size});
    check_change_refused({block, face, size, pad + "Position = 0.1, 0.006, 0"},
                         {"faces do not meet", "y = 0.001 to 0.011 m"});
    // A pad beside the plate: friction along y is along the face.
    check_change_accepted({block,
                           size,
                           contact + "Target face = x_max",
                           contact + "Source face = x_min",
                           pad + "Position = 0.155, 0, -0.01"});
    check_change_refused({block,
                          size,
                          contact + "Target face = y_max",
                          contact + "Source face = y_min",
                          pad + "Position = 0, 0.015, -0.01"},
                         {"Friction direction", "looks along y"});
  }



  /** Of steady sliding. */
  void
  faces_look_down()
  {
    const std::vector<std::string> below = {pad + "Position = 0.1075, 0, -0.02",
                                            contact + "Source face = z_max",
                                            contact + "Target face = bottom"};
    check_change_accepted(below);
    // Steady sliding takes it, as soon as something presses it on.
    std::vector<std::string> all = below;
    all.push_back(contact + "Contact state = preload");
    check_change_refused(all, {"'Scene/Loads' is empty"});
    all.insert(all.end(),
               {"Scene/Loads = up",
                "Scene/Load up/Body = pad",
                "Scene/Load up/Face = z_min",
                "Scene/Load up/Force = 0, 0, 100"});
    check_change_accepted(all);
  }

  void
  sliding_directions()
  {
    check_change_refused({contact + "Sliding direction = 1, 1, 0"},
                         {"'Scene/Contact pad_disc/Sliding direction'",
                          "Friction direction = given"});
    check_change_refused(
      {contact + "Friction direction = given",
       contact + "Sliding direction = 0, 0, 0"},
      {"'Scene/Contact pad_disc/Sliding direction'", "must not be"});
    check_change_accepted({contact + "Friction direction = given",
                           contact + "Sliding direction = 1, 1, 0"});
    const std::string disc = "Scene/Body disc/";
    check_change_refused({disc + "Rotation axis = 0, 1, 0"},
                         {"'Scene/Body disc/Rotation axis'", "along z"});
    check_change_refused({disc + "Rotation axis = 0, 0, 0"},
                         {"'Scene/Body disc/Rotation axis'", "must not be"});
    check_change_accepted({disc + "Rotation axis = 0, 0, -2"});
  }



  /** A grid on a round face would lose springs. */
  void
  grids_need_rectangles()
  {
    const std::vector<std::string> round = {pad + "Shape = cylinder",
                                            pad + "Outer radius = 0.01",
                                            contact + "Source face = bottom"};
    const auto                     with  = [&](const std::string &last) {
      std::vector<std::string> all = round;
      all.push_back(last);
      return all;
    };
    check_change_refused(with(contact + "Grid = 11, 11"),
                         {"'Scene/Contact pad_disc/Spring layout'",
                          "face 'bottom' of body 'pad' is round",
                          "quadrature"});
    check_change_accepted(with(contact + "Spring layout = quadrature"));
    check_change_accepted(with(contact + "Grid = 1, 1"));
    check_change_accepted(with(contact + "Formulation = mortar"));
  }



  void
  bodies_of_a_pair()
  {
    check_change_refused(
      {contact + "Target body = ground", contact + "Target face ="},
      {"'ground' is for rigid source bodies"});
    const std::vector<std::string> belt = {pad + "Shape = rigid",
                                           contact + "Source face =",
                                           contact + "Target body = ground",
                                           contact + "Target face ="};
    const auto with = [&](const std::vector<std::string> &more) {
      std::vector<std::string> all = belt;
      all.insert(all.end(), more.begin(), more.end());
      return all;
    };
    check_change_accepted(belt);
    check_change_refused(with({contact + "Sliding direction = 1, 0, 0"}),
                         {"'Scene/Contact pad_disc/Sliding direction'",
                          "Friction direction = given"});
    check_change_accepted(with({contact + "Friction direction = given",
                                contact + "Sliding direction = 1, 0, 0"}));
    check_change_refused(
      with({contact + "Friction direction = slip"}),
      {"'Scene/Contact pad_disc/Friction direction'", "'ground' has no axis"});
    check_change_refused({pad + "Shape = rigid", contact + "Source face ="},
                         {"'Scene/Contact pad_disc/Target body'", "rigid"});
    check_change_refused(
      {contact + "Target body = pad", contact + "Target face = z_max"},
      {"source body itself"});
  }



  void
  laws()
  {
    check_change_refused(
      {contact + "Contact state = preload", contact + "Friction slope = -0.01"},
      {"'Scene/Contact pad_disc/Friction slope'", "must be 0"});
    check_change_refused(
      {contact + "Friction law = exponential",
       contact + "Static friction coefficient = 0.5",
       contact + "Decay speed = 0.1",
       contact + "Friction slope = -0.01"},
      {"'Scene/Contact pad_disc/Friction slope'", "slope of its own"});
    check_change_refused(
      {contact + "Friction speeds = 0, 1",
       contact + "Friction coefficients = 0.4, 0.3"},
      {"'Scene/Contact pad_disc/Friction speeds'", "Friction law = table"});
    check_change_refused(
      {contact + "Static friction coefficient = 0.6"},
      {"Static friction coefficient'", "Friction law = exponential"});
    check_change_refused({contact + "Decay speed = 0.1"},
                         {"Decay speed'", "would be ignored"});
    check_change_accepted({contact + "Contact state = stick"});
    check_change_refused(
      {contact + "Transverse slip term = true", contact + "Sliding speed = 0"},
      {"'Scene/Contact pad_disc/Sliding speed'"});
    check_change_refused({contact + "Friction coefficient = 5.1"},
                         {"from -5 to 5"});
    check_change_accepted({contact + "Friction coefficient = -5"});
  }



  void
  geometry_of_faces()
  {
    BodyParameters block;
    block.position     = {{1., 2., 3.}};
    block.size         = {{2., 4., 6.}};
    const auto upper_y = prm::flat_face(block, "y_max");
    check(upper_y && upper_y->axis == 1 && upper_y->sign == 1 &&
            upper_y->position == 4. && upper_y->lower[0] == 0. &&
            upper_y->upper[1] == 9.,
          "upper y face of a block");
    BodyParameters annulus;
    annulus.shape = BodyParameters::Shape::annulus;
    check(!prm::flat_face(annulus, "inner"), "a curved face is not flat");
    check(prm::flat_face(annulus, "top")->position == annulus.height,
          "top of an annulus");
    check(prm::faces_of(BodyParameters::Shape::rigid).empty(),
          "rigid bodies have no faces");
  }
} // namespace

int
main()
{
  write_pad_on_disc();
  faces_meet();
  pads_beside_the_disc();
  blocks_on_blocks();
  faces_look_down();
  sliding_directions();
  grids_need_rectangles();
  bodies_of_a_pair();
  laws();
  geometry_of_faces();
}
