// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_eigen_mass_basis_h
#define squeal_eigen_mass_basis_h

#include <squeal/discretization/affine_system.h>

#include <memory>

namespace squeal
{
  /**
   * Columns that are added at the end. The memory grows in place where the
   * system can do that, so that a basis of gigabytes is never there twice.
   */
  class GrowingBlock
  {
  public:
    explicit GrowingBlock(const unsigned int n_rows = 0);
    GrowingBlock(GrowingBlock &&other) noexcept;
    GrowingBlock &operator=(GrowingBlock &&other) noexcept;
    ~GrowingBlock();
    /** Throws std::bad_alloc where there is no memory. */
    void         append(const Eigen::Ref<const Block> &columns);
    unsigned int n_columns() const;
    /** The columns as one matrix expression. */
    Eigen::Map<const Block> view() const;

  private:
    void reserve(const std::size_t n_bytes);

    Eigen::Index n_rows;
    unsigned int n_used  = 0;
    std::size_t  n_bytes = 0; /**< mapped */
    double      *data    = nullptr;
  };

  /** Whether a basis keeps its products with the symmetric operators: each
   * takes as much memory as the basis itself. */
  enum class BasisProducts
  {
    kept,
    computed_anew
  };

  /**
   * A mass-orthonormal basis Q and its product M Q. Keeping the product makes
   * orthogonalisation free of matrix products.
   */
  class MassBasis
  {
  public:
    explicit MassBasis(const Pencil       &pencil,
                       const BasisProducts products = BasisProducts::kept);

    /**
     * Orthonormalises the columns of @p W against the basis, then among
     * themselves, and appends them; directions that shrink below @p drop of
     * their own size are dropped. Returns the columns added; @p coefficients
     * (optional) receives Q^T M W of the old basis. @p twice: projects a second
     * time even where little was taken away.
     */
    Block extend(Block            W,
                 const double     drop,
                 Eigen::MatrixXd *coefficients = nullptr,
                 const bool       twice        = false);

    /** Starts an empty basis with columns that are mass-orthonormal already and
     * their products with the mass. */
    void adopt(const Eigen::Ref<const Block> &W,
               const Eigen::Ref<const Block> &MW);

    unsigned int            size() const;
    Eigen::Map<const Block> vectors() const;
    /** M Q, where it is kept. */
    Eigen::Map<const Block> mass_products() const;
    bool                    keeps_products() const;

  private:
    const Pencil &pencil;
    bool          keeps;
    GrowingBlock  Q, MQ;
  };

  /** X^T Y summed over the ranks, for any dense expressions. */
  template <typename X, typename Y>
  Eigen::MatrixXd
  inner_products(const RowSpace &space, const X &x, const Y &y)
  {
    Eigen::MatrixXd result = x.transpose() * y;
    space.sum(result);
    return result;
  }
} // namespace squeal

#endif
