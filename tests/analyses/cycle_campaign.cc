// SPDX-License-Identifier: LGPL-2.1-or-later

// Limit cycles over the axes of a campaign: what the cycles of several pairs
// come to, points as single analyses have them, finished points kept.
// Arguments: the program and the folder of parameter files.

#include <squeal/analyses/limit_cycle/cycle_campaign.h>
#include <squeal/analyses/limit_cycle/limit_cycle_output.h>

#include "brief_runs.h"

using namespace squeal;
using namespace squeal::testing;

namespace
{
  CycleResult
  cycle(const double frequency, const double rms, const double multiplier)
  {
    CycleResult c;
    c.pair          = {100., 2. * M_PI * 3000.};
    c.coarse.status = c.motion.status = CycleStatus::converged;
    c.figures.frequency               = frequency;
    c.figures.rms_normal              = rms;
    c.figures.largest_harmonic        = 1;
    c.coarse_figures                  = c.figures;
    c.multipliers.trivial             = 1.;
    c.multipliers.largest             = multiplier;
    c.multipliers.error               = 1e-3;
    return c;
  }

  CycleResult
  without_period()
  {
    CycleResult c;
    c.coarse.status = CycleStatus::no_period;
    return c;
  }

  CycleResult
  aperiodic()
  {
    CycleResult c;
    c.coarse.status = CycleStatus::aperiodic;
    return c;
  }

  void
  is(const std::vector<CycleResult> &cycles,
     const std::string              &text,
     const int                       heard,
     const std::size_t               n_different)
  {
    const CycleOutcome o = outcome_of(cycles);
    check(o.text == text && o.heard == heard && o.n_different == n_different,
          text + ": " + o.text + ", heard " + std::to_string(o.heard) +
            ", different " + std::to_string(o.n_different));
  }

  /** Cycles are the same within their errors, twice the difference to half the
   * steps. */
  void
  errors_by_half_the_steps()
  {
    check(error_by_steps(3., 2.5) == 1., "twice the difference");
    CycleResult a = cycle(3000., 50., .9), b = cycle(3012., 53., .9);
    is({a, b}, "several stable limit cycles", 1, 2);
    for (CycleResult *c : {&a, &b})
      {
        c->coarse_figures.frequency += 3.;
        c->coarse_figures.rms_normal += .75;
      }
    check(a.frequency_error() == 6., "of the frequency");
    is({a, b}, "stable limit cycle", 0, 1);
    // One harmonic grows by as much power as the other loses.
    CycleResult c                     = cycle(3000., std::sqrt(12.5), .9);
    c.figures.normal_harmonics        = {4., 3., .1};
    c.coarse_figures.normal_harmonics = {3., 4.};
    check_close(c.rms_normal_error(), 2., 1e-12, "of the harmonics");
  }

  /** With half the steps the other of two pairs may be the loudest. */
  void
  errors_of_the_same_pair()
  {
    CycleResult c                        = cycle(3000., 50., .9);
    c.figures.pairs                      = {ForceFigures{}, ForceFigures{}};
    c.coarse_figures                     = c.figures;
    c.figures.loudest                    = 1;
    c.figures.max_normal                 = 70.;
    c.coarse_figures.loudest             = 0;
    c.coarse_figures.max_normal          = 90.;
    c.coarse_figures.pairs[1].max_normal = 68.;
    c.coarse_figures.pairs[1].rms_normal = 49.5;
    check(c.force_error(&ForceFigures::max_normal) == 4.,
          "the largest force of the same pair");
    check(c.rms_normal_error() == 1., "its rms");
  }

  /** What is said of an unstable cycle with the multiplier @p m. */
  void
  is_left(const std::complex<double> m, const std::string &text)
  {
    CycleResult c        = cycle(3000., 50., std::abs(m));
    c.multipliers.values = Eigen::Vector3cd(m, std::conj(m), 1.);
    const std::string s  = cycle_sentence(c);
    check(s.find(text) != std::string::npos, text + ": " + s);
  }

  void
  ways_of_leaving()
  {
    is_left(-1.0159, "period doubling");
    is_left({.3, 1.1}, "torus");
    is_left(1.2, "fold");
    check(cycle_sentence(cycle(3000., 50., .9)).find("disturbances") ==
            std::string::npos,
          "nothing leaves a stable cycle");
  }

