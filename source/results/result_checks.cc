// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/base/run_log.h>
#include <squeal/parameters/text.h>
#include <squeal/results/result_checks.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

namespace squeal
{
  namespace
  {
    struct Condition
    {
      std::string column;
      std::string comparison;
      std::string value;
    };

    bool
    read_number(const std::string &text, double &number)
    {
      const char *end    = text.data() + text.size();
      const auto  result = std::from_chars(text.data(), end, number);
      return result.ec == std::errc() && result.ptr == end;
    }

    /** Numbers that differ by less, relatively, are equal. */
    constexpr double rounding_of_values = 1e-12;

    /** Splits "column op value" at the first operator. */
    Condition
    read_condition(const std::string &text)
    {
      const std::size_t at     = text.find_first_of("=!<>");
      std::size_t       length = 1;
      if (at != std::string::npos && text[at] != '=' &&
          text.compare(at + 1, 1, "=") == 0)
        length = 2;
      Condition condition;
      if (at != std::string::npos)
        condition = {prm::trim(text.substr(0, at)),
                     text.substr(at, length),
                     prm::trim(text.substr(at + length))};
      if (condition.column.empty() || condition.value.empty() ||
          condition.comparison == "!")
        throw InputError("'" + text +
                         "' is no condition of the form 'column = value'");
      return condition;
    }

    /** Those that " and " joins. */
    std::vector<Condition>
    read_conditions(const std::string &text)
    {
      std::vector<Condition> conditions;
      const std::string      separator = " and ";
      std::string            rest      = prm::trim(text);
      while (!rest.empty())
        {
          const std::size_t cut = rest.find(separator);
          conditions.push_back(read_condition(rest.substr(0, cut)));
          rest =
            cut == std::string::npos ? "" : rest.substr(cut + separator.size());
        }
      return conditions;
    }

    template <typename T>
    bool
    holds(const T &a, const std::string &comparison, const T &b)
    {
      if (comparison == "=")
        return a == b;
      if (comparison == "!=")
        return a != b;
      if (comparison == "<")
        return a < b;
      if (comparison == "<=")
        return a <= b;
      return comparison == ">" ? a > b : a >= b;
    }

    bool
    is_numeric(const Table &table, const std::string &column)
    {
      return table.columns()[table.column_index(column)].type !=
             Table::Type::text;
    }

    bool
    row_meets(const Table      &table,
              const std::size_t row,
              const Condition  &condition)
    {
      double number = 0.;
      if (!is_numeric(table, condition.column))
        return holds(table.text(row, condition.column),
                     condition.comparison,
                     condition.value);
      if (!read_number(condition.value, number))
        throw InputError("the column '" + condition.column +
                         "' holds numbers, not '" + condition.value + "'");
      // comparisons with a missing value (NaN) are false, and "!=" true
      double value = table.real(row, condition.column);
      // 0.9 of a file is 0.1 + 8 x 0.1 of an axis.
      if (std::abs(value - number) <= rounding_of_values * std::abs(number))
        value = number;
      return holds(value, condition.comparison, number);
    }

    /** The first "column = text" of @p where that no row of @p table meets, as
     * "no row has column = text", or nothing: a name that may be misspelt. */
    std::string
    unmet_text(const Table &table, const std::string &where)
    {
      for (const Condition &c : read_conditions(where))
        {
          bool is_met = is_numeric(table, c.column) || c.comparison != "=";
          for (std::size_t row = 0; !is_met && row < table.n_rows(); ++row)
            is_met = row_meets(table, row, c);
          if (!is_met)
            return "no row has " + c.column + " = " + c.value;
        }
      return "";
    }

    std::size_t
    nearest_row(const Table                    &table,
                const std::vector<std::size_t> &rows,
                const std::string              &text)
    {
      const Condition condition = read_condition(text);
      double          number    = 0.;
      if (condition.comparison != "=" || !read_number(condition.value, number))
        throw InputError("'" + text + "' is not of the form 'column = number'");
      std::size_t nearest  = rows.front();
      double      distance = std::numeric_limits<double>::infinity();
      for (const std::size_t row : rows)
        {
          const double d = std::abs(table.real(row, condition.column) - number);
          if (d < distance)
            {
              nearest  = row;
              distance = d;
            }
        }
      if (!std::isfinite(distance))
        throw InputError("no selected row has a value in '" + condition.column +
                         "'");
      return nearest;
    }

