// SPDX-License-Identifier: LGPL-2.1-or-later
#include "turned_rotor.h"

#include <squeal/analyses/analyses.h>
#include <squeal/base/exceptions.h>
#include <squeal/model/adaptive_cea.h>
#include <squeal/output/cea_quantities.h>
#include <squeal/output/headline_error.h>
#include <squeal/output/loudest_pairs.h>
#include <squeal/output/open_signs.h>
#include <squeal/output/record_unknowns.h>
#include <squeal/results/chart.h>

#include <algorithm>
#include <cmath>
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
        {"angle_deg", Type::real, "deg", "by which the rotor is turned", 6}};
      append_pair_columns(result);
      result.insert(
        result.end(),
        {{"discretisation_error_rel",
          Type::real,
          "",
          "estimated error of the frequency by the mesh, relative",
          2},
         {"n_unstable",
          Type::integer,
          "",
          "unstable pairs in the band at this angle"},
         {"sigma_error_mesh_per_s",
          Type::real,
          "1/s",
          "estimated: growth rate on an infinitely fine mesh less this one",
          2}});
      return result;
    }

    /** Rows of all unstable pairs of one angle, of the loudest pair alone where
     * none is unstable: the last row is always the loudest. @p growth takes
     * what all pairs say. */
    Table
    pairs_at(const Parameters &p,
             const double      angle,
             RunContext       &context,
             GrowthOfMany     &growth)
    {
      Model           model(p, context.timers);
      const MeshedCea cea =
        solve_cea_adaptively(model, context.log, context.timers);
      warn_of_growth_outside(cea.solution,
                             p.eigen,
                             "angle " + rounded_text(angle, 5) + ": ",
                             context.log);
      const ModeSolution  &modes      = cea.modes;
      const ComplexPairs  &pairs      = cea.solution.pairs;
      const PairQuantities quantities = pair_quantities(model, modes, pairs);
      record_unknowns(model, context.record);
      const LoudestPairs listed = loudest_pairs(pairs);
      growth.add(
        rounded_text(angle, 5) + " deg",
        open_signs(pairs, quantities.names, cea.errors.lambda),
        listed.n_unstable,
        is_growth_error_known(model, cea.errors.lambda[listed.numbers.back()]),
        text_of_growth_outside(cea.solution, p.eigen));
      Table table(columns());
      for (const unsigned int i : listed.numbers)
        {
          std::vector<Cell> row = {angle};
          append_pair_cells(row, pairs, quantities.names, i);
          row.insert(row.end(),
                     {or_missing(quantities.discretisation_error[i]),
                      listed.n_unstable,
                      or_missing(cea.errors.lambda[i].real())});
          table.add_row(row);
        }
      return table;
    }



    Chart
    chart_of(const Table       &all,
             const std::string &column,
             const std::string &label)
    {
      Chart       chart;
      ChartSeries series;
      series.x      = all.reals("angle_deg");
      series.y      = all.reals(column);
      series.style  = ChartSeries::Style::points;
      chart.x.label = "angle of the rotor in deg";
      chart.y.label = label;
      chart.legend  = Chart::Legend::none;
      chart.series  = {series};
      return chart;
    }

    /** What the loudest pair does over the angles, in a sentence. */
    std::string
    verdict_of(const Table &loudest)
    {
      const auto   sigma = loudest.reals("sigma_per_s");
      const auto   low   = std::min_element(sigma.begin(), sigma.end());
      const auto   high  = std::max_element(sigma.begin(), sigma.end());
      double       mean  = 0.;
      unsigned int n     = 0;
      for (std::size_t i = 0; i < sigma.size(); ++i)
        {
          mean += sigma[i] / sigma.size();
          n += loudest.integer(i, "n_unstable") > 0;
        }
      std::ostringstream text;
      text << "unstable at " << n << " of " << sigma.size()
           << " angles; the largest growth rate is " << rounded_text(*low, 4)
           << " to " << rounded_text(*high, 4) << " 1/s, "
           << rounded_text(mean, 4) << " in the mean, largest at "
           << rounded_text(loudest.real(high - sigma.begin(), "angle_deg"), 4)
           << " deg (" << loudest.text(high - sigma.begin(), "name") << ", "
           << rounded_text(loudest.real(high - sigma.begin(), "frequency_hz"),
                           5)
           << " Hz)";
      return text.str();
    }
  } // namespace



  void
  run_angles(RunContext &context)
  {
    const auto  &p = context.parameters;
    Table        all(columns()), loudest(columns());
    GrowthOfMany growth(
      "at", "angles", p.eigen.solver != EigenParameters::Solver::direct);
    for (unsigned int k = 0; k < p.angles.number; ++k)
      {
        const double angle =
          p.angles.from + (p.angles.to - p.angles.from) * k / p.angles.number;
        context.log.heading("Rotor at " + rounded_text(angle, 6) + " deg, " +
                            std::to_string(k + 1) + " of " +
                            std::to_string(p.angles.number));
        const Table at =
          pairs_at(turned_rotor(p, angle), angle, context, growth);
        all.append(at);
        std::vector<Cell> last;
        for (std::size_t c = 0; c < at.columns().size(); ++c)
          last.push_back(at.cell(at.n_rows() - 1, c));
        loudest.add_row(last);
      }
    context.write_table("angles.csv", loudest);
    context.write_table("angle_pairs.csv", all);
    context.log.heading("Loudest pair at every angle");
    std::ostringstream text;
    loudest.print(text);
    context.log.info(text.str());

    const std::string error = headline_error(
      {error_of_column("reduction", all, "error_estimate_rel"),
       error_of_column("mesh", all, "discretisation_error_rel")});
    const std::string verdict = verdict_of(loudest) + growth.reservations() +
                                "; largest error of a pair: " + error;
    if (const std::string open = growth.left_open(); !open.empty())
      context.log.warning(open +
                          ": refine it or raise 'Discretization/Degree'");
    context.record.figures = {
      {"largest error of a pair, relative", error},
      {"unknowns", std::to_string(context.record.n_dofs)}};
    HtmlReport report("Rotor angles of " + p.scene.name,
                      "lambda = sigma + i omega, sigma > 0 unstable");
    report.set_verdict(growth.verdict(), verdict, context.record.figures);
    if (p.output.plots && context.is_root)
      {
        context.output.file("plots/angles.png");
        const std::string path = context.output.path() + "/plots/angles";
        context.plotter.draw(
          draw_charts({chart_of(all, "sigma_per_s", "sigma in 1/s"),
                       chart_of(all, "frequency_hz", "frequency in Hz")},
                      1400,
                      700,
                      2),
          path);
        report.section("Over the angle");
        report.figure(path + ".png",
                      "Unstable pairs, and the least stable one where none is");
      }
    report.section("Loudest pair at every angle");
    report.table(loudest, "angles.csv");
    context.finish(p.output.report ? &report : nullptr, "");
  }
} // namespace squeal
