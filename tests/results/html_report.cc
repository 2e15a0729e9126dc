// SPDX-License-Identifier: LGPL-2.1-or-later
// The report is one file that needs no other and no network.
#include <squeal/base/base64.h>
#include <squeal/base/files.h>
#include <squeal/results/html_report.h>

#include <filesystem>
#include <fstream>

#include "check.h"

using namespace squeal;
using namespace squeal::testing;
using Type = Table::Type;

namespace
{
  const std::string path = "html_report_test.html";

  std::size_t
  count(const std::string &text, const std::string &part)
  {
    std::size_t n = 0;
    for (std::size_t at = text.find(part); at != std::string::npos;
         at             = text.find(part, at + 1))
      ++n;
    return n;
  }

  bool
  has(const std::string &text, const std::string &part)
  {
    return count(text, part) > 0;
  }

  std::string
  example()
  {
    const std::string picture = std::string("\x89PNG\r\n\x1a\n") + "pixels";
    std::ofstream("html_report_test.png", std::ios::binary) << picture;
    std::ofstream("html_report_test.svg") << "<svg/>";

    Table table({{"frequency_hz", Type::real, "Hz", "f = omega/2 pi", 6, 2},
                 {"residual_rel", Type::real, "", "", 3},
                 {"name", Type::text, "", "<name>"},
                 {"support_density_kg_per_m3", Type::real, "kg/m^3", ""}});
    table.add_row({3520.0, 1.2345e-12, "(0,3)+ & <b>", 70200.});
    table.add_row({5003.9, Cell(), "(0,4)+", 7e4});

    RunRecord record;
    record.versions       = {{"squeal", "0.1.0"}};
    record.parameter_file = "prm/a.prm";
    record.parameters     = {{"Scene/Name", "<script>alert(1)</script>"}};
    record.warnings       = {"a warning"};
    ResultCheck check;
    check.name         = "first pair";
    check.reason       = "no row";
    record.checks      = {check};
    record.void_checks = {"growth"};
    record.void_cause  = "A/B = 1";
    Timers timers;
    {
      Timers::Section section(timers, "Solve: modes");
    }
    record.take_timings(timers);

    HtmlReport report("Title & more", "subtitle");
    report.set_verdict(
      HtmlReport::Verdict::bad, "2 unstable pairs", {{"worst", "438.6 1/s"}});
    report.section("Pairs");
    report.paragraph("text");
    report.table(table, "caption", {}, {false, true});
    Table wide = table;
    for (int i = 0; i < 20; ++i)
      wide.add_column({"number_" + std::to_string(i), Type::real, "", ""});
    report.table(wide, "wide");
    report.table(
      Table(std::vector<Table::Column>{{"elsewhere", Type::real, "", ""}}),
      "in no file");
    report.figure("html_report_test.png", "one", true);
    report.figure("html_report_test.png", "two", true);
    report.figure("html_report_test.png", "three");
    report.figure("not_there.png", "four");
    report.run_record(record, "./squeal run prm/a.prm");
    const Table fewer(wide.columns());
    report.link_tables({{"all.csv", &wide}, {"other.csv", &fewer}});
    report.write(path);
    check_throws<std::exception>([&] { report.table(table, "", {"none"}); },
                                 "no column 'none'",
                                 "a column that is not there is named");
    return base64(picture);
  }
} // namespace

int
main()
{
  const std::string picture = example();
  const std::string html    = read_file(path);

  check(!has(html, "http:") && !has(html, "https:") && !has(html, "//cdn") &&
          !has(html, "url(") && !has(html, "@import") && !has(html, "<link") &&
          !has(html, "<script "),
        "nothing is read from outside of the file");
  check(count(html, "<script>") == 1 && count(html, "</script>") == 1 &&
          has(html, "aria-sort"),
        "one script sorts the tables");
  check(count(html, "src=\"") == count(html, "src=\"data:image/png;base64,"),
        "every picture is inside");
  check(count(html, "href=\"") ==
          count(html, "href=\"#part") +
            count(html, "href=\"html_report_test.png\"") +
            count(html, "href=\"html_report_test.svg\"") +
            count(html, "href=\"all.csv\""),
        "links stay in the page or lead to files beside it");
  check(count(html, "href=\"html_report_test.png\"") == 3 &&
          count(html, "href=\"html_report_test.svg\"") == 3,
        "every chart leads to its files");
  check(count(html, "href=\"all.csv\"") == 2 && !has(html, "other.csv"),
        "a table leads to the file that holds its columns and rows");
  const std::size_t n_more = count(html, "<th class=\"number more\"");
  check(n_more > 0 && n_more < 20 && count(html, "class=\"fold\"") == 1 &&
          has(html,
              "<label for=\"fold1\"> " + std::to_string(n_more) +
                " more columns</label>"),
        "columns that do not fit fold out");
  check(count(html, "<!-- ") == count(html, "<!-- row -->"),
        "no place is left unfilled");
  check(has(html, "<li>growth</li>") && has(html, "--set 'A/B = 1'"),
        "checks that a setting has made void are named with it");
  for (std::size_t i = 0; i < count(html, "href=\"#part"); ++i)
    check(has(html, "id=\"part" + std::to_string(i) + "\""),
          "link " + std::to_string(i) + " has its place");
  check(count(html, picture) == 3, "the three pictures that exist are in it");
  check(count(html, "<div class=\"row\">") == 1 &&
          count(html, "<figure class=\"narrow\">") == 2,
        "two narrow figures share a row");
  check(has(html, "Title &amp; more") && has(html, "(0,3)+ &amp; &lt;b&gt;") &&
          has(html, "&lt;script&gt;"),
        "texts are escaped");
  check(has(html, "3520.00") && has(html, "1.23e-12") &&
          has(html, "frequency<small>Hz</small>") &&
          has(html, "residual<small>relative</small>") &&
          has(html, "support density<small>kg/m^3</small>"),
        "numbers are rounded under headings with units");
  check(count(html, "<tr class=\"marked\">") == 1, "one row is tinted");
  check(has(html, "2 unstable pairs") && has(html, "438.6 1/s") &&
          has(html, "a warning") && has(html, "Solve: modes") &&
          has(html, "FAILED") && has(html, "./squeal run prm/a.prm") &&
          has(html, "prm/a.prm"),
        "verdict, warning, times, checks and command are there");
  for (const std::string tag :
       {"div", "table", "tr", "td", "th", "figure", "dl", "ul", "h2", "main"})
    check(count(html, "<" + tag + ">") + count(html, "<" + tag + " ") ==
            count(html, "</" + tag + ">"),
          "each <" + tag + "> is closed");
  std::filesystem::remove(path);
  std::filesystem::remove("html_report_test.png");
  std::filesystem::remove("html_report_test.svg");
}
