// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_sweep_branch_tracker_h
#define squeal_sweep_branch_tracker_h

#include <squeal/eigen/complex_pairs.h>

#include <functional>
#include <vector>

namespace squeal
{
  /** Solution at one place of a line through the parameter box. */
  struct TrackedPoint
  {
    double           coordinate = 0.;
    bool             asked      = false; /**< else inserted while tracking */
    ComplexPairs     pairs;
    std::vector<int> branch; /**< of every pair */

    /** Number of the pair on a branch, or -1. */
    int pair_of(const int wanted) const;
  };

  /** Options of the tracking. */
  struct TrackingOptions
  {
    double lowest_frequency  = 0.;
    double highest_frequency = 0.;
    /** Steps are not divided below this, in units of the coordinate. */
    double smallest_step = 1e-7;
    /** Distance to which close encounters are located. */
    double touch_tolerance = 1e-5;
    /** Points that are inserted, about: once there are as many, steps are not
     * divided any more, and what is in doubt is matched by frequency. */
    unsigned int most_inserted = 2000;
    /** The problem is real but for a factor: pairs coalesce on the real
     * parameter axis. */
    bool real = true;
  };

  /**
   * Follows eigenpairs along a line through the parameter box.
   *
   * Pairs of neighbouring points belong together when the product of the two
   * overlaps of left with right vectors is one; of pairs that coalesce in
   * between the two-dimensional invariant subspaces are compared instead
   * (determinants of overlaps, which no basis of the subspace changes). Where
   * that is ambiguous the step is divided. Points are also inserted where two
   * frequencies come closest, so that no lock-in is stepped over.
   *
   * A conjugate pair that becomes real goes on as the upper one of the two real
   * eigenvalues, which grows where the stiffness has lost its sign; the lower
   * one, which has nearly the same vectors, is a branch of its own.
   *
   * Inside an invariant pair that has coalesced branches are ordered by sigma:
   * the branch with the lower frequency outside has the lower sigma inside. So
   * a branch does not depend on the way it was reached on the line.
   */
  class BranchTracker
  {
  public:
    using Solver = std::function<ComplexPairs(const double)>;

    BranchTracker(const Solver &solver, const TrackingOptions &options);

    /** Solves at the coordinates (ascending) and where else it must. Branches
     * are numbered by frequency at the first point, later ones as they come. */
    std::vector<TrackedPoint> track(const std::vector<double> &coordinates);

    /** Number of points that were inserted. */
    unsigned int n_inserted() const;

  private:
    const Solver          solver;
    const TrackingOptions options;
    unsigned int          inserted = 0;
  };

  /** Pairs of two neighbouring points that belong together. */
  struct PairMatches
  {
    std::vector<int> to;         /**< pair of the second point, or -1 */
    bool             is_certain; /**< no pair inside the band is in doubt */
  };

  PairMatches match_pairs(const ComplexPairs    &a,
                          const ComplexPairs    &b,
                          const TrackingOptions &options);

  /** Where the branches of a closed path end: number k of the result is the
   * branch of @p first that the pair on branch k of @p last turned into, both
   * points being the same place. Round an exceptional point two are exchanged;
   * that is no error. */
  std::vector<int> loop_permutation(const TrackedPoint    &first,
                                    const TrackedPoint    &last,
                                    const TrackingOptions &options);

  /** Minus a quarter of Re (lambda_i - lambda_j)^2: positive for two
   * frequencies, negative for a coalesced pair, smooth through the coalescence.
   */
  double squared_split(const ComplexPairs &pairs, const int i, const int j);

  /** Whether an eigenvalue is real, as those of a motion that diverges or is
   * overdamped: two of them stand in the place of one conjugate pair. */
  bool is_real(const ComplexPairs &pairs, const int i);

  /** Whether two pairs are a multiple eigenvalue with vectors of its own, such
   * as the doublet of a round disc: their difference is rounding, and they do
   * not coalesce however small it is. */
  bool is_multiple(const ComplexPairs &pairs, const int i, const int j);
} // namespace squeal

#endif
