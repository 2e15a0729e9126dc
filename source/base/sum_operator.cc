// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/congruent_operator.h>
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

  namespace
  {
    using Term = std::pair<double, const LinearOperator *>;

    /** The sum of factor A X: matrices in one pass over the vectors, operators
     * of one map with one application of it. */
    Block
    sum_of_products(const std::vector<Term> &terms, const Block &X)
    {
      std::vector<SparseMatrix::Term>                              sparse;
      std::vector<std::pair<const VectorMap *, std::vector<Term>>> mapped;
      std::vector<Term>                                            others;
      for (const auto &[factor, part] : terms)
        if (const auto *matrix = dynamic_cast<const SparseMatrix *>(part))
          sparse.emplace_back(factor, matrix);
        else if (const auto *congruent =
                   dynamic_cast<const CongruentOperator *>(part))
          {
            auto same = std::find_if(
              mapped.begin(), mapped.end(), [&](const auto &group) {
                return group.first == &congruent->map();
              });
            if (same == mapped.end())
              same = mapped.insert(mapped.end(), {&congruent->map(), {}});
            same->second.emplace_back(factor, &congruent->inner());
          }
        else
          others.emplace_back(factor, part);
      Block result = sparse.empty() ? Block(Block::Zero(X.rows(), X.cols()))
                                    : SparseMatrix::multiply_sum(sparse, X);
      for (const auto &[map, inner] : mapped)
        result += map->restrict_forces(sum_of_products(inner, map->expand(X)));
      for (const auto &[factor, part] : others)
        part->add_product(factor, X, result);
      return result;
    }
  } // namespace



  Block
  SumOperator::multiply(const Block &X) const
  {
    std::vector<Term> terms;
    for (const auto &[factor, part] : parts)
      terms.emplace_back(factor, part.get());
    return sum_of_products(terms, X);
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
