// SPDX-License-Identifier: LGPL-2.1-or-later
#include "compare_summary.h"

#include <algorithm>
#include <cmath>
#include <ostream>

namespace squeal
{
  namespace
  {
    constexpr std::size_t most_parameters = 6, most_rows = 8, most_items = 3,
                          most_letters = 26, line_letters = 78;

    // Results of two machines differ by less.
    constexpr double equal_to = 1e-6;

    std::string
    shortened(const std::string &text, const std::size_t most = most_letters)
    {
      return text.size() <= most ? text : text.substr(0, most - 3) + "...";
    }

    /** The first rows of @p table with short texts. */
    void
    print_first(const Table                    &table,
                const std::vector<std::string> &names,
                const std::vector<std::size_t> &rows,
                const std::size_t               most,
                std::ostream                   &out)
    {
      std::vector<Table::Column> columns;
      for (const auto &name : names)
        columns.push_back(table.columns()[table.column_index(name)]);
      Table first(columns);
      for (std::size_t i = 0; i < std::min(most, rows.size()); ++i)
        {
          std::vector<Cell> cells;
          for (const auto &column : columns)
            if (table.is_missing(rows[i], column.name))
              cells.emplace_back();
            else if (column.type == Table::Type::text)
              cells.emplace_back(shortened(table.text(rows[i], column.name)));
            else if (column.type == Table::Type::integer)
              cells.emplace_back(table.integer(rows[i], column.name));
            else
              cells.emplace_back(table.real(rows[i], column.name));
          first.add_row(cells);
        }
      first.print(out);
      if (rows.size() > most)
        out << "  ... and " << rows.size() - most << " more\n";
    }

    void
    print_parameters(const Table *parameters, std::ostream &out)
    {
      if (parameters == nullptr)
        return;
      const std::size_t n = parameters->n_rows();
      out
        << '\n'
        << (n == 0
              ? "No parameter that shapes the result differs (files that both "
                "read were not compared).\n"
              : std::to_string(n) +
                  (n == 1 ? " parameter differs:\n" : " parameters differ:\n"));
      if (n == 0)
        return;
      std::vector<std::size_t> rows(n);
      for (std::size_t i = 0; i < n; ++i)
        rows[i] = i;
      // the entry whole, the values short: they are looked up in run.json
      for (std::size_t i = 0; i < std::min(most_parameters, n); ++i)
        out << "  "
            << shortened(parameters->text(i, "parameter") + ": " +
                           shortened(parameters->text(i, "A")) + " -> " +
                           shortened(parameters->text(i, "B")),
                         line_letters)
            << '\n';
      if (n > most_parameters)
        out << "  ... and " << n - most_parameters << " more\n";
    }

    bool
    have_other_axes(const Table *parameters)
    {
      for (std::size_t i = 0; parameters && i < parameters->n_rows(); ++i)
        if (parameters->text(i, "parameter").rfind("Sweep/Ax", 0) == 0)
          return true;
      return false;
    }

    /** |lambda_b - lambda_a| over |lambda_a|; NaN where there is one alone. */
    double
    change(const Table &t, const std::size_t row)
    {
      if (t.is_missing(row, "a") || t.is_missing(row, "b"))
        return std::nan("");
      const double two_pi = 2. * std::acos(-1.);
      const bool   sigma  = t.has_column("dsigma");
      const double part   = sigma ? t.real(row, "dsigma") : 0.,
                   whole  = sigma ? t.real(row, "sigma_a") : 0.;
      const double size   = std::hypot(whole, two_pi * t.real(row, "f_a_hz"));
      const double d      = std::hypot(part, two_pi * t.real(row, "df_hz"));
      return d == 0. ? 0. : size > 0. ? d / size : HUGE_VAL;
    }

    void
    print_first(const std::string              &title,
                const std::vector<std::string> &items,
                std::ostream                   &out)
    {
      out << title << ": " << items.size() << '\n';
      for (std::size_t i = 0; i < std::min(most_items, items.size()); ++i)
        out << "  " << shortened(items[i], line_letters) << '\n';
      if (items.size() > most_items)
        out << "  ... and " << items.size() - most_items << " more\n";
    }

    void
    print_pairs(const Table &table, std::ostream &out)
    {
      std::vector<double>      changes;
      std::vector<std::size_t> both;
      std::size_t              n_equal = 0, n_a = 0, n_b = 0;
      for (std::size_t r = 0; r < table.n_rows(); ++r)
        {
          changes.push_back(change(table, r));
          n_a += table.is_missing(r, "b");
          n_b += table.is_missing(r, "a");
          n_equal += changes[r] <= equal_to;
          if (changes[r] > equal_to)
            both.push_back(r);
        }
      out << '\n'
          << table.n_rows() - n_a - n_b << " pairs are in both runs, "
          << n_equal << " of them equal to 1e-6 of |lambda|;\n"
          << n_a << " only in A, " << n_b << " only in B.\n";
      if (both.empty())
        return;
      std::stable_sort(both.begin(),
                       both.end(),
                       [&](const std::size_t i, const std::size_t j) {
                         return changes[i] > changes[j];
                       });
      std::vector<std::string> names;
      for (const char *name : {"point",
                               "name",
                               "f_a_hz",
                               "f_b_hz",
                               "df_percent",
                               "sigma_a",
                               "sigma_b"})
        if (table.has_column(name))
          names.emplace_back(name);
      out << "\nThe largest changes:\n";
      print_first(table, names, both, most_rows, out);
    }
  } // namespace



  void
  print_reservations(const RunComparison &comparison,
                     const Table         *parameters,
                     std::ostream        &out)
  {
    if (comparison.table.has_column("point") && have_other_axes(parameters))
      out << "The axes differ: points of one number may have other values.\n";
    if (!comparison.why_not_by_shape.empty())
      out << "By name: " << comparison.why_not_by_shape << ".\n";
  }



  void
  print_summary(const RunComparison &comparison,
                const Table         *parameters,
                std::ostream        &out)
  {
    print_parameters(parameters, out);
    print_reservations(comparison, parameters, out);
    print_pairs(comparison.table, out);
    if (comparison.table.has_column("dsigma"))
      {
        out << '\n';
        print_first("New instabilities", comparison.new_instabilities, out);
        print_first(
          "Vanished instabilities", comparison.vanished_instabilities, out);
        if (!comparison.open_growth.empty())
          print_first("Growth open by the mesh", comparison.open_growth, out);
      }
    out << "--all prints every pair.\n";
  }
} // namespace squeal
