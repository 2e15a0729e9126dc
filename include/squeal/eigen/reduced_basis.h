// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_eigen_reduced_basis_h
#define squeal_eigen_reduced_basis_h

#include <squeal/discretization/affine_system.h>
#include <squeal/eigen/dense_quadratic.h>
#include <squeal/eigen/mass_basis.h>

#include <vector>

namespace squeal
{
  /**
   * A mass-orthonormal basis V of a subspace and the operator parts projected
   * on it, V^T A V. `reduce` is solve(), `reconstruct` is lift().
   */
  class ReducedBasis
  {
  public:
    explicit ReducedBasis(const Pencil &pencil);

    /** Adds the directions of @p W that V does not hold yet and projects.
     * Returns how many were added. */
    unsigned int extend(const Block &W);

    unsigned int                    size() const;
    Eigen::Map<const Block>         vectors() const;
    const std::vector<ReducedPart> &parts() const;

    /** All eigenpairs of the reduced pencil in basis coordinates. */
    DensePairs solve() const;

    /** V z; coordinates of an earlier, smaller basis will do. */
    ComplexBlock lift(const Eigen::MatrixXcd &coordinates) const;

    /** M, C and K times V z (of the transposed pencil where @p transposed),
     * from the stored products of every part with V. */
    Pencil::Products apply(const Eigen::MatrixXcd &coordinates,
                           const bool              transposed) const;

  private:
    /** A V of one part on the rows where it is not zero: those of friction
     * are few. */
    struct Product
    {
      std::vector<Eigen::Index> rows; /**< empty: all */
      GrowingBlock              columns;
      void                      append(const Block &AW);
      void                      add_to(const Eigen::MatrixXcd &coordinates,
                                       ComplexBlock           &result) const;
    };

    const Pencil            &pencil;
    MassBasis                basis;
    std::vector<Product>     products, transposed_products;
    std::vector<ReducedPart> projected;
    bool                     rayleigh;
    double                   alpha, beta;
  };
} // namespace squeal

#endif
