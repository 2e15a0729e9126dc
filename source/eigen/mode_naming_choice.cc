// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/eigen/mode_naming_choice.h>
#include <squeal/eigen/mode_naming_profile.h>

#include <algorithm>

namespace squeal
{
  namespace naming
  {
    bool
    may_exceed(const double value, const Limit &limit)
    {
      return value * limit.factor > limit.value;
    }

    bool
    may_fall_short(const double value, const Limit &limit)
    {
      return !(value > limit.value * limit.factor);
    }



    std::vector<unsigned int>
    near_largest(const std::vector<double> &scores, const double margin)
    {
      std::vector<unsigned int> result;
      if (scores.empty())
        return result;
      const double largest = *std::max_element(scores.begin(), scores.end());
      // Of a body at rest, or without numbers, nothing can be told.
      if (!(largest > 0.))
        return {0};
      for (unsigned int i = 0; i < scores.size(); ++i)
        if (largest - scores[i] <= margin * (largest + scores[i]))
          result.push_back(i);
      return result;
    }



    std::vector<unsigned int>
    numbers_of_nodes(const Eigen::VectorXd &profile)
    {
      const unsigned int most =
        n_sign_changes(profile, lobe.value / lobe.factor);
      const unsigned int fewest =
        n_sign_changes(profile, lobe.value * lobe.factor);
      if (most == fewest)
        return {most};
      return {fewest, most};
    }
  } // namespace naming
} // namespace squeal
