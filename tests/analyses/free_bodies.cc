// SPDX-License-Identifier: LGPL-2.1-or-later

// Bodies and mechanisms that nothing holds are said by name: a warning with
// the modes, and a refusal of complex eigenvalues where lambda = 0 is
// defective. Argument: the program.

#include "program.h"

using namespace squeal::testing;
namespace fs = std::filesystem;

namespace
{
  std::string program;

  Outcome
  run(const std::string &text, const std::vector<std::string> &settings)
  {
    write_text("free.prm", text);
    std::vector<std::string> words = {program, "--set", "Overwrite = true"};
    for (const std::string &setting : settings)
      words.insert(words.end(), {"--set", setting});
    words.push_back("free.prm");
    return run_program(words);
  }

  bool
  says(const std::string &text, const std::string &part)
  {
    return unbroken(text).find(part) != std::string::npos;
  }

  /** A pad held by nothing, a disc held at its inner edge. */
  std::string
  free_pad()
  {
    std::string text = replaced_in(small_brake, "edge, top\n", "edge\n");
    const auto  from = text.find("  subsection Support top");
    const auto  to   = text.find("  subsection Contact");
    return text.erase(from, to - from);
  }

  /** Two masses on a guide, a spring between them: they drift together. A
   * third is held along x only. */
  const std::string mechanism = R"(set Analysis         = modes
set Output directory = out
subsection Scene
  set Bodies   = left, right, fixed
  set Supports = guide_left, guide_right, upright
  set Springs  = link, hold
  subsection Body left
    set Shape = rigid
  end
  subsection Body right
    set Shape = rigid
  end
  subsection Body fixed
    set Shape = rigid
  end
  subsection Support guide_left
    set Body       = left
    set Kind       = components
    set Components = y, z, rx, ry, rz
  end
  subsection Support guide_right
    set Body       = right
    set Kind       = components
    set Components = y, z, rx, ry, rz
  end
  subsection Support upright
    set Body       = fixed
    set Kind       = components
    set Components = rx, ry, rz
  end
  subsection Spring link
    set Body       = left
    set Other body = right
    set Direction  = 1, 0, 0
    set Stiffness  = 100
  end
  subsection Spring hold
    set Body      = fixed
    set Direction = 1, 0, 0
    set Stiffness = 100
  end
end
subsection Eigenvalues
  set Highest frequency = 20
end
)";
} // namespace



int
main(int argc, char **argv)
{
  check(argc == 2, "argument: the program");
  program = argv[1];
  fs::remove_all("out");

  // Normal springs hold z, rx and ry of the pad: x, y and rz are free.
  Outcome o = run(free_pad(), {"Analysis = modes"});
  check(o.code == 0 &&
          says(o.output,
               "3 motions at 0 Hz are held by nothing, of the bodies pad:"),
        "modes: the pad is named");
  o = run(free_pad(), {});
  check(o.code == 2 && says(o.errors, "of the bodies pad") &&
          says(o.errors, "Eigenvalues/Lowest frequency"),
        "complex eigenvalues from 0 Hz are refused: " + o.errors);
  o = run(free_pad() + "subsection Sweep\n  set Axes = rho\n  subsection Axis "
                       "rho\n    set Entries = Scene/Body disc/Density\n    "
                       "set Scale = list\n    set Values = 4000, 8000\n  end\n"
                       "end\n",
          {"Analysis = sweep"});
  check(o.code == 2 && says(o.errors, "3 motions at 0 Hz are held by nothing"),
        "and so is a sweep from 0 Hz: " + o.errors);
  o = run(free_pad(), {"Eigenvalues/Lowest frequency = 100"});
  check(o.code == 0 && says(o.output, "of the bodies pad"),
        "from 100 Hz on they are computed");
  o = run(small_brake, {});
  check(o.code == 0 && !says(o.output, "held by nothing"),
        "nothing is said of bodies that are held");

  o = run(mechanism, {});
  check(o.code == 0 &&
          says(o.output,
               "3 motions at 0 Hz are held by nothing, of the bodies "
               "left, right, fixed"),
        "a mechanism and two motions of a lone mass");
  const std::string held = replaced_in(
    mechanism, "Components = rx, ry, rz", "Components = y, z, rx, ry, rz");
  o = run(held, {});
  check(o.code == 0 && says(o.output,
                            "1 motion at 0 Hz is held by nothing, of the "
                            "bodies left, right:"),
        "the mechanism alone");
}
