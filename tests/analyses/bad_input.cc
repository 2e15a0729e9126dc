// SPDX-License-Identifier: LGPL-2.1-or-later

// What a user can get wrong, tried on the program itself: every mistake ends
// in exactly one line on stderr that names what to change, a non-zero exit code
// and no result file. Arguments: the program, the shipped parameter files.

#include "../scene/gmsh_cube.h"
#include "program.h"

#include <squeal/base/exceptions.h>
#include <squeal/parameters/parameters.h>

using namespace squeal::testing;
namespace fs = std::filesystem;

namespace
{
  std::string program, shipped;

  bool
  has(const std::string &text, const std::string &part)
  {
    return text.find(part) != std::string::npos;
  }

  /** What a failed run may leave in the output directory. */
  bool
  holds_no_results(const std::string &directory)
  {
    for (const auto &[name, text] : files_below(directory))
      if (name != "run.log" && name != ".squeal_files")
        return false;
    return true;
  }

  void
  check_outcome(const Outcome                  &outcome,
                const int                       code,
                const std::vector<std::string> &parts,
                const std::string              &claim)
  {
    const std::string &e = outcome.errors;
    check(outcome.code == code,
          claim + ": exit code " + std::to_string(outcome.code) +
            ", expected " + std::to_string(code) + " (" + e + ")");
    check(e.substr(0, 8) == "squeal: " && e.find('\n') == e.size() - 1,
          claim + ": one line: " + e);
    for (const std::string &part : parts)
      check(has(e, part), claim + ": the line says '" + part + "': " + e);
  }

  /** Runs a file with this text and checks how it is refused. */
  void
  refuses(const std::string              &text,
          const std::vector<std::string> &parts,
          const std::string              &claim)
  {
    write_text("bad.prm", replaced(text, "= out\n", "= refused\n"));
    check_outcome(run_program({program, "bad.prm"}), 2, parts, claim);
    check(holds_no_results("refused"), claim + ": no results");
  }

  /** small_brake with one piece of its text changed. */
  void
  refuses_change(const std::string              &old,
                 const std::string              &by,
                 const std::vector<std::string> &parts,
                 const std::string              &claim)
  {
    refuses(replaced(small_brake, old, by), parts, claim);
  }

  /** The same where the text alone is wrong: that is found by what the program
   * begins with, before there is anything to leave, and what is called here,
   * without the start of a program. */
  void
  refuses_text(const std::string              &old,
               const std::string              &by,
               const std::vector<std::string> &parts,
               const std::string              &claim)
  {
    write_text("bad.prm", replaced(small_brake, old, by));
    Outcome outcome{0, "", ""};
    try
      {
        squeal::read_parameters("bad.prm").check();
      }
    catch (const squeal::InputError &e)
      {
        outcome = {2, "", std::string("squeal: ") + e.what() + "\n"};
      }
    check_outcome(outcome, 2, parts, claim);
  }



  void
  entries()
  {
    refuses_change("Young modulus = 2e10",
                   "Young modulos = 2e10",
                   {"bad.prm:19:", "Young modulos'", "Young modulus"},
                   "a misspelt entry, by line and nearest name");
    refuses_text("subsection Body pad",
                 "subsection Body pda",
                 {"bad.prm:6:", "no section 'Scene/Body pad'"},
                 "a misspelt section");
    refuses_text("= 2e10",
                 "= steel",
                 {"bad.prm:19:", "Young modulus", "'steel'"},
                 "a wrong type");
    refuses_text("= 2e10",
                 "= nan",
                 {"bad.prm:19:", "Young modulus"},
                 "a number that is none");
    refuses_text("= 0.3\n  end\n  subsection Support inner",
                 "= 0.5\n  end\n  subsection Support inner",
                 {"bad.prm:21:", "Poisson ratio", "0.4999"},
                 "an incompressible material");
    for (const char *density : {"0", "-2500"})
      refuses_text(std::string("= 2500"),
                   std::string("= ") + density,
                   {"bad.prm:20:", "Density", "greater than 0"},
                   std::string("density ") + density);
    refuses_text("Degree = 1",
                 "Degree = 99",
                 {"bad.prm:43:", "Degree", "from 1 to 8"},
                 "out of range");
    refuses_text("Analysis         = cea",
                 "Analysis         = scea",
                 {"bad.prm:1:", "Analysis", "cea"},
                 "an unknown analysis");
    refuses_text("  set Supports = inner_edge, top\n",
                 "  set Supports = inner_edge, top\n  set Supports = top\n",
                 {"bad.prm:", "Supports"},
                 "an entry given twice");
    refuses_text("= pad_disc",
                 "= pad_disc, other",
                 {"bad.prm:", "other"},
                 "a contact without its section");
    refuses_text("Source body          = pad",
                 "Source body          = pat",
                 {"pad_disc/Source body", "'pat'", "pad"},
                 "an unknown body");
    refuses_text("= inner\n",
                 "= inside\n",
                 {"inner_edge/Face", "inside", "inner"},
                 "an unknown face");
    refuses_text("Highest frequency = 6000",
                 "Highest frequency = 6000\n  set Lowest frequency = 7000",
                 {"Lowest frequency", "Highest frequency"},
                 "a band upside down");
  }



