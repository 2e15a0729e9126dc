// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_damage_sample_spacing_h
#define squeal_tribology_damage_sample_spacing_h

#include <cstdint>
#include <limits>
#include <map>
#include <string>
#include <vector>

namespace squeal::tribology
{
  /**
   * Intervals between the times of a history that comes in pieces, and whether
   * there are pauses among them: intervals of more than ten times the median
   * one. A pause counts as time in which nothing is counted. Intervals are kept
   * by classes of 2 %, so that the memory does not grow with the length.
   */
  class SampleSpacing
  {
  public:
    /** Adds @p times, s, ascending. */
    void add(const std::vector<double> &times);

    /** Median of the intervals, s: the mean of the class that has it; 0 without
     * intervals. */
    double median() const;

    /** Whether no interval is off their mean by more than a thousandth of it.
     */
    bool is_even() const;

    /** A line for a run with pauses; "" for one without. */
    std::string note() const;

  private:
    /** Intervals of about the same length. */
    struct Class
    {
      std::uint64_t n   = 0;
      double        sum = 0.; /**< s */
    };

    std::map<int, Class> classes; /**< by the logarithm of the interval */
    bool                 has_last = false;
    double               last     = 0.;                       /**< s */
    double               longest = 0., start_of_longest = 0.; /**< s */
    double               shortest    = std::numeric_limits<double>::infinity();
    std::uint64_t        n_intervals = 0;
    double               total       = 0.; /**< s */
  };
} // namespace squeal::tribology

#endif
