// SPDX-License-Identifier: LGPL-2.1-or-later

// Pictures of a campaign of transients beside the eigenvalue analyses.

#include <squeal/analyses/transient/campaign_table.h>
#include <squeal/results/chart.h>
#include <squeal/results/marked_series.h>
#include <squeal/run/campaign_runs.h>
#include <squeal/run/run_context.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace squeal
{
  namespace
  {
    void
    draw_comparison(RunContext &context, const Table &table, HtmlReport &report)
    {
      Chart chart;
      chart.title   = "Growth in time against the eigenvalue analysis";
      chart.x.label = "sigma of the whole model in 1/s";
      chart.y.label = "growth rate in time in 1/s";
      ChartSeries line;
      line.label               = "equal";
      line.style               = ChartSeries::Style::lines;
      line.ink                 = Ink::grey;
      double           ends[2] = {0., 0.};
      static const Ink inks[]  = {Ink::blue, Ink::vermillion, Ink::green};
      std::vector<ChartSeries> series;
      for (std::size_t i = 0; i < table.n_rows(); ++i)
        {
          const std::string top = table.text(i, "top");
          auto              s   = std::find_if(series.begin(),
                                series.end(),
                                [&](const auto &x) { return x.label == top; });
          if (s == series.end())
            {
              ChartSeries next;
              next.label = top;
              next.ink   = inks[series.size() % 3];
              s          = series.insert(series.end(), next);
            }
          const double x = table.real(i, "sigma_cea_per_s"),
                       y = table.real(i, "growth_rate_per_s");
          if (!std::isfinite(x) || !std::isfinite(y))
            continue;
          s->x.push_back(x);
          s->y.push_back(y);
          ends[0] = std::min({ends[0], x, y});
          ends[1] = std::max({ends[1], x, y});
        }
      line.x       = {ends[0], ends[1]};
      line.y       = line.x;
      chart.series = series;
      chart.series.push_back(line);
      context.output.file("plots/comparison.png");
      const std::string path = context.output.path() + "/plots/comparison";
      context.plotter.draw(draw_charts({chart}), path);
      report.section("Comparison");
      report.figure(
        path + ".png",
        "Growth rate in time over sigma of the whole model, both in "
        "1/s: a point for each run; on the line they are equal",
        true);
    }



    bool
    spans_a_decade(const Table &table, const std::string &column)
    {
      double low  = std::numeric_limits<double>::infinity(),
             high = -std::numeric_limits<double>::infinity();
      for (std::size_t i = 0; i < table.n_rows(); ++i)
        {
          low  = std::min(low, table.real(i, column));
          high = std::max(high, table.real(i, column));
        }
      return low > 0. && high >= 10. * low;
    }


    /** Where each way of looking finds growth, for one top. */
    Chart
    stability_chart(const Table           &table,
                    const std::string     &top,
                    const SceneParameters &scene,
                    const SweepParameters &sweep,
                    const bool             is_first)
    {
      Chart chart;
      chart.title = (top.empty() ? "" : "top " + top + ": ") + "unstable";
      const std::string &x = sweep.axes[0].name, &y = sweep.axes[1].name;
      chart.x.label    = shown_title(sweep.axes[0], scene);
      chart.y.label    = shown_title(sweep.axes[1], scene);
      chart.legend     = is_first ? Chart::Legend::above : Chart::Legend::none;
      using Marker     = ChartSeries::Marker;
      ChartSeries full = marked_series("full contact, linear",
                                       Marker::circle,
                                       4.5,
                                       Ink::blue,
                                       true),
                  real = marked_series("contact of steady sliding, linear",
                                       Marker::square,
                                       3.,
                                       Ink::green,
                                       true),
                  time = marked_series(
                    "in time", Marker::circle, 1.3, Ink::vermillion, false),
                  none = marked_series(
                    "stable in time", Marker::circle, .5, Ink::grey, false);
      const auto grows = [&](const std::size_t i, const std::string &column) {
        return table.real(i, column) > 0.;
      };
      for (std::size_t i = 0; i < table.n_rows(); ++i)
        if (table.text(i, "top") == top)
          for (auto &[s, shows] :
               {std::make_pair(&full, grows(i, "sigma_full_contact_per_s")),
                std::make_pair(&real, grows(i, "sigma_linear_per_s")),
                std::make_pair(&time, grows(i, "growth_rate_per_s")),
                std::make_pair(&none, !grows(i, "growth_rate_per_s"))})
            if (shows)
              {
                s->x.push_back(table.real(i, x));
                s->y.push_back(table.real(i, y));
              }
      if (!time.x.empty() && table.has_column("frequency_hz"))
        for (std::size_t i = 0; i < table.n_rows(); ++i)
          if (table.text(i, "top") == top && grows(i, "growth_rate_per_s"))
            time.names.push_back(
              std::isfinite(table.real(i, "frequency_hz"))
                ? rounded_text(1e-3 * table.real(i, "frequency_hz"), 3)
                : "");
      if (spans_a_decade(table, x))
        chart.x.scale = AxisSettings::Scale::logarithmic;
      chart.series = {full, real, time, none};
      return chart;
    }

    /** The stability map by full contact, by the contact of steady sliding and
     * in time: numbers are kHz of the limit cycle. */
    void
    draw_stability(RunContext &context, const Table &table, HtmlReport &report)
    {
      std::vector<std::string> tops;
      for (std::size_t i = 0; i < table.n_rows(); ++i)
        if (const std::string top = table.text(i, "top");
            std::find(tops.begin(), tops.end(), top) == tops.end())
          tops.push_back(top);
      std::vector<Chart> charts;
      for (const auto &top : tops)
        charts.push_back(stability_chart(table,
                                         top,
                                         context.parameters.scene,
                                         context.parameters.sweep,
                                         charts.empty()));
      if (charts.empty())
        return;
      context.output.file("plots/stability.png");
      const std::string path = context.output.path() + "/plots/stability";
      context.plotter.draw(
        draw_charts(charts, 1000, 420 * charts.size() + 180, 1), path);
      report.section("Where the motion grows");
      report.figure(
        path + ".png",
        "Points where the motion grows. Large circle: by the eigenvalues with "
        "the whole face in contact; square: by those about the contact of "
        "steady sliding; dot: in time, its number the frequency of the "
        "vibration in kHz; small dot: not in time",
        true);
    }
  } // namespace



  void
  draw_campaign(RunContext &context, const Table &table, HtmlReport &report)
  {
    const Parameters &p = context.parameters;
    if (p.transient.compare_with_cea)
      draw_comparison(context, table, report);
    else
      draw_amplitudes(context, table, report);
    if (p.sweep.axes.size() == 2)
      draw_stability(context, table, report);
  }
} // namespace squeal
