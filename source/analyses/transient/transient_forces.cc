// SPDX-License-Identifier: LGPL-2.1-or-later

// What the contact forces of a transient do: of the pairs together, and of the
// one that vibrates most.

#include <squeal/analyses/transient/transient_results.h>
#include <squeal/analyses/transient/transient_verdict.h>
#include <squeal/base/unknown_choice.h>
#include <squeal/base/worst_of.h>
#include <squeal/contact/pressure_moments.h>
#include <squeal/contact/summed_pairs.h>
#include <squeal/transient/slow_part.h>

#include <algorithm>
#include <cmath>

namespace squeal
{
  namespace
  {
    /** The first stretch of the second half. */
    constexpr unsigned int middle = n_force_stretches / 2;

    /** Pairs that carry less than this share of the largest mean normal force
     * only graze: over their own mean every touch is a large vibration. */
    constexpr double least_carried = 1e-3;

    /** Pairs whose vibrations differ by less than this share are equally loud.
     */
    constexpr double same_loudness = 1e-6;

    /** Of the source of a pair over the steps of the second half, m/s^2. */
    double
    largest_rms_acceleration(const TransientRecord &record)
    {
      double n_steps = 0., largest = 0.;
      for (const NodeShares &node : record.nodes)
        n_steps = std::max(n_steps, node.open + node.stick + node.slip);
      for (const double square : record.square_accelerations)
        largest = worst_of(largest, std::sqrt(square / std::max(n_steps, 1.)));
      return largest;
    }

    double
    largest_of(const std::vector<double> &values)
    {
      double largest = 0.;
      for (const double value : values)
        largest = worst_of(largest, value);
      return largest;
    }



    /** Whether a moment that vibrates by @p moment, N, is judged: more than
     * noise of @p least, and by far more than the @p force that else is. */
    bool
    is_by_far(const double moment, const double force, const double least)
    {
      return moment > least && moment > far_louder * force;
    }

    /** Forces of one pair in every step of a run. */
    struct PairVibration
    {
      explicit PairVibration(const std::vector<ForceStatistics> &stretches)
        : half(statistics_of(stretches, middle, n_force_stretches))
        , early(vibrations_of(stretches, 0, middle))
        , late(vibrations_of(stretches, middle, n_force_stretches))
        , least(least_vibration * half.mean_normal)
      {
        // Pure stick-slip leaves the normal force alone.
        if (!(largest_of(late.normal) > least) && half.mean_normal > 0. &&
            largest_of(late.tangential) > least)
          force = JudgedForce::tangential;
        if (half.mean_normal > 0. &&
            is_by_far(largest_of(late.moment), largest_of(judged()), least))
          force = JudgedForce::moment;
      }

      /** The force that is judged, by quarters of the second half, N. */
      const std::vector<double> &
      judged() const
      {
        return late.of(force);
      }

      /** Its largest vibration over the mean normal force. */
      double
      loudness() const
      {
        return half.mean_normal > 0. ? largest_of(judged()) / half.mean_normal
                                     : 0.;
      }

      bool
      is_silent() const
      {
        for (const QuarterVibrations *v : {&early, &late})
          if (largest_of(v->normal) > least ||
              largest_of(v->tangential) > least ||
              is_by_far(largest_of(v->moment), largest_of(v->normal), least))
            return false;
        return true;
      }

      ForceStatistics   half;
      QuarterVibrations early, late;
      double            least;                       /**< N: less is noise */
      JudgedForce       force = JudgedForce::normal; /**< that is judged */
    };



    std::string
    name_of(const PairVibration &vibration, const ContactPair &pair)
    {
      switch (vibration.force)
        {
        case JudgedForce::normal:
          return "normal force";
        case JudgedForce::tangential:
          return "tangential force";
        case JudgedForce::moment:
          return pressure_moments(pair.geometry).name_of(vibration.late.parts);
        }
      unknown_choice("judged force");
    }



    /** Of the pairs that count for the resultants those that carry; the first
     * where none does. */
    std::vector<JudgedPair>
    judged_pairs(const ContactNodes               &nodes,
                 const std::vector<PairVibration> &vibrations)
    {
      std::vector<JudgedPair> result;
      double                  largest = 0.;
      for (unsigned int i = 0; i < vibrations.size(); ++i)
        if (const ContactPair &pair = nodes.pairs()[i]; is_summed(nodes, pair))
          {
            result.push_back({i,
                              vibrations.size() > 1 ? pair.name() : "",
                              vibrations[i].force,
                              name_of(vibrations[i], pair),
                              vibrations[i].late.parts});
            largest = worst_of(largest, vibrations[i].half.mean_normal);
          }
      const JudgedPair first = result.at(0);
      result.erase(std::remove_if(result.begin(),
                                  result.end(),
                                  [&](const JudgedPair &pair) {
                                    return !(
                                      vibrations[pair.number].half.mean_normal >
                                      least_carried * largest);
                                  }),
                   result.end());
      return result.empty() ? std::vector<JudgedPair>{first} : result;
    }

    /** The force that is judged in @p now, StepForces or a PairSample whose
     * tangential force is @p tangential, N. */
    template <typename Forces>
    double
    value_of(const JudgedPair &pair, const Forces &now, const double tangential)
    {
      switch (pair.force)
        {
        case JudgedForce::normal:
          return now.normal;
        case JudgedForce::tangential:
          return tangential;
        case JudgedForce::moment:
          return pair.parts[0] * now.first_moment +
                 pair.parts[1] * now.second_moment;
        }
      unknown_choice("judged force");
    }

