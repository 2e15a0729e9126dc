// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/sparse_matrix.h>
#include <squeal/base/sum_operator.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>

namespace squeal
{
  SumOperator::SumOperator(std::vector<Part> p)
    : parts(std::move(p))
  {
    Assert(!parts.empty(), dealii::ExcInternalError());
  }

  const std::vector<SumOperator::Part> &
  SumOperator::summands() const
  {
    return parts;
  }

  Block
  SumOperator::multiply(const Block &X) const
  {
    std::vector<SparseMatrix::Term> sparse;
    for (const auto &[factor, part] : parts)
      if (const auto *matrix = dynamic_cast<const SparseMatrix *>(part.get()))
        sparse.emplace_back(factor, matrix);
    Block result = sparse.empty() ? Block(Block::Zero(X.rows(), X.cols()))
                                  : SparseMatrix::multiply_sum(sparse, X);
    for (const auto &[factor, part] : parts)
      if (!dynamic_cast<const SparseMatrix *>(part.get()))
        part->add_product(factor, X, result);
    return result;
  }

  Block
  SumOperator::multiply_transposed(const Block &X) const
  {
    Block result = parts[0].first * parts[0].second->multiply_transposed(X);
    for (std::size_t i = 1; i < parts.size(); ++i)
      result += parts[i].first * parts[i].second->multiply_transposed(X);
    return result;
  }

  Block
  SumOperator::multiply_absolute(const Block &X) const
  {
    Block result =
      std::abs(parts[0].first) * parts[0].second->multiply_absolute(X);
    for (std::size_t i = 1; i < parts.size(); ++i)
      result +=
        std::abs(parts[i].first) * parts[i].second->multiply_absolute(X);
    return result;
  }

  bool
  SumOperator::is_symmetric() const
  {
    return std::all_of(parts.begin(), parts.end(), [](const Part &part) {
      return part.second->is_symmetric();
    });
  }

  void
  SumOperator::append_to(Triplets    &triplets,
                         const double factor,
                         const bool   lower_only) const
  {
    for (const auto &[weight, part] : parts)
      part->append_to(triplets, factor * weight, lower_only);
  }
} // namespace squeal
