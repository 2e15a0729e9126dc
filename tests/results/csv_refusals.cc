// SPDX-License-Identifier: LGPL-2.1-or-later
// A CSV file that is not what it should be is refused with file and line.
#include <squeal/base/exceptions.h>
#include <squeal/results/table.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "check.h"

using namespace squeal;
using namespace squeal::testing;
using Type = Table::Type;

namespace
{
  const std::string path = "csv_refusals_test.csv";

  void
  refused(const std::string                &content,
          const std::string                &message,
          const std::string                &claim,
          const std::vector<Table::Column> &required = {})
  {
    std::ofstream(path, std::ios::binary) << content;
    check_throws<InputError>([&] { read_csv(path, required); }, message, claim);
    try
      {
        read_csv(path, required);
      }
    catch (const InputError &e)
      {
        check(std::string(e.what()).find('\n') == std::string::npos,
              "... in one line");
      }
  }

  Table
  accepted(const std::string &content)
  {
    std::ofstream(path, std::ios::binary) << content;
    return read_csv(path);
  }
} // namespace

int
main()
{
  const std::vector<Table::Column> time  = {{"time_s", Type::real, "s", ""}};
  const std::vector<Table::Column> index = {{"index", Type::integer, "", ""}};

  refused("", "is empty", "an empty file");
  refused("\n \n\r\n", "is empty", "a file of blank lines");
  refused("a,b\n1,2\n\n3\n",
          path + ":4: 1 cells where the header names 2",
          "a short row");
  refused("a,b\n1,2,3\n", path + ":2: 3 cells", "a long row");
  refused("\"a\nb\",\"a\nb\"\n1,2\n",
          path + ":1: the name of column 1 has more than one line",
          "a name of two lines");
  refused("a\n\"1\n2\"\n",
          "column 'a': '1?2' is not a number",
          "a cell of two lines",
          {{"a", Type::real, "", ""}});
  refused("a,b\n1,nan\n",
          path + ":2: column 'b': 'nan' is not a number",
          "NaN in a column of numbers");
  refused("a,b\n1,2\n1,-NaN\n", path + ":3: column 'b'", "NaN of another kind");
  refused("time,force\n1,2\n",
          path + ":1: the column 'time_s' is missing; the columns are: time, "
                 "force",
          "a required column that is missing",
          time);
  refused("time_s\n0.1\n0,2\n", path + ":3: 2 cells", "a decimal comma");
  refused("time_s\n0.1\n0.2s\n",
          path + ":3: column 'time_s': '0.2s' is not a number",
          "a word where a number is required",
          time);
  refused("index\n1\n2.5\n",
          path + ":3: column 'index': '2.5' is not an integer",
          "a fraction where an integer is required",
          index);
  refused("a,a\n1,2\n", path + ":1: two columns 'a'", "a column twice");
  refused("a,,c\n1,2,3\n", path + ":1: column 2 has no name", "a nameless one");
  refused("a\n\"open\n1\n", path + ":2: a quote is opened", "an open quote");
  refused(std::string("a\n1\0\n", 5),
          path + ":2: bytes that are no text",
          "binary garbage");
  check_throws<InputError>([] { read_csv("no/such.csv"); },
                           "no/such.csv': No such file",
                           "a missing file is named");
  check_throws<InputError>(
    [] { read_csv("."); }, "Is a directory", "a directory is named");

  const Table table =
    accepted("\xEF\xBB\xBF"
             "a , b\r\n 1 ,\"x, \"\"y\"\"\nz\"\r\n\r\n+2.5,w\r\n");
  check(table.n_rows() == 2 && table.real(1, "a") == 2.5 &&
          table.text(0, "b") == "x, \"y\"\nz",
        "byte order mark, \\r\\n, blanks, quotes and blank lines are read");
  check(accepted("a,b\r1,2\r3,4\r").real(1, "b") == 4.,
        "lines may all end with a carriage return");
  refused("a\n1\r2\n",
          path + ":2: a carriage return within the line",
          "one between two numbers, which would be one");
  check(accepted("a,b\n").n_rows() == 0, "a header alone is a table");
  check(accepted("a\n1").n_rows() == 1, "the last line needs no end");
  check(accepted("name\nnan\nother\n").text(0, "name") == "nan",
        "a mode may be called nan");
  std::filesystem::remove(path);

  // what spreadsheets of other countries write
  const std::string mark  = "\xEF\xBB\xBF";
  const Table       comma = accepted("a,b,name\n1.5,-2e-3,x\n,4,\"y,z\"\n");
  for (const std::string &other :
       {mark + "a;b;name\r\n1,5;-2e-3;x\r\n;4;y,z\r\n",
        std::string("\n\"a\";\"b\";\"name\"\n1.5;-0.002;x\n;4;\"y,z\"\n"),
        mark + "a\tb\tname\n1,5\t-2e-3\tx\n\t4\ty,z\n"})
    {
      const Table table = accepted(other);
      check(table.n_rows() == 2 && table.real(0, "a") == comma.real(0, "a") &&
              table.real(0, "b") == comma.real(0, "b") &&
              table.is_missing(1, "a") && table.text(1, "name") == "y,z",
            "semicolons or tabs, decimal commas or points, a byte-order mark");
    }
  refused("a;b\n1,5;2.5\n",
          path + ":2: '2.5': decimal commas and decimal points in one table",
          "both decimal marks");
  refused("a;b\n1.234,5;2\n",
          path + ":2: '1.234,5': decimal commas and decimal points",
          "points between thousands");
  refused("a,b\n1,5,2,5\n",
          "decimal commas, put semicolons between",
          "decimal commas between commas");
  refused("\xFF\xFE\x61",
          "is UTF-16 text: save it as UTF-8",
          "a spreadsheet's Unicode text");
}
