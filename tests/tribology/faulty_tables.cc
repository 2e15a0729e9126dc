// SPDX-License-Identifier: LGPL-2.1-or-later

// A table of damage or features that was cut, is empty or cannot be is refused
// with its line, rows at one place that differ are said, and so is a pad with
// its places in mm. A sector of a ring is refused with what to do. Numbers of
// any size correlate.
#include <squeal/base/exceptions.h>
#include <squeal/tribology/statistics/association.h>
#include <squeal/tribology/statistics/pad_tables.h>

#include <array>
#include <cmath>
#include <fstream>

#include "check.h"

using namespace squeal;
using namespace squeal::testing;
using namespace squeal::tribology;

namespace
{
  constexpr unsigned int n = 5; // nodes along each edge

  /** A value for each node of @p spacing, then @p more. */
  void
  write(const std::string &file,
        const std::string &column,
        const std::string &more    = "",
        const double       spacing = 2e-3)
  {
    std::ofstream out(file);
    out << "x_m,y_m,area_m2," << column << "\n";
    for (unsigned int k = 0; k < n * n; ++k)
      out << spacing * (k % n) << "," << spacing * (k / n) << ","
          << spacing * spacing << "," << 1. + k << "\n";
    out << more;
  }

  CorrelationParameters
  parameters()
  {
    CorrelationParameters p;
    p.damage_tables  = {"damage.csv"};
    p.feature_tables = {"features.csv"};
    p.indices        = {"index"};
    p.features       = {"feature"};
    return p;
  }

  void
  refused(const std::string &words, const std::string &what)
  {
    check_throws<InputError>([] { read_pads(parameters()); }, words, what);
  }

  std::vector<std::string>
  warnings_of_rows()
  {
    return warnings_of_doubled_rows(read_pads(parameters()), parameters());
  }



  void
  faulty_features()
  {
    write("damage.csv", "index");
    write("features.csv", "feature", "0.008,0.008,4e-6,25\n");
    check(warnings_of_rows().empty(), "a row that stands there twice is one");
    write("features.csv",
          "feature",
          "0.008,0.008,4e-6,99\n0,0,4e-6,\n0,0,4e-6,99\n");
    const std::vector<std::string> lines = warnings_of_rows();
    check(lines.size() == 1 &&
            lines[0].find("2 rows, such as lines 26 and 27, stand") !=
              std::string::npos,
          "rows at one place that differ are said");
    write("features.csv", "feature", "0.008,0.008,4e-6,2");
    refused("features.csv:27: the line does not end",
            "features that were cut in a number");
    std::ofstream("features.csv") << "x_m,y_m,feature\n";
    refused("'features.csv' has no rows", "features without rows");
    std::ofstream("features.csv")
      << "x_m,y_m,crack_density_per_m,feature\n0.004,0.004,-3,7\n";
    refused("features.csv:2: crack_density_per_m is -3",
            "a density of cracks below 0");
  }



  void
  faulty_damage()
  {
    write("features.csv", "feature");
    write("damage.csv", "index", "0,0,4e-6,1");
    refused("damage.csv:27: the line does not end",
            "damage that was cut in a number");
    write("damage.csv", "index");
    const CorrelationParameters p = parameters();
    check(warnings_of_long_pads(read_pads(p), p).empty(),
          "a pad of 8 mm is no doubt");
    write("damage.csv", "index", "", 2.);
    write("features.csv", "feature", "", 2.);
    const std::vector<std::string> lines =
      warnings_of_long_pads(read_pads(p), p);
    check(lines.size() == 1 &&
            lines[0].find("m long: if its places are in mm") !=
              std::string::npos,
          "one with places in mm is");
  }



  /** Damage and features of a sector of a ring, in @p place of radius, m, and
   * angle. */
  void
  write_sector(std::array<double, 2> (*place)(double, double))
  {
    std::ofstream damage("damage.csv"), features("features.csv");
    damage << "x_m,y_m,area_m2,index\n";
    features << "x_m,y_m,feature\n";
    for (unsigned int k = 0; k < n * n; ++k)
      {
        const double r    = .07 + .01 * (k % n);
        const auto [x, y] = place(r, .2 * (k / n) - .4);
        damage << x << "," << y << "," << .002 * r << "," << 1. + k << "\n";
        features << x << "," << y << "," << 1. + k << "\n";
      }
  }

  void
  sectors()
  {
    write_sector([](const double r, const double angle) {
      return std::array<double, 2>{{r * std::cos(angle), r * std::sin(angle)}};
    });
    refused("'damage.csv': its cells form no rectangular grid, which the terms "
            "of rim and edges and the surrogates need: of a sector of a ring "
            "give radius less its mean and mean radius times angle",
            "a sector of a ring as it lies");
    write_sector([](const double r, const double angle) {
      return std::array<double, 2>{{r - .09, .09 * angle}};
    });
    const auto pads = read_pads(parameters());
    check(pads[0].grid->n_x() == n && pads[0].grid->n_y() == n &&
            pads[0].features.at("feature").values ==
              pads[0].indices.at("index").values,
          "unrolled it is read, each cell with its own feature");
  }



  /** Numbers whose squares are beyond those of the machine. */
  void
  huge_and_tiny()
  {
    const std::vector<double> x = {1., 3., 2., 5.}, y = {2., 2.5, 4., 6.};
    for (const double factor : {1e200, 1e-200})
      {
        std::vector<double> scaled = x;
        for (double &v : scaled)
          v *= factor;
        check_close(pearson(scaled, y), pearson(x, y), 1e-14, "any unit");
      }
  }
} // namespace



int
main()
{
  faulty_features();
  faulty_damage();
  sectors();
  huge_and_tiny();
}
