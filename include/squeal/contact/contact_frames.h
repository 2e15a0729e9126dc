// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_contact_contact_frames_h
#define squeal_contact_contact_frames_h

#include <squeal/discretization/discretization.h>

#include <vector>

namespace squeal
{
  /**
   * The directions of a contact point, unit vectors that are orthogonal: n, the
   * outward normal of the target face; t, that of the sliding velocity V of the
   * target against the source; s = t x n across it. Above a disc that turns
   * about +z, at (r, 0): n = +z, t = +y, s = +x.
   */
  struct ContactFrame
  {
    dealii::Tensor<1, 3> normal, sliding, transverse;
  };

  /** Frames of all points of a pair. */
  struct ContactFrames
  {
    std::vector<ContactFrame> frames;
    /** |V| at the point over the mean of |V| over the points. */
    std::vector<double> speed_ratio;
  };

  /**
   * Frames of the @p points of @p contact. Where the target is meshed the
   * normal is that of its face where the line through the point along
   * @p source_normals (outward unit normals of the source) meets it, on edges
   * of its cells the mean of theirs, which rounding cannot change; of a rigid
   * target, or the ground, it is opposite to that of the source. V is
   * Omega x r about the axis of the target, or the same direction everywhere,
   * as the pair's friction direction says. Directions that differ from a
   * coordinate axis by rounding are that axis. The same on every rank.
   *
   * Throws InputError that names the contact where the line does not meet the
   * named target face, where the target face is further from a point, to either
   * side, than allowed_distance() of mortar faces, where the faces do not look
   * at each other, where V is not along the face, and where a point lies on the
   * axis.
   */
  ContactFrames contact_frames(
    const Discretization                    &discretization,
    const ContactParameters                 &contact,
    const std::vector<dealii::Point<3>>     &points,
    const std::vector<dealii::Tensor<1, 3>> &source_normals);
} // namespace squeal

#endif
