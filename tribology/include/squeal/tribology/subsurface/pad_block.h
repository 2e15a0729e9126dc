// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_subsurface_pad_block_h
#define squeal_tribology_subsurface_pad_block_h

#include <squeal/tribology/subsurface/half_space.h>

#include <Eigen/Core>

#include <array>
#include <vector>

namespace squeal::tribology
{
  /** A pad as an elastic block: loaded at its face z = 0, free at its sides,
   * held at its back z = thickness. Lengths in m. */
  struct PadBlock
  {
    Patch  face;
    double thickness;
    double poisson_ratio;
    double finest_cell;   /**< of the mesh, at the rim of the face */
    double coarsest_cell; /**< of the mesh, inside and at the back */
  };

  /** x, y and depth in m. */
  using BlockPoint = std::array<double, 3>;

  /**
   * What is missing from half-space stresses in a block, by finite elements.
   *
   * The half-space has the right tractions at the face, but stresses at the
   * sides and displacements at the back. A second field without load at the
   * face takes these away: tractions -s n at the sides, displacements -u at
   * the back. It is smooth wherever sides are far, so that the singular part
   * of the stress under the face stays that of the kernels, and a coarse mesh
   * will do. Along the rim of the face it varies over the distance to the rim;
   * nearer than one cell it is not resolved.
   *
   * Six rows for each point, three columns (unit traction x, y, pressure) for
   * each patch, in the order of PatchInfluence. Needs MPI to be initialised.
   */
  Eigen::MatrixXd block_correction(const PadBlock                &block,
                                   const std::vector<Patch>      &patches,
                                   const std::vector<BlockPoint> &points);
} // namespace squeal::tribology

#endif
