// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/base/files.h>
#include <squeal/base/run_log.h>
#include <squeal/results/table.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <ostream>
#include <stdexcept>

namespace squeal
{
  namespace
  {
    std::string
    names_of(const std::vector<Table::Column> &columns)
    {
      std::string names;
      for (const Table::Column &column : columns)
        names += (names.empty() ? "" : ", ") + column.name;
      return names;
    }

    std::string
    csv_text(const Cell &cell)
    {
      if (const double *real = std::get_if<double>(&cell.value))
        return shortest_text(*real);
      if (const long long *integer = std::get_if<long long>(&cell.value))
        return std::to_string(*integer);
      if (const std::string *text = std::get_if<std::string>(&cell.value))
        return *text;
      return "";
    }

    std::string
    quoted_if_needed(const std::string &text)
    {
      const bool has_edge_blank =
        !text.empty() && (text.front() == ' ' || text.back() == ' ');
      if (text.find_first_of(",\"\n\r") == std::string::npos && !has_edge_blank)
        return text;
      std::string result = "\"";
      for (const char c : text)
        result += c == '"' ? std::string("\"\"") : std::string(1, c);
      return result + '"';
    }

    /** Ends the run instead of writing a number that is none. */
    void
    require_finite(const Cell          &cell,
                   const Table::Column &column,
                   const std::size_t    row)
    {
      const double *real = std::get_if<double>(&cell.value);
      if (real == nullptr || std::isfinite(*real) ||
          (cell.may_be_infinite && !std::isnan(*real)))
        return;
      throw ComputationError(
        "the result '" + column.name + "' in row " + std::to_string(row + 1) +
        " is " + (std::isnan(*real) ? "not a number" : "infinite") +
        ": the numbers of the scene lead to no result here; look at the "
        "largest and the smallest of them");
    }

    /** @p cell as @p column holds it in @p row. */
    Cell
    fitted(const Cell &cell, const Table::Column &column, const std::size_t row)
    {
      if (cell.is_missing())
        return {};
      require_finite(cell, column, row);
      const bool is_real    = std::holds_alternative<double>(cell.value);
      const bool is_integer = std::holds_alternative<long long>(cell.value);
      const bool is_text    = !is_real && !is_integer;
      if (column.type == Table::Type::real && is_integer)
        return static_cast<double>(std::get<long long>(cell.value));
      if ((column.type == Table::Type::real && is_real) ||
          (column.type == Table::Type::integer && is_integer) ||
          (column.type == Table::Type::text && is_text))
        return cell;
      throw std::logic_error("the column '" + column.name + "' cannot hold '" +
                             csv_text(cell) + "'");
    }
  } // namespace



  Cell::Cell(const double number)
    : value(number)
  {
  }



  Cell::Cell(const std::string &text)
    : value(text)
  {
  }



  Cell::Cell(const char *text)
    : value(std::string(text))
  {
  }



  bool
  Cell::is_missing() const
  {
    return std::holds_alternative<std::monostate>(value);
  }



  Cell
  or_missing(const double value)
  {
    return std::isnan(value) ? Cell() : Cell(value);
  }

  Cell
  unbounded(const double value)
  {
    Cell cell(value);
    cell.may_be_infinite = true;
    return cell;
  }



  Table::Table(std::vector<Column> columns)
  {
    for (const Column &column : columns)
      add_column(column);
  }



  namespace
  {
    /** Columns of one name come from names that the user gave. */
    void
    require_new(const Table &table, const std::string &name)
    {
      if (table.has_column(name))
        throw InputError("two columns of a table would be called '" + name +
                         "': give the axis, body, pair or number of that "
                         "name another one");
    }
  } // namespace



  void
  Table::add_column(const Column &column)
  {
    require_new(*this, column.name);
    column_list.push_back(column);
    for (auto &row : rows)
      row.emplace_back();
  }



  void
  Table::add_row(std::vector<Cell> cells)
  {
    if (cells.size() != column_list.size())
      throw std::logic_error("a row of " + std::to_string(cells.size()) +
                             " cells under the columns " +
                             names_of(column_list));
    for (std::size_t c = 0; c < cells.size(); ++c)
      cells[c] = fitted(cells[c], column_list[c], rows.size());
    rows.push_back(std::move(cells));
  }



  void
  Table::put_first(const Column &column, const Cell &cell)
  {
    require_new(*this, column.name);
    const Cell first = fitted(cell, column, 0);
    column_list.insert(column_list.begin(), column);
    for (auto &row : rows)
      row.insert(row.begin(), first);
  }



  void
  Table::append(const Table &other)
  {
    if (column_list.empty())
      column_list = other.column_list;
    for (const auto &row : other.rows)
      add_row(row);
  }



  void
  Table::set(const std::size_t row, const std::string &column, const Cell &cell)
  {
    const std::size_t c = column_index(column);
    rows.at(row)[c]     = fitted(cell, column_list[c], row);
  }



