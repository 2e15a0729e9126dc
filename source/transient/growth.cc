// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/transient/growth.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <tuple>

namespace squeal
{
  namespace
  {
    constexpr std::size_t n_parts = 8, fewest_samples = 64;
    /** Two-sided 95 % of Student's t with seven degrees of freedom. */
    constexpr double student = 2.365;

    double
    slope(const std::vector<double> &x,
          const std::vector<double> &y,
          const std::size_t          first,
          const std::size_t          last)
    {
      const double n  = static_cast<double>(last - first);
      double       mx = 0., my = 0., xx = 0., xy = 0.;
      for (std::size_t i = first; i < last; ++i)
        {
          mx += x[i] / n;
          my += y[i] / n;
        }
      for (std::size_t i = first; i < last; ++i)
        {
          xx += (x[i] - mx) * (x[i] - mx);
          xy += (x[i] - mx) * (y[i] - my);
        }
      return xy / xx;
    }

    /** Slope over all and the half width of its interval: by those of parts,
     * and at least what its two halves differ by. Traces of other motions that
     * fade away bend the curve by less than parts of it scatter. */
    std::pair<double, double>
    slope_with_interval(const std::vector<double> &x,
                        const std::vector<double> &y)
    {
      std::array<double, n_parts> slopes;
      for (std::size_t k = 0; k < n_parts; ++k)
        slopes[k] =
          slope(x, y, k * x.size() / n_parts, (k + 1) * x.size() / n_parts);
      const double mean =
        std::accumulate(slopes.begin(), slopes.end(), 0.) / n_parts;
      // Not by the mean of squares: phases turn so fast that their scatter is
      // below its rounding, and an interval could be zero.
      double variance = 0.;
      for (const double s : slopes)
        variance += (s - mean) * (s - mean) / n_parts;
      const std::size_t middle = x.size() / 2;
      const double      halves =
        std::abs(slope(x, y, 0, middle) - slope(x, y, middle, x.size()));
      return {slope(x, y, 0, x.size()),
              std::max(student * std::sqrt(variance / (n_parts - 1.)), halves)};
    }
  } // namespace



  double
  GrowthFit::e_foldings() const
  {
    return std::abs(rate) * (end - start);
  }

  double
  GrowthFit::n_periods() const
  {
    return std::abs(frequency) * (end - start);
  }

  void
  GrowthFit::include(const std::complex<double> error)
  {
    rate_ci += std::abs(error.real());
    frequency_ci += std::abs(error.imag()) / (2. * M_PI);
  }



  GrowthFit
  fit_growth(const std::vector<double>               &times,
             const std::vector<std::complex<double>> &amplitudes,
             const std::size_t                        first,
             const std::size_t                        last)
  {
    GrowthFit fit;
    if (last < first + fewest_samples)
      return fit;
    std::vector<double> t, logs, phases;
    for (std::size_t i = first; i < last; ++i)
      {
        const double size = std::abs(amplitudes[i]);
        if (!(size > 0.))
          return fit;
        t.push_back(times[i]);
        logs.push_back(std::log(size));
        const double phase = std::arg(amplitudes[i]);
        phases.push_back(
          phases.empty()
            ? phase
            : phases.back() + std::remainder(phase - phases.back(), 2. * M_PI));
      }
    std::tie(fit.rate, fit.rate_ci) = slope_with_interval(t, logs);
    const auto turning              = slope_with_interval(t, phases);
    fit.frequency                   = turning.first / (2. * M_PI);
    fit.frequency_ci                = turning.second / (2. * M_PI);
    fit.start                       = t.front();
    fit.end                         = t.back();
    fit.is_valid                    = true;
    return fit;
  }



  std::vector<std::complex<double>>
  without_drift(const std::vector<std::complex<double>> &amplitudes,
                const std::size_t                        period)
  {
    const std::size_t n = amplitudes.size();
    if (period < 4 || n < period)
      return amplitudes;
    std::vector<std::complex<double>> sums(1), result(n);
    for (const auto &amplitude : amplitudes)
      sums.push_back(sums.back() + amplitude);
    for (std::size_t i = 0; i < n; ++i)
      {
        const std::size_t first =
          std::min(i - std::min(i, period / 2), n - period);
        result[i] = amplitudes[i] - (sums[first + period] - sums[first]) /
                                      static_cast<double>(period);
      }
    return result;
  }



  std::pair<std::size_t, std::size_t>
  fit_window(const std::vector<std::complex<double>> &amplitudes,
             const std::size_t                        first,
             const std::size_t                        last,
             const bool                               decays)
  {
    if (!decays)
      return {first + (last - first) / 3, last};
    std::size_t end = first;
    while (end < last &&
           std::abs(amplitudes[end]) > 1e-3 * std::abs(amplitudes[first]))
      ++end;
    return {first, end};
  }
} // namespace squeal
