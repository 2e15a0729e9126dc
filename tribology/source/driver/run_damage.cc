// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/parameters/checks.h>
#include <squeal/parameters/choices.h>
#include <squeal/parameters/text.h>
#include <squeal/results/chart.h>
#include <squeal/tribology/damage/damage_files.h>
#include <squeal/tribology/damage/damage_table.h>
#include <squeal/tribology/damage/map_picture.h>
#include <squeal/tribology/driver/analyses.h>

#include <algorithm>
#include <cmath>

namespace squeal::tribology
{
  namespace
  {
    /** One history with all that is computed from it. */
    struct Study
    {
      Study(const std::string &file, const HistoryParameters &history)
        : reader(file)
        , window(history_window(reader, history))
        , grid(reader.layout())
      {
      }

      HistoryReader                reader;
      HistoryWindow                window;
      ContactGrid                  grid;
      HistoryDamage                damage;
      std::vector<SubsurfacePoint> subsurface;
    };



    void
    count(Context &context, Study &study, const std::string &name)
    {
      const TribologyParameters &p = context.parameters;
      Timers::Section            section(context.timers, "Count: " + name);
      Progress progress(context.log, name + " history", study.window.n);
      study.damage = count_history(
        study.reader,
        p.history,
        p.fatigue,
        p.surface,
        study.grid,
        [&progress](const std::size_t n) { progress.advance(n); });
      for (const std::string &note : study.damage.notes)
        context.log.warning(study.reader.path() + ": " + note);
    }



    void
    require_same_nodes(const Study &a, const Study &b)
    {
      bool same = a.grid.n_nodes() == b.grid.n_nodes();
      for (std::size_t k = 0; same && k < a.grid.n_nodes(); ++k)
        same = std::hypot(a.grid.place(k)[0] - b.grid.place(k)[0],
                          a.grid.place(k)[1] - b.grid.place(k)[1]) <
               1e-3 * std::sqrt(a.grid.area(k));
      if (!same)
        throw InputError("'" + b.reader.path() +
                         "' has other contact nodes than '" + a.reader.path() +
                         "': compare runs of the same contact mesh");
    }



    /** Column of the table as a map. */
    FaceMap
    map_of(const Table       &table,
           const std::string &column,
           const std::string &title,
           const std::string &unit,
           const double       scale       = 1.,
           const bool         logarithmic = false)
    {
      FaceMap map{title, unit, table.reals(column), logarithmic};
      for (double &value : map.values)
        value *= scale;
      return map;
    }



    void
    draw(Context &context, const Drawing &drawing, const std::string &name)
    {
      const std::string path = context.output.file("plots/" + name + ".png");
      context.plotter.draw(drawing, path.substr(0, path.size() - 4));
    }



    std::size_t
    worst_node(const HistoryDamage &damage)
    {
      std::size_t worst = 0;
      for (std::size_t k = 1; k < damage.nodes.size(); ++k)
        if (damage.nodes[k].damage.back() > damage.nodes[worst].damage.back())
          worst = k;
      return worst;
    }



    void
    draw_damage(Context &context, const Study &study, const Table &table)
    {
      const FatigueParameters &f = context.parameters.fatigue;
      std::vector<FaceMap>     maps;
      for (const double exponent : f.exponents)
        maps.push_back(map_of(table,
                              "damage_" + slope_name(exponent) + "_per_s",
                              "Damage, slope " + slope_name(exponent),
                              f.constants.empty() ? "index in 1/s" : "1/s",
                              1.,
                              true));
      draw(context, draw_maps(study.grid, maps), "damage_maps");
      draw(
        context,
        draw_maps(
          study.grid,
          {map_of(table, "peak_pressure_pa", "Peak pressure", "MPa", 1e-6),
           map_of(table,
                  "friction_power_w_per_m2",
                  "Friction power",
                  "kW/m^2",
                  1e-3),
           map_of(table, "contact_duty", "Duty of contact", "part"),
           map_of(table, "impacts_per_s", "Impacts", "1/s"),
           map_of(
             table, "impulse_per_impact_pa_s", "Impulse of an impact", "Pa s"),
           map_of(table, "stick_slip_per_s", "Stick-slip changes", "1/s")}),
        "surface_maps");
      const std::size_t      worst  = worst_node(study.damage);
      const RangeMeanMatrix &matrix = study.damage.matrices[worst];
      std::vector<double>    ranges, means;
      for (std::size_t i = 0; i < matrix.n_classes(); ++i)
        {
          ranges.push_back(matrix.range(i));
          means.push_back(matrix.mean(i));
        }
      draw(context,
           draw_matrix(ranges,
                       means,
                       matrix.values(),
                       "Cycles at node " + std::to_string(worst) +
                         ", where damage is largest"),
           "range_mean");
    }



