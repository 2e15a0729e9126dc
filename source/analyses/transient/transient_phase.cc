// SPDX-License-Identifier: LGPL-2.1-or-later

// Phase between the resultants of a pair over time.

#include <squeal/analyses/transient/transient_results.h>
#include <squeal/results/chart.h>
#include <squeal/run/run_context.h>

#include <algorithm>
#include <cmath>

namespace squeal
{
  namespace
  {
    using Type = Table::Type;

    /** A phase is given where both forces vibrate by more than this share of
     * the mean normal force. */
    constexpr double least_amplitude = 1e-3;

    /** Runs of a campaign that one picture shows. */
    constexpr std::size_t most_runs = 6;

    ChartSeries
    dots(const std::string &label, const Ink ink)
    {
      ChartSeries s;
      s.label       = label;
      s.ink         = ink;
      s.marker_size = 0.8;
      return s;
    }
    /** Adds one run to both charts of draw_phases(). */
    void
    add_run(const std::string &label,
            const Table       &table,
            Chart             &amplitude,
            Chart             &phase)
    {
      const Ink   ink = series_ink(amplitude.series.size());
      ChartSeries a = dots(label, ink), p = dots(label, ink);
      a.style = ChartSeries::Style::lines;
      for (std::size_t i = 0; i < table.n_rows(); ++i)
        {
          const double t    = 1e3 * table.real(i, "time_s"),
                       size = table.real(i, "normal_amplitude_n");
          // Six decades under the largest.
          amplitude.y.lower =
            std::max(amplitude.y.lower.value_or(0.), 1e-6 * size);
          a.x.push_back(t);
          a.y.push_back(size);
          if (!table.is_missing(i, "phase_deg"))
            {
              p.x.push_back(t);
              p.y.push_back(table.real(i, "phase_deg"));
            }
          for (Chart *chart : {&amplitude, &phase})
            chart->x.upper = std::max(chart->x.upper.value_or(0.), t);
        }
      amplitude.series.push_back(a);
      phase.series.push_back(p);
    }
  } // namespace



  Table
  phase_table(const TransientRecord &record, const TransientFigures &f)
  {
    Table table(
      {{"time_s", Type::real, "s", "middle of a window"},
       {"normal_amplitude_n", Type::real, "N", ""},
       {"tangential_amplitude_n", Type::real, "N", ""},
       {"phase_deg", Type::real, "deg", "tangential against normal"}});
    const auto &samples = record.samples;
    if (samples.size() < 2)
      return table;
    const unsigned int pair        = f.loudest.number;
    const bool         beside_sums = f.loudest.is_beside_sums();
    const PhaseHistory h =
      phase_history(beside_sums ? samples_of(record, f.loudest)
                                : record.forces_of(pair, &PairSample::pressing),
                    record.forces_of(pair, &PairSample::pulling),
                    samples.front().time,
                    samples[1].time - samples[0].time,
                    f.largest_line,
                    least_amplitude * f.mean_normal);
    for (std::size_t i = 0; i < h.time.size(); ++i)
      table.add_row({h.time[i],
                     h.amplitude_a[i],
                     h.amplitude_b[i],
                     beside_sums ? Cell() : or_missing(h.phase[i])});
    return table;
  }



  void
  draw_phases(RunContext                                       &context,
              const std::vector<std::pair<std::string, Table>> &runs,
              HtmlReport                                       &report)
  {
    Chart amplitude, phase;
    amplitude.title   = "Amplitude of the normal force at the largest line";
    amplitude.x.label = "time in ms";
    amplitude.y.label = "amplitude in N";
    amplitude.y.scale = AxisSettings::Scale::logarithmic;
    phase.title       = "Phase of the tangential against the normal force";
    phase.x.label     = "time in ms";
    phase.y.label     = "phase in degrees";
    phase.y.lower     = -180.;
    phase.y.upper     = 180.;
    for (Chart *chart : {&amplitude, &phase})
      {
        chart->x.lower = 0.;
        if (runs.size() < 2)
          chart->legend = Chart::Legend::none;
      }
    const std::size_t n = std::min(runs.size(), most_runs);
    for (std::size_t k = 0; k < n; ++k)
      add_run(runs[k].first, runs[k].second, amplitude, phase);
    if (!(amplitude.y.lower.value_or(0.) > 0.))
      return;
    context.output.file("plots/phase.png");
    const std::string path = context.output.path() + "/plots/phase";
    // Where moments are judged there is no phase.
    const bool has_phase =
      std::any_of(runs.begin(), runs.begin() + n, [](const auto &run) {
        for (std::size_t i = 0; i < run.second.n_rows(); ++i)
          if (!run.second.is_missing(i, "phase_deg"))
            return true;
        return false;
      });
    if (!has_phase)
      amplitude.title = "Amplitude of the force that is judged, at its largest "
                        "line";
    context.plotter.draw(draw_charts(has_phase
                                       ? std::vector<Chart>{amplitude, phase}
                                       : std::vector<Chart>{amplitude},
                                     1400,
                                     !has_phase        ? 700
                                     : runs.size() < 2 ? 1000
                                                       : 1200),
                         path);
    report.figure(
      path + ".png",
      (has_phase
         ? std::string("Amplitude of the normal force, and phase of the "
                       "tangential against the normal force where both are "
                       "above 0.1 % of the mean normal force")
         : std::string("Amplitude of the force that is judged")) +
        (n < runs.size() ? "; the first " + std::to_string(n) + " of " +
                             std::to_string(runs.size()) + " runs"
                         : ""),
      true);
  }
} // namespace squeal
