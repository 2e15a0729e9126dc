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
   * On a rectangular grid they must be at most 1.5 times the rectangle that
   * reaches half a cell beyond the outermost nodes, elsewhere at most three
   * times the convex hull with half a distance of neighbours about it. They may
   * be much smaller, as those of a thin ring, of pins or of parts between slots
   * are: down to 1e-5 of what lies between the nodes. Nodes that lie on a line
   * tell nothing. The walls that the hull would have over the height of a
   * curved face count as span.
   */
  void require_areas_of_face(const HistoryLayout &layout,
                             const std::string   &path);

  /** A warning of a face that is longer (m) than those of brakes, as one with
   * all lengths in mm is, which require_areas_of_face() cannot tell; empty
   * where there is none. Begins with @p path. Throws nothing. */
  std::string doubt_of_length(const HistoryLayout &layout,
                              const std::string   &path);
} // namespace squeal::tribology

#endif
