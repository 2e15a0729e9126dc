// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_statistics_link_test_h
#define squeal_tribology_statistics_link_test_h

#include <squeal/tribology/setup/damage_parameters.h>
#include <squeal/tribology/statistics/conditional_link.h>
#include <squeal/tribology/statistics/shared_causes.h>
#include <squeal/tribology/statistics/spatial.h>

#include <string>
#include <vector>

namespace squeal::tribology
{
  /** What can be said about the link of two maps. */
  enum class Verdict
  {
    supported,
    contradicted,
    undecided
  };

  /** "supported", with "synthetic: " before it where images were made. */
  std::string verdict_text(Verdict verdict, bool is_synthetic);

  /** All that is computed from one index and one feature of one pad. */
  struct LinkTest
  {
    std::size_t n_cells = 0;
    double      r       = 0.; /**< Pearson */
    double      rho     = 0.; /**< Spearman */
    double      auc     = 0.;
    double      overlap = 0.; /**< of the top deciles */

    /** @name As if nothing but a link could make maps alike */
    //@{
    double                n_effective   = 0.; /**< of the pair */
    double                index_cells   = 0.; /**< independent ones alone */
    double                feature_cells = 0.;
    double                p_effective   = 1.; /**< Dutilleul */
    double                p_surrogate   = 1.;
    double                p_without     = 1.;  /**< larger of both, Holm */
    std::array<double, 2> interval{{-1., 1.}}; /**< Fisher, n_effective */
    Verdict               verdict_without = Verdict::undecided;
    ReferenceLinks        reference; /**< of the feature with mere places */
    //@}

    /** @name Once shared causes are taken out: this decides */
    //@{
    ConditionalLink       conditional;
    std::array<double, 2> conditional_interval{{-1., 1.}};
    /** NaN where no bootstraps were asked for. */
    std::array<double, 2> bootstrap{{-1., 1.}};
    double                p_adjusted = 1.;  /**< Holm */
    double                level      = .05; /**< that the verdict used */
    double                power = 0.; /**< of the relevant link at that level */
    Verdict               verdict = Verdict::undecided;
    //@}
  };

  /** Surrogates with which the level that Holm's adjustment asks of
   * @p n_links links is reached with ten to spare. */
  unsigned int surrogates_needed(const CorrelationParameters &parameters,
                                 std::size_t                  n_links);

  /** Everything but what decide() adds. */
  LinkTest measure_link(const GridMap               &index,
                        const GridMap               &feature,
                        ConditionalTests            &conditional,
                        const CorrelationParameters &parameters,
                        unsigned int                 n_surrogates,
                        std::mt19937_64             &generator);

  /**
   * Adjusts the p-values of tests that belong together and gives verdicts. With
   * p the conditional p-value:
   *
   * supported     p, adjusted, is at most the level, and the partial
   *               correlation is positive
   * contradicted  the same with a negative one; or nothing was found although
   *               the power was at least the wanted one and the interval of
   *               the partial correlation excludes the relevant link, both at
   *               the level that Holm's adjustment left to this test
   * undecided     anything else
   *
   * The verdict without shared causes asks for both p_effective and p_surrogate
   * and takes power and interval from n_effective.
   */
  void decide(std::vector<LinkTest>       &tests,
              const CorrelationParameters &parameters);
} // namespace squeal::tribology

#endif
