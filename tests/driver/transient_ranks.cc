// SPDX-License-Identifier: LGPL-2.1-or-later

// A transient on one and on two ranks: the same history until a contact status
// changes, and the same statistics of the squeal after that. Arguments: mpirun,
// the program, the folder of parameter files.

#include "program.h"

#include <map>

using namespace squeal::testing;

namespace
{
  using Table = std::map<std::string, std::vector<double>>;

  /** The columns of a CSV file by their names; what is no number is 0. */
  Table
  table_of(const std::string &file)
  {
    std::istringstream       text(text_of(file));
    std::vector<std::string> names;
    Table                    table;
    for (std::string line; std::getline(text, line);)
      {
        if (line.empty() || line[0] == '#')
          continue;
        std::istringstream row(line);
        unsigned int       i = 0;
        for (std::string cell; std::getline(row, cell, ','); ++i)
          if (i == names.size())
            names.push_back(cell);
          else if (i < names.size())
            table[names[i]].push_back(std::strtod(cell.c_str(), nullptr));
      }
    check(!names.empty() && !table[names[0]].empty(), "rows in " + file);
    return table;
  }

  void
  run(const std::string &mpirun,
      const std::string &program,
      const std::string &folder,
      const std::string &ranks)
  {
    // The steady sliding of both is the same to some 1e-10 of the load, by the
    // rounding of the static solutions; that grows as the disturbance does.
    const Outcome outcome =
      run_program(coarse_transient({mpirun, "-np", ranks, program},
                                   folder,
                                   "ranks_" + ranks,
                                   {"Transient/Disturbance = 1e-6",
                                    "Transient/End time = 0.08",
                                    "Transient/Tolerance = 1e-12",
                                    "Preload/Tolerance = 1e-13"}));
    check(outcome.code == 0, "runs on " + ranks + " ranks: " + outcome.errors);
  }
} // namespace



int
main(int argc, char *argv[])
{
  check(argc == 4, "arguments: mpirun, program, folder");
  for (const std::string ranks : {"1", "2"})
    {
      std::filesystem::remove_all("ranks_" + ranks);
      run(argv[1], argv[2], argv[3], ranks);
    }
  Table a = table_of("ranks_1/forces.csv"), b = table_of("ranks_2/forces.csv");
  std::size_t n = 0;
  while (n < a["n_open"].size() && a["n_open"][n] == a["n_open"][0] &&
         a["n_stick"][n] == a["n_stick"][0])
    ++n;
  check(n > 200 && n < a["n_open"].size(),
        "a linear phase and changes of status");
  for (const char *name : {"normal_n", "tangential_n", "radial_n"})
    {
      double worst = 0.;
      for (std::size_t i = 0; i < n; ++i)
        worst = std::max(worst, std::abs(a[name][i] - b[name][i]) / 100.);
      std::ostringstream text;
      text << name << " until then: the same but for " << worst
           << " of the load";
      check(worst < 1e-8, text.str());
    }

  Table c           = table_of("ranks_1/transient.csv"),
        d           = table_of("ranks_2/transient.csv");
  const auto differ = [&](const std::string &name) {
    return std::abs(c[name].at(0) - d[name].at(0));
  };
  check(differ("growth_rate_per_s") < c["growth_rate_ci_per_s"].at(0),
        "growth rate within its interval");
  check(differ("limit_cycle_frequency_hz") <
          c["limit_cycle_frequency_ci_hz"].at(0) +
            d["limit_cycle_frequency_ci_hz"].at(0),
        "frequency of the limit cycle within its interval");
  for (const char *name : {"rms_normal_n",
                           "rms_tangential_n",
                           "macroscopic_friction",
                           "stick_fraction",
                           "leading_edge_factor"})
    check(differ(name) < .05 * std::abs(c[name].at(0)),
          std::string(name) + " within 5 %");
}
