// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_damage_damage_files_h
#define squeal_tribology_damage_damage_files_h

#include <squeal/results/table.h>
#include <squeal/tribology/damage/history_damage.h>

#include <string>

namespace squeal::tribology
{
  /** Writes every real column of @p table as a dataset "nodes/<column>" and the
   * range-mean matrices with the middles of their classes. */
  void write_damage_hdf5(const std::string   &path,
                         const Table         &table,
                         const HistoryDamage &damage);

  /** Writes the real columns of @p table as point data of the face: cells
   * between the nodes of a grid, else single points. */
  void write_damage_vtu(const std::string &path,
                        const Table       &table,
                        const ContactGrid &grid);
} // namespace squeal::tribology

#endif