  void
  outcomes()
  {
    const CycleResult stable   = cycle(3000., 50., .9),
                      louder   = cycle(7000., 60., .95),
                      unstable = cycle(5000., 90., 1.1),
                      open     = cycle(4000., 70., 1.0005);
    is({}, "steady sliding", -1, 0);
    is({without_period()}, "no limit cycle found", -1, 0);
    is({aperiodic(), aperiodic()}, "no period", -1, 0);
    is({aperiodic(), without_period()}, "no limit cycle found", -1, 0);
    check(aperiodic().status() == "aperiodic", "what lasts without a period");
    is({unstable, without_period()}, "limit cycles found are unstable", -1, 1);
    is({unstable, stable}, "stable limit cycle", 1, 2);
    is({stable, louder, open}, "several stable limit cycles", 1, 3);
    is({open, unstable}, "limit cycle, stability open", 0, 2);
    is({open, cycle(4500., 70., 1.0005)}, "limit cycle, stability open", -1, 2);
    is({stable, cycle(3001., 50.2, .9)}, "stable limit cycle", 0, 1);
    CycleResult coarse              = cycle(3030., 50., .9);
    coarse.coarse_figures.frequency = 3000.;
    is({stable, coarse}, "stable limit cycle", 0, 1);
    // The same motion, gone through twice, and one whose period has doubled.
    CycleResult once = stable, twice = cycle(1500., 50., .81), doubled = twice;
    for (CycleResult *c : {&once, &twice, &doubled})
      {
        c->figures.normal_harmonics     = std::vector<double>(64, 0.);
        c->figures.tangential_harmonics = c->figures.normal_harmonics;
      }
    for (std::vector<double> CycleFigures::*of :
         {&CycleFigures::normal_harmonics, &CycleFigures::tangential_harmonics})
      {
        (once.figures.*of)[0] = (twice.figures.*of)[1] = 70.;
        (once.figures.*of)[1] = (twice.figures.*of)[3] = 10.;
      }
    doubled.figures.normal_harmonics    = twice.figures.normal_harmonics;
    doubled.figures.normal_harmonics[0] = 5.;
    is({once, twice}, "stable limit cycle", 0, 1);
    is({once, doubled}, "several stable limit cycles", 0, 2);
    // Alike in the louder pad, not in the other one.
    CycleResult together = stable, alone = stable, halved = twice;
    together.figures.pairs.resize(2);
    for (ForceFigures &pair : together.figures.pairs)
      pair.rms_normal = 50.;
    alone.figures.pairs               = together.figures.pairs;
    alone.figures.pairs[1].rms_normal = 20.;
    together.coarse_figures           = together.figures;
    alone.coarse_figures              = alone.figures;
    is({together, alone}, "several stable limit cycles", 0, 2);
    halved.figures.pairs = {twice.figures, doubled.figures};
    check(halved.figures.repetitions() == 1,
          "the period of all pairs is that of the motion");
    check(once.figures.repetitions() == 1 && twice.figures.repetitions() == 2 &&
            doubled.figures.repetitions() == 1,
          "how often a motion repeats itself within its period");
    check(outcome_table({unstable, stable}).integer(0, "n_stable") == 1,
          "counted in the table");
    MotionTrial there, elsewhere;
    there.ends_in = true;
    const Table followed =
      outcome_table({unstable, stable}, {1, {there, elsewhere, there}});
    check(followed.integer(0, "n_starts") == 2 &&
            followed.integer(0, "n_ending_in_cycle") == 1 &&
            followed.text(0, "stays") == "yes",
          "the last of the motions is that from the cycle itself");
    check(followed.text(0, "outcome") == "stable limit cycle",
          "the multipliers decide where they can");
    const Table left = outcome_table({stable}, {0, {there, elsewhere}});
    check(left.text(0, "outcome") ==
              "stable limit cycle, left by the motion from it" &&
            left.text(0, "stays") == "no",
          "a stable cycle on which a motion does not stay is no plain one");
    const CycleResult nearly = cycle(5000., 90., 1.008);
    const auto        after  = [&](const CycleResult &c,
                           const MotionTrial &from_elsewhere) {
      return outcome_table({c}, {0, {from_elsewhere, there}});
    };
    check(after(nearly, there).text(0, "outcome") ==
              "limit cycle, stable in time" &&
            !after(nearly, there).is_missing(0, "frequency_hz"),
          "a cycle that all motions end in is stable in time where its "
          "multiplier is near to 1");
    check(after(unstable, there).text(0, "outcome") ==
              "unstable limit cycle that motions stay near" &&
            after(unstable, there).is_missing(0, "frequency_hz"),
          "a multiplier far beyond 1 is not overruled: what is heard is not "
          "known");
    check(after(nearly, elsewhere).text(0, "outcome") ==
            "limit cycles found are unstable",
          "motions that end elsewhere leave it unstable");
    check(after(open, elsewhere).is_missing(0, "frequency_hz") &&
            after(open, elsewhere).text(0, "outcome") ==
              "limit cycle, stability open",
          "an open cycle that no motion from elsewhere ends in is not heard");
    MotionTrial on_its_way;
    on_its_way.is_undecided = true;
    check(!after(open, on_its_way).is_missing(0, "frequency_hz") &&
            after(open, on_its_way).integer(0, "n_undecided") == 1 &&
            after(open, on_its_way).integer(0, "n_ending_in_cycle") == 0,
          "a motion whose time ran out on its way to a cycle does not end "
          "elsewhere");
    check(outcome_table({open}, {0, {on_its_way, elsewhere, there}})
              .integer(0, "n_undecided") == 1,
          "and is counted");
    check(outcome_table({stable}).is_missing(0, "stays"),
          "nothing is said of motions that were not followed");
    check(outcome_table({}).n_rows() == 1, "a row without pairs, too");
    const Table outside = outcome_table({}, {}, {}, {700., 2. * M_PI * 51660.});
    check(outside.text(0, "outcome") ==
              "steady sliding in the band, growth outside" &&
            outside.real(0, "outside_hz") > 51659. &&
            outside.real(0, "outside_sigma_per_s") == 700.,
          "what grows outside the band is said");
    check(outcome_table({}).is_missing(0, "outside_hz") &&
            outcome_table({stable}, {}, {}, {700., 4e5}).text(0, "outcome") ==
              "stable limit cycle",
          "and changes nothing of cycles of the band");
  }



