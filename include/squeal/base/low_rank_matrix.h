// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_base_low_rank_matrix_h
#define squeal_base_low_rank_matrix_h

#include <squeal/base/linear_operator.h>

#include <Eigen/SparseCore>

#include <memory>
#include <utility>

namespace squeal
{
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
    void         add_transposed(const Eigen::MatrixXd &G, Block &Y) const;
    ComplexBlock apply_transposed(const Eigen::MatrixXcd &G) const;

    const std::vector<Row>         &rows() const;
    const RowSpace                 &space() const;
    std::shared_ptr<const RowSpace> space_pointer() const;

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
    void  add_product(const double factor,
                      const Block &X,
                      Block       &Y) const override;
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
} // namespace squeal

#endif