  void
  files()
  {
    const auto refuses_file = [](const std::string              &file,
                                 const std::vector<std::string> &parts,
                                 const std::string              &claim) {
      check_outcome(run_program({program, file}), 2, parts, claim);
    };
    refuses_file("nowhere.prm", {"nowhere.prm", "no such file"}, "no file");
    fs::create_directory("folder.prm");
    refuses_file("folder.prm", {"folder.prm", "irectory"}, "a directory");
    write_text("empty.prm", "");
    refuses_file("empty.prm", {"empty.prm"}, "an empty file");
    check(!fs::exists("output"), "an empty file starts nothing");
    std::string garbage;
    for (unsigned int i = 0, x = 1; i < 5000; ++i)
      garbage += static_cast<char>((x = x * 1664525u + 1013904223u) >> 24);
    write_text("garbage.prm", garbage);
    refuses_file("garbage.prm", {"garbage.prm"}, "binary garbage");
    check_outcome(run_program({program}), 2, {"--help"}, "no file named");
    check_outcome(run_program({program, "--sett", "x"}),
                  2,
                  {"--sett", "--help"},
                  "an unknown option");
    write_text("loop.prm", "include loop.prm\n");
    refuses_file("loop.prm", {"loop.prm"}, "a file that includes itself");
  }



  /** Pad and support as the two volumes of a Gmsh file. */
  std::string
  gmsh_scene(const std::string &volume)
  {
    return "set Output directory = out\nset Analysis = modes\n"
           "subsection Scene\n  set Bodies = pad\n  subsection Body pad\n"
           "    set Shape = gmsh\n    set Mesh file = mesh.msh\n"
           "    set Physical volume = " +
           volume +
           "\n  end\nend\nsubsection Output\n  set Plots = false\n  set "
           "Report = false\nend\n";
  }

  void
  meshes()
  {
    const Cube        cube;
    const std::string good         = version_2(cube);
    const std::string last         = "21 5 2 12 1" + spaced(cube.cells[7]);
    const auto        refuses_mesh = [](const std::string              &text,
                                 const std::vector<std::string> &parts,
                                 const std::string              &claim,
                                 const std::string &volume = "upper") {
      write_text("mesh.msh", text);
      refuses(gmsh_scene(volume), parts, claim);
    };
    refuses_mesh(replaced(good, last, "21 4 2 12 1 14 15 18 17"),
                 {"mesh.msh", "tetrahedra (1)"},
                 "a mesh with tetrahedra");
    Cube bad = cube;
    std::swap_ranges(
      bad.cells[6].begin(), bad.cells[6].begin() + 4, bad.cells[6].begin() + 4);
    refuses_mesh(
      version_2(bad), {"mesh.msh", "inverted"}, "a mesh with an inverted cell");
    refuses_mesh(good,
                 {"mesh.msh", "'pad'", "lower, upper"},
                 "a physical name that does not exist",
                 "pad");
    refuses_mesh(good.substr(0, good.size() / 2),
                 {"mesh.msh", "truncated"},
                 "a truncated mesh");
    fs::remove("mesh.msh");
    refuses(gmsh_scene("upper"), {"mesh.msh", "no such file"}, "no mesh file");

    // A face that the mesh does not have is found only when it is read.
    write_text("mesh.msh", good);
    refuses(replaced(gmsh_scene("upper"),
                     "set Bodies = pad\n",
                     "set Bodies = pad\n  set Supports = s\n  subsection "
                     "Support s\n    set Body = pad\n    set Face = top\n  "
                     "end\n"),
            {"face 'top'", "right side"},
            "a physical surface that does not exist");
  }



