// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_discretization_face_quadrature_h
#define squeal_discretization_face_quadrature_h

#include <squeal/discretization/discretization.h>

#include <vector>

namespace squeal
{
  /** Gauss points of a face of the scene with their areas, the same on every
   * rank, in the order of the cells. */
  struct FaceQuadrature
  {
    std::vector<dealii::Point<3>> points;
    std::vector<double>           areas; /**< m^2 */
    /** Outward unit normals of the body. */
    std::vector<dealii::Tensor<1, 3>> normals;

    double           total_area() const;
    dealii::Point<3> centre() const;
    /** Unit vector along the mean of the normals. */
    dealii::Tensor<1, 3> normal() const;
  };

  /** @p n_points Gauss points in each direction; 0: degree + 1. */
  FaceQuadrature face_quadrature(const Discretization &discretization,
                                 const unsigned int    face_id,
                                 const unsigned int    n_points = 0);

  /** Joins the pieces of all ranks, in rank order. */
  std::vector<double> all_gather(const std::vector<double> &mine,
                                 const MPI_Comm             communicator);
} // namespace squeal

#endif
