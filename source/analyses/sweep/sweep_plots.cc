// SPDX-License-Identifier: LGPL-2.1-or-later

// Charts of a sweep: frequency and sigma against the parameter, loci, the map
// of unstable ranges, the errors of the basis.

#include <squeal/analyses/sweep/sweep_solution.h>
#include <squeal/base/worst_of.h>
#include <squeal/eigen/unstable_pair.h>
#include <squeal/parameters/entry_traits.h>
#include <squeal/results/chart.h>
#include <squeal/results/frequency_unit.h>

#include <algorithm>
#include <cmath>

namespace squeal
{
  namespace
  {
    using Style  = ChartSeries::Style;
    using Marker = ChartSeries::Marker;

    constexpr std::size_t most_panels = 9;
    // Lines of more points have no markers.
    constexpr std::size_t most_marked = 40;

    ChartSeries
    series(const std::string &label,
           const Ink          ink,
           const Style        style,
           const Marker       marker = Marker::circle)
    {
      ChartSeries s;
      s.label       = label;
      s.ink         = ink;
      s.style       = style;
      s.marker      = marker;
      s.marker_size = style == Style::lines ? 1. : 0.9;
      return s;
    }

    std::string
    axis_label(const SweepModel &model, const unsigned int a)
    {
      const std::string title =
        axis_title(model.grid().axis(a).entries, model.scene());
      return model.grid().is_logarithmic(a) ? "log10 of " + title : title;
    }

    std::string
    line_title(const SweepModel &model, const SweepLine &line)
    {
      std::string text;
      for (unsigned int a = 1; a < model.grid().n_axes(); ++a)
        text += (a > 1 ? ", " : "") + model.grid().axis(a).name + " = " +
                rounded_text(model.grid().value(a, line.start[a]), 3);
      return text;
    }

    int
    n_branches(const SweepLine &line)
    {
      return line.branch_names.size();
    }

    const Ink branch_inks[] = {Ink::vermillion,
                               Ink::blue,
                               Ink::green,
                               Ink::orange,
                               Ink::purple,
                               Ink::sky,
                               Ink::black};

    /** Of all lines, which one picture shows. */
    FrequencyUnit
    unit_of(const SweepSolution &solution)
    {
      double highest = 0.;
      for (const SweepLine &line : solution.lines)
        for (const auto &p : line.points)
          for (unsigned int i = 0; i < p.pairs.size(); ++i)
            highest = std::max(highest, p.pairs.frequency(i));
      return FrequencyUnit(highest);
    }

    /** Frequency of every branch; what is unstable is marked, with the peaks of
     * ranges, which are often narrower than the grid. */
    Chart
    frequency_chart(const SweepModel    &model,
                    const SweepLine     &line,
                    const FrequencyUnit &unit)
    {
      Chart chart;
      chart.title   = line_title(model, line);
      chart.x.label = axis_label(model, 0);
      chart.y.label = unit.label;
      ChartSeries unstable =
        series("unstable", Ink::vermillion, Style::points, Marker::triangle);
      for (int b = 0; b < n_branches(line); ++b)
        {
          ChartSeries s = series("", Ink::blue, Style::lines);
          for (const auto &p : line.points)
            if (const int i = p.pair_of(b); i >= 0)
              {
                s.x.push_back(p.coordinate);
                s.y.push_back(unit.factor * p.pairs.frequency(i));
                if (p.asked && is_unstable(p.pairs, i))
                  {
                    unstable.x.push_back(s.x.back());
                    unstable.y.push_back(s.y.back());
                  }
              }
          if (s.x.size() > 1)
            chart.series.push_back(s);
        }
      for (const UnstableRange &range : line.ranges)
        {
          unstable.x.push_back(range.peak_at);
          unstable.y.push_back(unit.factor * range.peak_frequency);
        }
      if (!unstable.x.empty())
        chart.series.push_back(unstable);
      return chart;
    }

    /** Branches that are unstable somewhere on the line, each by its name. */
    std::vector<int>
    unstable_branches(const SweepLine &line)
    {
      std::vector<int> result;
      for (const auto &range : line.ranges)
        if (std::find(result.begin(), result.end(), range.branch) ==
            result.end())
          result.push_back(range.branch);
      return result;
    }

