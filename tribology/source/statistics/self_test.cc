// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/tribology/statistics/association.h>
#include <squeal/tribology/statistics/self_test.h>

#include <algorithm>
#include <cmath>

namespace squeal::tribology
{
  namespace
  {
    /** 1 in the three tenths of a random map that are lowest. */
    GridMap
    lowest_part(const std::size_t n, const unsigned int seed)
    {
      std::mt19937_64     generator(seed);
      GridMap             map    = random_map(n, n, 3., generator);
      std::vector<double> sorted = map.values;
      std::sort(sorted.begin(), sorted.end());
      for (double &v : map.values)
        v = v < sorted[3 * sorted.size() / 10] ? 1. : 0.;
      return map;
    }



    /** Correlation lengths across and along the sliding direction. */
    std::array<double, 2>
    lengths_of(const SelfTestRow &row)
    {
      const double stretch = row.pattern == SharedPattern::streaks ? 4. : 1.;
      return {{row.length / stretch, row.length * stretch}};
    }



    bool
    holds(const std::array<double, 2> &interval, const double value)
    {
      return interval[0] <= value && value <= interval[1];
    }
  } // namespace



  SelfTest::SelfTest(const CorrelationParameters &p)
    : parameters(p)
    , plateaus(lowest_part(n, p.seed))
    , causes(shared_causes({n, n, {}}, p.shared_causes, LeadingEdge::lowest_y))
    , causes_with_plateaus(shared_causes({n, n, {}},
                                         p.shared_causes,
                                         LeadingEdge::lowest_y,
                                         {{"plateaus", plateaus}}))
    , tests(causes)
    , tests_with_plateaus(causes_with_plateaus)
  {
  }



  GridMap
  SelfTest::shared(const SharedPattern pattern) const
  {
    GridMap map{n, n, std::vector<double>(n * n, 0.)};
    for (std::size_t cell = 0; cell < n * n; ++cell)
      {
        const std::size_t i = cell % n, j = cell / n;
        double           &value = map.values[cell];
        switch (pattern)
          {
          case SharedPattern::none:
          case SharedPattern::streaks:
            break;
          case SharedPattern::trend:
            value = 4. * j / (n - 1.) - 2.;
            break;
          case SharedPattern::rim:
            value = i == 0 || j == 0 || i == n - 1 || j == n - 1 ? 2. : 0.;
            break;
          case SharedPattern::leading_edge:
            value = 2. * std::exp(-double(j) / 1.5);
            break;
          case SharedPattern::mask:
            value = -2. * plateaus.values[cell];
            break;
          }
      }
    return map;
  }



  void
  SelfTest::add_pair(SelfTestRow       &row,
                     const GridMap     &pattern,
                     const unsigned int n_surrogates,
                     std::mt19937_64   &generator)
  {
    const auto    lengths   = lengths_of(row);
    GridMap       x         = random_map(n, n, lengths, generator);
    const GridMap other     = random_map(n, n, lengths, generator);
    GridMap       y         = x;
    const bool    is_masked = row.pattern == SharedPattern::mask;
    for (std::size_t cell = 0; cell < y.size(); ++cell)
      {
        y.values[cell] =
          row.link * x.values[cell] +
          std::sqrt(1. - row.link * row.link) * other.values[cell] +
          pattern.values[cell];
        x.values[cell] += pattern.values[cell];
        // two columns of cells that no image shows
        if (is_masked && cell % n > n - 3)
          y.values[cell] = NAN;
      }
    const auto   values = common_values(x, y);
    const double level = parameters.level, r = pearson(values[0], values[1]);
    const bool   effective =
      correlation_p_value(r, effective_sample_size(x, y)) <= level;
    const bool surrogate =
      surrogate_p_value(x, y, n_surrogates, generator) <= level;
    const ConditionalLink link =
      (is_masked ? tests_with_plateaus : tests).measure(x, y);
    row.n_plain += correlation_p_value(r, double(values[0].size())) <= level;
    row.n_effective += effective;
    row.n_surrogate += surrogate;
    row.n_both += effective && surrogate;
    row.n_conditional += link.p <= level;
    row.n_covered += holds(conditional_interval(link, .05), row.link);
    row.n_covered_bootstrap +=
      holds(bootstrap_interval(link, 199, .05, generator), row.link);
    row.conditional_cells += link.n_effective / row.n_pairs;
  }



  SelfTestRow
  SelfTest::run(const SharedPattern pattern,
                const double        length,
                const double        link,
                const unsigned int  n_pairs,
                const unsigned int  n_surrogates)
  {
    SelfTestRow row;
    row.pattern          = pattern;
    row.length           = length;
    row.link             = link;
    row.n_pairs          = n_pairs;
    const GridMap common = shared(pattern);
    for (unsigned int pair = 0; pair < n_pairs; ++pair)
      {
        std::seed_seq   seeds{parameters.seed,
                            pair,
                            static_cast<unsigned int>(1000. * length),
                            static_cast<unsigned int>(1000. * link),
                            static_cast<unsigned int>(pattern)};
        std::mt19937_64 generator(seeds);
        add_pair(row, common, n_surrogates, generator);
      }
    return row;
  }
} // namespace squeal::tribology
