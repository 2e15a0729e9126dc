// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_base_linear_operator_h
#define squeal_base_linear_operator_h

#include <squeal/base/row_space.h>

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

    /** Y += factor A X. */
    virtual void
    add_product(const double factor, const Block &X, Block &Y) const
    {
      Y += factor * multiply(X);
    }

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
} // namespace squeal

#endif