    /** Fills @p check from the rows; throws InputError for what prevents it. */
    void
    compare(const ResultCheckParameters &asked,
            const Table                 &table,
            ResultCheck                 &check)
    {
      std::vector<std::size_t> rows = select_rows(table, asked.where);
      const auto               take = [&](const double value) {
        const double error = std::abs(value - check.expected);
        if (!check.has_value || error > std::abs(check.got - check.expected))
          check.got = value;
        check.has_value = true;
      };
      check.n_rows = rows.size();
      if (asked.column == "count")
        {
          if (!asked.nearest.empty())
            throw InputError("'Nearest' takes one row, which 'count' does not "
                             "count: select rows by 'Where'");
          take(static_cast<double>(rows.size()));
          if (rows.empty())
            check.reason = unmet_text(table, asked.where);
        }
      else
        {
          table.column_index(asked.column);
          if (!is_numeric(table, asked.column))
            throw InputError("the column '" + asked.column +
                             "' holds texts: select them with 'where' and "
                             "check 'count'");
          if (rows.empty())
            throw InputError(asked.where.empty() ? "the table has no rows"
                                                 : "no row has " + asked.where);
          if (!asked.nearest.empty())
            rows = {nearest_row(table, rows, asked.nearest)};
          check.n_rows = rows.size();
          for (const std::size_t row : rows)
            {
              if (table.is_missing(row, asked.column))
                throw InputError("there is no value in row " +
                                 std::to_string(row + 1) + " of the column '" +
                                 asked.column + "'");
              const double value = table.real(row, asked.column);
              if (!std::isfinite(value))
                throw InputError("the value in row " + std::to_string(row + 1) +
                                 " of the column '" + asked.column +
                                 "' is infinite");
              take(value);
            }
        }
      check.passed = std::abs(check.got - check.expected) <= check.tolerance;
    }
  } // namespace



  std::string
  ResultCheck::line() const
  {
    const std::string head = (passed ? "ok      " : "FAILED  ") + name + ": ";
    if (!has_value)
      return head + reason;
    return head + "got " + rounded_text(got, 8) + ", expected " +
           rounded_text(expected, 8) + ", tolerance " +
           rounded_text(tolerance, 3) +
           (n_rows > 1    ? " (worst of " + std::to_string(n_rows) + " rows)"
            : n_rows == 0 ? " (" + (reason.empty() ? "no row" : reason) + ")"
                          : "");
  }



  std::vector<std::size_t>
  select_rows(const Table &table, const std::string &condition)
  {
    const std::vector<Condition> conditions = read_conditions(condition);
    for (const Condition &c : conditions)
      table.column_index(c.column);
    std::vector<std::size_t> rows;
    for (std::size_t row = 0; row < table.n_rows(); ++row)
      if (std::all_of(
            conditions.begin(), conditions.end(), [&](const Condition &c) {
              return row_meets(table, row, c);
            }))
        rows.push_back(row);
    return rows;
  }



  std::vector<ResultCheck>
  evaluate_result_checks(const std::vector<ResultCheckParameters>   &checks,
                         const std::map<std::string, const Table *> &tables)
  {
    std::string names;
    for (const auto &[name, table] : tables)
      names += (names.empty() ? "" : ", ") + name;

    std::vector<ResultCheck> results;
    for (const ResultCheckParameters &asked : checks)
      {
        ResultCheck check;
        check.name     = asked.name;
        check.expected = asked.expected;
        check.tolerance =
          std::max(asked.relative_tolerance * std::abs(asked.expected),
                   asked.absolute_tolerance);
        const auto found = tables.find(asked.table);
        if (found == tables.end())
          check.reason =
            "there is no table '" + asked.table + "'; the tables are: " + names;
        else
          try
            {
              compare(asked, *found->second, check);
            }
          catch (const InputError &e)
            {
              check.has_value = false;
              check.reason    = asked.table + ": " + e.what();
            }
        results.push_back(check);
      }
    return results;
  }



  void
  print_result_checks(const std::vector<ResultCheck> &checks, RunLog &log)
  {
    if (checks.empty())
      return;
    log.heading("Result checks");
    for (const ResultCheck &check : checks)
      log.result("  " + check.line());
  }



  void
  require_passed(const std::vector<ResultCheck> &checks)
  {
    std::string failed;
    std::size_t n_failed = 0;
    for (const ResultCheck &check : checks)
      if (!check.passed)
        {
          failed += (n_failed == 0 ? "" : ", ") + check.name;
          ++n_failed;
        }
    if (n_failed > 0)
      throw CheckError(std::to_string(n_failed) + " of " +
                       std::to_string(checks.size()) +
                       " result checks failed: " + failed);
  }
} // namespace squeal
