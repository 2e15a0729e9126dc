// SPDX-License-Identifier: LGPL-2.1-or-later

// The table of a campaign over two axes as a picture.

#include <squeal/analyses/limit_cycle/cycle_campaign.h>
#include <squeal/results/chart.h>
#include <squeal/results/html_report.h>
#include <squeal/results/marked_series.h>
#include <squeal/run/campaign_runs.h>
#include <squeal/run/run_context.h>

#include <algorithm>
#include <cmath>

namespace squeal
{
  namespace
  {
    /** How the outcomes look, in the order of the legend. */
    std::vector<ChartSeries>
    series_of_outcomes()
    {
      using Marker = ChartSeries::Marker;
      return {
        marked_series("steady sliding", Marker::circle, .6, Ink::grey, false),
        marked_series("steady sliding in the band, growth outside",
                      Marker::square,
                      1.,
                      Ink::grey,
                      false),
        marked_series(
          "stable limit cycle", Marker::circle, 2., Ink::blue, false),
        marked_series("stable limit cycle, left by the motion from it",
                      Marker::square,
                      2.,
                      Ink::blue,
                      true),
        marked_series(
          "several stable limit cycles", Marker::square, 2., Ink::blue, false),
        marked_series(
          "limit cycle, stable in time", Marker::circle, 2., Ink::green, false),
        marked_series(
          "limit cycle, stability open", Marker::circle, 2., Ink::blue, true),
        marked_series("unstable limit cycle that motions stay near",
                      Marker::circle,
                      2.,
                      Ink::vermillion,
                      true),
        marked_series("limit cycles found are unstable",
                      Marker::square,
                      2.,
                      Ink::vermillion,
                      true),
        marked_series("no period", Marker::square, 2., Ink::vermillion, false),
        marked_series(
          "no limit cycle found", Marker::circle, 2., Ink::orange, false)};
    }

    Chart
    map_of_top(const Table       &points,
               const std::string &top,
               const Parameters  &p,
               const bool         is_first)
    {
      const std::string &x = p.sweep.axes[0].name, &y = p.sweep.axes[1].name;
      Chart              chart;
      chart.title   = top.empty() ? "Limit cycles" : "top " + top;
      chart.x.label = shown_title(p.sweep.axes[0], p.scene);
      chart.y.label = shown_title(p.sweep.axes[1], p.scene);
      chart.legend  = is_first ? Chart::Legend::above : Chart::Legend::none;
      chart.series  = series_of_outcomes();
      double low = 1e300, high = 0.;
      for (std::size_t i = 0; i < points.n_rows(); ++i)
        {
          if (points.has_column("top") && points.text(i, "top") != top)
            continue;
          auto s = std::find_if(chart.series.begin(),
                                chart.series.end(),
                                [&](const ChartSeries &c) {
                                  return c.label == points.text(i, "outcome");
                                });
          // No point is left out, whatever it is called.
          if (s == chart.series.end())
            s = chart.series.insert(s,
                                    marked_series(points.text(i, "outcome"),
                                                  ChartSeries::Marker::square,
                                                  1.,
                                                  Ink::grey,
                                                  true));
          const double line = points.real(i, "dominant_line_hz");
          s->x.push_back(points.real(i, x));
          s->y.push_back(points.real(i, y));
          s->names.push_back(std::isfinite(line) ? rounded_text(1e-3 * line, 3)
                                                 : "");
          low  = std::min(low, points.real(i, x));
          high = std::max(high, points.real(i, x));
        }
      if (low > 0. && high >= 10. * low)
        chart.x.scale = AxisSettings::Scale::logarithmic;
      return chart;
    }
  } // namespace



  void
  draw_cycle_map(RunContext &context, const Table &points, HtmlReport &report)
  {
    std::vector<std::string> tops = context.parameters.transient.tops;
    if (tops.empty())
      tops.push_back("");
    std::vector<Chart> charts;
    for (const std::string &top : tops)
      charts.push_back(
        map_of_top(points, top, context.parameters, charts.empty()));
    context.output.file("plots/cycle_map.png");
    const std::string path = context.output.path() + "/plots/cycle_map";
    context.plotter.draw(
      draw_charts(charts, 1000, 420 * charts.size() + 180, 1), path);
    report.section("Outcomes");
    report.figure(path + ".png",
                  "What the growing pairs of each point lead to; numbers are "
                  "the kHz of the largest line of the cycle that is heard",
                  true);
  }
} // namespace squeal
