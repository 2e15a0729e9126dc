// SPDX-License-Identifier: LGPL-2.1-or-later

// Tables and JSON of a transient.

#include <squeal/analyses/transient/transient_results.h>
#include <squeal/results/json_file.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <functional>
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

    constexpr const char *reduction_text =
      "estimated: with the motions above the cut-off less without them, about "
      "steady sliding";

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
        {"limit_cycle_frequency_hz", Type::real, "Hz", "of its period", 6},
        {"mean_normal_n", Type::real, "N", "second half of the run"},
        {"rms_normal_n", Type::real, "N", "about the mean"},
        {"min_normal_n", Type::real, "N", ""},
        {"max_normal_n", Type::real, "N", ""},
        {"rms_tangential_n", Type::real, "N", "about the mean"},
        {"macroscopic_friction", Type::real, "", "mean tangential over normal"},
        {"phase_deg",
         Type::real,
         "deg",
         "tangential against normal at the largest line",
         4},
        {"separates", Type::text, "", "all nodes are open at a time"},
        {"stick_fraction", Type::real, "", "of closed node-time", 4},
        {"max_slip_speed_ratio", Type::real, "", "over |V|", 4},
        {"rms_pad_acceleration", Type::real, "m/s2", "centre of the pad", 4},
        {"leading_edge_factor", Type::real, "", "mean", 4},
        {"peak_pressure_pa", Type::real, "Pa", "", 4},
        {"n_never", Type::integer, "", "nodes never closed"},
        {"n_slip", Type::integer, "", "nodes that always slip"},
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
        {"largest_line_hz", Type::real, "Hz", "of the normal force", 6},
        {"repetition",
         Type::real,
         "",
         "correlation of the normal force periods later",
         3},
        {"sigma_error_reduction_per_s", Type::real, "1/s", reduction_text, 2},
        {"frequency_error_reduction_hz", Type::real, "Hz", reduction_text, 2}};
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
              f.frequency,
              f.mean_normal,
              f.rms_normal,
              f.min_normal,
              f.max_normal,
              f.rms_tangential,
              or_missing(f.macroscopic_friction),
              f.phase,
              yes_or_no(f.separates),
              f.stick_fraction,
              f.max_slip_speed_ratio,
              f.rms_acceleration,
              or_missing(f.mean_leading_edge_factor),
              f.peak_pressure,
              f.n_never,
              f.n_slip,
              f.n_stick_slip,
              f.n_separating,
              f.worst_imbalance,
              f.steps_per_second,
              f.iterations_per_step,
              f.n_inversions,
              or_missing(f.frequency_ci),
              f.largest_line,
              f.repetition,
              known(b.sigma_reduction),
              known(b.frequency_reduction)};
    }
  } // namespace



  Table
  transient_table(const TransientFigures &f)
  {
    Table table(transient_columns());
    table.add_row(transient_cells(f));
    return table;
  }



  Table
  branch_table(const TransientFigures &f)
  {
    Table table(
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
       {"rms_amplitude_sqrt_j", Type::real, "J^0.5", "second half", 3},
       {"sigma_error_reduction_per_s", Type::real, "1/s", reduction_text, 2},
       {"frequency_error_reduction_hz", Type::real, "Hz", reduction_text, 2}});
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



  namespace
  {
    /** A column of each of several pairs: "<pair>_normal_n". */
    std::string
    of_pair(const ContactPair &pair, const std::string &column)
    {
      return pair.name() + "_" + column;
    }

    /** Mean power between sample @p k and the one before it, W, where @p lost
     * is the energy lost up to a sample, J; empty at the start. */
    Cell
    power_up_to(const std::size_t                               k,
                const TransientRecord                          &record,
                const std::function<double(const std::size_t)> &lost)
    {
      if (k == 0)
        return Cell();
      return Cell((lost(k) - lost(k - 1)) /
                  (record.samples[k].time - record.samples[k - 1].time));
    }

    constexpr const char *power_text =
      "lost in slip, mean since the sample before";

    /** Resultants of each of several pairs behind those of all. */
    void
    add_pair_forces(const PreparedTransient &prepared,
                    const TransientRecord   &record,
                    Table                   &table)
    {
      const auto &pairs = prepared.pressed.nodes().pairs();
      if (pairs.size() < 2)
        return;
      using Member = double PairSample::*;
      for (unsigned int i = 0; i < pairs.size(); ++i)
        for (const auto &[name, text, member] :
             {std::make_tuple("normal_n",
                              "compression positive",
                              Member(&PairSample::normal)),
              std::make_tuple("tangential_n",
                              "along the sliding, on the source",
                              Member(&PairSample::tangential)),
              std::make_tuple("transverse_n",
                              "across the sliding, on the source",
                              Member(&PairSample::radial))})
          {
            const std::string column = of_pair(pairs[i], name);
            table.add_column({column, Type::real, "N", text});
            for (std::size_t k = 0; k < record.samples.size(); ++k)
              table.set(k, column, record.pair(k, i).*member);
          }
      for (unsigned int i = 0; i < pairs.size(); ++i)
        {
          const std::string column = of_pair(pairs[i], "friction_power_w");
          table.add_column({column, Type::real, "W", power_text});
          for (std::size_t k = 0; k < record.samples.size(); ++k)
            table.set(
              k, column, power_up_to(k, record, [&](const std::size_t s) {
                return record.pair(s, i).friction;
              }));
        }
    }
  } // namespace



  Table
  force_table(const PreparedTransient &prepared, const TransientRecord &record)
  {
    Table table(
      {{"time_s", Type::real, "s", ""},
       {"normal_n", Type::real, "N", "compression positive"},
       {"tangential_n", Type::real, "N", "along the sliding, on the source"},
       {"radial_n",
        Type::real,
        "N",
        "across the sliding (outwards on a disc), on the source"},
       {"n_open", Type::integer, "", "open nodes"},
       {"n_stick", Type::integer, "", "sticking nodes"},
       {"leading_edge_factor", Type::real, "", ""},
       {"friction_power_w", Type::real, "W", power_text}});
    for (std::size_t k = 0; k < record.samples.size(); ++k)
      {
        const TransientSample &s = record.samples[k];
        table.add_row({s.time,
                       s.normal,
                       s.tangential,
                       s.radial,
                       static_cast<int>(s.n_open),
                       static_cast<int>(s.n_stick),
                       s.leading_edge,
                       power_up_to(k, record, [&](const std::size_t i) {
                         return record.samples[i].friction;
                       })});
      }
    add_pair_forces(prepared, record, table);
    return table;
  }

  Table
  energy_table(const PreparedTransient &prepared, const TransientRecord &record)
  {
    Table table({{"time_s", Type::real, "s", ""},
                 {"kinetic_j", Type::real, "J", ""},
                 {"elastic_j", Type::real, "J", ""},
                 {"damping_j", Type::real, "J", "lost in the bodies"},
                 {"friction_j", Type::real, "J", "lost in slip"},
                 {"driving_j", Type::real, "J", "work of the sliding target"},
                 {"load_j", Type::real, "J", "work of the loads"},
                 {"numerical_j", Type::real, "J", "lost by the scheme"},
                 {"imbalance_rel", Type::real, "", "of the work done"}});
    for (const auto &s : record.samples)
      table.add_row({s.time,
                     s.kinetic,
                     s.elastic,
                     s.damping,
                     s.friction,
                     s.driving,
                     s.load,
                     s.numerical,
                     s.imbalance});
    const auto &pairs = prepared.pressed.nodes().pairs();
    for (unsigned int i = 0; i < pairs.size() && pairs.size() > 1; ++i)
      {
        const std::string column = of_pair(pairs[i], "friction_j");
        table.add_column({column, Type::real, "J", "lost in its slip"});
        for (std::size_t k = 0; k < record.samples.size(); ++k)
          table.set(k, column, record.pair(k, i).friction);
      }
    return table;
  }

  Table
  probe_table(const PreparedTransient &prepared, const TransientRecord &record)
  {
    const auto &pairs = prepared.pressed.nodes().pairs();
    Table       table({{"time_s", Type::real, "s", ""}});
    for (const ContactPair &pair : pairs)
      {
        const std::string name = pairs.size() == 1 ? "pad" : pair.name();
        const char       *text = "centre of the source body";
        for (const char *axis : {"x", "y", "z"})
          {
            table.add_column({name + "_" + axis + "_m", Type::real, "m", text});
            text = "";
          }
        for (const char *axis : {"x", "y", "z"})
          table.add_column(
            {name + "_a" + axis + "_m_per_s2", Type::real, "m/s2", ""});
      }
    for (std::size_t k = 0; k < record.samples.size(); ++k)
      {
        std::vector<Cell> row = {record.samples[k].time};
        for (unsigned int i = 0; i < pairs.size(); ++i)
          {
            const PairSample &s = record.pair(k, i);
            row.insert(row.end(), s.position, s.position + 3);
            row.insert(row.end(), s.acceleration, s.acceleration + 3);
          }
        table.add_row(row);
      }
    return table;
  }



  namespace
  {
    std::string
    zone_of(const NodeShares &n)
    {
      if (n.stick + n.slip == 0.)
        return "open";
      if (n.open > 0.)
        return n.stick > 0. ? "stick-slip-separation" : "slip-separation";
      return n.stick > 0. ? "stick-slip" : "slip";
    }
  } // namespace



  Table
  zone_table(const PreparedTransient &prepared, const TransientRecord &record)
  {
    const auto &pairs = prepared.pressed.nodes().pairs();
    Table       table({{"node", Type::integer, "", "from 0"},
                       {"x_m", Type::real, "m", ""},
                       {"y_m", Type::real, "m", ""},
                       {"zone", Type::text, "", "second half of the run"},
                       {"open_share", Type::real, "", "of the time", 4},
                       {"stick_share", Type::real, "", "of the time", 4},
                       {"slip_share", Type::real, "", "of the time", 4},
                       {"peak_pressure_pa", Type::real, "Pa", "", 4}});
    const bool  has_names = pairs.size() > 1;
    if (has_names)
      {
        table.add_column({"z_m", Type::real, "m", ""});
        table.add_column({"pair", Type::text, "", "contact"});
      }
    for (const ContactPair &pair : pairs)
      for (unsigned int k = 0; k < pair.n_nodes(); ++k)
        {
          const auto        j     = static_cast<std::size_t>(pair.first + k);
          const auto       &x     = pair.geometry.points[k];
          const NodeShares &n     = record.nodes[j];
          const double      total = std::max(1., n.open + n.stick + n.slip);
          std::vector<Cell> row   = {j,
                                     x[0],
                                     x[1],
                                     zone_of(n),
                                     n.open / total,
                                     n.stick / total,
                                     n.slip / total,
                                     n.peak_pressure};
          if (has_names)
            {
              row.emplace_back(x[2]);
              row.emplace_back(pair.name());
            }
          table.add_row(row);
        }
    return table;
  }



  Table
  speed_table(const PreparedTransient &prepared,
              const TransientRecord   &record,
              const Parameters        &p)
  {
    constexpr std::size_t n_parts = 50;
    Table        table({{"time_s", Type::real, "s", "middle of a stretch"},
                        {"speed_m_per_s", Type::real, "m/s", "sliding, there"},
                        {"macroscopic_friction",
                         Type::real,
                         "",
                         "mean tangential over mean normal force"},
                        {"mean_normal_n", Type::real, "N", ""},
                        {"rms_normal_n", Type::real, "N", "about the mean"}});
    const auto  &s = record.samples;
    const double v = prepared.pressed.speed();
    for (std::size_t k = 0; k < n_parts && s.size() >= 4 * n_parts; ++k)
      {
        const std::size_t first = k * s.size() / n_parts,
                          end   = (k + 1) * s.size() / n_parts;
        double n = 0., t = 0., variance = 0.;
        for (std::size_t i = first; i < end; ++i)
          {
            n += s[i].normal / (end - first);
            t += s[i].tangential / (end - first);
          }
        for (std::size_t i = first; i < end; ++i)
          variance += (s[i].normal - n) * (s[i].normal - n) / (end - first);
        const double time = 0.5 * (s[first].time + s[end - 1].time);
        table.add_row({time,
                       v * (1. + (p.transient.final_speed_ratio - 1.) * time /
                                   p.transient.end_time),
                       n > 0. ? Cell(t / n) : Cell(),
                       n,
                       std::sqrt(variance)});
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
