// SPDX-License-Identifier: LGPL-2.1-or-later

// Two pins on two sides of a beam, each with its own friction, through the
// whole chain by the programs: steady sliding, eigenvalues about it, motion in
// time, its history and the damage of both. Arguments: squeal and
// squeal-tribology.

#include "two_pins.h"
#include "program.h"
#include "worst.h"

#include <squeal/results/contact_history.h>
#include <squeal/results/table.h>

#include <cmath>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  std::string program, damage_program;

  void
  run(const std::string              &analysis,
      const std::vector<std::string> &settings = {})
  {
    write_text("scene.prm",
               two_pins + "set Analysis = " + analysis +
                 "\nset Output directory = out\nset Overwrite = true\n");
    std::vector<std::string> words = {program};
    for (const std::string &setting : settings)
      words.insert(words.end(), {"--set", setting});
    words.push_back("scene.prm");
    const Outcome o = run_program(words);
    check(o.code == 0, analysis + " runs: " + o.errors);
  }

  void
  check_close(const double       got,
              const double       expected,
              const double       tolerance,
              const std::string &claim)
  {
    check(std::abs(got - expected) <= tolerance,
          claim + ": " + std::to_string(got) + ", " + std::to_string(expected));
  }

  void
  steady_sliding()
  {
    run("preload");
    const Table       t    = read_csv("out/preload.csv");
    const std::size_t last = t.n_rows() - 1;
    check_close(t.real(last, "above_normal_n"), 50., 1e-6, "load above");
    check_close(t.real(last, "below_normal_n"), 50., 1e-6, "load below");
    check_close(
      t.real(last, "above_tangential_n"), 15., 1e-6, "friction above");
    check_close(
      t.real(last, "below_tangential_n"), 10., 1e-6, "friction below");
    check_close(t.real(last, "tangential_n"), 25., 1e-6, "their sum");
    check(t.real(last, "above_centre_along_m") < -1e-4 &&
            t.real(last, "below_centre_along_m") < -1e-4,
          "both press on the edge of entry");
    const Table nodes = read_csv("out/contact.csv");
    check(nodes.text(0, "pair") == "above" &&
            nodes.text(nodes.n_rows() - 1, "pair") == "below",
          "nodes of both pairs");
  }

  void
  in_time()
  {
    run("cea");
    const Table cea = read_csv("out/eigenvalues.csv");
    run("transient");
    const Table branches = read_csv("out/branches.csv");
    check(branches.n_rows() > 1, "pairs in the band");
    Worst worst;
    for (std::size_t i = 0; i < branches.n_rows(); ++i)
      {
        double nearest = 1e300;
        for (std::size_t k = 0; k < cea.n_rows(); ++k)
          if (const double off =
                std::abs(cea.real(k, "frequency_hz") /
                           branches.real(i, "frequency_linear_hz") -
                         1.);
              !(off >= nearest))
            nearest = off;
        worst.add(nearest);
      }
    check(worst.largest() < 1e-3,
          "pairs about the same contact: " + std::to_string(worst.largest()));
    const Table forces = read_csv("out/forces.csv");
    Worst       sum;
    for (std::size_t i = 0; i < forces.n_rows(); ++i)
      for (const char *name : {"normal_n", "tangential_n"})
        sum.add(std::abs(forces.real(i, std::string("above_") + name) +
                         forces.real(i, std::string("below_") + name) -
                         forces.real(i, name)));
    check(sum.largest() < 1e-9, "forces of both pins add up");
    check(read_csv("out/transient.csv").real(0, "worst_imbalance") < 1e-3,
          "the ledger closes");
    check(HistoryReader::pairs_of("out/contact_history.h5") ==
            std::vector<std::string>{"above", "below"},
          "a history of both");
    check(read_csv("out/probes.csv").has_column("below_az_m_per_s2"),
          "and both pins' motions");
  }

  /** After in_time(), whose run is a point of it, and damage(). */
  void
  campaign()
  {
    const Table alone = read_csv("out/transient.csv");
    run("transient",
        {"Sweep/Axes = mu",
         "Sweep/Axis mu/Entries = Scene/Contact below/Friction coefficient",
         "Sweep/Axis mu/Scale = list",
         "Sweep/Axis mu/Values = 0.1, 0.2"});
    const Table runs = read_csv("out/campaign.csv");
    check(runs.n_rows() == 2, "a row for each friction of one of two pairs");
    const std::size_t same = runs.real(0, "mu") > .15 ? 0 : 1;
    for (const char *name : {"min_normal_n",
                             "rms_normal_n",
                             "max_normal_n",
                             "macroscopic_friction"})
      check_close(runs.real(same, name),
                  alone.real(0, name),
                  1e-9 * std::abs(alone.real(0, name)),
                  std::string("a run of the campaign is the run alone: ") +
                    name);
    // 50 N on each pin, with 0.3 above.
    check_close(runs.real(1 - same, "macroscopic_friction"),
                (.3 + .1) / 2.,
                1e-3,
                "the other one has its own friction below");
    check(runs.real(0, "worst_imbalance") < 1e-3 &&
            runs.real(1, "worst_imbalance") < 1e-3,
          "both ledgers close");
  }

  void
  damage()
  {
    std::filesystem::copy_file(
      "out/contact_history.h5",
      "history.h5",
      std::filesystem::copy_options::overwrite_existing);
    const std::string text =
      "set Analysis = damage\nset Output directory = "
      "damage\nset Overwrite = true\n"
      "subsection History\n  set File = history.h5\nend\n"
      "subsection Output\n  set Plots = false\nend\n";
    write_text("damage.prm", text);
    const Outcome both = run_program({damage_program, "damage.prm"});
    check(both.code == 0, "damage of both: " + both.errors);
    const Table above = read_csv("damage/damage_above.csv"),
                below = read_csv("damage/damage_below.csv");
    check(above.n_rows() == 25 && below.n_rows() == 25, "a map of each");
    check(read_csv("damage/totals.csv").text(1, "pair") == "below",
          "totals of each");
    const Outcome one = run_program(
      {damage_program, "--set", "History/Contact pair = below", "damage.prm"});
    check(one.code == 0, "damage of one: " + one.errors);
    const Outcome none = run_program(
      {damage_program, "--set", "History/Contact pair = beside", "damage.prm"});
    check(none.code == 2 &&
            none.errors.find("above, below") != std::string::npos,
          "a name that is none: " + none.errors);
  }
} // namespace



int
main(int argc, char **argv)
{
  check(argc == 3, "arguments: squeal, squeal-tribology");
  program        = argv[1];
  damage_program = argv[2];
  steady_sliding();
  in_time();
  damage();
  campaign();
}
