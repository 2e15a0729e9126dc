// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/output/matrix_output.h>

#include <squeal/analyses/analyses.h>
#include <squeal/analyses/work_precision/figure_ladders.h>
#include <squeal/analyses/work_precision/ladder.h>
#include <squeal/base/assignment.h>
#include <squeal/base/exceptions.h>
#include <squeal/base/worst_of.h>
#include <squeal/model/cea_solution.h>
#include <squeal/output/headline_error.h>
#include <squeal/output/headlines.h>
#include <squeal/parameters/checks.h>
#include <squeal/parameters/choices.h>
#include <squeal/results/cost_at_error.h>
#include <squeal/results/plots.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>

namespace squeal
{
  namespace
  {
    using Ladder = WorkPrecisionParameters::Ladder;

    /** CPU seconds of the stages of an analysis; names, energies and error
     * estimates of the mesh are in none of them. */
    struct Stages
    {
      double assembly = 0., factor = 0., modes = 0., pairs = 0.;
    };

    /** One setting of a ladder and what it gave. */
    struct Rung
    {
      Ladder                            ladder;
      double                            setting;
      unsigned int                      dofs;
      double                            seconds = 0., memory = 0.;
      Stages                            stages   = {};
      double                            residual = 0.; /**< largest */
      std::vector<std::complex<double>> values   = {}; /**< 1/s */
      std::string                       matrices = {}; /**< their folder */
    };

    Stages
    stages_so_far(const Timers &timers)
    {
      Stages stages;
      for (const Timers::Entry &entry : timers.entries())
        if (entry.name == "Setup: mesh and unknowns" ||
            entry.name == "Setup: import of matrices" ||
            entry.name.rfind("Assemble: ", 0) == 0)
          stages.assembly += entry.own_cpu;
        else if (entry.name == "Solve: factorisation")
          stages.factor += entry.own_cpu;
        else if (entry.name == "Solve: undamped modes")
          stages.modes += entry.own_cpu;
        else if (entry.name == "Solve: certified eigenvalues" ||
                 entry.name == "Solve: direct eigenvalues")
          stages.pairs += entry.own_cpu;
      return stages;
    }

    /** Matrices and pairs of a rung in a folder of its own: meshes of two
     * ladders may have as many unknowns, and one mesh has pairs from several
     * bases. */
    void
    write_problem(RunContext         &context,
                  const Pencil       &pencil,
                  const ComplexPairs *pairs,
                  Rung               &rung)
    {
      rung.matrices = "matrices_" + choice_name(rung.ladder) + "_" +
                      prm::format_number(rung.setting);
      std::replace(rung.matrices.begin(), rung.matrices.end(), ' ', '_');
      write_matrices(context, pencil, rung.matrices);
      if (pairs)
        write_eigenpairs(context, *pencil.space(), *pairs, rung.matrices);
    }

    /** Whether rungs give complex pairs instead of undamped modes: frequencies
     * are those of one kind on all of them, and the basis is one of pairs. */
    bool
    are_of_pairs(const WorkPrecisionParameters &p)
    {
      return p.quantity != "frequency" ||
             std::find(p.ladders.begin(), p.ladders.end(), Ladder::basis) !=
               p.ladders.end();
    }

    Rung
    climb(RunContext &context, const Ladder ladder, const double value)
    {
      const Parameters p =
        parameters_of_rung(context.parameters, ladder, value);
      const Stages before = stages_so_far(context.timers);
      const double start  = cpu_seconds();
      context.log.info(setting_text(ladder, value));
      Model        model(p, context.timers);
      ModeSolution modes =
        solve_modes_adaptively(model, context.log, context.timers);
      Rung                       rung{ladder, value, model.n_unknowns()};
      std::optional<CeaSolution> cea;
      if (are_of_pairs(p.work_precision))
        {
          cea = solve_cea(model, modes, context.log, context.timers);
          warn_of_growth_left_out(
            *cea, setting_text(ladder, value) + ": ", context.log);
          for (unsigned int i = 0; i < cea->pairs.size(); ++i)
            {
              rung.values.push_back(cea->pairs.lambda[i]);
              rung.residual = worst_of(rung.residual, cea->pairs.residual[i]);
            }
        }
      else
        for (unsigned int i = 0; i < modes.n_up_to(p.eigen.highest_frequency);
             ++i)
          if (modes.modes.frequency(i) >= p.eigen.lowest_frequency)
            {
              rung.values.emplace_back(0.,
                                       2. * M_PI * modes.modes.frequency(i));
              rung.residual = worst_of(rung.residual, modes.modes.residual[i]);
            }
      rung.seconds       = cpu_seconds() - start;
      rung.memory        = peak_memory_mb();
      const Stages after = stages_so_far(context.timers);
      rung.stages        = {after.assembly - before.assembly,
                            after.factor - before.factor,
                            after.modes - before.modes,
                            after.pairs - before.pairs};
      // After the clock was read, and the memory.
      if (p.output.export_matrices)
        write_problem(
          context, *modes.pencil, cea ? &cea->pairs : nullptr, rung);
      return rung;
    }

