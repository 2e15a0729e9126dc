// SPDX-License-Identifier: LGPL-2.1-or-later

// What a fit does not know: as many frequencies as numbers have no errors to
// tell, a measured shape may belong to no mode of the scene, and one of zeros
// to none at all. Arguments: the program.

#include <squeal/results/table.h>

#include "program.h"
#include "updating_scenes.h"

#include <array>
#include <cmath>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  std::string program;

  Outcome
  run(const std::string &text, const std::vector<std::string> &settings = {})
  {
    return run_text(program, text, settings);
  }

  /** With as many frequencies as numbers the fit says nothing of its errors. */
  void
  test_no_spare_frequency()
  {
    write_text("measured.csv", "name,frequency_hz,weight\n,195,1\n,318,1\n");
    const Outcome outcome =
      run(replaced_in(mass_on_spring, "Report = false", "Report = true"),
          {"Analysis = updating"});
    check(outcome.code == 0, "the fit ends well " + outcome.errors);
    const Table table = read_csv("out/updated_numbers.csv");
    for (const std::string number : {"plane", "across"})
      check(value(table, number, "identified") == 0. &&
              std::isnan(value(table, number, "interval_lower")),
            "no number counts as identified without a spare frequency");
    const std::string said = unbroken(outcome.output);
    check(said.find("as many frequencies as numbers, 2") != std::string::npos,
          "the run warns of it");
    check(said.find("matter of chance") == std::string::npos,
          "but does not say that the data hold nothing of the numbers");
    check(text_of("out/report.html").find("(not determined)") !=
            std::string::npos,
          "and neither does the headline");
  }

  /** A spring of 1e-5 of the other has next to no influence: it is not known by
   * itself, not apart from the one that is. */
  void
  test_number_without_influence()
  {
    write_text("measured.csv",
               "name,frequency_hz,weight\n,160,1\n,226,1\n,275,1\n");
    std::string text = replaced_in(
      mass_on_spring, "set Springs  = spring", "set Springs = spring, weak");
    text = replaced_in(text,
                       "  subsection Spring spring",
                       "  subsection Spring weak\n    set Body = mass\n    "
                       "set Stiffnesses = 10, 0, 0\n  end\n"
                       "  subsection Spring spring");
    text = replaced_in(
      text, "set Numbers = plane, across", "set Numbers = plane, weak");
    text =
      replaced_in(text, "subsection Number across", "subsection Number weak");
    text                  = replaced_in(text,
                       "Scene/Spring spring/Stiffnesses[3]",
                       "Scene/Spring weak/Stiffnesses[1]");
    text                  = replaced_in(text,
                       "set Lower   = 1e5\n    set Upper   = 1e8\n  end\nend",
                       "set Lower   = 1\n    set Upper   = 100\n  end\nend");
    const Outcome outcome = run(text, {"Analysis = updating"});
    check(outcome.code == 0, "the fit ends well " + outcome.errors);
    check(
      unbroken(outcome.output)
          .find(
            "the data do not identify weak: its value is a matter of chance") !=
        std::string::npos,
      "the number is not identified: " + outcome.output);
    const Table table = read_csv("out/updated_numbers.csv");
    check(value(table, "plane", "identified") == 1. &&
            value(table, "weak", "identified") == 0.,
          "the other one is");
    for (const std::string number : {"plane", "weak"})
      check(std::isnan(value(table, number, "correlation")),
            "nothing is correlated with what is not known");
  }

  /** Of pairing by shape: the mass on springs moves along the axes; the third
   * measured shape is along @p c. */
  Outcome
  fit_with_shapes(const std::array<double, 3> &c)
  {
    std::string data   = "name,frequency_hz,weight\n",
                shapes = "shape,frequency_hz,point,real,imag\n",
                text =
                  replaced_in(mass_on_spring,
                              "set Numbers = plane",
                              "set Pairing = shape\n  set Numbers = plane");
    text += "subsection Measurement\n  set Shapes file = shapes.csv\n"
            "  set Points = p0, p1, p2\n";
    const std::array<std::string, 3> names{{"a", "b", "c"}};
    for (unsigned int i = 0; i < 3; ++i)
      {
        const std::string f = shortest_text(
          std::sqrt(std::array{1.5e6, 3e6, 4e6}[i]) / (2. * M_PI));
        data += names[i] + "," + f + ",1\n";
        for (unsigned int k = 0; k < 3; ++k)
          shapes += names[i] + "," + f + ",p" + std::to_string(k) + "," +
                    shortest_text(i == 2 ? c[k] : double(i == k)) + ",0\n";
        text += "  subsection Point p" + std::to_string(i) +
                "\n    set Body = mass\n    set Direction = " +
                (i == 0   ? "1, 0, 0"
                 : i == 1 ? "0, 1, 0"
                          : "0, 0, 1") +
                "\n  end\n";
      }
    write_text("measured.csv", data);
    write_text("shapes.csv", shapes);
    return run(text + "end\n", {"Analysis = updating"});
  }

  void
  test_shapes_of_no_mode()
  {
    const std::string warned = "is like the measured shape with a MAC of";
    const Outcome     good   = fit_with_shapes({{0., 0., 2.}});
    check(good.code == 0 &&
            unbroken(good.output).find(warned) == std::string::npos,
          "measured modes are fitted without a warning " + good.errors);
    for (const double mac :
         read_csv("out/updated_frequencies.csv").reals("mac_measured"))
      check_close(mac, 1., 1e-9, "they are the modes of the scene");

    const Outcome other = fit_with_shapes({{1., 1., 1.}});
    check(other.code == 0, "a shape of no mode is paired " + other.errors);
    const Table table = read_csv("out/updated_frequencies.csv");
    check_close(table.real(2, "mac"), 1., 1e-6, "the mode is followed well");
    check_close(table.real(2, "mac_measured"),
                1. / 3.,
                1e-9,
                "its MAC with the measured shape is told");
    const std::string said = unbroken(other.output);
    check(said.find(warned) != std::string::npos &&
            said.find("at the start the measured shape 'c'") !=
              std::string::npos,
          "and is warned of at the start and at the end");
    check(said.find("1 of 3") != std::string::npos,
          "and counted on the first screen");
  }

  void
  test_zero_shape()
  {
    const Outcome outcome = fit_with_shapes({{0., 0., 0.}});
    check(outcome.code == 2 &&
            outcome.errors.find("shapes.csv: shape 'c' is zero at all points "
                                "in Measurement/Points") != std::string::npos,
          "a shape of zeros is refused: " + outcome.errors);
  }
} // namespace

int
main(int argc, char **argv)
{
  check(argc == 2, "argument: the program");
  program = argv[1];
  test_no_spare_frequency();
  test_number_without_influence();
  test_shapes_of_no_mode();
  test_zero_shape();
}
