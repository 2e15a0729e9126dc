// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_eigen_complex_pairs_h
#define squeal_eigen_complex_pairs_h

#include <squeal/discretization/affine_system.h>

#include <string>
#include <vector>

namespace squeal
{
  /**
   * Eigenpairs of the quadratic pencil: Q(lambda) x = 0, y^T Q(lambda) = 0,
   * lambda = sigma + i omega, sigma > 0 unstable, f = omega / 2 pi >= 0, each
   * conjugate pair once, ascending in frequency.
   */
  struct ComplexPairs
  {
    Eigen::VectorXcd lambda; /**< 1/s */
    ComplexBlock     right, left;
    /** ||Q x|| / (|lambda|^2 ||M x|| + |lambda| ||C x|| + ||K x||). */
    Eigen::VectorXd residual;
    /** The same of the left vectors. */
    Eigen::VectorXd left_residual;
    /** Estimated |d lambda| / |lambda| against the full model; of members of a
     * nearly coalesced pair, that of the pair's mean plus half-difference. */
    Eigen::VectorXd error_estimate;
    /** Rounding floor of residual_rel, below which no basis can bring it:
     * 4 eps || |K| |x| || over the same denominator, or the residual at which
     * the basis stalled. */
    Eigen::VectorXd noise_floor;
    /** ||x|| ||y|| |2 lambda| / |y^T (2 lambda M + C) x| in mass norms: 1 for
     * undamped modes, at most 4.5e15, at a coalescence. */
    Eigen::VectorXd condition;
    /** The other member where the condition exceeds 1e4, else -1. */
    std::vector<int> pair_partner;

    unsigned int
    size() const
    {
      return static_cast<unsigned int>(lambda.size());
    }
    double
    sigma(const unsigned int i) const
    {
      return lambda[i].real();
    }
    double frequency(const unsigned int i) const;
    /** zeta = -sigma / |lambda|. */
    double damping_ratio(const unsigned int i) const;
  };

  /** Eigenvalue conditions above this are judged on the invariant pair. */
  constexpr double coalescence_condition = 1e4;

  /** Keeps the listed pairs, in that order. */
  ComplexPairs select_pairs(const ComplexPairs     &pairs,
                            const std::vector<int> &kept);

  /** residual_rel of right vectors (or left ones, with the transposed
   * pencil). */
  Eigen::VectorXd relative_residuals(const Pencil           &pencil,
                                     const Eigen::VectorXcd &lambda,
                                     const Pencil::Products &products,
                                     ComplexBlock           &residual_vectors,
                                     Eigen::VectorXd        &denominators);
} // namespace squeal

#endif
