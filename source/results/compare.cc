// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/assignment.h>
#include <squeal/base/exceptions.h>
#include <squeal/results/compare.h>
#include <squeal/results/open_growth.h>
#include <squeal/results/run_record.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <optional>
#include <ostream>
#include <sstream>

#include "compare_summary.h"

namespace squeal
{
  namespace fs = std::filesystem;

  namespace
  {
    constexpr double smallest_mac         = 0.3;
    constexpr double largest_distance     = 0.1; // relative, other name
    constexpr double cost_of_another_name = 0.05;

    /** The results of one run. */
    struct Run
    {
      std::string                               directory;
      bool                                      has_sigma = false;
      std::map<long, std::vector<ComparedPair>> points;
      SignatureFile                             signatures;
    };

    std::complex<double>
    eigenvalue(const ComparedPair &pair)
    {
      return {pair.sigma, 2. * std::acos(-1.) * pair.frequency};
    }

    /** |difference| over the larger eigenvalue. */
    double
    distance(const ComparedPair &a, const ComparedPair &b)
    {
      const double scale =
        std::max(std::abs(eigenvalue(a)), std::abs(eigenvalue(b)));
      return scale > 0. ? std::abs(eigenvalue(a) - eigenvalue(b)) / scale : 0.;
    }

    bool
    have_signatures(const std::vector<ComparedPair> &a,
                    const std::vector<ComparedPair> &b)
    {
      if (a.empty() || b.empty())
        return false;
      const std::size_t length = a.front().signature.size();
      const auto        fits   = [&](const ComparedPair &pair) {
        return length > 0 && pair.signature.size() == length;
      };
      return std::all_of(a.begin(), a.end(), fits) &&
             std::all_of(b.begin(), b.end(), fits);
    }

    /** Of the row @p r of eigenvalues.csv. */
    ComparedPair::Growth
    growth_of(const ComparedPair &pair, const Table &table, const std::size_t r)
    {
      const auto value_or = [&](const char *column, const double otherwise) {
        return table.has_column(column) && !table.is_missing(r, column)
                 ? table.real(r, column)
                 : otherwise;
      };
      if (is_growth_open(
            pair.sigma, value_or("sigma_error_mesh_per_s", 0.), pair.frequency))
        return ComparedPair::Growth::open;
      const double error = std::max(1e-10, value_or("error_estimate_rel", 0.));
      return pair.sigma > error * std::abs(eigenvalue(pair))
               ? ComparedPair::Growth::unstable
               : ComparedPair::Growth::stable;
    }

    Run
    read_run(const std::string &directory, const bool with_sigma)
    {
      const std::string path =
        (fs::path(directory) / (with_sigma ? "eigenvalues.csv" : "modes.csv"))
          .string();
      std::vector<Table::Column> required = {
        {"index", Table::Type::integer, "", ""},
        {"frequency_hz", Table::Type::real, "Hz", ""},
        {"name", Table::Type::text, "", ""}};
      if (with_sigma)
        required.push_back({"sigma_per_s", Table::Type::real, "1/s", ""});
      std::error_code ignored;
      if (!fs::exists(path, ignored))
        throw InputError("'" + directory + "' has no " +
                         fs::path(path).filename().string() +
                         ": --compare takes two eigenvalue analyses (modes, "
                         "cea, sweep), of which both have modes.csv or both "
                         "have eigenvalues.csv");
      const Table table = read_csv(path, required);

      Run run;
      run.directory = directory;
      run.signatures =
        read_signatures((fs::path(directory) / "signature.csv").string());
      run.has_sigma = with_sigma;
      for (std::size_t r = 0; r < table.n_rows(); ++r)
        {
          ComparedPair pair;
          pair.index     = table.integer(r, "index");
          pair.frequency = table.real(r, "frequency_hz");
          pair.sigma     = with_sigma ? table.real(r, "sigma_per_s") : 0.;
          pair.name      = table.text(r, "name");
          if (!std::isfinite(pair.frequency) || !std::isfinite(pair.sigma))
            throw InputError(path + ": row " + std::to_string(r + 1) +
                             " has no eigenvalue");
          if (with_sigma)
            pair.growth = growth_of(pair, table, r);
          const long point =
            table.has_column("point") ? table.integer(r, "point") : 0;
          run.points[point].push_back(pair);
        }
      if (run.points.size() == 1)
        {
          // its number says nothing
          auto only  = run.points.extract(run.points.begin());
          only.key() = 0;
          run.points.insert(std::move(only));
        }
      return run;
    }

