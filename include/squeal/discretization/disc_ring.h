// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_discretization_disc_ring_h
#define squeal_discretization_disc_ring_h

#include <squeal/discretization/discretization.h>

#include <array>
#include <optional>
#include <vector>

namespace squeal
{
  /**
   * The flat ring of a disc that pads slide on, wherever the disc lies: what
   * nodal diameters and circles are counted on. m.
   */
  struct DiscRing
  {
    dealii::Point<3> centre; /**< on the axis */
    /** Right-handed unit vectors: two across the axis, which angles are
     * counted between, and the axis. For an axis along z those of x, y, z. */
    std::array<dealii::Tensor<1, 3>, 3> directions;
    double                              inner_radius = 0., outer_radius = 0.;
    /** Heights along the axis above the centre: of the contact face (the upper
     * one where pads press from both sides) and of the other side. */
    double face = 0., other_side = 0.;

    /** Angle of a point about the axis, rad. */
    double angle_of(const dealii::Point<3> &point) const;

    /** Distance of a point from the axis. */
    double radius_of(const dealii::Point<3> &point) const;

    dealii::Point<3>     point(const double radius,
                               const double angle,
                               const double height) const;
    dealii::Tensor<1, 3> radial(const double angle) const;
    dealii::Tensor<1, 3> tangential(const double angle) const;
  };

  /** Whether the face of an annulus that a contact pair of the scene uses is
   * its bottom; false also where no pair uses bottom or top. */
  bool contact_face_looks_down(const SceneParameters &scene,
                               const unsigned int     body);

  /**
   * The rings of all bodies, none for a body that is no disc. An annulus is
   * one; so is a body from a mesh file that is the target of a contact, the
   * face of which is flat and a whole circular ring, to within 5 % of its area
   * for what facets cut off. In a scene without a contact any named face
   * counts, the one that reaches out farthest.
   */
  std::vector<std::optional<DiscRing>> disc_rings(
    const Discretization &discretization);

  /** The disc that names refer to: that of the first contact pair that has one,
   * else the first one; -1u without one. */
  unsigned int main_disc(const SceneParameters                      &scene,
                         const std::vector<std::optional<DiscRing>> &rings);
} // namespace squeal

#endif
