// SPDX-License-Identifier: LGPL-2.1-or-later

// What to change to stop a squeal.

#include <squeal/driver/sweep_solution.h>
#include <squeal/sweep/sensitivity.h>

#include <algorithm>
#include <cmath>

namespace squeal
{
  namespace
  {
    using Type = Table::Type;

    struct Influence
    {
      std::string entry;
      double      value, sigma, frequency;
    };
  } // namespace



  Table
  sensitivity_table(const SweepModel    &model,
                    const SweepSolution &solution,
                    RunContext          &context)
  {
    Timers::Section  section(context.timers, "Solve: sensitivities");
    const SweepGrid &grid = model.grid();
    Table            table;
    for (unsigned int a = 1; a < grid.n_axes(); ++a)
      table.add_column(
        {grid.axis(a).name, Type::real, "", grid.axis(a).entries[0], 5});
    for (const Table::Column &column : std::vector<Table::Column>{
           {"branch", Type::text, "", "unstable branch"},
           {"coordinate", Type::real, "", "of its peak on the first axis", 6},
           {"frequency_hz", Type::real, "Hz", "there", 6},
           {"sigma_per_s", Type::real, "1/s", "there", 5},
           {"rank", Type::integer, "", "1: the most influential"},
           {"entry", Type::text, "", "number of the scene"},
           {"value", Type::real, "", "of the entry, SI units", 5},
           {"dsigma_per_percent",
            Type::real,
            "1/s",
            "for one per cent more",
            4},
           {"dfrequency_per_percent",
            Type::real,
            "Hz",
            "for one per cent more",
            4},
           {"percent_to_zero",
            Type::real,
            "",
            "change that would bring sigma to 0 if it went on like this",
            3}})
      table.add_column(column);
    std::vector<std::string> entries = grid.entries();
    entries.insert(
      entries.end(), grid.other_entries().begin(), grid.other_entries().end());
    const auto &wanted = context.parameters.sweep.sensitivities;
    for (const auto &line : solution.lines)
      for (const auto &range : line.ranges)
        {
          SweepPoint point = line.start;
          point[0]         = range.peak_at;
          const ComplexPairs pairs =
            solve_point_refined(model.reduced(),
                                point,
                                model.system().coefficients(point),
                                model.band());
          int    pair = -1;
          double best = 1e300;
          for (unsigned int i = 0; i < pairs.size(); ++i)
            if (const double d = std::hypot(
                  pairs.sigma(i) - range.peak_sigma,
                  2. * M_PI * (pairs.frequency(i) - range.peak_frequency));
                d < best)
              {
                best = d;
                pair = i;
              }
          if (pair < 0)
            continue;
          std::vector<Influence> influences;
          for (unsigned int e = 0; e < entries.size(); ++e)
            {
              if (std::find(wanted.begin(), wanted.end(), entries[e]) ==
                  wanted.end())
                continue;
              const std::complex<double> d = sensitivities(
                model.reduced(), model.system(), point, pairs, e)[pair];
              influences.push_back({entries[e],
                                    grid.entry_value(point, e),
                                    0.01 * d.real(),
                                    0.01 * d.imag() / (2. * M_PI)});
            }
          std::stable_sort(influences.begin(),
                           influences.end(),
                           [](const auto &a, const auto &b) {
                             return std::abs(a.sigma) > std::abs(b.sigma);
                           });
          for (std::size_t k = 0; k < influences.size(); ++k)
            {
              std::vector<Cell> row;
              for (unsigned int a = 1; a < grid.n_axes(); ++a)
                row.emplace_back(grid.value(a, line.start[a]));
              const Influence &f = influences[k];
              row.insert(
                row.end(),
                {line.branch_names[range.branch],
                 range.peak_at,
                 pairs.frequency(pair),
                 pairs.sigma(pair),
                 k + 1,
                 f.entry,
                 f.value,
                 f.sigma,
                 f.frequency,
                 f.sigma == 0. ? Cell() : Cell(-pairs.sigma(pair) / f.sigma)});
              table.add_row(row);
            }
        }
    return table;
  }
} // namespace squeal
