// SPDX-License-Identifier: LGPL-2.1-or-later

// Sobol's first index: closed forms of linear functions, nothing where nothing
// is linked, few samples.

#include <squeal/sweep/first_order_index.h>

#include <cmath>
#include <random>

#include "check.h"

using namespace squeal;
using namespace squeal::testing;

namespace
{
  struct Samples
  {
    std::vector<double> x, y;
  };

  Samples
  draw(const unsigned int n, const unsigned int seed)
  {
    std::mt19937                           random(seed);
    std::uniform_real_distribution<double> uniform;
    Samples                                result;
    for (unsigned int i = 0; i < n; ++i)
      {
        result.x.push_back(uniform(random));
        result.y.push_back(uniform(random));
      }
    return result;
  }

  std::vector<double>
  combined(const Samples &s, const double a, const double b)
  {
    std::vector<double> values;
    for (std::size_t i = 0; i < s.x.size(); ++i)
      values.push_back(a * s.x[i] + b * s.y[i]);
    return values;
  }

  /** Of a x + b y the share of x is a^2 / (a^2 + b^2). */
  void
  linear_functions()
  {
    const Samples s = draw(20000, 1);
    for (const auto &[a, b] :
         {std::make_pair(1., 1.), {3., 1.}, {1., 0.}, {0., 1.}})
      check_close(first_order_index(s.x, combined(s, a, b)),
                  a * a / (a * a + b * b),
                  0.02,
                  "linear function",
                  1.);
  }

  void
  few_samples()
  {
    // The mean over many drawings: chance is taken off, also where classes do
    // not hold equally many.
    for (const unsigned int n : {10, 13, 19, 20, 57})
      {
        double             linked = 0., free = 0.;
        const unsigned int n_draws = 400;
        for (unsigned int seed = 0; seed < n_draws; ++seed)
          {
            const Samples s = draw(n, 100 * n + seed);
            linked += first_order_index(s.x, combined(s, 1., 0.)) / n_draws;
            free += first_order_index(s.x, s.y) / n_draws;
          }
        std::cout << "        " << n << " samples: " << linked << ", " << free
                  << std::endl;
        check(linked > 0.6 && linked <= 1., "a link is found by few samples");
        check(free >= 0. && free < 0.12, "and nothing where there is none");
      }
    const Samples nine = draw(9, 1);
    check(std::isnan(first_order_index(nine.x, nine.y)) &&
            classes_of(nine.x, nine.y).empty(),
          "nine samples have no index");
    check(first_order_index(draw(40, 1).x, std::vector<double>(40, 2.)) == 0.,
          "what does not vary is explained by nothing");
  }

  void
  not_finite()
  {
    const Samples s = draw(1000, 2);
    for (const double value : {HUGE_VAL, -HUGE_VAL, std::nan("")})
      {
        std::vector<double> values = combined(s, 1., 1.);
        values[500]                = value;
        check(std::isnan(first_order_index(s.x, values)),
              "a value that is not finite leaves no variance to share");
      }
  }

  void
  every_sample_is_in_one_class()
  {
    for (const unsigned int n : {10, 23, 99, 1000, 1001})
      {
        const Samples s    = draw(n, n);
        unsigned int  sum  = 0;
        double        last = -1.;
        for (const SampleClass &c : classes_of(s.x, s.y))
          {
            sum += c.n;
            check(c.n >= 5 && c.x > last, "classes ascend and are not empty");
            last = c.x;
          }
        check(sum == n, "every sample is in one class");
      }
  }
} // namespace



int
main()
{
  linear_functions();
  few_samples();
  not_finite();
  every_sample_is_in_one_class();
}
