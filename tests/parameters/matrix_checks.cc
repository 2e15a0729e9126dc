// SPDX-License-Identifier: LGPL-2.1-or-later
//
// In scenes of kind matrices nothing may be set that has nothing to act on, or
// that the contact pattern says.
#include "example_scene.h"

using namespace squeal;
using namespace squeal::testing;

namespace
{
  const std::string file = "matrices.prm";

  void
  write_scene()
  {
    write_text("k.mtx", "");
    write_text("m.mtx", "");
    write_text("pattern.csv", "");
    write_text(file,
               "subsection Scene\n"
               "  set Kind = matrices\n"
               "  set Matrix parts = m, k\n"
               "  subsection Matrix part m\n"
               "    set File = m.mtx\n    set Role = mass\n  end\n"
               "  subsection Matrix part k\n"
               "    set File = k.mtx\n    set Role = stiffness\n  end\n"
               "end\n");
  }

  void
  coefficients_act_on_something()
  {
    check_override_refused(
      file,
      {"Scene/Contact normal stiffness = 1e8"},
      {"'Scene/Contact normal stiffness'", "acts on nothing"},
      "stiffness of no contact pattern");
    check_override_refused(file,
                           {"Scene/Friction coefficient = 0.4"},
                           {"'Scene/Friction coefficient'", "acts on nothing"},
                           "coefficient of no friction");
    read_parameters(file,
                    {"Scene/Friction coefficient = 0.4",
                     "Scene/Contact normal stiffness = 1e8",
                     "Scene/Contact pattern file = pattern.csv"})
      .check();
    read_parameters(file,
                    {"Scene/Friction coefficient = 0.4",
                     "Scene/Matrix parts = m, k, f",
                     "Scene/Matrix part f/File = k.mtx",
                     "Scene/Matrix part f/Role = friction"})
      .check();
  }

  void
  the_pattern_has_points_and_directions()
  {
    const std::vector<std::string> contact = {
      "Scene/Contacts = pair",
      "Scene/Contact pattern file = pattern.csv",
      "Scene/Node table file = pattern.csv",
      "Scene/Contact pair/Source body = pad"};
    read_parameters(file, contact).check();
    for (const std::string entry : {"Grid = 4, 3",
                                    "Contact point = 0, 0, 1",
                                    "Friction direction = given",
                                    "Sliding direction = -1, 0, 0"})
      {
        std::vector<std::string> overrides = contact;
        overrides.push_back("Scene/Contact pair/" + entry);
        check_override_refused(
          file,
          overrides,
          {"'Scene/Contact pair/" + entry.substr(0, entry.find(" =")) + "'",
           "Contact pattern file"},
          entry + " with matrices");
      }
  }
} // namespace



int
main()
{
  write_scene();
  coefficients_act_on_something();
  the_pattern_has_points_and_directions();
}