    /** The records of two runs, if both left one. */
    std::optional<std::pair<RunRecord, RunRecord>>
    read_records(const Run &a, const Run &b)
    {
      const std::string path_a = (fs::path(a.directory) / "run.json").string();
      const std::string path_b = (fs::path(b.directory) / "run.json").string();
      std::error_code   ignored;
      if (!fs::exists(path_a, ignored) || !fs::exists(path_b, ignored))
        return {};
      return std::make_pair(read_run_record(path_a), read_run_record(path_b));
    }

    /** "" where the record does not tell. */
    std::string
    listed_bodies(const RunRecord &record)
    {
      for (const auto &[name, value] : record.parameters)
        if (name == "Scene/Bodies")
          return value;
      return "";
    }

    /** Gives every pair its signature, those of @p b in the order of @p a;
     * returns why that cannot be done, else "". */
    std::string
    give_signatures(
      Run                                                  &a,
      Run                                                  &b,
      const std::optional<std::pair<RunRecord, RunRecord>> &records)
    {
      // the index is unique within a point only
      if (a.points.size() != 1 || b.points.size() != 1)
        return "";
      const std::string bodies = records ? listed_bodies(records->first) : "";
      const std::string reason = align_signatures(
        a.signatures,
        b.signatures,
        !bodies.empty() && bodies == listed_bodies(records->second));
      for (Run *run : {&a, &b})
        for (ComparedPair &pair : run->points.begin()->second)
          {
            const auto found = run->signatures.of_pair.find(pair.index);
            if (found != run->signatures.of_pair.end())
              pair.signature = found->second;
          }
      return reason;
    }

    Table
    empty_table(const bool with_sigma,
                const bool with_point,
                const bool by_shape)
    {
      using Type = Table::Type;
      Table table;
      if (with_point)
        table.add_column({"point", Type::integer, "", ""});
      table.add_column({"a", Type::integer, "", "index in run A"});
      table.add_column({"b", Type::integer, "", "index in run B"});
      table.add_column({"name", Type::text, "", "name in run A, else in B"});
      table.add_column({"f_a_hz", Type::real, "Hz", "frequency in A", 6, 2});
      table.add_column({"f_b_hz", Type::real, "Hz", "frequency in B", 6, 2});
      table.add_column({"df_hz", Type::real, "Hz", "f_b - f_a", 6, 2});
      table.add_column({"df_percent", Type::real, "%", "of f_a", 6, 3});
      if (with_sigma)
        {
          table.add_column(
            {"sigma_a", Type::real, "1/s", "growth rate in A", 5});
          table.add_column(
            {"sigma_b", Type::real, "1/s", "growth rate in B", 5});
          table.add_column({"dsigma", Type::real, "1/s", "change", 4});
        }
      if (by_shape)
        table.add_column(
          {"mac", Type::real, "", "likeness of the shapes", 6, 3});
      table.add_column({"note", Type::text, "", ""});
      return table;
    }

    /** What became of the growth of a pair from A to B, one of which may be
     * null, for the column note; it is entered in the lists of @p result. */
    std::string
    change_of_growth(RunComparison      &result,
                     const ComparedPair *a,
                     const ComparedPair *b,
                     const std::string  &at_point)
    {
      using Growth     = ComparedPair::Growth;
      const Growth was = a != nullptr ? a->growth : Growth::stable,
                   is  = b != nullptr ? b->growth : Growth::stable;
      const auto label = [&](const ComparedPair &pair) {
        return rounded_text(pair.frequency, 6) + " Hz " + pair.name + at_point;
      };
      if (is == Growth::open || (b == nullptr && was == Growth::open))
        {
          result.open_growth.push_back(label(b != nullptr ? *b : *a));
          return "growth open by the mesh";
        }
      if (is == Growth::unstable && was == Growth::unstable)
        return "unstable";
      if (is == Growth::unstable)
        {
          const bool was_open = was == Growth::open;
          result.new_instabilities.push_back(
            label(*b) + (was_open ? ", open by the mesh in A" : ""));
          return std::string("NEW INSTABILITY") +
                 (was_open ? "; open by the mesh in A" : "");
        }
      if (was == Growth::unstable)
        {
          result.vanished_instabilities.push_back(label(*a));
          return "instability gone";
        }
      return was == Growth::open ? "growth decided: stable in B" : "";
    }

