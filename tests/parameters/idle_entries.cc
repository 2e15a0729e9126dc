// SPDX-License-Identifier: LGPL-2.1-or-later

// Entries without effect: those of another shape are refused or named, unless a
// later file or --set has changed what they belong to.

#include "example_scene.h"

using namespace squeal;
using namespace squeal::testing;

namespace
{
  const std::string disc = "Scene/Body disc/", pad = "Scene/Body pad/",
                    support = "Scene/Body support/",
                    contact = "Scene/Contact pad_disc/",
                    guide   = "Scene/Spring guide/";

  std::string
  notes_of(const std::string &file, const std::vector<std::string> &overrides)
  {
    std::string text;
    for (const std::string &note : read_parameters(file, overrides).notes)
      text += note;
    return text;
  }

  void
  check_named(const std::vector<std::string> &overrides,
              const std::string              &entry,
              const std::string              &cause)
  {
    const std::string note = notes_of("example.prm", overrides);
    check(note == "entries without effect: '" + entry + "' (" + cause + ")",
          entry + " is named, and nothing else: " + note);
  }

  void
  refused()
  {
    for (const char *entry : {"Mesh file = pad.msh",
                              "Physical volume = pad",
                              "Mesh length unit = 0.001",
                              "Mass = 2"})
      check_override_refused(
        "example.prm",
        {pad + entry},
        {"example.prm: '" + pad, "would be ignored by a block"},
        entry);
    write_text("masses.prm",
               "include example.prm\nsubsection Scene\n  subsection Body pad\n "
               "   set Mass = 2\n  end\nend\n");
    check_refused([]() { read_parameters("masses.prm").check(); },
                  {"masses.prm: '" + pad + "Mass' is for 'Shape = rigid'"},
                  "a file that includes the shape");
  }

  void
  named()
  {
    check(notes_of("example.prm", {}).empty(), "the example is in order");
    check_named(
      {pad + "Inner radius = 0.01"}, pad + "Inner radius", "'Shape = block'");
    check_named(
      {disc + "Thickness = 0.01"}, disc + "Thickness", "'Shape = annulus'");
    check_named(
      {pad + "Element layers = 3"}, pad + "Element layers", "'Shape = block'");
    check_named({pad + "Rotation axis = 0, 0, -1"},
                pad + "Rotation axis",
                "the body is no target of a contact");
    for (const char *entry : {"Normal stiffness",
                              "Normal stiffness per area",
                              "Tangential stiffness"})
      check_named(
        {contact + "Formulation = mortar", contact + entry + " = 1e7"},
        contact + entry,
        "'Formulation = mortar'");
    check_named({guide + "Stiffness = 0",
                 guide + "Stiffnesses = 1, 1, 1",
                 guide + "Direction = 0, 1, 0"},
                "Scene/Spring guide/Direction",
                "'Stiffness' and 'Dashpot' are 0");
    check_named({"Discretization/Tolerance = 1e-2"},
                "Discretization/Tolerance",
                "'Refinement = none'");
    check_named({"Eigenvalues/Number of pairs = 5"},
                "Eigenvalues/Number of pairs",
                "'Solver = certified'");
    check_named({"Scene/Load top/Ramp time = 1"},
                "Scene/Load top/Ramp time",
                "'Analysis = cea'");
    check_named({"Scene/Load top/Ramp time = 1", "Analysis = transient"},
                "Scene/Load top/Ramp time",
                "'Start = steady sliding'");
    for (const char *analysis : {"limit cycle", "triggers", "preload"})
      check_named(
        {"Scene/Load top/Ramp time = 1", std::string("Analysis = ") + analysis},
        "Scene/Load top/Ramp time",
        std::string("'Analysis = ") + analysis + "'");
    check_named({pad + "Rotation centre = 0, 0, 1"},
                pad + "Rotation centre",
                "the body is no target of a contact");
    check_named({"Discretization/Growth rate tolerance = 1"},
                "Discretization/Growth rate tolerance",
                "'Refinement = none'");
    check_named({"Eigenvalues/Compare with direct = true", "Analysis = angles"},
                "Eigenvalues/Compare with direct",
                "'Analysis = angles'");
  }

