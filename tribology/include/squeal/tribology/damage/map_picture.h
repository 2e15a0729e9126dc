// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_damage_map_picture_h
#define squeal_tribology_damage_map_picture_h

#include <squeal/results/plotter.h>
#include <squeal/tribology/history/contact_grid.h>

#include <string>
#include <vector>

namespace squeal::tribology
{
  /** A value for each cell of the face. */
  struct FaceMap
  {
    std::string         title;
    std::string         label;  /**< of the colour scale, with the unit */
    std::vector<double> values; /**< one a node; NaN is left grey */
    bool                logarithmic = false;
    bool                diverging   = false; /**< about 0 */
  };

  /** Draws maps side by side, seen from the disc: x to the right, y (sliding
   * direction) up, the leading edge below. */
  Drawing draw_maps(const ContactGrid &grid, const std::vector<FaceMap> &maps);

  /** Draws a range-mean matrix with the logarithm of the cycles as colour. */
  Drawing draw_matrix(const std::vector<double> &ranges,
                      const std::vector<double> &means,
                      const std::vector<double> &counts,
                      const std::string         &title);
} // namespace squeal::tribology

#endif