    /** What errors are of: the real or the imaginary parts of eigenvalues, or
     * of given numbers of the same kind, or eigenvalues as a whole. */
    class Measure
    {
    public:
      Measure(const std::string                       &quantity,
              const std::vector<double>               &given,
              const std::vector<std::complex<double>> &finest)
        : is_of_sigma(quantity == "sigma")
        , is_of_both(quantity == "eigenvalue")
        , is_given(!given.empty())
        , reference(finest)
      {
        for (const double x : given)
          reference.push_back(is_of_sigma
                                ? std::complex<double>(x, 0.)
                                : std::complex<double>(0., 2. * M_PI * x));
        for (const auto &r : reference)
          largest = worst_of(largest, size(r));
        if (!(largest > 0.))
          throw InputError("Work precision/Reference: all values are 0, which "
                           "errors cannot be relative to");
      }

      /** The largest error of @p values: of real parts, which may be 0, over
       * the largest one in size, else each over its own. Values are assigned
       * one to one by their distance in the complex plane or, of given numbers,
       * by that of the parts; where there are fewer values than references to
       * the nearest one. */
      double
      worst_error(const std::vector<std::complex<double>> &values) const
      {
        if (values.empty())
          return 1.;
        std::vector<std::vector<double>> distances;
        for (const auto &r : reference)
          {
            distances.emplace_back();
            for (const auto &v : values)
              // Squares keep the order where distances to both are as long.
              distances.back().push_back(is_given ? std::pow(size(v - r), 2)
                                                  : std::norm(v - r));
          }
        const std::vector<int> partner = smallest_assignment(distances);
        double                 worst   = 0.;
        for (std::size_t k = 0; k < reference.size(); ++k)
          {
            const auto &d = distances[k];
            const auto  to =
              partner[k] >= 0
                 ? partner[k]
                 : std::min_element(d.begin(), d.end()) - d.begin();
            worst = worst_of(worst,
                             size(values[to] - reference[k]) /
                               (is_of_sigma ? largest : size(reference[k])));
          }
        return worst;
      }

    private:
      double
      size(const std::complex<double> &x) const
      {
        return is_of_both    ? std::abs(x)
               : is_of_sigma ? std::abs(x.real())
                             : std::abs(x.imag());
      }

      const bool                        is_of_sigma, is_of_both, is_given;
      std::vector<std::complex<double>> reference;
      double                            largest = 0.;
    };

    /** The rung that stands for the truth: most unknowns, of as many the
     * smallest tolerance of the basis. */
    const Rung &
    finest_of(const std::vector<Rung> &rungs)
    {
      const auto tolerance = [](const Rung &rung) {
        return rung.ladder == Ladder::basis ? rung.setting : 1.;
      };
      return *std::max_element(
        rungs.begin(), rungs.end(), [&](const Rung &a, const Rung &b) {
          return a.dofs != b.dofs ? a.dofs < b.dofs
                                  : tolerance(a) > tolerance(b);
        });
    }

    /** A rung with the mesh of the one that stands for the truth: the error of
     * that mesh, which they share, is in neither. */
    bool
    shares_mesh(const Rung &rung, const Rung *finest)
    {
      return finest && rung.ladder != Ladder::basis &&
             rung.dofs == finest->dofs;
    }

