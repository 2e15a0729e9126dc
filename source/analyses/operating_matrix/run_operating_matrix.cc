// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/analyses/analyses.h>
#include <squeal/analyses/operating_matrix/operating_chart.h>
#include <squeal/analyses/operating_matrix/operating_condition.h>
#include <squeal/base/exceptions.h>
#include <squeal/base/number_text.h>
#include <squeal/model/adaptive_cea.h>
#include <squeal/model/drive_warnings.h>
#include <squeal/model/pressed_conditions.h>
#include <squeal/model/second_solutions.h>
#include <squeal/model/solved_scene.h>
#include <squeal/output/cea_quantities.h>
#include <squeal/output/headline_error.h>
#include <squeal/output/loudest_pairs.h>
#include <squeal/output/open_signs.h>
#include <squeal/output/record_unknowns.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <sstream>

namespace squeal
{
  namespace
  {
    std::vector<Table::Column>
    columns()
    {
      using Type                        = Table::Type;
      std::vector<Table::Column> result = {
        {"pressure_pa", Type::real, "Pa", "of all loads that press", 6},
        {"temperature_c", Type::real, "degrees Celsius", "of all tables", 5},
        {"speed_m_per_s", Type::real, "m/s", "sliding speed", 5},
        {"direction", Type::text, "", "forward or backward"}};
      append_pair_columns(result);
      result.push_back({"n_unstable",
                        Type::integer,
                        "",
                        "unstable pairs in the band under these conditions"});
      result.push_back({"frequency_error_mesh_hz",
                        Type::real,
                        "Hz",
                        "estimated: frequency on an infinitely fine mesh less "
                        "this one",
                        2});
      result.push_back({"sigma_error_mesh_per_s",
                        Type::real,
                        "1/s",
                        "estimated: growth rate on an infinitely fine mesh "
                        "less this one",
                        2});
      return result;
    }

    /** The pairs under one condition. */
    struct ConditionPairs
    {
      /** Of all unstable pairs, the loudest last; of the loudest alone where
       * none is unstable. */
      std::vector<std::vector<Cell>> rows;
      double                         largest_growth; /**< 1/s */
      double       growth_error; /**< of it by the mesh, 1/s; NaN: not known */
      unsigned int n_unstable;
      OpenSigns    open;
      bool         is_estimated; /**< the growth error, where there is a mesh */
      std::string  outside;      /**< text_of_growth_outside() */
    };

    ConditionPairs
    condition_pairs(const Model              &model,
                    const ComplexPairs       &pairs,
                    const OperatingCondition &c,
                    const Eigen::VectorXcd   &errors)
    {
      const std::vector<ModeName> names  = pair_names(model, pairs);
      const LoudestPairs          listed = loudest_pairs(pairs);
      const auto given = [](const std::optional<double> &value) {
        return value ? Cell(*value) : Cell();
      };
      const unsigned int loudest = listed.numbers.back();
      ConditionPairs     result;
      result.largest_growth = pairs.sigma(loudest);
      result.growth_error   = errors[loudest].real();
      result.n_unstable     = listed.n_unstable;
      result.open           = open_signs(pairs, names, errors);
      result.is_estimated   = is_growth_error_known(model, errors[loudest]);
      for (const unsigned int i : listed.numbers)
        {
          std::vector<Cell> row = {given(c.pressure),
                                   given(c.temperature),
                                   given(c.speed),
                                   c.backward ? "backward" : "forward"};
          append_pair_cells(row, pairs, names, i);
          row.push_back(listed.n_unstable);
          row.push_back(or_missing(errors[i].imag() / (2. * M_PI)));
          row.push_back(or_missing(errors[i].real()));
          result.rows.push_back(std::move(row));
        }
      return result;
    }

    ConditionPairs
    pairs_of(const SolvedScene        &scene,
             const OperatingCondition &c,
             SecondSolutions          &second,
             RunContext               &context)
    {
      const Model           &model = scene.model();
      const ComplexPairs    &pairs = scene.solution().pairs;
      const EigenParameters &eigen = model.parameters().eigen;
      warn_of_kinks(model.parameters().scene, context.log);
      warn_of_growth_outside(
        scene.solution(), eigen, text_of(c) + ": ", context.log);
      record_unknowns(model, context.record);
      const PairErrors errors =
        model.parameters().discretization.estimate_error
          ? loudest_pair_errors(
              model, scene.pencil(), pairs, second, context.log, context.timers)
          : PairErrors::unknown(pairs.size());
      ConditionPairs result = condition_pairs(model, pairs, c, errors.lambda);
      result.outside        = text_of_growth_outside(scene.solution(), eigen);
      return result;
    }

