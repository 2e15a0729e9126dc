// SPDX-License-Identifier: LGPL-2.1-or-later

// Phase between the resultants of a pair over time, and what a trigger has made
// of a run.

#include <squeal/analyses/transient/transient_results.h>
#include <squeal/analyses/transient/transient_verdict.h>
#include <squeal/results/chart.h>
#include <squeal/run/run_context.h>
#include <squeal/transient/slow_part.h>

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

    /** Vibration, over the mean normal force, that counts as squeal, and as
     * large. */
    constexpr double squeal_level = 0.01, large_level = 0.1;

    /** Those of @p all, one a sample, from one time to another. */
    std::vector<double>
    values_between(const TransientRecord     &record,
                   const std::vector<double> &all,
                   const double               from,
                   const double               to)
    {
      std::vector<double> values;
      for (std::size_t k = 0; k < record.samples.size(); ++k)
        if (record.samples[k].time >= from && record.samples[k].time <= to)
          values.push_back(all[k]);
      return values;
    }

    double
    mean_value(const std::vector<double> &values)
    {
      double sum = 0.;
      for (const double value : values)
        sum += value;
      return values.empty() ? 0. : sum / values.size();
    }

    /** About the nearest polynomial of a degree; 0: about the mean. */
    double
    rms_beside(const std::vector<double> &values, const unsigned int degree)
    {
      std::vector<double> squares;
      for (const double value : without_slow_part(values, degree))
        squares.push_back(value * value);
      return std::sqrt(mean_value(squares));
    }

    /** Whether steady sliding is left without a trigger, by the motion or by
     * the pairs about it. */
    bool
    grows_by_itself(const TransientFigures &f)
    {
      return f.verdict == "unstable" || !f.growing_outside.empty() ||
             (f.leading >= 0 && f.branches[f.leading].sigma > 0.);
    }

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



  bool
  has_trigger(const TransientParameters &t)
  {
    return !t.hammer.body.empty() || t.friction_impulse != 0.;
  }



  namespace
  {
    /** From the begin of the first trigger to the end of the last, s. */
    std::pair<double, double>
    times_of_triggers(const TransientParameters &t)
    {
      double begin = 1e300, end = 0.;
      if (!t.hammer.body.empty())
        {
          begin = t.hammer.time;
          end   = t.hammer.time + t.hammer.duration;
        }
      if (t.friction_impulse != 0.)
        {
          begin = std::min(begin, t.friction_impulse_time);
          end   = std::max(end,
                         t.friction_impulse_time + t.friction_impulse_duration);
        }
      return {begin, end};
    }

    /** What a pair does about a trigger. */
    struct PairOutcome
    {
      TriggerOutcome outcome;
      double         size; /**< after it or at the end, over the mean force */

      /** Whether this is the outcome of the run rather than @p other: the one
       * that lasts longer, of equal ones that of the louder pair. */
      bool
      comes_before(const PairOutcome &other) const
      {
        return rank() != other.rank() ? rank() > other.rank()
                                      : size > (1. + 1e-6) * other.size;
      }

    private:
      unsigned int
      rank() const
      {
        const auto       &text    = outcome.text;
        const std::string texts[] = {"temporary after the trigger",
                                     "run too short",
                                     "squeal after the trigger",
                                     "squeal by itself"};
        for (unsigned int k = 4; k > 0; --k)
          if (text == texts[k - 1])
            return k;
        return 0;
      }
    };

    PairOutcome
    outcome_of(const JudgedPair                &pair,
               const std::pair<double, double> &trigger,
               const TransientRecord           &record,
               const TransientFigures          &f)
    {
      const double begin = trigger.first, end = trigger.second;
      const auto  &samples = record.samples;
      const double last    = samples.back().time;
      const auto   all     = samples_of(record, pair);
      const auto   values  = [&](const double from, const double to) {
        return values_between(record, all, from, to);
      };
      const auto rms = [&](const double from, const double to) {
        return rms_beside(values(from, to), 2);
      };
      const double mean =
        pair.share * mean_value(values_between(
                       record,
                       record.forces_of(pair.number, &PairSample::normal),
                       0.9 * last,
                       last));
      TriggerOutcome r;
      r.pair               = pair;
      r.before             = rms(0.75 * begin, begin);
      r.after              = rms(end, end + 0.1 * last);
      r.end                = rms(0.9 * last, last);
      const double earlier = rms(0.8 * last, 0.9 * last), window = 0.01 * last;
      // These windows may be shorter than a period.
      for (double from = end; from + window <= last * (1. + 1e-9);
           from += window)
        if (rms_beside(values(from, from + window), 0) > large_level * mean)
          r.lasting = from + window - end;
      const double least = squeal_level * mean;
      // Small motion about steady sliding that shrinks ends, however slowly.
      const bool ends = r.end < earlier &&
                        std::all_of(samples.begin() + 9 * samples.size() / 10,
                                    samples.end(),
                                    [](const auto &s) { return s.is_linear; });
      const bool lasts = r.end > least && r.end > 0.8 * earlier && !ends;
      // A squeal that grows is not there to its full size at the trigger.
      r.text = lasts && (r.before > least || grows_by_itself(f))
                 ? "squeal by itself"
               : end > 0.9 * last ? "run too short"
               : lasts            ? "squeal after the trigger"
               : r.after > least  ? "temporary after the trigger"
                                  : "none";
      return {r, mean > 0. ? std::max(r.after, r.end) / mean : 0.};
    }

    /** The combination of the moments of @p pair that vibrates most from one
     * time to another. */
    MomentParts
    parts_between(const JudgedPair      &pair,
                  const TransientRecord &record,
                  const double           from,
                  const double           to)
    {
      const auto vibration = [&](double PairSample::*const of) {
        return without_slow_part(
          values_between(record, record.forces_of(pair.number, of), from, to),
          2);
      };
      const std::vector<double> a = vibration(&PairSample::first_moment),
                                b = vibration(&PairSample::second_moment);
      double first = 0., second = 0., mixed = 0.;
      for (std::size_t k = 0; k < a.size(); ++k)
        {
          first += a[k] * a[k];
          second += b[k] * b[k];
          mixed += a[k] * b[k];
        }
      return loudest_moment(first, second, mixed);
    }

    /** The outcome by the force that is judged, or by a moment that the trigger
     * leaves by far more of: what dies out is not judged by the end. */
    PairOutcome
    louder_outcome_of(const JudgedPair                &pair,
                      const std::pair<double, double> &trigger,
                      const TransientRecord           &record,
                      const TransientFigures          &f)
    {
      const PairOutcome judged = outcome_of(pair, trigger, record, f);
      PairOutcome       result = judged;
      if (pair.is_beside_sums())
        return result;
      const double last = record.samples.back().time, end = trigger.second;
      for (const auto &[from, to] : {std::make_pair(end, end + 0.1 * last),
                                     std::make_pair(0.9 * last, last)})
        {
          JudgedPair by_moment = pair;
          by_moment.force      = JudgedForce::moment;
          by_moment.parts      = parts_between(pair, record, from, to);
          by_moment.force_name = "moment of the normal forces";
          if (const PairOutcome next =
                outcome_of(by_moment, trigger, record, f);
              next.size > squeal_level &&
              next.size > far_louder * judged.size && next.comes_before(result))
            result = next;
        }
      return result;
    }
  } // namespace



  TriggerOutcome
  evaluate_trigger(const TransientRecord     &record,
                   const TransientFigures    &f,
                   const TransientParameters &t)
  {
    if (!has_trigger(t))
      return {};
    const auto  trigger = times_of_triggers(t);
    PairOutcome result  = louder_outcome_of(f.judged.at(0), trigger, record, f);
    for (std::size_t i = 1; i < f.judged.size(); ++i)
      if (const PairOutcome next =
            louder_outcome_of(f.judged[i], trigger, record, f);
          next.comes_before(result))
        result = next;
    return result.outcome;
  }



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
