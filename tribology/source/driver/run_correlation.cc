// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/parameters/checks.h>
#include <squeal/results/chart.h>
#include <squeal/results/json_file.h>
#include <squeal/tribology/damage/damage_table.h>
#include <squeal/tribology/damage/map_picture.h>
#include <squeal/tribology/driver/analyses.h>
#include <squeal/tribology/driver/study_report.h>
#include <squeal/tribology/statistics/association.h>
#include <squeal/tribology/statistics/pad_tables.h>
#include <squeal/tribology/statistics/quantity_text.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <ostream>

namespace squeal::tribology
{
  namespace
  {
    using Json = nlohmann::ordered_json;

    Json
    number(const double value)
    {
      return std::isfinite(value) ? Json(value) : Json(nullptr);
    }



    Table::Column
    real(const std::string &name, const std::string &description)
    {
      return {name, Table::Type::real, "", description, 3};
    }



    Table
    link_table(const std::vector<PadLink> &links, const bool is_synthetic)
    {
      Table table(
        {{"pad", Table::Type::integer, "", "pad, from 1"},
         {"index", Table::Type::text, "", "column of the damage table"},
         {"feature", Table::Type::text, "", "column of the features"},
         {"verdict", Table::Type::text, "", "what follows"},
         {"cells", Table::Type::integer, "", "cells with both"},
         real("pearson", "correlation"),
         real("spearman", "correlation of the ranks"),
         real("roc_auc",
              "index finds cells with the feature; 0.5 is "
              "chance"),
         real("top_decile_overlap", "0.1 is chance"),
         real("effective_cells", "independent cells (Dutilleul)"),
         real("p_effective", "p-value with these"),
         real("p_surrogate", "p-value among phase-randomised maps"),
         real("p_adjusted", "larger of the two, Holm over all rows"),
         real("r_lower", "interval with the effective cells"),
         real("r_upper", "interval with the effective cells"),
         real("bootstrap_lower", "interval from 3 x 3 blocks"),
         real("bootstrap_upper", "interval from 3 x 3 blocks"),
         real("power", "of finding the relevant link")});
      for (const PadLink &l : links)
        table.add_row({l.pad + 1,
                       l.index,
                       l.feature,
                       verdict_text(l.test.verdict, is_synthetic),
                       l.test.n_cells,
                       or_missing(l.test.r),
                       or_missing(l.test.rho),
                       or_missing(l.test.auc),
                       or_missing(l.test.overlap),
                       l.test.n_effective,
                       l.test.p_effective,
                       l.test.p_surrogate,
                       l.test.p_adjusted,
                       l.test.interval[0],
                       l.test.interval[1],
                       l.test.bootstrap[0],
                       l.test.bootstrap[1],
                       l.test.power});
      return table;
    }



    Json
    json_of(const std::vector<PadLink> &links, const bool is_synthetic)
    {
      Json list = Json::array();
      for (const PadLink &l : links)
        list.push_back(
          {{"pad", l.pad + 1},
           {"index", l.index},
           {"feature", l.feature},
           {"cells", l.test.n_cells},
           {"pearson", number(l.test.r)},
           {"spearman", number(l.test.rho)},
           {"roc_auc", number(l.test.auc)},
           {"top_decile_overlap", number(l.test.overlap)},
           {"effective_cells", number(l.test.n_effective)},
           {"p_effective", number(l.test.p_effective)},
           {"p_surrogate", number(l.test.p_surrogate)},
           {"p_adjusted", number(l.test.p_adjusted)},
           {"interval", {l.test.interval[0], l.test.interval[1]}},
           {"bootstrap_interval", {l.test.bootstrap[0], l.test.bootstrap[1]}},
           {"power", number(l.test.power)},
           {"verdict", verdict_text(l.test.verdict, is_synthetic)}});
      return list;
    }



    Table
    self_test_table(Context &context)
    {
      const CorrelationParameters &p = context.parameters.correlation;
      Timers::Section              section(context.timers, "Test: the tester");
      const std::vector<double>    links = {.2, .4, .6, .8};
      Progress                     progress(
        context.log, "self test", p.test_lengths.size() * (1 + links.size()));
      Table table(
        {{"length_nodes", Table::Type::real, "", "correlation length", 3},
         {"link", Table::Type::real, "", "true correlation; 0: none", 3},
         {"pairs", Table::Type::integer, "", "pairs of maps"},
         real("rate_plain", "found by the plain test, dishonest"),
         real("rate_effective", "found with the effective cells"),
         real("rate_surrogate", "found among surrogates"),
         real("rate_both", "found by both, as verdicts ask"),
         real("both_lower", "its 95 % interval"),
         real("both_upper", "its 95 % interval")});
      const auto add =
        [&](const double length, const double link, const unsigned int n) {
          const SelfTestRow row = self_test(length, link, n, 199, p);
          const double      m   = n;
          const auto [a, b]     = rate_interval(row.n_both, n);
          table.add_row({length,
                         link,
                         n,
                         row.n_plain / m,
                         row.n_effective / m,
                         row.n_surrogate / m,
                         row.n_both / m,
                         a,
                         b});
          progress.advance();
        };
      for (const double length : p.test_lengths)
        {
          add(length, 0., p.n_test_pairs);
          for (const double link : links)
            add(length, link, std::max(100u, p.n_test_pairs / 5));
        }
      return table;
    }



