// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/base64.h>
#include <squeal/base/files.h>
#include <squeal/base/run_log.h>
#include <squeal/results/column_title.h>
#include <squeal/results/html_report.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <ostream>
#include <sstream>

#include "html_report_style.h"

namespace squeal
{
  namespace
  {
    // Of what fits beside each other on a page: characters, those between
    // columns, and of a long text what is shown of it.
    constexpr std::size_t page_width = 125, column_gap = 3, longest_text = 30;

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
      return items.empty()
               ? ""
               : "<details><summary>What the columns mean</summary>\n"
                 "<dl class=\"legend\">\n" +
                   items + "</dl></details>\n";
    }

    /** Characters that a column takes. */
    std::size_t
    width_of(const Table &table, const std::size_t column)
    {
      const ColumnTitle  title(table.columns()[column]);
      std::istringstream words(title.name + " " + title.unit);
      std::size_t        width = 0;
      for (std::string word; words >> word;)
        width = std::max(width, display_width(word));
      for (std::size_t r = 0; r < table.n_rows(); ++r)
        width = std::max(
          width,
          std::min(display_width(table.display(r, column)), longest_text));
      return width + column_gap;
    }

    /** How many of the first @p columns fit beside each other, at least one. */
    std::size_t
    n_fitting(const Table &table, const std::vector<std::size_t> &columns)
    {
      std::size_t width = 0, n = 0;
      for (const std::size_t c : columns)
        {
          width += width_of(table, c);
          if (n > 0 && width > page_width)
            break;
          ++n;
        }
      return n;
    }

    /** Stands in the text until what is to be there is known. */
    std::string
    place(const std::string &kind, const std::size_t number)
    {
      return "<!-- " + kind + " " + std::to_string(number) + " -->";
    }

    void
    fill(std::string &text, const std::string &at, const std::string &with)
    {
      const std::size_t found = text.find(at);
      if (found != std::string::npos)
        text.replace(found, at.size(), with);
    }

    std::string
    link_to(const std::string &file)
    {
      return "<a href=\"" + escaped(file) + "\">" + escaped(file) + "</a>";
    }

