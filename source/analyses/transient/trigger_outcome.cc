// SPDX-License-Identifier: LGPL-2.1-or-later

// What a trigger has made of a run.

#include <squeal/analyses/transient/transient_results.h>
#include <squeal/base/unknown_choice.h>
#include <squeal/transient/slow_part.h>

#include <algorithm>
#include <cmath>

namespace squeal
{
  namespace
  {
    /** Vibration, over the mean normal force, that counts as squeal, and as
     * large. */
    constexpr double squeal_level = 0.01, large_level = 0.1;

    /** What lasts is at least this share of what it was before. */
    constexpr double least_left = 0.8;

    /** Steps for each coefficient of a polynomial that is taken away. */
    constexpr double least_steps = 8.;

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

    /** Numbers of the first of some stretches and of the one behind the last.
     */
    struct StretchRange
    {
      unsigned int first = 0, end = 0;
    };

    /** The force of a pair that is judged, from one time to another: in every
     * step, or in the samples where the stretches of the steps are longer than
     * that time or not there. */
    class ForceOverTime
    {
    public:
      /** References are kept; @p time_step: s. */
      ForceOverTime(const TransientRecord &r,
                    const JudgedPair      &p,
                    const double           time_step)
        : record(r)
        , pair(p)
        , steps(r.trigger_stretches_of(p.number))
        , samples(samples_of(r, p))
        , normals(r.forces_of(p.number, &PairSample::normal))
        , ends(1, 0.)
      {
        for (const ForceStatistics &s : steps)
          {
            n_steps += s.n_steps;
            ends.push_back(n_steps * time_step);
            pieces.push_back(piece_of(pieces.size()));
          }
      }

      /** Whole stretches that begin at @p from or later and end by @p to, s;
       * none where these are shorter. */
      StretchRange
      between(const double from, const double to) const
      {
        const double rounding = 1e-9 * ends.back();
        StretchRange result;
        result.first =
          std::lower_bound(ends.begin(), ends.end(), from - rounding) -
          ends.begin();
        result.end = std::upper_bound(ends.begin(), ends.end(), to + rounding) -
                     ends.begin();
        result.end   = std::max(result.end, 1u) - 1;
        result.first = std::min(result.first, result.end);
        return result;
      }

      /** About the nearest polynomial of a degree; 0: about the mean. */
      double
      rms(const double from, const double to, const unsigned int degree) const
      {
        const StretchRange range = between(from, to);
        return range.first < range.end
                 ? rms_of_steps(range, degree)
                 : rms_beside(values_between(record, samples, from, to),
                              degree);
      }

      double
      mean_normal(const double from, const double to) const
      {
        const StretchRange range = between(from, to);
        return range.first < range.end
                 ? statistics_of(steps, range.first, range.end).mean_normal
                 : mean_value(values_between(record, normals, from, to));
      }

      /** Of the last step, or of the last sample, s. */
      double
      last_time() const
      {
        return steps.empty() ? record.samples.back().time : ends.back();
      }

      /** Time from @p from to the end of the last window, of about
       * @p window, s, whose rms is above @p level; 0: none. */
      double
      lasting(const double from, const double window, const double level) const
      {
        const double last   = last_time();
        double       result = 0.;
        for (double begin = from; begin + window <= last * (1. + 1e-9);)
          {
            // Whole stretches, so that no step is between two windows.
            const StretchRange range = between(begin, begin + window);
            const double       end =
              range.first < range.end ? ends[range.end] : begin + window;
            if (rms(begin, end, 0) > level)
              result = end - from;
            begin = end;
          }
        return result;
      }

    private:
      SignalPiece
      piece_of(const std::size_t k) const
      {
        switch (pair.force)
          {
          case JudgedForce::normal:
            return steps[k].normal();
          case JudgedForce::tangential:
            return steps[k].tangential();
          case JudgedForce::moment:
            return steps[k].moment(pair.parts);
          case JudgedForce::node:
            return record.watched
              .trigger_pieces[pair.watched * n_trigger_stretches + k];
          }
        unknown_choice("judged force");
      }

