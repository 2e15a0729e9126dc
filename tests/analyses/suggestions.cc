// SPDX-License-Identifier: LGPL-2.1-or-later

// Changes that stop a flutter of two degrees of freedom: what leaves the band
// goes on squealing, what diverges outside the band does not squeal in it, and
// what is undamped does not squeal by rounding.
// Argument: the program.

#include <squeal/results/table.h>

#include "program.h"
#include "source_directory.h"

#include <string>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  /** suggestions.csv of prm/minimal/hoffmann.prm, which flutters beyond
   * mu = 0.75 at 0.2251 Hz, with @p text. */
  Table
  suggestions(const std::string &program,
              const std::string &text,
              const std::string &name)
  {
    write_text(name + ".prm",
               "include " SQUEAL_SOURCE_DIR "/prm/minimal/hoffmann.prm\n"
               "drop Result checks\n"
               "set Analysis = sweep\nset Output directory = " +
                 name +
                 "\nset Overwrite = true\n"
                 "subsection Output\n  set Plots = false\n"
                 "  set Report = false\nend\n" +
                 text);
    const Outcome o = run_program({program, name + ".prm"});
    check(o.code == 0, name + " ends: " + o.errors);
    return read_csv(name + "/suggestions.csv");
  }

  std::string
  sweep(const std::string &sensitivities)
  {
    return "subsection Sweep\n  set Axes = mu\n  set Suggestions = 1\n"
           "  set Sensitivities = " +
           sensitivities +
           "\n  subsection Axis mu\n"
           "    set Entries = Scene/Contact belt/Friction coefficient\n"
           "    set From = 0.8\n    set To = 1\n    set Number = 3\n  end\n"
           "end\n";
  }

  std::string
  band(const std::string &lowest, const std::string &highest)
  {
    return "subsection Eigenvalues\n  set Lowest frequency = " + lowest +
           "\n  set Highest frequency = " + highest + "\nend\n";
  }

  const std::string damped = R"(subsection Scene
  subsection Spring horizontal
    set Dashpot = 0.01
  end
  subsection Spring inclined
    set Dashpot = 0.01
  end
end
)";

  /** With a times the inclined spring, mu = 1 and hardly any damping it
   * flutters where 25/144 (a - 1)^2 + a^2 < 4/3 a, which is up to a = 1.3199.
   * Below it the mean of both omega^2 is (11 + 13 a) / 12: with a = 0.76 the
   * flutter is below 0.21 Hz. */
  void
  out_of_the_band(const std::string &program)
  {
    const Table table = suggestions(program,
                                    damped + band("0.21", "0.26") +
                                      sweep("Scene/Spring inclined/Stiffness"),
                                    "leaves");
    check(table.n_rows() == 1, "one number may be changed");
    check_close(table.real(0, "change_percent"),
                110. * 0.3199,
                1.5,
                "the flutter ends in the band, not by leaving it");
    check(table.text(0, "verdict") == "stable",
          "by the direct solution: " + table.text(0, "verdict"));
    check(table.real(0, "largest_sigma_per_s") < 0., "as by the basis");
  }

  /** Without damping all stable pairs have a sigma of rounding, of either
   * sign. */
  void
  without_damping(const std::string &program)
  {
    const Table table = suggestions(
      program,
      band("0.1", "0.5") + sweep("Scene/Contact belt/Friction coefficient"),
      "undamped");
    // From mu = 1 to 3/4, and a tenth more of the change.
    check_close(
      table.real(0, "change_percent"), -27.5, 0.1, "the flutter ends");
    check(table.text(0, "verdict") == "stable",
          "by the direct solution, too: " + table.text(0, "verdict"));
  }

  /** A second mass with the opposite friction, mu = -3, and the stiffness
   * [[2, 5], [1, 2]] of determinant -1 diverges at sqrt(sqrt(5) - 2) 1/s, less
   * what the dashpots take. */
  void
  beside_the_band(const std::string &program)
  {
    const Table table = suggestions(program,
                                    damped + R"(subsection Scene
  set Bodies   = mass, other
  set Supports = plane, other_plane
  set Springs  = horizontal, inclined, other_horizontal, other_inclined
  set Contacts = belt, other_belt
  subsection Body other
    set Shape = rigid
    set Mass  = 1
  end
  subsection Support other_plane
    set Body       = other
    set Kind       = components
    set Components = x, rx, ry, rz
  end
  subsection Spring other_horizontal
    set Body      = other
    set Direction = 0, 1, 0
    set Stiffness = 0.5
    set Dashpot   = 0.01
  end
  subsection Spring other_inclined
    set Body      = other
    set Direction = 0, -1.5, 1
    set Stiffness = 2.166666666666667
    set Dashpot   = 0.01
  end
  subsection Contact other_belt
    set Source body          = other
    set Target body          = ground
    set Grid                 = 1, 1
    set Normal stiffness     = 1.333333333333333
    set Friction coefficient = -3
  end
end
)" + band("0.1", "0.5") +
                                      sweep("Scene/Contact belt/Friction "
                                            "coefficient"),
                                    "divergence");
    check(table.n_rows() == 1 && !table.is_missing(0, "change_percent"),
          "less friction is found");
    const std::string verdict = table.text(0, "verdict");
    check(verdict.rfind("stable", 0) == 0, "and stops the flutter: " + verdict);
    check(verdict.find("outside the band 0 Hz grows") != std::string::npos,
          "what diverges below the band is told: " + verdict);
    check(table.real(0, "direct_sigma_per_s") < 0. &&
            table.real(0, "direct_frequency_hz") > 0.1,
          "the direct solution is judged in the band");
  }
} // namespace

int
main(int argc, char **argv)
{
  check(argc == 2, "one argument");
  out_of_the_band(argv[1]);
  beside_the_band(argv[1]);
  without_damping(argv[1]);
}
