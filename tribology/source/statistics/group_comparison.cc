// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/number_text.h>
#include <squeal/tribology/setup/feature_columns.h>
#include <squeal/tribology/statistics/association.h>
#include <squeal/tribology/statistics/pad_tables.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <set>

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
        if (std::isfinite(map.values[k]) && weights.values[k] > 0.)
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

    /** Sums of pads are rounded in another order for each choice of them:
     * differences of means that lie as close, over the largest value, are the
     * same. */
    constexpr double same_means = 1e-12;

    /** Part of all choices of as many values as there are @p chosen_values whose
     * difference of means from the rest is at least that of these from
     * @p others; of random ones, with the one at hand among them, where there
     * are too many. The order of the values does not matter. */
    double
    permutation_p(const std::vector<double> &others,
                  const std::vector<double> &chosen_values,
                  const unsigned int         seed)
    {
      std::vector<double> values = others;
      values.insert(values.end(), chosen_values.begin(), chosen_values.end());
      std::sort(values.begin(), values.end());
      const std::size_t n = values.size(), k = chosen_values.size();
      const double      sum = std::accumulate(values.begin(), values.end(), 0.);
      const auto        difference = [&](const double in) {
        return std::abs(in / k - (sum - in) / (n - k));
      };
      const double least = difference(std::accumulate(
                             chosen_values.begin(), chosen_values.end(), 0.)) -
                           same_means * std::max(std::abs(values.front()),
                                                 std::abs(values.back()));
      double     n_all = 0., n_larger = 0.;
      const auto count = [&](const double in) {
        n_all += 1.;
        n_larger += difference(in) >= least ? 1. : 0.;
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



    double
    mean_of(const std::vector<double> &values)
    {
      double mean = 0.;
      for (const double v : values)
        mean += v / values.size();
      return mean;
    }



    /** Names of the features that any pad has. */
    std::set<std::string>
    features_of(const std::vector<PadMaps> &pads)
    {
      std::set<std::string> names;
      for (const PadMaps &pad : pads)
        for (const auto &[name, map] : pad.features)
          names.insert(name);
      return names;
    }



    /** Mean of a feature on a pad, NaN where it has none. */
    double
    mean_on(const PadMaps &pad, const std::string &feature)
    {
      const auto it = pad.features.find(feature);
      if (it == pad.features.end())
        return NAN;
      const bool is_by_length =
        is_mean_along_cracks(feature) && pad.crack_length.size() > 0;
      return known_mean(it->second, is_by_length ? pad.crack_length : pad.seen);
    }



    /** Smallest p-value that the numbers of pads allow. */
    double
    smallest_p(const GroupResult &result)
    {
      const double both = result.n_silent == result.n_squealing ? 2. : 1.;
      return std::min(1.,
                      both /
                        number_of_choices(result.n_silent + result.n_squealing,
                                          result.n_squealing));
    }



    /** Verdicts of all features together. */
    void
    decide_groups(std::vector<GroupResult> &results, const double level)
    {
      std::vector<double> p_values;
      for (const GroupResult &result : results)
        p_values.push_back(result.p_value);
      const std::vector<double> adjusted = holm(p_values);
      for (std::size_t i = 0; i < results.size(); ++i)
        {
          GroupResult &result   = results[i];
          const double smallest = smallest_p(result),
                       n        = double(results.size());
          result.p_adjusted     = adjusted[i];
          if (adjusted[i] <= level)
            result.verdict = result.mean_squealing > result.mean_silent
                               ? Verdict::supported
                               : Verdict::contradicted;
          else if (smallest > level)
            result.reason = "So few pads cannot decide: a pad is one sample, "
                            "and the smallest p-value of these numbers is " +
                            rounded_text(smallest, 2) + ".";
          else if (n * smallest > level)
            result.reason = "So few pads cannot decide among " +
                            std::to_string(results.size()) +
                            " features: the smallest p-value of these "
                            "numbers, adjusted, is " +
                            rounded_text(std::min(1., n * smallest), 2) +
                            "; name fewer in 'Features'.";
        }
    }
  } // namespace



  std::vector<GroupResult>
  compare_groups(const std::vector<PadMaps>  &pads,
                 const CorrelationParameters &p)
  {
    std::vector<GroupResult> results;
    for (const std::string &feature : features_of(pads))
      {
        GroupResult         result;
        std::vector<double> silent, squealing;
        for (const PadMaps &pad : pads)
          if (const double mean = mean_on(pad, feature); std::isfinite(mean))
            (pad.is_silent ? silent : squealing).push_back(mean);
        if (silent.empty() || squealing.empty())
          continue;
        result.feature        = feature;
        result.n_silent       = silent.size();
        result.n_squealing    = squealing.size();
        result.mean_silent    = mean_of(silent);
        result.mean_squealing = mean_of(squealing);
        result.p_value        = std::max(smallest_p(result),
                                  permutation_p(silent, squealing, p.seed));
        results.push_back(result);
      }
    decide_groups(results, p.level);
    return results;
  }



  std::vector<std::string>
  warnings_of_lacking_features(const std::vector<PadMaps>  &pads,
                               const CorrelationParameters &p)
  {
    std::vector<std::string> warnings;
    if (p.groups.empty())
      return warnings;
    for (const std::string &feature : features_of(pads))
      {
        std::string lacking;
        std::size_t n_lacking = 0;
        for (std::size_t pad = 0; pad < pads.size(); ++pad)
          if (!std::isfinite(mean_on(pads[pad], feature)))
            {
              lacking +=
                (lacking.empty() ? "" : ", ") + std::to_string(pad + 1);
              ++n_lacking;
            }
        if (n_lacking > 0)
          warnings.push_back(
            "feature '" + feature + "': pad" + (n_lacking > 1 ? "s " : " ") +
            lacking + (n_lacking > 1 ? " have" : " has") +
            " no value of it, and groups are compared without; "
            "give every pad the same features");
      }
    return warnings;
  }
} // namespace squeal::tribology
