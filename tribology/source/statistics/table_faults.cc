// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/base/inputs_read.h>
#include <squeal/base/number_text.h>
#include <squeal/tribology/statistics/table_faults.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace squeal::tribology
{
  namespace
  {
    /** Whether both rows tell a number of @p column, and not the same. */
    bool
    disagree(const Table       &table,
             const std::string &column,
             const std::size_t  a,
             const std::size_t  b)
    {
      return !table.is_missing(a, column) && !table.is_missing(b, column) &&
             table.real(a, column) != table.real(b, column);
    }
  } // namespace



  Table
  read_whole_csv(const std::string                &path,
                 const std::vector<Table::Column> &required)
  {
    Table             table   = read_csv(path, required);
    const std::string content = read_input_file(path);
    if (content.back() != '\n')
      throw InputError(
        path + ":" +
        std::to_string(1 + std::count(content.begin(), content.end(), '\n')) +
        ": the line does not end: the file may have been cut; if it is whole, "
        "add a newline");
    return table;
  }



  void
  require_possible_features(const Table &table, const std::string &file)
  {
    constexpr const char *density = "crack_density_per_m";
    if (table.n_rows() == 0)
      throw InputError("'" + file + "' has no rows below its header");
    if (!table.has_column(density))
      return;
    for (std::size_t row = 0; row < table.n_rows(); ++row)
      if (!table.is_missing(row, density) && table.real(row, density) < 0.)
        throw InputError(file + ":" + std::to_string(row + 2) + ": " + density +
                         " is " + shortest_text(table.real(row, density)) +
                         ": a length over an area is not negative");
  }



  std::string
  rows_that_disagree(const Table                    &table,
                     const std::vector<std::size_t> &rows,
                     const std::vector<std::string> &columns)
  {
    std::map<std::array<double, 2>, std::size_t> firsts;
    std::string                                  text;
    std::size_t                                  n = 0;
    for (const std::size_t row : rows)
      {
        const auto [place, is_first] = firsts.insert(
          {{{table.real(row, "x_m"), table.real(row, "y_m")}}, row});
        const std::size_t other = place->second;
        if (is_first ||
            std::none_of(columns.begin(), columns.end(), [&](const auto &name) {
              return disagree(table, name, other, row);
            }))
          continue;
        if (++n == 1)
          text = "such as lines " + std::to_string(other + 2) + " and " +
                 std::to_string(row + 2);
      }
    return n == 0 ? ""
                  : std::to_string(n) + (n == 1 ? " row, " : " rows, ") + text;
  }
} // namespace squeal::tribology
