// SPDX-License-Identifier: LGPL-2.1-or-later

// Amplitude of the limit cycles of a campaign over growth rate and sliding
// speed, the friction that is measured from outside, and ladders.

#include <squeal/analyses/transient/campaign_table.h>
#include <squeal/output/judged_force.h>
#include <squeal/parameters/entry_traits.h>
#include <squeal/results/chart.h>
#include <squeal/results/column_title.h>
#include <squeal/run/campaign_runs.h>
#include <squeal/run/run_context.h>

#include <algorithm>
#include <cmath>

namespace squeal
{
  namespace
  {
    /** Fewer points make no curve. */
    constexpr std::size_t least_points = 3;

    /** Least range of the normal force in squeal over its largest value. */
    constexpr double squeal_range = 0.05;

    bool
    is_speed(const SweepAxisParameters &axis)
    {
      const std::string end = "/Sliding speed";
      for (const auto &entry : axis.entries)
        if (entry.size() < end.size() ||
            entry.substr(entry.size() - end.size()) != end)
          return false;
      return !axis.entries.empty();
    }

    /** Whether it says how finely the runs compute. */
    bool
    is_ladder(const SweepAxisParameters &axis)
    {
      return std::all_of(
        axis.entries.begin(), axis.entries.end(), &is_resolution_entry);
    }

    /** The values of all axes but @p left_out and the top: what tells one
     * curve from another. */
    std::string
    curve_name(const Table                            &table,
               const std::size_t                       row,
               const std::vector<SweepAxisParameters> &axes,
               const std::string                      &left_out)
    {
      std::string name;
      for (const auto &axis : axes)
        if (axis.name != left_out)
          name += (name.empty() ? "" : ", ") +
                  ColumnTitle(table.columns()[table.column_index(axis.name)])
                    .with(table.real(row, axis.name));
      const std::string top = table.text(row, "top");
      return name + (name.empty() || top.empty() ? "" : ", ") + top;
    }

    /** Column @p y over column @p x of the rows that @p shows lets through, one
     * series for each name. Returns the number of points. */
    template <typename Shows, typename Name>
    std::size_t
    fill(Chart             &chart,
         const Table       &table,
         const std::string &x,
         const std::string &y,
         const Shows       &shows,
         const Name        &name)
    {
      std::size_t n = 0;
      for (std::size_t i = 0; i < table.n_rows(); ++i)
        {
          const double a = table.real(i, x), b = table.real(i, y);
          if (!shows(i) || !std::isfinite(a) || !std::isfinite(b))
            continue;
          const std::string label = name(i);
          auto              s =
            std::find_if(chart.series.begin(),
                         chart.series.end(),
                         [&](const auto &c) { return c.label == label; });
          if (s == chart.series.end())
            {
              ChartSeries next;
              next.label = label;
              next.ink   = series_ink(chart.series.size());
              s          = chart.series.insert(chart.series.end(), next);
            }
          s->x.push_back(a);
          s->y.push_back(b);
          ++n;
        }
      if (chart.series.size() < 2)
        chart.legend = Chart::Legend::none;
      return n;
    }

    void
    draw(RunContext               &context,
         const std::string        &name,
         const std::vector<Chart> &charts,
         const std::string        &caption,
         HtmlReport               &report)
    {
      context.output.file("plots/" + name + ".png");
      const std::string path = context.output.path() + "/plots/" + name;
      context.plotter.draw(draw_charts(charts, 1100, 200 + 500 * charts.size()),
                           path);
      report.figure(path + ".png", caption, true);
    }