    /** Adds a row; one of @p a and @p b may be null. */
    void
    add_comparison(RunComparison      &result,
                   const ComparedPair *a,
                   const ComparedPair *b,
                   const long          point)
    {
      Table            &table = result.table;
      std::vector<Cell> missing(table.columns().size());
      table.add_row(missing);
      const std::size_t row = table.n_rows() - 1;
      const auto        set = [&](const std::string &column, const Cell &cell) {
        if (table.has_column(column))
          table.set(row, column, cell);
      };
      set("point", point);
      set("name", a != nullptr ? a->name : b->name);
      if (a != nullptr)
        {
          set("a", a->index);
          set("f_a_hz", a->frequency);
          set("sigma_a", a->sigma);
        }
      if (b != nullptr)
        {
          set("b", b->index);
          set("f_b_hz", b->frequency);
          set("sigma_b", b->sigma);
        }
      if (a != nullptr && b != nullptr)
        {
          const double df = b->frequency - a->frequency;
          set("df_hz", df);
          if (a->frequency > 0.)
            set("df_percent", 100. * df / a->frequency);
          set("dsigma", b->sigma - a->sigma);
          set("mac", modal_assurance(a->signature, b->signature));
        }

      std::string note;
      if (a == nullptr)
        note = "only in B";
      else if (b == nullptr)
        note = "only in A";
      else if (a->name != b->name)
        note = "in B: " + b->name;
      const std::string growth = change_of_growth(
        result,
        a,
        b,
        table.has_column("point") ? " at point " + std::to_string(point) : "");
      note += (note.empty() || growth.empty() ? "" : "; ") + growth;
      set("note", note);
    }

    void
    compare_point(RunComparison                   &result,
                  const std::vector<ComparedPair> &a,
                  const std::vector<ComparedPair> &b,
                  const long                       point)
    {
      std::vector<bool> used_a(a.size(), false), used_b(b.size(), false);
      for (const auto &[i, j] : match_pairs(a, b))
        {
          add_comparison(result, &a[i], &b[j], point);
          used_a[i] = used_b[j] = true;
        }
      for (std::size_t i = 0; i < a.size(); ++i)
        if (!used_a[i])
          add_comparison(result, &a[i], nullptr, point);
      for (std::size_t j = 0; j < b.size(); ++j)
        if (!used_b[j])
          add_comparison(result, nullptr, &b[j], point);
    }

    /** The parameters that shape the result and differ. */
    Table
    differing_parameters(const RunRecord &record_a, const RunRecord &record_b)
    {
      std::map<std::string, std::pair<std::string, std::string>> values;
      for (const auto &[name, value] : record_a.parameters)
        values[name].first = value;
      for (const auto &[name, value] : record_b.parameters)
        values[name].second = value;
      Table table({{"parameter", Table::Type::text, "", ""},
                   {"A", Table::Type::text, "", ""},
                   {"B", Table::Type::text, "", ""}});
      for (const auto &[name, both] : values)
        if (both.first != both.second && name.find("Output") != 0 &&
            name.find("Result checks/") != 0)
          table.add_row({name, both.first, both.second});
      return table;
    }

    void
    print_list(const std::string              &title,
               const std::vector<std::string> &items,
               std::ostream                   &out)
    {
      out << title << ": " << (items.empty() ? "none" : "") << '\n';
      for (const std::string &item : items)
        out << "  " << item << '\n';
    }

