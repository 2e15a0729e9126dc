// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/output/judged_force.h>

namespace squeal
{
  Table::Column
  judged_force_column(const std::string &name)
  {
    return {name,
            Table::Type::text,
            "",
            "where a moment of the normal forces is judged: its name"};
  }

  Cell
  judged_force_cell(const std::string &moment)
  {
    return moment.empty() ? Cell() : Cell(moment);
  }

  std::string
  rms_label(const Table &table, const std::vector<std::string> &columns)
  {
    for (const std::string &column : columns)
      for (std::size_t i = 0; i < table.n_rows(); ++i)
        if (!table.text(i, column).empty())
          return "rms of the normal force or of the judged moment in N";
    return "rms of the normal force in N";
  }
} // namespace squeal
