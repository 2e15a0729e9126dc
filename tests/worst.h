// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tests_worst_h
#define squeal_tests_worst_h

#include <Eigen/Core>

#include <cstdio>
#include <limits>
#include <string>

#include "check.h"

namespace squeal
{
  namespace testing
  {
    /**
     * The largest and the smallest of values that a test collects.
     *
     * A NaN makes both NaN, whenever it is added, and so does an empty set.
     * Every comparison with NaN is false, so that such a set neither is within
     * a limit nor beyond one; std::max(worst, x) would drop the NaN.
     */
    class Worst
    {
    public:
      /** @p place says where a value was found, for the printed line. */
      void
      add(const double value, const std::string &place = "")
      {
        const bool is_first = ++n_values == 1;
        if (!is_first && std::isnan(most))
          return;
        if (is_first || !(value <= most))
          {
            most       = value;
            where_most = place;
          }
        if (is_first || !(value >= least))
          {
            least       = value;
            where_least = place;
          }
      }

      double
      largest() const
      {
        return most;
      }

      double
      smallest() const
      {
        return least;
      }

      const std::string &
      place_of_largest() const
      {
        return where_most;
      }

      const std::string &
      place_of_smallest() const
      {
        return where_least;
      }

      unsigned int
      size() const
      {
        return n_values;
      }

      /** Whether there are values and all of them are at most @p limit. */
      bool
      is_within(const double limit) const
      {
        return n_values > 0 && most <= limit;
      }

      /** Whether there are values and all of them are at least @p limit. */
      bool
      stays_above(const double limit) const
      {
        return n_values > 0 && least >= limit;
      }

    private:
      unsigned int n_values = 0;
      double       most     = std::numeric_limits<double>::quiet_NaN();
      double       least    = std::numeric_limits<double>::quiet_NaN();
      std::string  where_most, where_least;
    };

    /** The largest coefficient of a real array or matrix; NaN where one of them
     * is NaN or where there is none. Eigen's maxCoeff() may drop a NaN. */
    template <typename Derived>
    double
    largest(const Eigen::DenseBase<Derived> &values)
    {
      return values.size() == 0
               ? std::numeric_limits<double>::quiet_NaN()
               : values.derived().template maxCoeff<Eigen::PropagateNaN>();
    }

    /** The smallest one, likewise. */
    template <typename Derived>
    double
    smallest(const Eigen::DenseBase<Derived> &values)
    {
      return values.size() == 0
               ? std::numeric_limits<double>::quiet_NaN()
               : values.derived().template minCoeff<Eigen::PropagateNaN>();
    }

    /** The largest absolute value of a real or complex array or matrix. */
    template <typename Derived>
    double
    largest_abs(const Eigen::MatrixBase<Derived> &values)
    {
      return largest(values.cwiseAbs());
    }

    namespace internal
    {
      inline std::string
      found(const double       value,
            const std::string &place,
            const std::string &relation,
            const double       limit)
      {
        char text[64];
        std::snprintf(
          text, sizeof text, "%.3g %s %.3g", value, relation.c_str(), limit);
        return std::string(": ") + text + (place.empty() ? "" : " at ") + place;
      }
    } // namespace internal

    /** check(all values <= @p limit) that prints the largest and its place. */
    inline void
    check_within(const Worst       &worst,
                 const double       limit,
                 const std::string &text)
    {
      check(worst.is_within(limit),
            text + internal::found(
                     worst.largest(), worst.place_of_largest(), "<=", limit));
    }

    /** check(all values >= @p limit) that prints the smallest and its place. */
    inline void
    check_above(const Worst &worst, const double limit, const std::string &text)
    {
      check(worst.stays_above(limit),
            text + internal::found(
                     worst.smallest(), worst.place_of_smallest(), ">=", limit));
    }
  } // namespace testing
} // namespace squeal

#endif
