// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_sweep_stability_h
#define squeal_sweep_stability_h

#include <squeal/sweep/exceptional_point.h>

#include <complex>
#include <functional>
#include <vector>

namespace squeal
{
  /** A range of one branch along a line in which sigma is positive, and
   * somewhere by more than its own error (is_unstable()). */
  struct UnstableRange
  {
    int    branch = -1;
    double lower = 0., upper = 0.; /**< coordinates of sigma = 0 */
    bool   at_lower_limit = false; /**< still unstable at the line's end */
    bool   at_upper_limit = false;
    /** Still unstable where the branch leaves the frequency band within the
     * line: `lower` or `upper` is where it does. */
    bool   leaves_band_below = false, leaves_band_above = false;
    double peak_sigma     = 0.; /**< 1/s */
    double peak_at        = 0.;
    double peak_frequency = 0.; /**< Hz */
    /** Slopes of sigma at the two edges, 1/s a unit of the coordinate; 0 where
     * there is no edge. An error of sigma over them is an error of the edge. */
    double lower_slope = 0., upper_slope = 0.;
    /** Largest estimated |dlambda| of the branch at the ends, 1/s. */
    double sigma_error = 0.;
    /** Whether it holds a point of the line whose problem is known; if not,
     * more points may show that there is no such range. */
    bool is_certain = true;

    /** Whether sigma = 0 at `lower` and at `upper`. */
    bool
    has_lower_edge() const
    {
      return !at_lower_limit && !leaves_band_below;
    }
    bool
    has_upper_edge() const
    {
      return !at_upper_limit && !leaves_band_above;
    }
  };

  /** Where two pairs coalesce: the exceptional point nearest to the line. */
  struct ExceptionalPoint
  {
    int                  branch_1 = -1, branch_2 = -1;
    bool                 is_lock_in = true; /**< for ascending coordinates */
    std::complex<double> coordinate;
    double               frequency = 0.; /**< Hz */
    double               sigma     = 0.; /**< 1/s, of both */
    /** Eigenvalue condition at the real part of the coordinate, or at the end
     * of the line nearest to it; NaN where one of the two is not in the band.
     */
    double condition = 0.;
  };

  /**
   * What a tracked line says of stability. Edges are bracketed to @p tolerance
   * of the coordinate, peaks located to a hundred times that.
   *
   * @p is_known tells of a coordinate whether the problem is known there, not
   * only that of a neighbour, as it is with a contact state that is held
   * between points; it is the same all over between neighbouring points, and
   * true everywhere if empty. Peaks are sought where it is true; a range that
   * holds no such point has its peak anywhere and is not certain.
   */
  class LineStability
  {
  public:
    LineStability(const BranchTracker::Solver       &solver,
                  const TrackingOptions             &options,
                  const double                       tolerance,
                  const std::function<bool(double)> &is_known = {});

    std::vector<UnstableRange> ranges(
      const std::vector<TrackedPoint> &line) const;

    /** Those that coalescence_of() finds from neighbouring points of the line
     * between which the real part of a squared half-difference changes its
     * sign, each once: where the root is real, that between the two. With
     * damping that is not proportional the coordinate is complex. */
    std::vector<ExceptionalPoint> exceptional_points(
      const std::vector<TrackedPoint> &line,
      const Continuation              &continuation) const;

  private:
    /** The pair at @p x that continues pair @p i of @p near. */
    struct At
    {
      ComplexPairs pairs;
      int          pair = -1;
      double       sigma() const;
    };
    At continue_pair(const TrackedPoint &near,
                     const int           pair,
                     const double        x) const;
    /** Root of sigma between two neighbouring points. */
    double edge(const TrackedPoint &a,
                const TrackedPoint &b,
                const int           branch,
                double             &slope) const;
    /** Where the branch, unstable at the point @p inside, leaves the band on the
     * way to the neighbour @p outside, which lacks it, with a slope of NaN; or,
     * if sigma becomes zero before, that root and its slope. The point itself
     * where the problem between is not known. */
    double end_in_band(const TrackedPoint &inside,
                       const TrackedPoint &outside,
                       const int           branch,
                       double             &slope) const;
    /** Both ends of the range whose first and last points are given. */
    void find_ends(const std::vector<TrackedPoint> &line,
                   const std::size_t                first,
                   const std::size_t                last,
                   UnstableRange                   &range) const;
    bool knows(const double x) const;
    /** Whether a peak next to @p a may lie between it and its neighbour @p b.
     */
    bool may_peak_between(const TrackedPoint &a, const TrackedPoint &b) const;
    /** Returns whether sigma exceeds its error at the peak. */
    bool locate_peak(const std::vector<TrackedPoint> &line,
                     const std::size_t                at,
                     UnstableRange                   &range) const;

    const BranchTracker::Solver       solver;
    const TrackingOptions             options;
    const double                      tolerance;
    const std::function<bool(double)> known;
  };
} // namespace squeal

#endif
