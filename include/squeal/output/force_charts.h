// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_output_force_charts_h
#define squeal_output_force_charts_h

#include <squeal/results/chart.h>

#include <string>
#include <vector>

namespace squeal
{
  /** The resultants of the contact at equally spaced times. */
  struct ForceCurve
  {
    std::vector<double> time;               /**< s */
    std::vector<double> normal, tangential; /**< N */

    void add(const double t, const double n, const double t_along);
    /** The last @p n points, all where there are fewer. */
    ForceCurve last(const std::size_t n) const;
  };

  /** Both resultants over time. */
  Chart forces_over_time(const ForceCurve &curve, const std::string &title);

  /** The tangential over the normal force, and the phase portrait: the rate of
   * the normal force, by central differences between the second and the last
   * point but one, over the force. */
  std::vector<Chart> portraits(const ForceCurve &curve);
} // namespace squeal

#endif
