// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/results/chart.h>
#include <squeal/tribology/damage/range_mean_picture.h>
#include <squeal/tribology/driver/damage_study.h>

#include <algorithm>
#include <cmath>

namespace squeal::tribology
{
  namespace
  {
    /** Column of the table as a map. */
    ContactMap::Panel
    map_of(const Table       &table,
           const std::string &column,
           const std::string &title,
           const std::string &unit,
           const double       scale       = 1.,
           const bool         logarithmic = false)
    {
      ContactMap::Panel panel;
      panel.title       = title;
      panel.label       = unit;
      panel.values      = table.reals(column);
      panel.logarithmic = logarithmic;
      for (double &value : panel.values)
        value *= scale;
      return panel;
    }



    void
    draw_maps(Context                       &context,
              const DamageStudy             &study,
              std::vector<ContactMap::Panel> panels,
              const std::string             &name)
    {
      for (ContactMap::Panel &panel : panels)
        panel.values = study.grid.drawn_values(panel.values);
      ContactMap(study.grid.drawn_face())
        .plot(
          context.plotter, panels, context.plot_path(name + study.suffix()), 3);
    }



    void
    draw_damage(Context &context, const DamageStudy &study, const Table &table)
    {
      const FatigueParameters       &f = context.parameters.fatigue;
      std::vector<ContactMap::Panel> maps;
      for (const double exponent : f.exponents)
        maps.push_back(map_of(table,
                              "damage_" + slope_name(exponent) + "_per_s",
                              "Damage, slope " + slope_name(exponent),
                              f.constants.empty() ? "index in 1/s" : "1/s",
                              1.,
                              true));
      draw_maps(context, study, maps, "damage_maps");
      draw_maps(
        context,
        study,
        {map_of(table, "peak_pressure_pa", "Peak pressure", "MPa", 1e-6),
         map_of(
           table, "friction_power_w_per_m2", "Friction power", "kW/m^2", 1e-3),
         map_of(table, "contact_duty", "Duty of contact", "part"),
         map_of(table, "impacts_per_s", "Impacts", "1/s"),
         map_of(
           table, "impulse_per_impact_pa_s", "Impulse of an impact", "Pa s"),
         map_of(table, "stick_slip_per_s", "Stick-slip changes", "1/s")},
        "surface_maps");
      const std::size_t      worst  = study.damage.worst_node();
      const RangeMeanMatrix &matrix = study.damage.matrices[worst];
      std::vector<double>    ranges, means;
      for (std::size_t i = 0; i < matrix.n_classes(); ++i)
        {
          ranges.push_back(matrix.range(i));
          means.push_back(matrix.mean(i));
        }
      context.plotter.draw(
        draw_matrix(ranges,
                    means,
                    matrix.values(),
                    "Cycles at node " + std::to_string(worst) +
                      ", where damage of slope " +
                      slope_name(f.exponents.front()) + " is largest"),
        context.plot_path("range_mean" + study.suffix()));
    }



    /** Largest and mean utilisation against depth, flagged points left out. */
    void
    draw_depths(Context &context, const DamageStudy &study)
    {
      const SubsurfaceParameters &p = context.parameters.subsurface;
      Chart                       chart;
      const auto                  has_own = [&p](const auto criterion) {
        return has_limit(criterion, p);
      };
      const bool all =
                   std::all_of(p.criteria.begin(), p.criteria.end(), has_own),
                 any =
                   std::any_of(p.criteria.begin(), p.criteria.end(), has_own);
      chart.title =
        any ? "Largest value over its limit under the face"
            : "Largest value over its limit by the reference stress (none "
              "given)";
      chart.x.label = "depth in um";
      chart.x.scale = AxisSettings::Scale::logarithmic;
      chart.y.label = all   ? "value / limit"
                      : any ? "value / limit, given or by reference stress"
                            : "value / limit by reference stress";
      for (std::size_t c = 0; c < p.criteria.size(); ++c)
        {
          ChartSeries series;
          series.label = choice_name(p.criteria[c]);
          if (any && !has_own(p.criteria[c]))
            series.label += ", limit by the reference stress";
          series.ink   = static_cast<Ink>(c % 8);
          series.style = ChartSeries::Style::lines_points;
          for (const double depth : p.depths)
            {
              double largest = -1e300;
              for (const SubsurfacePoint &point : study.subsurface)
                if (point.depth == depth && !point.is_near_edge)
                  largest = std::max(largest, point.values[c].utilisation());
              if (largest > -1e300)
                {
                  series.x.push_back(1e6 * depth);
                  series.y.push_back(largest);
                }
            }
          chart.series.push_back(series);
        }
      context.plotter.draw(draw_charts({chart}, 1100, 700),
                           context.plot_path("depths" + study.suffix()));
    }
  } // namespace



  void
  draw_damage_pictures(Context           &context,
                       const DamageStudy &study,
                       const Table       &table,
                       const bool         has_silent)
  {
    Timers::Section section(context.timers, "Write: plots");
    draw_damage(context, study, table);
    if (has_silent)
      {
        std::vector<ContactMap::Panel> maps;
        for (const double m : context.parameters.fatigue.exponents)
          maps.push_back(map_of(table,
                                "ratio_damage_" + slope_name(m) + "_per_s",
                                "Squealing over silent, " + slope_name(m),
                                "ratio",
                                1.,
                                true));
        draw_maps(context, study, maps, "ratio_maps");
      }
    if (!study.subsurface.empty())
      draw_depths(context, study);
  }
} // namespace squeal::tribology
