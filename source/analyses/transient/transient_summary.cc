// SPDX-License-Identifier: LGPL-2.1-or-later

// What a transient comes to: one row of figures, its pairs, and both as JSON.

#include <squeal/analyses/transient/transient_results.h>
#include <squeal/results/json_file.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <ostream>

namespace squeal
{
  namespace
  {
    using Type = Table::Type;
    using Json = nlohmann::ordered_json;

    const char *
    yes_or_no(const bool value)
    {
      return value ? "yes" : "no";
    }

    /** JSON has no word for what is not a number. */
    Json
    number(const double value)
    {
      return std::isfinite(value) ? Json(value) : Json();
    }

    /** What the cut-off costs, the last columns of runs and of pairs. */
    std::vector<Table::Column>
    with_reduction_columns(std::vector<Table::Column> columns)
    {
      const std::string text =
        "estimated: with the motions above the cut-off less without them, "
        "about steady sliding";
      columns.push_back(
        {"sigma_error_reduction_per_s", Type::real, "1/s", text, 2});
      columns.push_back(
        {"frequency_error_reduction_hz", Type::real, "Hz", text, 2});
      return columns;
    }

    std::vector<Table::Column>
    transient_columns()
    {
      return {
        {"verdict", Type::text, "", "stable, unstable or undecided"},
        {"growth_rate_per_s", Type::real, "1/s", "of the leading branch"},
        {"growth_rate_ci_per_s",
         Type::real,
         "1/s",
         "half width, 95 %, and the time step's part",
         3},
        {"growth_frequency_hz", Type::real, "Hz", "of the leading branch", 7},
        {"e_foldings", Type::real, "", "within the fitted window", 3},
        {"sigma_linear_per_s", Type::real, "1/s", "about steady sliding"},
        {"frequency_linear_hz", Type::real, "Hz", "about steady sliding", 7},
        {"sigma_cea_per_s", Type::real, "1/s", "by the whole model"},
        {"frequency_cea_hz", Type::real, "Hz", "by the whole model", 7},
        {"limit_cycle", Type::text, "", "the second half is steady"},
        {"limit_cycle_frequency_hz",
         Type::real,
         "Hz",
         "of its period, in samples",
         6},
        {"mean_normal_n", Type::real, "N", "steps of the second half"},
        {"rms_normal_n", Type::real, "N", "about the mean"},
        {"min_normal_n", Type::real, "N", ""},
        {"max_normal_n", Type::real, "N", ""},
        {"rms_tangential_n", Type::real, "N", "about the mean"},
        {"macroscopic_friction", Type::real, "", "mean friction over normal"},
        {"phase_deg",
         Type::real,
         "deg",
         "tangential against normal at the largest line, in samples",
         4},
        {"separates", Type::text, "", "all nodes are open at a time"},
        {"stick_fraction", Type::real, "", "of closed node-time", 4},
        {"max_slip_speed_ratio", Type::real, "", "over |V| of its pair", 4},
        {"rms_pad_acceleration", Type::real, "m/s2", "centre of the pad", 4},
        {"leading_edge_factor", Type::real, "", "mean", 4},
        {"peak_pressure_pa", Type::real, "Pa", "", 4},
        {"n_never", Type::integer, "", "nodes never closed"},
        {"n_slip", Type::integer, "", "nodes that always slip"},
        {"n_sticking", Type::integer, "", "nodes that always stick"},
        {"n_stick_slip", Type::integer, "", "nodes that stick and slip"},
        {"n_separating", Type::integer, "", "nodes that open and close"},
        {"worst_imbalance", Type::real, "", "of the energy ledger", 2},
        {"steps_per_second", Type::real, "1/s", "of one core", 4},
        {"iterations_per_step", Type::real, "", "of Newton's method", 3},
        {"inversions", Type::real, "", "of the contact Jacobian", 5},
        {"limit_cycle_frequency_ci_hz",
         Type::real,
         "Hz",
         "largest deviation of its quarters that have a line",
         2},
        {"largest_line_hz",
         Type::real,
         "Hz",
         "of the force that is judged, in samples",
         6},
        {"repetition",
         Type::real,
         "",
         "correlation of the normal force periods later, in samples",
         3},
        {"rms_normal_change_n",
         Type::real,
         "N",
         "of the rms from the first to the second half of its time",
         3},
        {"mean_normal_error_n",
         Type::real,
         "N",
         "of the judged pair: by the period that the end of the run cuts, at "
         "most",
         2},
        {"rms_normal_error_n",
         Type::real,
         "N",
         "by the period that the end of the run cuts, at most",
         2}};
    }



