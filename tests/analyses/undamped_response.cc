// SPDX-License-Identifier: LGPL-2.1-or-later

// Frequency response of a scene without damping. Arguments: the program.

#include <squeal/results/table.h>

#include "program.h"

#include <cmath>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  std::string program;

  Outcome
  run(const std::string &text, const std::vector<std::string> &settings = {})
  {
    return run_text(program, text, settings);
  }

  /** The peak of a mode without damping has no bound, its response beside its
   * frequency has. */
  void
  test_undamped()
  {
    const std::string mass    = R"(set Analysis = frequency response
set Output directory = out
subsection Scene
  set Bodies   = mass
  set Supports = others
  set Springs  = spring
  subsection Body mass
    set Shape = rigid
    set Mass  = 1
  end
  subsection Support others
    set Body       = mass
    set Kind       = components
    set Components = x, y, rx, ry, rz
  end
  subsection Spring spring
    set Body      = mass
    set Direction = 0, 0, 1
    set Stiffness = 3553057.584392169
  end
end
subsection Eigenvalues
  set Lowest frequency  = 100
  set Highest frequency = 500
end
subsection Measurement
  set Points = a
  subsection Point a
    set Body = mass
  end
end
subsection Frequency response
  set Number = 4
  set Checks = 4
end
)";
    const Outcome     outcome = run(mass);
    check(outcome.code == 0, "an undamped scene is solved " + outcome.errors);
    const Table table = read_csv("out/mode_participation.csv");
    check(table.n_rows() == 1 && table.is_missing(0, "peak") &&
            table.is_missing(0, "share"),
          "its mode has no peak and no share");
    const auto   values = read_csv("out/frequency_response.csv").reals("real");
    const double f[]    = {100., 700. / 3., 1100. / 3., 500.};
    check(values.size() == 4, "as many responses as frequencies");
    for (unsigned int k = 0; k < 4; ++k)
      check_close(values[k],
                  1. / (4. * M_PI * M_PI * (9e4 - f[k] * f[k])),
                  1e-9,
                  "the response of an undamped mass on a spring");
    check(unbroken(outcome.output).find("1 mode of the band has no damping") !=
            std::string::npos,
          "the run warns of it");
    check(
      text_of("out/report.html").find("their peaks have no bound: 300.00 Hz") !=
        std::string::npos,
      "and the headline names it");
    const Outcome at = run(mass, {"Frequency response/Number = 5"});
    check(at.code == 2 &&
            at.errors.find("Hz is the frequency of mode") != std::string::npos,
          "a frequency of the grid at its resonance is refused: " + at.errors);
  }
} // namespace

int
main(int argc, char **argv)
{
  check(argc == 2, "argument: the program");
  program = argv[1];
  test_undamped();
}
