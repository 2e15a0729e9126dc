// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_eigen_reduced_basis_h
#define squeal_eigen_reduced_basis_h

#include <squeal/discretization/affine_system.h>
#include <squeal/eigen/dense_quadratic.h>
#include <squeal/eigen/mass_basis.h>

#include <vector>

namespace squeal
{
  /** Residual vectors r of pairs, ||r|| over its denominator |lambda|^2 ||M x||
   * + |lambda| ||C x|| + ||K x||, and that denominator. */
  struct PairResiduals
  {
    ComplexBlock    vectors;
    Eigen::VectorXd relative, denominators;
  };

  /**
   * A mass-orthonormal basis V of a subspace and the operator parts projected
   * on it, V^T A V. `reduce` is solve(), `reconstruct` is lift().
   */
  class ReducedBasis
  {
  public:
    /** Of symmetric parts the products with V are @p kept or computed anew
     * whenever they are needed; product_gram() needs kept ones. */
    explicit ReducedBasis(const Pencil       &pencil,
                          const BasisProducts kept = BasisProducts::kept);

    /** Starts with mass-orthonormal vectors and their products with the mass
     * and with the symmetric stiffness K_0. */
    void start(const Eigen::Ref<const Block> &W,
               const Eigen::Ref<const Block> &MW,
               const Eigen::Ref<const Block> &KW);

    /** Adds the directions of @p W that V does not hold yet and projects.
     * Returns how many were added. */
    unsigned int extend(Block W);

    /** Frees what extend() and residuals() need, when both are done. */
    void release_products();

    unsigned int                    size() const;
    bool                            keeps_products() const;
    Eigen::Map<const Block>         vectors() const;
    const std::vector<ReducedPart> &parts() const;

    /** All eigenpairs of the reduced pencil in basis coordinates. */
    DensePairs solve() const;

    /** V z; coordinates of an earlier, smaller basis will do. */
    ComplexBlock lift(const Eigen::MatrixXcd &coordinates) const;

    /** Residuals Q(lambda) V z of pairs (of the transposed pencil where
     * @p transposed), from the stored products of every part with V. */
    PairResiduals residuals(const Eigen::VectorXcd &lambda,
                            const Eigen::MatrixXcd &coordinates,
                            const bool              transposed) const;

    /** The same with other coefficients of the parts. */
    PairResiduals residuals(const std::vector<TermCoefficients> &coefficients,
                            const Eigen::VectorXcd              &lambda,
                            const Eigen::MatrixXcd              &coordinates,
                            const bool transposed) const;

    /** The same with coefficients of the parts for each pair. */
    PairResiduals residuals(
      const std::vector<std::vector<TermCoefficients>> &of_pairs,
      const Eigen::VectorXcd                           &lambda,
      const Eigen::MatrixXcd                           &coordinates,
      const bool                                        transposed) const;

    /** (A V)^T (B V) of the parts number @p i and @p j: the norm of any
     * residual follows without its vector. */
    Eigen::MatrixXd product_gram(const std::size_t i,
                                 const std::size_t j) const;

  private:
    /** A V of one part on the rows where it is not zero: those of friction
     * are few. */
    struct Product
    {
      std::vector<Eigen::Index> rows; /**< empty: all */
      GrowingBlock              columns;
      /** Takes the rows in which the product with a column without zeros is
       * not zero, where these are few. */
      void reach(const Eigen::VectorXd &A_probe);
      void append(const Eigen::Ref<const Block> &AW);
      /** X^T A W for the columns W appended last. */
      Eigen::MatrixXd projected_on(const Eigen::Map<const Block> &X,
                                   const unsigned int             n_last) const;
    };

    /** Adds the projection of part @p i on the new vectors @p W. */
    void project(const std::size_t i, const Block &W);
    /** The same for a symmetric part whose product @p AW is at hand. */
    void append_symmetric(const std::size_t              i,
                          const Eigen::Ref<const Block> &AW);
    /** Adds V^T A W and (V^T A^T W)^T to the projection; none below where A is
     * symmetric. */
    void grow(const std::size_t      i,
              const Eigen::MatrixXd &right,
              const Eigen::MatrixXd &below);
    /** The only symmetric part with that coefficient, or the number of parts.
     */
    std::size_t lone_part(
      double (*coefficient)(const TermCoefficients &)) const;
    /** A V z of part @p i with z complex, on the rows of its product: real
     * parts, then imaginary ones. */
    Block product_with(const std::size_t       i,
                       const bool              transposed,
                       const Eigen::MatrixXcd &z) const;

    const Pencil        &pencil;
    MassBasis            basis;
    std::vector<Product> products, transposed_products;
    /** The part whose product is that of the basis with the mass, if any. */
    std::size_t mass_part;
    /** The part whose product with the start is that of K_0, if any. */
    std::size_t              stiffness_part;
    std::vector<ReducedPart> projected;
    bool                     rayleigh;
    double                   alpha, beta;
  };
} // namespace squeal

#endif
