// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_damage_range_mean_picture_h
#define squeal_tribology_damage_range_mean_picture_h

#include <squeal/results/plotter.h>

#include <string>
#include <vector>

namespace squeal::tribology
{
  /** Draws a range-mean matrix with the logarithm of the cycles as colour. */
  Drawing draw_matrix(const std::vector<double> &ranges,
                      const std::vector<double> &means,
                      const std::vector<double> &counts,
                      const std::string         &title);
} // namespace squeal::tribology

#endif
