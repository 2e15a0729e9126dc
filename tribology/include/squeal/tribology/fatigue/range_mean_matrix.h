// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_fatigue_range_mean_matrix_h
#define squeal_tribology_fatigue_range_mean_matrix_h

#include <algorithm>
#include <cstddef>
#include <vector>

namespace squeal::tribology
{
  /** Cycles by classes of their range and mean. */
  class RangeMeanMatrix
  {
  public:
    /** @p n classes of the range from 0 to @p largest_range and of the mean
     * between the two others, of equal width. */
    RangeMeanMatrix(const std::size_t n,
                    const double      largest_range,
                    const double      smallest_mean,
                    const double      largest_mean)
      : n(n)
      , range_width(largest_range / n)
      , mean_start(smallest_mean)
      , mean_width((largest_mean - smallest_mean) / n)
      , counts(n * n, 0.)
    {
    }

    /** Adds cycles; what lies outside goes to the classes at the border. */
    void
    add(const double range, const double mean, const double count)
    {
      counts[class_of(range / range_width) * n +
             class_of((mean - mean_start) / mean_width)] += count;
    }

    /** Cycles of range class @p i and mean class @p j. */
    double
    count(const std::size_t i, const std::size_t j) const
    {
      return counts[i * n + j];
    }

    std::size_t
    n_classes() const
    {
      return n;
    }

    /** Middle of range class @p i. */
    double
    range(const std::size_t i) const
    {
      return (i + 0.5) * range_width;
    }

    /** Middle of mean class @p j. */
    double
    mean(const std::size_t j) const
    {
      return mean_start + (j + 0.5) * mean_width;
    }

    /** Row by row of the range. */
    const std::vector<double> &
    values() const
    {
      return counts;
    }

  private:
    std::size_t
    class_of(const double position) const
    {
      return static_cast<std::size_t>(
        std::clamp(position, 0., static_cast<double>(n - 1)));
    }

    std::size_t         n;
    double              range_width, mean_start, mean_width;
    std::vector<double> counts;
  };
} // namespace squeal::tribology

#endif
