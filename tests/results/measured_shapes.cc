// SPDX-License-Identifier: LGPL-2.1-or-later

// Motions of nodes that a universal file gives in a system of its own: turned
// into the global axes, or refused where the system is not known. Datasets of
// stress and strain are no shapes.
#include <squeal/base/exceptions.h>
#include <squeal/base/run_log.h>
#include <squeal/parameters/response_parameters.h>
#include <squeal/results/measured_shapes.h>

#include <cstdio>
#include <fstream>
#include <sstream>

#include "check.h"

using namespace squeal;
using namespace squeal::testing;

namespace
{
  /** A line of fields, each as @p format of printf. */
  template <typename Number>
  std::string
  line_of(const char *format, const std::vector<Number> &values)
  {
    std::string result;
    for (const Number value : values)
      {
        char text[24];
        std::snprintf(text, sizeof text, format, value);
        result += text;
      }
    return result + "\n";
  }

  std::string
  integers(const std::vector<int> &values)
  {
    return line_of("%10d", values);
  }

  std::string
  reals(const std::vector<double> &values)
  {
    return line_of("%13.5e", values);
  }

  std::string
  dataset(const std::string &number, const std::string &text)
  {
    return "    -1\n" + number + "\n" + text + "    -1\n";
  }

  /** Two nodes at the same place, of which the second moves in system
   * @p system: 1, 2, 3 along its axes. */
  void
  write(const std::string &systems, const int system)
  {
    std::string node_1 = integers({1, 0, 0, 0}),
                node_2 = integers({2, 0, system, 0});
    node_1.pop_back();
    node_2.pop_back();
    const std::string origin = reals({0., 0., 0.});
    std::ofstream("shapes.uff")
      << systems << dataset("    15", node_1 + origin + node_2 + origin)
      << dataset("    55",
                 "shape\nNONE\nNONE\nNONE\nNONE\n" +
                   integers({1, 2, 3, 8, 2, 3}) + integers({2, 4, 0, 1}) +
                   reals({1000., 1., 0., 0.}) + integers({1}) +
                   reals({1., 2., 3.}) + integers({2}) + reals({1., 2., 3.}));
  }

  /** System @p number of kind @p kind, whose x axis is the global y axis and
   * whose y axis is -x. */
  std::string
  turned(const int number, const int kind)
  {
    return dataset("    18",
                   integers({number, kind, 0, 8, 1}) + "turned\n" +
                     reals({5., 0., 0., 5., 2., 0.}) + reals({5., 1., 1.}));
  }

  std::array<std::complex<double>, 3>
  second_node()
  {
    const auto shapes = read_measured_shapes("shapes.uff");
    check(shapes.size() == 1 && shapes[0].nodes.size() == 2,
          "one shape of two nodes");
    const auto &first = shapes[0].nodes.at(1);
    check(first[0] == 1. && first[1] == 2. && first[2] == 3.,
          "a node without a system moves in the global axes");
    return shapes[0].nodes.at(2);
  }

  /** A dataset 55 of one node with the first two values 1 and 2. */
  std::string
  shape(const std::string &title,
        const int          characteristic,
        const int          specific,
        const int          n_values = 3)
  {
    std::vector<double> values(n_values);
    values[0] = 1.;
    values[1] = 2.;
    return dataset("    55",
                   title + "\nNONE\nNONE\nNONE\nNONE\n" +
                     integers({1, 2, characteristic, specific, 2, n_values}) +
                     integers({2, 4, 0, 1}) + reals({1000., 1., 0., 0.}) +
                     integers({1}) + reals(values));
  }

  /** A dataset 55 of a complex mode with the eigenvalue -3 + i @p omega, whose
   * node 1 moves by 1 + 2 i, 3 - 4 i and 5 i, or by their conjugates. */
  std::string
  complex_mode(const std::string &title, const int analysis, const double omega)
  {
    const double s = omega < 0. ? -1. : 1.;
    return dataset("    55",
                   title + "\nNONE\nNONE\nNONE\nNONE\n" +
                     integers({1, analysis, 2, 8, 5, 3}) +
                     integers({2, 6, 0, 1}) +
                     reals({-3., omega, 1., 0., 1., 0.}) + integers({1}) +
                     reals({1., 2. * s, 3., -4. * s, 0., 5. * s}));
  }

