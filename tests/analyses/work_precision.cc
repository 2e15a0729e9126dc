// SPDX-License-Identifier: LGPL-2.1-or-later

// Errors of a ladder are those of the quantity that it names: real parts in
// 1/s, frequencies in Hz, and the finest rung is the one with most unknowns,
// however long another one takes. Rungs of steady sliding and of transients are
// the runs with these settings. Arguments: the program, the folder prm.

#include <squeal/results/table.h>

#include "program.h"
#include "worst.h"

#include <cmath>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  std::string program, folder;

  void
  run(const std::vector<std::string> &settings)
  {
    std::filesystem::remove_all("out");
    write_text("brake.prm", small_brake);
    std::vector<std::string> words = {
      program, "--quiet", "--set", "Eigenvalues/Highest frequency = 40000"};
    for (const std::string &setting : settings)
      words.insert(words.end(), {"--set", setting});
    words.push_back("brake.prm");
    const Outcome o = run_program(words);
    check(o.code == 0, "runs: " + o.errors);
  }

  /** Ladder of degrees with the quantity and the reference. */
  Table
  ladder(const std::string &values,
         const std::string &quantity,
         const std::string &reference)
  {
    run({"Analysis = work precision",
         "Work precision/Ladders = degree",
         "Work precision/Values = " + values,
         "Work precision/Quantity = " + quantity,
         "Work precision/Reference = " + reference});
    return read_csv("out/work_precision.csv");
  }

  std::string
  listed(const std::vector<double> &values, const double factor = 1.)
  {
    std::ostringstream text;
    text.precision(17);
    for (std::size_t i = 0; i < values.size(); ++i)
      text << (i == 0 ? "" : ", ") << factor * values[i];
    return text.str();
  }

  /** The pressed brake on a coarse mesh, for 1 ms. */
  Outcome
  pressed(std::vector<std::string> settings)
  {
    std::filesystem::remove_all("out");
    std::vector<std::string> words = {program, "--quiet"};
    for (const std::string setting : {"Output directory = out",
                                      "Output/Plots = false",
                                      "Scene/Body disc/Cells = 12, 2, 1",
                                      "Scene/Body pad/Cells = 1, 1, 1",
                                      "Scene/Body support/Cells = 1, 1, 4",
                                      "Scene/Support top/Kind = guided",
                                      "Discretization/Degree = 1",
                                      "Transient/Disturbance = 1e-8",
                                      "Transient/End time = 0.002"})
      words.insert(words.end(), {"--set", setting});
    for (const std::string &setting : settings)
      words.insert(words.end(), {"--set", setting});
    words.push_back(folder + "/tribobrake/pressed.prm");
    return run_program(words);
  }

  /** The value of @p figure on the rung @p setting. */
  double
  figure(const Table       &table,
         const std::string &setting,
         const std::string &name,
         const std::string &column = "figure_value")
  {
    for (std::size_t i = 0; i < table.n_rows(); ++i)
      if (table.text(i, "setting") == setting &&
          table.text(i, "figure") == name)
        return table.is_missing(i, column) ? std::nan("missing")
                                           : table.real(i, column);
    check(false, "there is a rung " + setting + " with " + name);
    return 0.;
  }

  /** What the error of @p name on the coarse rung is measured by. */
  double
  figure_extent(const Table &table, const std::string &name)
  {
    return std::abs(figure(table, "degree = 1", name) -
                    figure(table, "degree = 2", name)) /
           figure(table, "degree = 1", name, "error_rel");
  }

  /** The rungs are the single runs with their settings, and errors those
   * against the finest one. */
  void
  check_transient_ladders()
  {
    const Outcome o = pressed({"Analysis = work precision",
                               "Work precision/Problem = transient",
                               "Work precision/Ladders = time step, cut-off",
                               "Work precision/Time steps = 1e-6, 4e-6, 2e-6",
                               "Work precision/Cut-offs = 10e3, 20e3"});
    check(o.code == 0, "transients are climbed: " + o.errors);
    const Table t       = read_csv("out/figure_errors.csv");
    const auto  leading = [&](const std::string &setting) {
      return figure(t, setting, "leading_edge_factor");
    };
    const double coarse = leading("time step = 4e-6"),
                 fine   = leading("time step = 1e-6");
    check(coarse != fine && fine > 0., "the step changes the result");
    check(std::abs(
            figure(t, "time step = 4e-6", "leading_edge_factor", "error_rel") -
            std::abs(coarse - fine) / fine) < 1e-9,
          "the smallest step is the reference, wherever it stands");
    check(
      figure(t, "cut-off = 20000", "leading_edge_factor", "error_rel") == 0. &&
        figure(t, "cut-off = 10000", "leading_edge_factor", "error_rel") > 0.,
      "the highest cut-off is the reference");
    check(figure(t, "time step = 1e-6", "worst_imbalance", "error_rel") ==
            figure(t, "time step = 1e-6", "worst_imbalance"),
          "the energy ledger is an error by itself");
    const Outcome single =
      pressed({"Analysis = transient", "Transient/Time step = 4e-6"});
    check(single.code == 0, "a single run: " + single.errors);
    const Table one = read_csv("out/transient.csv");
    for (const char *name : {"leading_edge_factor", "worst_imbalance"})
      check(std::abs(one.real(0, name) - figure(t, "time step = 4e-6", name)) <=
              1e-12 * std::abs(one.real(0, name)),
            "a rung is the run with its settings");
  }

  void
  check_preload_ladders()
  {
    const Outcome o = pressed({"Analysis = work precision",
                               "Work precision/Problem = steady sliding",
                               "Work precision/Ladders = degree",
                               "Work precision/Values = 2, 1"});
    check(o.code == 0, "steady sliding is climbed: " + o.errors);
    const Table t = read_csv("out/figure_errors.csv");
    check(std::abs(figure(t, "degree = 1", "tangential_n") - 50.) < 1e-6 &&
            figure(t, "degree = 1", "tangential_n", "error_rel") < 1e-9,
          "friction is that of the load on any mesh");
    check(figure(t, "degree = 1", "secant_stiffness_n_per_m", "error_rel") >
            1e-3,
          "elements of first degree are stiffer");
    // A position has no size of its own.
    const double extent = figure_extent(t, "centre_x_m");
    check(std::abs(extent - figure_extent(t, "centre_y_m")) < 1e-9 * extent &&
            extent > .01 && extent < .2,
          "positions are measured by the face: " + std::to_string(extent));
    check(pressed({"Analysis = preload", "Discretization/Degree = 1"}).code ==
            0,
          "a single run");
    const Table one = read_csv("out/preload.csv");
    check(std::abs(one.real(one.n_rows() - 1, "secant_stiffness_n_per_m") /
                     figure(t, "degree = 1", "secant_stiffness_n_per_m") -
                   1.) < 1e-9,
          "a rung is the run with its settings");
  }

  /** Frequencies of all ladders are those of complex pairs where one of them is
   * 'basis': on one mesh they differ by the basis alone, not by friction. */
  void
  check_ladders_of_one_mesh()
  {
    const std::vector<std::string> friction = {
      "Scene/Contact pad_disc/Formulation = mortar",
      "Scene/Contact pad_disc/Friction coefficient = 0.7",
      "Discretization/Estimate error = false"};
    const auto frequencies = [&](const std::string &analysis) {
      auto all = friction;
      all.push_back("Analysis = " + analysis);
      run(all);
      return read_csv(analysis == "cea" ? "out/eigenvalues.csv"
                                        : "out/modes.csv")
        .reals("frequency_hz");
    };
    const std::vector<double> undamped = frequencies("modes"),
                              pairs    = frequencies("cea");
    check(undamped.size() == pairs.size(), "as many modes as pairs");
    Worst shift;
    for (std::size_t i = 0; i < pairs.size(); ++i)
      shift.add(std::abs(pairs[i] / undamped[i] - 1.));
    check(shift.largest() > 1e-4,
          "friction shifts frequencies: " + listed({shift.largest()}));
    auto all = friction;
    all.insert(all.end(),
               {"Analysis = work precision",
                "Work precision/Ladders = adaptive, basis",
                "Work precision/Adaptive values = 1",
                "Work precision/Values = 1e-4, 1e-10"});
    run(all);
    const Table t = read_csv("out/work_precision.csv");
    for (std::size_t i = 0; i < t.n_rows(); ++i)
      check(t.real(i, "error_rel") < 1e-5 &&
              std::abs(t.real(i, "value") / pairs.front() - 1.) < 1e-6,
            t.text(i, "setting") + " has the pairs of its mesh");
    check(t.text(0, "reference") == "finest rung, same mesh" &&
            t.text(1, "reference") == "finest rung" &&
            t.text(2, "reference") == "itself",
          "what errors are against is told");
    const Table costs = read_csv("out/cost_at_error.csv");
    check(costs.text(0, "ladder") == "adaptive" &&
            costs.text(0, "found") == "not found" &&
            costs.text(1, "found") == "by every rung",
          "a rung on the mesh of the reference says nothing of the mesh");
  }

  void
  check_refused(const std::vector<std::string> &settings,
                const std::string              &expected)
  {
    std::vector<std::string> all = {"Analysis = work precision",
                                    "Work precision/Problem = transient",
                                    "Work precision/Values = 1, 2"};
    all.insert(all.end(), settings.begin(), settings.end());
    const Outcome o = pressed(all);
    check(o.code != 0 && o.errors.find(expected) != std::string::npos,
          "is refused with '" + expected + "': " + o.errors);
  }
} // namespace

