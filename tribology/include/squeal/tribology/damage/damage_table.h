// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_damage_damage_table_h
#define squeal_tribology_damage_damage_table_h

#include <squeal/results/table.h>
#include <squeal/tribology/damage/subsurface.h>
#include <squeal/tribology/setup/tribology_parameters.h>

#include <string>
#include <vector>

namespace squeal::tribology
{
  /** "m3", "m4.5": names a slope in columns. */
  std::string slope_name(double exponent);

  /**
   * damage.csv: one row a node. The columns node, x_m, y_m, area_m2 come first
   * and are what tables of features are joined by. The columns sliding_x and
   * sliding_y, the same in all rows, are the unit direction in which the target
   * slides, 0 where it slides all round. @p silent may be nullptr;
   * with it columns silent_... and ratio_... are added.
   */
  Table damage_table(const TribologyParameters          &parameters,
                     const ContactGrid                  &grid,
                     const HistoryDamage                &squealing,
                     const HistoryDamage                *silent,
                     const std::vector<SubsurfacePoint> &subsurface);

  /** subsurface.csv: one row for each node and depth. */
  Table subsurface_table(const SubsurfaceParameters         &parameters,
                         const ContactGrid                  &grid,
                         const std::vector<SubsurfacePoint> &points);

  /** Columns of a damage table that are indices of damage. */
  std::vector<std::string> damage_indices(const Table &table);
} // namespace squeal::tribology

#endif
