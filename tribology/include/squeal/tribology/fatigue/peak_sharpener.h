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
   * amplitude, with fewer it is less. Where the contact was open before (0) the
   * middle is not that of a sine, and the top is that of a parabola. None is
   * raised across 0, beyond which an open contact has nothing; one of two equal
   * samples stays what it is, as do the first and the last value.
   *
   * An extremum is unseen where its samples tell no top: beside a sample of an
   * open contact, or alone between two that are alike.
   */
  class PeakSharpener
  {
  public:
    /** @p exponent weighs the ranges of which some are unseen. */
    explicit PeakSharpener(double exponent);

    /** Appends to @p sharpened what the @p n values make known: each value when
     * the one behind it has come. */
    void add(const double        *values,
             std::size_t          n,
             std::vector<double> &sharpened);

    /** Appends the last value, if there is one. */
    void finish(std::vector<double> &sharpened) const;

    /** Share, 0 to 1, of the ranges between neighbouring extrema, each to the
     * power of the exponent, that begin or end with an unseen one; 0 where
     * there are none. */
    double unseen_share() const;

  private:
    /** Whether the middle sample is up to @p share of the largest range so
     * far: that of an open contact. */
    bool   is_within(double share) const;
    double top(double next) const;
    bool   is_unseen(double next) const;
    void   turn(double next, double raised);

    double      exponent;
    std::size_t n_values = 0;
    double      earlier = 0., before = 0., now = 0.;
    double      turning   = 0.;    /**< the extremum before, raised */
    bool        was_open  = false; /**< that extremum was of none */
    bool        hid       = false; /**< that extremum is unseen */
    int         direction = 0;     /**< of the last change: up 1, down -1 */
    /** Sums of the ranges over the largest one, to the power of the exponent:
     * their powers may be beyond the largest number. */
    double all = 0., unseen = 0., largest = 0.;
  };
} // namespace squeal::tribology

#endif
