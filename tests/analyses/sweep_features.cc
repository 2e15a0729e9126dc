// SPDX-License-Identifier: LGPL-2.1-or-later

// Sweeps by the program on a coarse TriboBrake: the same on one and two ranks,
// changes that stop squeal hold in the full model, a mesh for each radius.
// Arguments: mpirun, the program and "ranks" or "features".

#include <squeal/results/table.h>

#include "program.h"
#include "source_directory.h"
#include "worst.h"

#include <cmath>
#include <filesystem>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  const std::vector<std::string> coarse = {
    "Scene/Body disc/Cells = 16, 3, 1",
    "Scene/Body pad/Cells = 2, 2, 2",
    "Scene/Body support/Cells = 2, 2, 6",
    "Sweep/Axis e_pad/Number = 15",
    // the pair of 5 kHz
    "Eigenvalues/Lowest frequency = 4400",
    "Eigenvalues/Highest frequency = 5600",
    "Output/Plots = false",
    "Output/Report = false",
    "Overwrite = true"};

  Outcome
  run(const std::vector<std::string> &command,
      const std::string              &file,
      const std::string              &directory,
      std::vector<std::string>        settings)
  {
    // What an earlier run has left, such as its basis, must not serve.
    std::filesystem::remove_all(directory);
    std::vector<std::string> all = command;
    settings.insert(settings.begin(), coarse.begin(), coarse.end());
    settings.push_back("Output directory = " + directory);
    for (const auto &setting : settings)
      {
        all.push_back("--set");
        all.push_back(setting);
      }
    all.push_back(SQUEAL_SOURCE_DIR "/prm/tribobrake/" + file);
    const Outcome o = run_program(all);
    check(o.code == 0, file + " ends well: " + o.errors);
    return o;
  }

  void
  compare(const std::string              &file,
          const std::string              &a,
          const std::string              &b,
          const std::vector<std::string> &columns,
          const double                    tolerance)
  {
    const Table one = read_csv(a + "/" + file), two = read_csv(b + "/" + file);
    check(one.n_rows() > 0 && one.n_rows() == two.n_rows(),
          file + ": " + std::to_string(one.n_rows()) + " rows in both");
    for (const auto &column : columns)
      {
        Worst worst;
        for (std::size_t i = 0; i < one.n_rows(); ++i)
          {
            // A missing value would leave the largest as it is.
            check(!one.is_missing(i, column) && !two.is_missing(i, column),
                  file + ", " + column + ": a number in both");
            worst.add(std::abs(one.real(i, column) - two.real(i, column)) /
                      std::max(1., std::abs(one.real(i, column))));
          }
        check(worst.largest() <= tolerance,
              file + ", " + column + ": " + std::to_string(worst.largest()));
      }
  }

  void
  changes_hold(const std::string &directory)
  {
    const Table  table  = read_csv(directory + "/suggestions.csv");
    unsigned int n_best = 0;
    for (std::size_t i = 0; i < table.n_rows(); ++i)
      if (table.text(i, "verdict") == "stable")
        {
          ++n_best;
          check(table.real(i, "direct_sigma_per_s") < 0. &&
                  table.real(i, "sigma_per_s") > 0.,
                table.text(i, "entry") + " by " +
                  table.text(i, "change_percent") + " %: no pair squeals");
          check(std::abs(table.real(i, "change_percent")) <= 50.,
                "within Largest change");
        }
    check(n_best > 0, "a change that holds: " + std::to_string(n_best));
  }

  /** The same radius as a value of an axis and as the scene's own. */
  void
  radius(const std::string &program)
  {
    std::vector<std::string> settings = {"Scene/Body disc/Cells = 12, 2, 1",
                                         "Scene/Body pad/Cells = 1, 1, 1",
                                         "Scene/Body support/Cells = 1, 1, 6",
                                         "Sweep/Axis e_pad/From = 10^10.1",
                                         "Sweep/Axis e_pad/To = 10^10.4",
                                         "Sweep/Axis e_pad/Number = 6",
                                         "Sweep/Axis mu/Values = 0.5"};
    run({program}, "zones.prm", "alone", settings);
    settings.push_back("Sweep/Axis radius/Number = 3");
    run({program}, "pad_radius.prm", "radii", settings);
    const Table all = read_csv("radii/unstable_ranges.csv"),
                one = read_csv("alone/unstable_ranges.csv");
    std::size_t n   = 0;
    for (std::size_t i = 0; i < all.n_rows(); ++i)
      {
        // The middle of the axis is where the scene's pad stands.
        if (!(std::abs(all.real(i, "radius") - 0.1075) <= 1e-9))
          continue;
        check(n < one.n_rows() &&
                std::abs(all.real(i, "lower_coordinate") -
                         one.real(n, "lower_coordinate")) < 1e-4,
              "edge " + all.text(i, "lower_coordinate") + " as alone");
        ++n;
      }
    check(n > 0 && n == one.n_rows(), "all ranges of the one radius");
    check(all.n_rows() > n, "and ranges of the others");
  }

  /** About the contact that steady sliding leaves closed at each point, which
   * has no residual of the full problem but an error. */
  void
  preload(const std::string &program)
  {
    run({program},
        "stability_map_preload.prm",
        "about_preload",
        {"Sweep/Axis e_pad/Number = 9",
         "Sweep/Axis mu/Values = 0.3",
         "Sweep/Direct checks = 1"});
    const Table table  = read_csv("about_preload/eigenvalues.csv");
    std::size_t n_open = 0;
    Worst       error;
    for (std::size_t i = 0; i < table.n_rows(); ++i)
      {
        n_open +=
          table.integer(i, "closed_points") < table.integer(0, "closed_points");
        check(table.is_missing(i, "residual_rel"), "a residual is not formed");
        error.add(table.real(i, "error_estimate_rel"));
      }
    check(table.n_rows() > 9 && n_open > 0,
          "points of the contact open as the pad becomes stiffer");
    check(error.largest() <= 1e-6,
          "every pair has its error: " + std::to_string(error.largest()));
  }

  void
  same_on_two_ranks(const std::string &mpirun, const std::string &program)
  {
    const std::vector<std::string> settings = {
      "Sweep/Suggestions = 2",
      "Sweep/Sensitivities = Scene/Body pad/Young modulus, Scene/Contact "
      "pad_disc/Friction coefficient, Scene/Body disc/Density, "
      "Scene/Damping/Stiffness damping",
      "Sweep/Axis mu/Values = 0.3, 0.5",
      "Sweep/Axis e_pad/From = 10^10.2",
      "Sweep/Axis e_pad/To = 10^10.6",
      "Sweep/Axis e_pad/Number = 7"};
    for (const std::string ranks : {"1", "2"})
      run({mpirun, "-np", ranks, program},
          "what_to_change.prm",
          "ranks_" + ranks,
          settings);
    compare("eigenvalues.csv", "ranks_1", "ranks_2", {"frequency_hz"}, 1e-8);
    // 1e-8 of |lambda| at 5 kHz.
    compare("eigenvalues.csv", "ranks_1", "ranks_2", {"sigma_per_s"}, 3e-4);
    compare("unstable_ranges.csv",
            "ranks_1",
            "ranks_2",
            {"lower_coordinate", "upper_coordinate"},
            2e-5);
    changes_hold("ranks_1");
  }
} // namespace



int
main(int argc, char **argv)
{
  check(argc == 4, "arguments: mpirun, program, which");
  const std::string which = argv[3];
  check(which == "ranks" || which == "features", "ranks or features");
  if (which == "ranks")
    same_on_two_ranks(argv[1], argv[2]);
  else
    {
      radius(argv[2]);
      preload(argv[2]);
    }
}
