// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_discretization_point_evaluator_h
#define squeal_discretization_point_evaluator_h

#include <squeal/base/low_rank_matrix.h>
#include <squeal/discretization/discretization.h>

#include <array>
#include <vector>

namespace squeal
{
  /**
   * Displacements at points of bodies as linear functionals of the free
   * unknowns: u_c(x) = sum_a phi_a(x) u_a in a meshed body, and
   * u(x) = u_0 + r x (x - x_0) in a rigid one.
   */
  class PointEvaluator
  {
  public:
    explicit PointEvaluator(const Discretization &discretization);

    /**
     * Three functional rows (x, y, z) for each of @p points of a body, the
     * same on every rank. A point may lie outside the body by @p tolerance of
     * a cell's size (curved boundaries). Points that no cell holds give
     * `found = false`.
     */
    struct Result
    {
      std::vector<std::array<Functionals::Row, 3>> rows;
      std::vector<bool>                            found;
    };
    Result displacements(const unsigned int                   body,
                         const std::vector<dealii::Point<3>> &points,
                         const double tolerance = 1e-6) const;

  private:
    struct CellBox
    {
      Discretization::CellIterator cell;
      std::array<double, 3>        lower, upper;
    };

    bool evaluate_in(const CellBox                   &box,
                     const dealii::Point<3>          &point,
                     const double                     tolerance,
                     std::array<Functionals::Row, 3> &rows) const;

    Result rigid(const unsigned int                   body,
                 const std::vector<dealii::Point<3>> &points) const;

    const Discretization             &discretization;
    std::vector<std::vector<CellBox>> boxes; /**< owned cells of each body */
  };

  /** a x + b y + ... of functional rows; equal columns are merged. */
  Functionals::Row combine(
    const std::vector<std::pair<double, const Functionals::Row *>> &parts);
} // namespace squeal

#endif