    /** What the error of @p rung is against. */
    std::string
    reference_of(const Rung &rung, const Rung *finest)
    {
      return !finest                     ? "given values"
             : &rung == finest           ? "itself"
             : shares_mesh(rung, finest) ? "finest rung, same mesh"
                                         : "finest rung";
    }

    /** Given numbers stand for values of the band, each for one of its own.
     * Throws InputError where the finest rung has fewer values than there are
     * numbers; rungs of which some values are compared with nothing, as the
     * second ones of doublets may be, are named in the log. */
    void
    check_reference(const std::size_t        n_given,
                    const std::vector<Rung> &rungs,
                    RunLog                  &log)
    {
      const Rung &finest = finest_of(rungs);
      if (finest.values.size() < n_given)
        prm::refuse_entry(
          "Work precision",
          "Reference",
          "there are " + std::to_string(n_given) +
            " numbers, but the finest rung (" +
            setting_text(finest.ladder, finest.setting) + ") has " +
            std::to_string(finest.values.size()) +
            " values between the frequencies of 'Eigenvalues': give at "
            "most one number for each of them");
      for (const Rung &rung : rungs)
        if (rung.values.size() != n_given)
          log.warning(setting_text(rung.ladder, rung.setting) + ": " +
                      std::to_string(rung.values.size()) +
                      " values in the band and " + std::to_string(n_given) +
                      " numbers of 'Work precision/Reference'; its error is "
                      "right only if each number has its value in the band, "
                      "and says nothing of the others");
    }

    /** What each ladder must spend for the error @p goal, and the same as
     * sentences for the log. */
    Table
    cost_table(const std::vector<WorkPrecisionSeries> &series,
               const double                            goal,
               RunLog                                 &log)
    {
      using Type = Table::Type;
      Table table(
        {{"ladder", Type::text, "", "ladder"},
         {"error_rel", Type::real, "", "error to be reached", 3},
         {"dofs", Type::real, "", "unknowns it takes", 3},
         {"dofs_over_least", Type::real, "", "over the best ladder's", 3},
         {"seconds", Type::real, "s", "CPU time it takes", 3},
         {"seconds_over_least", Type::real, "", "over the best ladder's", 3},
         {"found", Type::text, "", "between rungs or beyond the finest"}});
      std::vector<std::optional<CostAtError>> dofs, seconds;
      double least_dofs = 1e300, least_seconds = 1e300;
      for (const WorkPrecisionSeries &s : series)
        {
          dofs.push_back(cost_at_error(s.dofs, s.errors, goal));
          seconds.push_back(cost_at_error(s.seconds, s.errors, goal));
          if (dofs.back())
            least_dofs = std::min(least_dofs, dofs.back()->cost);
          if (seconds.back())
            least_seconds = std::min(least_seconds, seconds.back()->cost);
        }
      for (std::size_t i = 0; i < series.size(); ++i)
        {
          const auto cell = [](const auto &cost, const double over) {
            return cost ? Cell(cost->cost / over) : Cell();
          };
          const std::vector<double> &errors = series[i].errors;
          // A cost of the least rung or less, which is only a bound.
          const bool is_bounded =
            !errors.empty() &&
            std::all_of(errors.begin(), errors.end(), [goal](const double e) {
              return e <= goal;
            });
          const std::string found = is_bounded              ? "by every rung"
                                    : !dofs[i]              ? "not found"
                                    : dofs[i]->extrapolated ? "extrapolated"
                                                            : "interpolated";
          table.add_row({series[i].label,
                         goal,
                         cell(dofs[i], 1.),
                         cell(dofs[i], least_dofs),
                         cell(seconds[i], 1.),
                         cell(seconds[i], least_seconds),
                         found});
          if (dofs[i])
            log.info(
              "an error of " + rounded_text(100. * goal, 3) + " % takes " +
              rounded_text(dofs[i]->cost, 3) + " unknowns with the ladder '" +
              series[i].label + "' (" + found + "), " +
              rounded_text(dofs[i]->cost / least_dofs, 3) + " times the least");
        }
      return table;
    }

