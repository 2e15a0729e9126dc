// SPDX-License-Identifier: LGPL-2.1-or-later

// Cells of images that do not match the nodes: rows of features share their
// area with the nodal cells, so that no feature moves and what was seen of a
// node does not grow with the number of rows.
#include <squeal/tribology/statistics/pad_tables.h>

#include <cmath>
#include <fstream>

#include "check.h"
#include "worst.h"

using namespace squeal;
using namespace squeal::testing;
using namespace squeal::tribology;

namespace
{
  constexpr unsigned int n = 5; // nodes along each edge, 2 mm apart

  /** A linear function of places in units of the distance of the nodes. */
  double
  linear(const double x, const double y)
  {
    return 1. + x + 10. * y;
  }

  void
  write_damage()
  {
    std::ofstream out("damage.csv");
    out << "node,x_m,y_m,area_m2,index\n";
    for (unsigned int j = 0; j < n; ++j)
      for (unsigned int i = 0; i < n; ++i)
        {
          const double area =
            4e-6 * (i % (n - 1) == 0 ? .5 : 1.) * (j % (n - 1) == 0 ? .5 : 1.);
          out << i + n * j << "," << 2e-3 * i - 4e-3 << "," << 2e-3 * j - 4e-3
              << "," << area << "," << linear(i, j) << "\n";
        }
  }

  /** The function at the centres of @p m times @p m cells of the face, each
   * seen in part. */
  void
  write_cells(const unsigned int m, const double seen)
  {
    std::ofstream out("features.csv");
    out.precision(12);
    out << "x_m,y_m,coverage,feature\n";
    for (unsigned int j = 0; j < m; ++j)
      for (unsigned int i = 0; i < m; ++i)
        {
          const double x = (n - 1) * (i + .5) / m, y = (n - 1) * (j + .5) / m;
          out << 2e-3 * x - 4e-3 << "," << 2e-3 * y - 4e-3 << "," << seen << ","
              << linear(x, y) << "\n";
        }
  }

  CorrelationParameters
  parameters()
  {
    CorrelationParameters p;
    p.damage_tables  = {"damage.csv"};
    p.feature_tables = {"features.csv"};
    p.indices        = {"index"};
    return p;
  }

  void
  cells_beside_nodes()
  {
    for (const unsigned int m : {4, 7, 8, 12, 20})
      {
        const std::string cells = std::to_string(m) + " cells: ";
        write_cells(m, .05);
        const auto  pads = read_pads(parameters());
        const auto &map  = pads[0].features.at("feature");
        Worst       off, seen;
        for (unsigned int j = 1; j + 1 < n; ++j)
          for (unsigned int i = 1; i + 1 < n; ++i)
            // of seven cells only the middle node has as many on both sides
            if (m != 7 || (i == 2 && j == 2))
              off.add(std::abs(map.values[i + n * j] - linear(i, j)));
        check_within(off, 1e-9, cells + "linear features stay in place");
        for (const double part : pads[0].coverage.values)
          seen.add(std::abs(part - .05));
        check_within(seen, 1e-9, cells + "each node is seen to 5 %");
        const auto lines = warnings_of_thin_cells(pads, parameters());
        check(lines.size() == 1 &&
                lines[0].find("25 of 25 cells") != std::string::npos,
              cells + "and left out");
      }
  }

  void
  coarse_cells()
  {
    const auto lines = []() {
      return warnings_of_coarse_features(read_pads(parameters()), parameters());
    };
    write_cells(3, 1.);
    check(lines().empty(), "cells a third longer than the nodes' are no fault");
    std::ofstream("features.csv") << "x_m,y_m,feature\n"
                                     "-0.0022,-0.0022,1\n0.0022,-0.0022,2\n"
                                     "-0.0022,0.0022,3\n0.0022,0.0022,4\n";
    const auto coarse = lines();
    check(coarse.size() == 1 &&
            coarse[0].find("are 2.2 times as long") != std::string::npos,
          "cells that are twice as long are told");
    const auto values =
      read_pads(parameters())[0].features.at("feature").values;
    check(values[6] == 1. && values[8] == 2. && std::isnan(values[7]),
          "and count at the node next to their centre");
  }

  /** Rows in one column in the middle of the face are as wide as the face. */
  void
  cells_in_one_column()
  {
    std::ofstream out("features.csv");
    out << "image,x_m,y_m,feature\n";
    for (unsigned int j = 0; j < 8; ++j)
      out << "pad,0," << -4e-3 + 1e-3 * (j + .5) << "," << j << "\n";
    out.close();
    const auto pads  = read_pads(parameters());
    const auto lines = warnings_of_coarse_features(pads, parameters());
    check(lines.size() == 1 &&
            lines[0].find("are 4.0 times as long") != std::string::npos,
          "they are told: " + (lines.empty() ? "" : lines[0]));
    const auto &values = pads[0].features.at("feature").values;
    check(std::isfinite(values[2]) && std::isnan(values[1]),
          "and count at the nodes next to their centres");
    std::ofstream("features.csv") << "x_m,y_m,feature\n0.001,-0.003,1\n"
                                     "0.001,-0.001,2\n0.001,0.001,3\n";
    check(warnings_of_coarse_features(read_pads(parameters()), parameters())
            .empty(),
          "points beside the middle are points");
  }

  /** One row in the middle of the face is as large as the face. */
  void
  one_cell()
  {
    write_cells(1, 1.);
    const auto lines =
      warnings_of_coarse_features(read_pads(parameters()), parameters());
    check(lines.size() == 1 &&
            lines[0].find("are 4.0 times as long") != std::string::npos,
          "one cell is told: " + (lines.empty() ? "" : lines[0]));
    std::ofstream("features.csv") << "x_m,y_m,feature\n0,0.001,1\n";
    check(warnings_of_coarse_features(read_pads(parameters()), parameters())
            .empty(),
          "a point beside the middle is a point");
  }

  /** Rows that are no lattice, and rows at nodes. */
  void
  points()
  {
    std::ofstream("features.csv") << "x_m,y_m,feature\n"
                                     "-0.003,-0.0012,1\n0.0013,0.0022,2\n"
                                     "0.0031,0.0035,3\n";
    const auto pads   = read_pads(parameters());
    const auto values = pads[0].features.at("feature").values;
    check(values[5] == 1. && values[6] == 1. && std::isnan(values[7]) &&
            pads[0].coverage.values[5] == 1.,
          "a point on a border tells of both sides");
    write_cells(2, 1.);
    const auto at_nodes = read_pads(parameters());
    Worst      known;
    for (const double v : at_nodes[0].features.at("feature").values)
      known.add(std::isfinite(v) ? 0. : 1.);
    check(at_nodes[0].features.at("feature").values[6] == linear(1., 1.) &&
            known.largest() == 1.,
          "a row at a node tells of that node only");
  }
} // namespace

int
main()
{
  write_damage();
  cells_beside_nodes();
  coarse_cells();
  cells_in_one_column();
  one_cell();
  points();
}