    void
    draw(Context &context, const Drawing &drawing, const std::string &name)
    {
      const std::string path = context.output.file("plots/" + name + ".png");
      context.plotter.draw(drawing, path.substr(0, path.size() - 4));
    }



    void
    draw_power(Context &context, const Table &test)
    {
      Chart chart;
      chart.title    = "How often a link is found, by its strength";
      chart.x.label  = "true correlation";
      chart.y.label  = "rate";
      chart.y.lower  = 0.;
      chart.y.upper  = 1.;
      unsigned int n = 0;
      for (const double length : context.parameters.correlation.test_lengths)
        {
          ChartSeries series;
          series.label = "length " + rounded_text(length, 3) + " nodes";
          series.style = ChartSeries::Style::lines_points;
          series.ink   = static_cast<Ink>(n++ % 8);
          for (std::size_t i = 0; i < test.n_rows(); ++i)
            if (test.real(i, "length_nodes") == length)
              {
                series.x.push_back(test.real(i, "link"));
                series.y.push_back(test.real(i, "rate_both"));
              }
          chart.series.push_back(series);
        }
      chart.lines.push_back({false,
                             context.parameters.correlation.level,
                             "nominal false positives"});
      draw(context, draw_charts({chart}, 1100, 700), "power");
    }



    /** Scatter of the pair with the smallest p-value, and its two maps. */
    void
    draw_best(Context                    &context,
              const std::vector<PadMaps> &pads,
              const std::vector<PadLink> &links)
    {
      const auto best = std::min_element(
        links.begin(), links.end(), [](const PadLink &a, const PadLink &b) {
          return std::max(a.test.p_effective, a.test.p_surrogate) <
                 std::max(b.test.p_effective, b.test.p_surrogate);
        });
      const PadMaps &pad     = pads[best->pad];
      const GridMap &index   = pad.indices.at(best->index);
      const GridMap &feature = pad.features.at(best->feature);
      Chart          chart;
      chart.title = "Pad " + std::to_string(best->pad + 1) +
                    ": r = " + rounded_text(best->test.r, 2) + ", " +
                    rounded_text(best->test.n_effective, 2) +
                    " independent cells";
      chart.x.label = QuantityText(best->index).with_unit();
      chart.y.label = QuantityText(best->feature).with_unit();
      ChartSeries series;
      const auto  values = common_values(index, feature);
      series.x           = values[0];
      series.y           = values[1];
      chart.series.push_back(series);
      draw(context, draw_charts({chart}, 900, 700), "scatter");
      const auto by_node = [&pad](const GridMap &map) {
        std::vector<double> v(map.size());
        for (std::size_t i = 0; i < map.size(); ++i)
          v[pad.grid->order()[i]] = map.values[i];
        return v;
      };
      const auto map_of = [&by_node](const std::string &column,
                                     const GridMap     &map) {
        const QuantityText quantity(column);
        return FaceMap{quantity.name, quantity.unit, by_node(map)};
      };
      draw(
        context,
        draw_maps(*pad.grid,
                  {map_of(best->index, index), map_of(best->feature, feature)}),
        "maps");
    }



    std::string
    headline(const std::vector<PadLink> &links, const bool is_synthetic)
    {
      unsigned int counts[3] = {0, 0, 0};
      for (const PadLink &l : links)
        ++counts[static_cast<int>(l.test.verdict)];
      return (is_synthetic ? "synthetic: " : "") + std::to_string(counts[0]) +
             " supported, " + std::to_string(counts[1]) + " contradicted, " +
             std::to_string(counts[2]) + " undecided of " +
             std::to_string(links.size()) + " links";
    }



