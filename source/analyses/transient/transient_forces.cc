// SPDX-License-Identifier: LGPL-2.1-or-later

// What the contact forces of a transient do: of the pairs together, and of the
// one that vibrates most.

#include <squeal/analyses/transient/transient_results.h>
#include <squeal/analyses/transient/transient_verdict.h>
#include <squeal/base/number_text.h>
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



    /** Nodes that vibrate each on its own, as where they open and close one
     * after the other, leave their sum 1 / sqrt(n) of what they do, and that is
     * a fair judge of them. This many times less is left by none but waves. */
    constexpr double beyond_chance = 3.;

    /** Of ten periods: pressure that wanders from some nodes to others leaves
     * less beside its slow part. */
    constexpr unsigned int least_crossings = 20;

    /** Whether the nodes of a pair, @p n of them, vibrate by more than noise of
     * @p least, N, and in every quarter by far more than its sums and moments
     * do. */
    bool
    cancels(const NodeVibrations    &nodes,
            const QuarterVibrations &sums,
            const unsigned int       n,
            const double             least)
    {
      double most = 0.;
      for (const auto *one : {&sums.normal, &sums.tangential, &sums.moment})
        most = worst_of(most, largest_of(*one));
      return nodes.n_crossings >= least_crossings &&
             largest_of(nodes.all) > least &&
             *std::min_element(nodes.all.begin(), nodes.all.end()) >
               std::max(far_louder, beyond_chance * std::sqrt(n)) * most;
    }

    /** Whether a force that vibrates by @p other, N, is judged: more than noise
     * of @p least, and by far more than the @p force that else is. */
    bool
    is_by_far(const double other, const double force, const double least)
    {
      return other > least && other > far_louder * force;
    }

    /** Forces of one pair in every step of a run. */
    struct PairVibration
    {
      PairVibration(const std::vector<ForceStatistics> &stretches,
                    const WatchedNodes                 &watched,
                    const ContactPair                  &pair)
        : half(statistics_of(stretches, middle, n_force_stretches))
        , early(vibrations_of(stretches, 0, middle))
        , late(vibrations_of(stretches, middle, n_force_stretches))
        , early_nodes(vibrations_of_nodes(watched, pair, 0, middle))
        , late_nodes(
            vibrations_of_nodes(watched, pair, middle, n_force_stretches))
        , n_nodes(pair.n_nodes())
        , least(least_vibration * half.mean_normal)
      {
        // Pure stick-slip leaves the normal force alone, but for what rings on
        // since the load came.
        const double normal     = largest_of(late.normal),
                     tangential = largest_of(late.tangential);
        if (half.mean_normal > 0. &&
            (is_by_far(tangential, normal, least) ||
             (tangential > least && !(normal > least))))
          force = JudgedForce::tangential;
        if (half.mean_normal > 0. &&
            is_by_far(largest_of(late.moment), largest_of(judged()), least))
          force = JudgedForce::moment;
        if (half.mean_normal > 0. && cancels(late_nodes, late, n_nodes, least))
          force = JudgedForce::node;
      }

      /** The force that is judged, by quarters of the second half, N. */
      const std::vector<double> &
      judged() const
      {
        return force == JudgedForce::node ? late_nodes.of_loudest
                                          : late.of(force);
      }

      /** As JudgedPair::share. */
      double
      share() const
      {
        return force == JudgedForce::node ? 1. / n_nodes : 1.;
      }

      /** Its largest vibration over its share of the mean normal force. */
      double
      loudness() const
      {
        return half.mean_normal > 0.
                 ? largest_of(judged()) / (share() * half.mean_normal)
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
        return !cancels(early_nodes, early, n_nodes, least) &&
               !cancels(late_nodes, late, n_nodes, least);
      }

      ForceStatistics   half;
      QuarterVibrations early, late;
      NodeVibrations    early_nodes, late_nodes;
      unsigned int      n_nodes;
      double            least;                       /**< N: less is noise */
      JudgedForce       force = JudgedForce::normal; /**< that is judged */
    };



    /** "normal force of node 12 at (0.275, 0, 0.01) m": as in zones.csv. */
    std::string
    name_of_node(const unsigned int number, const ContactPair &pair)
    {
      const auto &x = pair.geometry.points[number - pair.first];
      return "normal force of node " + std::to_string(number) + " at (" +
             rounded_text(x[0], 4) + ", " + rounded_text(x[1], 4) + ", " +
             rounded_text(x[2], 4) + ") m";
    }

    std::string
    name_of(const PairVibration &vibration,
            const WatchedNodes  &watched,
            const ContactPair   &pair)
    {
      switch (vibration.force)
        {
        case JudgedForce::normal:
          return "normal force";
        case JudgedForce::tangential:
          return "tangential force";
        case JudgedForce::moment:
          return pressure_moments(pair.geometry).name_of(vibration.late.parts);
        case JudgedForce::node:
          return name_of_node(watched.numbers[vibration.late_nodes.loudest],
                              pair);
        }
      unknown_choice("judged force");
    }



    /** Of the pairs that count for the resultants those that carry; the first
     * where none does. */
    std::vector<JudgedPair>
    judged_pairs(const ContactNodes               &nodes,
                 const WatchedNodes               &watched,
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
                              name_of(vibrations[i], watched, pair),
                              vibrations[i].late.parts,
                              vibrations[i].late_nodes.loudest,
                              vibrations[i].share()});
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
        case JudgedForce::node:
          break; // is none of these
        }
      unknown_choice("judged force");
    }

    /** The force that is judged in each of the last steps, N. */
    std::vector<double>
    last_steps_of(const TransientRecord &record, const JudgedPair &pair)
    {
      if (pair.force == JudgedForce::node)
        return record.watched.series(record.watched.last_steps, pair.watched);
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

    /** What the cycles that a window of @p time, s, cuts change at most: of the
     * mean @p mean of values from @p least to @p most that repeat with @p
     * frequency, Hz. Over a part of a period the values less their mean add up
     * to the most where they are the largest first and the least then. */
    double
    error_of_cut(const double mean,
                 const double least,
                 const double most,
                 const double frequency,
                 const double time)
    {
      return most > least ? (most - mean) * (mean - least) /
                              ((most - least) * frequency * time)
                          : 0.;
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

  bool
  JudgedPair::is_beside_sums() const
  {
    return is_by_moment() || force == JudgedForce::node;
  }

  std::vector<double>
  samples_of(const TransientRecord &record, const JudgedPair &pair)
  {
    if (pair.force == JudgedForce::node)
      return record.watched.series(record.watched.samples, pair.watched);
    std::vector<double> result;
    for (std::size_t k = 0; k < record.samples.size(); ++k)
      {
        const PairSample &now = record.pair(k, pair.number);
        result.push_back(value_of(pair, now, now.pulling));
      }
    return result;
  }

  double
  rms_of_pressure(const JudgedPair      &pair,
                  const TransientRecord &record,
                  const unsigned int     first,
                  const unsigned int     end)
  {
    if (pair.force == JudgedForce::node)
      return record.watched.rms(pair.watched, first, end);
    const ForceStatistics s =
      statistics_of(record.stretches_of(pair.number), first, end);
    return pair.is_by_moment()
             ? rms_of(s.moment(loudest_moment(
                 s.square_first, s.square_second, s.mixed_moments)))
             : s.rms_normal();
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
      return s.mean_normal > 0. ? rms_of_pressure(pair, record, first, end) /
                                    (pair.share * s.mean_normal)
                                : 0.;
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
      vibrations.emplace_back(
        record.stretches_of(i), record.watched, nodes.pairs()[i]);
    f.judged  = judged_pairs(nodes, record.watched, vibrations);
    f.loudest = loudest_of(f.judged, [&](const JudgedPair &pair) {
      return vibrations[pair.number].loudness();
    });
    f.is_silent =
      std::all_of(f.judged.begin(), f.judged.end(), [&](const JudgedPair &p) {
        return vibrations[p.number].is_silent();
      });
    const PairVibration &v = vibrations[f.loudest.number];
    f.mean_normal          = v.half.mean_normal;
    f.rms_normal =
      f.loudest.is_by_moment() ? rms_of(v.half.moment(f.loudest.parts))
      : f.loudest.force == JudgedForce::node
        ? record.watched.rms(f.loudest.watched, middle, n_force_stretches)
        : v.half.rms_normal();
    f.most_rms_of_sum = largest_of(v.late.normal);
    f.min_normal      = v.half.min_normal;
    f.max_normal      = v.half.max_normal;
    f.mean_tangential = v.half.mean_tangential;
    f.rms_tangential  = v.half.rms_tangential();
    f.rms_change =
      change_of_rms(f.loudest.is_beside_sums() ? v.judged() : v.late.normal);
    f.rms_change_share = share_of_change(v.judged());
    f.least_rms = *std::min_element(v.judged().begin(), v.judged().end());
    f.most_rms  = largest_of(v.judged());
  }



  void
  evaluate_cut(const double time, TransientFigures &f)
  {
    if (!f.has_limit_cycle || !(f.frequency > 0.) ||
        !(f.repetition >= least_repetition))
      return;
    f.mean_normal_error = error_of_cut(
      f.mean_normal, f.min_normal, f.max_normal, f.frequency, time);
    if (f.loudest.is_beside_sums() || !(f.rms_normal > 0.))
      return;
    const double farthest =
      std::max(f.max_normal - f.mean_normal, f.mean_normal - f.min_normal);
    f.rms_normal_error = error_of_cut(f.rms_normal * f.rms_normal,
                                      0.,
                                      farthest * farthest,
                                      f.frequency,
                                      time) /
                         (2. * f.rms_normal);
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
    return !(f.most_rms > least_vibration * f.loudest.share * f.mean_normal);
  }
} // namespace squeal
