// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/analyses/analyses.h>
#include <squeal/analyses/sweep/sweep_scenes.h>
#include <squeal/analyses/sweep/sweep_solution.h>
#include <squeal/base/worst_of.h>
#include <squeal/model/cea_solution.h>
#include <squeal/output/headline_error.h>
#include <squeal/output/headlines.h>
#include <squeal/output/open_signs.h>
#include <squeal/output/record_unknowns.h>
#include <squeal/sweep/sweep_grid.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace squeal
{
  namespace
  {
    /** The tables of one scene, or of all of them below each other. */
    struct SweepTables
    {
      Table eigenvalues, ranges, coalescences, boundary, influence, suggestions,
        probabilities, drivers, checks, comparison, doublets;

      template <typename Function>
      void
      for_each(const Function &function)
      {
        function("eigenvalues.csv", eigenvalues);
        function("unstable_ranges.csv", ranges);
        function("exceptional_points.csv", coalescences);
        function("boundary.csv", boundary);
        function("sensitivities.csv", influence);
        function("suggestions.csv", suggestions);
        function("scatter.csv", probabilities);
        function("scatter_drivers.csv", drivers);
        function("direct_check.csv", checks);
        function("comparison.csv", comparison);
        function("doublets.csv", doublets);
      }
    };

    /** What the summary says of all scenes together. */
    struct Totals
    {
      std::size_t  n_points = 0, n_solved = 0;
      WorstError   worst;
      unsigned int n_lines = 0, n_unstable_lines = 0, n_vectors = 0,
                   largest_basis = 0, n_reused = 0, n_factors = 0;
      bool is_meshed = false; /**< growth rates have errors by it */
    };

    SweepTables
    tables_of(SweepModel              &model,
              const SweepSolution     &solution,
              std::vector<ChartGroup> &charts,
              RunContext              &context)
    {
      const SweepParameters &s = context.parameters.sweep;
      SweepTables            t;
      {
        Timers::Section section(context.timers, "Write: tables");
        t.eigenvalues = sweep_eigenvalue_table(model, solution);
      }
      t.ranges   = unstable_range_table(model, solution);
      t.doublets = doublet_table(model, solution, t.eigenvalues);
      if (s.exceptional_points)
        t.coalescences = exceptional_point_table(model, solution);
      if (s.boundary_tolerance > 0.)
        {
          t.boundary = boundary_table(model, solution, context);
          charts.push_back({"boundary",
                            "Boundary of the unstable regions",
                            {boundary_chart(model, t.boundary)}});
        }
      if (!s.sensitivities.empty())
        t.influence = sensitivity_table(model, solution, context);
      if (s.suggestions > 0)
        t.suggestions = suggestion_table(model, solution, context);
      if (s.scatter_samples > 0)
        {
          ScatterTables scatter = scatter_tables(model, context);
          t.probabilities       = scatter.probabilities;
          t.drivers             = scatter.drivers;
          charts.push_back({"scatter",
                            "Probability of squeal along every axis",
                            scatter.charts});
        }
      if (s.direct_checks > 0)
        t.checks = direct_check_table(model, solution, context);
      if (s.compare)
        t.comparison = comparison_table(model, solution, context);
      return t;
    }

    /** Makes the tables that name axes once without rows: an axis that is
     * called like one of their columns is refused before the solution. */
    void
    check_column_names(SweepModel &model, const SweepScene &scene)
    {
      const SweepSolution nothing;
      for (Table table : {sweep_eigenvalue_table(model, nothing),
                          unstable_range_table(model, nothing)})
        scene.enter(table);
    }

    void
    add(const SweepModel &model, const SweepSolution &solution, Totals &totals)
    {
      totals.n_points += model.grid().n_points();
      totals.n_solved += solution.n_solved;
      totals.worst.frequency =
        worst_of(totals.worst.frequency, solution.worst.frequency);
      totals.worst.sigma = worst_of(totals.worst.sigma, solution.worst.sigma);
      totals.n_vectors = std::max(totals.n_vectors, model.reduced().n_total());
      totals.largest_basis = std::max<unsigned int>(
        totals.largest_basis, model.reduced().largest_basis());
      totals.n_reused += model.is_reused();
      totals.n_factors += model.n_factors();
      totals.is_meshed = totals.is_meshed || has_mesh_error(model.model());
      for (const auto &line : solution.lines)
        {
          ++totals.n_lines;
          totals.n_unstable_lines += !line.ranges.empty();
        }
    }

    std::string
    verdict(const std::string &axis, const std::size_t n, const Totals &totals)
    {
      if (n == 0)
        return "no unstable range of " + axis +
               (totals.is_meshed
                  ? std::string(" on this mesh; ") + growth_error_unknown
                  : "");
      return std::to_string(n) +
             (n == 1 ? " unstable range of " : " unstable ranges of ") + axis +
             " on " + std::to_string(totals.n_unstable_lines) + " of " +
             std::to_string(totals.n_lines) +
             (totals.n_lines == 1 ? " line" : " lines");
    }

    /** Of the edges between points, in the coordinate of the axis; ends of the
     * sweep have no error. */
    std::string
    error_of_edges(const Table &ranges, const SweepAxisParameters &axis)
    {
      const std::string unit =
        axis.scale == SweepAxisParameters::Scale::logarithmic
          ? " decades"
          : " in " + axis.name;
      std::vector<ErrorSource> sources;
      for (const char *column :
           {"lower_error_reduction", "upper_error_reduction"})
        if (const auto source = error_of_column("reduction", ranges, column);
            !std::isnan(source.second))
          sources.emplace_back("reduction", source.second);
      if (sources.empty())
        return "no edge";
      for (const char *column : {"lower_error_contact", "upper_error_contact"})
        if (const double error = error_of_column("", ranges, column).second;
            error > 0.)
          sources.emplace_back("contact state between points", error);
      sources.push_back(
        error_of_column("mesh", ranges, "edge_error_discretisation"));
      return headline_error(sources, unit);
    }

    std::string
    error_of_frequencies(const SweepTables &tables, const Totals &totals)
    {
      return headline_error({{"reduction", totals.worst.frequency},
                             error_of_column("mesh",
                                             tables.eigenvalues,
                                             "discretisation_error_rel")});
    }

    /** Every axis, the one that is swept first. */
    SweepParameters
    all_axes(const std::vector<SweepScene> &scenes, const Parameters &p)
    {
      SweepParameters sweep = scenes.front().parameters.sweep;
      for (const auto &axis : p.sweep.axes)
        if (std::none_of(sweep.axes.begin(),
                         sweep.axes.end(),
                         [&](const auto &a) { return a.name == axis.name; }))
          sweep.axes.push_back(axis);
      return sweep;
    }

    /** The answer to what the sweep was asked most of all. */
    std::string
    headline(const std::vector<SweepScene> &scenes,
             const SweepTables             &all,
             const Totals                  &totals,
             const Parameters              &p)
    {
      if (all.probabilities.n_rows())
        return scatter_headline(all.probabilities);
      const SweepParameters sweep = all_axes(scenes, p);
      const std::string     ranges =
        verdict(sweep.axes[0].name, all.ranges.n_rows(), totals);
      if (all.suggestions.n_rows())
        return suggestion_headline(all.suggestions, p.scene) + "; " + ranges;
      const std::string where =
        range_headline(all.ranges, sweep, p.scene, totals.is_meshed);
      if (all.ranges.n_rows() == 0)
        return where + "; largest error of a frequency, relative: " +
               error_of_frequencies(all, totals);
      return where + "; " + ranges + "; largest error of an edge: " +
             error_of_edges(all.ranges, sweep.axes[0]);
    }

    void
    print(RunContext                       &context,
          const std::string                &heading,
          const std::vector<const Table *> &tables)
    {
      std::ostringstream text;
      for (const Table *table : tables)
        table->print(text);
      context.log.heading(heading);
      context.log.info(text.str());
    }

    void
    enter_figures(RunContext                    &context,
                  const std::vector<SweepScene> &scenes,
                  const SweepTables             &tables,
                  const Totals                  &totals)
    {
      const SweepParameters sweep = all_axes(scenes, context.parameters);
      context.record.figures.insert(
        context.record.figures.begin(),
        {{"unstable ranges", std::to_string(tables.ranges.n_rows())},
         {"points", std::to_string(totals.n_points)},
         {"solutions, edges and tracking included",
          std::to_string(totals.n_solved)},
         {"largest error of a frequency, relative",
          error_of_frequencies(tables, totals)},
         {"largest error of an edge",
          error_of_edges(tables.ranges, sweep.axes[0])},
         {"worst estimated frequency error of the reduction, relative",
          rounded_text(totals.worst.frequency, 2)},
         {"worst estimated sigma error of the reduction",
          rounded_text(totals.worst.sigma, 2) + " 1/s"},
         {"completeness",
          "inertia, all undamped modes of the band at " +
            std::to_string(totals.n_factors) + " of the points"},
         {"unknowns", std::to_string(context.record.n_dofs)},
         {"common basis", std::to_string(totals.n_vectors)},
         {"largest basis of a cell", std::to_string(totals.largest_basis)},
         {"basis",
          totals.n_reused == scenes.size() ? "of an earlier run"
          : totals.n_reused == 0           ? "built in this run"
                                           : "of an earlier run in part"},
         {"CPU seconds until here",
          rounded_text(context.timers.total_cpu(), 3)}});
      if (const std::string below =
            text_unseen_below_band(context.parameters.eigen);
          !below.empty())
        context.record.figures.push_back({"below the band", below});
      if (scenes.size() > 1)
        context.record.figures.insert(
          context.record.figures.begin(),
          {"scenes", std::to_string(scenes.size())});
    }

    void
    write_report(RunContext  &context,
                 HtmlReport  &report,
                 SweepTables &t,
                 const bool   has_shapes)
    {
      report.section("Unstable ranges");
      report.table(t.ranges, "Ranges of the first axis with sigma > 0");
      if (has_shapes)
        report.paragraph(explanation_of_names());
      if (t.doublets.n_rows())
        {
          report.section("Doublets of the disc");
          report.table(t.doublets, "Which member of each doublet squeals");
        }
      if (t.influence.n_rows() || t.suggestions.n_rows())
        report.section("What to change");
      if (t.suggestions.n_rows())
        report.table(t.suggestions, "Changes that stop the worst pairs");
      if (t.influence.n_rows())
        report.table(t.influence, "Influence on the unstable pairs");
      if (t.probabilities.n_rows())
        {
          report.section("Scatter");
          report.table(t.probabilities, "Probability of squeal");
          report.table(t.drivers, "What decides it");
        }
      if (t.coalescences.n_rows())
        {
          report.section("Lock-in and lock-out");
          report.table(t.coalescences, "Exceptional points");
        }
      context.finish(context.parameters.output.report ? &report : nullptr, "");
    }
  } // namespace



  void
  run_sweep(RunContext &context)
  {
    const auto                   &p      = context.parameters;
    const std::vector<SweepScene> scenes = sweep_scenes(p);
    HtmlReport                    report("Parameter sweep of " + p.scene.name,
                      "lambda = sigma + i omega, sigma > 0 unstable");
    SweepTables                   all;
    Totals                        totals;
    bool                          has_shapes = false;
    Block                         vectors;
    if (p.output.plots)
      report.section("Charts");
    for (std::size_t k = 0; k < scenes.size(); ++k)
      {
        const SweepScene &scene = scenes[k];
        if (scenes.size() > 1)
          context.log.heading(scene.title());
        SweepModel model(
          context, scenes, k, scenes.size() > 1 ? &vectors : nullptr);
        check_column_names(model, scene);
        const SweepSolution solution = solve_sweep(model, context);
        warn_of_doubts(model, solution, context);
        add(model, solution, totals);
        has_shapes = model.model().namer().n_coordinates() > 0;
        if (model.model().n_unknowns() > context.record.n_dofs)
          record_unknowns(model.model(), context.record);
        std::vector<ChartGroup> charts;
        SweepTables own = tables_of(model, solution, charts, context);
        if (p.output.plots)
          {
            Timers::Section section(context.timers, "Write: charts");
            draw_sweep(model,
                       solution,
                       charts,
                       scene.name,
                       scene.title(),
                       context,
                       report);
          }
        std::vector<Table *> sums;
        all.for_each([&](const char *, Table &sum) { sums.push_back(&sum); });
        std::size_t i = 0;
        own.for_each([&](const char *, Table &table) {
          scene.enter(table);
          sums[i++]->append(table);
        });
      }
    all.for_each([&](const std::string &name, const Table &table) {
      if (table.columns().size() > scenes[0].columns.size())
        context.write_table(name, table);
    });
    if (has_shapes)
      context.log.info(explanation_of_names());
    if (all.suggestions.n_rows())
      print(context, "Changes that stop squeal", {&all.suggestions});
    if (all.probabilities.n_rows())
      print(
        context, "Probability of squeal", {&all.probabilities, &all.drivers});
    print(context, "Unstable ranges (sigma > 0)", {&all.ranges});
    enter_figures(context, scenes, all, totals);
    report.set_verdict(all.ranges.n_rows() ? HtmlReport::Verdict::bad
                       : totals.is_meshed  ? HtmlReport::Verdict::neutral
                                           : HtmlReport::Verdict::good,
                       headline(scenes, all, totals, p),
                       context.record.figures);
    write_report(context, report, all, has_shapes);
  }
} // namespace squeal
