// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/driver/analyses.h>
#include <squeal/driver/cea_solution.h>
#include <squeal/results/plots.h>

#include <cmath>
#include <sstream>

namespace squeal
{
  namespace
  {
    using Ladder = WorkPrecisionParameters::Ladder;

    /** One setting of a ladder and what it gave. */
    struct Rung
    {
      Ladder                            ladder;
      double                            setting;
      unsigned int                      dofs;
      double                            seconds, memory;
      std::vector<std::complex<double>> values; /**< 1/s */
    };

    std::string
    ladder_name(const Ladder ladder)
    {
      switch (ladder)
        {
        case Ladder::degree:
          return "degree";
        case Ladder::refinement:
          return "refinement";
        case Ladder::adaptive:
          return "adaptive";
        case Ladder::basis:
          return "basis";
        }
      return "";
    }

    Parameters
    parameters_of(const Parameters &all,
                  const Ladder      ladder,
                  const double      value)
    {
      Parameters p                    = all;
      p.discretization.estimate_error = false;
      switch (ladder)
        {
        case Ladder::degree:
          p.discretization.degree = static_cast<unsigned int>(value);
          break;
        case Ladder::refinement:
          p.discretization.refinements = static_cast<unsigned int>(value);
          break;
        case Ladder::adaptive:
          p.discretization.refinement =
            DiscretizationParameters::Refinement::eigenvalue_error;
          p.discretization.tolerance = value;
          break;
        case Ladder::basis:
          p.eigen.residual_tolerance = p.eigen.error_tolerance = value;
          break;
        }
      return p;
    }

    Rung
    climb(RunContext &context, const Ladder ladder, const double value)
    {
      const Parameters p     = parameters_of(context.parameters, ladder, value);
      const double     start = cpu_seconds();
      context.log.info(ladder_name(ladder) + " = " + rounded_text(value, 6));
      Model              model(p, context.timers);
      const ModeSolution modes =
        solve_modes_adaptively(model, context.log, context.timers);
      Rung rung{ladder, value, model.n_unknowns(), 0., 0., {}};
      if (p.work_precision.quantity == "sigma" || ladder == Ladder::basis)
        {
          const CeaSolution cea =
            solve_cea(model, modes, context.log, context.timers);
          for (unsigned int i = 0; i < cea.pairs.size(); ++i)
            rung.values.push_back(cea.pairs.lambda[i]);
        }
      else
        for (unsigned int i = 0; i < modes.n_up_to(p.eigen.highest_frequency);
             ++i)
          if (modes.modes.frequency(i) >= p.eigen.lowest_frequency)
            rung.values.emplace_back(0., 2. * M_PI * modes.modes.frequency(i));
      rung.seconds = cpu_seconds() - start;
      rung.memory  = peak_memory_mb();
      return rung;
    }

    /** Largest relative distance of a reference value to the nearest one. */
    double
    worst_error(const std::vector<std::complex<double>> &values,
                const std::vector<std::complex<double>> &reference)
    {
      double worst = 0.;
      for (const auto &r : reference)
        {
          double distance = 1e300;
          for (const auto &v : values)
            distance = std::min(distance, std::abs(v - r));
          worst = std::max(worst, distance / std::abs(r));
        }
      return worst;
    }
  } // namespace



  void
  run_work_precision(RunContext &context)
  {
    const auto       &p = context.parameters.work_precision;
    std::vector<Rung> rungs;
    for (const Ladder ladder : p.ladders)
      for (const double value : p.values)
        rungs.push_back(climb(context, ladder, value));
    if (rungs.empty() || rungs.back().values.empty())
      throw InputError(
        "Work precision/Values: the ladder gave no values in the "
        "band");

    std::vector<std::complex<double>> reference;
    for (const double f : p.reference)
      reference.emplace_back(0., 2. * M_PI * f);
    const Rung *finest = nullptr;
    if (reference.empty())
      {
        // The costliest rung stands for the truth and is not shown.
        for (const Rung &rung : rungs)
          if (!finest || rung.seconds > finest->seconds)
            finest = &rung;
        reference = finest->values;
      }
    using Type = Table::Type;
    Table table(
      {{"setting", Type::text, "", "ladder and value"},
       {"dofs", Type::integer, "", "unknowns"},
       {"seconds", Type::real, "s", "CPU time", 3},
       {"peak_memory_mb", Type::real, "MB", "of the process so far", 4},
       {"quantity", Type::text, "", "what is measured"},
       {"value", Type::real, "Hz", "first value of the band", 7},
       {"error_rel", Type::real, "", "largest relative error", 3},
       {"reference", Type::text, "", "what it is measured against"}});
    std::vector<WorkPrecisionSeries> series;
    for (const Rung &rung : rungs)
      {
        const std::string name  = ladder_name(rung.ladder);
        const double      error = worst_error(rung.values, reference);
        table.add_row({name + " = " + rounded_text(rung.setting, 6),
                       rung.dofs,
                       rung.seconds,
                       rung.memory,
                       p.quantity,
                       rung.values.empty()
                         ? Cell()
                         : Cell(rung.values[0].imag() / (2. * M_PI)),
                       error,
                       finest ? "costliest rung" : "given values"});
        if (&rung == finest)
          continue;
        if (series.empty() || series.back().label != name)
          series.push_back({name, {}, {}, {}, {}});
        series.back().seconds.push_back(rung.seconds);
        series.back().dofs.push_back(rung.dofs);
        series.back().errors.push_back(error);
        series.back().settings.push_back(rounded_text(rung.setting, 3));
      }
    context.write_table("work_precision.csv", table);
    std::ostringstream text;
    table.print(text);
    context.log.info(text.str());

    HtmlReport report("Work and precision of " + context.parameters.scene.name,
                      "error against cost");
    report.section("Ladder");
    report.table(table, "Settings");
    if (context.is_root && context.parameters.output.plots)
      {
        context.output.file("plots/work_precision.png");
        const std::string path =
          context.output.path() + "/plots/work_precision";
        plot_work_precision(context.plotter,
                            series,
                            context.parameters.discretization.tolerance,
                            path);
        report.figure(path + ".png", "Error against work");
      }
    context.finish(context.parameters.output.report ? &report : nullptr, "");
  }
} // namespace squeal
