// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/tribology/images/line_smoothing.h>

#include <algorithm>
#include <cmath>

namespace squeal::tribology
{
  std::vector<double>
  mean_weights(const double deviation, const int reach)
  {
    std::vector<double> weights;
    double              sum = 0.;
    for (int k = -reach; k <= reach; ++k)
      {
        weights.push_back(std::exp(-0.5 * k * k / (deviation * deviation)));
        sum += weights.back();
      }
    for (double &w : weights)
      w /= sum;
    return weights;
  }



  Curve
  averaged_along(const Curve               &line,
                 const bool                 is_ring,
                 const std::vector<double> &weights)
  {
    const int  n     = int(line.size());
    const int  reach = int(weights.size() / 2);
    const auto at    = [&](const int i) -> cv::Point2d {
      if (is_ring)
        return line[(i % (n - 1) + n - 1) % (n - 1)];
      if (i < 0)
        return 2. * line[0] - line[std::min(-i, n - 1)];
      if (i >= n)
        return 2. * line[n - 1] - line[std::max(2 * (n - 1) - i, 0)];
      return line[i];
    };
    Curve result(n, {0., 0.});
    for (int i = 0; i < n; ++i)
      for (int k = -reach; k <= reach; ++k)
        result[i] += weights[reach + k] * at(i + k);
    return result;
  }
} // namespace squeal::tribology
