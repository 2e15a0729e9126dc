// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_model_point_remarks_h
#define squeal_model_point_remarks_h

#include <squeal/model/model.h>

#include <string>
#include <vector>

namespace squeal
{
  /**
   * Lumped masses and point springs that act at single points of meshed bodies,
   * a line each. The displacement under a point force has no limit as the mesh
   * is refined, and neither have the frequencies; no estimate of the mesh error
   * tells that.
   *
   * Left out are points closer together than the cells, which act along a line,
   * and forces too small to deform a cell: stiffness, or mass times the squared
   * upper edge of the band, below 1e-4 of Young's modulus times the mean edge
   * of a cell. Collective.
   */
  std::vector<std::string> remarks_on_points(const Model &model);
} // namespace squeal

#endif