    /** The force that is judged in each of the last steps, N. */
    std::vector<double>
    last_steps_of(const TransientRecord &record, const JudgedPair &pair)
    {
      std::vector<double> result;
      const std::size_t   n_pairs = record.n_pairs();
      for (std::size_t k = pair.number; k < record.last_steps.size();
           k += n_pairs)
        {
          const StepForces &now = record.last_steps[k];
          result.push_back(value_of(pair, now, now.tangential));
        }
      return result;
    }

    /** Without the odd values at the start: the transform of a number of them
     * with large prime factors takes long. */
    std::vector<double>
    of_even_length(const std::vector<double> &values)
    {
      constexpr std::size_t block = 2048;
      const std::size_t     n     = values.size();
      return {values.begin() + (n > block ? n % block : 0), values.end()};
    }

    /** The first of the pairs that no other one is louder than. */
    template <typename Loudness>
    JudgedPair
    loudest_of(const std::vector<JudgedPair> &pairs, const Loudness &loudness)
    {
      JudgedPair result = pairs.at(0);
      for (const JudgedPair &pair : pairs)
        if (loudness(pair) > (1. + same_loudness) * loudness(result))
          result = pair;
      return result;
    }
  } // namespace



  std::string
  of_judged(const JudgedPair &pair)
  {
    return pair.name.empty() ? "" : " of the pair " + pair.name;
  }



  bool
  JudgedPair::is_by_moment() const
  {
    return force == JudgedForce::moment;
  }

  std::vector<double>
  samples_of(const TransientRecord &record, const JudgedPair &pair)
  {
    std::vector<double> result;
    for (std::size_t k = 0; k < record.samples.size(); ++k)
      {
        const PairSample &now = record.pair(k, pair.number);
        result.push_back(value_of(pair, now, now.pulling));
      }
    return result;
  }

  double
  rms_of_pressure(const ForceStatistics &pair)
  {
    const double normal = pair.rms_normal(),
                 moment = rms_of(pair.moment(loudest_moment(
                   pair.square_first, pair.square_second, pair.mixed_moments)));
    return is_by_far(moment, normal, least_vibration * pair.mean_normal)
             ? moment
             : normal;
  }



  JudgedPair
  loudest_in(const std::vector<JudgedPair> &pairs,
             const TransientRecord         &record,
             const unsigned int             first,
             const unsigned int             end)
  {
    return loudest_of(pairs, [&](const JudgedPair &pair) {
      const ForceStatistics s =
        statistics_of(record.stretches_of(pair.number), first, end);
      return s.mean_normal > 0. ? rms_of_pressure(s) / s.mean_normal : 0.;
    });
  }



  void
  evaluate_forces(const ContactNodes    &nodes,
                  const TransientRecord &record,
                  TransientFigures      &f)
  {
    const ForceStatistics all =
      statistics_of(record.stretches, middle, n_force_stretches);
    f.separates                = all.n_apart > 0.;
    f.mean_normal_of_all       = all.mean_normal;
    f.macroscopic_friction     = all.macroscopic_friction();
    f.mean_leading_edge_factor = all.leading_edge_factor();
    f.rms_acceleration         = largest_rms_acceleration(record);
    std::vector<PairVibration> vibrations;
    for (unsigned int i = 0; i < nodes.pairs().size(); ++i)
      vibrations.emplace_back(record.stretches_of(i));
    f.judged  = judged_pairs(nodes, vibrations);
    f.loudest = loudest_of(f.judged, [&](const JudgedPair &pair) {
      return vibrations[pair.number].loudness();
    });
    f.is_silent =
      std::all_of(f.judged.begin(), f.judged.end(), [&](const JudgedPair &p) {
        return vibrations[p.number].is_silent();
      });
    const PairVibration &v         = vibrations[f.loudest.number];
    const bool           by_moment = f.loudest.is_by_moment();
    f.mean_normal                  = v.half.mean_normal;
    f.rms_normal =
      by_moment ? rms_of(v.half.moment(f.loudest.parts)) : v.half.rms_normal();
    f.most_rms_of_sum  = largest_of(v.late.normal);
    f.min_normal       = v.half.min_normal;
    f.max_normal       = v.half.max_normal;
    f.mean_tangential  = v.half.mean_tangential;
    f.rms_tangential   = v.half.rms_tangential();
    f.rms_change       = change_of_rms(by_moment ? v.judged() : v.late.normal);
    f.rms_change_share = share_of_change(v.judged());
    f.least_rms = *std::min_element(v.judged().begin(), v.judged().end());
    f.most_rms  = largest_of(v.judged());
  }



  double
  highest_line(const double interval)
  {
    return 0.45 / interval;
  }

  double
  line_beyond_samples(const TransientRecord &record,
                      const JudgedPair      &pair,
                      const double           lowest,
                      const double           interval)
  {
    const std::vector<StepForces> &steps   = record.last_steps;
    const std::size_t              n_pairs = record.n_pairs(),
                      n       = n_pairs > 0 ? steps.size() / n_pairs : 0,
                      of_half = std::lround(.5 * record.n_steps);
    if (n < 2)
      return 0.;
    const double step =
      (steps.back().time - steps.front().time) / static_cast<double>(n - 1);
    std::vector<double> force = last_steps_of(record, pair);
    force.erase(force.begin(),
                force.end() - std::min<std::ptrdiff_t>(force.size(), of_half));
    const double line =
      power_spectrum(without_slow_part(of_even_length(force), 1), step)
        .peak(lowest, highest_line(step));
    return line > highest_line(interval) ? line : 0.;
  }



  bool
  nothing_vibrates(const TransientFigures &f)
  {
    return !(f.most_rms > least_vibration * f.mean_normal);
  }
} // namespace squeal
