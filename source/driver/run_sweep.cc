// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/driver/analyses.h>
#include <squeal/driver/sweep_solution.h>

#include <algorithm>
#include <sstream>

namespace squeal
{
  namespace
  {
    std::string
    verdict(const SweepModel &model, const SweepSolution &solution)
    {
      unsigned int n_lines = 0, n_ranges = 0;
      double       peak = 0.;
      for (const auto &line : solution.lines)
        {
          n_lines += !line.ranges.empty();
          n_ranges += line.ranges.size();
          for (const auto &range : line.ranges)
            peak = std::max(peak, range.peak_sigma);
        }
      if (n_ranges == 0)
        return "no unstable range of " + model.grid().axis(0).name;
      return std::to_string(n_ranges) +
             (n_ranges == 1 ? " unstable range of " : " unstable ranges of ") +
             model.grid().axis(0).name + " on " + std::to_string(n_lines) +
             " of " + std::to_string(solution.lines.size()) +
             (solution.lines.size() == 1 ? " line" : " lines") +
             ", largest sigma " + rounded_text(peak, 4) + " 1/s";
    }
  } // namespace



  void
  run_sweep(RunContext &context)
  {
    const auto         &p = context.parameters;
    SweepModel          model(context);
    const SweepSolution solution = solve_sweep(model, context);

    Table table;
    {
      Timers::Section section(context.timers, "Write: tables");
      table = sweep_eigenvalue_table(model, solution);
      context.write_table("eigenvalues.csv", table);
    }
    const Table ranges = unstable_range_table(model, solution);
    context.write_table("unstable_ranges.csv", ranges);
    const Table coalescences = exceptional_point_table(model, solution);
    if (p.sweep.exceptional_points)
      context.write_table("exceptional_points.csv", coalescences);
    if (p.sweep.boundary_tolerance > 0.)
      context.write_table("boundary.csv",
                          boundary_table(model, solution, context));
    Table influence;
    if (!p.sweep.sensitivities.empty())
      {
        influence = sensitivity_table(model, solution, context);
        context.write_table("sensitivities.csv", influence);
      }
    ScatterTables scatter;
    if (p.sweep.scatter_samples > 0)
      {
        scatter = scatter_tables(model, context);
        context.write_table("scatter.csv", scatter.probabilities);
        context.write_table("scatter_drivers.csv", scatter.drivers);
        std::ostringstream shares;
        scatter.probabilities.print(shares);
        scatter.drivers.print(shares);
        context.log.heading("Probability of squeal");
        context.log.info(shares.str());
      }
    if (p.sweep.direct_checks > 0)
      context.write_table("direct_check.csv",
                          direct_check_table(model, solution, context));
    if (p.sweep.compare)
      context.write_table("comparison.csv",
                          comparison_table(model, solution, context));

    context.log.heading("Unstable ranges (sigma > 0)");
    std::ostringstream text;
    ranges.print(text);
    context.log.info(text.str());
    const auto &worst     = solution.worst;
    context.record.n_dofs = model.model().n_unknowns();
    context.record.figures.insert(
      context.record.figures.begin(),
      {{"unstable ranges", std::to_string(ranges.n_rows())},
       {"points", std::to_string(model.grid().n_points())},
       {"solutions, edges and tracking included",
        std::to_string(solution.n_solved)},
       {"worst estimated frequency error, relative",
        rounded_text(worst.frequency, 2)},
       {"worst estimated sigma error", rounded_text(worst.sigma, 2) + " 1/s"},
       {"unknowns", std::to_string(model.model().n_unknowns())},
       {"common basis", std::to_string(model.reduced().n_total())},
       {"largest basis of a cell",
        std::to_string(model.reduced().largest_basis())},
       {"basis", model.is_reused() ? "of an earlier run" : "built in this run"},
       {"CPU seconds until here",
        rounded_text(context.timers.total_cpu(), 3)}});

    HtmlReport report("Parameter sweep of " + p.scene.name,
                      "lambda = sigma + i omega, sigma > 0 unstable");
    report.set_verdict(ranges.n_rows() ? HtmlReport::Verdict::bad
                                       : HtmlReport::Verdict::good,
                       verdict(model, solution),
                       context.record.figures);
    if (p.output.plots)
      {
        Timers::Section section(context.timers, "Write: charts");
        draw_sweep(model, solution, scatter.charts, context, report);
      }
    report.section("Unstable ranges");
    report.table(ranges, "Ranges of the first axis with sigma > 0");
    if (influence.n_rows())
      {
        report.section("What to change");
        report.table(influence, "Influence on the unstable pairs");
      }
    if (!scatter.charts.empty())
      {
        report.section("Scatter");
        report.table(scatter.probabilities, "Probability of squeal");
        report.table(scatter.drivers, "What decides it");
      }
    if (coalescences.n_rows())
      {
        report.section("Lock-in and lock-out");
        report.table(coalescences, "Exceptional points");
      }
    context.finish(p.output.report ? &report : nullptr, "");
  }
} // namespace squeal
