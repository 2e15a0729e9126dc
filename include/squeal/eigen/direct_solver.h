// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_eigen_direct_solver_h
#define squeal_eigen_direct_solver_h

#include <squeal/base/mumps.h>
#include <squeal/eigen/complex_pairs.h>

#include <memory>
#include <string>
#include <vector>

namespace squeal
{
  /** Pairs of a direct solver, and how far from its shift they are all that
   * there are. */
  struct DirectPairs
  {
    ComplexPairs         pairs;
    std::complex<double> shift; /**< 1/s */
    double               reach; /**< 1/s; infinite where nothing is left */

    /** Whether an eigenvalue @p lambda, 1/s, would be among them. */
    bool
    has_reached(const std::complex<double> lambda) const
    {
      return std::abs(lambda - shift) <= reach;
    }
  };

  /** The distance from @p shift to the farthest of @p lambda, 1/s, and a little
   * more, so that rounding leaves none of them beyond it. */
  double reach_of(const Eigen::VectorXcd    &lambda,
                  const std::complex<double> shift);

  /** Numbers of the pairs of @p direct inside the band, Hz, that is_of_band()
   * tells and that have no eigenvalue of their own in @p known, 1/s, within a
   * thousandth of their size. Left out are motions at 0 Hz that neither grow
   * nor decay, pairs at an end of the band, and those whose residual shows that
   * the direct solver has not converged on them. */
  std::vector<unsigned int> pairs_missing(const Eigen::VectorXcd &known,
                                          const DirectPairs      &direct,
                                          const double            lowest,
                                          const double            highest);

  /** A sentence that names frequency and growth of @p missing eigenvalues, 1/s,
   * those that grow first; empty where there are none. */
  std::string text_of_missing(Eigen::VectorXcd missing);

  /**
   * The check of the certified solver: sparse shift-invert Arnoldi (PARPACK's
   * znaupd) on the linearised problem, with a complex LU of Q(shift) by MUMPS.
   * With z = (x, lambda x) one step solves
   * Q(s) x_1 = -(M v + (C + s M) u), x_2 = u + s x_1. Where all eigenvalues of
   * a pencil or all but one are asked for, which Arnoldi does not give, the
   * same step is solved as a dense matrix.
   */
  class DirectSolver
  {
  public:
    /** Factorises Q(shift). */
    DirectSolver(const Pencil &pencil, const std::complex<double> shift);

    /**
     * The @p n_pairs eigenvalues nearest to the shift with right vectors and
     * residuals (no left vectors, no conditions, no error estimates: NaN).
     * Eigenvalues of both half-planes may be among them. An imaginary part
     * below 1e-6 times the distance from the shift may be rounding and is 0.
     * Throws ComputationError when ARPACK does not converge.
     */
    ComplexPairs solve(const unsigned int n_pairs,
                       const double       tolerance = 1e-12) const;

    /** The eigenvalues nearest to the shift, at first @p n_pairs of them, then
     * more until they reach as far as @p radius, 1/s; up to some eight times as
     * many. Throws as solve(). */
    DirectPairs solve_within(const double       radius,
                             const unsigned int n_pairs) const;

    /** Conditions of the @p pairs of solve(), from the left vectors of the
     * transposed problem. NaN where there is no left vector for a pair. Throws
     * as solve(). */
    void find_conditions(ComplexPairs &pairs,
                         const double  tolerance = 1e-12) const;

  private:
    Eigen::VectorXcd apply(const Eigen::VectorXcd &z) const;
    Eigen::VectorXcd apply_transposed(const Eigen::VectorXcd &z) const;
    /** Left vectors of the pencil from those of the step, one a column. */
    ComplexBlock left_vectors(const ComplexBlock &Z) const;
    /** 1/s. The second half of a vector, lambda x, is in units of the shift:
     * otherwise rounding of the larger half would move all eigenvalues. */
    double scale_of_rate() const;

    const Pencil                                             &pencil;
    std::complex<double>                                      shift;
    std::unique_ptr<MumpsFactorization<std::complex<double>>> factor;
  };
} // namespace squeal

#endif