    /** Largest and mean utilisation against depth, flagged points left out. */
    void
    draw_depths(Context &context, const Study &study)
    {
      const SubsurfaceParameters &p = context.parameters.subsurface;
      Chart                       chart;
      const bool                  has_limit = p.axial_limit > 0.;
      chart.title =
        has_limit ? "Largest value over its limit under the face"
                  : "Largest value over the reference stress (no limit given)";
      chart.x.label = "depth in um";
      chart.x.scale = AxisSettings::Scale::logarithmic;
      chart.y.label = has_limit ? "value / limit" : "value / reference stress";
      for (std::size_t c = 0; c < p.criteria.size(); ++c)
        {
          ChartSeries series;
          series.label = choice_name(p.criteria[c]);
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
      draw(context, draw_charts({chart}, 1100, 700), "depths");
    }



    double
    largest(const Table &table, const std::string &column)
    {
      double value = NAN;
      for (const double v : table.reals(column))
        if (!(v <= value))
          value = v;
      return value;
    }



    /** Totals over the face, one row for each history. */
    Table
    totals(const TribologyParameters        &p,
           const std::vector<const Study *> &studies)
    {
      Table table(
        {{"run", Table::Type::text, "", "history"},
         {"seconds", Table::Type::real, "s", "length", 5},
         {"mean_pressure_pa", Table::Type::real, "Pa", "over the face", 5},
         {"friction_power_w", Table::Type::real, "W", "over the face", 5},
         {"impacts_per_s", Table::Type::real, "1/s", "of all nodes", 5}});
      for (const double m : p.fatigue.exponents)
        table.add_column({"mean_damage_" + slope_name(m) + "_per_s",
                          Table::Type::real,
                          "1/s",
                          "area mean of the damage",
                          5});
      for (const Study *study : studies)
        {
          double area = 0., pressure = 0., power = 0., impacts = 0.;
          std::vector<double> damage(p.fatigue.exponents.size(), 0.);
          for (std::size_t k = 0; k < study->grid.n_nodes(); ++k)
            {
              const HistoryDamage::Node &node = study->damage.nodes[k];
              const double               a    = study->grid.area(k);
              const double               t    = node.surface.duration;
              area += a;
              pressure += a * node.surface.mean_pressure();
              power += a * node.surface.friction_energy / t;
              impacts += node.surface.impacts / t;
              for (std::size_t c = 0; c < damage.size(); ++c)
                damage[c] += a * node.damage[c] / study->damage.duration;
            }
          std::vector<Cell> row = {study == studies[0] ? "squealing" : "silent",
                                   study->damage.duration,
                                   pressure / area,
                                   power,
                                   impacts};
          for (const double d : damage)
            row.push_back(d / area);
          table.add_row(row);
        }
      return table;
    }



    const char *const in_a_block =
      "in a block that is free at its sides and held at its back: half-space "
      "kernels and what they lack, by finite elements. Points nearer to the "
      "rim of the face than two of the finest cells are flagged (near_edge) "
      "and left out of maxima.";

    const char *const in_a_half_space =
      "in a half-space. Points nearer to an edge than three depths are flagged "
      "(near_edge) and left out of maxima: a half-space has no edges. The "
      "deeper, the fewer nodes remain, which alone makes a step in the "
      "picture. 'Pad thickness' makes it a block.";



    /** What the cycles are of. */
    std::string
    counted_stress(const FatigueParameters &fatigue)
    {
      return fatigue.quantity == FatigueParameters::Quantity::pressure
               ? "normal stress, compression negative"
               : choice_name(fatigue.quantity);
    }



    void
    fill_report(HtmlReport    &report,
                const Context &context,
                const Table   &table,
                const Table   &sums,
                const bool     has_silent,
                const Study   &study)
    {
      const TribologyParameters &p        = context.parameters;
      const std::string          plots    = context.output.path() + "/plots/";
      const bool                 is_index = p.fatigue.constants.empty();
      report.section("What was done");
      report.list(
        {"The history " + p.history.file + " (" +
           std::to_string(study.damage.samples) + " samples, " +
           rounded_text(study.damage.duration, 4) + " s, " +
           std::to_string(study.grid.n_nodes()) +
           " contact nodes) was counted by rainflow (ASTM E1049, residue as " +
           choice_name(p.fatigue.residue) + ") at every node.",
         is_index
           ? "No constants of the material were given: damage is an INDEX, the "
             "sum of n (S_a / " +
               rounded_text(p.fatigue.reference_stress, 4) +
               " Pa)^m. It ranks places and runs; it says nothing about life. "
               "Several slopes stand side by side since nobody has published "
               "one "
               "for brake pads."
           : "Damage is that of the given S-N curves: 1 is failure.",
         "Per second means per second of this history; an application is " +
           rounded_text(p.fatigue.application_time, 4) + " s of it."});
      report.section("Damage");
      report.table(sums, "Over the whole face");
      report.figure(plots + "damage_maps.png",
                    "Damage seen from the disc; the leading edge is below.");
      report.figure(plots + "range_mean.png",
                    "Range-mean matrix of the node with the largest damage: "
                    "number of counted cycles of each range and mean of the " +
                      counted_stress(p.fatigue) +
                      ", both in MPa, a box for each class; white: none.",
                    true);
      if (has_silent)
        report.figure(
          plots + "ratio_maps.png",
          "Squealing over silent run, node by node; grey where the silent "
          "pad does not touch.");
      if (has_silent)
        report.paragraph(
          "The ratio has no scale of its own: it compares with what this "
          "silent run still vibrates, which depends on its disturbance and "
          "damping. Damage grows with a power of the range, so that half the "
          "silent vibration makes the ratio of slope m 2^m times larger.");
      report.section("Surface");
      report.figure(plots + "surface_maps.png",
                    "What works on third-body layers and edges: friction, "
                    "separation and impacts.");
      if (!study.subsurface.empty())
        {
          report.section("Below the face");
          report.paragraph(
            "Stresses under each node from the tractions of all nodes, over "
            "the last " +
            std::to_string(p.subsurface.n_samples) + " samples, " +
            (study.subsurface[0].is_in_block ? in_a_block : in_a_half_space) +
            (p.subsurface.axial_limit > 0.
               ? ""
               : " No fatigue limit was given: values are indices, relative to "
                 "Fatigue/Reference stress."));
          report.figure(plots + "depths.png",
                        "Largest value of each criterion against depth.");
        }
      report.section("Limits");
      report.list(
        {"Pressure at the edge of a pad is singular in theory: damage of "
         "single "
         "nodes there depends on the contact mesh. The columns 'averaged' use "
         "the stress averaged over " +
           rounded_text(1e3 * p.fatigue.averaging_length, 3) +
           " mm and may be compared between meshes finer than that.",
         "Plateau factor " + rounded_text(p.fatigue.plateau_factor, 3) +
           ": nodal pressures are multiplied by it; real contact spots carry "
           "more than the nodal mean.",
         "A spectral estimate (Dirlik) assumes a Gaussian process, which a "
         "limit "
         "cycle is not: the column dirlik_over_counting says how far off it "
         "is."});
      report.section("Nodes");
      report.table(table, "All nodes (damage.csv)", {}, {}, false);
    }
  } // namespace



