// SPDX-License-Identifier: LGPL-2.1-or-later

// Triggers of the coarse TriboBrake: what a search without a threshold says,
// finished scenes that are kept with the same bytes, how a bracket is tabled,
// and multipliers that their error leaves open. With a further argument: a
// threshold between the blows either side of it, which takes many motions;
// cycle/triggers.cc finds known ones by the same search. Arguments: the program
// and the folder of parameter files; "threshold" (optional).

#include <squeal/analyses/triggers/trigger_tables.h>
#include <squeal/results/table.h>

#include "../worst.h"
#include "program.h"

using namespace squeal;
using namespace squeal::testing;

namespace
{
  const std::string ramp = "Scene/Load press/Ramp time = 0.02";

  struct Run
  {
    const std::string program, folder;

    Outcome
    operator()(const std::string              &directory,
               const std::vector<std::string> &settings) const
    {
      std::vector<std::string> words = {program};
      std::vector<std::string> all   = {"Triggers/Points = side",
                                        "Triggers/Edge time = 0",
                                        "Triggers/Longest time = 0.2",
                                        "Limit cycle/Steps per period = 64",
                                        "Output/Plots = false",
                                        "Output/Report = false",
                                        "Output directory = " + directory};
      all.insert(all.end(), settings.begin(), settings.end());
      for (const std::string &setting : all)
        words.insert(words.end(), {"--set", setting});
      words.push_back(folder + "/tribobrake/triggers.prm");
      return run_program(words);
    }
  };

  void
  ends_with(const Run                      &run,
            const std::vector<std::string> &settings,
            const std::string              &status)
  {
    const Outcome o = run("out", settings);
    check(o.code == 0, status + ": runs: " + o.errors);
    const Table t = read_csv("out/triggers.csv");
    check(t.n_rows() == 1 && t.text(0, "trigger_status") == status &&
            t.is_missing(0, "impulse_ns"),
          "says '" + status + "': " + t.text(0, "trigger_status"));
    const std::string said = unbroken(o.output);
    check(said.find(status) != std::string::npos,
          "in the sentence of the run, too");
    check((said.find("/Ramp time' (") != std::string::npos) ==
            (settings.back() == ramp),
          "a ramp without effect is warned of");
  }

  void
  faults(const Run &run)
  {
    ends_with(run,
              {"Scene/Contact pad_disc/Friction coefficient = 0.6", ramp},
              "steady sliding is unstable");
    // Too short to see what the motion ends in.
    ends_with(run,
              {"Triggers/Impulses = 0.25", "Triggers/Longest time = 0.025"},
              "undecided at the largest impulse");
  }

  /** The same scene is taken from the run before, and another one is not. */
  void
  kept_scenes(const Run &run)
  {
    const std::vector<std::string> first = {"Triggers/Impulses = 0.01, 0.02"};
    ends_with(run, first, "no squeal at the largest impulse");
    const std::string taken = "1 of 1 runs are taken from",
                      bytes = text_of("out/triggers.csv");
    const Outcome again     = run("out", first);
    check(again.code == 0 && again.output.find(taken) != std::string::npos &&
            text_of("out/triggers.csv") == bytes,
          "a finished scene is kept with the same bytes");
    // Another point is another scene.
    const Outcome other =
      run("out",
          {first[0], "Measurement/Point side/Position = 0.1075, -0.005, 0.05"});
    check(other.code == 0 && other.output.find(taken) == std::string::npos &&
            unbroken(other.output)
                .find("struck at side is support 0.1075 "
                      "-0.005 0.05") != std::string::npos,
          "not where the point is another one");
  }

  /** The search ends with a bracket, which is tabled. */
  void
  threshold(const Run &run)
  {
    check(run("first",
              {"Triggers/Impulses = 0.15, 0.25", "Triggers/Tolerance = 0.1"})
              .code == 0,
          "a threshold is sought");
    const Table  t     = read_csv("first/triggers.csv");
    const double lower = t.real(0, "impulse_lower_ns"),
                 upper = t.real(0, "impulse_upper_ns");
    check(t.text(0, "trigger_status") == "threshold" && lower > 0. &&
            upper - lower <= .1 * upper && t.real(0, "impulse_error_ns") > 0.,
          "it is bracketed: " + std::to_string(lower) + " to " +
            std::to_string(upper) + " N s");
  }

  /** The bracket that is tabled is that of half the steps. */
  void
  tabled_bracket()
  {
    TriggerResult r;
    r.threshold.status = r.finer.status = TriggerThreshold::Status::bracketed;
    r.threshold.lower                   = .14;
    r.threshold.upper                   = .15;
    r.finer.lower                       = .15;
    r.finer.upper                       = .16;
    r.strongest.windows.emplace_back();
    const Table t = trigger_table({r});
    check_close(t.real(0, "impulse_lower_ns"), .15, 1e-12, "its lower end");
    check_close(t.real(0, "impulse_upper_ns"), .16, 1e-12, "its upper end");
    check_close(t.real(0, "impulse_ns"), .155, 1e-12, "its middle");
    // Half the bracket and the change with half the steps.
    check_close(t.real(0, "impulse_error_ns"), .015, 1e-12, "its error");
  }

  /** The multipliers of the cycle on the edge are counted where their error
   * tells on which side of 1 the largest one lies. */
  void
  multipliers_outside()
  {
    TriggerResult r;
    r.threshold.status = r.finer.status = TriggerThreshold::Status::not_there;
    r.unstable.coarse.status            = r.unstable.motion.status =
      CycleStatus::converged;
    r.edge.rms_normal = r.unstable.figures.rms_normal = 50.;
    r.edge.frequency = r.unstable.figures.frequency = 1000.;
    FloquetMultipliers &m                           = r.unstable.multipliers;
    m.values             = Eigen::Vector4cd(1.65, -1.2, 1., .4);
    m.trivial            = 1.;
    m.largest            = 1.65;
    const auto n_outside = [&](const double error) {
      m.error = error;
      return trigger_table({r});
    };
    check(n_outside(3e-4).integer(0, "n_outside") == 2, "both are outside");
    check(n_outside(.3).integer(0, "n_outside") == 1, "one by its error");
    check(n_outside(.9).is_missing(0, "n_outside"),
          "an error that covers the distance to 1 leaves them open");
  }
} // namespace

int
main(int argc, char *argv[])
{
  check(argc > 2, "arguments: the program and the folder of parameter files");
  const Run run{argv[1], argv[2]};
  std::filesystem::remove_all("out");
  std::filesystem::remove_all("first");
  if (argc > 3)
    {
      threshold(run);
      return 0;
    }
  tabled_bracket();
  multipliers_outside();
  faults(run);
  kept_scenes(run);
}
