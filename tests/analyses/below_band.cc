// SPDX-License-Identifier: LGPL-2.1-or-later

// What grows below the lowest frequency of the band is named: friction strong
// enough makes a mass on a belt diverge, which has no frequency. Sweeps say
// that they see the band only. What grows much faster than the band vibrates is
// found, or named where the basis does not certify it. An operating matrix
// names the condition of both and is not good. Argument: the program.

#include <squeal/results/table.h>

#include "program.h"
#include "source_directory.h"
#include "worst.h"

#include <algorithm>
#include <cmath>
#include <vector>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  std::string program;

  /** The mass of hoffmann.prm with its inclined spring the other way round: K =
   * [[2, 1 + 4 mu / 3], [1, 2]], whose smaller eigenvalue 2 - sqrt(1 + 4 mu /
   * 3) is negative beyond mu = 2.25. Up to there it neither flutters nor
   * diverges. */
  Outcome
  run(const std::string &analysis,
      const std::string &friction,
      const std::string &lowest)
  {
    write_text("mass.prm",
               "include " SQUEAL_SOURCE_DIR "/prm/minimal/hoffmann.prm\n"
               "drop Result checks\nset Analysis = " +
                 analysis +
                 "\nset Output directory = out\nset Overwrite = true\n"
                 "subsection Output\n  set Plots = false\nend\n"
                 "subsection Scene\n  subsection Spring inclined\n    set "
                 "Direction = 0, 1.5, 1\n  end\n  subsection Contact belt\n    "
                 "set Friction coefficient = " +
                 friction +
                 "\n  end\nend\nsubsection Eigenvalues\n  set Lowest frequency "
                 "= " +
                 lowest +
                 "\nend\nsubsection Sweep\n  set Axes = mu\n  subsection Axis "
                 "mu\n    set Entries = Scene/Contact belt/Friction "
                 "coefficient\n    set From = 0\n    set To = 2\n    set "
                 "Number = 3\n  end\nend\n");
    const Outcome o = run_program({program, "mass.prm"});
    check(o.code == 0, analysis + " runs: " + o.errors);
    return o;
  }

  /** The mass and a block with table.csv, from 0 Hz on. */
  Outcome
  run_with_table(const std::string &friction)
  {
    run("cea", friction, "0");
    write_text("table.prm",
               "include mass.prm\nsubsection Scene\n  set Bodies = mass, b\n"
               "  set Supports = plane, side\n  subsection Body b\n    set "
               "Shape = block\n    set Size = 0.02, 0.02, 0.02\n    set "
               "Position = 1, 1, 1\n    set Cells = 1, 1, 1\n    set Modulus "
               "table file = table.csv\n    set Modulus extrapolation = "
               "constant\n  end\n  subsection Support side\n    set Body = b\n"
               "    set Face = x_min\n  end\nend\nsubsection "
               "Discretization\n  set Estimate error = false\nend\n");
    const Outcome o = run_program({program, "table.prm"});
    check(o.code == 0, "with a table: " + o.errors);
    return o;
  }

  bool
  has(const std::string &text, const std::string &part)
  {
    return unbroken(text).find(part) != std::string::npos;
  }

  /** A block on an elastic base, whose springs press it down the more, the more
   * friction drags it. */
  const std::string wedged_block = R"(
set Analysis         = cea
set Output directory = wedge
set Overwrite        = true
subsection Scene
  set Bodies   = block, base
  set Supports = bottom
  set Springs  = inclined, hold
  set Contacts = belt
  subsection Body block
    set Size          = 0.05, 0.05, 0.05
    set Position      = 0, 0, 0
    set Cells         = 3, 3, 3
    set Young modulus = 2e9
    set Density       = 2000
  end
  subsection Body base
    set Size          = 0.1, 0.1, 0.02
    set Position      = 0, 0, -0.02
    set Cells         = 4, 4, 1
    set Young modulus = 2e11
    set Density       = 7800
  end
  subsection Support bottom
    set Body = base
    set Face = z_min
  end
  subsection Spring inclined
    set Kind      = area
    set Body      = block
    set Face      = z_max
    set Direction = 0, -1.5, 1
    set Stiffness = 1e11
  end
  subsection Spring hold
    set Kind        = area
    set Body        = block
    set Face        = z_max
    set Stiffnesses = 1e9, 1e9, 1e8
  end
  subsection Contact belt
    set Source body          = block
    set Source face          = z_min
    set Target body          = base
    set Target face          = z_max
    set Grid                 = 4, 4
    set Normal stiffness     = 1e9
    set Friction coefficient = -5
  end
end
subsection Discretization
  set Degree         = 1
  set Estimate error = false
end
subsection Eigenvalues
  set Lowest frequency    = 0
  set Compare with direct = true
end
subsection Output
  set Plots  = false
  set Shapes = none
