// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/tribology/statistics/association.h>

#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace squeal::tribology
{
  namespace
  {
    using boost::math::cdf;
    using boost::math::complement;
    using boost::math::quantile;

    std::vector<std::size_t>
    ascending(const std::vector<double> &x)
    {
      std::vector<std::size_t> order(x.size());
      std::iota(order.begin(), order.end(), 0);
      std::sort(
        order.begin(),
        order.end(),
        [&x](const std::size_t a, const std::size_t b) { return x[a] < x[b]; });
      return order;
    }



    /** Weights (0, 1 or a part for equal values) of the top tenth. */
    std::vector<double>
    top_tenth(const std::vector<double> &x)
    {
      std::vector<double>            weight(x.size(), 0.);
      const std::vector<std::size_t> order = ascending(x);
      double                         rest  = x.size() / 10.;
      for (std::size_t end = x.size(); end > 0 && rest > 0.;)
        {
          std::size_t start = end - 1;
          while (start > 0 && x[order[start - 1]] == x[order[end - 1]])
            --start;
          const double share = std::min(1., rest / (end - start));
          for (std::size_t i = start; i < end; ++i)
            weight[order[i]] = share;
          rest -= end - start;
          end = start;
        }
      return weight;
    }



    /** @p x over a power of two near its largest size, which rounds nothing:
     * squares of tiny and of huge values stay in range. */
    std::vector<double>
    in_range(std::vector<double> x)
    {
      double largest = 0.;
      for (const double v : x)
        largest = std::max(largest, std::abs(v));
      if (largest > 0. && std::isfinite(largest))
        for (double &v : x)
          v = std::scalbn(v, -std::ilogb(largest));
      return x;
    }
  } // namespace



  double
  pearson(const std::vector<double> &of_x, const std::vector<double> &of_y)
  {
    const std::vector<double> x = in_range(of_x), y = in_range(of_y);
    const double              n  = static_cast<double>(x.size());
    const double              mx = std::accumulate(x.begin(), x.end(), 0.) / n;
    const double              my = std::accumulate(y.begin(), y.end(), 0.) / n;
    double                    xx = 0., yy = 0., xy = 0.;
    for (std::size_t i = 0; i < x.size(); ++i)
      {
        xx += (x[i] - mx) * (x[i] - mx);
        yy += (y[i] - my) * (y[i] - my);
        xy += (x[i] - mx) * (y[i] - my);
      }
    // What rounding of the mean leaves of a constant is no variation.
    const auto varies = [n](const double squares, const double mean) {
      return squares > n * std::pow(1e-12 * mean, 2);
    };
    return varies(xx, mx) && varies(yy, my)
             ? std::clamp(xy / std::sqrt(xx * yy), -1., 1.)
             : NAN;
  }



  std::vector<double>
  ranks(const std::vector<double> &x)
  {
    const std::vector<std::size_t> order = ascending(x);
    std::vector<double>            result(x.size());
    for (std::size_t start = 0; start < x.size();)
      {
        std::size_t end = start + 1;
        while (end < x.size() && x[order[end]] == x[order[start]])
          ++end;
        for (std::size_t i = start; i < end; ++i)
          result[order[i]] = .5 * (start + 1 + end);
        start = end;
      }
    return result;
  }



  double
  spearman(const std::vector<double> &x, const std::vector<double> &y)
  {
    return pearson(ranks(x), ranks(y));
  }



  double
  roc_auc(const std::vector<double> &x,
          const std::vector<double> &y,
          const double               threshold)
  {
    const std::vector<double> rank = ranks(x);
    double                    sum = 0., n_with = 0.;
    for (std::size_t i = 0; i < x.size(); ++i)
      if (y[i] > threshold)
        {
          sum += rank[i];
          n_with += 1.;
        }
    const double n_without = x.size() - n_with;
    return n_with > 0. && n_without > 0.
             ? (sum - n_with * (n_with + 1.) / 2.) / (n_with * n_without)
             : NAN;
  }



  double
  feature_threshold(const std::vector<double> &y)
  {
    const double positive =
      std::count_if(y.begin(), y.end(), [](const double v) { return v > 0.; }) /
      static_cast<double>(y.size());
    if (positive >= .05 && positive <= .95)
      return 0.;
    std::vector<double> sorted = y;
    std::sort(sorted.begin(), sorted.end());
    return sorted.empty() ? 0. : sorted[(sorted.size() - 1) / 2];
  }



  double
  top_decile_overlap(const std::vector<double> &x, const std::vector<double> &y)
  {
    const std::vector<double> a = top_tenth(x), b = top_tenth(y);
    double                    both = 0., all = 0.;
    for (std::size_t i = 0; i < a.size(); ++i)
      {
        both += a[i] * b[i];
        all += a[i];
      }
    return all > 0. ? both / all : NAN;
  }



  double
  correlation_p_value(const double r, const double n)
  {
    if (!(n > 3.) || std::isnan(r))
      return 1.;
    if (std::abs(r) >= 1.)
      return 0.;
    const double t = std::abs(r) * std::sqrt((n - 2.) / (1. - r * r));
    return 2. * cdf(complement(boost::math::students_t(n - 2.), t));
  }



  double
  correlation_power(const double r, const double n, const double level)
  {
    if (!(n > 3.))
      return level;
    const boost::math::normal normal;
    const double              z     = quantile(normal, 1. - level / 2.);
    const double              shift = std::atanh(r) * std::sqrt(n - 3.);
    return cdf(normal, shift - z) + cdf(normal, -shift - z);
  }



  std::array<double, 2>
  correlation_interval(const double r, const double n, const double level)
  {
    if (!(n > 3.) || std::isnan(r))
      return {{-1., 1.}};
    const double z =
      quantile(boost::math::normal(), 1. - level / 2.) / std::sqrt(n - 3.);
    return {{std::tanh(std::atanh(r) - z), std::tanh(std::atanh(r) + z)}};
  }



  std::array<double, 2>
  rate_interval(const unsigned int k, const unsigned int n)
  {
    const double z = quantile(boost::math::normal(), .975);
    const double p = static_cast<double>(k) / n, zz = z * z / n;
    const double half = z * std::sqrt(p * (1. - p) / n + zz / (4. * n));
    return {
      {(p + zz / 2. - half) / (1. + zz), (p + zz / 2. + half) / (1. + zz)}};
  }



  std::vector<double>
  holm(const std::vector<double> &p)
  {
    const std::vector<std::size_t> order = ascending(p);
    std::vector<double>            adjusted(p.size());
    double                         largest = 0.;
    for (std::size_t i = 0; i < p.size(); ++i)
      {
        largest            = std::max(largest, p[order[i]] * (p.size() - i));
        adjusted[order[i]] = std::min(1., largest);
      }
    return adjusted;
  }
} // namespace squeal::tribology
