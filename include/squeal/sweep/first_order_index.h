// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_sweep_first_order_index_h
#define squeal_sweep_first_order_index_h

#include <vector>

namespace squeal
{
  /** Samples whose x is next to each other. */
  struct SampleClass
  {
    double       x, mean; /**< means of x and of the values */
    unsigned int n;
  };

  /** Samples in classes of equal counts (as nearly as can be) of @p x: 20, or
   * fewer so that five are in each. Empty for fewer than ten samples. */
  std::vector<SampleClass> classes_of(const std::vector<double> &x,
                                      const std::vector<double> &values);

  /**
   * Share of the variance of @p values that x alone explains (Sobol's first
   * order index; Sobol, Sensitivity estimates for nonlinear mathematical
   * models, 1993), from the means of classes of x, less what classes of so few
   * samples show of pure chance: of n samples without a link, k classes explain
   * (k - 1) / (n - 1) on the mean. Between 0 and 1; 0 where the values do not
   * vary, NaN for fewer than ten samples or a value that is not finite.
   */
  double first_order_index(const std::vector<double> &x,
                           const std::vector<double> &values);
} // namespace squeal

#endif
