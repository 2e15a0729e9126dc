// SPDX-License-Identifier: LGPL-2.1-or-later

// What permutation tests make of values that are equal but for rounding: groups
// of pads that do not differ, that differ by little beside their size, and maps
// whose surrogates all correlate alike.
#include <squeal/tribology/statistics/pad_tables.h>
#include <squeal/tribology/statistics/spatial.h>

#include <cmath>

#include "check.h"

using namespace squeal;
using namespace squeal::testing;
using namespace squeal::tribology;

namespace
{
  /** The comparison of pads that have one feature, each with the same value
   * everywhere, of which the first @p n_silent are silent. */
  GroupResult
  comparison_of(const std::vector<double> &values, const std::size_t n_silent)
  {
    constexpr std::size_t n_cells = 36;
    std::vector<PadMaps>  pads(values.size());
    for (std::size_t i = 0; i < values.size(); ++i)
      {
        pads[i].features["feature"] = {
          6, 6, std::vector<double>(n_cells, values[i])};
        pads[i].seen = {6, 6, {}};
        for (std::size_t k = 0; k < n_cells; ++k)
          pads[i].seen.values.push_back(1e-6 * (k % 6 == 0 ? .5 : 1.));
        pads[i].is_silent = i < n_silent;
      }
    return compare_groups(pads, CorrelationParameters()).front();
  }

  /** Every choice of pads differs as much as the one at hand: not at all. */
  void
  equal_pads()
  {
    for (const double value : {.1, .21, .25, .3, .31, .5, .7, 101325.})
      for (const auto &[n_silent, n_squealing] :
           {std::pair<std::size_t, std::size_t>(3, 4),
            {4, 6},
            {5, 5},
            {12, 13}})
        {
          const GroupResult result = comparison_of(
            std::vector<double>(n_silent + n_squealing, value), n_silent);
          check(result.p_value == 1. && result.verdict == Verdict::undecided,
                std::to_string(n_silent + n_squealing) +
                  " pads with the value " + std::to_string(value) +
                  " do not differ");
        }
  }

  /** Two of the 20 choices of three pads tell the smaller values from the
   * larger ones, whatever is added to all. */
  void
  pads_that_differ_by_little()
  {
    for (const double offset : {0., 1., 101325.})
      {
        std::vector<double> values;
        for (const double more : {.001, .002, .003, .0041, .0052, .0063})
          values.push_back(offset + more);
        const GroupResult result = comparison_of(values, 3);
        check_close(result.p_value,
                    .1,
                    1e-12,
                    "p of three and three pads around " +
                      std::to_string(offset));
        check(result.verdict == Verdict::undecided,
              "which decide nothing: " + result.reason);
      }
  }

  /** Of a map with two columns the surrogates have two values as well, and any
   * two values of columns correlate alike with a feature, but for their sign.
   */
  void
  surrogates_of_two_columns()
  {
    GridMap index{2, 6, {}}, feature{2, 6, {}};
    for (unsigned int k = 0; k < 12; ++k)
      {
        index.values.push_back(k % 2 == 0 ? .1 : .7);
        feature.values.push_back(std::sin(1.7 * k * k + .3) + .3 * (k % 2));
      }
    std::mt19937_64 generator(1);
    check(surrogate_p_value(index, feature, 99, generator) == 1.,
          "no surrogate correlates less");
  }
} // namespace



int
main()
{
  equal_pads();
  pads_that_differ_by_little();
  surrogates_of_two_columns();
}
