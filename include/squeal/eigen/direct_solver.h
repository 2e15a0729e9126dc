// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_eigen_direct_solver_h
#define squeal_eigen_direct_solver_h

#include <squeal/base/mumps.h>
#include <squeal/eigen/complex_pairs.h>

#include <memory>

namespace squeal
{
  /**
   * The check of the certified solver: sparse shift-invert Arnoldi (PARPACK's
   * znaupd) on the linearised problem, with a complex LU of Q(shift) by MUMPS.
   * With z = (x, lambda x) one step solves
   * Q(s) x_1 = -(M v + (C + s M) u), x_2 = u + s x_1.
   */
  class DirectSolver
  {
  public:
    /** Factorises Q(shift). */
    DirectSolver(const Pencil &pencil, const std::complex<double> shift);

    /**
     * The @p n_pairs eigenvalues nearest to the shift with right vectors and
     * residuals (no left vectors, no error estimates: NaN). Eigenvalues of both
     * half-planes may be among them. Throws ComputationError when ARPACK does
     * not converge.
     */
    ComplexPairs solve(const unsigned int n_pairs,
                       const double       tolerance = 1e-12) const;

  private:
    Eigen::VectorXcd apply(const Eigen::VectorXcd &z) const;

    const Pencil                                             &pencil;
    std::complex<double>                                      shift;
    std::unique_ptr<MumpsFactorization<std::complex<double>>> factor;
  };
} // namespace squeal

#endif
