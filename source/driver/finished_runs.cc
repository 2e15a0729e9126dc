// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/base/files.h>
#include <squeal/driver/finished_runs.h>

#include <fstream>

namespace squeal
{
  namespace
  {
    using Json = nlohmann::ordered_json;

    Cell
    to_cell(const Json &value)
    {
      if (value.is_string())
        return value.get<std::string>();
      if (value.is_number_integer())
        return value.get<long long>();
      return value.is_number() ? Cell(value.get<double>()) : Cell();
    }



    Json
    to_json(const Cell &cell)
    {
      if (const auto *real = std::get_if<double>(&cell.value))
        return *real;
      if (const auto *whole = std::get_if<long long>(&cell.value))
        return *whole;
      if (const auto *text = std::get_if<std::string>(&cell.value))
        return *text;
      return nullptr;
    }



    /** The values of a row; of those without a version too. */
    const Json &
    values_of(const Json &row)
    {
      return row.is_object() ? row.at("row") : row;
    }
  } // namespace



  FinishedRuns::FinishedRuns(const std::string &path,
                             const std::string &program,
                             const bool         resume)
    : path(path)
    , program(program)
  {
    std::ifstream in(path);
    if (!in || !resume)
      return;
    try
      {
        rows = Json::parse(in);
        for (const auto &row : rows)
          if (!values_of(row).is_array())
            throw std::runtime_error("no row");
      }
    catch (const std::exception &)
      {
        throw InputError("'" + path +
                         "' cannot be read: remove it or set "
                         "Transient/Resume = false");
      }
  }



  bool
  FinishedRuns::find(const std::string &key,
                     const std::size_t  n_columns,
                     std::vector<Cell> &row) const
  {
    const auto found = rows.find(key);
    if (found == rows.end() ||
        (n_columns > 0 && values_of(*found).size() != n_columns))
      return false;
    row.clear();
    for (const auto &value : values_of(*found))
      row.push_back(to_cell(value));
    return true;
  }



  std::string
  FinishedRuns::program_of(const std::string &key) const
  {
    const auto found = rows.find(key);
    if (found == rows.end())
      return "";
    return found->is_object() ? found->value("program", "unknown") : "unknown";
  }



  void
  FinishedRuns::add(const std::string &key, const std::vector<Cell> &row)
  {
    Json values = Json::array();
    for (const Cell &cell : row)
      values.push_back(to_json(cell));
    rows[key] = {{"program", program}, {"row", values}};
    write_atomically(path, [&](std::ostream &out) { out << rows.dump(1); });
  }
} // namespace squeal
