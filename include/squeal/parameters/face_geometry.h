// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_parameters_face_geometry_h
#define squeal_parameters_face_geometry_h

#include <squeal/parameters/scene_parameters.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace squeal
{
  namespace prm
  {
    /** Names of the faces of a shape, in the order of their numbers in the
     * mesh; none for rigid bodies and those of mesh
     * files, which hold the names. */
    std::vector<std::string> faces_of(BodyParameters::Shape shape);

    /** Whether the 'Rotation centre' of an annulus or a cylinder is on its own
     * axis, along z through its 'Position'. */
    bool turns_about_own_axis(const BodyParameters &round);

    /** The box around a body; nothing for rigid ones, those of mesh files, and
     * those that their 'Angle' has moved. m */
    struct Box
    {
      Vector3 lower, upper;

      /** The longest edge. */
      double size() const;
    };
    std::optional<Box> box_of(const BodyParameters &body);

    /**
     * A flat face of an annulus, block or cylinder: a rectangle or a ring in
     * the plane normal to one axis. m
     */
    struct FlatFace
    {
      unsigned int          axis;     /**< 0, 1, 2: the normal is +-x, y, z */
      int                   sign;     /**< +1: the outward normal is +axis */
      double                position; /**< of the plane along the axis */
      std::array<double, 2> lower, upper; /**< box in the other two axes */
      bool                  is_round;     /**< ring (or disc), else rectangle */
      std::array<double, 2> centre;
      double                inner_radius, outer_radius; /**< of a ring */
      double                body_size; /**< longest edge of the body's box */
    };

    /** The face of this name, or nothing if it is curved or the body has
     * no box_of(). */
    std::optional<FlatFace> flat_face(const BodyParameters &body,
                                      const std::string    &face);

    /** Why two faces cannot touch: other planes, not facing each other, or side
     * by side; empty if they can. Lengths are compared to 1e-6 of the
     * larger body. */
    std::string fault_of_touching(const FlatFace &source,
                                  const FlatFace &target);

    /** Why @p source, which touches @p target, reaches beyond its edge; empty
     * if it does not. */
    std::string fault_of_footprint(const FlatFace &source,
                                   const FlatFace &target);
  } // namespace prm
} // namespace squeal

#endif