  std::size_t
  Table::n_rows() const
  {
    return rows.size();
  }



  const std::vector<Table::Column> &
  Table::columns() const
  {
    return column_list;
  }



  bool
  Table::has_column(const std::string &name) const
  {
    return std::any_of(column_list.begin(),
                       column_list.end(),
                       [&](const Column &c) { return c.name == name; });
  }



  std::size_t
  Table::column_index(const std::string &name) const
  {
    for (std::size_t c = 0; c < column_list.size(); ++c)
      if (column_list[c].name == name)
        return c;
    throw InputError("there is no column '" + name +
                     "'; the columns are: " + names_of(column_list));
  }



  const Cell &
  Table::cell(const std::size_t row, const std::size_t column) const
  {
    return rows.at(row).at(column);
  }



  bool
  Table::is_missing(const std::size_t row, const std::string &column) const
  {
    return cell(row, column_index(column)).is_missing();
  }



  double
  Table::real(const std::size_t row, const std::string &column) const
  {
    const Cell &entry = cell(row, column_index(column));
    if (const double *real = std::get_if<double>(&entry.value))
      return *real;
    if (const long long *integer = std::get_if<long long>(&entry.value))
      return static_cast<double>(*integer);
    if (entry.is_missing())
      return std::numeric_limits<double>::quiet_NaN();
    throw InputError("the column '" + column + "' holds texts, not numbers");
  }



  long long
  Table::integer(const std::size_t row, const std::string &column) const
  {
    const Cell &entry = cell(row, column_index(column));
    if (const long long *integer = std::get_if<long long>(&entry.value))
      return *integer;
    throw InputError("the column '" + column + "' has no integer in row " +
                     std::to_string(row + 1));
  }



  std::string
  Table::text(const std::size_t row, const std::string &column) const
  {
    return csv_text(cell(row, column_index(column)));
  }



  std::vector<double>
  Table::reals(const std::string &column) const
  {
    std::vector<double> values(n_rows());
    for (std::size_t r = 0; r < n_rows(); ++r)
      values[r] = real(r, column);
    return values;
  }



  std::string
  Table::display(const std::size_t row, const std::size_t column) const
  {
    const Cell   &entry = cell(row, column);
    const double *real  = std::get_if<double>(&entry.value);
    if (real == nullptr)
      return csv_text(entry);
    const int n_decimals = column_list[column].n_decimals;
    if (n_decimals < 0 || !std::isfinite(*real))
      return rounded_text(*real, column_list[column].n_digits);
    // What the decimals cannot show is no zero.
    if (*real != 0. && std::abs(*real) < std::pow(10., -n_decimals))
      return rounded_text(*real, 2);
    char       buffer[512];
    const auto end = std::to_chars(buffer,
                                   buffer + sizeof(buffer),
                                   *real == 0. ? 0. : *real,
                                   std::chars_format::fixed,
                                   n_decimals);
    return std::string(buffer, end.ptr);
  }



  void
  Table::write_csv(std::ostream &out) const
  {
    const auto write_line = [&](const auto &text_of_column) {
      std::string line;
      for (std::size_t c = 0; c < column_list.size(); ++c)
        line += (c == 0 ? "" : ",") + quoted_if_needed(text_of_column(c));
      // a line without any character would be no row at all
      out << (line.empty() ? "\"\"" : line) << '\n';
    };
    write_line([&](const std::size_t c) { return column_list[c].name; });
    for (const auto &row : rows)
      write_line([&](const std::size_t c) { return csv_text(row[c]); });
  }



  void
  Table::write_csv(const std::string &path) const
  {
    write_atomically(path, [&](std::ostream &out) { write_csv(out); });
  }



  void
  Table::print(std::ostream                   &out,
               const std::vector<std::string> &names,
               const std::size_t               n_rows_shown) const
  {
    std::vector<std::size_t> shown;
    for (const std::string &name : names)
      shown.push_back(column_index(name));
    if (names.empty())
      for (std::size_t c = 0; c < column_list.size(); ++c)
        shown.push_back(c);

    std::vector<std::vector<std::string>> lines(1);
    std::vector<bool>                     left;
    for (const std::size_t c : shown)
      {
        lines[0].push_back(column_list[c].name);
        left.push_back(column_list[c].type == Type::text);
      }
    for (std::size_t r = 0; r < std::min(n_rows(), n_rows_shown); ++r)
      {
        lines.emplace_back();
        for (const std::size_t c : shown)
          lines.back().push_back(display(r, c));
      }
    print_aligned(out, lines, left);
    if (n_rows_shown < n_rows())
      out << "  ... and " << n_rows() - n_rows_shown << " more\n";
  }



  void
  Table::describe(std::ostream &out) const
  {
    std::vector<std::vector<std::string>> lines = {{"column", "unit", ""}};
    for (const Column &column : column_list)
      lines.push_back({column.name, column.unit, column.description});
    print_aligned(out, lines, {true, true, true});
  }
} // namespace squeal
