// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_results_shape_plot_h
#define squeal_results_shape_plot_h

#include <squeal/results/plotter.h>
#include <squeal/results/shape_picture.h>

#include <string>

namespace squeal
{
  /**
   * Draws two panels: the deformed scene, lit and seen obliquely, with the
   * edges of the undeformed one where they stick out and the names of the
   * bodies, and the
   * disc's contact face seen from +z with the nodal lines in black and the
   * outline of the contact dashed. Both are coloured by the values over the
   * largest of the face (of the surface if there is no face), blue to red.
   * Without face quads the first panel is alone. Writes
   * @p path.png and returns whether it is there.
   */
  bool plot_shape(const Plotter      &plotter,
                  const ShapePicture &picture,
                  const std::string  &path);
} // namespace squeal

#endif
