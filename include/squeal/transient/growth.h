// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_transient_growth_h
#define squeal_transient_growth_h

#include <complex>
#include <cstddef>
#include <utility>
#include <vector>

namespace squeal
{
  /** Rate and frequency of a complex amplitude a(t) ~ exp((sigma + i omega) t)
   * in a window. */
  struct GrowthFit
  {
    double rate    = 0.;         /**< 1/s */
    double rate_ci = 0.;         /**< half width of the interval, 1/s: 95 % by
                                    the scatter, and the time step's part */
    double frequency    = 0.;    /**< Hz */
    double frequency_ci = 0.;    /**< Hz */
    double start = 0., end = 0.; /**< of the window, s */
    bool   is_valid = false;

    double e_foldings() const;
    double n_periods() const; /**< in the window */

    /** Widens the intervals by what the time step adds to sigma + i omega, @p
     * error in 1/s (time_step_error.h). */
    void include(const std::complex<double> error);
  };

  /**
   * Least squares for log|a| and the phase over samples @p first to @p last
   * (one past the end). The interval comes from the scatter of the slopes of
   * eight equal parts of the window. Not valid with fewer than 64 samples or
   * where a vanishes. Neighbouring samples must be less than half a period
   * apart.
   */
  GrowthFit fit_growth(const std::vector<double>               &times,
                       const std::vector<std::complex<double>> &amplitudes,
                       const std::size_t                        first,
                       const std::size_t                        last);

  /**
   * Takes from each amplitude the mean over the @p period samples around it:
   * what is left turns. The mean of exp(lambda t) is a constant times
   * exp(lambda t), so that rate and frequency stay what they are; what goes is
   * the trace of a steady sliding that shifts slowly, with the turning mesh of
   * a corotating disc or a ramp. Within half a period of either end the nearest
   * whole one counts. Returns @p amplitudes for fewer than four samples a
   * period or less than one of them.
   */
  std::vector<std::complex<double>> without_drift(
    const std::vector<std::complex<double>> &amplitudes,
    const std::size_t                        period);

  /**
   * The window of a fit within the linear phase, samples @p first to @p last:
   * its last two thirds; of a motion that decays, from the start until it has
   * fallen to a thousandth. Returns {first, last}.
   */
  std::pair<std::size_t, std::size_t> fit_window(
    const std::vector<std::complex<double>> &amplitudes,
    const std::size_t                        first,
    const std::size_t                        last,
    const bool                               decays);
} // namespace squeal

#endif
