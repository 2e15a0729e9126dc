// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_discretization_patterned_matrix_h
#define squeal_discretization_patterned_matrix_h

#include <squeal/base/sparse_matrix.h>
#include <squeal/discretization/discretization.h>
#include <squeal/discretization/element_matrices.h>

#include <Eigen/Core>

#include <memory>
#include <vector>

namespace squeal
{
  /**
   * Local rows of one cell: the free unknowns that its degrees of freedom
   * expand to, ascending, and the matrix T of the expansion (empty when
   * every degree of freedom is one unknown or held).
   */
  struct CellRows
  {
    std::vector<int> rows;
    std::vector<int> component; /**< 0..2 of each row, -1 if mixed */
    std::vector<int> source;    /**< degree of freedom of each row, if simple */
    Eigen::MatrixXd  T;         /**< dofs x rows, if not simple */
    bool             simple = true;
  };

  CellRows cell_rows(const Discretization               &d,
                     const Discretization::CellIterator &cell,
                     const ElementMatrices              &element);

  /** One sparse matrix in the making: the pattern from all cells, then the
   * values, added by walking the sorted rows. */
  class PatternedMatrix
  {
  public:
    PatternedMatrix(const std::shared_ptr<const RowSpace> &space,
                    const std::vector<CellRows>           &cells,
                    const bool                             same_component_only);

    void add(const CellRows &cell, const Eigen::MatrixXd &element);

    /** Element matrices that change sign when transposed are read from the
     * other triangle (columns are contiguous in memory). */
    double transpose_sign = 1.;

    std::shared_ptr<const SparseMatrix> finish();

  private:
    bool couple(const int a, const int b) const;

    std::shared_ptr<const RowSpace> row_space;
    bool                            same_component;
    std::vector<std::size_t>        starts;
    std::vector<int>                columns;
    std::vector<double>             values;
  };
} // namespace squeal

#endif
