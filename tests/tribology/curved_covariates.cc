// SPDX-License-Identifier: LGPL-2.1-or-later

// A measured covariate with a curved effect on both maps is taken out of them,
// and a link beside it is found; few cells are not fitted by many terms.
#include <squeal/tribology/statistics/conditional_link.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "check.h"

using namespace squeal;
using namespace squeal::testing;
using namespace squeal::tribology;

namespace
{
  SharedCauses
  of_pad(const GridMap &grid, const std::vector<MeasuredCause> &measured)
  {
    return shared_causes(grid,
                         CorrelationParameters().shared_causes,
                         LeadingEdge::lowest_y,
                         measured);
  }

  /** Both maps follow the third power of the logarithm of a pressure, and have
   * a scatter of their own. */
  void
  curved_covariate()
  {
    std::mt19937_64  generator(12);
    constexpr double n_pads  = 20.;
    double           n_false = 0., n_found = 0., n_columns = 0.;
    for (unsigned int i = 0; i < n_pads; ++i)
      {
        const GridMap z = random_map(11, 11, 2., generator);
        GridMap       x = random_map(11, 11, 1.5, generator),
                y = random_map(11, 11, 1.5, generator), alike = x, cause = z;
        const double low = *std::min_element(z.values.begin(), z.values.end());
        for (std::size_t k = 0; k < z.size(); ++k)
          {
            cause.values[k]     = 1e6 * std::exp(.25 * z.values[k]);
            const double shared = std::pow(z.values[k] - low, 3);
            alike.values[k]     = shared + x.values[k] + .5 * y.values[k];
            x.values[k] += shared;
            y.values[k] += shared;
          }
        const SharedCauses causes = of_pad(z, {{"mean_pressure_pa", cause}});
        ConditionalTests   tests(causes);
        n_columns += causes.values.cols();
        n_false += tests.measure(x, y).p <= .05;
        n_found += tests.measure(x, alike).p <= .05;
      }
    const GridMap grid{11, 11, {}};
    check_close(n_columns / n_pads,
                of_pad(grid, {}).values.cols() + 8.,
                1e-12,
                "121 cells have eight terms of a covariate");
    check(n_false <= 4.,
          "a curved effect of a covariate is no link: " +
            std::to_string(n_false) + " of 20");
    check(n_found >= 18.,
          "and a link beside it is found: " + std::to_string(n_found) +
            " of 20");
    GridMap few{5, 5, std::vector<double>(25, 0.)};
    for (std::size_t k = 0; k < 25; ++k)
      few.values[k] = double(k * k);
    check(shared_causes(few, {}, LeadingEdge::lowest_y, {{"few", few}})
              .values.cols() == 3,
          "25 cells have two");
  }
} // namespace



int
main()
{
  curved_covariate();
}