    void
    print_all(const RunComparison        &result,
              const std::optional<Table> &parameters,
              std::ostream               &out)
    {
      if (parameters && parameters->n_rows() == 0)
        out << "\nAll parameters that shape the result are the same.\n";
      else if (parameters)
        {
          out << '\n';
          parameters->print(out);
        }
      out << '\n';
      print_reservations(result, parameters ? &*parameters : nullptr, out);
      out << "Pairs matched by "
          << (result.by_shape ? "shape (MAC)" : "name and nearest eigenvalue")
          << ":\n";
      result.table.print(out);
      if (!result.table.has_column("dsigma"))
        return;
      out << '\n';
      print_list("New instabilities", result.new_instabilities, out);
      print_list("Vanished instabilities", result.vanished_instabilities, out);
      if (!result.open_growth.empty())
        print_list("Growth open by the mesh", result.open_growth, out);
    }
  } // namespace



  std::vector<std::pair<std::size_t, std::size_t>>
  match_pairs(const std::vector<ComparedPair> &a,
              const std::vector<ComparedPair> &b)
  {
    const bool   by_shape = have_signatures(a, b);
    const double refused  = 10.;

    std::vector<std::vector<double>> costs(a.size(),
                                           std::vector<double>(b.size()));
    for (std::size_t i = 0; i < a.size(); ++i)
      for (std::size_t j = 0; j < b.size(); ++j)
        {
          const double apart      = distance(a[i], b[j]);
          const bool   same_name  = a[i].name == b[j].name;
          const double difference = cost_of_another_name * !same_name;
          if (by_shape)
            {
              // the eigenvalue decides only between equal shapes
              const double mac =
                modal_assurance(a[i].signature, b[j].signature);
              costs[i][j] =
                mac < smallest_mac ? refused : 1. - mac + 0.02 * apart;
            }
          else
            costs[i][j] = !same_name && apart > largest_distance
                            ? refused
                            : apart + difference;
        }

    std::vector<std::pair<std::size_t, std::size_t>> matches;
    const std::vector<int> column_of = smallest_assignment(costs);
    for (std::size_t i = 0; i < a.size(); ++i)
      if (column_of[i] >= 0 && costs[i][column_of[i]] < refused)
        matches.emplace_back(i, column_of[i]);
    return matches;
  }



  RunComparison
  compare_runs(const std::string &directory_a,
               const std::string &directory_b,
               std::ostream      &out,
               const bool         all)
  {
    for (const std::string &directory : {directory_a, directory_b})
      if (!fs::is_directory(directory))
        throw InputError("'" + directory +
                         "' is not the output directory of a run");
    const bool with_sigma =
      fs::exists(fs::path(directory_a) / "eigenvalues.csv") &&
      fs::exists(fs::path(directory_b) / "eigenvalues.csv");
    Run        a       = read_run(directory_a, with_sigma);
    Run        b       = read_run(directory_b, with_sigma);
    const auto records = read_records(a, b);

    RunComparison result;
    result.why_not_by_shape = give_signatures(a, b, records);
    const bool with_point   = a.points.size() > 1 || b.points.size() > 1;
    for (const auto &[point, pairs] : a.points)
      if (!with_point && b.points.size() == 1)
        result.by_shape = have_signatures(pairs, b.points.begin()->second);
    result.table = empty_table(with_sigma, with_point, result.by_shape);

    std::map<long, int> points;
    for (const Run *run : {&a, &b})
      for (const auto &[point, pairs] : run->points)
        points[point] = 0;
    for (const auto &[point, unused] : points)
      {
        const auto                      in_a = a.points.find(point);
        const auto                      in_b = b.points.find(point);
        const std::vector<ComparedPair> none;
        compare_point(result,
                      in_a == a.points.end() ? none : in_a->second,
                      in_b == b.points.end() ? none : in_b->second,
                      point);
      }

    std::optional<Table> parameters;
    if (records)
      parameters = differing_parameters(records->first, records->second);
    std::ostringstream whole;
    print_all(result, parameters, whole);
    const std::string text = whole.str();
    out << "A: " << directory_a << "\nB: " << directory_b << '\n';
    if (all || std::count(text.begin(), text.end(), '\n') + 2 <=
                 static_cast<long>(most_compared_lines))
      out << text;
    else
      print_summary(result, parameters ? &*parameters : nullptr, out);
    return result;
  }
} // namespace squeal
