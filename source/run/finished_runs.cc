// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/checksum.h>
#include <squeal/base/exceptions.h>
#include <squeal/base/files.h>
#include <squeal/base/state_files.h>
#include <squeal/run/finished_runs.h>

#include <algorithm>
#include <cmath>

namespace squeal
{
  namespace
  {
    using Json = nlohmann::ordered_json;

    constexpr int list_version = 2;

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



    bool
    is_finite(const Cell &cell)
    {
      const auto *real = std::get_if<double>(&cell.value);
      return !real || std::isfinite(*real);
    }



    /** Of all that a row holds but its checksum. */
    std::string
    checksum_of_row(Json row)
    {
      row.erase("checksum");
      return checksum_of(row.dump());
    }



    bool
    is_whole(const Json &row)
    {
      const auto is_value = [](const Json &value) {
        return value.is_string() || value.is_number() || value.is_null();
      };
      return row.is_object() && row.size() == 4 && row.at("name").is_string() &&
             row.at("fingerprint").is_string() && row.at("values").is_array() &&
             std::all_of(
               row.at("values").begin(), row.at("values").end(), is_value) &&
             row.at("checksum").get<std::string>() == checksum_of_row(row);
    }



    /** The rows of a file; throws what says that it is damaged. */
    std::vector<Json>
    parse(const std::string &text)
    {
      const Json all = Json::parse(text);
      if (all.size() != 3 || all.at("version").get<int>() != list_version)
        throw std::runtime_error("another version");
      std::vector<Json> rows;
      for (const Json &row : all.at("rows"))
        {
          if (!is_whole(row))
            throw std::runtime_error("a row that is damaged");
          rows.push_back(row);
        }
      return rows;
    }
  } // namespace



  FinishedRuns::FinishedRuns(const std::string &path,
                             const std::string &content)
    : path(path)
  {
    if (content.empty())
      return;
    try
      {
        rows = parse(content);
      }
    catch (const std::exception &)
      {
        throw InputError("'" + path +
                         "' is damaged or of another version of squeal: move "
                         "it away or set Transient/Resume = false");
      }
  }



  bool
  FinishedRuns::find(const Fingerprint &fingerprint,
                     const std::string &name,
                     const std::size_t  n_columns,
                     std::vector<Cell> &row) const
  {
    const std::string text = fingerprint.text();
    for (const Json &known : rows)
      if (known.at("name") == name && known.at("fingerprint") == text &&
          (n_columns == 0 || known.at("values").size() == n_columns))
        {
          row.clear();
          for (const Json &value : known.at("values"))
            row.push_back(to_cell(value));
          return true;
        }
    return false;
  }



  void
  FinishedRuns::add(const Fingerprint       &fingerprint,
                    const std::string       &name,
                    const std::vector<Cell> &row)
  {
    if (!std::all_of(row.begin(), row.end(), is_finite))
      return;
    Json values = Json::array();
    for (const Cell &cell : row)
      values.push_back(to_json(cell));
    Json entry = {
      {"name", name}, {"fingerprint", fingerprint.text()}, {"values", values}};
    entry["checksum"] = checksum_of_row(entry);
    rows.erase(std::remove_if(rows.begin(),
                              rows.end(),
                              [&](const Json &known) {
                                return known.at("name") == name &&
                                       known.at("fingerprint") ==
                                         entry.at("fingerprint");
                              }),
               rows.end());
    rows.push_back(entry);
    const Json all = {{"format", std::string("squeal ") + state_kind::rows},
                      {"version", list_version},
                      {"rows", rows}};
    write_atomically(path, [&](std::ostream &out) { out << all.dump(1); });
  }



  std::size_t
  FinishedRuns::n_rows() const
  {
    return rows.size();
  }

  std::string
  FinishedRuns::nearest_difference(const Fingerprint &fingerprint) const
  {
    std::string difference;
    std::size_t fewest = 0;
    for (const Json &row : rows)
      {
        const auto        text = row.at("fingerprint").get<std::string>();
        const std::size_t n    = fingerprint.n_differences(text);
        if (difference.empty() || n < fewest)
          {
            difference = fingerprint.difference(text);
            fewest     = n;
          }
      }
    return difference;
  }
} // namespace squeal
