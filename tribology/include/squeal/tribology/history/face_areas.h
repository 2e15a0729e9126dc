// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_history_face_areas_h
#define squeal_tribology_history_face_areas_h

#include <squeal/results/contact_history.h>

#include <string>

namespace squeal::tribology
{
  /**
   * Throws InputError, one line that begins with @p path and names both
   * numbers, where the tributary areas (m^2) of a face do not add up to about
   * what its nodes (m) span, as of lengths in mm beside areas in m^2.
   *
   * On a rectangular grid they must lie between the rectangle that ends at the
   * outermost nodes and the one that reaches half a cell beyond, to a factor of
   * 1.5. Elsewhere they must be at most three times the convex hull with half a
   * distance of neighbours about it; they may be much smaller, as those of a
   * thin ring or of pins are. Nodes that lie on a line tell nothing. The walls
   * that the hull would have over the height of a curved face count as span.
   */
  void require_areas_of_face(const HistoryLayout &layout,
                             const std::string   &path);
} // namespace squeal::tribology

#endif