  void
  geometry()
  {
    refuses_change("= 0.1, 0, 0\n",
                   "= 0.1, 0, 0.0001\n",
                   {"pad_disc", "do not meet", "Position"},
                   "contact faces with a gap between them");
    refuses_change("= 0.1, 0, 0\n",
                   "= 0.117, 0, 0\n",
                   {"pad_disc", "0.12", "Position"},
                   "a pad that leaves the disc");
    refuses_change("= 0.1, 0, 0\n",
                   "= 0.3, 0, 0\n",
                   {"pad_disc", "do not meet", "Position"},
                   "a pad beside the disc");
    refuses_change("Highest frequency = 6000",
                   "Highest frequency = 6000\n  set Lowest frequency = 5990",
                   {"from 5990", "no modes", "5944.42 Hz"},
                   "a band without modes, by the next one");
    refuses_change("Highest frequency = 6000",
                   "Highest frequency = 1e-3",
                   {"no modes"},
                   "a band far below the first mode");
    refuses(replaced(replaced(small_brake, "= cea", "= modes"),
                     "Highest frequency = 6000",
                     "Highest frequency = 1000"),
            {"no modes", "raise Highest frequency"},
            "modes of a band without modes");
  }



  /** The imported ring with one of its files replaced. */
  void
  refuses_import(const std::string              &entry,
                 const std::string              &file,
                 const std::string              &text,
                 const std::vector<std::string> &parts,
                 const std::string              &claim)
  {
    const std::string original =
      text_of(shipped + "/matrices/ring_pad/" + file);
    check(!original.empty(), "read " + file);
    const std::string name = fs::path(file).filename().string();
    write_text(name,
               text == "half" ? original.substr(0, original.size() / 2) : text);
    check_outcome(run_program({program,
                               "--set",
                               entry + " = " + fs::absolute(name).string(),
                               "--set",
                               "Output directory = refused",
                               "--set",
                               "Output/Plots = false",
                               shipped + "/matrices/ring_pad.prm"}),
                  2,
                  parts,
                  claim);
    check(holds_no_results("refused"), claim + ": no results");
  }

  void
  imports()
  {
    const std::string part = "Scene/Matrix part ring/File";
    refuses_import(
      part, "market/ring.mtx", "half", {"ring.mtx"}, "a truncated matrix");
    refuses_import(part, "market/ring.mtx", "", {"ring.mtx", "empty"}, "empty");
    refuses_import(part,
                   "market/ring.mtx",
                   "%%MatrixMarket matrix coordinate real general\n"
                   "2 2 1\n1 1 nan\n",
                   {"ring.mtx:3"},
                   "a matrix with NaN, by line");
    std::string contact = text_of(shipped + "/matrices/ring_pad/contact.csv");
    const auto  comma   = contact.rfind(',');
    refuses_import("Scene/Contact pattern file",
                   "contact.csv",
                   contact.substr(0, comma + 1) + "nan\n",
                   {"contact.csv:"},
                   "a CSV file with NaN, by line");
    refuses_import("Scene/Contact pattern file",
                   "contact.csv",
                   contact.substr(0, contact.find('\n') + 1) + "1,2\n",
                   {"contact.csv:2"},
                   "a CSV file with too few columns");
  }
} // namespace



int
main(int argc, char **argv)
{
  check(argc == 3, "arguments: program, shipped parameter files");
  program = argv[1];
  shipped = argv[2];
  for (const char *folder : {"folder.prm", "refused", "output"})
    fs::remove_all(folder);
  write_text("good.prm", small_brake);
  fs::remove_all("out");
  check(run_program({program, "good.prm"}).code == 0,
        "the scene that is spoilt below runs");
  entries();
  files();
  meshes();
  geometry();
  imports();
}