    Chart
    sigma_chart(const SweepModel &model, const SweepLine &line)
    {
      Chart chart;
      chart.title    = line_title(model, line);
      chart.x.label  = axis_label(model, 0);
      chart.y.label  = "sigma in 1/s";
      chart.lines    = {{false, 0., "", Ink::black, false}};
      unsigned int k = 0;
      for (const int b : unstable_branches(line))
        {
          ChartSeries s =
            series(line.branch_names[b],
                   branch_inks[k++ % 7],
                   line.points.size() > most_marked ? Style::lines
                                                    : Style::lines_points);
          for (const auto &p : line.points)
            if (const int i = p.pair_of(b); i >= 0)
              {
                s.x.push_back(p.coordinate);
                s.y.push_back(p.pairs.sigma(i));
              }
          chart.series.push_back(s);
        }
      if (chart.series.empty())
        {
          // What damps least, in its place.
          ChartSeries s =
            series("largest, no unstable range", Ink::grey, Style::lines);
          double size = 0.;
          for (const auto &p : line.points)
            if (p.pairs.size() > 0)
              {
                s.x.push_back(p.coordinate);
                s.y.push_back(p.pairs.lambda.real().maxCoeff());
                size = worst_of(size, std::abs(s.y.back()));
              }
          // Undamped pairs have nothing but rounding.
          if (!(size > growth_as_good_as_zero * model.band().highest))
            {
              chart.y.lower = -1.;
              chart.y.upper = 1.;
            }
          chart.x.lower = model.grid().lower(0);
          chart.x.upper = model.grid().upper(0);
          chart.series.push_back(s);
        }
      return chart;
    }

    /** Paths of the branches that become unstable in the plane of lambda. */
    Chart
    locus_chart(const SweepModel    &model,
                const SweepLine     &line,
                const FrequencyUnit &unit)
    {
      Chart chart;
      chart.title   = line_title(model, line);
      chart.x.label = "sigma in 1/s";
      chart.y.label = unit.label;
      chart.lines   = {{true, 0., "", Ink::black, false}};
      Strip growth;
      growth.lower   = 0.;
      chart.strips   = {growth};
      unsigned int k = 0;
      for (const auto &e : line.exceptional)
        for (const int b : {e.branch_1, e.branch_2})
          {
            const bool is_drawn =
              std::any_of(chart.series.begin(),
                          chart.series.end(),
                          [&](const ChartSeries &s) {
                            return s.label == line.branch_names[b];
                          });
            if (is_drawn)
              continue;
            ChartSeries s =
              series(line.branch_names[b], branch_inks[k++ % 7], Style::lines);
            for (const auto &p : line.points)
              if (const int i = p.pair_of(b); i >= 0)
                {
                  s.x.push_back(p.pairs.sigma(i));
                  s.y.push_back(unit.factor * p.pairs.frequency(i));
                }
            chart.series.push_back(s);
          }
      if (chart.series.size() > 6)
        chart.legend = Chart::Legend::none;
      return chart;
    }

    /** Unstable ranges of all lines over the second axis. */
    Chart
    map_chart(const SweepModel &model, const SweepSolution &solution)
    {
      Chart chart;
      chart.title   = "Unstable ranges";
      chart.x.label = axis_label(model, 0);
      chart.y.label = axis_label(model, 1);
      chart.x.lower = model.grid().lower(0);
      chart.x.upper = model.grid().upper(0);
      struct Group
      {
        double      frequency;
        ChartSeries series; /**< how its ranges are drawn */
        bool        is_named = false;
      };
      std::vector<Group> groups;
      for (const auto &line : solution.lines)
        for (const auto &range : line.ranges)
          {
            // Ranges of one kind have nearly one frequency.
            Group *group = nullptr;
            for (auto &g : groups)
              if (std::abs(g.frequency - range.peak_frequency) <
                  0.05 * g.frequency)
                group = &g;
            if (!group)
              {
                groups.push_back(
                  {range.peak_frequency,
                   series("near " + rounded_text(range.peak_frequency, 2) +
                            " Hz",
                          branch_inks[groups.size() % 7],
                          Style::lines_points,
                          static_cast<Marker>(groups.size() % 4))});
                group = &groups.back();
              }
            // A small shift keeps ranges that overlap apart.
            const double y = model.grid().value(1, line.start[1]) +
                             0.012 *
                               (model.grid().upper(1) - model.grid().lower(1)) *
                               (group - groups.data());
            ChartSeries piece = group->series;
            piece.x           = {range.lower, range.upper};
            piece.y           = {y, y};
            if (group->is_named)
              piece.label = "";
            group->is_named = true;
            chart.series.push_back(piece);
          }
      return chart;
    }

