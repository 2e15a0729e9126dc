// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_base_sparse_matrix_h
#define squeal_base_sparse_matrix_h

#include <squeal/base/linear_operator.h>

#include <memory>
#include <utility>

namespace squeal
{
  /**
   * A sparse matrix A with A^T = A or A^T = -A, of which the lower triangle is
   * stored. Each rank holds the sum over its own cells in local numbering; the
   * matrix is the sum over the ranks, so that neither assembly nor
   * factorisation needs communication.
   */
  class SparseMatrix : public LinearOperator
  {
  public:
    enum class Symmetry
    {
      symmetric,
      skew
    };

    /** Takes the compressed rows of the lower triangle (diagonal included) in
     * local numbering, columns ascending in each row. */
    SparseMatrix(std::shared_ptr<const RowSpace> space,
                 std::vector<std::size_t>        row_starts,
                 std::vector<int>                columns,
                 std::vector<double>             values,
                 const Symmetry symmetry = Symmetry::symmetric);

    /** From entries of the lower triangle in local numbering. */
    SparseMatrix(std::shared_ptr<const RowSpace> space,
                 const Triplets                 &lower,
                 const Symmetry symmetry = Symmetry::symmetric);

    Block multiply(const Block &X) const override;
    Block multiply_transposed(const Block &X) const override;
    Block multiply_absolute(const Block &X) const override;

    /** The sum of factor A X over matrices of one row space, with one pass over
     * the vectors. */
    using Term = std::pair<double, const SparseMatrix *>;
    static Block multiply_sum(const std::vector<Term> &terms, const Block &X);

    bool is_symmetric() const override;
    void append_to(Triplets    &triplets,
                   const double factor,
                   const bool   lower_only) const override;

    /** Appends this rank's entries of the rows that @p wanted, a flag for each
     * global row, has, without the others. */
    void append_rows_to(Triplets                &triplets,
                        const std::vector<bool> &wanted) const;

    /** this += factor * other; the two share one pattern. */
    void add(const double factor, const SparseMatrix &other);

    /** True where @p other has the same rows and columns. */
    bool same_pattern(const SparseMatrix &other) const;

    Symmetry        symmetry() const;
    std::size_t     n_nonzeros() const;
    const RowSpace &space() const;

  private:
    template <int width>
    using RowBlock =
      Eigen::Matrix<double, Eigen::Dynamic, width, Eigen::RowMajor>;
    template <bool absolute>
    static Block sum_of_products(const std::vector<Term> &terms,
                                 const Block             &X);
    template <bool absolute>
    static Eigen::MatrixXd local_products(const std::vector<Term> &terms,
                                          const Eigen::MatrixXd   &X);
    template <bool absolute, int width>
    void add_to_columns(const double           factor,
                        const RowBlock<width> &x,
                        RowBlock<width>       &y) const;

    std::shared_ptr<const RowSpace> row_space;
    std::vector<std::size_t>        row_starts;
    std::vector<int>                columns;
    std::vector<int>                tiles; /**< first rows of equal patterns */
    std::vector<double>             values;
    Symmetry                        kind;
  };
} // namespace squeal

#endif