  void
  run_damage(Context &context)
  {
    const TribologyParameters &p = context.parameters;
    prm::require_file(p.history.file, "History", "File", true);
    prm::require_file(p.history.silent_file, "History", "Silent file", false);
    Study                  study(p.history.file, p.history);
    std::unique_ptr<Study> silent;
    if (!p.history.silent_file.empty())
      {
        silent = std::make_unique<Study>(p.history.silent_file, p.history);
        require_same_nodes(study, *silent);
      }
    if (!study.grid.is_grid())
      context.log.warning("the contact nodes stand on no rectangular grid: "
                          "nodal cells are taken as squares");
    if (!study.grid.is_grid() && p.subsurface.pad_thickness > 0.)
      context.log.warning("stresses under the face are those of a half-space, "
                          "in spite of 'Pad thickness'");
    if (!study.reader.layout().has_slip_rate)
      context.log.warning("the history has no slip rate: friction power, wear "
                          "and stick-slip are 0");
    count(context, study, "squealing");
    if (silent)
      count(context, *silent, "silent");
    if (p.subsurface.compute)
      {
        Timers::Section section(context.timers, "Evaluate: subsurface");
        Progress progress(context.log, "subsurface", study.grid.n_nodes());
        study.subsurface = evaluate_subsurface(
          study.reader,
          study.window,
          p.subsurface,
          p.fatigue,
          study.grid,
          [&progress](const std::size_t n) { progress.advance(n); });
      }

    const Table table = damage_table(p,
                                     study.grid,
                                     study.damage,
                                     silent ? &silent->damage : nullptr,
                                     study.subsurface);
    context.write_table("damage.csv", table);
    std::vector<const Study *> studies = {&study};
    if (silent)
      studies.push_back(silent.get());
    const Table sums = totals(p, studies);
    context.write_table("totals.csv", sums);
    if (!study.subsurface.empty())
      context.write_table(
        "subsurface.csv",
        subsurface_table(p.subsurface, study.grid, study.subsurface));
    write_damage_hdf5(context.output.file("damage.h5"), table, study.damage);
    write_damage_vtu(context.output.file("damage.vtu"), table, study.grid);

    if (p.output.plots && context.plotter.is_available())
      {
        Timers::Section section(context.timers, "Write: plots");
        draw_damage(context, study, table);
        if (silent)
          {
            std::vector<FaceMap> maps;
            for (const double m : p.fatigue.exponents)
              maps.push_back(map_of(table,
                                    "ratio_damage_" + slope_name(m) + "_per_s",
                                    "Squealing over silent, " + slope_name(m),
                                    "ratio",
                                    1.,
                                    true));
            draw(context, draw_maps(study.grid, maps), "ratio_maps");
          }
        if (!study.subsurface.empty())
          draw_depths(context, study);
      }

    const std::string slope   = slope_name(p.fatigue.exponents.back());
    RunRecord::Pairs &figures = context.record.figures;
    figures                   = {
                        {"nodes", std::to_string(study.grid.n_nodes())},
                        {"samples", std::to_string(study.damage.samples)},
                        {"largest pressure in MPa",
                         rounded_text(1e-6 * largest(table, "peak_pressure_pa"), 4)},
                        {"largest damage per second, " + slope,
                         rounded_text(largest(table, "damage_" + slope + "_per_s"), 4)},
                        {"points kept by a counter", std::to_string(study.damage.deepest)}};
    std::string headline = "Damage of " + std::to_string(study.grid.n_nodes()) +
                           " nodes" +
                           (p.fatigue.constants.empty() ? " (index)" : "");
    if (silent)
      {
        std::vector<std::string> ratios;
        for (const double m : p.fatigue.exponents)
          {
            const std::string column =
              "mean_damage_" + slope_name(m) + "_per_s";
            const double quiet = sums.real(1, column);
            ratios.push_back(quiet > 0.
                               ? rounded_text(sums.real(0, column) / quiet, 3) +
                                   " (slope " + slope_name(m) + ")"
                               : "infinitely many (" + slope_name(m) + ")");
            figures.emplace_back(
              "squealing over silent, " + slope_name(m),
              ratios.back().substr(0, ratios.back().find(' ')));
          }
        headline += ": " + prm::join(ratios, ", ") + " times the silent run's";
      }
    HtmlReport report("Damage" + (p.name.empty() ? "" : " of " + p.name),
                      p.history.file);
    report.set_verdict(HtmlReport::Verdict::neutral, headline, figures);
    fill_report(report, context, table, sums, silent != nullptr, study);
    context.finish(p.output.report ? &report : nullptr, "damage.vtu");
  }
} // namespace squeal::tribology
