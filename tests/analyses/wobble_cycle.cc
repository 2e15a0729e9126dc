// SPDX-License-Identifier: LGPL-2.1-or-later

// A plate on a ring of springs whose friction lets it wobble: the normal forces
// cancel in their sum but for a ripple of as many lines a period as there are
// springs, which says nothing of the motion. Cycles, branches, campaigns and
// motions from other starts are judged by the moment, whatever the number of
// springs, and as transients are. Argument: the program.

#include "plate_on_ring.h"

#include <squeal/results/table.h>

#include <cmath>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  const std::string frictions = R"(subsection Sweep
  set Axes = mu
  subsection Axis mu
    set Entries = Scene/Contact face/Friction coefficient
    set Scale   = list
    set Values  = 0.02, 0.4
  end
end
)",
                    speeds    = R"(subsection Sweep
  set Axes = v
  subsection Axis v
    set Entries = Scene/Contact face/Sliding speed
    set From    = 4
    set To      = 6
    set Number  = 1
  end
end
)";

  /** The moment that row @p row names. */
  std::string
  judged(const Table &t, const std::size_t row)
  {
    return t.text(row, "judged_force");
  }

  const std::string moment = "moment of the normal forces about ";

  bool
  is_moment(const std::string &name)
  {
    return name == moment + "x" || name == moment + "y";
  }

  void
  says(const std::string &output, const std::string &text)
  {
    check(output.find(text) != std::string::npos, "says: " + text);
  }

  /** Of both numbers of springs the same motion, within the errors stated. */
  void
  same_motion(const Table &a, const Table &b, const std::string &claim)
  {
    const std::size_t i = a.n_rows() - 1;
    check(is_moment(judged(a, i)) && is_moment(judged(b, 0)),
          claim + "judged by a moment: " + judged(a, i) + ", " + judged(b, 0));
    for (const auto &[number, error] :
         {std::make_pair("frequency_hz", "frequency_error_hz"),
          std::make_pair("rms_normal_n", "rms_normal_error_n")})
      check(std::abs(a.real(i, number) - b.real(0, number)) <=
              a.real(i, error) + b.real(0, error),
            claim + number + ": " + std::to_string(a.real(i, number)) + ", " +
              std::to_string(b.real(0, number)));
    check(b.real(0, "rms_normal_error_n") < .01 * b.real(0, "rms_normal_n"),
          claim + "the error of the rms");
    check_close(a.real(i, "dominant_line_hz"),
                b.real(0, "dominant_line_hz"),
                1e-3,
                claim + "the line");
    check_close(b.real(0, "dominant_line_hz"),
                b.real(0, "frequency_hz"),
                1e-9,
                claim + "which goes round once a period");
  }

  void
  branches(const Table &cycle)
  {
    const Table t = read_csv("branch/branch.csv");
    check(t.n_rows() > 1, "a branch has points");
    for (std::size_t i = 0; i < t.n_rows(); ++i)
      {
        check(is_moment(judged(t, i)), "along a branch: " + judged(t, i));
        check_close(t.real(i, "dominant_line_hz"),
                    cycle.real(0, "dominant_line_hz"),
                    .1,
                    "along a branch the line is that of the wobble");
      }
  }

  void
  starts(const Table &campaign)
  {
    const Table t = read_csv("cycles/starts.csv");
    check(t.n_rows() == 2, "one other start, and one from the cycle");
    for (std::size_t i = 0; i < t.n_rows(); ++i)
      {
        check_close(t.real(i, "cycle_frequency_hz"),
                    campaign.real(1, "frequency_hz"),
                    1e-9,
                    "the ripple makes no shorter period");
        check(t.text(i, "ends_in_cycle") == "yes" && is_moment(judged(t, i)),
              "both end in the cycle: " + t.text(i, "ends_in_cycle"));
      }
  }

  /** Two frictions: steady sliding, and a wobble that a single run has too. */
  void
  campaign_of_transients(const std::string &program, const Table &cycle)
  {
    const std::string said =
      run_ring(program,
               {"Analysis = transient",
                "Output directory = transients",
                "Transient/Campaign table = campaign.csv",
                "Transient/Threads = 1"});
    const Table t = read_csv("transients/campaign.csv");
    check(t.n_rows() == 2 && judged(t, 0).empty() && is_moment(judged(t, 1)),
          "each run names its force: " + judged(t, 0) + ", " + judged(t, 1));
    says(said, "mu 0.4: the " + judged(t, 1) + " vibrates by");
    check_close(t.real(1, "rms_normal_n"),
                cycle.real(0, "rms_normal_n"),
                .01,
                "rms of the transient and of the cycle");
    check_close(t.real(1, "frequency_hz"),
                cycle.real(0, "frequency_hz"),
                .002,
                "and the frequency");
  }
} // namespace

int
main(int argc, char *argv[])
{
  check(argc > 1, "argument: the program");
  const std::string program = argv[1];
  for (const char *folder : {"branch", "cycles", "transients"})
    std::filesystem::remove_all(folder);
  write_ring(24, speeds);
  const std::string said =
    run_ring(program, {"Analysis = limit cycle", "Output directory = branch"});
  const Table cycle = read_csv("branch/limit_cycle.csv");
  says(said, "rms of the " + judged(cycle, 0));
  says(said, "their sum by");
  says(said, "points of the branch are those of a moment");
  branches(cycle);
  write_ring(12, frictions);
  const std::string of_campaign = run_ring(program,
                                           {"Analysis = limit cycle",
                                            "Output directory = cycles",
                                            "Limit cycle/Campaign = true",
                                            "Limit cycle/Starts = 1"});
  says(of_campaign, "mu = 0.40000: the " + moment);
  const Table campaign = read_csv("cycles/campaign.csv");
  same_motion(campaign, cycle, "campaign.csv: ");
  same_motion(read_csv("cycles/competition.csv"), cycle, "competition.csv: ");
  starts(campaign);
  campaign_of_transients(program, cycle);
}
