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



    /** The moment that vibrates more than noise of @p least, N, and by far more
     * than @p force does, by @p size of each; else @p force. */
    template <typename Size>
    JudgedForce
    or_moment(const JudgedForce force, const double least, const Size &size)
    {
      const double first  = size(JudgedForce::first_moment),
                   second = size(JudgedForce::second_moment);
      const auto moment   = second > (1. + same_loudness) * first
                              ? JudgedForce::second_moment
                              : JudgedForce::first_moment;
      return size(moment) > least && size(moment) > far_louder * size(force)
               ? moment
               : force;
    }

    /** By the largest vibration of a quarter. */
    JudgedForce
    or_moment(const JudgedForce        force,
              const double             least,
              const QuarterVibrations &v)
    {
      return or_moment(force, least, [&](const JudgedForce one) {
        return largest_of(v.of(one));
      });
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
        if (half.mean_normal > 0.)
          force = or_moment(force, least, late);
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
          for (const JudgedForce one :
               {JudgedForce::normal,
                JudgedForce::tangential,
                or_moment(JudgedForce::normal, least, *v)})
            if (largest_of(v->of(one)) > least)
              return false;
        return true;
      }

      ForceStatistics   half;
      QuarterVibrations early, late;
      double            least;                       /**< N: less is noise */
      JudgedForce       force = JudgedForce::normal; /**< that is judged */
    };



    std::string
    name_of(const JudgedForce force, const ContactPair &pair)
    {
      switch (force)
        {
        case JudgedForce::normal:
          return "normal force";
        case JudgedForce::tangential:
          return "tangential force";
        case JudgedForce::first_moment:
          return pressure_moments(pair.geometry).names[0];
        case JudgedForce::second_moment:
          return pressure_moments(pair.geometry).names[1];
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
                              name_of(vibrations[i].force, pair)});
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

    /** The member of the forces of a step that a judged force is. */
    double StepForces::       *
    step_of(const JudgedForce force)
    {
      switch (force)
        {
        case JudgedForce::normal:
          return &StepForces::normal;
        case JudgedForce::tangential:
          return &StepForces::tangential;
        case JudgedForce::first_moment:
          return &StepForces::first_moment;
        case JudgedForce::second_moment:
          return &StepForces::second_moment;
        }
      unknown_choice("judged force");
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
    return force == JudgedForce::first_moment ||
           force == JudgedForce::second_moment;
  }

  double PairSample::       *
  sample_of(const JudgedForce force)
  {
    switch (force)
      {
      case JudgedForce::normal:
        return &PairSample::normal;
      case JudgedForce::tangential:
        return &PairSample::pulling;
      case JudgedForce::first_moment:
        return &PairSample::first_moment;
      case JudgedForce::second_moment:
        return &PairSample::second_moment;
      }
    unknown_choice("judged force");
  }

  double
  rms_of_pressure(const ForceStatistics &pair)
  {
    return pair.rms(
      or_moment(JudgedForce::normal,
                least_vibration * pair.mean_normal,
                [&](const JudgedForce force) { return pair.rms(force); }));
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
    const PairVibration &v = vibrations[f.loudest.number];
    const JudgedForce    pressing =
      f.loudest.is_by_moment() ? f.loudest.force : JudgedForce::normal;
    f.mean_normal      = v.half.mean_normal;
    f.rms_normal       = v.half.rms(pressing);
    f.most_rms_of_sum  = largest_of(v.late.normal);
    f.min_normal       = v.half.min_normal;
    f.max_normal       = v.half.max_normal;
    f.mean_tangential  = v.half.mean_tangential;
    f.rms_tangential   = v.half.rms_tangential();
    f.rms_change       = change_of_rms(v.late.of(pressing));
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
    double StepForces::*const of_step = step_of(pair.force);
    std::vector<double>       force;
    for (std::size_t k = n - std::min(n, of_half); k < n; ++k)
      {
        const StepForces &s = steps[k * n_pairs + pair.number];
        force.push_back(s.*of_step);
      }
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
