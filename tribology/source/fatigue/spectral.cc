// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/tribology/fatigue/spectral.h>

#include <opencv2/core.hpp>

#include <cmath>
#include <numeric>

namespace squeal::tribology
{
  std::array<double, 5>
  Spectrum::moments() const
  {
    // three Gauss points are exact for f^4 times a line
    const double                place = std::sqrt(0.6);
    const std::array<double, 3> places{{-place, 0., place}};
    const std::array<double, 3> weights{{5. / 18., 8. / 18., 5. / 18.}};
    std::array<double, 5>       result{};
    for (std::size_t i = 0; i + 1 < frequency.size(); ++i)
      {
        const double width = frequency[i + 1] - frequency[i];
        for (unsigned int q = 0; q < 3; ++q)
          {
            const double t = 0.5 * (1. + places[q]);
            const double f = frequency[i] + t * width;
            double       term =
              width * weights[q] * ((1. - t) * density[i] + t * density[i + 1]);
            for (double &moment : result)
              {
                moment += term;
                term *= f;
              }
          }
      }
    return result;
  }



  double
  dirlik_damage(const std::array<double, 5> &m, const SnCurve &curve)
  {
    if (!(m[0] > 0.) || !(m[4] > 0.))
      return 0.;
    const double k       = curve.exponent;
    const double x       = m[1] / m[0] * std::sqrt(m[2] / m[4]);
    const double g       = m[2] / std::sqrt(m[0] * m[4]);
    const double d1      = 2. * (x - g * g) / (1. + g * g);
    const double r       = (g - x - d1 * d1) / (1. - g - d1 + d1 * d1);
    const double d2      = (1. - g - d1 + d1 * d1) / (1. - r);
    const double d3      = 1. - d1 - d2;
    const double q       = 1.25 * (g - d3 - d2 * r) / d1;
    const double moments = d1 * std::pow(q, k) * std::tgamma(1. + k) +
                           std::pow(2., k / 2.) * std::tgamma(1. + k / 2.) *
                             (d2 * std::pow(std::abs(r), k) + d3);
    return std::sqrt(m[4] / m[2]) / curve.constant *
           std::pow(std::sqrt(m[0]) / curve.reference_stress, k) * moments;
  }



  double
  narrow_band_damage(const std::array<double, 5> &m, const SnCurve &curve)
  {
    if (!(m[0] > 0.))
      return 0.;
    const double k = curve.exponent;
    return std::sqrt(m[2] / m[0]) / curve.constant *
           std::pow(std::sqrt(2. * m[0]) / curve.reference_stress, k) *
           std::tgamma(1. + k / 2.);
  }



  WelchEstimator::WelchEstimator(const std::size_t n, const double rate)
    : n(n)
    , rate(rate)
    , window(n)
    , power(n / 2 + 1, 0.)
  {
    for (std::size_t i = 0; i < n; ++i)
      window[i] = 0.5 - 0.5 * std::cos(2. * M_PI * i / n);
    waiting.reserve(n);
  }



  void
  WelchEstimator::add(const double     *values,
                      const std::size_t n_values,
                      const std::size_t stride)
  {
    for (std::size_t i = 0; i < n_values; ++i)
      {
        waiting.push_back(values[i * stride]);
        if (waiting.size() == n)
          {
            add_window();
            waiting.erase(waiting.begin(), waiting.begin() + n / 2);
          }
      }
  }



  void
  WelchEstimator::add_window()
  {
    const double mean = std::accumulate(waiting.begin(), waiting.end(), 0.) / n;
    std::vector<double> transformed(n);
    for (std::size_t i = 0; i < n; ++i)
      transformed[i] = window[i] * (waiting[i] - mean);
    cv::Mat row(1, static_cast<int>(n), CV_64F, transformed.data()), packed;
    cv::dft(row, packed);
    const double *c = packed.ptr<double>();
    // packed as Re 0, Re 1, Im 1, ..., Re n/2
    power[0] += c[0] * c[0];
    for (std::size_t i = 1; i < n / 2; ++i)
      power[i] += c[2 * i - 1] * c[2 * i - 1] + c[2 * i] * c[2 * i];
    power[n / 2] += c[n - 1] * c[n - 1];
    ++n_done;
  }



  std::size_t
  WelchEstimator::n_windows() const
  {
    return n_done;
  }



  Spectrum
  WelchEstimator::spectrum() const
  {
    Spectrum result;
    double   squares = 0.;
    for (const double w : window)
      squares += w * w;
    for (std::size_t i = 0; i < power.size(); ++i)
      {
        const double sides = i == 0 || i == n / 2 ? 1. : 2.;
        result.frequency.push_back(i * rate / n);
        result.density.push_back(
          n_done == 0 ? 0. : sides * power[i] / (rate * squares * n_done));
      }
    return result;
  }
} // namespace squeal::tribology
