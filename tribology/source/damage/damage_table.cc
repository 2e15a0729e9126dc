// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/parameters/choices.h>
#include <squeal/parameters/numbers.h>
#include <squeal/tribology/damage/damage_table.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace squeal::tribology
{
  namespace
  {
    using Node = HistoryDamage::Node;

    /** A column that is computed from a node of one history. */
    struct Quantity
    {
      Table::Column                       column;
      std::function<double(const Node &)> value;
      bool                                has_ratio      = false;
      bool                                may_be_missing = false;
    };



    std::string
    with_underscores(std::string text)
    {
      std::replace(text.begin(), text.end(), ' ', '_');
      return text;
    }



    double
    ratio(const double a, const double b)
    {
      return b > 0. ? a / b : NAN;
    }



    Table::Column
    real(const std::string &name,
         const std::string &unit,
         const std::string &description)
    {
      return {name, Table::Type::real, unit, description, 4};
    }



    void
    add_damage(std::vector<Quantity>   &list,
               const FatigueParameters &f,
               const double             period,
               const bool               has_dirlik)
    {
      const std::string what =
        f.constants.empty() ? "index of damage"
        : f.accumulation == FatigueParameters::Accumulation::miner
          ? "damage (1 is failure)"
          : "share of the life while the history repeats";
      for (std::size_t c = 0; c < f.exponents.size(); ++c)
        {
          const std::string m = slope_name(f.exponents[c]);
          list.push_back(
            {real("damage_" + m + "_per_s",
                  "1/s",
                  what + " per second, slope " + m),
             [c, period](const Node &n) { return n.damage[c] / period; },
             true});
          list.push_back({real("damage_" + m + "_error_per_s",
                               "1/s",
                               "standard error of that by its scatter along "
                               "the history, slope " +
                                 m),
                          [c, period](const Node &n) {
                            return n.sampling_error[c] * n.damage[c] / period;
                          },
                          false,
                          true});
          list.push_back({real("damage_" + m + "_per_application",
                               "",
                               what + " per brake application, slope " + m),
                          [c, period, &f](const Node &n) {
                            return n.damage[c] / period * f.application_time;
                          }});
          list.push_back(
            {real("damage_" + m + "_averaged_per_s",
                  "1/s",
                  what +
                    " per second of the stress averaged over "
                    "the averaging length, slope " +
                    m),
             [c, period](const Node &n) { return n.averaged[c] / period; },
             true});
          if (has_dirlik)
            list.push_back({real("dirlik_over_counting_" + m,
                                 "",
                                 "spectral over counted damage, both on a "
                                 "straight S-N line without mean stress and by "
                                 "Miner's sum, slope " +
                                   m),
                            [c, period](const Node &n) {
                              return ratio(n.dirlik[c], n.straight[c] / period);
                            },
                            false,
                            true});
        }
    }



    void
    add_surface(std::vector<Quantity>   &list,
                const SurfaceParameters &surface,
                const double             application_time,
                const HistoryDamage     &damage)
    {
      const double k =
        surface.wear_coefficient > 0. ? surface.wear_coefficient : 1.;
      const bool is_index = surface.wear_coefficient <= 0.;
      const auto per_s    = [](const double value, const Node &n) {
        return ratio(value, n.surface.duration);
      };
      const auto of_slip = [per_s, known = damage.has_slip_rate](
                             const double value, const Node &n) {
        return known ? per_s(value, n) : NAN;
      };
      list.push_back({real("friction_power_w_per_m2",
                           "W/m^2",
                           "mean friction power per area"),
                      [of_slip](const Node &n) {
                        return of_slip(n.surface.friction_energy, n);
                      },
                      true,
                      true});
      list.push_back({real("friction_energy_per_application_j_per_m2",
                           "J/m^2",
                           "friction energy per area and application"),
                      [of_slip, application_time](const Node &n) {
                        return of_slip(n.surface.friction_energy, n) *
                               application_time;
                      },
                      false,
                      true});
      list.push_back(
        {is_index ? real("wear_index_pa_m_per_s",
                         "Pa m/s",
                         "pressure times slip speed: Archard wear rate for "
                         "k/H = 1")
                  : real("wear_rate_m_per_s", "m/s", "Archard wear rate"),
         [of_slip, k](const Node &n) {
           return k * of_slip(n.surface.pressure_slip, n);
         },
         true,
         true});
      list.push_back({is_index ? real("wear_index_per_application_pa_m",
                                      "Pa m",
                                      "the same per application")
                               : real("wear_depth_per_application_m",
                                      "m",
                                      "Archard wear depth per application"),
                      [of_slip, k, application_time](const Node &n) {
                        return k * of_slip(n.surface.pressure_slip, n) *
                               application_time;
                      },
                      false,
                      true});
      list.push_back({real("contact_duty", "", "part of the time in contact"),
                      [](const Node &n) { return n.surface.duty(); }});
      list.push_back(
        {real("impacts_per_s", "1/s", "closures after separation"),
         [per_s](const Node &n) { return per_s(n.surface.impacts, n); }});
      list.push_back({real("impulse_per_impact_pa_s",
                           "Pa s",
                           "impulse per area from closure to the first maximum "
                           "of the pressure"),
                      [](const Node &n) {
                        return n.surface.impacts > 0.
                                 ? ratio(n.surface.impulse, n.surface.closures)
                                 : 0.;
                      },
                      false,
                      true});
      list.push_back(
        {real("stick_slip_per_s", "1/s", "changes between stick and slip"),
         [per_s, known = damage.has_stick_slip](const Node &n) {
           return known ? per_s(n.surface.stick_slip, n) : NAN;
         },
         false,
         true});
    }



    /** Largest utilisation of a criterion below a node, without flagged
     * points unless there are no others, and its depth. */
    std::array<double, 2>
    deepest_maximum(const std::vector<SubsurfacePoint> &points,
                    const std::size_t                   node,
                    const std::size_t                   criterion)
    {
      std::array<double, 2> best{{NAN, NAN}};
      for (const SubsurfacePoint &p : points)
        if (p.node == node && !p.is_near_edge)
          {
            const double value = p.values[criterion].utilisation();
            if (std::isnan(value))
              throw ComputationError("a criterion below the surface has no "
                                     "finite value");
            if (!(value <= best[0]))
              best = {{value, p.depth}};
          }
      if (best[0] == 0.) // alike at all depths
        best[1] = NAN;
      return best;
    }
  } // namespace



  std::string
  slope_name(const double exponent)
  {
    return "m" + prm::format_number(exponent);
  }



  Table
  damage_table(const TribologyParameters          &p,
               const ContactGrid                  &grid,
               const HistoryDamage                &squealing,
               const HistoryDamage                *silent,
               const std::vector<SubsurfacePoint> &subsurface)
  {
    const bool            has_dirlik = !squealing.nodes[0].dirlik.empty();
    std::vector<Quantity> list       = {
            {real("mean_pressure_pa", "Pa", "mean pressure"),
             [](const Node &n) { return n.surface.mean_pressure(); },
             true},
            {real("peak_pressure_pa", "Pa", "largest pressure"),
             [](const Node &n) { return n.surface.peak_pressure; },
             true},
            {real("cycles_per_s", "1/s", "counted cycles"),
             [&](const Node &n) { return n.cycles / squealing.period; }},
            {real("largest_range_pa", "Pa", "largest counted range"),
             [](const Node &n) { return n.largest_range; }}};
    add_damage(list, p.fatigue, squealing.period, has_dirlik);
    add_surface(list, p.surface, p.fatigue.application_time, squealing);
    std::vector<Quantity> for_silent;
    if (silent)
      {
        add_damage(for_silent, p.fatigue, silent->period, false);
        add_surface(for_silent, p.surface, p.fatigue.application_time, *silent);
      }

    Table table(
      {{"node", Table::Type::integer, "", "contact node, from 0"},
       {"x_m", Table::Type::real, "m", "place along the face's first axis", 4},
       {"y_m", Table::Type::real, "m", "place along its second axis", 4},
       {"area_m2", Table::Type::real, "m^2", "tributary area", 4},
       {"sliding_x",
        Table::Type::real,
        "",
        "direction in which the disc slides, 0 and 0: all round",
        4},
       {"sliding_y", Table::Type::real, "", "the same, second axis", 4}});
    for (const Quantity &q : list)
      table.add_column(q.column);
    const std::vector<SubsurfaceParameters::Criterion> criteria =
      subsurface.empty() ? std::vector<SubsurfaceParameters::Criterion>()
                         : p.subsurface.criteria;
    for (const auto criterion : criteria)
      {
        const std::string name = with_underscores(choice_name(criterion));
        table.add_column(real("subsurface_" + name,
                              "",
                              "largest " + choice_name(criterion) +
                                " value over its limit below the node"));
        table.add_column(
          real("depth_" + name + "_m", "m", "depth of that maximum"));
      }
    for (const Quantity &q : for_silent)
      if (q.has_ratio)
        {
          table.add_column(real("silent_" + q.column.name,
                                q.column.unit,
                                q.column.description + ", silent run"));
          table.add_column(
            real("ratio_" + q.column.name,
                 "",
                 "squealing over silent: " + q.column.description));
        }

    for (std::size_t k = 0; k < grid.n_nodes(); ++k)
      {
        std::vector<Cell> row = {k,
                                 grid.place(k)[0],
                                 grid.place(k)[1],
                                 grid.area(k),
                                 grid.sliding()[0],
                                 grid.sliding()[1]};
        for (const Quantity &q : list)
          row.push_back(q.may_be_missing
                          ? or_missing(q.value(squealing.nodes[k]))
                          : Cell(q.value(squealing.nodes[k])));
        for (std::size_t c = 0; c < criteria.size(); ++c)
          for (const double value : deepest_maximum(subsurface, k, c))
            row.push_back(or_missing(value));
        for (const Quantity &q : for_silent)
          if (q.has_ratio)
            {
              const double quiet = q.value(silent->nodes[k]);
              const auto   same =
                std::find_if(list.begin(), list.end(), [&](const Quantity &o) {
                  return o.column.name == q.column.name;
                });
              row.push_back(q.may_be_missing ? or_missing(quiet) : Cell(quiet));
              // Where the silent pad does not touch, rounding alone is counted.
              const bool touches = silent->nodes[k].surface.contact_time > 0.;
              row.push_back(touches ? or_missing(ratio(
                                        same->value(squealing.nodes[k]), quiet))
                                    : Cell());
            }
        table.add_row(row);
      }
    return table;
  }



  Table
  subsurface_table(const SubsurfaceParameters         &p,
                   const ContactGrid                  &grid,
                   const std::vector<SubsurfacePoint> &points)
  {
    using C = SubsurfaceParameters::Criterion;
    Table table(
      {{"node", Table::Type::integer, "", "contact node, from 0"},
       {"x_m", Table::Type::real, "m", "place of the node", 4},
       {"y_m", Table::Type::real, "m", "place of the node", 4},
       {"depth_m", Table::Type::real, "m", "depth under the face", 4},
       {"near_edge",
        Table::Type::integer,
        "",
        "1: an edge is too near: than three depths in a half-space, than two "
        "of the finest cells in a block"}});
    const auto has_plane = [](const C c) {
      return c == C::findley || c == C::swt || c == C::fatemi_socie;
    };
    for (const C criterion : p.criteria)
      {
        const std::string name = with_underscores(choice_name(criterion));
        table.add_column(real(name, "", "value over limit"));
        if (has_plane(criterion))
          {
            table.add_column(real(name + "_inclination_deg",
                                  "degrees",
                                  "critical plane: normal from the z axis"));
            table.add_column(real(name + "_azimuth_deg",
                                  "degrees",
                                  "critical plane: normal from the x axis"));
          }
      }
    table.add_column({"field",
                      Table::Type::text,
                      "",
                      "half-space, or block: with finite elements"});
    for (const SubsurfacePoint &point : points)
      {
        std::vector<Cell> row = {point.node,
                                 grid.place(point.node)[0],
                                 grid.place(point.node)[1],
                                 point.depth,
                                 int(point.is_near_edge)};
        for (std::size_t c = 0; c < p.criteria.size(); ++c)
          {
            row.push_back(point.values[c].utilisation());
            if (has_plane(p.criteria[c]))
              {
                const CriterionValue &value = point.values[c];
                row.push_back(value.has_plane() ? Cell(value.inclination())
                                                : Cell());
                row.push_back(value.has_plane() ? Cell(value.azimuth())
                                                : Cell());
              }
          }
        row.push_back(point.is_in_block ? "block" : "half-space");
        table.add_row(row);
      }
    return table;
  }



  std::vector<std::string>
  damage_indices(const Table &table)
  {
    std::vector<std::string> names;
    for (const Table::Column &column : table.columns())
      {
        const std::string &n      = column.name;
        const auto         starts = [&n](const std::string &start) {
          return n.compare(0, start.size(), start) == 0;
        };
        if (n.find("_error_") != std::string::npos)
          continue;
        if ((starts("damage_") && n.find("_per_s") != std::string::npos) ||
            starts("friction_power") || starts("wear_index_pa_m_per_s") ||
            starts("wear_rate") || starts("impacts_per_s") ||
            starts("impulse_per_impact") || starts("stick_slip") ||
            starts("peak_pressure") || starts("subsurface_"))
          names.push_back(n);
      }
    return names;
  }
} // namespace squeal::tribology
