// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_fatigue_peak_sharpener_h
#define squeal_tribology_fatigue_peak_sharpener_h

#include <cstddef>
#include <vector>

namespace squeal::tribology
{
  /**
   * A sampled history that comes in pieces, with the peaks that its samples
   * miss: each local extremum is raised to the top of the sine through it and
   * its two neighbours, about the middle between that top and the extremum
   * before. For a sine with three and more samples a period that is its
   * amplitude, with fewer it is less. None is raised across 0, beyond which an
   * open contact has nothing; one of two equal samples stays what it is, as do
   * the first and the last value.
   */
  class PeakSharpener
  {
  public:
    /** Appends to @p sharpened what the @p n values make known: each value when
     * the one behind it has come. */
    void add(const double        *values,
             std::size_t          n,
             std::vector<double> &sharpened);

    /** Appends the last value, if there is one. */
    void finish(std::vector<double> &sharpened) const;

  private:
    double top(double next) const;

    std::size_t n_values = 0;
    double      before = 0., now = 0.;
    double      turning   = 0.; /**< the extremum before, raised */
    int         direction = 0;  /**< of the last change: up 1, down -1 */
  };
} // namespace squeal::tribology

#endif
