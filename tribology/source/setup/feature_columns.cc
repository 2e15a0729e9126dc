// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/parameters/numbers.h>
#include <squeal/parameters/text.h>
#include <squeal/tribology/setup/feature_columns.h>

#include <algorithm>
#include <cmath>

namespace squeal::tribology
{
  namespace
  {
    /** Columns of places and names, which are no features. */
    bool
    is_place(const std::string &name)
    {
      for (const char *other : {"node",
                                "cell",
                                "x_m",
                                "y_m",
                                "area_m2",
                                "sliding_x",
                                "sliding_y",
                                "coverage",
                                "image",
                                "images",
                                "pad",
                                "synthetic"})
        if (name == other)
          return true;
      return false;
    }



    bool
    is_named(const std::vector<std::string> &names, const std::string &name)
    {
      return std::find(names.begin(), names.end(), name) != names.end();
    }



    /** Whether a text is a number, or would be one but for a decimal comma. */
    bool
    is_meant_as_number(std::string text)
    {
      if (const std::size_t comma = text.find(','); comma != std::string::npos)
        text[comma] = '.';
      return prm::parse_number(text).has_value();
    }



    /** An angle of lines jumps from 90 to -90 degrees: it has no mean and no
     * correlation as a number. */
    constexpr const char *angle_of_lines = "crack_angle_deg";
  } // namespace



  bool
  is_mean_along_cracks(const std::string &column)
  {
    return column == "crack_width_m" || column == "crack_alignment" ||
           column == along_sliding_column;
  }



  std::vector<std::string>
  feature_columns(const Table &table, const CorrelationParameters &p)
  {
    if (is_named(p.features, angle_of_lines) ||
        is_named(p.covariates, angle_of_lines))
      throw InputError(std::string("'") + angle_of_lines +
                       "' jumps from 90 to -90 degrees where lines turn "
                       "across the sliding: take '" +
                       along_sliding_column + "'");
    if (!p.features.empty())
      return p.features;
    std::vector<std::string> names;
    for (const Table::Column &column : table.columns())
      if (column.type != Table::Type::text && !is_place(column.name) &&
          column.name != angle_of_lines && !is_named(p.covariates, column.name))
        names.push_back(column.name);
    return names;
  }



  void
  require_finite_numbers(const Table       &table,
                         const std::string &column,
                         const std::string &file)
  {
    const bool is_text =
      table.columns()[table.column_index(column)].type == Table::Type::text;
    for (std::size_t row = 0; row < table.n_rows(); ++row)
      if (!table.is_missing(row, column) &&
          (is_text ? !prm::parse_number(table.text(row, column))
                   : !std::isfinite(table.real(row, column))))
        throw InputError(file + ":" + std::to_string(row + 2) + ": column '" +
                         column +
                         "': " + prm::in_quotes(table.text(row, column)) +
                         " is not a finite number; leave the cell empty where "
                         "a value is missing");
  }



  std::vector<std::string>
  columns_of_texts(const Table                 &table,
                   const CorrelationParameters &p,
                   const std::string           &file)
  {
    std::vector<std::string> names;
    if (!p.features.empty())
      return names;
    for (const Table::Column &column : table.columns())
      {
        if (column.type != Table::Type::text || is_place(column.name) ||
            column.name == angle_of_lines ||
            is_named(p.covariates, column.name))
          continue;
        for (std::size_t row = 0; row < table.n_rows(); ++row)
          if (is_meant_as_number(table.text(row, column.name)))
            require_finite_numbers(table, column.name, file);
        names.push_back(column.name);
      }
    return names;
  }
} // namespace squeal::tribology