int
main(int argc, char **argv)
{
  check(argc == 3, "usage: test_analyses_work_precision PROGRAM PRM_FOLDER");
  program = argv[1];
  folder  = argv[2];
  check_transient_ladders();
  check_preload_ladders();
  check_ladders_of_one_mesh();
  check_refused({"Work precision/Ladders = basis"}, "does not have");
  check_refused({"Work precision/Ladders = time step"},
                "'Work precision/Time steps' is empty");
  check_refused(
    {"Work precision/Ladders = cut-off", "Work precision/Cut-offs = 2e4"},
    "at least two");
  check_refused(
    {"Work precision/Ladders = degree", "Work precision/Reference = 1"},
    "its own finest rung");
  check_refused(
    {"Work precision/Ladders = degree", "Transient/Integrators = reduced"},
    "several runs");
  run({"Discretization/Degree = 1", "Discretization/Estimate error = false"});
  const Table               pairs = read_csv("out/eigenvalues.csv");
  const std::vector<double> sigma = pairs.reals("sigma_per_s");
  check(sigma.size() > 2, "some pairs are in the band");
  const Table same = ladder("1", "sigma", listed(sigma));
  check(same.real(0, "error_rel") < 1e-6,
        "real parts that are those of the rung have no error: " +
          std::to_string(same.real(0, "error_rel")));
  const Table larger = ladder("1", "sigma", listed(sigma, 1.1));
  check(std::abs(larger.real(0, "error_rel") - .1 / 1.1) < 1e-6,
        "a tenth more is the largest error over the largest real part: " +
          std::to_string(larger.real(0, "error_rel")));

  run({"Analysis = modes",
       "Discretization/Degree = 1",
       "Discretization/Estimate error = false"});
  const std::vector<double> f = read_csv("out/modes.csv").reals("frequency_hz");
  const Table higher          = ladder("1", "frequency", listed(f, 1.0001));
  check(std::abs(higher.real(0, "error_rel") - 1e-4 / 1.0001) < 1e-9,
        "frequencies are given in Hz: " +
          std::to_string(higher.real(0, "error_rel")));

  // Each number stands for a value of its own.
  const auto given = [](const std::string &numbers) {
    return run_program({program,
                        "--quiet",
                        "--set",
                        "Analysis = work precision",
                        "--set",
                        "Work precision/Ladders = degree",
                        "--set",
                        "Work precision/Values = 1",
                        "--set",
                        "Work precision/Reference = " + numbers,
                        "--set",
                        "Overwrite = true",
                        "brake.prm"});
  };
  const Outcome more = given(listed(f) + ", 1e3, 2e3, 3e3, 4e3");
  check(more.code != 0 &&
          more.errors.find("but the finest rung") != std::string::npos,
        "more numbers than values are refused: " + more.errors);
  const Outcome fewer = given("0.001");
  check(fewer.code == 0 &&
          text_of("out/run.log").find("says nothing of the others") !=
            std::string::npos,
        "one number for several values is told: " + fewer.errors);

  const Table own = ladder("2, 1", "eigenvalue", "");
  check(own.real(0, "error_rel") == 0. && own.real(1, "error_rel") > 1e-3,
        "the finest rung stands for the truth, wherever it stands");
}
