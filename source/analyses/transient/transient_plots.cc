// SPDX-License-Identifier: LGPL-2.1-or-later

// Pictures of a transient.

#include <squeal/analyses/transient/transient_results.h>
#include <squeal/output/contact_output.h>
#include <squeal/output/force_charts.h>
#include <squeal/results/chart.h>
#include <squeal/run/run_context.h>

#include <algorithm>
#include <cmath>

namespace squeal
{
  namespace
  {
    constexpr std::size_t most_points          = 4000;
    constexpr double      periods_shown        = 6.;
    constexpr std::size_t steps_without_period = 1000;

    ChartSeries
    line(const std::string &label, const Ink ink)
    {
      ChartSeries s;
      s.label = label;
      s.style = ChartSeries::Style::lines;
      s.ink   = ink;
      return s;
    }

    /** Both resultants over the whole run: of many samples the least and the
     * largest of every group. */
    Chart
    force_chart(const TransientRecord &record)
    {
      ForceCurve        curve;
      const auto       &samples = record.samples;
      const std::size_t group =
        std::max<std::size_t>(1, 2 * samples.size() / most_points);
      const auto extreme = [&](const std::size_t first, const bool largest) {
        const auto begin = samples.begin() + first,
                   end   = begin + std::min(group, samples.size() - first);
        const auto value = [&](double TransientSample::*x) {
          const auto less = [&](const auto &a, const auto &b) {
            return a.*x < b.*x;
          };
          const auto at = largest ? std::max_element(begin, end, less)
                                  : std::min_element(begin, end, less);
          return (*at).*x;
        };
        curve.add(begin->time,
                  value(&TransientSample::normal),
                  value(&TransientSample::tangential));
      };
      for (std::size_t i = 0; i < samples.size(); i += group)
        {
          extreme(i, false);
          if (group > 1)
            extreme(i, true);
        }
      return forces_over_time(curve, "Forces");
    }

    Chart
    spectrum_chart(const TransientRecord &record, const TransientFigures &f)
    {
      const bool          beside_sums = f.loudest.is_beside_sums();
      std::vector<double> normal =
        beside_sums ? samples_of(record, f.loudest)
                    : record.forces_of(f.loudest.number, &PairSample::normal);
      std::vector<double> tangential =
        record.forces_of(f.loudest.number, &PairSample::pulling);
      for (auto *signal : {&normal, &tangential})
        signal->erase(signal->begin(), signal->begin() + signal->size() / 2);
      const double interval = record.samples[1].time - record.samples[0].time;
      Chart        chart;
      chart.title = "Power spectral density" + of_judged(f.loudest) +
                    ", second half of the run";
      chart.x.label  = "frequency in kHz";
      chart.y.label  = "N^2/Hz";
      chart.y.scale  = AxisSettings::Scale::logarithmic;
      double largest = 0., least = 1e300;
      for (const auto &[signal, label, ink] :
           {std::make_tuple(&normal,
                            beside_sums ? f.loudest.force_name
                                        : std::string("normal"),
                            Ink::blue),
            std::make_tuple(
              &tangential, std::string("tangential"), Ink::vermillion)})
        {
          const Spectrum s     = power_spectrum(*signal, interval, 3);
          ChartSeries    curve = line(label, ink);
          for (std::size_t k = 1; k < s.density.size(); ++k)
            {
              curve.x.push_back(1e-3 * s.frequency[k]);
              curve.y.push_back(s.density[k]);
              largest = std::max(largest, s.density[k]);
              least   = std::min(least, s.density[k]);
            }
          chart.series.push_back(curve);
        }
      chart.y.lower = std::max({1e-30, 1e-12 * largest, 0.5 * least});
      if (f.has_limit_cycle && f.frequency > 0.)
        chart.lines = {{true,
                        1e-3 * f.frequency,
                        rounded_text(f.frequency, 5) + " Hz",
                        Ink::grey,
                        true}};
      return chart;
    }