  void
  not_named()
  {
    const std::vector<std::vector<std::string>> useful = {
      {pad + "Inner radius = 0.05"}, // the default
      {disc + "Rotation axis = 0, 0, -1"},
      {pad + "Rotation axis = 0, 0, -1", pad + "Angle = 10"},
      {contact + "Normal stiffness = 1e7"},
      {guide + "Stiffnesses = 1, 1, 1"},
      {"Discretization/Tolerance = 1e-2",
       "Discretization/Refinement = eigenvalue error"},
      {"Eigenvalues/Number of pairs = 5", "Eigenvalues/Solver = direct"},
      {"Eigenvalues/Number of pairs = 5",
       "Eigenvalues/Compare with direct = true"},
      {"Scene/Load top/Ramp time = 1",
       "Analysis = transient",
       "Transient/Start = ramp"},
      {"Scene/Load top/Ramp time = 1",
       "Analysis = preload",
       "Output/Export matrices = true"},
      {"Discretization/Growth rate tolerance = 1",
       "Discretization/Tolerance = 1e-2",
       "Discretization/Refinement = contact error"}};
    for (const auto &overrides : useful)
      check(notes_of("example.prm", overrides).empty(),
            overrides.back() + " has an effect");
    // --set comes after the file, and a file after what it includes.
    check(notes_of("example.prm", {pad + "Shape = cylinder"}).empty(),
          "the size of the block that it was");
    write_text(
      "meshed.prm",
      "include example.prm\nsubsection Scene\n  subsection Body pad\n "
      "   set Shape = gmsh\n    set Mesh file = pad.msh\n  end\nend\n");
    write_text("block.prm",
               "include meshed.prm\nsubsection Scene\n  subsection Body pad\n  "
               "  set Shape = block\n  end\nend\n");
    const Parameters p = read_parameters("block.prm");
    check(p.notes.empty() && p.scene.bodies[1].mesh_file.empty(),
          "a block again has no mesh file");
    for (const auto &[path, value] : p.used)
      check(path != pad + "Mesh file" || value.empty(),
            "nor in the entries as used, which can be run again");
  }

  /** What a sweep or a fit changes is not idle for what it is at the start. */
  void
  varied()
  {
    write_text("axes.prm",
               "include example.prm\nset Analysis = sweep\n"
               "subsection Scene\n"
               " subsection Body pad\n  set Rotation axis = 0, 0, -1\n end\n"
               " subsection Spring guide\n  set Stiffness = 0\n"
               "  set Stiffnesses = 1, 1, 1\n  set Direction = 0, 1, 0\n end\n"
               "end\nsubsection Sweep\n set Axes = k, phi\n"
               " subsection Axis k\n  set Entries = " +
                 guide + "Stiffness\n set From = 0\n set To = 2e5\n end\n" +
                 " subsection Axis phi\n  set Entries = " + pad +
                 "Angle\n set From = 0\n set To = 20\n end\nend\n");
    check(
      notes_of("axes.prm", {}).empty(),
      "axes give the direction of a spring and the axis of a body effect: " +
        notes_of("axes.prm", {}));
    check_named({guide + "Stiffness = 0",
                 guide + "Stiffnesses = 1, 1, 1",
                 guide + "Direction = 0, 1, 0",
                 "Sweep/Sensitivities = " + pad + "Density"},
                guide + "Direction",
                "'Stiffness' and 'Dashpot' are 0");
    check(notes_of("example.prm",
                   {guide + "Stiffness = 0",
                    guide + "Stiffnesses = 1, 1, 1",
                    guide + "Direction = 0, 1, 0",
                    "Sweep/Sensitivities = " + guide + "Stiffness"})
            .empty(),
          "so do sensitivities");
    check(notes_of("example.prm",
                   {guide + "Stiffness = 0",
                    guide + "Stiffnesses = 1, 1, 1",
                    guide + "Direction = 0, 1, 0",
                    "Analysis = preload",
                    "Preload/Stiffness entry = " + guide + "Stiffness",
                    "Preload/Stiffness values = 1e5, 1e6"})
              .find("Direction") == std::string::npos,
          "and the entry over which a preload tells the stiffness");
  }

  /** Of two included files the later one overrides the earlier, and a file what
   * it includes, however deep. */
  void
  deep_includes()
  {
    write_text("mid.prm",
               "include example.prm\nsubsection Scene\n  subsection Body pad\n "
               "   set Mesh file = pad.msh\n  set Outer radius = 0.3\n  end\n"
               "end\n");
    write_text("top.prm", "include mid.prm\nset Output directory = top\n");
    write_text("after.prm",
               "subsection Scene\n  subsection Body pad\n"
               "    set Mesh file = pad.msh\n  end\nend\n");
    write_text("two.prm", "include example.prm\ninclude after.prm\n");
    write_text("other.prm", "include after.prm\ninclude example.prm\n");
    for (const char *file : {"mid.prm", "top.prm", "two.prm"})
      check_refused([&]() { read_parameters(file).check(); },
                    {"'" + pad + "Mesh file"},
                    file);
    check(notes_of("top.prm", {}).find(pad + "Outer radius") !=
            std::string::npos,
          "a file in the middle is named, too");
    const Parameters other = read_parameters("other.prm");
    check(other.notes.empty() && other.scene.bodies[1].mesh_file.empty(),
          "the shape of the later of two files overrules the earlier one");
  }
} // namespace

int
main()
{
  write_example();
  refused();
  named();
  not_named();
  varied();
  deep_includes();
}