    /** Over the number of vectors, and over CPU seconds. */
    std::vector<Chart>
    basis_charts(const std::vector<BasisRound> &rounds,
                 const SweepParameters         &p)
    {
      std::vector<Chart> charts(2);
      charts[0].title   = "Greedy basis";
      charts[0].x.label = "vectors";
      charts[1].title   = "Error against work";
      charts[1].x.label = "CPU seconds of the basis";
      for (Chart &chart : charts)
        {
          const bool  is_work = &chart == &charts[1];
          ChartSeries f =
            series("frequency, relative", Ink::blue, Style::lines_points);
          ChartSeries s = series(
            "sigma, 1/s", Ink::vermillion, Style::lines_points, Marker::square);
          for (const auto &round : rounds)
            {
              const double x = is_work ? round.cpu_seconds : round.basis_size;
              f.x.push_back(x);
              f.y.push_back(round.worst.frequency);
              s.x.push_back(x);
              s.y.push_back(round.worst.sigma);
            }
          chart.y.label = "worst estimated error in the box";
          chart.y.scale = AxisSettings::Scale::logarithmic;
          chart.series  = {f, s};
          chart.lines   = {
              {false, p.frequency_tolerance, "tolerance of frequency", Ink::blue},
              {false, p.sigma_tolerance, "tolerance of sigma", Ink::vermillion}};
        }
      return charts;
    }
  } // namespace



  void
  draw_sweep(const SweepModel              &model,
             const SweepSolution           &solution,
             const std::vector<ChartGroup> &others,
             const std::string             &scene,
             const std::string             &title,
             RunContext                    &context,
             HtmlReport                    &report)
  {
    if (!context.is_root)
      return;
    const auto draw = [&](const std::string        &kind,
                          const std::string        &text,
                          const std::vector<Chart> &charts) {
      const std::string name    = kind + (scene.empty() ? "" : "_" + scene);
      const std::string caption = text + (title.empty() ? "" : "; " + title);
      context.output.file("plots/" + name + ".png");
      const std::string  path      = context.output.path() + "/plots/" + name;
      const unsigned int n_columns = charts.size() > 4   ? 3
                                     : charts.size() > 1 ? 2
                                                         : 1;
      const unsigned int n_rows = (charts.size() + n_columns - 1) / n_columns;
      context.plotter.draw(
        draw_charts(charts, 900 * n_columns, 650 * n_rows, n_columns), path);
      report.figure(path + ".png", caption, n_columns == 1);
    };
    const FrequencyUnit unit = unit_of(solution);
    std::vector<Chart>  frequencies, sigmas, loci;
    for (const auto &line : solution.lines)
      {
        if (frequencies.size() == most_panels)
          break;
        frequencies.push_back(frequency_chart(model, line, unit));
        sigmas.push_back(sigma_chart(model, line));
        if (!line.exceptional.empty())
          loci.push_back(locus_chart(model, line, unit));
      }
    draw(
      "frequencies",
      "Frequencies in " + unit.name +
        " of all pairs over the axis, a line for each "
        "branch, a panel for each value of the other axes; triangles: points "
        "of the grid where the pair is unstable",
      frequencies);
    draw("sigma",
         "Growth rates sigma in 1/s of the branches that are unstable "
         "somewhere: above the line at 0 they squeal",
         sigmas);
    if (!loci.empty())
      draw("locus",
           "Paths of the pairs that coalesce, " + unit.label +
             " over sigma in 1/s; tinted: unstable",
           loci);
    if (model.grid().n_axes() == 2)
      draw(
        "stability_map",
        "Unstable ranges: each a line between two marks, its lower and its "
        "upper edge along the first axis or its end, at a value of the second; "
        "colour and shape of the marks: its frequency where sigma is largest; "
        "ranges that overlap are shifted up a little",
        {map_chart(model, solution)});
    for (const ChartGroup &group : others)
      draw(group.name, group.caption, group.charts);
    if (model.history().size() > 1)
      draw("basis",
           "Worst estimated error of the greedy basis over its size and over "
           "the work",
           basis_charts(model.history(), context.parameters.sweep));
  }
} // namespace squeal