    /** Links to the files of a picture as seen from @p folder. */
    std::string
    links_of_figure(const std::string &png, const std::filesystem::path &folder)
    {
      namespace fs = std::filesystem;
      std::string     links;
      std::error_code ignored;
      for (const char *ending : {".png", ".svg"})
        {
          const fs::path file = fs::path(png).replace_extension(ending);
          if (fs::is_regular_file(file, ignored))
            links += " " + link_to(fs::absolute(file)
                                     .lexically_normal()
                                     .lexically_proximate(folder)
                                     .string());
        }
      return links;
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
    // What the sentence says word for word is not repeated; short values may
    // stand in it by chance.
    constexpr std::size_t shortest_repeated = 12;
    if (!figures.empty())
      {
        verdict_box += "<dl class=\"figures\">\n";
        for (const auto &[name, value] : figures)
          if (value.size() < shortest_repeated ||
              headline.find(value) == std::string::npos)
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
    const std::size_t n_shown = n_fitting(table, shown);
    const auto        open    = [&](const char *tag, const std::size_t i) {
      const bool is_number =
        table.columns()[shown[i]].type != Table::Type::text;
      const std::string classes =
        std::string(is_number ? "number" : "") + (i < n_shown ? ""
                                                            : is_number ? " more"
                                                                        : "more");
      return std::string("<") + tag +
             (classes.empty() ? "" : " class=\"" + classes + "\"");
    };

    const std::size_t number = shown_tables.size();
    shown_tables.push_back({{}, table.n_rows()});
    for (const std::size_t c : shown)
      shown_tables.back().columns.push_back(table.columns()[c].name);
    body += "<div class=\"table\">";
    if (n_shown < shown.size())
      {
        const std::string id = "fold" + std::to_string(number);
        body += "<input type=\"checkbox\" class=\"fold\" id=\"" + id +
                "\"><label for=\"" + id + "\"> " +
                std::to_string(shown.size() - n_shown) +
                " more columns</label> ";
      }
    body += place("table", number);
    body +=
      "<div class=\"wide\" tabindex=\"0\"><table class=\"data\">\n<caption>" +
      escaped(caption) + "</caption>\n<thead><tr>";
    for (std::size_t i = 0; i < shown.size(); ++i)
      {
        const Table::Column &column = table.columns()[shown[i]];
        const ColumnTitle    title(column);
        body += open("th", i) + " title=\"" + escaped(column.description) +
                "\">" + escaped(title.name) + "<small>" + escaped(title.unit) +
                "</small></th>";
      }
    body += "</tr></thead>\n<tbody>\n";
    for (std::size_t r = 0; r < table.n_rows(); ++r)
      {
        const bool marked = r < highlighted.size() && highlighted[r];
        body += marked ? "<tr class=\"marked\">" : "<tr>";
        for (std::size_t i = 0; i < shown.size(); ++i)
          {
            const std::string text = escaped(table.display(r, shown[i]));
            body +=
              open("td", i) +
              (display_width(text) > longest_text ? " title=\"" + text + "\""
                                                  : "") +
              ">" + text + "</td>";
          }
        body += "</tr>\n";
      }
    body += "</tbody></table></div></div>\n";
    if (with_legend)
      body += legend_of(table, shown);
  }



  void
  HtmlReport::link_tables(const std::map<std::string, const Table *> &tables)
  {
    for (ShownTable &shown : shown_tables)
      {
        std::size_t fewest = std::numeric_limits<std::size_t>::max();
        for (const auto &[name, table] : tables)
          if (table->n_rows() >= shown.n_rows && table->n_rows() < fewest &&
              std::all_of(shown.columns.begin(),
                          shown.columns.end(),
                          [&table = table](const std::string &column) {
                            return table->has_column(column);
                          }))
            {
              shown.link = name;
              fewest     = table->n_rows();
            }
      }
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
            "\"><figcaption>" + escaped(caption) +
            place("figure", figure_files.size()) + "</figcaption></figure>\n";
    figure_files.push_back(path);
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
  HtmlReport::checks(const RunRecord &record)
  {
    section("Result checks");
    if (!record.void_checks.empty())
      {
        paragraph("Not checked, as --set '" + record.void_cause +
                  "' changes what they expect:");
        list(record.void_checks);
      }
    if (record.checks.empty())
      return;
    body += "<div class=\"wide\" "
            "tabindex=\"0\"><table>\n<thead><tr><th></th><th>check</th>"
            "<th class=\"number\">got</th><th class=\"number\">expected</th>"
            "<th class=\"number\">tolerance</th><th></th></tr></thead>\n"
            "<tbody>\n";
    for (const ResultCheck &check : record.checks)
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
    if (!record.checks.empty() || !record.void_checks.empty())
      checks(record);
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
    namespace fs     = std::filesystem;
    std::string text = body;
    for (std::size_t i = 0; i < shown_tables.size(); ++i)
      fill(text,
           place("table", i),
           shown_tables[i].link.empty() ? "" : link_to(shown_tables[i].link));
    const fs::path folder = fs::absolute(path).lexically_normal().parent_path();
    for (std::size_t i = 0; i < figure_files.size(); ++i)
      fill(text, place("figure", i), links_of_figure(figure_files[i], folder));
    write_atomically(path, [&](std::ostream &out) {
      out << "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n"
             "<meta charset=\"utf-8\">\n<meta name=\"viewport\" "
             "content=\"width=device-width, initial-scale=1\">\n<title>"
          << escaped(title) << "</title>\n<style>" << report_style
          << "</style>\n</head>\n<body>\n<main>\n<h1>" << escaped(title)
          << "</h1>\n<p class=\"subtitle\">" << escaped(subtitle) << "</p>\n"
          << verdict_box << "<nav>";
      for (std::size_t i = 0; i < section_titles.size(); ++i)
        out << "<a href=\"#" << anchor(i) << "\">" << escaped(section_titles[i])
            << "</a> ";
      out << "</nav>\n" << text << "</main>\n";
      if (!shown_tables.empty())
        out << sorting_script;
      for (const std::string &script : scripts)
        out << script;
      out << "</body>\n</html>\n";
    });
  }
} // namespace squeal
