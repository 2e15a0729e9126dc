// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/number_text.h>
#include <squeal/tribology/statistics/pad_tables.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

namespace squeal::tribology
{
  namespace
  {
    /** The mean over what is known of the face. */
    double
    known_mean(const GridMap &map, const GridMap &weights)
    {
      double sum = 0., weight = 0.;
      for (std::size_t k = 0; k < map.values.size(); ++k)
        if (std::isfinite(map.values[k]))
          {
            sum += weights.values[k] * map.values[k];
            weight += weights.values[k];
          }
      return weight > 0. ? sum / weight : NAN;
    }



    /** More choices of pads than this are drawn at random. */
    constexpr double most_choices = 1e6;
    constexpr double n_drawn      = 2e5;

    /** How many ways there are to choose @p k of @p n. */
    double
    number_of_choices(const std::size_t n, const std::size_t k)
    {
      double result = 1.;
      for (std::size_t i = 1; i <= k; ++i)
        result *= double(n - k + i) / i;
      return result;
    }

    /** Part of all choices of @p k of the values whose difference of means is
     * at least the one given; of random ones, with the one at hand among them,
     * where there are too many. The order of @p values does not matter. */
    double
    permutation_p(std::vector<double> values,
                  const std::size_t   k,
                  const double        observed,
                  const unsigned int  seed)
    {
      std::sort(values.begin(), values.end());
      const std::size_t n   = values.size();
      const double      sum = std::accumulate(values.begin(), values.end(), 0.);
      double            n_all = 0., n_larger = 0.;
      const auto        count = [&](const double in) {
        const double difference = in / k - (sum - in) / (n - k);
        n_all += 1.;
        n_larger +=
          std::abs(difference) >= std::abs(observed) * (1. - 1e-12) ? 1. : 0.;
      };
      if (number_of_choices(n, k) > most_choices)
        {
          std::mt19937_64 generator(seed);
          for (n_all = n_larger = 1.; n_all < n_drawn;)
            {
              double in = 0.;
              for (std::size_t i = 0; i < k; ++i)
                {
                  std::uniform_int_distribution<std::size_t> rest(i, n - 1);
                  std::swap(values[i], values[rest(generator)]);
                  in += values[i];
                }
              count(in);
            }
          return n_larger / n_all;
        }
      std::vector<int> chosen(n, 0);
      std::fill(chosen.end() - k, chosen.end(), 1);
      do
        count(
          std::inner_product(values.begin(), values.end(), chosen.begin(), 0.));
      while (std::next_permutation(chosen.begin(), chosen.end()));
      return n_larger / n_all;
    }
  } // namespace



  std::vector<GroupResult>
  compare_groups(const std::vector<PadMaps>  &pads,
                 const CorrelationParameters &p)
  {
    std::vector<GroupResult> results;
    if (pads.empty())
      return results;
    for (const auto &[feature, map] : pads[0].features)
      {
        GroupResult         result;
        std::vector<double> silent, squealing;
        result.feature = feature;
        for (const PadMaps &pad : pads)
          if (pad.features.count(feature) > 0)
            if (const double mean =
                  known_mean(pad.features.at(feature), pad.seen);
                std::isfinite(mean))
              (pad.is_silent ? silent : squealing).push_back(mean);
        if (silent.empty() || squealing.empty())
          continue;
        result.n_silent    = silent.size();
        result.n_squealing = squealing.size();
        for (const double v : silent)
          result.mean_silent += v / silent.size();
        for (const double v : squealing)
          result.mean_squealing += v / squealing.size();
        const double difference = result.mean_squealing - result.mean_silent;
        std::vector<double> all = silent;
        all.insert(all.end(), squealing.begin(), squealing.end());
        result.p_value =
          permutation_p(all, squealing.size(), difference, p.seed);
        const double smallest =
          std::min(1.,
                   (silent.size() == squealing.size() ? 2. : 1.) /
                     number_of_choices(all.size(), squealing.size()));
        if (result.p_value <= p.level)
          result.verdict =
            difference > 0. ? Verdict::supported : Verdict::contradicted;
        else if (smallest > p.level)
          result.reason = "So few pads cannot decide: a pad is one sample, and "
                          "the smallest p-value of these numbers is " +
                          rounded_text(smallest, 2) + ".";
        results.push_back(result);
      }
    return results;
  }
} // namespace squeal::tribology
