// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/tribology/fatigue/damage_counter.h>

#include <algorithm>

namespace squeal::tribology
{
  CountingRules
  counting_rules(const FatigueParameters &fatigue)
  {
    return {fatigue.residue == FatigueParameters::Residue::repeating
              ? RainflowCounter::Residue::repeating
              : RainflowCounter::Residue::half_cycles,
            sn_curves(fatigue),
            MeanStressCorrection(fatigue),
            fatigue.accumulation,
            {},
            {}};
  }



  DamageCounter::DamageCounter(const CountingRules &rules)
    : rules(&rules)
    , counter(rules.residue)
    , miner(rules.curves.size(), 0.)
    , straight_sums(rules.straight_curves.size(), 0.)
    , range_mean(rules.empty_matrix)
  {
    if (rules.accumulation == FatigueParameters::Accumulation::manson_halford)
      curves_of_damage.resize(rules.curves.size());
  }



  void
  DamageCounter::take(const double range, const double mean, const double count)
  {
    ranges[n_waiting] = range;
    means[n_waiting]  = mean;
    counts[n_waiting] = count;
    if (++n_waiting == batch)
      flush();
  }



  void
  DamageCounter::add(const double     *stresses,
                     const std::size_t n,
                     const std::size_t stride)
  {
    counter.add(stresses,
                n,
                stride,
                [this](const double range, const double mean, const double c) {
                  take(range, mean, c);
                });
  }



  void
  DamageCounter::finish()
  {
    counter.finish([this](const double range,
                          const double mean,
                          const double c) { take(range, mean, c); });
    flush();
    sums = miner;
    for (std::size_t i = 0; i < curves_of_damage.size(); ++i)
      sums[i] = curves_of_damage[i].share();
  }



  void
  DamageCounter::flush()
  {
    std::array<double, batch> amplitudes, damages;
    for (std::size_t i = 0; i < n_waiting; ++i)
      {
        amplitudes[i] = 0.5 * ranges[i];
        cycles += counts[i];
        largest = std::max(largest, ranges[i]);
      }
    if (range_mean)
      for (std::size_t i = 0; i < n_waiting; ++i)
        range_mean->add(ranges[i], means[i], counts[i]);
    for (std::size_t c = 0; c < straight_sums.size(); ++c)
      {
        rules->straight_curves[c].damage(
          amplitudes.data(), n_waiting, damages.data());
        for (std::size_t i = 0; i < n_waiting; ++i)
          straight_sums[c] += counts[i] * damages[i];
      }
    if (!rules->correction.is_none())
      for (std::size_t i = 0; i < n_waiting; ++i)
        amplitudes[i] =
          rules->correction.equivalent_amplitude(amplitudes[i], means[i]);
    for (std::size_t c = 0; c < miner.size(); ++c)
      {
        rules->curves[c].damage(amplitudes.data(), n_waiting, damages.data());
        for (std::size_t i = 0; i < n_waiting; ++i)
          miner[c] += counts[i] * damages[i];
        if (!curves_of_damage.empty())
          for (std::size_t i = 0; i < n_waiting; ++i)
            curves_of_damage[c].add(counts[i], damages[i]);
      }
    n_waiting = 0;
  }



  const std::vector<double> &
  DamageCounter::damages() const
  {
    return sums;
  }



  const std::vector<double> &
  DamageCounter::closed_damages()
  {
    flush();
    return miner;
  }

  const std::vector<double> &
  DamageCounter::miner_sums() const
  {
    return miner;
  }



  const std::vector<double> &
  DamageCounter::straight_damages() const
  {
    return straight_sums;
  }



  double
  DamageCounter::n_cycles() const
  {
    return cycles;
  }



  double
  DamageCounter::largest_range() const
  {
    return largest;
  }



  std::size_t
  DamageCounter::deepest() const
  {
    return counter.deepest();
  }



  const std::optional<RangeMeanMatrix> &
  DamageCounter::matrix() const
  {
    return range_mean;
  }
} // namespace squeal::tribology
