// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_discretization_face_tractions_h
#define squeal_discretization_face_tractions_h

#include <squeal/discretization/discretization.h>

#include <vector>

namespace squeal
{
  /** Tractions of the stresses in a meshed body. */
  struct FaceTractions
  {
    /** (3 n_points) x n_modes, Pa: x, y, z at the first point, then at the
     * second; zero where no cell holds the point. The same on every rank. */
    Eigen::MatrixXd   values;
    std::vector<bool> found;
  };

  /**
   * sigma n of the elastic stresses of @p body at @p points, the same on every
   * rank, for the normals there; the mean of the cells that share a point.
   *
   * @param modes displacements, m, in the owned rows of the discretisation
   */
  FaceTractions face_tractions(
    const Discretization                    &d,
    const Block                             &modes,
    const unsigned int                       body,
    const std::vector<dealii::Point<3>>     &points,
    const std::vector<dealii::Tensor<1, 3>> &normals);
} // namespace squeal

#endif