    /** Growth rate and amplitude over how finely the runs compute. */
    void
    draw_ladder(RunContext                &context,
                const Table               &table,
                const SweepAxisParameters &axis,
                HtmlReport                &report)
    {
      const auto name = [&](const std::size_t i) {
        return curve_name(table, i, context.parameters.sweep.axes, axis.name);
      };
      const auto        all = [](const std::size_t) { return true; };
      Chart             growth, amplitude;
      const std::string over = shown_title(axis, context.parameters.scene);
      growth.title           = "Growth rate over " + over;
      growth.y.label         = "growth rate in 1/s";
      amplitude.title        = "Vibration over " + over;
      amplitude.y.label      = rms_label(table, {"judged_force"});
      for (Chart *chart : {&growth, &amplitude})
        chart->x.label = over;
      const std::size_t n =
        fill(growth, table, axis.name, "growth_rate_per_s", all, name);
      fill(amplitude, table, axis.name, "rms_normal_n", all, name);
      for (Chart *chart : {&growth, &amplitude})
        for (auto &s : chart->series)
          s.style = ChartSeries::Style::lines_points;
      amplitude.legend = Chart::Legend::none;
      if (n > 1)
        draw(context,
             "over_" + axis.name,
             {growth, amplitude},
             "Growth rate, and vibration in the second half of each run, over "
             "how finely the runs compute",
             report);
    }
  } // namespace



  void
  draw_amplitudes(RunContext &context, const Table &table, HtmlReport &report)
  {
    const auto &axes = context.parameters.sweep.axes;
    // What rings on slowly looks steady, but is small.
    const auto runs = [&](const std::size_t i) {
      // Two rms are no more than a range, but that of a moment or a node that
      // is judged.
      const double largest = std::abs(table.real(i, "max_normal_n"));
      return table.text(i, "limit_cycle") == "yes" &&
             (table.real(i, "max_normal_n") - table.real(i, "min_normal_n") >
                squeal_range * largest ||
              2. * table.real(i, "rms_normal_n") >
                squeal_range * table.real(i, "judged_share") * largest);
    };
    Chart over_sigma;
    over_sigma.title   = "Amplitude of the limit cycle over growth rate";
    over_sigma.x.label = "largest sigma about steady sliding in 1/s";
    over_sigma.y.label = rms_label(table, {"judged_force"});
    over_sigma.y.lower = 0.;
    over_sigma.lines   = {{true, 0., "", Ink::grey, true}};
    report.section("Limit cycles");
    // Rungs of a ladder have one growth rate but for their errors.
    if (std::none_of(axes.begin(), axes.end(), &is_ladder) &&
        fill(over_sigma,
             table,
             "sigma_linear_per_s",
             "rms_normal_n",
             runs,
             [&](const std::size_t i) {
               return curve_name(
                 table, i, axes, axes.empty() ? "" : axes.front().name);
             }) >= least_points)
      draw(context,
           "amplitude_over_sigma",
           {over_sigma},
           "Amplitude of the limit cycles over the growth rate about steady "
           "sliding",
           report);
    for (const auto &axis : axes)
      {
        if (is_ladder(axis))
          draw_ladder(context, table, axis, report);
        if (!is_speed(axis))
          continue;
        const auto name = [&](const std::size_t i) {
          return curve_name(table, i, axes, axis.name);
        };
        const auto all = [](const std::size_t) { return true; };
        Chart      amplitude, friction;
        amplitude.title   = "Vibration over sliding speed";
        amplitude.x.label = "sliding speed in m/s";
        amplitude.y.label = rms_label(table, {"judged_force"});
        amplitude.y.lower = 0.;
        friction.title    = "Macroscopic friction over sliding speed";
        friction.x.label  = "sliding speed in m/s";
        friction.y.label  = "mean tangential over mean normal force";
        for (Chart *chart : {&amplitude, &friction})
          if (axis.scale == SweepAxisParameters::Scale::logarithmic)
            chart->x.scale = AxisSettings::Scale::logarithmic;
        const std::size_t n_amplitudes =
          fill(amplitude, table, axis.name, "rms_normal_n", all, name);
        const std::size_t n_frictions =
          fill(friction, table, axis.name, "macroscopic_friction", all, name);
        for (Chart *chart : {&amplitude, &friction})
          for (auto &s : chart->series)
            s.style = ChartSeries::Style::lines_points;
        friction.legend = Chart::Legend::none;
        if (std::min(n_amplitudes, n_frictions) >= least_points)
          draw(context,
               "over_" + axis.name,
               {amplitude, friction},
               "Vibration and macroscopic friction coefficient, second half of "
               "each run, over the sliding speed",
               report);
      }
  }
} // namespace squeal
