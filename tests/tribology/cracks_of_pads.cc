// SPDX-License-Identifier: LGPL-2.1-or-later

// Cracks in tables of pads: what is a mean along them weighs their length, and
// pads without any are pads all the same.
#include <squeal/base/exceptions.h>
#include <squeal/tribology/statistics/pad_tables.h>

#include <cmath>
#include <fstream>

#include "check.h"

using namespace squeal;
using namespace squeal::testing;
using namespace squeal::tribology;

namespace
{
  constexpr unsigned int n = 5;

  /** Place of a node or cell on a pad of 8 mm. */
  double
  place(const unsigned int i)
  {
    return 2e-3 * i - 4e-3;
  }

  /** Damage on 5 x 5 nodes, the middles of cells. */
  void
  write_damage()
  {
    std::ofstream out("damage.csv");
    out << "node,x_m,y_m,area_m2,index\n";
    for (unsigned int k = 0; k < n * n; ++k)
      out << k << "," << place(k % n) << "," << place(k / n) << ",4e-6," << k
          << "\n";
  }

  /** Widths and directions of cracks weigh the length of the cracks, in cells
   * that are merged and in means of pads. */
  void
  means_along_cracks()
  {
    write_damage();
    const auto read_with = [](const std::string &density) {
      // narrow cracks along the sliding in the first cell, few others
      std::ofstream out("features.csv");
      out << "x_m,y_m,coverage,crack_width_m,crack_along_sliding,feature"
          << density << "\n";
      for (unsigned int k = 0; k < n * n; ++k)
        out << place(k % n) << "," << place(k / n) << ",1,"
            << (k == 0 ? "1e-5,1,1" : "6e-5,-1,2")
            << (density.empty() ? ""
                : k == 0        ? ",30"
                                : ",1")
            << "\n";
      out << "-0.0038,-0.0038,0.5,4e-5,-1,2" << (density.empty() ? "" : ",10")
          << "\n";
      out.close();
      CorrelationParameters p;
      p.damage_tables  = {"damage.csv", "damage.csv"};
      p.feature_tables = {"features.csv", "features.csv"};
      p.groups         = {"silent", "squealing"};
      p.indices        = {"index"};
      p.features       = {"crack_width_m", "crack_along_sliding", "feature"};
      std::vector<PadMaps> pads = read_pads(p);
      pads[0].is_silent         = true;
      return pads;
    };
    const auto mean_of = [](const std::vector<PadMaps> &pads,
                            const std::string          &feature) {
      for (const GroupResult &g : compare_groups(pads, CorrelationParameters()))
        if (g.feature == feature)
          return g.mean_silent;
      return std::nan("");
    };
    const auto   pads  = read_with(",crack_density_per_m");
    const double first = (30. * 1e-5 + 5. * 4e-5) / 35.;
    check_close(pads[0].features.at("crack_width_m").values[0],
                first,
                1e-9,
                "width of a cell along its cracks");
    // of the first cell, all of which is seen, the mean density
    const double density = 35. / 1.5;
    check_close(mean_of(pads, "crack_width_m"),
                (density * first + 24. * 6e-5) / (density + 24.),
                1e-9,
                "width of a pad along its cracks");
    check_close(mean_of(pads, "crack_along_sliding"),
                (density * 25. / 35. - 24.) / (density + 24.),
                1e-9,
                "and their direction");
    check_close(mean_of(pads, "feature"),
                (2. / 1.5 + 24. * 2.) / 25.,
                1e-9,
                "other features by area");
    check_close(mean_of(read_with(""), "crack_width_m"),
                (3e-5 / 1.5 + 24. * 6e-5) / 25.,
                1e-9,
                "as all where no density is known");
  }

  /** Two tables that hold the same are one pad, unless nothing that was
   * measured varies, whichever features are asked for. */
  void
  tables_that_hold_the_same()
  {
    write_damage();
    const auto write = [](const std::string &name, const bool has_cracks) {
      std::ofstream out(name);
      out << "image,x_m,y_m,crack_density_per_m,plateau,crack_width_m\n";
      for (unsigned int k = 0; k < n * n; ++k)
        out << "pad," << place(k % n) << "," << place(k / n) << ","
            << (has_cracks && k == 7 ? "3" : "0") << "," << k << ",\n";
    };
    CorrelationParameters p;
    p.damage_tables     = {"damage.csv", "damage.csv"};
    p.features          = {"crack_density_per_m", "crack_width_m"};
    const auto check_of = [&p](const std::string &a, const std::string &b) {
      p.feature_tables = {a, b};
      check_correlation(p);
    };
    for (const std::string name : {"none_1.csv", "none_2.csv"})
      write(name, false);
    for (const std::string name : {"some_1.csv", "some_2.csv"})
      write(name, true);
    for (const bool are_named : {true, false})
      {
        if (!are_named)
          p.features.clear();
        check_throws<InputError>(
          [&]() { check_of("none_1.csv", "none_2.csv"); },
          "same pad twice",
          "plateaus at the same places");
      }
    check_throws<InputError>([&]() { check_of("some_1.csv", "some_2.csv"); },
                             "same pad twice",
                             "cracks at the same place");
    p.covariates = {"plateau"};
    check_of("none_1.csv", "none_2.csv");
    check_throws<InputError>([&]() { check_of("none_1.csv", "./none_1.csv"); },
                             "same pad twice",
                             "one file is one pad, whatever it holds");
  }
} // namespace

int
main()
{
  means_along_cracks();
  tables_that_hold_the_same();
}
