// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_statistics_self_test_h
#define squeal_tribology_statistics_self_test_h

#include <squeal/tribology/statistics/link_test.h>

#include <memory>

namespace squeal::tribology
{
  /** Rates of one self test: how often a link was found, how often an interval
   * held the true one. */
  struct SelfTestRow
  {
    SharedPattern pattern = SharedPattern::none;
    double        length  = 0.; /**< cells */
    double        link    = 0.; /**< true correlation; 0: false positives */
    unsigned int  n_pairs = 0;

    /** @name Pairs found to be linked */
    //@{
    unsigned int n_plain = 0, n_effective = 0, n_surrogate = 0, n_both = 0,
                 n_conditional = 0;
    //@}

    /** @name Intervals at 95 % that hold the true correlation */
    //@{
    unsigned int n_covered = 0, n_covered_bootstrap = 0;
    //@}

    double conditional_cells = 0.; /**< mean over the pairs */
  };

  /**
   * Tests the test on pairs of maps of 11 x 11 cells: each map is a random map
   * of a correlation length plus a pattern that both share; the random parts
   * have a true correlation. Streaks share nothing, but four times the length
   * along the sliding direction and a quarter of it across. The leading edge
   * of made maps is the one at the lowest y, whatever that of the pads is.
   * Where a link is found although it is 0, the test is wrong.
   */
  class SelfTest
  {
  public:
    explicit SelfTest(const CorrelationParameters &parameters);

    /** Surrogates of each pair. */
    static constexpr unsigned int n_surrogates = 199;

    /** Without surrogates SelfTestRow::n_surrogate and n_both are 0. */
    SelfTestRow run(SharedPattern pattern,
                    double        length,
                    double        link,
                    unsigned int  n_pairs,
                    unsigned int  n_surrogates = SelfTest::n_surrogates);

  private:
    static constexpr std::size_t n = 11;

    /** What is added to both maps. */
    GridMap shared(SharedPattern pattern) const;

    void add_pair(SelfTestRow     &row,
                  const GridMap   &shared,
                  unsigned int     n_surrogates,
                  std::mt19937_64 &generator);

    CorrelationParameters parameters;
    GridMap               plateaus; /**< 1 where lower, else 0 */
    SharedCauses          causes, causes_with_plateaus;
    ConditionalTests      tests, tests_with_plateaus;
  };
} // namespace squeal::tribology

#endif
