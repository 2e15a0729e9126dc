// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/results/chart.h>
#include <squeal/results/frequency_unit.h>
#include <squeal/results/plots.h>
#include <squeal/results/table.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace squeal
{
  namespace
  {
    using Style  = ChartSeries::Style;
    using Marker = ChartSeries::Marker;
    using Scale  = AxisSettings::Scale;

    constexpr double smallest_drawn = 1e-17; // below the noise of doubles
    constexpr int    most_bars      = 60;

    ChartSeries
    series(const std::string &label,
           const Ink          ink,
           const Marker       marker,
           const bool         hollow = false,
           const Style        style  = Style::points)
    {
      ChartSeries s;
      s.label  = label;
      s.ink    = ink;
      s.marker = marker;
      s.hollow = hollow;
      s.style  = style;
      return s;
    }

    std::string
    frequency_text(const double frequency)
    {
      return (frequency >= 100. ? plain_number(frequency, 0)
                                : rounded_text(frequency, 3)) +
             " Hz";
    }

    FrequencyUnit
    unit_of(const std::vector<PlottedPair> &pairs)
    {
      double highest = 0.;
      for (const PlottedPair &pair : pairs)
        highest = std::max(highest, pair.frequency);
      return FrequencyUnit(highest);
    }

    std::string
    pair_text(const PlottedPair &pair)
    {
      return frequency_text(pair.frequency) +
             (pair.name.empty() ? "" : "  " + pair.name);
    }

    /** Damping ratio in per cent. */
    double
    damping_percent(const PlottedPair &pair)
    {
      const double omega = 2. * std::acos(-1.) * pair.frequency;
      return -100. * pair.sigma / std::hypot(pair.sigma, omega);
    }

    /** A power of ten, two decades below the largest value. */
    double
    inner_decade(const std::vector<double> &values)
    {
      double largest = 0.;
      for (const double value : values)
        if (std::isfinite(value))
          largest = std::max(largest, std::abs(value));
      if (largest == 0.)
        return 1.;
      return std::pow(10., std::floor(std::log10(largest)) - 2.);
    }

    void
    add(ChartSeries       &s,
        const double       x,
        const double       y,
        const std::string &name = "")
    {
      if (!std::isfinite(x) || !std::isfinite(y))
        return;
      s.x.push_back(x);
      s.y.push_back(y);
      s.names.push_back(name);
    }

    /** The lines of two tolerances, one line if they are the same. */
    std::vector<ReferenceLine>
    tolerance_lines(const double residual_tolerance,
                    const double error_tolerance)
    {
      if (residual_tolerance == error_tolerance)
        return {{false, error_tolerance, "tolerance", Ink::black, true}};
      return {
        {false, residual_tolerance, "tolerance of residual", Ink::grey, true},
        {false, error_tolerance, "tolerance of error", Ink::black, true}};
    }

    /** Leaves out the labels of series that have no point. */
    void
    drop_empty(Chart &chart)
    {
      chart.series.erase(std::remove_if(chart.series.begin(),
                                        chart.series.end(),
                                        [](const ChartSeries &s) {
                                          return s.x.empty() && s.boxes.empty();
                                        }),
                         chart.series.end());
    }

    /** The pairs to draw as bars, by frequency. */
    std::vector<PlottedPair>
    chosen_for_bars(std::vector<PlottedPair> pairs)
    {
      const auto by_frequency = [](const PlottedPair &a, const PlottedPair &b) {
        return a.frequency < b.frequency;
      };
      std::stable_sort(pairs.begin(), pairs.end(), by_frequency);
      std::stable_partition(pairs.begin(),
                            pairs.end(),
                            [](const PlottedPair &p) { return p.is_unstable; });
      if (pairs.size() > static_cast<std::size_t>(most_bars))
        pairs.resize(most_bars);
      std::stable_sort(pairs.begin(), pairs.end(), by_frequency);
      return pairs;
    }
  } // namespace



  bool
  plot_spectrum(const Plotter                  &plotter,
                const std::vector<PlottedPair> &pairs,
                const std::string              &path,
                const std::string              &title)
  {
    const FrequencyUnit unit   = unit_of(pairs);
    ChartSeries         stable = series("stable", Ink::blue, Marker::circle);
    ChartSeries         unstable =
      series("unstable", Ink::vermillion, Marker::triangle);
    ChartSeries open =
      series("growth open by the mesh", Ink::orange, Marker::diamond, true);
    unstable.marker_size = open.marker_size = 2.2;
    std::vector<double> sigmas;
    for (const PlottedPair &pair : pairs)
      {
        sigmas.push_back(pair.sigma);
        if (pair.is_open || pair.is_unstable)
          add(pair.is_open ? open : unstable,
              pair.sigma,
              unit.factor * pair.frequency,
              pair_text(pair));
        else
          add(stable, pair.sigma, unit.factor * pair.frequency);
      }

    Chart chart;
    chart.title   = title;
    chart.x.label = "σ in 1/s   (growth to the right, decay to the left)";
    chart.x.scale = Scale::signed_logarithmic;
    chart.x.linear_width = inner_decade(sigmas);
    chart.y.label        = unit.label;
    chart.y.lower        = 0.;
    chart.series         = {stable, open, unstable};
    chart.lines          = {{true, 0., "", Ink::black, false}};
    Strip growth;
    growth.lower = 0.;
    chart.strips = {growth};
    drop_empty(chart);
    return plotter.draw(draw_charts({chart}), path);
  }



  bool
  plot_damping_chart(const Plotter                  &plotter,
                     const std::vector<PlottedPair> &pairs,
                     const double                    threshold_percent,
                     const std::string              &path,
                     const std::string              &title)
  {
    const FrequencyUnit unit      = unit_of(pairs);
    const double        threshold = -std::abs(threshold_percent);
    ChartSeries         stable    = series("stable", Ink::blue, Marker::circle);
    ChartSeries         weak =
      series("unstable, within the threshold", Ink::orange, Marker::diamond);
    ChartSeries strong = series(
      "unstable, beyond the threshold", Ink::vermillion, Marker::triangle);
    weak.marker_size = strong.marker_size = 2.2;
    double most_damped = 0., least_damped = threshold;
    for (const PlottedPair &pair : pairs)
      {
        if (!(pair.frequency > 0.))
          continue;
        const double zeta = damping_percent(pair);
        const double f    = unit.factor * pair.frequency;
        if (!pair.is_unstable)
          add(stable, f, zeta);
        else if (zeta >= threshold)
          add(weak, f, zeta, pair_text(pair));
        else
          add(strong, f, zeta, pair_text(pair));
        most_damped  = std::max(most_damped, zeta);
        least_damped = std::min(least_damped, zeta);
      }

    Chart chart;
    chart.title   = title;
    chart.x.label = unit.label;
    chart.x.lower = 0.;
    chart.y.label = "damping ratio ζ in %   (negative: unstable)";
    // a few heavily damped modes would flatten all that matters
    if (most_damped > 4. * std::abs(least_damped))
      {
        chart.y.scale = Scale::signed_logarithmic;
        chart.y.linear_width =
          std::pow(10., std::floor(std::log10(std::abs(least_damped))) - 1.);
      }
    chart.series = {stable, weak, strong};
    chart.lines  = {{false, 0., "", Ink::black, false},
                    {false,
                     threshold,
                     "threshold " + std::string(threshold < 0. ? "−" : "") +
                       shortest_text(std::abs(threshold)) + " %",
                     Ink::vermillion,
                     true}};
    Strip squeal;
    squeal.vertical = false;
    squeal.upper    = threshold;
    chart.strips    = {squeal};
    drop_empty(chart);
    return plotter.draw(draw_charts({chart}), path);
  }



  bool
  plot_energy_shares(const Plotter                  &plotter,
                     const std::vector<std::string> &bodies,
                     const std::vector<PlottedPair> &pairs,
                     const std::string              &path,
                     const std::string              &title)
  {
    const std::vector<PlottedPair> shown = chosen_for_bars(pairs);
    const int                      n     = static_cast<int>(shown.size());
    // vermillion is kept for what is unstable
    const std::array<Ink, 7> inks = {{Ink::blue,
                                      Ink::orange,
                                      Ink::green,
                                      Ink::purple,
                                      Ink::sky,
                                      Ink::yellow,
                                      Ink::grey}};
    Chart                    chart;
    chart.title = title;
    if (shown.size() < pairs.size())
      chart.title += " (" + std::to_string(n) + " of " +
                     std::to_string(pairs.size()) + " pairs)";
    chart.x.label = "share of kinetic energy in %";
    chart.x.lower = 0.;
    chart.x.upper = 100.;
    chart.y.lower = 0.;
    chart.y.upper = std::max(1, n);
    for (int i = 0; i < n; ++i)
      chart.y.marks.push_back(
        {n - i - 0.5, pair_text(shown[i]), shown[i].is_unstable});

    for (std::size_t b = 0; b < bodies.size(); ++b)
      {
        ChartSeries s;
        s.label = bodies[b];
        s.style = Style::boxes;
        s.ink   = inks[b % inks.size()];
        for (int i = 0; i < n; ++i)
          {
            const std::vector<double> &shares = shown[i].energy_shares;
            if (b >= shares.size())
              continue;
            double from = 0.;
            for (std::size_t c = 0; c < b; ++c)
              from += 100. * shares[c];
            s.boxes.push_back(
              {from, from + 100. * shares[b], n - i - 0.9, n - i - 0.1});
          }
        chart.series.push_back(s);
      }
    return plotter.draw(draw_charts({chart}, 1400, std::max(500, 220 + 30 * n)),
                        path);
  }



  bool
  plot_error_estimates(const Plotter                  &plotter,
                       const std::vector<PlottedPair> &pairs,
                       const double                    residual_tolerance,
                       const double                    error_tolerance,
                       const std::string              &path,
                       const std::string              &title)
  {
    const FrequencyUnit unit = unit_of(pairs);
    ChartSeries         residual =
      series("residual, relative", Ink::sky, Marker::square);
    ChartSeries estimate = series(
      "error estimate |dλ|/|λ| of the reduction", Ink::blue, Marker::circle);
    ChartSeries mesh = series(
      "discretisation error of f, relative", Ink::orange, Marker::diamond);
    mesh.marker_size = 2.;
    const auto drawn = [](const double value) {
      return value == 0. ? smallest_drawn : value;
    };
    for (const PlottedPair &pair : pairs)
      {
        const double f = unit.factor * pair.frequency;
        add(residual, f, drawn(pair.residual));
        add(estimate, f, drawn(pair.error_estimate));
        add(mesh, f, drawn(pair.discretisation_error));
      }

    Chart chart;
    chart.title   = title;
    chart.x.label = unit.label;
    chart.x.lower = 0.;
    chart.y.label = "relative error";
    chart.y.scale = Scale::logarithmic;
    chart.series  = {residual, estimate, mesh};
    chart.lines   = tolerance_lines(residual_tolerance, error_tolerance);
    drop_empty(chart);
    return plotter.draw(draw_charts({chart}), path);
  }



  bool
  plot_work_precision(const Plotter                          &plotter,
                      const std::vector<WorkPrecisionSeries> &ladders,
                      const double                            goal,
                      const std::string                      &path,
                      const std::string                      &title)
  {
    std::vector<Chart> charts(2);
    charts[0].title   = title;
    charts[0].x.label = "CPU time in s";
    charts[1].title   = " ";
    charts[1].x.label = "degrees of freedom";
    for (Chart &chart : charts)
      {
        chart.x.scale = Scale::logarithmic;
        chart.y.scale = Scale::logarithmic;
        chart.y.label = "relative error";
        if (goal > 0.)
          chart.lines.push_back({false, goal, "goal", Ink::black, true});
        for (std::size_t k = 0; k < ladders.size(); ++k)
          {
            const WorkPrecisionSeries &ladder = ladders[k];
            const std::vector<double> &work =
              &chart == &charts[0] ? ladder.seconds : ladder.dofs;
            ChartSeries s = series(ladder.label,
                                   static_cast<Ink>(k % 9),
                                   static_cast<Marker>(k % 4),
                                   false,
                                   Style::lines_points);
            for (std::size_t i = 0;
                 i < std::min(work.size(), ladder.errors.size());
                 ++i)
              add(s,
                  work[i],
                  ladder.errors[i],
                  i < ladder.settings.size() ? ladder.settings[i] : "");
            chart.series.push_back(s);
          }
        drop_empty(chart);
      }
    return plotter.draw(draw_charts(charts, 1700, 900, 2), path);
  }



  bool
  plot_enrichment_decay(const Plotter                     &plotter,
                        const std::vector<EnrichmentStep> &steps,
                        const double                       residual_tolerance,
                        const double                       error_tolerance,
                        const std::string                 &path,
                        const std::string                 &title)
  {
    ChartSeries residual = series(
      "worst residual", Ink::sky, Marker::square, false, Style::lines_points);
    ChartSeries estimate = series("worst error estimate",
                                  Ink::blue,
                                  Marker::circle,
                                  false,
                                  Style::lines_points);
    for (const EnrichmentStep &step : steps)
      {
        add(residual, step.basis_size, step.worst_residual);
        add(estimate, step.basis_size, step.worst_estimate);
      }
    Chart chart;
    chart.title   = title;
    chart.x.label = "vectors in the reduced basis";
    chart.y.label = "relative error";
    chart.y.scale = Scale::logarithmic;
    chart.series  = {residual, estimate};
    chart.lines   = tolerance_lines(residual_tolerance, error_tolerance);
    return plotter.draw(draw_charts({chart}), path);
  }
} // namespace squeal
