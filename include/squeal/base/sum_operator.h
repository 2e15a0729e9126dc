// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_base_sum_operator_h
#define squeal_base_sum_operator_h

#include <squeal/base/linear_operator.h>

#include <memory>
#include <utility>

namespace squeal
{
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
