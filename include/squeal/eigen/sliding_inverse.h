// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_eigen_sliding_inverse_h
#define squeal_eigen_sliding_inverse_h

#include <squeal/base/low_rank_matrix.h>
#include <squeal/eigen/undamped_modes.h>

#include <Eigen/LU>

#include <vector>

namespace squeal
{
  /**
   * (K_0 + N - shift M)^-1 with the friction N of low rank, and its transpose,
   * from the one real LDL^T factor of the frictionless problem:
   * with N = L^T G and S the frictionless inverse,
   * (S^-1 + L^T G)^-1 = S - S L^T (1 + G S L^T)^-1 G S  (Woodbury).
   * Another contact state than that of the factor is a change of low rank too.
   * Friction moves the spectrum of a stiff contact far more than one step of
   * an iteration with S can follow; with this inverse it is exact.
   */
  class SlidingInverse
  {
  public:
    /** Solves once for every row of the friction operators and of those
     * symmetric ones of low rank that are there in other contact states than
     * that of @p pencil. Non-symmetric terms that are not of low rank, or of
     * more than 600 rows (200 where the factor is on disk), are left out: the
     * inverse is then that of a neighbouring problem. */
    SlidingInverse(const Pencil &pencil, const ShiftedInverse &inverse);

    /** The same factor and the same rows with the strength that @p pencil gives
     * them: no solve is needed. Other parts than those of @p other leave the
     * plain inverse. */
    SlidingInverse(const Pencil &pencil, const SlidingInverse &other);

    Block solve(const Block &b) const;
    Block solve_transposed(const Block &b) const;

  private:
    /** Operators L^T G of one L. */
    struct Rows
    {
      const Functionals                                      *left;
      std::vector<std::pair<double, const LowRankOperator *>> terms;
    };

    /** Terms of @p pencil with their factors; symmetric ones by what they are
     * more than @p factored. */
    std::vector<Rows> collect(
      const Pencil                        &pencil,
      const std::vector<TermCoefficients> &factored) const;
    void            factorize_capacitance();
    Eigen::MatrixXd forces(const Block &X) const;
    Block           transposed_forces(const Eigen::MatrixXd &g) const;

    std::shared_ptr<const RowSpace>      space;
    const ShiftedInverse                &inverse;
    std::vector<TermCoefficients>        factored; /**< of the parts */
    std::vector<Rows>                    rows;
    std::shared_ptr<const Block>         responses; /**< S L^T */
    Eigen::PartialPivLU<Eigen::MatrixXd> capacitance;
  };
} // namespace squeal

#endif
