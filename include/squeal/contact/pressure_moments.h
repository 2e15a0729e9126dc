// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_contact_pressure_moments_h
#define squeal_contact_pressure_moments_h

#include <squeal/contact/contact_geometry.h>

#include <Eigen/Dense>

#include <array>
#include <string>

namespace squeal
{
  /** Whether all points of the face look one way, but for rounded coordinates:
   * then the resultants along and across it are those of friction alone. */
  bool is_flat(const ContactGeometry &geometry);

  /**
   * Two sums of the nodes' normal forces that tell where a face carries, which
   * their plain sum does not: in a wobble that goes round the plain one is
   * steady. Weights have the mean 0 and the mean square 1 over the face, and
   * their product has the mean 0: so has every combination of both whose parts'
   * squares add up to 1, and what the combinations tell does not hang on the
   * axes of the scene.
   */
  struct PressureMoments
  {
    /** In N, 2 x three a node. Of a face that looks to a side: the moments
     * about the centre of the face, along the two axes of the scene that its
     * normal is farthest from, over the radii of gyration of the face. Of one
     * that looks to none, all round a shaft: the parts of the normal forces
     * along the two axes that the face looks along most, over the root of the
     * mean square of the normals there. Where the face is wider along a
     * direction between the axes, the two are the nearest to those whose
     * weights' product has the mean 0. A row is 0 where the face has no
     * width. */
    Eigen::MatrixXd rows;
    /** "moment of the normal forces about x" or "resultant of the normal forces
     * along x". */
    std::array<std::string, 2> names;
    /** Column k: the axis of row k, along the axes of both names, of any
     * length. */
    Eigen::Matrix2d axes = Eigen::Matrix2d::Identity();

    /** "moment of the normal forces about an axis 45 deg from x towards y": the
     * name of the combination of both rows with @p parts. */
    std::string name_of(const std::array<double, 2> &parts) const;
  };

  PressureMoments pressure_moments(const ContactGeometry &geometry);

  /** Vibration of a force, over the mean normal force, that is more than the
   * noise of the solver. */
  constexpr double least_vibration = 1e-4;

  /** A moment of the normal forces is judged where it vibrates by more than
   * this many times what their sum does: a pad that rocks has the lines of its
   * sum, which is of the size of its moments; a wobble that goes round cancels
   * in the sum, and what it leaves there has other lines. */
  constexpr double far_louder = 30.;
} // namespace squeal

#endif
