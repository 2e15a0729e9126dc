// SPDX-License-Identifier: LGPL-2.1-or-later
// A table that is written as CSV and read back is the same to the last bit.
#include <squeal/base/exceptions.h>
#include <squeal/base/files.h>
#include <squeal/results/table.h>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <limits>
#include <random>
#include <sstream>

#include "check.h"

using namespace squeal;
using namespace squeal::testing;
using Type = Table::Type;

namespace
{
  const std::string path = "table_test.csv";

  bool
  same_bits(const double a, const double b)
  {
    return std::memcmp(&a, &b, sizeof(double)) == 0;
  }

  void
  test_bits()
  {
    using Limits               = std::numeric_limits<double>;
    std::vector<double> values = {0.,
                                  -0.,
                                  1.,
                                  0.1,
                                  1. / 3.,
                                  -1e300,
                                  Limits::denorm_min(),
                                  Limits::max(),
                                  Limits::min(),
                                  Limits::epsilon(),
                                  Limits::infinity(),
                                  9007199254740993.,
                                  12345678901234567890.,
                                  5003.9};
    std::mt19937_64     random(7);
    while (values.size() < 5000)
      {
        const std::uint64_t bits = random();
        double              value;
        std::memcpy(&value, &bits, sizeof(value));
        if (!std::isnan(value))
          values.push_back(value);
      }
    Table table({{"x", Type::real, "m", "any double"}});
    for (const double value : values)
      table.add_row({unbounded(value)});
    table.write_csv(path);
    const Table read = read_csv(path);
    check(read.n_rows() == values.size(), "every row comes back");
    bool same = true;
    for (std::size_t r = 0; r < values.size(); ++r)
      same = same && same_bits(read.real(r, "x"), values[r]);
    check(same, "every bit of 5000 doubles comes back");

    Table whole({{"x", Type::real, "", ""}});
    for (const double value : {1., -0., 0.})
      whole.add_row({value});
    whole.write_csv("table_test_whole.csv");
    const Table again = read_csv("table_test_whole.csv");
    check(same_bits(again.real(1, "x"), -0.) && again.real(0, "x") == 1.,
          "a sign of zero is kept among whole numbers");
    std::filesystem::remove("table_test_whole.csv");

    const std::string first = read_file(path);
    read.write_csv(path);
    check(read_file(path) == first, "and the same bytes are written again");
  }

  void
  test_texts()
  {
    const std::vector<std::string> texts = {
      "(0,3)+", "said \"no\"", "two\nlines", " edge ", "plain", "\"", "a,b"};
    Table table({{"index", Type::integer, "", ""},
                 {"name, quoted", Type::text, "", ""},
                 {"value", Type::real, "", ""}});
    for (std::size_t i = 0; i < texts.size(); ++i)
      table.add_row({i, texts[i], or_missing(i == 2 ? std::nan("") : 0.5 * i)});
    table.add_row({Cell(), Cell(), Cell()});
    table.write_csv(path);
    const Table read = read_csv(path);
    check(read.columns()[0].type == Type::integer &&
            read.columns()[1].type == Type::text &&
            read.columns()[2].type == Type::real,
          "types are recognised");
    bool same = true;
    for (std::size_t i = 0; i < texts.size(); ++i)
      same = same && read.text(i, "name, quoted") == texts[i];
    check(same, "commas, quotes, line ends and edge blanks come back");
    check(read.is_missing(2, "value") && std::isnan(read.real(2, "value")) &&
            read_file(path).find("nan") == std::string::npos,
          "a value that is not there is an empty cell");
    check(read.n_rows() == texts.size() + 1 && read.is_missing(7, "index") &&
            read.is_missing(7, "name, quoted"),
          "a row of nothing is still a row");
  }

