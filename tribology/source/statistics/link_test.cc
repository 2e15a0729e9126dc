// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/tribology/statistics/association.h>
#include <squeal/tribology/statistics/link_test.h>

#include <algorithm>
#include <cmath>

namespace squeal::tribology
{
  std::string
  verdict_text(const Verdict verdict, const bool is_synthetic)
  {
    const std::string text = verdict == Verdict::supported      ? "supported"
                             : verdict == Verdict::contradicted ? "contradicted"
                                                                : "undecided";
    return (is_synthetic ? "synthetic: " : "") + text;
  }



  LinkTest
  measure_link(const GridMap               &index,
               const GridMap               &feature,
               const CorrelationParameters &p,
               std::mt19937_64             &generator)
  {
    const auto [x, y] = common_values(index, feature);
    LinkTest test;
    test.n_cells     = x.size();
    test.n_effective = static_cast<double>(x.size());
    test.r           = pearson(x, y);
    if (x.size() < 4 || std::isnan(test.r))
      {
        test.rho = test.auc = test.overlap = NAN;
        return test;
      }
    test.rho         = spearman(x, y);
    test.auc         = roc_auc(x, y, feature_threshold(y));
    test.overlap     = top_decile_overlap(x, y);
    test.n_effective = effective_sample_size(index, feature);
    test.p_effective = correlation_p_value(test.r, test.n_effective);
    test.p_surrogate =
      surrogate_p_value(index, feature, p.n_surrogates, generator);
    test.interval  = correlation_interval(test.r, test.n_effective, p.level);
    test.bootstrap = block_bootstrap_interval(
      index, feature, p.n_bootstraps, p.level, generator);
    test.power = correlation_power(p.relevant_link, test.n_effective, p.level);
    return test;
  }



  void
  decide(std::vector<LinkTest> &tests, const CorrelationParameters &p)
  {
    std::vector<double> worse;
    for (const LinkTest &test : tests)
      worse.push_back(std::max(test.p_effective, test.p_surrogate));
    const std::vector<double> adjusted = holm(worse);
    for (std::size_t i = 0; i < tests.size(); ++i)
      {
        LinkTest &test  = tests[i];
        test.p_adjusted = adjusted[i];
        if (adjusted[i] <= p.level)
          test.verdict =
            test.r > 0. ? Verdict::supported : Verdict::contradicted;
        else if (test.power >= p.wanted_power &&
                 test.interval[1] < p.relevant_link)
          test.verdict = Verdict::contradicted;
        else
          test.verdict = Verdict::undecided;
      }
  }



  SelfTestRow
  self_test(const double                 length,
            const double                 link,
            const unsigned int           n_pairs,
            const unsigned int           n_surrogates,
            const CorrelationParameters &p)
  {
    const std::size_t n = 11;
    SelfTestRow       row;
    row.length  = length;
    row.link    = link;
    row.n_pairs = n_pairs;
    for (unsigned int pair = 0; pair < n_pairs; ++pair)
      {
        std::seed_seq   seeds{p.seed,
                            pair,
                            static_cast<unsigned int>(1000. * length),
                            static_cast<unsigned int>(1000. * link)};
        std::mt19937_64 generator(seeds);
        const GridMap   x     = random_map(n, n, length, generator);
        const GridMap   other = random_map(n, n, length, generator);
        GridMap         y     = x;
        for (std::size_t i = 0; i < y.size(); ++i)
          y.values[i] =
            link * x.values[i] + std::sqrt(1. - link * link) * other.values[i];
        const double r = pearson(x.values, y.values);
        const bool   plain =
          correlation_p_value(r, static_cast<double>(x.size())) <= p.level;
        const bool effective =
          correlation_p_value(r, effective_sample_size(x, y)) <= p.level;
        const bool surrogate =
          surrogate_p_value(x, y, n_surrogates, generator) <= p.level;
        row.n_plain += plain;
        row.n_effective += effective;
        row.n_surrogate += surrogate;
        row.n_both += effective && surrogate;
      }
    return row;
  }
} // namespace squeal::tribology
