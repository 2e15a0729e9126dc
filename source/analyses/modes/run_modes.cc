// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/output/matrix_output.h>
#include <squeal/output/shape_output.h>

#include <squeal/analyses/analyses.h>
#include <squeal/base/exceptions.h>
#include <squeal/model/doublets.h>
#include <squeal/output/headline_error.h>
#include <squeal/output/moving_pictures.h>
#include <squeal/output/record_unknowns.h>
#include <squeal/results/plots.h>

#include <sstream>

namespace squeal
{
  void
  run_modes(RunContext &context)
  {
    const auto &p = context.parameters;
    Model       model(p, context.timers);
    model.print_summary(context.log);
    Table steps(
      {{"mesh", Table::Type::integer, "", "number of the mesh"},
       {"unknowns", Table::Type::integer, "", "free unknowns"},
       {"estimated_error_rel",
        Table::Type::real,
        "",
        "largest estimated relative frequency error in the band",
        3},
       {"cpu_seconds", Table::Type::real, "s", "since the start", 3}});
    ModeSolution solution =
      solve_modes_adaptively(model, context.log, context.timers, &steps);
    if (p.output.export_matrices)
      {
        write_matrices(context, *solution.pencil, "matrices");
        write_matrix_parts(context, model.linearized().system, "matrices");
      }
    const Table table = mode_table(model, solution);
    if (table.n_rows() == 0)
      refuse_empty_band(p, solution);
    if (const std::string free = free_motions(model, solution); !free.empty())
      context.log.warning(free + ": hold them by Scene/Supports or Scene/"
                                 "Springs if this is not meant");
    if (p.discretization.refinement ==
          DiscretizationParameters::Refinement::eigenvalue_error &&
        steps.n_rows() > 0)
      context.write_table("meshes.csv", steps);
    context.write_table("modes.csv", table);
    context.log.heading("Modes");
    if (model.namer().n_coordinates() > 0)
      context.log.info(explanation_of_names());
    std::ostringstream text;
    table.print(text, {"index", "frequency_hz", "name", "error_estimate_rel"});
    context.log.info(text.str());
    const std::string error =
      headline_error({error_of_column("mesh", table, "error_estimate_rel")});
    record_unknowns(model, context.record);
    context.record.figures = {
      {"modes in the band", std::to_string(table.n_rows())},
      {"largest error of a frequency, relative", error},
      {"unknowns", std::to_string(model.n_unknowns())}};

    HtmlReport report("Modes of " + p.scene.name, "undamped, frictionless");
    report.set_verdict(
      HtmlReport::Verdict::neutral,
      std::to_string(table.n_rows()) + " modes from " +
        rounded_text(table.real(0, "frequency_hz"), 5) + " to " +
        rounded_text(table.real(table.n_rows() - 1, "frequency_hz"), 5) +
        " Hz; largest error of a frequency: " + error,
      context.record.figures);
    report.section("Modes");
    report.table(table, "Modes in the band");
    if (model.namer().n_coordinates() > 0)
      report.paragraph(explanation_of_names());
    if (steps.n_rows() > 0)
      report.table(steps, "Meshes");

    const Table doublets = doublet_table(table);
    if (doublets.n_rows() > 0)
      {
        context.write_table("doublets.csv", doublets);
        report.section("Doublets of the disc");
        if (p.output.plots && context.is_root)
          {
            context.output.file("plots/doublets.png");
            const std::string path = context.output.path() + "/plots/doublets";
            context.plotter.draw(draw_charts({doublet_chart(doublets)}), path);
            report.figure(path + ".png", "What pad and support split", false);
          }
        report.table(doublets, "Doublets");
      }

    std::string open_this;
    if (p.output.shapes == OutputParameters::Shapes::all &&
        model.discretization() && model.discretization()->has_mesh())
      {
        Timers::Section section(context.timers, "Write: shapes");
        report.section("Shapes");
        show_modes(context, model, solution, report);
        open_this = write_mode_shapes(context, model, solution);
      }
    context.finish(p.output.report ? &report : nullptr, open_this);
  }
} // namespace squeal