    void
    report_links(HtmlReport                     &report,
                 const Context                  &context,
                 std::vector<PadLink>            links,
                 const std::vector<GroupResult> &groups)
    {
      const CorrelationParameters &p     = context.parameters.correlation;
      const std::string            plots = context.output.path() + "/plots/";
      report.section("Question");
      report.paragraph(
        "Do cells of the pad with more computed damage have more of the "
        "features seen in the images? Each row is one index of damage against "
        "one feature on the same nodal cells of one pad.");
      if (p.is_synthetic)
        report.paragraph("The images were made by a generator: every verdict "
                         "says 'synthetic' and is about the method, not about "
                         "a brake.");
      report.section("Links");
      for (PadLink &link : links)
        {
          link.index   = QuantityText(link.index).name;
          link.feature = QuantityText(link.feature).name;
        }
      report.table(link_table(links, p.is_synthetic),
                   "All links (correlation.csv)");
      report.figure(
        plots + "scatter.png", "The link with the smallest p-value.", true);
      report.figure(plots + "maps.png", "Its two maps.");
      report.section("Groups");
      if (groups.empty())
        report.paragraph("All pads are of one group.");
      for (const GroupResult &g : groups)
        report.paragraph(
          g.feature + ": mean " + rounded_text(g.mean_squealing, 4) + " on " +
          std::to_string(g.n_squealing) + " squealing pads, " +
          rounded_text(g.mean_silent, 4) + " on " + std::to_string(g.n_silent) +
          " silent pads; p = " + rounded_text(g.p_value, 3) + ": " +
          verdict_text(g.verdict, p.is_synthetic) + ". " + g.reason);
      report.section("How sure");
      report.list(
        {"Neighbouring cells are alike and count less than one each: the "
         "column "
         "effective_cells says how many independent ones remain.",
         "A link is supported (or, with a negative sign, contradicted) only if "
         "both p-values, adjusted by Holm for the number of rows, are at "
         "most " +
           rounded_text(p.level, 3) + ".",
         "It is contradicted too if a correlation of " +
           rounded_text(p.relevant_link, 3) +
           " would have been found with a "
           "probability of " +
           rounded_text(p.wanted_power, 3) +
           " and the interval of r excludes it.",
         "Anything else is undecided. One pad for a group is one sample."});
    }
  } // namespace



  void
  run_correlation(Context &context)
  {
    const CorrelationParameters &p = context.parameters.correlation;
    for (const std::string &file : p.damage_tables)
      prm::require_file(file, "Correlation", "Damage tables", true);
    for (const std::string &file : p.feature_tables)
      prm::require_file(file, "Correlation", "Feature tables", true);
    const StudyRuns            study(p.runs);
    const std::vector<PadMaps> pads = read_pads(p);
    std::vector<PadLink>       links;
    std::vector<GroupResult>   groups;
    {
      Timers::Section section(context.timers, "Correlate: maps");
      links  = link_pads(pads, p);
      groups = compare_groups(pads, p);
    }
    Json json = {{"format_version", 1},
                 {"synthetic", p.is_synthetic},
                 {"level", p.level},
                 {"relevant_link", p.relevant_link},
                 {"wanted_power", p.wanted_power},
                 {"links", json_of(links, p.is_synthetic)},
                 {"groups", Json::array()}};
    for (const GroupResult &g : groups)
      json["groups"].push_back(
        {{"feature", g.feature},
         {"silent_pads", g.n_silent},
         {"squealing_pads", g.n_squealing},
         {"mean_silent", number(g.mean_silent)},
         {"mean_squealing", number(g.mean_squealing)},
         {"p", number(g.p_value)},
         {"verdict", verdict_text(g.verdict, p.is_synthetic)},
         {"reason", g.reason}});
    context.write_table("correlation.csv", link_table(links, p.is_synthetic));
    HtmlReport report("Correlation" + (context.parameters.name.empty()
                                         ? ""
                                         : ": " + context.parameters.name),
                      "damage maps against maps of features");
    const bool draws =
      context.parameters.output.plots && context.plotter.is_available();
    if (!links.empty() && draws)
      draw_best(context, pads, links);
    const std::string verdict =
      links.empty() ? "Test of the tester" : headline(links, p.is_synthetic);
    context.record.figures = {{"verdict", verdict},
                              {"pads", std::to_string(pads.size())},
                              {"links", std::to_string(links.size())}};
    report.set_verdict(
      HtmlReport::Verdict::neutral, verdict, context.record.figures);
    if (!study.empty())
      {
        report.section("In short");
        report.list(in_plain_words(links, groups, p));
        report.section("What was done");
        study.add_steps(report);
        report.section("Damage of the pad");
        study.add_damage(report);
        report.section("Images");
        study.add_images(report, context);
      }
    if (!links.empty())
      report_links(report, context, links, groups);
    if (p.self_test)
      {
        const Table test = self_test_table(context);
        context.write_table("self_test.csv", test);
        Json rows = Json::array();
        for (std::size_t i = 0; i < test.n_rows(); ++i)
          {
            Json row;
            for (const Table::Column &column : test.columns())
              row[column.name] = test.real(i, column.name);
            rows.push_back(row);
          }
        json["self_test"] = rows;
        if (draws)
          draw_power(context, test);
        report.section("Test of the tester");
        report.paragraph(
          "Pairs of random maps of 11 x 11 cells: with a link of "
          "0 every find is a false positive.");
        report.table(test, "Rates (self_test.csv)");
        report.figure(context.output.path() + "/plots/power.png",
                      "Power against the strength of the link.");
      }
    if (!study.empty())
      {
        report.section("The whole study again");
        study.add_commands(report, context.record);
      }
    write_json(context.output.file("correlation.json"), json);
    context.finish(context.parameters.output.report ? &report : nullptr, "");
  }
} // namespace squeal::tribology
