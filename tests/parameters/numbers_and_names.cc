// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Numbers are read exactly or not at all, and a typo finds the name meant.
#include <squeal/parameters/names.h>
#include <squeal/parameters/numbers.h>
#include <squeal/parameters/text.h>

#include "check.h"

using namespace squeal;
using namespace squeal::testing;

namespace
{
  void
  numbers()
  {
    check(prm::parse_number("2.5e10") == 2.5e10, "2.5e10");
    check(prm::parse_number("-3") == -3., "-3");
    check(prm::parse_number("+.5") == .5, "+.5");
    check(prm::parse_number("10^3") == 1000., "10^3");
    check(prm::parse_number("-10^2") == -100., "-10^2 is -(10^2)");
    check(prm::parse_number("2 ^ -1") == 0.5, "2 ^ -1");
    check_close(prm::parse_number("10^10.4").value(),
                25118864315.09580,
                1e-14, // pow() is good to a few units in the last place
                "10^10.4");
    for (const char *text : {"",
                             " ",
                             "nan",
                             "inf",
                             "-inf",
                             "1,2",
                             "1e999",
                             "0x10",
                             "1 2",
                             "+-1",
                             "1e",
                             "10^",
                             "^2",
                             "0^1",
                             "10^400",
                             "1m",
                             "10^10^2"})
      check(!prm::parse_number(text),
            "'" + std::string(text) + "' is no number");
  }



  void
  numbers_survive_printing()
  {
    for (const double number :
         {0.1, 210e9, 1e-8, -2.5895e8, 1. / 3., 4.9e-324, 1.7e308, 0., 3e14})
      check(prm::parse_number(prm::format_number(number)) == number,
            prm::format_number(number) + " is read back exactly");
    check(prm::format_number(2.1e11) == "2.1e11", "no e+11");
    check(prm::format_number(1e-8) == "1e-8", "no e-08");
    check(prm::format_number(1e100) == "1e100", "zeros of exponents stay");
    check(prm::format_number(-0.) == "0", "no -0");
  }



  void
  distances()
  {
    check(prm::edit_distance("pad", "pad") == 0, "same");
    check(prm::edit_distance("Pad", "pad") == 0, "case does not count");
    check(prm::edit_distance("", "abc") == 3, "insertions");
    check(prm::edit_distance("Yuong", "Young") == 1, "swap of neighbours");
    check(prm::edit_distance("kitten", "sitting") == 3, "kitten, sitting");
    check(prm::edit_distance("ca", "abc") == 3, "a swap is not edited further");
  }



  void
  nearest_names()
  {
    const std::vector<std::string> names = {
      "Density", "Young modulus", "Young moduli"};
    check(prm::nearest_name("Yuong modulus", names) == "Young modulus",
          "the nearest of several");
    check(prm::nearest_name("Densty", names) == "Density", "a letter missing");
    check(prm::nearest_name("Colour", names).empty(),
          "nothing is suggested for another word");
    check(prm::nearest_name("x", {"y", "z"}).empty(),
          "nothing is suggested when no letter agrees");
  }



  void
  identifiers()
  {
    for (const char *name : {"pad", "Pad_2", "x"})
      check(prm::is_identifier(name), std::string(name) + " is a name");
    for (const char *name : {"", "2pad", "_a", "a b", "a/b", "a-b", "ü"})
      check(!prm::is_identifier(name),
            "'" + std::string(name) + "' is no name");
    check(prm::fault_of_names({"a", "b"}).empty(), "two names");
    check(!prm::fault_of_names({"a", "a"}).empty(), "one name twice");
  }



  void
  texts()
  {
    check(prm::split(" a, b ,,c ", ',') ==
            std::vector<std::string>({"a", "b", "", "c"}),
          "parts are trimmed, empty ones stay");
    check(prm::split("  ", ',').empty(), "a blank text has no parts");
    check(prm::collapse_blanks("  a \t b ") == "a b", "blanks collapse");
    for (const char *text : {"plain", "\u00b5", "\u20ac", "\U0001f600"})
      check(prm::is_utf8(text), std::string(text) + " is UTF-8");
    for (const char *text :
         {"\xb5", "\xc2", "\xc0\x80", "\xed\xa0\x80", "\xf5\x80\x80\x80"})
      check(!prm::is_utf8(text), "a broken letter is not UTF-8");
    check(prm::in_quotes("a\nb") == "'a?b'", "an error stays in one line");
  }
} // namespace

int
main()
{
  numbers();
  numbers_survive_printing();
  distances();
  nearest_names();
  identifiers();
  texts();
}
