// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_statistics_link_test_h
#define squeal_tribology_statistics_link_test_h

#include <squeal/tribology/setup/damage_parameters.h>
#include <squeal/tribology/statistics/spatial.h>

#include <functional>
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
    std::size_t           n_cells     = 0;
    double                r           = 0.; /**< Pearson */
    double                rho         = 0.; /**< Spearman */
    double                auc         = 0.;
    double                overlap     = 0.; /**< of the top deciles */
    double                n_effective = 0.;
    double                p_effective = 1.; /**< Dutilleul */
    double                p_surrogate = 1.;
    double                p_adjusted  = 1.;     /**< larger of the two, Holm */
    std::array<double, 2> interval{{-1., 1.}};  /**< Fisher, n_effective */
    std::array<double, 2> bootstrap{{-1., 1.}}; /**< blocks */
    double                power   = 0.; /**< of finding the relevant link */
    Verdict               verdict = Verdict::undecided;
  };

  /** Everything but p_adjusted and the verdict. */
  LinkTest measure_link(const GridMap               &index,
                        const GridMap               &feature,
                        const CorrelationParameters &parameters,
                        std::mt19937_64             &generator);

  /**
   * Adjusts the p-values of tests that belong together and gives verdicts:
   *
   * supported     both p-values, adjusted, are at most the level, and r > 0
   * contradicted  the same with r < 0; or nothing was found although the power
   *               was at least the wanted one and the interval of r excludes
   *               the relevant link
   * undecided     anything else
   */
  void decide(std::vector<LinkTest>       &tests,
              const CorrelationParameters &parameters);

  /** Rates of one self test: how often a link was found. */
  struct SelfTestRow
  {
    double       length  = 0.; /**< cells */
    double       link    = 0.; /**< true correlation; 0: false positives */
    unsigned int n_pairs = 0;
    unsigned int n_plain = 0, n_effective = 0, n_surrogate = 0, n_both = 0;
  };

  /** Pairs of maps of 11 x 11 cells with this correlation length and link. */
  SelfTestRow self_test(double                       length,
                        double                       link,
                        unsigned int                 n_pairs,
                        unsigned int                 n_surrogates,
                        const CorrelationParameters &parameters);
} // namespace squeal::tribology

#endif