    /** Of all conditions, in their order. */
    std::vector<ConditionPairs>
    solve_conditions(const std::vector<OperatingCondition> &all,
                     RunContext                            &context)
    {
      std::vector<ConditionPairs> result(all.size());
      std::size_t                 n_done = 0;
      PressedConditions           pressed;
      CommonParts                 common;
      SecondSolutions             second;
      std::size_t                 n_groups = 0;
      for (const auto &[key, members] : with_same_bodies(all))
        {
          second.of_bodies(++n_groups);
          std::unique_ptr<SolvedScene> first;
          for (const std::size_t k : members)
            {
              context.log.heading(text_of(all[k]) + ", " +
                                  std::to_string(++n_done) + " of " +
                                  std::to_string(all.size()));
              const Parameters here = parameters_of(context.parameters, all[k]);
              auto             scene = std::make_unique<SolvedScene>(
                here,
                pressed.states(here, n_groups, context.timers),
                first.get(),
                common,
                context.log,
                context.timers);
              result[k] = pairs_of(*scene, all[k], second, context);
              if (scene->has_start())
                first = std::move(scene);
            }
        }
      return result;
    }

    /** Absolute, 1/s; NaN: not estimated. */
    double
    growth_error_of_loudest(const std::vector<ConditionPairs> &all)
    {
      return std::abs(std::max_element(all.begin(),
                                       all.end(),
                                       [](const auto &a, const auto &b) {
                                         return a.largest_growth <
                                                b.largest_growth;
                                       })
                        ->growth_error);
    }

    /** Where it squeals, in a sentence. */
    std::string
    verdict_of(const Table &loudest)
    {
      std::size_t           n = 0, most = 0;
      std::set<std::string> names;
      for (std::size_t i = 0; i < loudest.n_rows(); ++i)
        {
          if (loudest.integer(i, "n_unstable") > 0)
            {
              ++n;
              names.insert(loudest.text(i, "name"));
            }
          if (loudest.real(i, "sigma_per_s") >
              loudest.real(most, "sigma_per_s"))
            most = i;
        }
      std::ostringstream text;
      text << "unstable under " << n << " of " << loudest.n_rows()
           << " conditions";
      if (n == 0)
        return text.str();
      text << ", loudest with "
           << rounded_text(loudest.real(most, "sigma_per_s"), 4) << " 1/s at "
           << rounded_text(loudest.real(most, "frequency_hz"), 5) << " Hz ("
           << loudest.text(most, "name") << ", "
           << loudest.text(most, "direction");
      for (const auto &[column, unit] :
           {std::make_pair("pressure_pa", " Pa"),
            std::make_pair("temperature_c", " degrees Celsius"),
            std::make_pair("speed_m_per_s", " m/s")})
        if (!loudest.is_missing(most, column))
          text << ", " << rounded_text(loudest.real(most, column), 4) << unit;
      text << ")";
      return text.str();
    }
  } // namespace



  void
  run_operating_matrix(RunContext &context)
  {
    const auto &p              = context.parameters;
    const auto  all_conditions = operating_conditions(p.operating_matrix);
    // What some table does not cover ends the run before any work.
    for (const OperatingCondition &c : all_conditions)
      parameters_of(p, c);
    Table        all(columns()), loudest(columns());
    const auto   solved = solve_conditions(all_conditions, context);
    GrowthOfMany growth(
      "under", "conditions", p.eigen.solver != EigenParameters::Solver::direct);
    for (std::size_t k = 0; k < solved.size(); ++k)
      {
        const ConditionPairs &condition = solved[k];
        for (const auto &row : condition.rows)
          all.add_row(row);
        loudest.add_row(condition.rows.back());
        growth.add(text_of(all_conditions[k]),
                   condition.open,
                   condition.n_unstable,
                   condition.is_estimated,
                   condition.outside);
      }
    context.write_table("operating_matrix.csv", loudest);
    context.write_table("operating_pairs.csv", all);
    context.log.heading("Loudest pair under every condition");
    std::ostringstream text;
    loudest.print(text);
    context.log.info(text.str());

    const std::string verdict = verdict_of(loudest) + growth.reservations();
    if (const std::string open = growth.left_open(); !open.empty())
      context.log.warning(open +
                          ": refine it or raise 'Discretization/Degree'");
    context.record.figures = {
      {"which", verdict},
      {"largest error of a pair by the basis, relative",
       headline_error(
         {error_of_column("reduction", all, "error_estimate_rel")})},
      {"error of the largest growth rate, 1/s",
       headline_error({{"mesh", growth_error_of_loudest(solved)}}, " 1/s")},
      {"largest error of a frequency, Hz",
       headline_error(
         {error_of_column("mesh", loudest, "frequency_error_mesh_hz")}, " Hz")},
      {"unknowns", std::to_string(context.record.n_dofs)}};
    HtmlReport report("Operating matrix of " + p.scene.name,
                      "lambda = sigma + i omega, sigma > 0 unstable");
    report.set_verdict(growth.verdict(), verdict, context.record.figures);
    if (p.output.plots && context.is_root)
      {
        context.output.file("plots/operating_matrix.png");
        const std::string path =
          context.output.path() + "/plots/operating_matrix";
        context.plotter.draw(operating_chart(loudest), path);
        report.section("Where it squeals");
        report.figure(path + ".png",
                      "Loudest pair: growth rate as colour, frequency in kHz "
                      "above the growth rate in 1/s",
                      true);
      }
    report.section("Loudest pair under every condition");
    report.table(loudest, "operating_matrix.csv");
    context.finish(p.output.report ? &report : nullptr, "");
  }
} // namespace squeal
