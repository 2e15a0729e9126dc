// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_base_sparse_matrix_h
#define squeal_base_sparse_matrix_h

#include <squeal/base/row_space.h>

#include <Eigen/SparseCore>

#include <memory>
#include <vector>

namespace squeal
{
  /** Entries of a matrix in global rows and columns; duplicates add up. */
  struct Triplets
  {
    std::vector<int>    rows, columns;
    std::vector<double> values;

    void
    add(const int row, const int column, const double value)
    {
      rows.push_back(row);
      columns.push_back(column);
      values.push_back(value);
    }
  };



  /**
   * A real linear operator on the rows of a row space.
   */
  class LinearOperator
  {
  public:
    virtual ~LinearOperator() = default;

    /** A X. */
    virtual Block multiply(const Block &X) const = 0;

    /** A^T X. */
    virtual Block multiply_transposed(const Block &X) const = 0;

    /** |A| |X|, entry by entry: the size that rounding errors of A X have in
     * units of the machine precision. */
    virtual Block multiply_absolute(const Block &X) const = 0;

    /** True where A^T = A. */
    virtual bool is_symmetric() const = 0;

    /** Appends this rank's entries of factor * A in global numbering; of a
     * symmetric operator only the lower triangle when @p lower_only. */
    virtual void append_to(Triplets    &triplets,
                           const double factor,
                           const bool   lower_only) const = 0;
  };



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
    bool  is_symmetric() const override;
    void  append_to(Triplets    &triplets,
                    const double factor,
                    const bool   lower_only) const override;

    /** this += factor * other; the two share one pattern. */
    void add(const double factor, const SparseMatrix &other);

    /** True where @p other has the same rows and columns. */
    bool same_pattern(const SparseMatrix &other) const;

    Symmetry        symmetry() const;
    std::size_t     n_nonzeros() const;
    const RowSpace &space() const;

  private:
    template <bool absolute>
    Block product(const Block &X) const;
    template <bool absolute, int width>
    void product_of_columns(const Eigen::MatrixXd &X,
                            const int              first,
                            Eigen::MatrixXd       &result) const;

    std::shared_ptr<const RowSpace> row_space;
    std::vector<std::size_t>        row_starts;
    std::vector<int>                columns;
    std::vector<int>                tiles; /**< first rows of equal patterns */
    std::vector<double>             values;
    Symmetry                        kind;
  };



  /**
   * A few linear functionals of the unknowns (displacements at points, gaps,
   * slips): the rows of a wide sparse matrix B, known in full on every rank.
   */
  class Functionals
  {
  public:
    using Row = std::vector<std::pair<unsigned int, double>>;

    /** @p rows in global numbering, the same on every rank. */
    Functionals(std::shared_ptr<const RowSpace> space, std::vector<Row> rows);

    unsigned int n_rows() const;
    /** B X: n_rows x columns, the same on every rank. */
    Eigen::MatrixXd  apply(const Block &X) const;
    Eigen::MatrixXcd apply(const ComplexBlock &X) const;
    /** |B| |X|, entry by entry. */
    Eigen::MatrixXd apply_absolute(const Block &X) const;
    /** |B|^T |G|. */
    Block apply_transposed_absolute(const Eigen::MatrixXd &G) const;
    /** B^T G. */
    Block        apply_transposed(const Eigen::MatrixXd &G) const;
    ComplexBlock apply_transposed(const Eigen::MatrixXcd &G) const;

    const std::vector<Row> &rows() const;
    const RowSpace         &space() const;

  private:
    std::shared_ptr<const RowSpace>              row_space;
    std::vector<Row>                             all_rows;
    Eigen::SparseMatrix<double, Eigen::RowMajor> owned;
  };



  /**
   * An operator A = L^T G of few rows: the forces on the functionals L (point
   * displacements, slips) follow from the motion by G.
   */
  class LowRankOperator : public LinearOperator
  {
  public:
    virtual const Functionals &left_rows() const = 0;
    /** G X, the same on every rank: A X = L^T (G X). */
    virtual Eigen::MatrixXd forces(const Block &X) const = 0;
    /** G^T g: A^T X = G^T (L X). */
    virtual Block transposed_forces(const Eigen::MatrixXd &g) const = 0;

    Block multiply(const Block &X) const override;
    Block multiply_transposed(const Block &X) const override;
  };



  /**
   * The low-rank operator L^T diag(w) R of springs, contact and friction;
   * symmetric when L and R are the same object.
   */
  class LowRankMatrix : public LowRankOperator
  {
  public:
    LowRankMatrix(std::shared_ptr<const Functionals> left,
                  Eigen::VectorXd                    weights,
                  std::shared_ptr<const Functionals> right);

    const Functionals &left_rows() const override;
    Eigen::MatrixXd    forces(const Block &X) const override;
    Block transposed_forces(const Eigen::MatrixXd &g) const override;
    Block multiply_absolute(const Block &X) const override;
    bool  is_symmetric() const override;
    /** All entries come from the first rank of the functionals' space. */
    void append_to(Triplets    &triplets,
                   const double factor,
                   const bool   lower_only) const override;

    std::shared_ptr<const Functionals> left, right;
    Eigen::VectorXd                    weights;

  private:
    bool on_root;
  };



  /** The sum of factor * operator over its parts. */
  class SumOperator : public LinearOperator
  {
  public:
    using Part = std::pair<double, std::shared_ptr<const LinearOperator>>;
    explicit SumOperator(std::vector<Part> parts);

    const std::vector<Part> &summands() const;

    Block multiply(const Block &X) const override;
    Block multiply_transposed(const Block &X) const override;
    Block multiply_absolute(const Block &X) const override;
    bool  is_symmetric() const override;
    void  append_to(Triplets    &triplets,
                    const double factor,
                    const bool   lower_only) const override;

  private:
    std::vector<Part> parts;
  };
} // namespace squeal

#endif
