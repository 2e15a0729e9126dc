// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/tribology/setup/feature_columns.h>

#include <algorithm>

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
} // namespace squeal::tribology
