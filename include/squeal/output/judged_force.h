// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_output_judged_force_h
#define squeal_output_judged_force_h

#include <squeal/results/table.h>

#include <string>
#include <vector>

namespace squeal
{
  /** The declaration of the column @p name, which says what rms, lines and
   * repetition of a row are of: the moment of the normal forces that is judged,
   * or that of a node, or nothing where that is their sum. */
  Table::Column judged_force_column(const std::string &name);

  /** What stands in it; @p moment: its name, empty where there is none. */
  Cell judged_force_cell(const std::string &moment);

  /** "rms of the normal force in N", with the moments and the nodes where @p columns
   * of @p table name some. */
  std::string rms_label(const Table                    &table,
                        const std::vector<std::string> &columns);
} // namespace squeal

#endif
