// SPDX-License-Identifier: LGPL-2.1-or-later

// Scenes with lengths in mm or moduli in MPa are warned of by every analysis
// and by --validate, and pads that their loads press by more than small
// displacements hold. Argument: the program.

#include "program.h"

using namespace squeal;
using namespace squeal::testing;

namespace
{
  std::string program;

  /** The small brake with a pad of @p modulus, Pa, under 1 MPa. */
  std::string
  pressed_brake(const std::string &analysis, const std::string &modulus)
  {
    std::string text = replaced_in(small_brake, "= cea", "= " + analysis);
    text             = replaced_in(text, "= 2e10", "= " + modulus);
    text             = replaced_in(
      text, "  set Contacts = pad_disc\n", R"(  set Contacts = pad_disc
  set Loads    = press
  subsection Load press
    set Body     = pad
    set Face     = z_max
    set Pressure = 1e6
  end
)");
    return replaced_in(text,
                       "    set Grid                 = 2, 2\n",
                       "    set Formulation   = mortar\n"
                       "    set Contact state = preload\n");
  }

  bool
  has(const Outcome &run, const std::string &part)
  {
    return unbroken(run.output).find(part) != std::string::npos;
  }

  void
  check_run(const std::string &text,
            const std::string &part,
            const bool         is_expected,
            const std::string &what)
  {
    const Outcome run = run_text(program, text);
    check(run.code == 0, what + " runs: " + run.errors);
    check(has(run, part) == is_expected,
          what + (is_expected ? " warns of '" : " has no '") + part + "'");
  }
} // namespace

int
main(int argc, char *argv[])
{
  check(argc == 2, "one argument: the program");
  program                  = argv[1];
  const std::string strain = "small displacements, which all results rest on",
                    unit   = "softer than any solid of a brake",
                    size   = "m long, which no brake is";
  for (const std::string analysis : {"preload", "cea"})
    {
      check_run(pressed_brake(analysis, "2e10"), strain, false, analysis);
      check_run(pressed_brake(analysis, "2e10"), unit, false, analysis);
      check_run(pressed_brake(analysis, "8000"), unit, true, analysis);
      check_run(pressed_brake(analysis, "5e6"),
                "its mean pressure, 1.00e+06 Pa, is 0.20 times the Young "
                "modulus of pad: " +
                  strain,
                true,
                analysis);
    }
  const auto as_long_as = [](const std::string &height) {
    return replaced_in(replaced_in(replaced_in(small_brake, "= cea", "= modes"),
                                   "0.01, 0.01, 0.01",
                                   "0.01, 0.01, " + height),
                       "= 2e10",
                       "= 8000");
  };
  check_run(as_long_as("9"), size, false, "modes of a scene of 9 m");
  check_run(as_long_as("12"), size, true, "modes of a scene of 12 m");
  const Outcome validated = run_program({program, "--validate", "run.prm"});
  check(validated.code == 0 && has(validated, size) && has(validated, unit),
        "--validate says so before a run");
}
