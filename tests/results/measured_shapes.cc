// SPDX-License-Identifier: LGPL-2.1-or-later

// Motions of nodes that a universal file gives in a system of its own: turned
// into the global axes, or refused where the system is not known.
#include <squeal/base/exceptions.h>
#include <squeal/results/measured_shapes.h>

#include <cstdio>
#include <fstream>

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
} // namespace

int
main()
{
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
