// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/parameters/checks.h>
#include <squeal/results/chart.h>
#include <squeal/results/contact_map.h>
#include <squeal/results/json_file.h>
#include <squeal/tribology/damage/damage_table.h>
#include <squeal/tribology/driver/analyses.h>
#include <squeal/tribology/driver/correlation_tables.h>
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

    void
    draw_power(Context &context, const Table &test)
    {
      Chart chart;
      chart.title = "How often a link is found, shared: " +
                    (test.n_rows() > 0 ? test.text(0, "shared") : "");
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
            if (test.real(i, "length_nodes") == length &&
                test.text(i, "shared") == test.text(0, "shared"))
              {
                series.x.push_back(test.real(i, "link"));
                series.y.push_back(test.real(i, "rate_conditional"));
              }
          chart.series.push_back(series);
        }
      chart.lines.push_back({false,
                             context.parameters.correlation.level,
                             "nominal false positives"});
      context.plotter.draw(draw_charts({chart}, 1100, 700),
                           context.plot_path("power"));
    }



    /** Scatter of the pair with the smallest p-value, and its two maps. */
    void
    draw_best(Context                    &context,
              const std::vector<PadMaps> &pads,
              const std::vector<PadLink> &links)
    {
      const auto best = std::min_element(
        links.begin(), links.end(), [](const PadLink &a, const PadLink &b) {
          return a.test.conditional.p < b.test.conditional.p;
        });
      const PadMaps &pad     = pads[best->pad];
      const GridMap &index   = pad.indices.at(best->index);
      const GridMap &feature = pad.features.at(best->feature);
      Chart          chart;
      chart.title = "Pad " + std::to_string(best->pad + 1) +
                    ": r = " + rounded_text(best->test.r, 2) + ", " +
                    rounded_text(best->test.conditional.r, 2) +
                    " with shared causes taken out";
      chart.x.label = QuantityText(best->index).with_unit();
      chart.y.label = QuantityText(best->feature).with_unit();
      ChartSeries series;
      const auto  values = common_values(index, feature);
      series.x           = values[0];
      series.y           = values[1];
      chart.series.push_back(series);
      context.plotter.draw(draw_charts({chart}, 900, 700),
                           context.plot_path("scatter"));
      const auto by_node = [&pad](const GridMap &map) {
        std::vector<double> v(map.size());
        for (std::size_t i = 0; i < map.size(); ++i)
          v[pad.grid->order()[i]] = map.values[i];
        return pad.grid->drawn_values(v);
      };
      const auto map_of = [&by_node](const std::string &column,
                                     const GridMap     &map) {
        const QuantityText quantity(column);
        ContactMap::Panel  panel;
        panel.title  = quantity.name;
        panel.label  = quantity.unit;
        panel.values = by_node(map);
        return panel;
      };
      ContactMap(pad.grid->drawn_face())
        .plot(context.plotter,
              {map_of(best->index, index), map_of(best->feature, feature)},
              context.plot_path("maps"));
    }



    /** What the test finds where there is nothing, and where there is
     * something. */
    std::string
    headline_of_test(const Table &test)
    {
      double alarms = 0., upper = 0., power = 1., least = 1., most = 0.,
             strongest = 0.;
      for (std::size_t i = 0; i < test.n_rows(); ++i)
        strongest = std::max(strongest, test.real(i, "link"));
      for (std::size_t i = 0; i < test.n_rows(); ++i)
        {
          const double found = test.real(i, "rate_conditional"),
                       held  = test.real(i, "coverage");
          if (test.real(i, "link") == 0. && found >= alarms)
            {
              alarms = found;
              upper  = std::max(upper, test.real(i, "conditional_upper"));
            }
          if (test.real(i, "link") == strongest)
            power = std::min(power, found);
          least = std::min(least, held);
          most  = std::max(most, held);
        }
      const auto percent = [](const double share) {
        return rounded_text(100. * share, 3);
      };
      return "finds a link where there is none in at most " + percent(alarms) +
             " % of the pairs of maps (95 %: up to " + percent(upper) +
             " %), a link of " + rounded_text(strongest, 2) + " in at least " +
             percent(power) + " %; " + percent(least) + " to " + percent(most) +
             " % of its intervals at 95 % hold the truth";
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
                 const CorrelationParameters    &p,
                 std::vector<PadLink>            links,
                 const std::vector<GroupResult> &groups)
    {
      const std::string plots = context.output.path() + "/plots/";
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
                   "All links (correlation.csv has more columns)",
                   columns_of_report());
      report.list(shared_cause_sentences(links, p));
      report.figure(
        plots + "scatter.png", "The link with the smallest p-value.", true);
      report.figure(plots + "maps.png",
                    "Its two maps; the disc slides along the arrow.");
      report.section("Groups");
      if (groups.empty())
        report.paragraph("All pads are of one group.");
      for (const GroupResult &g : groups)
        report.paragraph(
          g.feature + ": mean " + rounded_text(g.mean_squealing, 4) + " on " +
          std::to_string(g.n_squealing) + " squealing pads, " +
          rounded_text(g.mean_silent, 4) + " on " + std::to_string(g.n_silent) +
          " silent pads; p = " + rounded_text(g.p_value, 3) + ", " +
          rounded_text(g.p_adjusted, 3) + " adjusted by Holm for " +
          std::to_string(groups.size()) + " features: " +
          verdict_text(g.verdict, p.is_synthetic) + ". " + g.reason);
      report.section("How sure");
      report.list(
        {"The verdict rests on what is left of both maps once shared causes "
         "are taken out; verdict_without is what would follow otherwise.",
         "Neighbouring cells are alike and count less than one each: "
         "effective_cells says how many independent ones the pair of maps has, "
         "conditional_cells how many once causes are taken out.",
         "A link is supported (or, with a negative sign, contradicted) only if "
         "the p-value of the partial correlation, adjusted by Holm for the "
         "number of rows, is at most " +
           rounded_text(p.level, 3) + ".",
         "It is contradicted too if a partial correlation of " +
           rounded_text(p.relevant_link, 3) +
           " would have been found with a probability of " +
           rounded_text(p.wanted_power, 3) +
           " at the level that the verdict uses, and its interval at that "
           "level excludes it.",
         "Anything else is undecided. One pad for a group is one sample.",
         "A cause that both maps share and nobody measured cannot be taken "
         "out: name maps of it in 'Covariates'."});
    }
  } // namespace



  void
  run_correlation(Context &context)
  {
    CorrelationParameters p = context.parameters.correlation;
    for (const std::string &file : p.damage_tables)
      prm::require_file(file, "Correlation", "Damage tables", true);
    for (const std::string &file : p.feature_tables)
      prm::require_file(file, "Correlation", "Feature tables", true);
    const StudyRuns            study(p.runs);
    const std::vector<PadMaps> pads = read_pads(p);
    std::vector<PadLink>       links;
    std::vector<GroupResult>   groups;
    for (const PadMaps &pad : pads)
      p.is_synthetic = p.is_synthetic || pad.is_synthetic;
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
                 {"shared_causes", Json::array()},
                 {"groups", json_of(groups, p.is_synthetic)}};
    if (!pads.empty())
      json["shared_causes"] = pads[0].causes.names;
    for (const std::string &line : warnings_of_thin_cells(pads, p))
      context.log.warning(line);
    for (const std::string &line : warnings_of_coarse_features(pads, p))
      context.log.warning(line);
    for (const std::string &line : warnings_of_assumed_places(pads, p))
      context.log.warning(line);
    for (const std::string &line : warnings_of_texts(pads, p))
      context.log.warning(line);
    for (const std::string &line : warnings_of_doubled_rows(pads, p))
      context.log.warning(line);
    for (const std::string &line : warnings_of_long_pads(pads, p))
      context.log.warning(line);
    for (const std::string &line : warnings_of_constant_covariates(pads))
      context.log.warning(line);
    for (const std::string &line : warnings_of_lacking_covariates(pads))
      context.log.warning(line);
    for (const std::string &line : warnings_of_assumed_edges(pads, p))
      context.log.warning(line);
    for (const std::string &line : warnings_of_weak_links(links))
      context.log.warning(line);
    for (const std::string &line : warnings_of_links_by_steps(links, p))
      context.log.warning(line);
    for (const std::string &line : warnings_of_lacking_features(pads, p))
      context.log.warning(line);
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
      report_links(report, context, p, links, groups);
    if (p.self_test)
      {
        const Table test = self_test_table(context);
        context.write_table("self_test.csv", test);
        Json rows = Json::array();
        for (std::size_t i = 0; i < test.n_rows(); ++i)
          {
            Json row;
            for (const Table::Column &column : test.columns())
              row[column.name] = column.type == Table::Type::text
                                   ? Json(test.text(i, column.name))
                                   : Json(test.real(i, column.name));
            rows.push_back(row);
          }
        json["self_test"] = rows;
        if (draws)
          draw_power(context, test);
        if (links.empty())
          {
            context.record.figures[0].second = headline_of_test(test);
            report.set_verdict(HtmlReport::Verdict::neutral,
                               headline_of_test(test),
                               context.record.figures);
          }
        report.section("Test of the tester");
        report.paragraph(
          "Pairs of random maps of 11 x 11 cells, to which a pattern is added "
          "that both share, or which are bands along the sliding direction "
          "(streaks): with a link of 0 every find is a false positive.");
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
