// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_fatigue_spectral_h
#define squeal_tribology_fatigue_spectral_h

#include <squeal/tribology/fatigue/sn_curve.h>

#include <array>
#include <cstddef>
#include <vector>

namespace squeal::tribology
{
  /** One-sided power spectral density, linear between its points. */
  struct Spectrum
  {
    std::vector<double> frequency; /**< Hz, ascending */
    std::vector<double> density;   /**< Pa^2/Hz */

    /** integral of f^n G df for n = 0 .. 4 (Hz; exact for the lines). */
    std::array<double, 5> moments() const;
  };

  /**
   * Damage per second of a stationary Gaussian process with these @p moments
   * on a straight S-N line (knee and limit of @p curve are not looked at), after
   * Dirlik (1985). Zero for a spectrum without power. A limit cycle is not
   * Gaussian: compare with counting before relying on it.
   */
  double dirlik_damage(const std::array<double, 5> &moments,
                       const SnCurve               &curve);

  /** The same for a narrow band: Rayleigh distributed amplitudes at the rate of
   * upward zero crossings; on the safe side for a wide band. */
  double narrow_band_damage(const std::array<double, 5> &moments,
                            const SnCurve               &curve);

  /**
   * Welch's estimate of the spectrum of a history that comes in pieces: Hann
   * windows of @p n samples that overlap by half, mean of each removed.
   */
  class WelchEstimator
  {
  public:
    /** @p n: samples of a window, even; @p rate: samples per second. */
    WelchEstimator(std::size_t n, double rate);

    void add(const double *values, std::size_t n, std::size_t stride = 1);

    /** Windows so far. */
    std::size_t n_windows() const;

    Spectrum spectrum() const;

  private:
    void add_window();

    std::size_t         n;
    double              rate;
    std::vector<double> window, waiting, power;
    std::size_t         n_done = 0;
  };
} // namespace squeal::tribology

#endif
