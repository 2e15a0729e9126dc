// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_subsurface_half_space_h
#define squeal_tribology_subsurface_half_space_h

#include <Eigen/Core>

namespace squeal::tribology
{
  /** A rectangle of the face z = 0. */
  struct Patch
  {
    double x_min, x_max, y_min, y_max; /**< m */
  };

  /** Stress (xx, yy, zz, xy, yz, xz) for tractions (x, y, pressure). */
  using PatchInfluence = Eigen::Matrix<double, 6, 3>;

  /**
   * Stress at (x, y, z) in the elastic half-space z > 0 that uniform tractions
   * on a rectangle of its face cause: tangential ones along +x and +y, and a
   * pressure (which pushes along +z). Boussinesq and Cerruti's potentials,
   * integrated in closed form (Love 1929 for the pressure); z > 0.
   *
   * In the pad's frame (design: z into the pad, sliding along +y) these are the
   * tractions of the history.
   */
  PatchInfluence patch_influence(const Patch &patch,
                                 double       x,
                                 double       y,
                                 double       z,
                                 double       poisson_ratio);

  /**
   * Displacement (x, y, z) times shear modulus at the same place for the same
   * tractions. Point forces at 4 x 4 Gauss points of the patch: for places that
   * are farther away than its size.
   */
  Eigen::Matrix3d patch_displacement(const Patch &patch,
                                     double       x,
                                     double       y,
                                     double       z,
                                     double       poisson_ratio);

  /** In-plane stress (xx, zz, xz) for tractions (x, pressure). */
  using StripInfluence = Eigen::Matrix<double, 3, 2>;

  /** The same in plane strain for an endless strip x_min < x < x_max. */
  StripInfluence strip_influence(double x_min,
                                 double x_max,
                                 double x,
                                 double z);

  /** Whether the half-space fails at this depth: an edge of the face is nearer
   * than three depths. @p distance: to the nearest edge. */
  bool is_near_edge(double distance, double depth);
} // namespace squeal::tribology

#endif
