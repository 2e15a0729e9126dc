// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_base_symmetric_block_matrix_h
#define squeal_base_symmetric_block_matrix_h

#include <squeal/base/linear_operator.h>

#include <vector>

namespace squeal
{
  /**
   * A symmetric sparse matrix of one rank for many products with one vector:
   * its lower triangle in blocks of up to three rows and columns, the unknowns
   * of a vertex. A block is read once for its rows and its columns; 8.4 bytes
   * an entry where the blocks are full.
   */
  class SymmetricBlockMatrix
  {
  public:
    /** @p lower entries of the lower triangle of @p n rows, in any order;
     * those of one place add up. */
    SymmetricBlockMatrix(const Triplets &lower, const Eigen::Index n);

    /** y = A x. @p x and @p y are two vectors of n_rows() values. Keeps its
     * buffers: not for two threads at a time. */
    void multiply(const Eigen::VectorXd &x, Eigen::VectorXd &y);

    Eigen::Index n_rows() const;
    /** Bytes of values and indices that a product reads. */
    std::size_t n_bytes() const;

  private:
    /** Places that a block, and a group of a vector, takes. */
    static constexpr int width = 3, padded = 4;

    Eigen::Index             n;
    std::vector<int>         group_starts; /**< first unknown of each group */
    std::vector<std::size_t> row_starts;   /**< first block of each group */
    std::vector<int>         columns;      /**< group of each block's columns */
    std::vector<double>      values;       /**< blocks left of the diagonal */
    std::vector<double>      diagonal;     /**< whole blocks */
    std::vector<double>      x_padded, y_padded;
  };
} // namespace squeal

#endif
