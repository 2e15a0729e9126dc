// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/analyses/limit_cycle/pairs_to_follow.h>
#include <squeal/model/reduced_motions.h>

#include <algorithm>
#include <cmath>

namespace squeal
{
  std::vector<Eigen::Index>
  pairs_to_follow(const LinearizedMotion     &linear,
                  const EigenParameters      &band,
                  const LimitCycleParameters &l)
  {
    std::vector<Eigen::Index> pairs = growing_pairs(linear, band);
    if (pairs.empty())
      return pairs;
    if (l.frequency > 0.)
      std::iter_swap(
        pairs.begin(),
        std::min_element(pairs.begin(),
                         pairs.end(),
                         [&](const Eigen::Index a, const Eigen::Index b) {
                           const auto off = [&](const Eigen::Index k) {
                             return std::abs(linear.lambda[k].imag() /
                                               (2. * M_PI) -
                                             l.frequency);
                           };
                           return off(a) < off(b);
                         }));
    if (!l.every_pair)
      pairs.resize(1);
    return pairs;
  }
} // namespace squeal
