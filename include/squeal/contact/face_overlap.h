// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_contact_face_overlap_h
#define squeal_contact_face_overlap_h

#include <squeal/contact/surface_face.h>

#include <vector>

namespace squeal
{
  /** A point for integrals over the segment that two faces share. */
  struct OverlapPoint
  {
    dealii::Point<2> source, target; /**< unit coordinates */
    double           weight;         /**< of the source face's unit square */
  };

  /**
   * The segment that a source and a target face share, seen along the normal of
   * the source face's centre. The outline of the target face is projected to
   * the source face and clipped in its unit coordinates, where every source
   * face, curved or not, is a square; the target's edges stay curves there
   * unless they are straight. All weights of a source face that is covered add
   * up to 1. Empty where the faces do not meet: they must face each other and
   * be no further apart than 1e-4 of the larger one, or than curved faces
   * bulge, or than @p reach of the larger one.
   */
  std::vector<OverlapPoint> face_overlap(const SurfaceFace &source,
                                         const SurfaceFace &target,
                                         const unsigned int degree,
                                         const double       reach = 0.);

  /** The same for the whole source face; the target coordinates mean nothing.
   */
  std::vector<OverlapPoint> whole_face(const SurfaceFace &source,
                                       const unsigned int degree);

  /** Distance beyond which face_overlap() does not look. m */
  double allowed_distance(const SurfaceFace &source, const SurfaceFace &target);
} // namespace squeal

#endif