  /** A shape is that of the eigenvalue above the real axis, whichever member of
   * the pair the file holds; both together are one shape. */
  void
  test_conjugate_modes()
  {
    const std::array<std::complex<double>, 3> values{
      {{1., 2.}, {3., -4.}, {0., 5.}}};
    for (const int analysis : {3, 7})
      for (const double omega : {100., -100.})
        {
          std::ofstream("complex.uff") << complex_mode("m", analysis, omega);
          const auto shapes = read_measured_shapes("complex.uff");
          check(shapes.size() == 1 && shapes[0].nodes.at(1) == values,
                "a shape of analysis type " + std::to_string(analysis) +
                  " by either member of its pair");
          check_close(shapes[0].frequency,
                      100. / (2. * M_PI),
                      1e-12,
                      "and its frequency in Hz");
        }
    std::ofstream("complex.uff")
      << complex_mode("upper", 3, 100.) << complex_mode("lower", 3, -100.)
      << complex_mode("other", 3, -200.);
    const auto shapes = read_measured_shapes("complex.uff");
    check(shapes.size() == 2 && shapes[0].name == "upper" &&
            shapes[1].name == "other",
          "both members of a pair are one shape");
  }

  /** Names of the shapes of a file; @p log gets what the run log shows. */
  std::vector<std::string>
  names_of(const std::string &text, std::string &log)
  {
    std::ofstream("kinds.uff") << text;
    MeasurementParameters m;
    m.shapes_file = "kinds.uff";
    std::ostringstream       out;
    RunLog                   run_log(true, out);
    std::vector<std::string> names;
    for (const auto &measured : read_measured_shapes(m, run_log))
      names.push_back(measured.name);
    // The console breaks long lines.
    log.clear();
    std::istringstream words(out.str());
    for (std::string word; words >> word;)
      log += word + " ";
    return names;
  }

  void
  test_kinds()
  {
    using Names = std::vector<std::string>;
    std::string log;
    check(names_of(shape("u", 2, 8) + shape("v", 3, 11, 6) + shape("a", 2, 12),
                   log) == Names{"u", "v", "a"} &&
            log.empty(),
          "displacements, velocities and accelerations");
    check(names_of(shape("s", 4, 2, 6) + shape("u", 2, 8) +
                     shape("e", 4, 3, 6) + shape("r", 2, 9),
                   log) == Names{"u"},
          "stress, strain and reactions are passed over");
    for (const char *part :
         {"'s' (stress)", "'e' (strain)", "'r' (reaction forces)"})
      check(log.find(part) != std::string::npos, "the log names " + log);
    check(names_of(shape("open", 2, 0) + shape("u", 2, 8), log) ==
              Names{"open", "u"} &&
            log.find("warning") != std::string::npos &&
            log.find("'open'") != std::string::npos &&
            log.find("'u'") == std::string::npos,
          "a kind that is not said is warned of");
    check_throws<InputError>(
      [&]() { names_of(shape("s", 4, 2, 6), log); },
      "no displacements, velocities or accelerations: 's' (stress)",
      "refused: a file of stress alone");
  }
} // namespace

int
main()
{
  test_kinds();
  test_conjugate_modes();
  write(turned(7, 0), 7);
  const auto moved = second_node();
  check_close(moved[0].real(), -2., 1e-12, "its second direction is -x");
  check_close(moved[1].real(), 1., 1e-12, "its first direction is y");
  check_close(moved[2].real(), 3., 1e-12, "its third direction is z");

  write("", 1);
  check(second_node()[0] == 1., "1 is the global system where none is defined");
  write("", 7);
  check_throws<InputError>(second_node, "node 2", "a system that is not there");
  write(turned(7, 1), 7);
  check_throws<InputError>(second_node, "system 7", "a cylindrical system");
}
