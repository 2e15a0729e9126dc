// SPDX-License-Identifier: LGPL-2.1-or-later

// A plate that rocks on a ring of springs, by what its transients are judged:
// their period is that of the moments, whose half the sum of the normal forces
// has; the force of speeds.csv is one for all speeds; waves that cancel in sums
// and moments are in the charts of a campaign. Argument: the program.

#include "plate_on_ring.h"

#include <squeal/results/table.h>

#include <cmath>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  const std::string slow = "Scene/Contact face/Sliding speed = 0.05";

  /** As the limit cycle, whose period is that of all forces. */
  void
  period(const std::string &program)
  {
    write_ring(24, "", 1, .02);
    run_ring(
      program,
      {"Analysis = transient", slow, "Output directory = rocking/transient"});
    run_ring(
      program,
      {"Analysis = limit cycle", slow, "Output directory = rocking/cycle"});
    const Table t = read_csv("rocking/transient/transient.csv"),
                c = read_csv("rocking/cycle/limit_cycle.csv");
    check(!t.has_column("judged_force"), "the sum is judged");
    const double f = t.real(0, "limit_cycle_frequency_hz");
    check(std::abs(f - c.real(0, "frequency_hz")) <=
            c.real(0, "frequency_error_hz") +
              t.real(0, "limit_cycle_frequency_ci_hz"),
          "the period is that of the limit cycle: " + std::to_string(f) + ", " +
            std::to_string(c.real(0, "frequency_hz")) + " Hz");
    for (const std::string number : {"mean_normal", "rms_normal"})
      {
        const double error = t.real(0, number + "_error_n");
        check(std::abs(t.real(0, number + "_n") - c.real(0, number + "_n")) <=
                  error + c.real(0, number + "_error_n") &&
                error < .01 * t.real(0, "mean_normal_n"),
              number +
                " of a run that ends within a period is that of the "
                "limit cycle within its error, " +
                std::to_string(error) + " N");
      }
    check_close(t.real(0, "largest_line_hz"),
                2. * f,
                1e-3,
                "the sum has twice its frequency");
  }

  void
  speeds(const std::string &program)
  {
    write_ring(24, "", 1, .014);
    run_ring(program,
             {"Analysis = transient",
              slow,
              "Output directory = rocking/speeds",
              "Transient/End time = 0.4",
              "Transient/Final speed ratio = 0.3"});
    const Table t = read_csv("rocking/speeds/speeds.csv");
    check(t.n_rows() == 50, "fifty speeds");
    for (std::size_t i = 26; i < t.n_rows(); ++i)
      {
        check(t.text(i, "judged_force") == t.text(0, "judged_force"),
              "one force for all speeds");
        const double ratio =
          t.real(i, "rms_normal_n") / t.real(i - 1, "rms_normal_n");
        check(ratio > .5 && ratio < 2.,
              "no jump from speed to speed: " + std::to_string(ratio));
      }
  }

  const std::string frictions = R"(subsection Sweep
  set Axes = mu
  subsection Axis mu
    set Entries = Scene/Contact face/Friction coefficient
    set Scale   = list
    set Values  = 0.36, 0.38, 0.42
  end
end
)";

  void
  nodes_of_a_campaign(const std::string &program)
  {
    write_ring(48, frictions, 2);
    run_ring(program,
             {"Analysis = transient",
              slow,
              "Output directory = rocking/campaign",
              "Transient/End time = 0.1",
              "Transient/History start = 0.1",
              "Transient/Campaign table = campaign.csv",
              "Transient/Threads = 1",
              "Output/Plots = true"});
    const Table t = read_csv("rocking/campaign/campaign.csv");
    for (std::size_t i = 0; i < t.n_rows(); ++i)
      {
        check(t.text(i, "judged_force").find("node") != std::string::npos,
              "judged by a node: " + t.text(i, "judged_force"));
        check_close(t.real(i, "judged_share"), 1. / 48., 1e-3, "of 48");
        check(t.text(i, "limit_cycle") == "yes", "in a limit cycle");
      }
    check(std::filesystem::exists(
            "rocking/campaign/plots/amplitude_over_sigma.png"),
          "whose amplitude is drawn over the growth rate");
  }
} // namespace

int
main(int argc, char *argv[])
{
  check(argc > 1, "argument: the program");
  std::filesystem::remove_all("rocking");
  period(argv[1]);
  speeds(argv[1]);
  nodes_of_a_campaign(argv[1]);
}
