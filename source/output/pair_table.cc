// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/output/cea_quantities.h>
#include <squeal/output/pair_table.h>

#include <cmath>

namespace squeal
{
  using Type = Table::Type;

  PairRow::PairRow(const ComplexPairs &pairs, const unsigned int i)
    : index(i + 1)
    , lambda(pairs.lambda[i])
    , residual(i < pairs.residual.size() ? Cell(pairs.residual[i]) : Cell())
    , error_estimate(pairs.error_estimate[i])
    , condition(pairs.condition[i])
    , is_unstable(squeal::is_unstable(pairs, i))
    , discretisation_error(std::nan(""))
    , mesh_error(std::nan(""), std::nan(""))
  {
  }



  const std::vector<PairColumn> &
  pair_columns_before_shares()
  {
    static const std::vector<PairColumn> columns = {
      {{"index", Type::integer, "", "number of the pair, from 1"},
       [](const PairRow &r) { return Cell(r.index); }},
      {{"branch",
        Type::text,
        "",
        "branch of a sweep, by the names at its ends"},
       [](const PairRow &r) { return Cell(r.branch); }},
      {{"sigma_per_s", Type::real, "1/s", "growth rate; > 0 unstable", 6, 3},
       [](const PairRow &r) { return Cell(r.lambda.real()); }},
      {{"frequency_hz", Type::real, "Hz", "omega / 2 pi", 7},
       [](const PairRow &r) { return Cell(r.lambda.imag() / (2. * M_PI)); }},
      {{"damping_ratio", Type::real, "", "zeta = -sigma / |lambda|", 4},
       [](const PairRow &r) {
         return Cell(r.lambda == 0. ? 0.
                                    : -r.lambda.real() / std::abs(r.lambda));
       }},
      {{"residual_rel", Type::real, "", "relative, of the full problem", 2},
       [](const PairRow &r) { return r.residual; }},
      {{"error_estimate_rel",
        Type::real,
        "",
        "estimated relative error of the reduction",
        2},
       [](const PairRow &r) { return or_missing(r.error_estimate); }},
      {{"name", Type::text, "", "disc shape and support motion"},
       [](const PairRow &r) { return Cell(r.name); }}};
    return columns;
  }



  const std::vector<PairColumn> &
  pair_columns_behind_shares()
  {
    static const std::vector<PairColumn> columns = {
      {{"energy_per_cycle",
        Type::real,
        "",
        "friction work per cycle over peak kinetic energy",
        3},
       [](const PairRow &r) { return Cell(r.energy_per_cycle); }},
      {{"contact_participation",
        Type::real,
        "",
        "tangential source times normal target motion",
        3},
       [](const PairRow &r) { return r.contact_participation; }},
      {{"partner_1", Type::text, "", "undamped mode, MAC"},
       [](const PairRow &r) { return Cell(r.partners[0]); }},
      {{"partner_2", Type::text, "", "undamped mode, MAC"},
       [](const PairRow &r) { return Cell(r.partners[1]); }},
      {{"contact_state", Type::text, "", "of the contact"},
       [](const PairRow &r) { return Cell(r.contact_state); }},
      {{"discretisation_error_rel",
        Type::real,
        "",
        "estimated relative frequency error of the mesh",
        2},
       [](const PairRow &r) { return or_missing(r.discretisation_error); }},
      {{"condition", Type::real, "", "of the eigenvalue", 3},
       [](const PairRow &r) {
         return std::isnan(r.condition) ? Cell() : unbounded(r.condition);
       }},
      {{"abaqus_damping_ratio",
        Type::real,
        "",
        "-2 sigma / |omega|, as Abaqus prints it",
        4},
       [](const PairRow &r) {
         return r.lambda.imag() == 0.
                  ? Cell()
                  : Cell(-2. * r.lambda.real() / r.lambda.imag());
       }},
      {{"unstable", Type::integer, "", "1: sigma beyond its error"},
       [](const PairRow &r) { return Cell(r.is_unstable ? 1 : 0); }},
      {{"sigma_error_mesh_per_s",
        Type::real,
        "1/s",
        "estimated: growth rate on an infinitely fine mesh less this one",
        2},
       [](const PairRow &r) { return or_missing(r.mesh_error.real()); }},
      {{"frequency_error_mesh_hz",
        Type::real,
        "Hz",
        "estimated: frequency on an infinitely fine mesh less this one",
        2},
       [](const PairRow &r) {
         return or_missing(r.mesh_error.imag() / (2. * M_PI));
       }}};
    return columns;
  }



  PairTable::PairTable(const std::vector<std::string>   &bodies,
                       const std::vector<Table::Column> &axes,
                       const std::vector<Table::Column> &at_end)
  {
    result.add_column({"point", Type::integer, "", "parameter point, from 0"});
    for (const auto &column : axes)
      result.add_column(column);
    for (const auto &column : pair_columns_before_shares())
      result.add_column(column.column);
    for (const auto &body : bodies)
      result.add_column({"ke_share_" + body,
                         Type::real,
                         "",
                         "share of the kinetic energy in " + body,
                         3});
    for (const auto &column : pair_columns_behind_shares())
      result.add_column(column.column);
    for (const auto &column : at_end)
      result.add_column(column);
  }

  void
  PairTable::add(const PairRow           &row,
                 const std::vector<Cell> &axes,
                 const std::vector<Cell> &at_end)
  {
    std::vector<Cell> cells{row.point};
    cells.insert(cells.end(), axes.begin(), axes.end());
    for (const auto &column : pair_columns_before_shares())
      cells.push_back(column.value(row));
    cells.insert(
      cells.end(), row.energy_shares.begin(), row.energy_shares.end());
    for (const auto &column : pair_columns_behind_shares())
      cells.push_back(column.value(row));
    cells.insert(cells.end(), at_end.begin(), at_end.end());
    result.add_row(std::move(cells));
  }

  const Table &
  PairTable::table() const
  {
    return result;
  }
} // namespace squeal
