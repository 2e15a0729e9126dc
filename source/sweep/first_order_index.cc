// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/sweep/first_order_index.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace squeal
{
  namespace
  {
    constexpr std::size_t most_classes = 20, samples_per_class = 5;
  } // namespace



  std::vector<SampleClass>
  classes_of(const std::vector<double> &x, const std::vector<double> &values)
  {
    const std::size_t n = std::min(most_classes, x.size() / samples_per_class);
    if (n < 2)
      return {};
    std::vector<std::size_t> order(x.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(
      order.begin(),
      order.end(),
      [&](const std::size_t a, const std::size_t b) { return x[a] < x[b]; });
    std::vector<SampleClass> result;
    for (std::size_t c = 0; c < n; ++c)
      {
        const std::size_t first = c * x.size() / n,
                          last  = (c + 1) * x.size() / n;
        const double size       = last - first;
        SampleClass  found{0., 0., static_cast<unsigned int>(last - first)};
        for (std::size_t i = first; i < last; ++i)
          {
            found.x += x[order[i]] / size;
            found.mean += values[order[i]] / size;
          }
        result.push_back(found);
      }
    return result;
  }



  double
  first_order_index(const std::vector<double> &x,
                    const std::vector<double> &values)
  {
    const auto classes = classes_of(x, values);
    if (classes.empty() ||
        !std::all_of(values.begin(), values.end(), [](const double v) {
          return std::isfinite(v);
        }))
      return std::nan("");
    const double n    = values.size();
    double       mean = 0., variance = 0., between = 0.;
    for (const double v : values)
      mean += v / n;
    for (const double v : values)
      variance += (v - mean) * (v - mean) / n;
    // What is left of equal values is rounding.
    if (std::all_of(values.begin(), values.end(), [&](const double v) {
          return v == values.front();
        }))
      return 0.;
    for (const SampleClass &c : classes)
      between += c.n / n * (c.mean - mean) * (c.mean - mean);
    const double chance = (classes.size() - 1.) / (n - 1.);
    return std::max(0., (between / variance - chance) / (1. - chance));
  }
} // namespace squeal