    /** Amplitudes of the least stable branches. */
    Chart
    branch_chart(const TransientRecord &record, const TransientFigures &f)
    {
      std::vector<unsigned int> order;
      for (unsigned int k = 0; k < f.branches.size(); ++k)
        order.push_back(k);
      std::sort(order.begin(), order.end(), [&](const auto a, const auto b) {
        return f.branches[a].sigma > f.branches[b].sigma;
      });
      order.resize(std::min<std::size_t>(order.size(), 6));
      Chart chart;
      chart.title   = "Amplitudes of the pairs about steady sliding";
      chart.x.label = "time in ms";
      chart.y.label = "root of kinetic energy amplitude in J^0.5";
      chart.y.scale = AxisSettings::Scale::logarithmic;
      const std::size_t step =
        std::max<std::size_t>(1, record.samples.size() / most_points);
      for (std::size_t i = 0; i < order.size(); ++i)
        {
          const BranchResult &b = f.branches[order[i]];
          ChartSeries         s = line(rounded_text(b.frequency, 4) + " Hz, " +
                                 rounded_text(b.sigma, 3) + " 1/s",
                               series_ink(i));
          const auto          a = record.branch(order[i], f.branches.size());
          for (std::size_t k = 0; k < a.size(); k += step)
            if (std::abs(a[k]) > 0.)
              {
                s.x.push_back(1e3 * record.samples[k].time);
                s.y.push_back(std::abs(a[k]));
              }
          chart.series.push_back(s);
        }
      if (f.linear_end > f.linear_start)
        {
          Strip strip;
          strip.lower  = 1e3 * f.linear_start;
          strip.upper  = 1e3 * f.linear_end;
          strip.tint   = "#eef4fb";
          chart.strips = {strip};
        }
      return chart;
    }

    /** Pressure at eight moments of the last period kept, or fewer where that
     * has fewer samples. */
    std::vector<ContactMap::Panel>
    pressure_panels(const HistorySamples &h,
                    const std::size_t     n,
                    const double          frequency)
    {
      std::vector<ContactMap::Panel> panels;
      if (h.n_samples() < 2)
        return panels;
      const double period = frequency > 0. ? 1. / frequency : 0.;
      double       upper  = 0.;
      std::size_t  before = h.n_samples();
      for (unsigned int k = 0; k < 8; ++k)
        {
          const double time = h.time.back() - period * (7. - k) / 8.;
          std::size_t  i =
            std::lower_bound(h.time.begin(), h.time.end(), time - 1e-12) -
            h.time.begin();
          i = std::min(i, h.n_samples() - 1);
          if (i == before)
            continue;
          before = i;
          ContactMap::Panel panel;
          panel.title = rounded_text(1e3 * h.time[i], 6) + " ms";
          panel.label = "MPa";
          for (std::size_t j = 0; j < n; ++j)
            {
              panel.values.push_back(pressure_on_map(h.pressure[n * i + j]));
              panel.arrows_x.push_back(h.traction[2 * (n * i + j)]);
              panel.arrows_y.push_back(h.traction[2 * (n * i + j) + 1]);
              upper = std::max(upper, 1e-6 * h.pressure[n * i + j]);
            }
          panels.push_back(panel);
        }
      for (auto &panel : panels)
        panel.upper = upper;
      return panels;
    }
    /** The samples of pair @p i in the last period, and one before it. */
    HistorySamples
    last_period(const HistoryStream &history,
                const std::size_t    i,
                const double         frequency)
    {
      const std::size_t n = history.n_samples();
      if (n < 2)
        return {};
      std::size_t first = n - 2;
      if (frequency > 0.)
        {
          const double end = history.read(i, n - 1, 1).time[0];
          first =
            std::min(first, history.sample_at(end - 1. / frequency - 1e-12));
        }
      return history.read(i, first, n - first);
    }

    /** Pressure of a pair over the last period. */
    void
    draw_pressure(RunContext           &context,
                  const ContactPair    &pair,
                  const bool            is_one_of_several,
                  const HistorySamples &history,
                  const double          frequency,
                  HtmlReport           &report)
    {
      const auto panels = pressure_panels(history, pair.n_nodes(), frequency);
      if (panels.empty())
        return;
      const std::string name =
        is_one_of_several ? "pressure_" + pair.name() : "pressure";
      context.output.file("plots/" + name + ".png");
      const std::string file = context.output.path() + "/plots/" + name;
      contact_map(pair.geometry).plot(context.plotter, panels, file, 4);
      report.figure(
        file + ".png",
        (is_one_of_several ? "Contact pressure of " + pair.name()
                           : std::string("Contact pressure")) +
          " over the last period, grey: none; arrows: tractions on the pad, "
          "on one scale");
    }
  } // namespace



