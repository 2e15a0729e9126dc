// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/output/judged_force.h>

namespace squeal
{
  namespace
  {
    bool
    is_of_node(const std::string &judged)
    {
      return judged.rfind("normal force of node", 0) == 0;
    }
  } // namespace



  Table::Column
  judged_force_column(const std::string &name)
  {
    return {name,
            Table::Type::text,
            "",
            "where a moment of the normal forces or that of a node is judged: "
            "its name"};
  }

  Cell
  judged_force_cell(const std::string &moment)
  {
    return moment.empty() ? Cell() : Cell(moment);
  }

  std::string
  rms_label(const Table &table, const std::vector<std::string> &columns)
  {
    bool moments = false, nodes = false;
    for (const std::string &column : columns)
      for (std::size_t i = 0; i < table.n_rows(); ++i)
        if (const std::string name = table.text(i, column); !name.empty())
          (is_of_node(name) ? nodes : moments) = true;
    if (moments || nodes)
      return std::string("rms of the normal force or of the judged ") +
             (moments && nodes ? "moment or node"
              : moments        ? "moment"
                               : "node") +
             " in N";
    return "rms of the normal force in N";
  }
} // namespace squeal