  /** No table takes a number that is none, wherever it comes in. */
  void
  test_not_finite()
  {
    const double nan      = std::nan("");
    const double infinity = std::numeric_limits<double>::infinity();
    Table        table({{"index", Type::integer, "", ""},
                        {"sigma_per_s", Type::real, "1/s", ""}});
    table.add_row({1, 2.5});
    const auto refused = [](const auto &action, const std::string &what) {
      check_throws<ComputationError>(action, what, what + " is refused");
    };
    refused(
      [&]() {
        table.add_row({2, nan});
      },
      "'sigma_per_s' in row 2 is not a number");
    refused(
      [&]() {
        table.add_row({2, infinity});
      },
      "'sigma_per_s' in row 2 is infinite");
    refused([&]() { table.set(0, "sigma_per_s", -nan); },
            "'sigma_per_s' in row 1 is not a number");
    refused(
      [&]() {
        table.put_first({"e_pad", Type::real, "", ""}, nan);
      },
      "'e_pad' in row 1 is not a number");
    refused(
      [&]() {
        table.add_row({2, unbounded(nan)});
      },
      "'sigma_per_s' in row 2 is not a number");
    refused(
      [&]() {
        table.add_row({2, or_missing(infinity)});
      },
      "'sigma_per_s' in row 2 is infinite");
    check(table.n_rows() == 1 && table.real(0, "sigma_per_s") == 2.5,
          "and leaves the table as it was");
    table.add_row({2, or_missing(nan)});
    table.add_row({3, unbounded(infinity)});
    check(table.is_missing(1, "sigma_per_s") &&
            table.text(2, "sigma_per_s") == "inf",
          "what was said to be missing or infinite is taken");
  }

  void
  test_one_column_of_nothing()
  {
    Table table({{"x", Type::real, "", ""}});
    table.add_row({Cell()});
    table.add_row({1.});
    table.write_csv(path);
    check(read_csv(path).n_rows() == 2 && read_csv(path).is_missing(0, "x"),
          "a single empty cell is no blank line");
  }

  void
  test_late_columns()
  {
    Table table({{"a", Type::real, "", ""}});
    table.add_row({1});
    table.add_column({"b", Type::text, "", ""});
    check(table.is_missing(0, "b"), "a column added late is empty");
    table.set(0, "b", "now");
    check(table.text(0, "b") == "now" && table.real(0, "a") == 1.,
          "and can be filled");
    check_throws<InputError>([&] { table.real(0, "c"); },
                             "no column 'c'; the columns are: a, b",
                             "a column that is not there is named");
    check_throws<InputError>(
      [&] {
        table.add_column({"b", Table::Type::real, "", ""});
      },
      "two columns of a table would be called 'b'",
      "a name that is there already is refused");
    check_throws<InputError>(
      [&] {
        table.put_first({"a", Table::Type::real, "", ""}, 1.);
      },
      "called 'a'",
      "in front as well");
    check_throws<std::logic_error>(
      [&] {
        table.add_row({1., 2., 3.});
      },
      "3 cells",
      "a row of another length is refused");
    check_throws<std::logic_error>([&] { table.set(0, "b", 1.5); },
                                   "'b' cannot hold '1.5'",
                                   "a number is no text");
  }

  void
  test_rounding()
  {
    check(rounded_text(3519.996, 6) == "3520.00" &&
            rounded_text(999.9996, 6) == "1000.00" &&
            rounded_text(-0.000123456, 3) == "-0.000123" &&
            rounded_text(1.23456e-9, 3) == "1.23e-09" &&
            rounded_text(123456., 3) == "123456" &&
            rounded_text(1234567., 3) == "1.23e+06" &&
            rounded_text(-0., 3) == "0",
          "numbers are rounded as people write them");
    Table table({{"name", Type::text, "", ""},
                 {"f", Type::real, "Hz", "", 6, 1},
                 {"n", Type::integer, "", ""}});
    table.add_row({"µ+", 5003.94, 7});
    table.add_row({"long", 3.06, 12});
    table.add_row({"x", Cell(), 1});
    std::ostringstream out;
    table.print(out, {"n", "name", "f"}, 2);
    check(out.str() == "   n  name       f\n"
                       "  ----------------\n"
                       "   7  µ+    5003.9\n"
                       "  12  long     3.1\n"
                       "  ... and 1 more\n",
          "the printed table is aligned and cut");
    table.add_row({"y", -0.04, 1});
    table.add_row({"y", -0.06, 1});
    table.add_row({"y", -0., 1});
    table.add_row({"y", 1.234e-7, 1});
    table.add_row({"y", 0.14, 1});
    check(table.display(3, 1) == "-0.040" && table.display(4, 1) == "-0.060" &&
            table.display(5, 1) == "0.0" && table.display(6, 1) == "1.2e-07" &&
            table.display(7, 1) == "0.1",
          "what the decimals cannot show is printed all the same");
  }
} // namespace

int
main()
{
  test_bits();
  test_texts();
  test_one_column_of_nothing();
  test_not_finite();
  test_late_columns();
  test_rounding();
  std::filesystem::remove(path);
}
