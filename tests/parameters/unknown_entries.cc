// SPDX-License-Identifier: LGPL-2.1-or-later
//
// An entry or section that does not exist is named with its line, the nearest
// name and what is allowed there.
#include "example_scene.h"

using namespace squeal;
using namespace squeal::testing;

namespace
{
  const std::string head = "subsection Scene\n"
                           "  set Bodies = disc, pad\n"
                           "  subsection Body disc\n"
                           "  end\n";

  void
  entries()
  {
    check_text_refused(head + "  subsection Body pad\n"
                              "    set Yuong modulus = 1e9\n"
                              "  end\n"
                              "end\n",
                       {"test.prm:6: unknown entry "
                        "'Scene/Body pad/Yuong modulus'",
                        "did you mean 'Young modulus'?",
                        "Allowed here: Shape, Position, "},
                       "misspelt entry");
    check_text_refused("set Degree = 2\n",
                       {"test.prm:1: unknown entry 'Degree'",
                        "'Discretization'",
                        "Allowed here: Analysis, "},
                       "entry at the wrong place");
    check_text_refused("subsection Scene\nset Density = 2\nend\n",
                       {"test.prm:2: ", "'Scene/Body <name>'"},
                       "entry of a body outside of its section");
  }



  void
  sections()
  {
    check_text_refused("set Analysis = modes\n"
                       "subsection Discretisation\n"
                       "  set Degree = 2\n"
                       "end\n",
                       {"test.prm:2: unknown section 'Discretisation'",
                        "did you mean 'Discretization'?",
                        "Allowed here: Scene, "},
                       "misspelt section");
    check_text_refused("subsection Scen\nsubsection Body pad\nend\nend\n",
                       {"test.prm:1: unknown section 'Scen'"},
                       "the outer one of two unknown sections");
    check_text_refused(
      "subsection Body pad\nset Shape = block\nend\n",
      {"test.prm:1: unknown section 'Body pad'", "belongs in section 'Scene'"},
      "section of a body outside of the scene");
    check_text_refused("subsection Output\nsubsection Plots\nend\nend\n",
                       {"test.prm:2: unknown section 'Output/Plots'"},
                       "section where there are none");
  }



  void
  members_of_lists()
  {
    check_text_refused(head + "  subsection Body padd\n"
                              "  end\n"
                              "  subsection Body pad\n"
                              "  end\n"
                              "end\n",
                       {"test.prm:5: section 'Scene/Body padd'",
                        "'padd' is not in 'Scene/Bodies = disc, pad' "
                        "(test.prm:2)",
                        "did you mean 'pad'?"},
                       "section of a name that is not in the list");
    check_text_refused(head + "end\n",
                       {"test.prm:2: ", "no section 'Scene/Body pad'"},
                       "name in the list without a section");
    check_text_refused("subsection Scene\n"
                       "  subsection Spring a\n"
                       "  end\n"
                       "end\n",
                       {"test.prm:2: ", "'a' is not in 'Scene/Springs = '"},
                       "section without a list");
    check_text_refused("subsection Scene\n"
                       "  set Bodies = a, a\n"
                       "  subsection Body a\n"
                       "  end\n"
                       "end\n",
                       {"test.prm:2: ", "'a' is there twice"},
                       "name twice in a list");
    for (const char *name : {"a b", "1a", "a/b", ""})
      check_text_refused("subsection Scene\nset Bodies = x, " +
                           std::string(name) + "\nend\n",
                         {"test.prm:2: ", "letters, digits"},
                         "list with '" + std::string(name) + "'");
  }



  void
  overrides_are_checked_alike()
  {
    const std::string file = write_example();
    check_override_refused(file,
                           {"Scene/Body pad/Densty = 1"},
                           {"--set: unknown entry 'Scene/Body pad/Densty'",
                            "did you mean 'Density'?"},
                           "override of an unknown entry");
    check_override_refused(file,
                           {"Scene/Body padd/Density = 1"},
                           {"--set: ", "(example.prm:4)", "mean 'pad'?"},
                           "override in an unknown body");
  }



  void
  all_families_are_declared()
  {
    for (const char *family : {"Bodies, Body",
                               "Ties, Tie",
                               "Springs, Spring",
                               "Supports, Support",
                               "Lumped masses, Lumped mass",
                               "Loads, Load",
                               "Contacts, Contact",
                               "Matrix parts, Matrix part"})
      {
        const std::string text  = family;
        const std::string list  = text.substr(0, text.find(','));
        const std::string word  = text.substr(text.find(',') + 2);
        const std::string start = "subsection Scene\nset " + list +
                                  " = a, b\nsubsection " + word + " a\nend\n";
        check_text_refused(start + "end\n",
                           {"'Scene/" + word + " b'"},
                           list + " need their sections");
        write_text("test.prm", start + "subsection " + word + " b\nend\nend\n");
        read_parameters("test.prm");
      }
  }
} // namespace

int
main()
{
  entries();
  sections();
  members_of_lists();
  overrides_are_checked_alike();
  all_families_are_declared();
}