  ForceCurve
  last_periods(const TransientRecord &record,
               const double           frequency,
               const unsigned int     pair)
  {
    ForceCurve        all;
    const auto       &steps   = record.last_steps;
    const std::size_t n_pairs = record.n_pairs();
    for (std::size_t k = pair; k < steps.size(); k += n_pairs)
      all.add(steps[k].time, steps[k].normal, steps[k].tangential);
    if (all.time.size() < 2)
      return all;
    const double step = all.time[1] - all.time[0];
    return all.last(frequency > 0.
                      ? std::lround(periods_shown / frequency / step) + 1
                      : steps_without_period);
  }



  void
  draw_transient(RunContext              &context,
                 const PreparedTransient &prepared,
                 const TransientRecord   &record,
                 const TransientFigures  &f,
                 const HistoryStream     &history,
                 HtmlReport              &report)
  {
    const auto path = [&](const std::string &name) {
      context.output.file("plots/" + name + ".png");
      return context.output.path() + "/plots/" + name;
    };
    const auto draw = [&](const std::string        &name,
                          const std::vector<Chart> &charts,
                          const std::string        &caption) {
      const std::string file = path(name);
      context.plotter.draw(
        draw_charts(charts, 1400, charts.size() > 1 ? 1200 : 900), file);
      report.figure(file + ".png", caption, true);
    };
    const std::size_t n = record.samples.size();
    if (n < 16)
      return;
    const ForceCurve  end = last_periods(record, f.frequency, f.loudest.number);
    const std::string last_title =
      "Forces" + of_judged(f.loudest) + ", every step of the last periods";
    report.section("Charts");
    draw("forces",
         {force_chart(record)},
         f.loudest.name.empty()
           ? "Forces over time"
           : "Forces over time, sums over the pairs that slide");
    draw(
      "forces_last_periods", {forces_over_time(end, last_title)}, last_title);
    // Lines that samples have folded down are not there.
    if (f.beyond_samples == 0.)
      draw("spectrum", {spectrum_chart(record, f)}, "Spectrum");
    if (!f.branches.empty())
      draw("branches",
           {branch_chart(record, f)},
           "Pairs of the largest sigma; shaded: the linear phase, in which "
           "growth rates are fitted");
    // The sums do not have the period of a moment or a node that is judged.
    if (!f.loudest.is_beside_sums())
      draw("limit_cycle",
           portraits(end),
           "Every step of the last periods" + of_judged(f.loudest) +
             ": closed curves in a limit cycle");
    const auto &pairs = prepared.pressed.nodes().pairs();
    for (std::size_t i = 0; i < pairs.size(); ++i)
      draw_pressure(context,
                    pairs[i],
                    pairs.size() > 1,
                    last_period(history, i, f.frequency),
                    f.frequency,
                    report);
  }



  void
  draw_speeds(RunContext &context, const Table &speeds, HtmlReport &report)
  {
    if (speeds.n_rows() == 0)
      return;
    Chart friction, amplitude;
    friction.title    = "Macroscopic friction over sliding speed";
    friction.y.label  = "tangential over normal force";
    amplitude.title   = "Vibration over sliding speed";
    amplitude.y.label = "rms of the normal force in N";
    for (const auto &[chart, column] :
         {std::make_pair(&friction, "macroscopic_friction"),
          std::make_pair(&amplitude, "rms_normal_n")})
      {
        ChartSeries s  = line("", Ink::blue);
        s.style        = ChartSeries::Style::lines_points;
        s.x            = speeds.reals("speed_m_per_s");
        s.y            = speeds.reals(column);
        chart->x.label = "sliding speed in m/s";
        chart->series  = {s};
        chart->legend  = Chart::Legend::none;
      }
    context.output.file("plots/over_speed.png");
    const std::string path = context.output.path() + "/plots/over_speed";
    context.plotter.draw(draw_charts({friction, amplitude}, 1100, 1100), path);
    report.figure(path + ".png",
                  "Macroscopic friction coefficient and vibration over the "
                  "sliding speed, which changes with time",
                  true);
  }
} // namespace squeal
