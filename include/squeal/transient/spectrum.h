// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_transient_spectrum_h
#define squeal_transient_spectrum_h

#include <vector>

namespace squeal
{
  /** Share of the power that a lower line must have to count. */
  constexpr double least_power_share = 0.05;

  /** What the correlation with itself may lack of 1 in a signal that repeats
   * itself, and of the best one in a period that counts. A line of 5 % of the
   * power that is turned around costs as much. */
  constexpr double most_aperiodic = 0.1;

  /** Power spectral density of a signal, one-sided. */
  struct Spectrum
  {
    std::vector<double> frequency; /**< Hz, from 0 in equal steps */
    std::vector<double> density;   /**< (unit of the signal)^2 / Hz */

    /** Frequency of the largest density between two frequencies, refined by a
     * parabola through the logarithms of three values; 0 if there is none. */
    double peak(const double lowest, const double highest) const;
    /**
     * Frequency of a periodic motion: its largest line, or that over 2, 3 or 4.
     * It is the shortest of these periods after which the signal repeats itself
     * almost as well as after any of them, however weak the line of that period
     * is, if it repeats itself at all (threshold of YIN: de Cheveigne and
     * Kawahara, J. Acoust. Soc. Am. 111, 2002). Of a signal that does not,
     * multiples of the lower frequency hold at least 5 % of the power more than
     * those of the higher one, and than chance would give them. 0 if there is
     * no line.
     */
    double fundamental(const double lowest, const double highest) const;
    /** Of what lies between half of @p lowest and @p highest, Hz, with itself a
     * period of @p frequency later: 1 where that is a period or a multiple of
     * one. */
    double correlation(const double frequency,
                       const double lowest,
                       const double highest) const;
    /** Integral of the density between half of @p lowest and @p highest. */
    double power(const double lowest, const double highest) const;
    /** Root of the integral of the density within a relative width around a
     * frequency: the rms of one line. */
    double line_rms(const double centre, const double relative_width) const;
  };

  /**
   * Welch's estimate: Hann windows over half-overlapping parts of @p n_parts
   * equal lengths (1: the whole), the mean taken off.
   */
  Spectrum power_spectrum(const std::vector<double> &signal,
                          const double               interval,
                          const unsigned int         n_parts = 1);

  /** Phase of @p b against @p a at a frequency, degrees in (-180, 180]. */
  double phase_difference(const std::vector<double> &a,
                          const std::vector<double> &b,
                          const double               interval,
                          const double               frequency);

  /**
   * How well a signal repeats itself with a frequency: the largest correlation
   * coefficient with itself 1 to 20 periods later, each to the next sample. 1
   * for a periodic signal, less with every motion beside it; about 1/sqrt(n) at
   * worst. 0 where fewer than two periods are there.
   */
  double repetition(const std::vector<double> &signal,
                    const double               interval,
                    const double               frequency);

  /**
   * By how much the largest line within 10 % of a frequency is off it in the
   * quarters of a signal, at worst, Hz. A quarter without a line does not
   * count; NaN if none has one.
   */
  double line_deviation(const std::vector<double> &signal,
                        const double               interval,
                        const double               frequency);

  /** Two signals at one frequency over time. */
  struct PhaseHistory
  {
    std::vector<double> time;        /**< s, middles of the windows */
    std::vector<double> amplitude_a; /**< unit of the signal */
    std::vector<double> amplitude_b;
    /** Of b against a, degrees in (-180, 180]; NaN where an amplitude is below
     * the gate. */
    std::vector<double> phase;
  };

  /**
   * Complex demodulation at @p frequency over half-overlapping Hann windows of
   * @p n_periods. The mean of each window is taken off. The motion's own
   * frequency may differ by a part of frequency / n_periods: both signals turn
   * alike. Signals start at @p start. Empty where a window is longer than the
   * signals.
   *
   * @param gate  least amplitude of both that has a phase
   */
  PhaseHistory phase_history(const std::vector<double> &a,
                             const std::vector<double> &b,
                             const double               start,
                             const double               interval,
                             const double               frequency,
                             const double               gate,
                             const double               n_periods = 20.);
} // namespace squeal

#endif