    std::vector<Cell>
    transient_cells(const TransientFigures &f)
    {
      const bool         has   = f.leading >= 0;
      const BranchResult b     = has ? f.branches[f.leading] : BranchResult();
      const auto         known = [&](const double value) {
        return has ? Cell(value) : Cell();
      };
      const auto fitted = [&](const double value) {
        return b.fit.is_valid ? Cell(value) : Cell();
      };
      // Noise has a largest line, too.
      const auto vibrating = [&](const double value) {
        return nothing_vibrates(f) ? Cell() : or_missing(value);
      };
      const auto of_lines = [&](const double value) {
        return f.beyond_samples > 0. ? Cell() : vibrating(value);
      };
      return {f.verdict,
              fitted(b.fit.rate),
              fitted(b.fit.rate_ci),
              fitted(b.fit.frequency),
              fitted(b.fit.e_foldings()),
              known(b.sigma),
              known(b.frequency),
              has ? or_missing(b.sigma_cea) : Cell(),
              has ? or_missing(b.frequency_cea) : Cell(),
              yes_or_no(f.has_limit_cycle),
              of_lines(f.frequency),
              f.mean_normal_of_all,
              f.rms_normal,
              f.min_normal,
              f.max_normal,
              f.rms_tangential,
              or_missing(f.macroscopic_friction),
              vibrating(f.phase),
              yes_or_no(f.separates),
              f.stick_fraction,
              f.max_slip_speed_ratio,
              f.rms_acceleration,
              or_missing(f.mean_leading_edge_factor),
              f.peak_pressure,
              f.n_never,
              f.n_slip,
              f.n_sticking,
              f.n_stick_slip,
              f.n_separating,
              f.worst_imbalance,
              f.steps_per_second,
              f.iterations_per_step,
              f.n_inversions,
              vibrating(f.frequency_ci),
              of_lines(f.largest_line),
              vibrating(f.repetition),
              or_missing(f.rms_change),
              or_missing(f.mean_normal_error),
              or_missing(f.rms_normal_error),
              known(b.sigma_reduction),
              known(b.frequency_reduction)};
    }
  } // namespace



  Table
  transient_table(const TransientFigures &f)
  {
    Table table(with_reduction_columns(transient_columns()));
    table.add_row(transient_cells(f));
    if (f.loudest.is_beside_sums())
      {
        table.add_column(
          {"judged_force", Type::text, "", "whose vibration this is"});
        table.set(0, "judged_force", Cell(f.loudest.force_name));
      }
    if (f.loudest.name.empty())
      return table;
    for (const auto &[column, cell] :
         {std::make_pair(
            Table::Column{
              "loudest_pair", Type::text, "", "whose vibration this is"},
            Cell(f.loudest.name)),
          std::make_pair(
            Table::Column{
              "loudest_mean_normal_n", Type::real, "N", "of that pair"},
            Cell(f.mean_normal))})
      {
        table.add_column(column);
        table.set(0, column.name, cell);
      }
    return table;
  }



  Table
  branch_table(const TransientFigures &f)
  {
    Table table(with_reduction_columns(
      {{"branch", Type::integer, "", "by frequency, from 1"},
       {"frequency_linear_hz", Type::real, "Hz", "about steady sliding", 7},
       {"sigma_linear_per_s", Type::real, "1/s", "about steady sliding"},
       {"frequency_cea_hz", Type::real, "Hz", "by the whole model", 7},
       {"sigma_cea_per_s", Type::real, "1/s", "by the whole model"},
       {"frequency_transient_hz", Type::real, "Hz", "linear phase", 7},
       {"growth_rate_per_s", Type::real, "1/s", "linear phase"},
       {"growth_rate_ci_per_s",
        Type::real,
        "1/s",
        "half width, 95 %, and the time step's part",
        3},
       {"window_start_s", Type::real, "s", "of the fit", 4},
       {"window_end_s", Type::real, "s", "of the fit", 4},
       {"e_foldings", Type::real, "", "within the window", 3},
       {"rms_amplitude_sqrt_j", Type::real, "J^0.5", "second half", 3}}));
    for (std::size_t k = 0; k < f.branches.size(); ++k)
      {
        const BranchResult &b      = f.branches[k];
        const auto          fitted = [&](const double value) {
          return b.fit.is_valid ? Cell(value) : Cell();
        };
        table.add_row({k + 1,
                       b.frequency,
                       b.sigma,
                       or_missing(b.frequency_cea),
                       or_missing(b.sigma_cea),
                       fitted(b.fit.frequency),
                       fitted(b.fit.rate),
                       fitted(b.fit.rate_ci),
                       fitted(b.fit.start),
                       fitted(b.fit.end),
                       fitted(b.fit.e_foldings()),
                       b.last_amplitude,
                       b.sigma_reduction,
                       b.frequency_reduction});
      }
    return table;
  }



  void
  write_transient_json(const TransientFigures &f,
                       const std::string      &explanation,
                       const std::string      &path)
  {
    const Table table = transient_table(f);
    Json        json  = {{"format_version", 1}};
    for (const auto &column : table.columns())
      if (column.type == Type::text)
        json[column.name] = table.text(0, column.name);
      else
        json[column.name] = number(table.real(0, column.name));
    json["explanation"]    = explanation;
    json["linear_phase_s"] = {f.linear_start, f.linear_end};
    json["harmonics_n"]    = f.harmonics;
    const Table branches   = branch_table(f);
    json["branches"]       = Json::array();
    for (std::size_t i = 0; i < branches.n_rows(); ++i)
      {
        Json row;
        for (const auto &column : branches.columns())
          row[column.name] = number(branches.real(i, column.name));
        json["branches"].push_back(row);
      }
    write_json(path, json);
  }
} // namespace squeal
