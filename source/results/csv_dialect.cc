// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/results/csv_dialect.h>

#include <algorithm>
#include <cctype>

namespace squeal
{
  namespace
  {
    /** Whether a text is digits with signs, decimal marks and an exponent. */
    bool
    looks_like_number(const std::string &text)
    {
      bool has_digit = false;
      for (const char c : text)
        {
          const bool is_digit = std::isdigit(static_cast<unsigned char>(c));
          if (!is_digit && std::string("+-.,eE").find(c) == std::string::npos)
            return false;
          has_digit = has_digit || is_digit;
        }
      return has_digit;
    }
  } // namespace



  CsvDialect::CsvDialect(const std::string &header)
  {
    bool        inside     = false;
    std::size_t semicolons = 0, tabs = 0;
    for (const char c : header)
      {
        if (c == '"')
          inside = !inside;
        if (inside)
          continue;
        if (c == ',')
          return;
        semicolons += c == ';';
        tabs += c == '\t';
      }
    if (semicolons > 0)
      mark = ';';
    else if (tabs > 0)
      mark = '\t';
  }



  std::string
  CsvDialect::number(const std::string &cell, const std::string &place)
  {
    if (mark == ',' || !looks_like_number(cell))
      return cell;
    const auto        n_commas = std::count(cell.begin(), cell.end(), ',');
    const std::size_t at       = cell.find(',');
    has_commas                 = has_commas || n_commas > 0;
    has_points = has_points || cell.find('.') != std::string::npos;
    if (has_commas && has_points)
      throw InputError(place + ": '" + cell +
                       "': decimal commas and decimal points in one table: "
                       "write all numbers with one of them");
    if (n_commas != 1)
      return cell;
    return cell.substr(0, at) + '.' + cell.substr(at + 1);
  }



  std::string
  CsvDialect::hint(const std::size_t n_cells, const std::size_t n_columns) const
  {
    return mark == ',' && n_cells > n_columns
             ? "; if its numbers have decimal commas, put semicolons between "
               "the "
               "cells"
             : "";
  }



  std::string
  without_byte_order_mark(const std::string &text, const std::string &path)
  {
    if (text.compare(0, 2, "\xFF\xFE") == 0 ||
        text.compare(0, 2, "\xFE\xFF") == 0)
      throw InputError("'" + path + "' is UTF-16 text: save it as UTF-8");
    return text.compare(0, 3, "\xEF\xBB\xBF") == 0 ? text.substr(3) : text;
  }
} // namespace squeal
