// SPDX-License-Identifier: LGPL-2.1-or-later

// A transient on one and on two ranks: the same history until a contact status
// changes, and the same statistics of the squeal after that. Arguments: mpirun,
// the program, the folder of parameter files.

#include "program.h"
#include "worst.h"

#include <cmath>
#include <map>
#include <numeric>

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
                                    "Transient/End time = 0.04",
                                    "Transient/History start = 0.04",
                                    "Transient/Animation frames = 0",
                                    "Transient/Tolerance = 1e-12",
                                    "Preload/Tolerance = 1e-13"}));
    check(outcome.code == 0, "runs on " + ranks + " ranks: " + outcome.errors);
  }

  /** A mean over the second half of a series and the half width of its 95 %
   * interval by the scatter of eight parts of it (t of 7 degrees of freedom).
   * The parts last for some ten periods of the squeal, so that one knows little
   * of the next. */
  struct Mean
  {
    explicit Mean(const std::vector<double> &series)
    {
      constexpr std::size_t n    = 8;
      const std::size_t     half = series.size() / 2, length = half / n;
      std::vector<double>   means;
      for (std::size_t k = 0; k < n; ++k)
        {
          const auto first = series.end() - half + k * length;
          means.push_back(std::accumulate(first, first + length, 0.) / length);
          value += means.back() / n;
        }
      double squares = 0.;
      for (const double mean : means)
        squares += std::pow(mean - value, 2);
      half_width = 2.365 * std::sqrt(squares / (n - 1) / n);
    }

    double value = 0., half_width;
  };

  /** The statistics of the squeal that a history of forces has. */
  std::map<std::string, Mean>
  statistics(Table forces)
  {
    const double        normal = Mean(forces["normal_n"]).value;
    std::vector<double> squares, edge;
    for (std::size_t i = 0; i < forces["normal_n"].size(); ++i)
      {
        squares.push_back(std::pow(forces["normal_n"][i] - normal, 2));
        edge.push_back(forces["leading_edge_factor"][i] *
                       forces["normal_n"][i]);
      }
    return {{"normal force", Mean(forces["normal_n"])},
            {"tangential force", Mean(forces["tangential_n"])},
            {"variance of the normal force", Mean(squares)},
            {"open nodes", Mean(forces["n_open"])},
            {"sticking nodes", Mean(forces["n_stick"])},
            {"force at the leading edge", Mean(edge)}};
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
      Worst worst;
      for (std::size_t i = 0; i < n; ++i)
        worst.add(std::abs(a[name][i] - b[name][i]) / 100.);
      std::ostringstream text;
      text << name << " until then: the same but for " << worst.largest()
           << " of the load";
      check(worst.largest() < 1e-8, text.str());
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
  const auto of_a = statistics(a), of_b = statistics(b);
  for (const auto &[name, mean] : of_a)
    {
      const Mean        &other = of_b.at(name);
      std::ostringstream text;
      text << name << ": " << mean.value << " +- " << mean.half_width << " and "
           << other.value << " +- " << other.half_width;
      check(mean.half_width > 0. &&
              std::abs(mean.value - other.value) <=
                std::hypot(mean.half_width, other.half_width),
            text.str());
    }
}
