// SPDX-License-Identifier: LGPL-2.1-or-later
// Expected values of a parameter file pass, fail, and fail when there is
// nothing to compare.
#include <squeal/base/exceptions.h>
#include <squeal/base/run_log.h>
#include <squeal/results/result_checks.h>

#include <cmath>
#include <sstream>

#include "check.h"

using namespace squeal;
using namespace squeal::testing;
using Type = Table::Type;

namespace
{
  Table
  example()
  {
    Table table({{"index", Type::integer, "", ""},
                 {"frequency_hz", Type::real, "Hz", ""},
                 {"sigma_per_s", Type::real, "1/s", ""},
                 {"name", Type::text, "", ""}});
    table.add_row({1, 1629.7, -5., "(0,0)"});
    table.add_row({2, 3520., 94., "pad and support"});
    table.add_row({3, 5003.9, 438.6, "(0,4)+"});
    table.add_row({4, 5004.1, -531., "(0,4)+"});
    table.add_row({5, Cell(), 1., "(9,9)"});
    return table;
  }

  ResultCheck
  evaluate(const std::string &where,
           const std::string &nearest,
           const std::string &column,
           const double       expected,
           const double       relative,
           const double       absolute = 0.,
           const std::string &name     = "eigenvalues.csv")
  {
    ResultCheckParameters asked;
    asked.name               = "check";
    asked.table              = name;
    asked.where              = where;
    asked.nearest            = nearest;
    asked.column             = column;
    asked.expected           = expected;
    asked.relative_tolerance = relative;
    asked.absolute_tolerance = absolute;
    const Table table        = example();
    return evaluate_result_checks({asked}, {{"eigenvalues.csv", &table}})
      .front();
  }

  void
  fails(const ResultCheck &result,
        const std::string &reason,
        const std::string &claim)
  {
    check(!result.passed && !result.has_value &&
            result.line().find("FAILED") == 0 &&
            result.line().find(reason) != std::string::npos,
          claim + " (" + result.line() + ")");
  }

  void
  test_values()
  {
    check(evaluate("name = (0,0)", "", "frequency_hz", 1629.68, 1e-4).passed,
          "a value within the relative tolerance passes");
    check(!evaluate("name = (0,0)", "", "frequency_hz", 1629.68, 1e-6).passed,
          "and fails a tighter one");
    check(evaluate("index = 1", "", "sigma_per_s", -5.2, 0., 0.21).passed &&
            !evaluate("index = 1", "", "sigma_per_s", -5.2, 0., 0.19).passed,
          "the absolute tolerance decides likewise");
    check(evaluate("index = 1", "", "sigma_per_s", -5.2, 0.05, 0.01).passed,
          "the larger of the two tolerances holds");
    check(evaluate("index = 2", "", "frequency_hz", 3520., 0.).passed,
          "tolerance zero asks for equality");
    const ResultCheck failed =
      evaluate("index = 2", "", "frequency_hz", 3500., 1e-3);
    check(failed.line() == "FAILED  check: got 3520.0000, expected 3500.0000, "
                           "tolerance 3.50",
          "the line tells what came out: " + failed.line());
  }

  void
  test_selection()
  {
    check(
      evaluate(
        "sigma_per_s > 0", "frequency_hz = 5000", "sigma_per_s", 438.6, 1e-9)
        .passed,
      "the nearest of the selected rows is taken");
    check(evaluate("", "frequency_hz = 3400", "index", 2, 0.).passed,
          "without a condition the nearest of all");
    check(
      evaluate("sigma_per_s > 0 and frequency_hz < 9000", "", "count", 2, 0.)
        .passed,
      "conditions are joined and rows are counted; a missing value meets "
      "none");
    check(evaluate("name = (5,5)", "", "count", 0, 0.).passed,
          "counting no rows is a result");
    const std::string none =
      evaluate("name = (5,5)", "", "count", 0, 0.).line();
    check(none.find("(no row has name = (5,5))") != std::string::npos,
          "and the text that no row has is told: " + none);
    const std::string apart =
      evaluate("name = (0,0) and index = 2", "", "count", 0, 0.).line();
    check(apart.find("(no row)") != std::string::npos,
          "or that conditions meet in no row: " + apart);
    check(evaluate("name != (0,4)+", "", "count", 3, 0.).passed &&
            evaluate("frequency_hz >= 5004.1", "", "count", 1, 0.).passed &&
            evaluate("frequency_hz <= 5004.1", "", "count", 4, 0.).passed &&
            evaluate("index != 5", "", "count", 4, 0.).passed,
          "the other comparisons hold");
    check(
      evaluate("frequency_hz = 5003.900000000001", "", "index", 3, 0.).passed,
      "numbers that differ by rounding are equal");
    check(
      evaluate("frequency_hz != 5003.900000000001", "", "count", 4, 0.).passed,
      "and not unequal");
    check(evaluate("name = (0,4)+", "", "frequency_hz", 5004., 1e-4).passed,
          "of several rows all must pass");
    const ResultCheck worst =
      evaluate("name = (0,4)+", "", "sigma_per_s", 438., 0.01);
    check(!worst.passed && worst.got == -531. && worst.n_rows == 2,
          "and the worst is reported: " + worst.line());
  }

  void
  test_nothing_to_compare()
  {
    fails(evaluate("name = (5,5)", "", "frequency_hz", 1., 1.),
          "no row has name = (5,5)",
          "a check that selects nothing fails");
    fails(evaluate("", "", "frequenzy", 1., 1.),
          "no column 'frequenzy'",
          "a column that does not exist fails");
    fails(evaluate("mode = 1", "", "frequency_hz", 1., 1.),
          "no column 'mode'",
          "so does one in the condition");
    fails(evaluate("", "f = 1", "frequency_hz", 1., 1.),
          "no column 'f'",
          "and one to be near to");
    fails(evaluate("", "frequency_hz = 3520", "count", 1., 1.),
          "'Nearest' takes one row",
          "the rows that are nearest are not counted");
    fails(evaluate("", "frequency_hz ~ 1", "frequency_hz", 1., 1.),
          "is no condition",
          "a condition without comparison fails");
    fails(evaluate("", "frequency_hz = high", "frequency_hz", 1., 1.),
          "'column = number'",
          "nearest to a word fails");
    fails(evaluate("index = one", "", "index", 1., 1.),
          "holds numbers, not 'one'",
          "a number compared with a word fails");
    fails(evaluate("index = 1", "", "name", 1., 1.),
          "holds texts",
          "a text cannot be compared");
    fails(evaluate("index = 5", "", "frequency_hz", 1., 1e9),
          "no value in row 5",
          "a missing value fails whatever the tolerance");
    fails(evaluate("", "", "count", 1., 1., 0., "modes.csv"),
          "no table 'modes.csv'; the tables are: eigenvalues.csv",
          "a table that is not there fails");
  }

  void
  test_report()
  {
    const std::vector<ResultCheck> results = {evaluate("", "", "count", 5, 0.),
                                              evaluate("", "", "count", 6, 0.)};
    std::ostringstream             console;
    RunLog                         log(true, console);
    print_result_checks(results, log);
    check(console.str().find("  ok      check: got 5") != std::string::npos &&
            console.str().find("  FAILED  check: got 5") != std::string::npos,
          "each check has its line");
    check_throws<CheckError>([&] { require_passed(results); },
                             "1 of 2 result checks failed: check",
                             "a failed check ends the run");
    require_passed({results[0]});
    require_passed({});
  }
} // namespace

int
main()
{
  test_values();
  test_selection();
  test_nothing_to_compare();
  test_report();
}
