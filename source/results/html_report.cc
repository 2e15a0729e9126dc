// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/base64.h>
#include <squeal/base/files.h>
#include <squeal/base/run_log.h>
#include <squeal/results/column_title.h>
#include <squeal/results/html_report.h>

#include <algorithm>
#include <filesystem>
#include <ostream>

namespace squeal
{
  namespace
  {
    const char style[] = R"(
:root { --ink: #1d2733; --faint: #5b6775; --rule: #d9dee4; --good: #00795a;
  --bad: #b84a00; --neutral: #0072b2; }
* { box-sizing: border-box; }
body { margin: 0; background: #f4f6f8; color: var(--ink);
  font: 15px/1.5 "DejaVu Sans", "Segoe UI", Helvetica, Arial, sans-serif; }
main { max-width: 1180px; margin: 0 auto; padding: 2rem 2.5rem 3rem;
  background: #fff; }
h1 { font-size: 1.8rem; margin: 0; }
.subtitle { color: var(--faint); margin: .2rem 0 1.4rem; }
h2 { font-size: 1.25rem; margin: 2.4rem 0 .8rem; padding-bottom: .25rem;
  border-bottom: 2px solid var(--rule); }
.verdict { border-left: .5rem solid var(--neutral); background: #f4f7fa;
  padding: 1rem 1.3rem; }
.verdict.good { border-color: var(--good); }
.verdict.bad { border-color: var(--bad); background: #fdf3ec; }
.verdict strong { font-size: 1.35rem; color: var(--neutral); }
.verdict.good strong { color: var(--good); }
.verdict.bad strong { color: var(--bad); }
.figures { display: flex; flex-wrap: wrap; gap: .5rem 2.2rem; margin: .7rem 0 0; }
.figures div { min-width: 8rem; }
.figures dt { color: var(--faint); font-size: .82rem; }
.figures dd { margin: 0; font-weight: 600; }
nav { margin: 1.2rem 0 0; font-size: .9rem; }
nav a { color: var(--neutral); text-decoration: none; margin-right: 1.1rem; }
/* A table that goes on beyond the right edge has a shadow there: a cover that
   moves with the table hides it at the end. */
.wide { overflow-x: auto; background:
  linear-gradient(to left, #fff 40%, #fff0) 100% 0 / 3rem 100% local no-repeat,
  linear-gradient(to left, #1d273340, #fff0) 100% 0 / 1rem 100% scroll
    no-repeat; }
table { border-collapse: collapse; font-size: .84rem; margin: .4rem 0; }
caption { text-align: left; color: var(--faint); padding-bottom: .4rem; }
th { text-align: left; vertical-align: bottom; font-weight: 600;
  border-bottom: 2px solid var(--ink); padding: .25rem .7rem .25rem 0; }
th small { display: block; font-weight: 400; color: var(--faint); }
td { border-bottom: 1px solid var(--rule); padding: .2rem .7rem .2rem 0;
  vertical-align: top; }
th.number { text-align: right; padding-left: .7rem; vertical-align: bottom; }
td.number { text-align: right; white-space: nowrap;
  font-variant-numeric: tabular-nums; padding-left: .7rem; }
tr.marked td { background: #fdeadd; font-weight: 600; }
table.data td:not(.number) { min-width: 5.5em; }
/* What a row is about stays in sight. */
.wide th:first-child, .wide td:first-child { position: sticky; left: 0;
  background: #fff; }
.wide tr.marked td:first-child { background: #fdeadd; }
td.ok { color: var(--good); font-weight: 600; }
td.failed { color: var(--bad); font-weight: 600; }
dl.legend { font-size: .8rem; color: var(--faint); columns: 2; margin: .3rem 0; }
dl.legend div { break-inside: avoid; }
dl.legend dt { display: inline; font-weight: 600; }
dl.legend dd { display: inline; margin: 0; }
dl.legend dd::after { content: ""; display: block; }
.row { display: flex; flex-wrap: wrap; gap: 1rem 2%; }
figure { margin: 1rem 0; width: 100%; }
figure.narrow { width: 49%; }
figure img { width: 100%; border: 1px solid var(--rule); }
figcaption { color: var(--faint); font-size: .86rem; }
pre { background: #f4f7fa; padding: .8rem 1rem; overflow-x: auto;
  font-size: .86rem; }
table.pairs td:first-child { color: var(--faint); }
table.pairs td { overflow-wrap: anywhere; }
@media print { body { background: #fff; font-size: 10.5pt; }
  main { padding: 0; max-width: none; } nav { display: none; }
  figure, tr, .verdict, pre { break-inside: avoid; } h2 { break-after: avoid; }
  .wide { overflow: visible; background: none; } table { font-size: 7.5pt; }
  table.data td { white-space: normal; } th, td { padding-right: .35rem; }
  td.number, th.number { padding-left: .2rem; } }
)";

    std::string
    escaped(const std::string &text)
    {
      std::string result;
      for (const char c : text)
        switch (c)
          {
          case '&':
            result += "&amp;";
            break;
          case '<':
            result += "&lt;";
            break;
          case '>':
            result += "&gt;";
            break;
          case '"':
            result += "&quot;";
            break;
          default:
            result += c;
          }
      return result;
    }

    std::string
    anchor(const std::size_t number)
    {
      return "part" + std::to_string(number);
    }

    std::string
    legend_of(const Table &table, const std::vector<std::size_t> &columns)
    {
      std::string items;
      for (const std::size_t c : columns)
        {
          const Table::Column &column = table.columns()[c];
          if (!column.description.empty())
            items += "<div><dt>" + escaped(ColumnTitle(column).name) +
                     "</dt> <dd>" + escaped(column.description) +
                     "</dd></div>\n";
        }
      return items.empty() ? "" : "<dl class=\"legend\">\n" + items + "</dl>\n";
    }
  } // namespace



  HtmlReport::HtmlReport(const std::string &title, const std::string &subtitle)
    : title(title)
    , subtitle(subtitle)
  {
  }



  void
  HtmlReport::set_verdict(const Verdict           verdict,
                          const std::string      &headline,
                          const RunRecord::Pairs &figures)
  {
    const char *kind = verdict == Verdict::good  ? " good"
                       : verdict == Verdict::bad ? " bad"
                                                 : "";
    verdict_box = std::string("<div class=\"verdict") + kind + "\">\n<strong>" +
                  escaped(headline) + "</strong>\n";
    if (!figures.empty())
      {
        verdict_box += "<dl class=\"figures\">\n";
        for (const auto &[name, value] : figures)
          verdict_box += "<div><dt>" + escaped(name) + "</dt><dd>" +
                         escaped(value) + "</dd></div>\n";
        verdict_box += "</dl>\n";
      }
    verdict_box += "</div>\n";
  }



  void
  HtmlReport::section(const std::string &section_title)
  {
    body += "<h2 id=\"" + anchor(section_titles.size()) + "\">" +
            escaped(section_title) + "</h2>\n";
    section_titles.push_back(section_title);
  }



  void
  HtmlReport::paragraph(const std::string &text)
  {
    body += "<p>" + escaped(text) + "</p>\n";
  }



  void
  HtmlReport::table(const Table                    &table,
                    const std::string              &caption,
                    const std::vector<std::string> &names,
                    const std::vector<bool>        &highlighted,
                    const bool                      with_legend)
  {
    std::vector<std::size_t> shown;
    for (const std::string &name : names)
      shown.push_back(table.column_index(name));
    for (std::size_t c = 0; names.empty() && c < table.columns().size(); ++c)
      shown.push_back(c);
    const auto class_of = [&](const std::size_t c) {
      return table.columns()[c].type == Table::Type::text ? ""
                                                          : " class=\"number\"";
    };

    body +=
      "<div class=\"wide\" tabindex=\"0\"><table class=\"data\">\n<caption>" +
      escaped(caption) + "</caption>\n<thead><tr>";
    for (const std::size_t c : shown)
      {
        const Table::Column &column = table.columns()[c];
        const ColumnTitle    title(column);
        body += std::string("<th") + class_of(c) + " title=\"" +
                escaped(column.description) + "\">" + escaped(title.name) +
                "<small>" + escaped(title.unit) + "</small></th>";
      }
    body += "</tr></thead>\n<tbody>\n";
    for (std::size_t r = 0; r < table.n_rows(); ++r)
      {
        const bool marked = r < highlighted.size() && highlighted[r];
        body += marked ? "<tr class=\"marked\">" : "<tr>";
        for (const std::size_t c : shown)
          body += std::string("<td") + class_of(c) + ">" +
                  escaped(table.display(r, c)) + "</td>";
        body += "</tr>\n";
      }
    body += "</tbody></table></div>\n";
    if (with_legend)
      body += legend_of(table, shown);
  }



  void
  HtmlReport::figure(const std::string &path,
                     const std::string &caption,
                     const bool         narrow)
  {
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(path, ignored))
      return;
    // neighbouring narrow figures share one row
    const std::string row = "<div class=\"row\">\n", end = "</div>\n";
    const std::string mark = "<!-- row -->\n";
    const bool        continues =
      narrow && body.size() >= mark.size() + end.size() &&
      body.compare(body.size() - mark.size(), mark.size(), mark) == 0;
    if (continues)
      body.erase(body.size() - mark.size() - end.size());
    else if (narrow)
      body += row;
    body += std::string("<figure") + (narrow ? " class=\"narrow\"" : "") +
            "><img alt=\"" + escaped(caption) +
            "\" src=\"data:image/png;base64," + base64(read_file(path)) +
            "\"><figcaption>" + escaped(caption) + "</figcaption></figure>\n";
    if (narrow)
      body += end + mark;
  }



  void
  HtmlReport::interactive(const std::string &markup, const std::string &more)
  {
    body += markup;
    if (std::find(scripts.begin(), scripts.end(), more) == scripts.end())
      scripts.push_back(more);
  }



  void
  HtmlReport::pairs(const RunRecord::Pairs &list, const std::string &caption)
  {
    body += "<table class=\"pairs\">\n<caption>" + escaped(caption) +
            "</caption>\n<tbody>\n";
    for (const auto &[name, value] : list)
      body += "<tr><td>" + escaped(name) + "</td><td>" + escaped(value) +
              "</td></tr>\n";
    body += "</tbody></table>\n";
  }



  void
  HtmlReport::list(const std::vector<std::string> &items)
  {
    body += "<ul>\n";
    for (const std::string &item : items)
      body += "<li>" + escaped(item) + "</li>\n";
    body += "</ul>\n";
  }



  void
  HtmlReport::code(const std::string &text)
  {
    body += "<pre>" + escaped(text) + "</pre>\n";
  }



  void
  HtmlReport::checks(const std::vector<ResultCheck> &results)
  {
    section("Result checks");
    body += "<div class=\"wide\" "
            "tabindex=\"0\"><table>\n<thead><tr><th></th><th>check</th>"
            "<th class=\"number\">got</th><th class=\"number\">expected</th>"
            "<th class=\"number\">tolerance</th><th></th></tr></thead>\n"
            "<tbody>\n";
    for (const ResultCheck &check : results)
      body +=
        std::string("<tr>") +
        (check.passed ? "<td class=\"ok\">ok" : "<td class=\"failed\">FAILED") +
        "</td><td>" + escaped(check.name) + "</td><td class=\"number\">" +
        (check.has_value ? rounded_text(check.got, 8) : "") +
        "</td><td class=\"number\">" + rounded_text(check.expected, 8) +
        "</td><td class=\"number\">" + rounded_text(check.tolerance, 3) +
        "</td><td>" + escaped(check.reason) + "</td></tr>\n";
    body += "</tbody></table></div>\n";
  }



  void
  HtmlReport::timings(const RunRecord &record)
  {
    section("Times and memory");
    using Type = Table::Type;
    Table times({{"section", Type::text, "", ""},
                 {"calls", Type::integer, "", ""},
                 {"wall", Type::real, "s", "with the sections inside", 6, 2},
                 {"own wall", Type::real, "s", "without them", 6, 2},
                 {"own CPU", Type::real, "s", "all threads", 6, 2}});
    for (const Timers::Entry &entry : record.timings)
      times.add_row(
        {entry.name, entry.count, entry.wall, entry.own_wall, entry.own_cpu});
    table(times,
          "Total " + format_duration(record.total_wall) + ", CPU " +
            format_duration(record.total_cpu) + ", peak memory " +
            rounded_text(record.peak_memory_mb, 4) + " MB, " +
            std::to_string(record.n_ranks) +
            (record.n_ranks == 1 ? " process" : " processes"),
          {},
          {},
          false);
  }



  void
  HtmlReport::run_record(const RunRecord &record, const std::string &command)
  {
    if (!record.checks.empty())
      checks(record.checks);
    if (!record.warnings.empty())
      {
        section("Warnings");
        list(record.warnings);
      }
    timings(record);
    section("How to repeat this run");
    code(command);
    pairs(record.versions, "Versions used");
    section("Parameters");
    pairs(record.parameters,
          "Every entry as used, read from " + record.parameter_file);
  }



  void
  HtmlReport::write(const std::string &path) const
  {
    write_atomically(path, [&](std::ostream &out) {
      out << "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n"
             "<meta charset=\"utf-8\">\n<meta name=\"viewport\" "
             "content=\"width=device-width, initial-scale=1\">\n<title>"
          << escaped(title) << "</title>\n<style>" << style
          << "</style>\n</head>\n<body>\n<main>\n<h1>" << escaped(title)
          << "</h1>\n<p class=\"subtitle\">" << escaped(subtitle) << "</p>\n"
          << verdict_box << "<nav>";
      for (std::size_t i = 0; i < section_titles.size(); ++i)
        out << "<a href=\"#" << anchor(i) << "\">" << escaped(section_titles[i])
            << "</a> ";
      out << "</nav>\n" << body << "</main>\n";
      for (const std::string &script : scripts)
        out << script;
      out << "</body>\n</html>\n";
    });
  }
} // namespace squeal