      double
      rms_of_steps(const StretchRange &range, const unsigned int degree) const
      {
        const std::vector<SignalPiece> some(pieces.begin() + range.first,
                                            pieces.begin() + range.end);
        SignalPiece                    all;
        for (const SignalPiece &piece : some)
          join(piece, all);
        return degree == 0 || all.n < least_steps * (degree + 1)
                 ? rms_of(all)
                 : rms_beside_slow_part(some, 1, degree).front();
      }

      const TransientRecord             &record;
      const JudgedPair                  &pair;
      const std::vector<ForceStatistics> steps;
      const std::vector<double>          samples, normals;
      std::vector<SignalPiece>           pieces;
      std::vector<double> ends; /**< s: 0 and those of stretches */
      double              n_steps = 0.;
    };

    PairOutcome
    outcome_of(const JudgedPair                &pair,
               const std::pair<double, double> &trigger,
               const double                     time_step,
               const TransientRecord           &record,
               const TransientFigures          &f)
    {
      const double        begin = trigger.first, end = trigger.second;
      const auto         &samples = record.samples;
      const ForceOverTime force(record, pair, time_step);
      const double        last = force.last_time();
      const double   mean = pair.share * force.mean_normal(0.9 * last, last);
      TriggerOutcome r;
      r.pair               = pair;
      r.before             = force.rms(0.75 * begin, begin, 2);
      r.after              = force.rms(end, end + 0.1 * last, 2);
      r.end                = force.rms(0.9 * last, last, 2);
      const double earlier = force.rms(0.8 * last, 0.9 * last, 2);
      // These windows may be shorter than a period.
      r.lasting          = force.lasting(end, 0.01 * last, large_level * mean);
      const double least = squeal_level * mean;
      // Small motion about steady sliding that shrinks ends, however slowly.
      const bool ends = r.end < earlier &&
                        std::all_of(samples.begin() + 9 * samples.size() / 10,
                                    samples.end(),
                                    [](const auto &s) { return s.is_linear; });
      // An even vibration is a limit cycle. An uneven one may be bounces that
      // become smaller, whose last ones do not show it.
      const bool falls = !f.has_limit_cycle &&
                         force.rms(0.75 * last, last, 2) <
                           least_left * force.rms(0.5 * last, 0.75 * last, 2);
      const bool lasts = r.end > least && r.end > least_left * earlier &&
                         !ends && !(falls && end < 0.5 * last);
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
     * time to another, in every step or where those are not there in the
     * samples. */
    MomentParts
    parts_between(const JudgedPair      &pair,
                  const double           time_step,
                  const TransientRecord &record,
                  const double           from,
                  const double           to)
    {
      const StretchRange range =
        ForceOverTime(record, pair, time_step).between(from, to);
      if (range.first + 4 <= range.end) // it has quarters
        return vibrations_of(record.trigger_stretches_of(pair.number),
                             range.first,
                             range.end)
          .parts;
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
                      const double                     time_step,
                      const TransientRecord           &record,
                      const TransientFigures          &f)
    {
      const PairOutcome judged =
        outcome_of(pair, trigger, time_step, record, f);
      PairOutcome result = judged;
      if (pair.is_beside_sums())
        return result;
      const double last = ForceOverTime(record, pair, time_step).last_time(),
                   end  = trigger.second;
      for (const auto &[from, to] : {std::make_pair(end, end + 0.1 * last),
                                     std::make_pair(0.9 * last, last)})
        {
          JudgedPair by_moment = pair;
          by_moment.force      = JudgedForce::moment;
          by_moment.parts = parts_between(pair, time_step, record, from, to);
          by_moment.force_name = "moment of the normal forces";
          if (const PairOutcome next =
                outcome_of(by_moment, trigger, time_step, record, f);
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
    PairOutcome result =
      louder_outcome_of(f.judged.at(0), trigger, t.step(), record, f);
    for (std::size_t i = 1; i < f.judged.size(); ++i)
      if (const PairOutcome next =
            louder_outcome_of(f.judged[i], trigger, t.step(), record, f);
          next.comes_before(result))
        result = next;
    return result.outcome;
  }
} // namespace squeal