end
)";

  std::string
  wedged(const std::string &highest, const std::string &rounds)
  {
    write_text("wedge.prm",
               wedged_block +
                 "subsection Eigenvalues\n set Highest frequency = " + highest +
                 "\n set Maximum enrichments = " + rounds + "\nend\n");
    const Outcome o = run_program({program, "wedge.prm"});
    check(o.code == 0, "the wedged block runs: " + o.errors);
    return unbroken(o.output);
  }

  /** The growth rates of the table, from the largest on. */
  std::vector<double>
  growth_rates()
  {
    const Table         table = read_csv("wedge/eigenvalues.csv");
    std::vector<double> result;
    for (std::size_t r = 0; r < table.n_rows(); ++r)
      if (table.real(r, "sigma_per_s") > 1.)
        result.push_back(table.real(r, "sigma_per_s"));
    std::sort(result.rbegin(), result.rend());
    return result;
  }

  /** Divergence at rates of up to 20 times the band, which the same scene with
   * a band that holds them has, too. */
  void
  fast_growth()
  {
    wedged("20000", "30");
    const std::vector<double> slow = growth_rates();
    wedged("1000", "30");
    const std::vector<double> fast = growth_rates();
    check(fast.size() == 4 && slow.size() >= fast.size(),
          "four motions diverge: " + std::to_string(fast.size()));
    for (const double rate : fast)
      {
        double off = 1.;
        for (const double other : slow)
          if (std::abs(rate / other - 1.) < off)
            off = std::abs(rate / other - 1.);
        check(off < 1e-6, "as in a band that holds them");
      }
    check(fast.front() > 1e5, "at 20 times the band");
    const Table checks = read_csv("wedge/direct_check.csv");
    Worst       difference;
    for (std::size_t r = 0; r < checks.n_rows(); ++r)
      if (!checks.is_missing(r, "difference_rel"))
        difference.add(checks.real(r, "difference_rel"));
    check_within(difference, 1e-4, "the direct solver compares what it finds");

    const std::string named = "faster than the band vibrates";
    check(has(wedged("1000", "4"), named),
          "where few rounds certify no such growth it is named");
    check(growth_rates().size() == 1, "and is not in the table");
    check(has(text_of("wedge/report.html"), named), "the report names it, too");
  }

  /** A verdict of many conditions counts what grows beside the pairs, and names
   * the first condition where something does. */
  void
  growth_of_conditions()
  {
    const auto matrix_of = [](const std::string &prm, const bool is_in_both) {
      write_text("matrix.prm",
                 "include " + prm +
                   "\nset Analysis = operating matrix\nset Output directory = "
                   "matrix\nsubsection Eigenvalues\n set Compare with direct = "
                   "false\nend\nsubsection Operating matrix\n set Both "
                   "directions = true\nend\n");
      const Outcome o = run_program({program, "matrix.prm"});
      check(o.code == 0, "the operating matrix runs: " + o.errors);
      const std::string report = text_of("matrix/report.html");
      check(has(report, "verdict bad") &&
              has(report,
                  std::string("under ") + (is_in_both ? "2" : "1") +
                    " of 2 conditions something grows that is not in the "
                    "tables (forward: "),
            "growth beside the pairs is in the verdict");
      check(has(o.output, "warning: forward: ") &&
              has(o.output, "warning: backward: ") == is_in_both,
            "and warnings name their conditions");
      return unbroken(report);
    };
    run("cea", "3", "0.1");
    check(
      has(matrix_of("mass.prm", false), "(forward: divergence: a motion grows"),
      "a mass that diverges below the band forwards alone");
    wedged("1000", "4");
    check(
      has(matrix_of("wedge.prm", true), "faster than the band vibrates"),
      "a block that wedges in both directions, stable backwards by its table");
  }
} // namespace

int
main(int argc, char **argv)
{
  check(argc == 2, "one argument");
  program = argv[1];
  // sqrt(sqrt(5) - 2) = 0.48587
  const std::string divergence =
    "divergence: a motion grows without vibration, by about 0.486 1/s";
  check(has(run("cea", "3", "0.1").output, divergence),
        "the first screen names divergence below the band");
  check(has(text_of("out/run.json"), divergence), "and so does run.json");
  check(has(text_of("out/report.html"), divergence), "and the report");
  check(read_csv("out/eigenvalues.csv").n_rows() == 1,
        "the band itself has one pair, which does not grow");

  check(has(run("cea", "2", "0.1").output, "nothing grows below 0.1"),
        "where none diverges the first screen says so");

  check(!has(run("cea", "3", "0").output, "below the band"),
        "a band from 0 has nothing below it");
  const Table table = read_csv("out/eigenvalues.csv");
  Worst       sigma;
  for (std::size_t r = 0; r < table.n_rows(); ++r)
    if (table.real(r, "frequency_hz") == 0.)
      sigma.add(table.real(r, "sigma_per_s"));
  check_close(sigma.largest(),
              std::sqrt(std::sqrt(5.) - 2.),
              1e-9,
              "and has it as a row");

  // A block whose modulus follows the frequency leaves the mass as it is; what
  // is below a thousandth of the highest frequency is looked at, not sought.
  write_text("table.csv",
             "frequency_Hz,temperature_C,storage_modulus_Pa,loss_factor\n"
             "1,20,1e9,0.1\n100,20,3e9,0.5\n30000,20,8e9,0.1\n");
  check(has(run_with_table("3").output, divergence),
        "beside a modulus over frequency divergence is named");
  check(has(run_with_table("3").output, "pairs from 0.0005"),
        "completeness says from where on");
  check(has(run_with_table("1.5").output, "nothing grows below 0.0005"),
        "and that nothing diverges");

  const std::string unseen = "not looked at: what grows below 0.1";
  check(has(run("sweep", "1", "0.1").output, unseen),
        "a sweep says that it sees the band only");
  check(has(text_of("out/run.json"), unseen), "in run.json, too");
  fast_growth();
  growth_of_conditions();
}
