// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/low_rank_matrix.h>

#include <deal.II/base/exceptions.h>

namespace squeal
{
  Functionals::Functionals(std::shared_ptr<const RowSpace> space,
                           std::vector<Row>                rows)
    : row_space(std::move(space))
    , all_rows(std::move(rows))
    , owned(all_rows.size(), row_space->n_owned())
  {
    const unsigned int                  first = row_space->first_owned();
    const unsigned int                  end   = first + row_space->n_owned();
    std::vector<Eigen::Triplet<double>> entries;
    for (unsigned int r = 0; r < all_rows.size(); ++r)
      for (const auto &[column, value] : all_rows[r])
        if (column >= first && column < end)
          entries.emplace_back(r, column - first, value);
    owned.setFromTriplets(entries.begin(), entries.end());
  }

  unsigned int
  Functionals::n_rows() const
  {
    return all_rows.size();
  }

  Eigen::MatrixXd
  Functionals::apply(const Block &X) const
  {
    Eigen::MatrixXd result = owned * X;
    row_space->sum(result);
    return result;
  }

  Eigen::MatrixXcd
  Functionals::apply(const ComplexBlock &X) const
  {
    Eigen::MatrixXcd result(n_rows(), X.cols());
    result.real() = apply(Block(X.real()));
    result.imag() = apply(Block(X.imag()));
    return result;
  }

  Eigen::MatrixXd
  Functionals::apply_absolute(const Block &X) const
  {
    Eigen::MatrixXd result = owned.cwiseAbs() * X.cwiseAbs();
    row_space->sum(result);
    return result;
  }

  Block
  Functionals::apply_transposed_absolute(const Eigen::MatrixXd &G) const
  {
    return owned.cwiseAbs().transpose() * G.cwiseAbs();
  }

  Block
  Functionals::apply_transposed(const Eigen::MatrixXd &G) const
  {
    return owned.transpose() * G;
  }

  ComplexBlock
  Functionals::apply_transposed(const Eigen::MatrixXcd &G) const
  {
    ComplexBlock result(row_space->n_owned(), G.cols());
    result.real() = owned.transpose() * G.real();
    result.imag() = owned.transpose() * G.imag();
    return result;
  }

  void
  Functionals::add_transposed(const Eigen::MatrixXd &G, Block &Y) const
  {
    Y.noalias() += owned.transpose() * G;
  }

  const RowSpace &
  Functionals::space() const
  {
    return *row_space;
  }

  std::shared_ptr<const RowSpace>
  Functionals::space_pointer() const
  {
    return row_space;
  }

  const std::vector<Functionals::Row> &
  Functionals::rows() const
  {
    return all_rows;
  }



  Block
  LowRankOperator::multiply(const Block &X) const
  {
    return left_rows().apply_transposed(forces(X));
  }

  void
  LowRankOperator::add_product(const double factor,
                               const Block &X,
                               Block       &Y) const
  {
    left_rows().add_transposed(factor * forces(X), Y);
  }

  Block
  LowRankOperator::multiply_transposed(const Block &X) const
  {
    return transposed_forces(left_rows().apply(X));
  }



  LowRankMatrix::LowRankMatrix(std::shared_ptr<const Functionals> left_rows,
                               Eigen::VectorXd                    w,
                               std::shared_ptr<const Functionals> right_rows)
    : left(std::move(left_rows))
    , right(std::move(right_rows))
    , weights(std::move(w))
  {
    AssertDimension(left->n_rows(), right->n_rows());
    AssertDimension(left->n_rows(), weights.size());
    on_root = left->space().rank() == 0;
  }

  const Functionals &
  LowRankMatrix::left_rows() const
  {
    return *left;
  }

  Eigen::MatrixXd
  LowRankMatrix::forces(const Block &X) const
  {
    return weights.asDiagonal() * right->apply(X);
  }

  Block
  LowRankMatrix::transposed_forces(const Eigen::MatrixXd &g) const
  {
    return right->apply_transposed(Eigen::MatrixXd(weights.asDiagonal() * g));
  }

  Block
  LowRankMatrix::multiply_absolute(const Block &X) const
  {
    return left->apply_transposed_absolute(Eigen::MatrixXd(
      weights.cwiseAbs().asDiagonal() * right->apply_absolute(X)));
  }

  bool
  LowRankMatrix::is_symmetric() const
  {
    return left == right;
  }

  void
  LowRankMatrix::append_to(Triplets    &triplets,
                           const double factor,
                           const bool   lower_only) const
  {
    if (!on_root)
      return;
    for (unsigned int r = 0; r < left->n_rows(); ++r)
      for (const auto &[i, a] : left->rows()[r])
        for (const auto &[j, b] : right->rows()[r])
          if (!lower_only || i >= j)
            triplets.add(i, j, factor * weights[r] * a * b);
  }
} // namespace squeal
