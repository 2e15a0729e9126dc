// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/tribology/driver/correlation_tables.h>
#include <squeal/tribology/statistics/association.h>
#include <squeal/tribology/statistics/self_test.h>

#include <algorithm>
#include <cmath>

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



    Json
    interval(const std::array<double, 2> &ends)
    {
      return {number(ends[0]), number(ends[1])};
    }



    Table::Column
    real(const std::string &name, const std::string &description)
    {
      return {name, Table::Type::real, "", description, 3};
    }



    Table::Column
    text(const std::string &name, const std::string &description)
    {
      return {name, Table::Type::text, "", description};
    }



    Table::Column
    integer(const std::string &name, const std::string &description)
    {
      return {name, Table::Type::integer, "", description};
    }



    std::vector<Table::Column>
    link_columns()
    {
      return {
        integer("pad", "pad, from 1"),
        text("index", "column of the damage table"),
        text("feature", "column of the features"),
        text("verdict", "what follows, shared causes taken out"),
        integer("cells", "cells with both, those without a covariate too"),
        real("pearson", "correlation"),
        real("spearman", "correlation of the ranks"),
        real("roc_auc", "index finds cells with the feature; 0.5 is chance"),
        real("top_decile_overlap", "0.1 is chance"),
        real("effective_cells", "independent cells of the pair of maps"),
        real("p_effective", "p-value with these"),
        real("p_surrogate", "p-value among phase-randomised maps"),
        real("p_adjusted", "p_conditional, Holm over all rows: decides"),
        real("r_lower", "interval of the correlation, effective cells"),
        real("r_upper", "interval of the correlation, effective cells"),
        real("bootstrap_lower",
             "interval of the partial correlation, resampled"),
        real("bootstrap_upper",
             "interval of the partial correlation, resampled"),
        real("power",
             "of finding the relevant link at the level of the verdict"),
        text("verdict_without", "what would follow if nothing were taken out"),
        real("p_without",
             "larger of p_effective and p_surrogate, Holm over all rows"),
        real("partial_correlation", "shared causes taken out"),
        real("partial_lower", "its interval"),
        real("partial_upper", "its interval"),
        real("p_conditional", "p-value of the partial correlation"),
        real("conditional_cells", "independent cells behind it"),
        integer("terms_taken_out", "degrees of freedom of shared causes"),
        real("verdict_level", "level that Holm left to this row"),
        real("index_cells", "independent cells of the index alone"),
        real("feature_cells", "independent cells of the feature alone"),
        real("leading_edge_correlation",
             "of the feature with a map that only decays from the "
             "leading edge on"),
        real("rim_correlation",
             "of the feature with a map that only decays from the rim "
             "on"),
        text("leading_edge", "edge of the pad taken for the leading one")};
    }



    Table
    empty_self_test()
    {
      return Table(
        {text("shared", "what both maps share without a link"),
         real("length_nodes", "correlation length"),
         real("link", "true correlation; 0: none"),
         integer("pairs", "pairs of maps"),
         real("rate_plain", "found by the plain test, dishonest"),
         real("rate_effective", "found with the effective cells"),
         real("rate_surrogate", "found among surrogates"),
         real("rate_both", "found by both: the verdict without shared causes"),
         real("both_lower", "its 95 % interval"),
         real("both_upper", "its 95 % interval"),
         real("rate_conditional", "found once shared causes are taken out"),
         real("conditional_lower", "its 95 % interval"),
         real("conditional_upper", "its 95 % interval"),
         real("coverage", "intervals at 95 % that hold the true correlation"),
         real("coverage_bootstrap", "the same, resampled intervals"),
         real("conditional_cells", "independent cells, mean")});
    }



    void
    add_row(Table &table, const SelfTestRow &row)
    {
      const double m           = row.n_pairs;
      const auto   both        = rate_interval(row.n_both, row.n_pairs);
      const auto   conditional = rate_interval(row.n_conditional, row.n_pairs);
      table.add_row({choice_name(row.pattern),
                     row.length,
                     row.link,
                     row.n_pairs,
                     row.n_plain / m,
                     row.n_effective / m,
                     row.n_surrogate / m,
                     row.n_both / m,
                     both[0],
                     both[1],
                     row.n_conditional / m,
                     conditional[0],
                     conditional[1],
                     row.n_covered / m,
                     row.n_covered_bootstrap / m,
                     row.conditional_cells});
    }
  } // namespace



  Table
  link_table(const std::vector<PadLink> &links, const bool is_synthetic)
  {
    Table table(link_columns());
    for (const PadLink &l : links)
      {
        const LinkTest        &t = l.test;
        const ConditionalLink &c = t.conditional;
        table.add_row({l.pad + 1,
                       l.index,
                       l.feature,
                       verdict_text(t.verdict, is_synthetic),
                       t.n_cells,
                       or_missing(t.r),
                       or_missing(t.rho),
                       or_missing(t.auc),
                       or_missing(t.overlap),
                       t.n_effective,
                       t.p_effective,
                       t.p_surrogate,
                       t.p_adjusted,
                       t.interval[0],
                       t.interval[1],
                       or_missing(t.bootstrap[0]),
                       or_missing(t.bootstrap[1]),
                       t.power,
                       verdict_text(t.verdict_without, is_synthetic),
                       t.p_without,
                       c.is_known ? Cell(c.r) : Cell(),
                       t.conditional_interval[0],
                       t.conditional_interval[1],
                       c.p,
                       c.n_effective,
                       c.n_taken,
                       t.level,
                       t.index_cells,
                       t.feature_cells,
                       or_missing(t.reference.leading_edge),
                       or_missing(t.reference.rim),
                       choice_name(t.reference.edge)});
      }
    return table;
  }



  const std::vector<std::string> &
  columns_of_report()
  {
    static const std::vector<std::string> names = {"pad",
                                                   "index",
                                                   "feature",
                                                   "verdict",
                                                   "verdict_without",
                                                   "cells",
                                                   "pearson",
                                                   "effective_cells",
                                                   "p_without",
                                                   "partial_correlation",
                                                   "partial_lower",
                                                   "partial_upper",
                                                   "conditional_cells",
                                                   "p_adjusted",
                                                   "power"};
    return names;
  }



  Json
  json_of(const std::vector<PadLink> &links, const bool is_synthetic)
  {
    Json list = Json::array();
    for (const PadLink &l : links)
      {
        const LinkTest        &t = l.test;
        const ConditionalLink &c = t.conditional;
        list.push_back(
          {{"pad", l.pad + 1},
           {"index", l.index},
           {"feature", l.feature},
           {"cells", t.n_cells},
           {"pearson", number(t.r)},
           {"spearman", number(t.rho)},
           {"roc_auc", number(t.auc)},
           {"top_decile_overlap", number(t.overlap)},
           {"effective_cells", number(t.n_effective)},
           {"p_effective", number(t.p_effective)},
           {"p_surrogate", number(t.p_surrogate)},
           {"p_without", number(t.p_without)},
           {"verdict_without", verdict_text(t.verdict_without, is_synthetic)},
           {"interval", interval(t.interval)},
           {"partial_correlation", c.is_known ? number(c.r) : Json(nullptr)},
           {"partial_interval", interval(t.conditional_interval)},
           {"bootstrap_interval", interval(t.bootstrap)},
           {"conditional_cells", number(c.n_effective)},
           {"p_conditional", number(c.p)},
           {"p_adjusted", number(t.p_adjusted)},
           {"verdict_level", number(t.level)},
           {"power", number(t.power)},
           {"index_cells", number(t.index_cells)},
           {"feature_cells", number(t.feature_cells)},
           {"leading_edge_correlation", number(t.reference.leading_edge)},
           {"rim_correlation", number(t.reference.rim)},
           {"leading_edge", choice_name(t.reference.edge)},
           {"verdict", verdict_text(t.verdict, is_synthetic)}});
      }
    return list;
  }



  Json
  json_of(const std::vector<GroupResult> &groups, const bool is_synthetic)
  {
    Json list = Json::array();
    for (const GroupResult &g : groups)
      list.push_back({{"feature", g.feature},
                      {"silent_pads", g.n_silent},
                      {"squealing_pads", g.n_squealing},
                      {"mean_silent", number(g.mean_silent)},
                      {"mean_squealing", number(g.mean_squealing)},
                      {"p", number(g.p_value)},
                      {"p_adjusted", number(g.p_adjusted)},
                      {"verdict", verdict_text(g.verdict, is_synthetic)},
                      {"reason", g.reason}});
    return list;
  }



  Table
  self_test_table(Context &context)
  {
    const CorrelationParameters &p = context.parameters.correlation;
    Timers::Section              section(context.timers, "Test: the tester");
    const std::vector<double>    links = {.3, .8};
    Progress                     progress(context.log,
                      "self test",
                      p.test_patterns.size() * p.test_lengths.size() *
                        (1 + links.size()));
    SelfTest                     test(p);
    Table                        table = empty_self_test();
    for (const SharedPattern pattern : p.test_patterns)
      for (const double length : p.test_lengths)
        {
          add_row(table, test.run(pattern, length, 0., p.n_test_pairs));
          progress.advance();
          for (const double link : links)
            {
              add_row(
                table,
                test.run(
                  pattern, length, link, std::max(100u, p.n_test_pairs / 5)));
              progress.advance();
            }
        }
    return table;
  }
} // namespace squeal::tribology