  const std::string search = R"(
subsection Eigenvalues
  set Lowest frequency  = 100
  set Highest frequency = 20000
end
subsection Limit cycle
  set Run time           = 0.004
  set Every growing pair = true
  set Campaign           = )";

  const std::string ramp = R"(
subsection Scene
  subsection Load press
    set Ramp time = 0.02
  end
end
)";

  std::string
  limit_cycle(const std::string &folder,
              const std::string &more,
              const std::string &directory = "out")
  {
    std::string text = pin_on_beam(folder, more);
    for (const auto &[from, to] :
         {std::make_pair(std::string("= transient\n"),
                         std::string("= limit cycle\n")),
          std::make_pair(std::string("= out\n"), "= " + directory + "\n")})
      {
        const auto at = text.find(from);
        check(at != std::string::npos, "changes " + from);
        text.replace(at, from.size(), to);
      }
    return text;
  }

  std::string
  campaign(const std::string &folder)
  {
    return limit_cycle(folder, ramp + search + R"(true
  set Starts             = 4
end
subsection Sweep
  set Axes = mu
  subsection Axis mu
    set Entries = Scene/Contact pin_beam/Friction coefficient
    set Scale   = list
    set Values  = 0.1, 0.4
  end
end
)");
  }

  std::string
  single(const std::string &folder)
  {
    return limit_cycle(folder,
                       ramp + search + R"(false
end
subsection Scene
  subsection Contact pin_beam
    set Friction coefficient = 0.4
  end
end
)",
                       "single");
  }

  /** The last line without its first @p n cells. */
  std::string
  last_row(const std::string &file, const unsigned int n)
  {
    std::istringstream text(text_of(file));
    std::string        last;
    for (std::string line; std::getline(text, line);)
      if (!line.empty())
        last = line;
    for (unsigned int i = 0; i < n; ++i)
      last = last.substr(last.find(',') + 1);
    return last;
  }

  void
  points(const std::string &program, const std::string &folder)
  {
    std::filesystem::remove_all("out");
    std::filesystem::remove_all("single");
    write_text("campaign.prm", campaign(folder));
    write_text("single.prm", single(folder));
    const Outcome first = run_program({program, "campaign.prm"});
    check(first.code == 0, "a campaign runs: " + first.errors);
    const Outcome alone = run_program({program, "single.prm"});
    check(alone.code == 0, "the point alone runs: " + alone.errors);
    for (const Outcome *o : {&first, &alone})
      check(unbroken(o->output).find("/Ramp time' (") != std::string::npos,
            "a ramp without effect is warned of");
    const std::string starts = text_of("out/starts.csv");
    check(starts.find(" J, reversed") != std::string::npos &&
            starts.find("of -") == std::string::npos,
          "impulses are named by an energy and a direction: " + starts);
    const std::string pairs = text_of("out/competition.csv"),
                      cells = text_of("out/campaign.csv");
    check(last_row("out/competition.csv", 1) ==
            last_row("single/competition.csv", 0),
          "the pair of a point is that of the single analysis: " +
            last_row("out/competition.csv", 1));
    check(cells.find("steady sliding") != std::string::npos,
          "steady sliding is stable at the lower friction");
    const Outcome again = run_program({program, "campaign.prm"});
    check(again.code == 0 && again.output.find("2 of 2 runs are taken from") !=
                               std::string::npos,
          "finished points are kept: " + again.errors);
    check(text_of("out/competition.csv") == pairs &&
            text_of("out/campaign.csv") == cells,
          "with the same bytes");
  }
} // namespace

int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  check(argc > 2, "arguments: the program and the folder of parameter files");
  errors_by_half_the_steps();
  errors_of_the_same_pair();
  ways_of_leaving();
  outcomes();
  points(argv[1], argv[2]);
}