    Table
    empty_table()
    {
      using Type = Table::Type;
      return Table(
        {{"setting", Type::text, "", "ladder and value"},
         {"dofs", Type::integer, "", "unknowns"},
         {"seconds", Type::real, "s", "CPU time", 3},
         {"peak_memory_mb", Type::real, "MB", "of the process so far", 4},
         {"quantity", Type::text, "", "what is measured"},
         {"value", Type::real, "Hz", "first value of the band", 7},
         {"error_rel", Type::real, "", "largest relative error", 3},
         {"reference", Type::text, "", "what it is measured against"},
         {"pairs", Type::integer, "", "eigenvalues in the band"},
         {"residual_rel", Type::real, "", "largest relative residual", 2},
         {"assembly_cpu_s", Type::real, "s", "mesh and assembly", 3},
         {"factor_cpu_s", Type::real, "s", "factorisation", 3},
         {"modes_cpu_s", Type::real, "s", "undamped modes", 3},
         {"pairs_cpu_s", Type::real, "s", "complex pairs from the modes", 3},
         {"matrices", Type::text, "", "folder of the exported matrices"}});
    }

    std::vector<Cell>
    row_of(const Rung        &rung,
           const double       error,
           const std::string &quantity,
           const std::string &reference)
    {
      return {setting_text(rung.ladder, rung.setting),
              rung.dofs,
              rung.seconds,
              rung.memory,
              quantity,
              rung.values.empty() ? Cell()
                                  : Cell(rung.values[0].imag() / (2. * M_PI)),
              error,
              reference,
              rung.values.size(),
              rung.residual,
              rung.stages.assembly,
              rung.stages.factor,
              rung.stages.modes,
              rung.stages.pairs,
              rung.matrices};
    }
  } // namespace



  void
  run_work_precision(RunContext &context)
  {
    const auto &p = context.parameters.work_precision;
    if (p.problem != WorkPrecisionParameters::Problem::eigenvalues)
      return run_figure_ladders(context);
    // A rung that cannot be is told before the first one is climbed.
    for (const Ladder ladder : p.ladders)
      for (const double value : p.rungs(ladder))
        parameters_of_rung(context.parameters, ladder, value);
    std::vector<Rung> rungs;
    for (const Ladder ladder : p.ladders)
      for (const double value : p.rungs(ladder))
        rungs.push_back(climb(context, ladder, value));
    if (rungs.empty() || rungs.back().values.empty())
      throw InputError(
        "Work precision/Values: the ladder gave no values in the "
        "band");

    if (!p.reference.empty())
      check_reference(p.reference.size(), rungs, context.log);
    // The finest rung stands for the truth and is not shown, nor are others of
    // its mesh.
    const Rung   *finest = p.reference.empty() ? &finest_of(rungs) : nullptr;
    const Measure measure(p.quantity,
                          p.reference,
                          finest ? finest->values
                                 : std::vector<std::complex<double>>());
    Table         table = empty_table();
    std::vector<WorkPrecisionSeries> series;
    for (const Rung &rung : rungs)
      {
        const std::string name  = choice_name(rung.ladder);
        const double      error = measure.worst_error(rung.values);
        table.add_row(
          row_of(rung, error, p.quantity, reference_of(rung, finest)));
        if (series.empty() || series.back().label != name)
          series.push_back({name, {}, {}, {}, {}});
        if (&rung == finest || shares_mesh(rung, finest))
          continue;
        series.back().seconds.push_back(rung.seconds);
        series.back().dofs.push_back(rung.dofs);
        series.back().errors.push_back(error);
        series.back().settings.push_back(rounded_text(rung.setting, 3));
      }
    context.write_table("work_precision.csv", table);
    std::ostringstream text;
    table.print(text);
    context.log.info(text.str());

    const Table costs = cost_table(
      series, context.parameters.discretization.tolerance, context.log);
    context.write_table("cost_at_error.csv", costs);

    HtmlReport report("Work and precision of " + context.parameters.scene.name,
                      "error against cost");
    report.set_verdict(
      HtmlReport::Verdict::neutral,
      work_headline(costs) + "; errors are those against " +
        (finest ? "the finest rung" : "the given values"),
      {{"largest error of a rung, relative",
        rounded_text(error_of_column("", table, "error_rel").second, 2)},
       {"rungs", std::to_string(rungs.size())}});
    report.section("Ladder");
    report.table(table, "Settings");
    report.table(costs, "Cost of an error");
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
