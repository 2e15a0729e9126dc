// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_statistics_association_h
#define squeal_tribology_statistics_association_h

#include <array>
#include <vector>

namespace squeal::tribology
{
  /** @name How two lists of values go together
   * NaN where that is not defined (a constant list, a single class). */
  //@{
  double pearson(const std::vector<double> &x, const std::vector<double> &y);

  /** Ranks from 1, equal values share their mean rank. */
  std::vector<double> ranks(const std::vector<double> &x);

  double spearman(const std::vector<double> &x, const std::vector<double> &y);

  /** Area under the ROC curve when @p x is to find the cells in which @p y is
   * above @p threshold: 0.5 is chance. */
  double roc_auc(const std::vector<double> &x,
                 const std::vector<double> &y,
                 double                     threshold);

  /** 0 if between 5 % and 95 % of the values are positive, else the median:
   * what divides cells with a feature from those without. */
  double feature_threshold(const std::vector<double> &y);

  /** Part of the cells in the top tenth of @p x that are in that of @p y: 0.1 is
   * chance. */
  double top_decile_overlap(const std::vector<double> &x,
                            const std::vector<double> &y);
  //@}

  /** @name Probabilities */
  //@{
  /** Two-sided p-value of a correlation of @p n_effective independent pairs
   * (Student's t); 1 where fewer than three remain. */
  double correlation_p_value(double r, double n_effective);

  /** Probability that a correlation of this size is found at this level, from
   * Fisher's z. */
  double correlation_power(double r, double n_effective, double level);

  /** Interval of the true correlation, from Fisher's z. */
  std::array<double, 2> correlation_interval(double r,
                                             double n_effective,
                                             double level);

  /** Wilson's interval of a rate at 95 %: @p k of @p n. */
  std::array<double, 2> rate_interval(unsigned int k, unsigned int n);

  /** Holm's step-down adjustment of p-values. */
  std::vector<double> holm(const std::vector<double> &p_values);
  //@}
} // namespace squeal::tribology

#endif
