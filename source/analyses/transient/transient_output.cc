// SPDX-License-Identifier: LGPL-2.1-or-later

// Tables of a transient over time, its zones and its speeds.

#include <squeal/analyses/transient/transient_results.h>
#include <squeal/output/judged_force.h>

#include <cmath>
#include <functional>

namespace squeal
{
  namespace
  {
    using Type = Table::Type;

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
        "across the sliding, along t x n, on the source"},
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
                       or_missing(s.leading_edge),
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
      const std::string closed = n.slip == 0.   ? "stick"
                                 : n.stick > 0. ? "stick-slip"
                                                : "slip";
      return n.open > 0. ? closed + "-separation" : closed;
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
              const TransientFigures  &f,
              const Parameters        &p)
  {
    constexpr unsigned int n_parts = 50;
    static_assert(n_force_stretches % n_parts == 0, "whole stretches");
    Table        table({{"time_s", Type::real, "s", "middle of a stretch"},
                        {"speed_m_per_s", Type::real, "m/s", "sliding, there"},
                        {"macroscopic_friction",
                         Type::real,
                         "",
                         "mean friction along the sliding over mean normal "
                                "force"},
                        {"mean_normal_n", Type::real, "N", ""},
                        {"rms_normal_n", Type::real, "N", "about the mean"}});
    const double v           = prepared.pressed.speed();
    const bool   has_several = !f.loudest.name.empty();
    if (has_several)
      table.add_column(
        {"loudest_pair", Type::text, "", "whose vibration this is"});
    table.add_column(judged_force_column("judged_force"));
    for (unsigned int k = 0; k < n_parts && record.n_steps >= 4 * n_parts; ++k)
      {
        constexpr unsigned int length = n_force_stretches / n_parts;
        const unsigned int     first = k * length, end = first + length;
        const ForceStatistics  s  = statistics_of(record.stretches, first, end);
        const JudgedPair  loudest = loudest_in(f.judged, record, first, end);
        const double      share   = (k + 0.5) / n_parts;
        std::vector<Cell> row     = {
              share * p.transient.end_time,
              v * (1. + (p.transient.final_speed_ratio - 1.) * share),
              or_missing(s.macroscopic_friction()),
              s.mean_normal,
              rms_of_pressure(loudest, record, first, end)};
        if (has_several)
          row.emplace_back(loudest.name);
        row.push_back(judged_force_cell(
          loudest.is_beside_sums() ? loudest.force_name : ""));
        table.add_row(row);
      }
    return table;
  }
} // namespace squeal
