// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/analyses/triggers/trigger_charts.h>
#include <squeal/output/judged_force.h>
#include <squeal/results/chart.h>
#include <squeal/results/html_report.h>
#include <squeal/run/campaign_runs.h>
#include <squeal/run/run_context.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace squeal
{
  namespace
  {
    /** Panels of one picture. */
    constexpr std::size_t most_panels = 4;

    std::vector<std::string>
    points_of(const Table &table)
    {
      std::vector<std::string> result;
      for (std::size_t i = 0; i < table.n_rows(); ++i)
        if (const std::string point = table.text(i, "point");
            std::find(result.begin(), result.end(), point) == result.end())
          result.push_back(point);
      return result;
    }

    struct MotionLook
    {
      const char *motion, *label;
      Ink         ink;
      bool        is_dashed, is_line;
    };

    constexpr MotionLook motion_looks[] = {
      {"largest impulse", "after the largest impulse", Ink::orange, true, true},
      {"above", "above the threshold", Ink::vermillion, false, true},
      {"below", "below the threshold", Ink::blue, false, true},
      // Restarts break a line.
      {"edge, above", "on the edge, above", Ink::vermillion, false, false},
      {"edge, below", "on the edge, below", Ink::blue, false, false}};

    Chart
    motion_chart(const Table &motions, const std::string &point)
    {
      Chart chart;
      chart.title   = "Struck at " + point;
      chart.x.label = "time from the blow in ms";
      chart.y.label = rms_label(motions, {"judged_force"});
      chart.y.scale = AxisSettings::Scale::logarithmic;
      for (const MotionLook &look : motion_looks)
        {
          ChartSeries s;
          s.label       = look.label;
          s.ink         = look.ink;
          s.dashed      = look.is_dashed;
          s.hollow      = true;
          s.marker_size = 0.8;
          s.style       = look.is_line ? ChartSeries::Style::lines
                                       : ChartSeries::Style::points;
          for (std::size_t i = 0; i < motions.n_rows(); ++i)
            if (motions.text(i, "point") == point &&
                motions.text(i, "motion") == look.motion &&
                motions.real(i, "rms_normal_n") > 0.)
              {
                s.x.push_back(1e3 * motions.real(i, "time_s"));
                s.y.push_back(motions.real(i, "rms_normal_n"));
              }
          if (!s.x.empty())
            chart.series.push_back(s);
        }
      return chart;
    }

    /** The cells of @p column over the axis @p x, where they are there and the
     * threshold is known. */
    ChartSeries
    over_axis(const Table       &t,
              const std::string &x,
              const std::string &point,
              const std::string &column)
    {
      ChartSeries s;
      s.style = ChartSeries::Style::lines_points;
      for (std::size_t i = 0; i < t.n_rows(); ++i)
        if (t.text(i, "point") == point && !t.is_missing(i, column) &&
            t.text(i, "trigger_status") == "threshold")
          {
            s.x.push_back(t.real(i, x));
            s.y.push_back(t.real(i, column));
          }
      return s;
    }

    void
    show(RunContext               &context,
         const std::vector<Chart> &charts,
         const std::string        &name,
         const std::string        &caption,
         HtmlReport               &report)
    {
      context.output.file("plots/" + name + ".png");
      const std::string path = context.output.path() + "/plots/" + name;
      context.plotter.draw(
        draw_charts(charts, 1400, 600 * static_cast<int>(charts.size()) + 200),
        path);
      report.figure(path + ".png", caption);
    }
  } // namespace



  void
  draw_motions(RunContext &context, const Table &motions, HtmlReport &report)
  {
    std::vector<Chart> charts;
    for (const std::string &point : points_of(motions))
      if (charts.size() < most_panels)
        charts.push_back(motion_chart(motions, point));
    if (!charts.empty())
      show(context,
           charts,
           "triggers",
           "Motions after a blow either side of the threshold, and those that "
           "follow the edge between them, window by window",
           report);
  }

  void
  draw_branches(RunContext &context, const Table &triggers, HtmlReport &report)
  {
    const auto        &axis = context.parameters.sweep.axes.front();
    const std::string  x    = axis.name;
    std::vector<Chart> charts(2);
    charts[0].title = "Cycles and thresholds";
    charts[0].y.label =
      rms_label(triggers, {"squeal_judged_force", "unstable_judged_force"});
    charts[1].y.label = "smallest impulse in N s";
    for (Chart &chart : charts)
      chart.x.label = shown_title(axis, context.parameters.scene);
    const std::vector<std::string> points = points_of(triggers);
    for (std::size_t i = 0; i < points.size(); ++i)
      {
        ChartSeries squeal =
                      over_axis(triggers, x, points[i], "squeal_rms_normal_n"),
                    unstable = over_axis(
                      triggers, x, points[i], "unstable_rms_normal_n"),
                    impulse = over_axis(triggers, x, points[i], "impulse_ns");
        squeal.label        = i == 0 ? "after the largest blow, transient" : "";
        unstable.label      = i == 0 ? "unstable cycle on the edge" : "";
        impulse.label       = points[i];
        squeal.ink          = Ink::vermillion;
        unstable.ink        = Ink::blue;
        impulse.ink         = series_ink(i);
        unstable.hollow     = true;
        for (ChartSeries *s : {&squeal, &unstable})
          if (!s->x.empty())
            charts[0].series.push_back(*s);
        if (!impulse.x.empty())
          charts[1].series.push_back(impulse);
      }
    if (!charts[1].series.empty())
      show(context,
           charts,
           "branches",
           "The motion that the largest impulse ends in, the unstable cycle on "
           "the "
           "edge, and the smallest impulse that leads to squeal",
           report);
  }
} // namespace squeal
