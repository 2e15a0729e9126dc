// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/tribology/statistics/association.h>
#include <squeal/tribology/statistics/link_test.h>

#include <algorithm>
#include <cmath>

namespace squeal::tribology
{
  namespace
  {
    /** What a verdict looks at. */
    struct Evidence
    {
      double r = 0., n_effective = 0., p_adjusted = 1., level = .05;

      double
      power(const double link) const
      {
        return correlation_power(link, n_effective, level);
      }

      Verdict
      verdict(const CorrelationParameters &p) const
      {
        if (p_adjusted <= p.level)
          return r > 0. ? Verdict::supported : Verdict::contradicted;
        const bool is_excluded =
          correlation_interval(r, n_effective, level)[1] < p.relevant_link;
        return power(p.relevant_link) >= p.wanted_power && is_excluded
                 ? Verdict::contradicted
                 : Verdict::undecided;
      }
    };



    /** The level at which each test was held against its own p-value: Holm
     * divides by the tests that were left when its turn came. */
    std::vector<double>
    levels_used(const std::vector<double> &p_values,
                const std::vector<double> &adjusted,
                const double               level)
    {
      std::vector<double> levels;
      for (std::size_t i = 0; i < p_values.size(); ++i)
        {
          std::size_t n_before = 0;
          for (std::size_t j = 0; j < p_values.size(); ++j)
            n_before += adjusted[j] <= level &&
                        (adjusted[i] > level || p_values[j] < p_values[i]);
          levels.push_back(level / (p_values.size() - n_before));
        }
      return levels;
    }
  } // namespace



  std::string
  verdict_text(const Verdict verdict, const bool is_synthetic)
  {
    const std::string text = verdict == Verdict::supported      ? "supported"
                             : verdict == Verdict::contradicted ? "contradicted"
                                                                : "undecided";
    return (is_synthetic ? "synthetic: " : "") + text;
  }



  unsigned int
  surrogates_needed(const CorrelationParameters &p, const std::size_t n_links)
  {
    const double wanted = std::ceil(10. * n_links / p.level);
    return std::max(p.n_surrogates,
                    static_cast<unsigned int>(std::min(wanted, 1e7)));
  }



  LinkTest
  measure_link(const GridMap               &index,
               const GridMap               &feature,
               ConditionalTests            &conditional,
               const CorrelationParameters &p,
               const unsigned int           n_surrogates,
               std::mt19937_64             &generator)
  {
    const auto [x, y] = common_values(index, feature);
    LinkTest test;
    test.n_cells     = x.size();
    test.n_effective = static_cast<double>(x.size());
    test.r           = pearson(x, y);
    test.reference =
      reference_links(feature, conditional.shared_causes().leading_edge);
    test.conditional = conditional.measure(index, feature);
    if (p.n_bootstraps == 0)
      test.bootstrap = {{NAN, NAN}};
    if (x.size() < 4 || std::isnan(test.r))
      {
        test.rho = test.auc = test.overlap = NAN;
        return test;
      }
    test.rho           = spearman(x, y);
    test.auc           = roc_auc(x, y, feature_threshold(y));
    test.overlap       = top_decile_overlap(x, y);
    test.n_effective   = effective_sample_size(index, feature);
    test.index_cells   = effective_sample_size(index, index);
    test.feature_cells = effective_sample_size(feature, feature);
    test.p_effective   = correlation_p_value(test.r, test.n_effective);
    test.p_surrogate =
      surrogate_p_value(index, feature, n_surrogates, generator);
    test.interval = correlation_interval(test.r, test.n_effective, p.level);
    test.conditional_interval = conditional_interval(test.conditional, p.level);
    if (p.n_bootstraps > 0)
      test.bootstrap = bootstrap_interval(
        test.conditional, p.n_bootstraps, p.level, generator);
    return test;
  }



  void
  decide(std::vector<LinkTest> &tests, const CorrelationParameters &p)
  {
    std::vector<double> without, with;
    for (const LinkTest &test : tests)
      {
        without.push_back(std::max(test.p_effective, test.p_surrogate));
        with.push_back(test.conditional.p);
      }
    const std::vector<double> adjusted_without = holm(without),
                              adjusted         = holm(with);
    const std::vector<double> levels_without =
                                levels_used(without, adjusted_without, p.level),
                              levels = levels_used(with, adjusted, p.level);
    for (std::size_t i = 0; i < tests.size(); ++i)
      {
        LinkTest      &test = tests[i];
        const Evidence plain{
          test.r, test.n_effective, adjusted_without[i], levels_without[i]};
        test.p_without       = adjusted_without[i];
        test.verdict_without = plain.verdict(p);
        const Evidence beside{test.conditional.r,
                              test.conditional.n_effective,
                              adjusted[i],
                              levels[i]};
        test.p_adjusted = adjusted[i];
        test.level      = levels[i];
        test.power      = beside.power(p.relevant_link);
        test.verdict    = beside.verdict(p);
      }
  }
} // namespace squeal::tribology
