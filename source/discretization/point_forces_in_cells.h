// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_source_discretization_point_forces_in_cells_h
#define squeal_source_discretization_point_forces_in_cells_h

#include "eigenvalue_error_cell.h"

#include <squeal/discretization/eigenvalue_error.h>

#include <vector>

namespace squeal
{
  /** The forces in each active cell that this rank knows. */
  struct ForcesInCells
  {
    std::vector<std::vector<CellErrorProblem::Force>> forces;
    std::vector<bool> pointwise; /**< cells too small to smooth them out */
  };

  /** Unit coordinates of a point of @p cell; false if it lies outside. */
  bool find_in_cell(const Discretization               &discretization,
                    const Discretization::CellIterator &cell,
                    const dealii::Point<3>             &point,
                    dealii::Point<3>                   &unit);

  /** A point on common faces acts on all their cells in equal parts. */
  ForcesInCells forces_in_cells(const Discretization           &discretization,
                                const std::vector<PointForces> &forces);
} // namespace squeal

#endif
