// SPDX-License-Identifier: LGPL-2.1-or-later

// What a history does not tell is an empty cell and a warning, and a pause in
// it is said; the ratio of a spectral estimate to counting is that of the same
// rules. Argument: the program.
#include "../analyses/program.h"

#include <squeal/results/contact_history.h>
#include <squeal/results/table.h>
#include <squeal/tribology/damage/history_damage.h>

#include <random>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  std::string program;

  /** A grid of 2 x 2 nodes under a common pressure, with slip rates or
   * without; tractions are @p friction times the pressure, and the status at
   * the times is @p status, one after the other and again; none if it is empty. */
  void
  write_history(const std::string                &file,
                const std::vector<double>        &times,
                const std::vector<double>        &pressures,
                const bool                        has_slip_rate,
                const double                      friction = .5,
                const std::vector<ContactStatus> &status   = {},
                const double                      slip     = 2.,
                const std::string                &name     = "",
                const double                      sliding  = 1.)
  {
    HistoryLayout layout;
    layout.name    = name;
    layout.sliding = {{0., sliding}};
    for (const double y : {0., 1e-3})
      for (const double x : {0., 1e-3})
        layout.points.push_back({{x, y, 0.}});
    layout.areas.assign(4, .25e-6);
    layout.has_gap = layout.has_status = layout.has_resultants = false;
    layout.has_slip_rate                                       = has_slip_rate;
    layout.has_status = !status.empty();
    HistorySamples s;
    s.time = times;
    for (std::size_t i = 0; i < pressures.size(); ++i)
      for (unsigned int node = 0; node < 4; ++node)
        {
          const double p = pressures[i];
          s.pressure.push_back(p);
          s.traction.insert(s.traction.end(), {0., friction * p});
          if (!status.empty())
            s.status.push_back(std::uint8_t(status[i % status.size()]));
          if (has_slip_rate)
            s.slip_rate.insert(s.slip_rate.end(), {0., slip});
        }
    HistoryWriter writer(file, layout);
    writer.append(s);
    writer.finish();
  }



  /** Pressure of 1 MPa with a sine of 100 Hz, at times 1 ms apart. */
  void
  write_sine(const std::string &file,
             const bool         has_slip_rate,
             const double       pause = 0.,
             const std::size_t  at    = 50)
  {
    std::vector<double> times, pressures;
    for (unsigned int i = 0; i <= 100; ++i)
      {
        times.push_back(1e-3 * i + (i > at ? pause : 0.));
        pressures.push_back(1e6 * (1. + .5 * std::sin(.2 * M_PI * i + .3)));
      }
    write_history(file, times, pressures, has_slip_rate);
  }



  /** Runs the damage of histories; returns the record of the run. */
  std::string
  run_damage(const std::string &history, const std::string &fatigue = "")
  {
    write_text("test.prm",
               "set Analysis = damage\nset Output directory = damage\n"
               "set Overwrite = true\nsubsection History\n" +
                 history + "end\nsubsection Fatigue\n  set Exponents = 3\n" +
                 fatigue +
                 "end\nsubsection Subsurface\n  set Compute = false\nend\n"
                 "subsection Output\n  set Plots = false\nend\n");
    const Outcome outcome = run_program({program, "test.prm"});
    check(outcome.code == 0, "the run ends well: " + outcome.errors);
    return text_of("damage/run.json");
  }



  bool
  has(const std::string &text, const std::string &part)
  {
    return text.find(part) != std::string::npos;
  }



  void
  without_slip_rate()
  {
    write_sine("known.h5", true);
    write_sine("unknown.h5", false);
    const std::string unknown =
      "unknown.h5: the history has no slip rate: friction power, wear and "
      "stick-slip are not known";
    const std::string both =
      run_damage("  set File = known.h5\n  set Silent file = unknown.h5\n");
    check(has(both, unknown), "a silent history without slip rate is said");
    check(both.find("no slip rate") == both.rfind("no slip rate"),
          "the other one is not");
    Table damage = read_csv("damage/damage.csv");
    Table totals = read_csv("damage/totals.csv");
    for (const char *column :
         {"friction_power_w_per_m2", "wear_index_pa_m_per_s"})
      check(!damage.is_missing(0, column) &&
              damage.is_missing(0, std::string("silent_") + column) &&
              damage.is_missing(0, std::string("ratio_") + column),
            std::string(column) + ": empty for the silent history, as is the "
                                  "ratio");
    check_close(totals.real(0, "friction_power_w"),
                1e-6 * 1e6,
                .05,
                "the total of the known slip: mu p v A");
    check(totals.is_missing(1, "friction_power_w"),
          "that of the unknown one is empty");
    check(!totals.is_missing(1, "mean_damage_m3_per_s") &&
            totals.real(1, "mean_damage_m3_per_s") > 0.,
          "its damage is known");

    check(has(run_damage("  set File = unknown.h5\n"), unknown),
          "a history without slip rate is said");
    damage = read_csv("damage/damage.csv");
    for (const char *column : {"friction_power_w_per_m2",
                               "friction_energy_per_application_j_per_m2",
                               "wear_index_pa_m_per_s",
                               "wear_index_per_application_pa_m",
                               "stick_slip_per_s"})
      check(damage.is_missing(0, column), std::string(column) + ": empty");
    check(read_csv("damage/totals.csv").is_missing(0, "friction_power_w"),
          "the total is empty");
  }



  void
  pauses()
  {
    write_sine("even.h5", true);
    check(!has(run_damage("  set File = even.h5\n"), "no sample for"),
          "even times: no word of a pause");
    const double before =
      read_csv("damage/totals.csv").real(0, "mean_damage_m3_per_s");
    write_sine("short.h5", true, .008);
    check(!has(run_damage("  set File = short.h5\n"), "no sample for"),
          "nine intervals are no pause");
    write_sine("pause.h5", true, .9);
    const std::string record = run_damage("  set File = pause.h5\n");
    check(
      has(record,
          "pause.h5: no sample for 0.901 s after 0.0500000 s, 901 times the "
          "median interval: "),
      "a pause is said with its length and time");
    const std::string report = text_of("damage/report.html");
    const std::size_t what   = report.find("What was done"),
                      pause  = report.find("no sample for 0.901 s", what);
    check(what != std::string::npos &&
            pause < report.find("Over the whole face", what),
          "the report says it where it says what was counted");
    check(has(record, "per second are 10.1 times lower than without"),
          "and with what it does");
    check_close(before /
                  read_csv("damage/totals.csv").real(0, "mean_damage_m3_per_s"),
                10.,
                1e-3,
                "which it does");
    write_sine("silent.h5", true, .9, 20);
    check(has(run_damage("  set File = even.h5\n  set Silent file = "
                         "silent.h5\n"),
              "silent.h5: no sample for 0.901 s after 0.0200000 s"),
          "so is one of the silent history");
  }



  /** What no contact does is said, and what every contact does is not. */
  void
  contradictions()
  {
    const std::vector<double> times     = {0., 1e-3, 2e-3, 3e-3, 4e-3};
    const std::vector<double> pressures = {1e6, 2e6, 1e6, 2e6, 1e6};
    const std::string power  = "the friction power is negative at 4 of 4 nodes",
                      status = "the status is open in 20 of 20 values that "
                               "have a pressure, up to 2.00e+06 Pa";
    write_history("driven.h5", times, pressures, true, -.5);
    check(has(run_damage("  set File = driven.h5\n"), power),
          "friction that drives the sliding");
    write_history("open.h5", times, pressures, true, .5, {ContactStatus::open});
    check(has(run_damage("  set File = open.h5\n"), status),
          "an open contact under pressure");
    const std::vector<ContactStatus> slips            = {ContactStatus::slip},
                                     sticks_and_slips = {ContactStatus::slip,
                                                         ContactStatus::stick};
    write_history("closed.h5", times, {1e6, 0., 1e6, 0., 1e6}, true, .5, slips);
    check(has(run_damage("  set File = closed.h5\n"),
              "8 of 20 values with a closed status have no pressure"),
          "a closed contact without pressure");
    write_history("rubs.h5", times, pressures, true, .5, sticks_and_slips, .3);
    check(has(run_damage("  set File = rubs.h5\n"),
              "the slip rate is 0.300 m/s on the mean of the 8 values whose "
              "status is stick"),
          "sticking at the speed of sliding");
    write_history(
      "rests.h5", times, pressures, true, .5, {ContactStatus::stick}, 1e-12);
    check(!has(run_damage("  set File = rests.h5\n"), "the slip rate is"),
          "sticking with rounding of the slip rate has no word");
    write_history("slips.h5", times, pressures, true, .5, slips);
    const std::string slipping = run_damage("  set File = slips.h5\n");
    check(!has(slipping, "closed status") && !has(slipping, "status is"),
          "a closed contact that slips under pressure has no word");
    const std::string direction = "the slip rates point along (0, -1.0)";
    write_history("turned.h5", times, pressures, true, -.5, {}, -2.);
    const std::string turned = run_damage("  set File = turned.h5\n");
    check(has(turned, direction) && !has(turned, "the friction power is"),
          "sliding the other way than the history says");
    for (const double sliding : {1., 0.3})
      {
        write_history(
          "speed.h5", times, pressures, true, .5, {}, .3, "", sliding);
        check(has(run_damage("  set File = speed.h5\n"),
                  "'nodes/sliding' has a length of 0.30") == (sliding < 1.),
              "a speed for a direction is no sliding all round");
      }
    const std::string dragged = "the tractions point along (0, -1.0)";
    write_history("dragged.h5", times, pressures, false, -.5);
    check(has(run_damage("  set File = dragged.h5\n"), dragged),
          "without slip rates tractions tell where the disc slides");
    write_history("along.h5", times, pressures, false);
    check(!has(run_damage("  set File = along.h5\n"), "the tractions point"),
          "along the sliding they have no word");
    write_history("usual.h5", times, pressures, true);
    const std::string usual = run_damage("  set File = usual.h5\n");
    check(!has(usual, "the friction power is") &&
            !has(usual, "the status is") && !has(usual, "the slip rates point"),
          "friction that slows and a contact without status have no word");
  }



  /** Of runs that slide other ways nodes do not correspond. */
  void
  runs_that_slide_other_ways()
  {
    const std::vector<double> times = {0., 1e-3, 2e-3}, p = {1e6, 2e6, 1e6};
    write_history("forth.h5", times, p, true);
    write_history("back.h5", times, p, true, -.5, {}, -2., "", -1.);
    run_damage("  set File = back.h5\n");
    run_damage("  set File = forth.h5\n  set Silent file = forth.h5\n");
    const Outcome other = run_program(
      {program, "test.prm", "--set", "History/Silent file = back.h5"});
    check(other.code == 2 &&
            has(other.errors, "back.h5' slides along (0, -1.0) by") &&
            has(other.errors, "forth.h5' along (0, 1.0)"),
          "the other way is refused: " + other.errors);
  }



  /** A history alone is called what it calls itself. */
  void
  names_of_runs()
  {
    const auto names = []() {
      const Table              totals = read_csv("damage/totals.csv");
      std::vector<std::string> texts;
      for (std::size_t i = 0; i < totals.n_rows(); ++i)
        texts.push_back(totals.is_missing(i, "run") ? ""
                                                    : totals.text(i, "run"));
      return texts;
    };
    using Names                     = std::vector<std::string>;
    const std::vector<double> times = {0., 1e-3, 2e-3}, p = {1e6, 2e6, 1e6};
    write_history("named.h5", times, p, true, .5, {}, 2., "quiet braking");
    run_damage("  set File = named.h5\n");
    check(names() == Names{"quiet braking"}, "one history: its own name");
    run_damage("  set File = known.h5\n");
    check(names() == Names{""}, "one without a name: none");
    run_damage("  set File = known.h5\n  set Silent file = named.h5\n");
    check(names() == Names{"squealing", "silent"}, "two that are compared");
  }



  /** Of a face that is pulled the largest pressure is the least tension. */
  void
  tension()
  {
    write_history(
      "pulled.h5", {0., 1e-3, 2e-3, 3e-3}, {-3e6, -1e6, -3e6, -3e6}, true);
    run_damage("  set File = pulled.h5\n");
    const Table damage = read_csv("damage/damage.csv");
    check(damage.real(0, "peak_pressure_pa") == -1e6, "peak of a tension");
    check_close(damage.real(0, "mean_pressure_pa"),
                -(2. + 2. + 3.) / 3. * 1e6,
                1e-9,
                "its mean by the trapezoidal rule");
    const Outcome beyond = run_program({program,
                                        "test.prm",
                                        "--set",
                                        "Fatigue/Mean stress = goodman",
                                        "--set",
                                        "Fatigue/Ultimate strength = 1e5"});
    check(beyond.code == 2 && has(beyond.errors, "Ultimate strength"),
          "a mean stress beyond the strength is refused: " + beyond.errors);
  }



  /** Entries without effect, values of nothing, and what indices are over. */
  void
  what_is_said()
  {
    const auto run = [](const std::vector<std::string> &settings) {
      std::vector<std::string> words = {program, "test.prm"};
      for (const std::string &setting : settings)
        words.insert(words.end(), {"--set", setting});
      const Outcome outcome = run_program(words);
      check(outcome.code == 0, "the run ends well: " + outcome.errors);
      return text_of("damage/run.json");
    };
    const std::vector<std::string> surface = {"Surface/Contact pressure = 2",
                                              "Surface/Stick speed = 1"};
    const auto pressure = "'Surface/Contact pressure' is set but not used",
               speed    = "'Surface/Stick speed' is set but not used";
    run_damage("  set File = open.h5\n");
    std::string record = run(surface);
    check(has(record, pressure) && has(record, speed),
          "a status tells contact and stick");
    run_damage("  set File = unknown.h5\n");
    record = run(surface);
    check(!has(record, pressure) && has(record, speed),
          "without slip rates nothing sticks");
    run_damage("  set File = known.h5\n");
    record = run(surface);
    check(!has(record, pressure) && !has(record, speed),
          "of pressures and slip rates both are used");

    run({"Subsurface/Compute = true",
         "Subsurface/Criteria = swt, crossland",
         "Subsurface/Depths = 1e-5, 2e-5"});
    const std::string report = text_of("damage/report.html");
    check(has(report, "the same damage all over the face (slope m3)"),
          "all nodes have the same damage: none has the most");
    check(has(report, "limits that follow from Fatigue/Reference stress"),
          "indices below the face are over limits");
    const Table damage = read_csv("damage/damage.csv");
    for (std::size_t k = 0; k < damage.n_rows(); ++k)
      check(damage.is_missing(k, "subsurface_swt") ||
              (damage.real(k, "subsurface_swt") == 0.) ==
                damage.is_missing(k, "depth_swt_m"),
            "a value of 0 has no depth");
  }



  /** Headline, picture and caption speak of the same slope. */
  void
  worst_node_of_two_slopes()
  {
    tribology::HistoryDamage damage;
    damage.nodes.resize(2);
    damage.nodes[0].damage = {2., 1.};
    damage.nodes[1].damage = {1., 5.};
    check(damage.worst_node() == 0, "the first slope tells the worst node");
    run_damage("  set File = known.h5\n");
    const Outcome outcome =
      run_program({program, "test.prm", "--set", "Output/Plots = true"});
    check(outcome.code == 0, "the run ends well: " + outcome.errors);
    const std::string picture = "damage/plots/range_mean.svg";
    if (!std::filesystem::exists(picture))
      return; // nothing draws here
    check(has(text_of("damage/report.html"),
              "node with the largest damage of slope m3:") &&
            has(text_of(picture), "where damage of slope m3 is largest"),
          "caption and title name the slope");
  }



  /** Low-pass noise about a compression that Goodman rewards. */
  void
  gaussian_noise()
  {
    std::mt19937_64                  generator(7);
    std::normal_distribution<double> normal;
    std::vector<double>              times, pressures;
    double                           a = 0., b = 0., e = 0.;
    for (unsigned int i = 0; i < 60000; ++i)
      {
        a += .1 * (normal(generator) - a);
        b += .1 * (a - b);
        e += .1 * (b - e);
        times.push_back(1e-3 * i);
        pressures.push_back(1e6 * (2. + e));
      }
    write_history("noise.h5", times, pressures, true);
    const auto figures = [](const std::string &rules) {
      run_damage("  set File = noise.h5\n", "  set Constants = 1e6\n" + rules);
      const Table t = read_csv("damage/damage.csv");
      return std::array<double, 2>{
        {t.real(0, "dirlik_over_counting_m3"), t.real(0, "damage_m3_per_s")}};
    };
    const auto [ratio, damage] = figures("");
    check_close(ratio, 1., .15, "Gaussian noise: spectral over counted damage");
    for (const std::string rules :
         {"  set Mean stress = goodman\n  set Ultimate strength = 3e6\n",
          "  set Accumulation = manson halford\n",
          "  set Endurance limit = 2e5\n"})
      {
        const auto [same, other] = figures(rules);
        check(same == ratio, "it is so whatever the rules of the damage");
        check(other != damage, "which changes with them:" + rules);
      }
    // Far behind the start the samples come four times as often.
    for (std::size_t i = 59000; i < times.size(); ++i)
      times[i] = times[i - 1] + .25e-3;
    write_history("uneven.h5", times, pressures, true);
    check(has(run_damage("  set File = uneven.h5\n", "  set Constants = 1e6\n"),
              "no spectral estimate: it needs evenly spaced times"),
          "a spectrum of uneven samples is none");
  }



  /** A history that takes much of the life is said to depend on order. */
  void
  order()
  {
    const std::string rule = "  set Accumulation = manson halford\n";
    const std::string note = "their order changes the life";
    check(has(run_damage("  set File = known.h5\n",
                         rule + "  set Constants = 100\n"),
              note),
          "ten cycles of some hundreds: a word of their order");
    check(!has(run_damage("  set File = known.h5\n",
                          rule + "  set Constants = 1e6\n"),
               note),
          "ten of a million: none");
    check(!has(run_damage("  set File = known.h5\n", "  set Constants = 100\n"),
               note),
          "nor by Miner's sum, which has no order");
  }
} // namespace



int
main(int argc, char **argv)
{
  check(argc == 2, "one argument");
  program = argv[1];
  without_slip_rate();
  pauses();
  contradictions();
  runs_that_slide_other_ways();
  names_of_runs();
  tension();
  worst_node_of_two_slopes();
  gaussian_noise();
  order();
  what_is_said();
}
