// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_sweep_exceptional_point_h
#define squeal_sweep_exceptional_point_h

#include <squeal/sweep/branch_tracker.h>

#include <Eigen/Core>

#include <complex>
#include <functional>
#include <optional>
#include <vector>

namespace squeal
{
  /** M, C and K of a small problem, 1/s as unit of lambda. */
  struct ContinuedMatrices
  {
    Eigen::MatrixXcd mass, damping, stiffness;
  };

  /** A small problem at complex coordinates of a line. */
  struct ContinuedPencil
  {
    /** Nothing where the matrices have no continuation off the real axis. */
    std::function<std::optional<ContinuedMatrices>(
      const std::complex<double> coordinate)>
      at;
    /** Its vectors (columns) in the coordinates of those of the pairs. */
    Eigen::MatrixXd basis;
  };

  /** Problems that hold near a real coordinate, each better than the one before
   * and dearer. */
  using Continuation =
    std::function<std::vector<ContinuedPencil>(const double coordinate)>;

  /** Where two pairs coalesce. */
  struct Coalescence
  {
    std::complex<double> coordinate;
    std::complex<double> lambda; /**< of both, 1/s */
    /** The two at the real part of the coordinate, 1/s. */
    std::complex<double> beside[2];
  };

  /** A stretch of real coordinates. */
  struct Stretch
  {
    double lower = 0., upper = 0.;
  };

  /**
   * The exceptional point of the pairs on @p branch_1 and @p branch_2, which
   * both points have: the root of ((lambda_1 - lambda_2) / 2)^2 by secant steps
   * from the two points, the two eigenvalues being followed to complex
   * coordinates.
   *
   * Nothing where the steps do not converge, to 1e-10 of the stretch and 1e-6
   * of |lambda| for the half-difference; where the root is double or the
   * vectors stay apart, as at a crossing of pairs that are not coupled; or
   * where
   * it lies away from @p line: its real part by more than 5 percent of the
   * stretch, its imaginary part by more than all of it.
   */
  std::optional<Coalescence> coalescence_of(const Continuation &continuation,
                                            const TrackedPoint &a,
                                            const TrackedPoint &b,
                                            const int           branch_1,
                                            const int           branch_2,
                                            const Stretch      &line);
} // namespace squeal

#endif
