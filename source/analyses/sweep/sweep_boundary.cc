// SPDX-License-Identifier: LGPL-2.1-or-later

// The boundary of the unstable regions of two parameters.

#include <squeal/analyses/sweep/sweep_solution.h>
#include <squeal/parameters/entry_traits.h>
#include <squeal/results/chart.h>

#include <algorithm>
#include <cmath>

namespace squeal
{
  namespace
  {
    using Type = Table::Type;

    /** The range of @p other that continues @p range: nearest in frequency and
     * place; -1 where there is none. */
    int
    continuation(const UnstableRange              &range,
                 const std::vector<UnstableRange> &other,
                 const double                      length)
    {
      int    best     = -1;
      double distance = 0.5;
      for (std::size_t i = 0; i < other.size(); ++i)
        {
          // what diverges has no frequency
          const double larger =
            std::max({other[i].peak_frequency, range.peak_frequency, 1e-300});
          const double d =
            std::abs(other[i].peak_frequency - range.peak_frequency) / larger *
              10. +
            std::abs(other[i].lower - range.lower) / length;
          if (d < distance)
            {
              best     = i;
              distance = d;
            }
        }
      return best;
    }

    /** Largest distance of the edges of @p middle from the straight lines
     * between the other two, in shares of the range; 1 where ranges begin or
     * end. */
    double
    deviation(const SweepLine &a,
              const SweepLine &b,
              const SweepLine &middle,
              const double     length)
    {
      const double s =
        (middle.start[1] - a.start[1]) / (b.start[1] - a.start[1]);
      if (a.ranges.size() != b.ranges.size() ||
          a.ranges.size() != middle.ranges.size())
        return 1.;
      double worst = 0.;
      for (const auto &range : middle.ranges)
        {
          const int i = continuation(range, a.ranges, length);
          const int j = continuation(range, b.ranges, length);
          if (i < 0 || j < 0)
            return 1.;
          const auto line = [&](const double x, const double y) {
            return (1. - s) * x + s * y;
          };
          worst = std::max(
            {worst,
             std::abs(range.lower - line(a.ranges[i].lower, b.ranges[j].lower)),
             std::abs(range.upper -
                      line(a.ranges[i].upper, b.ranges[j].upper))});
        }
      return worst / length;
    }
  } // namespace



  Table
  boundary_table(SweepModel          &model,
                 const SweepSolution &solution,
                 RunContext          &context)
  {
    const SweepGrid &grid        = model.grid();
    const double     tolerance   = context.parameters.sweep.boundary_tolerance;
    const double     length      = grid.upper(0) - grid.lower(0);
    const double     height      = grid.upper(1) - grid.lower(1);
    std::vector<SweepLine> lines = solution.lines;
    std::sort(lines.begin(), lines.end(), [](const auto &a, const auto &b) {
      return a.start[1] < b.start[1];
    });
    SweepSolution added;
    for (std::size_t i = 0; i + 1 < lines.size();)
      {
        if (lines[i + 1].start[1] - lines[i].start[1] <= tolerance * height)
          {
            ++i;
            continue;
          }
        SweepPoint start    = lines[i].start;
        start[1]            = 0.5 * (lines[i].start[1] + lines[i + 1].start[1]);
        SweepLine    middle = solve_line(model, start, context, added);
        const double d      = deviation(lines[i], lines[i + 1], middle, length);
        lines.insert(lines.begin() + i + 1, std::move(middle));
        // Both halves are four times as straight.
        if (d <= 4. * tolerance)
          i += 2;
      }

    if (grid.n_states() > 1 && added.n_solved > 0)
      context.log.warning(
        "the lines that boundary.csv has between the values of " +
        grid.axis(1).name +
        " hold the contact states at the nearest value: more values tell the "
        "edges between");

    Table table(
      {{grid.axis(1).name, Type::real, "", grid.axis(1).entries[0], 6},
       {"frequency_hz", Type::real, "Hz", "at the peak of sigma", 6},
       {"lower_coordinate", Type::real, "", "sigma = 0", 7},
       {"upper_coordinate", Type::real, "", "sigma = 0", 7},
       {"at_lower_limit", Type::integer, "", "1: goes on below"},
       {"at_upper_limit", Type::integer, "", "1: goes on above"},
       {"peak_sigma_per_s", Type::real, "1/s", "largest sigma", 5},
       {"leaves_band_below",
        Type::integer,
        "",
        "1: goes on below, outside the frequency band"},
       {"leaves_band_above",
        Type::integer,
        "",
        "1: goes on above, outside the frequency band"}});
    for (const auto &line : lines)
      for (const auto &range : line.ranges)
        table.add_row({grid.value(1, line.start[1]),
                       range.peak_frequency,
                       range.lower,
                       range.upper,
                       range.at_lower_limit ? 1 : 0,
                       range.at_upper_limit ? 1 : 0,
                       range.peak_sigma,
                       range.leaves_band_below ? 1 : 0,
                       range.leaves_band_above ? 1 : 0});
    context.log.info(
      "  boundary of the unstable regions: " + std::to_string(lines.size()) +
      " lines, " + std::to_string(added.n_solved) +
      " solutions beside those of the grid");
    return table;
  }


  Chart
  boundary_chart(const SweepModel &model, const Table &boundary)
  {
    const SweepGrid &grid = model.grid();
    Chart            chart;
    chart.title   = "Boundary of the unstable regions";
    chart.x.label = (grid.is_logarithmic(0) ? "log10 of " : "") +
                    axis_title(grid.axis(0).entries, model.scene());
    chart.y.label = axis_title(grid.axis(1).entries, model.scene());
    chart.x.lower = grid.lower(0);
    chart.x.upper = grid.upper(0);
    std::vector<double> frequencies;
    for (std::size_t i = 0; i < boundary.n_rows(); ++i)
      {
        // Ranges of one kind have nearly one frequency.
        const double f = boundary.real(i, "frequency_hz");
        std::size_t  k = 0;
        while (k < frequencies.size() &&
               std::abs(f - frequencies[k]) > 0.06 * frequencies[k])
          ++k;
        if (k == frequencies.size())
          {
            frequencies.push_back(f);
            ChartSeries next;
            next.label       = "near " + rounded_text(f, 2) + " Hz";
            next.ink         = series_ink(k);
            next.marker      = static_cast<ChartSeries::Marker>(k % 4);
            next.marker_size = 0.8;
            chart.series.push_back(next);
          }
        frequencies[k] = f;
        for (const auto &[edge, side] :
             {std::pair<std::string, std::string>{"lower", "below"},
              {"upper", "above"}})
          if (boundary.integer(i, "at_" + edge + "_limit") == 0 &&
              boundary.integer(i, "leaves_band_" + side) == 0)
            {
              chart.series[k].x.push_back(
                boundary.real(i, edge + "_coordinate"));
              chart.series[k].y.push_back(boundary.real(i, grid.axis(1).name));
            }
      }
    return chart;
  }
} // namespace squeal
