// SPDX-License-Identifier: LGPL-2.1-or-later

// Tables of damage and features on the cells of one pad: where features lie
// when images are known from the pad's centre on and nodes from that of the
// disc, how rows of a cell count, and places that lie nowhere.
#include <squeal/base/exceptions.h>
#include <squeal/tribology/statistics/association.h>
#include <squeal/tribology/statistics/pad_tables.h>
#include <squeal/tribology/statistics/quantity_text.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <functional>
#include <random>

#include "check.h"
#include "worst.h"

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

  double
  value(const unsigned int i, const unsigned int j)
  {
    return 1. + i + 10. * j;
  }

  /** Damage on 5 x 5 nodes about (@p x, @p y). */
  void
  write_damage(const double x, const double y)
  {
    std::ofstream out("damage.csv");
    out << "node,x_m,y_m,area_m2,index\n";
    for (unsigned int j = 0; j < n; ++j)
      for (unsigned int i = 0; i < n; ++i)
        out << i + n * j << "," << x + place(i) << "," << y + place(j)
            << ",4e-6," << value(i, j) << "\n";
  }

  /** The same values as a feature about (@p x, @p y), then @p more. */
  void
  write_features(const double x, const double y, const std::string &more = "")
  {
    std::ofstream out("features.csv");
    out << "x_m,y_m,coverage,feature\n";
    for (unsigned int j = 0; j < n; ++j)
      for (unsigned int i = 0; i < n; ++i)
        out << x + place(i) << "," << y + place(j) << ",1," << value(i, j)
            << "\n";
    out << more;
  }

  PadMaps
  read()
  {
    CorrelationParameters p;
    p.damage_tables  = {"damage.csv"};
    p.feature_tables = {"features.csv"};
    p.indices        = {"index"};
    p.features       = {"feature"};
    return std::move(read_pads(p)[0]);
  }

  double
  largest_difference(const PadMaps &pad)
  {
    const auto &a = pad.indices.at("index").values;
    const auto &b = pad.features.at("feature").values;
    check(a.size() == n * n && b.size() == a.size(), "25 cells");
    Worst largest;
    for (std::size_t k = 0; k < a.size(); ++k)
      largest.add(std::abs(a[k] - b[k]));
    return largest.largest();
  }



  void
  shifts()
  {
    write_features(0., 0.);
    write_damage(0., 0.);
    check(largest_difference(read()) == 0., "both about the pad's centre");
    // where the brake's pad stands on the disc
    write_damage(.13, -.02);
    check(largest_difference(read()) == 0.,
          "features about the centre, nodes about a place on the disc");
    write_damage(0., .1);
    check(largest_difference(read()) == 0., "shifted along one axis only");
    write_features(.13, -.02);
    write_damage(.13, -.02);
    check(largest_difference(read()) == 0., "both about a place on the disc");
    // A part of the face that lies on the nodes stays where it is.
    write_damage(0., 0.);
    std::ofstream("features.csv") << "x_m,y_m,coverage,feature\n"
                                  << "0.004,0.004,1,7\n";
    const auto one = read().features.at("feature").values;
    for (std::size_t k = 0; k < one.size(); ++k)
      check(k + 1 == one.size() ? one[k] == 7. : std::isnan(one[k]),
            "one feature in the last cell, cell " + std::to_string(k));
  }



  /** A part of a face whose centre is not the origin may lie at either of two
   * places; what reaches over the whole face lies at one. */
  void
  places_of_parts()
  {
    write_features(0., 0.);
    write_damage(2e-3, 2e-3);
    check(!read().is_place_assumed && largest_difference(read()) == 0.,
          "a whole face counted from its centre");
    std::ofstream("features.csv") << "x_m,y_m,coverage,feature\n"
                                  << "0,0,1,7\n0.002,0,1,8\n";
    check(read().is_place_assumed, "a part that lies on the face twice");
    CorrelationParameters p;
    p.damage_tables                = {"damage.csv"};
    p.feature_tables               = {"features.csv"};
    p.indices                      = {"index"};
    std::vector<PadMaps>     pads  = read_pads(p);
    std::vector<std::string> lines = warnings_of_assumed_places(pads, p);
    check(lines.size() == 1 && lines[0].find("'image'") != std::string::npos,
          "is warned of");
    std::ofstream("features.csv") << "image,x_m,y_m,coverage,feature\n"
                                  << "pad,0,0,1,7\n";
    check(!read().is_place_assumed &&
            read().features.at("feature").values[n * n / 2] == 7.,
          "rows of the pad count from its centre");
    write_damage(0., 0.);
    std::ofstream("features.csv") << "x_m,y_m,coverage,feature\n0,0,1,7\n";
    check(!read().is_place_assumed, "about the origin both are the same");
  }



  void
  rows_of_a_cell()
  {
    write_damage(0., 0.);
    // value 1 with coverage 1, then 5 with coverage 0.25, in the first cell
    write_features(0., 0., "-0.0038,-0.0036,0.25,5\n0.004,0.004,0,1e9\n");
    const auto values = read().features.at("feature").values;
    check_close(values.front(), 1.8, 1e-12, "rows count with their coverage");
    check(values.back() == value(n - 1, n - 1), "not at all without coverage");
    for (const std::string wrong : {"3", "-0.1", "1.02"})
      {
        write_features(0., 0., "0.004,0.004," + wrong + ",5\n");
        check_throws<InputError>([] { read(); },
                                 "features.csv:27: coverage is " + wrong,
                                 "no part of a cell: " + wrong);
      }
    // pixels of a border
    write_features(0., 0., "0.004,0.004,1.004,5\n");
    check_close(read().features.at("feature").values.back(),
                .5 * (value(n - 1, n - 1) + 5.),
                1e-12,
                "a little more than a cell is a cell");
  }



  /** Tables with measured maps beside an index and a feature. */
  void
  write_measured()
  {
    std::ofstream   damage("damage.csv"), features("features.csv");
    std::mt19937_64 generator(1);
    damage << "node,x_m,y_m,area_m2,damage_m3_per_s,mean_pressure_pa\n";
    features << "x_m,y_m,crack_density_per_m,plateau_fraction\n";
    for (unsigned int j = 0; j < n; ++j)
      for (unsigned int i = 0; i < n; ++i)
        {
          damage << i + n * j << "," << place(i) << "," << place(j) << ",4e-6,"
                 << generator() % 97 << "," << i * j << "\n";
          features << place(i) << "," << place(j) << "," << generator() % 97
                   << "," << (i * i + j) % 2 << "\n";
        }
  }



  /** Of a covariate that the damage table has as well, with one value in all
   * cells, the varying map of the features is taken out all the same. */
  void
  covariate_of_both_tables(const CorrelationParameters &p, const PadMaps &one)
  {
    {
      std::ofstream features("features.csv");
      features << "x_m,y_m,crack_density_per_m,plateau_fraction,"
                  "mean_pressure_pa\n";
      for (unsigned int k = 0; k < n * n; ++k)
        features << place(k % n) << "," << place(k / n) << "," << k * k % 17
                 << "," << k % 5 << "," << 3e6 << "\n";
    }
    const std::vector<PadMaps> pads = read_pads(p);
    const SharedCauses        &both = pads[0].causes;
    check(both.values.cols() == one.causes.values.cols() + 2 &&
            both.names[both.names.size() - 2] ==
              "mean_pressure_pa of the damage table" &&
            both.names.back() == "mean_pressure_pa of the features",
          "columns of one name in both tables are two causes");
    Worst off;
    for (const int k : {-2, -1})
      for (Eigen::Index i = 0; i < both.values.rows(); ++i)
        off.add(std::abs(both.values(i, both.values.cols() - 2 + k) -
                         one.causes.values(i, one.causes.values.cols() + k)));
    check(off.largest() == 0., "that of the damage table is the same");
    const auto lines = warnings_of_constant_covariates(pads);
    check(
      lines.size() == 1 &&
        lines[0].find("take nothing out: mean_pressure_pa of the features") !=
          std::string::npos,
      "one that is the same everywhere is warned of");
    write_measured();
  }

  /** Measured maps of either table are shared causes and no longer indices or
   * features; few cells beside many causes are warned of. */
  void
  covariates()
  {
    write_measured();
    CorrelationParameters p;
    p.damage_tables     = {"damage.csv"};
    p.feature_tables    = {"features.csv"};
    const PadMaps plain = std::move(read_pads(p)[0]);
    p.covariates        = {"plateau_fraction", "mean_pressure_pa"};
    const PadMaps pad   = std::move(read_pads(p)[0]);
    check(plain.features.size() == 2 && pad.features.size() == 1 &&
            pad.features.count("crack_density_per_m") == 1,
          "a covariate is no feature");
    check(pad.causes.values.cols() == plain.causes.values.cols() + 4 &&
            pad.causes.names.back() == "mean_pressure_pa",
          "but a cause, with its square");
    check(warnings_of_lacking_covariates(read_pads(p)).empty() &&
            warnings_of_constant_covariates(read_pads(p)).empty(),
          "covariates that are known everywhere");
    covariate_of_both_tables(p, pad);
    {
      std::ofstream features("features.csv");
      features << "x_m,y_m,crack_density_per_m,plateau_fraction\n";
      for (unsigned int k = 0; k < n * n; ++k)
        features << place(k % n) << "," << place(k / n) << "," << k * k % 17
                 << "," << (k < 7 ? "" : std::to_string(k % 5)) << "\n";
    }
    const auto lacking = warnings_of_lacking_covariates(read_pads(p));
    check(lacking.size() == 1 &&
            lacking[0].find("not known in 7 of 25 cells") != std::string::npos,
          "cells without a covariate are counted");
    write_measured();
    p.covariates = {"hardness"};
    check_throws<InputError>(
      [&p] { read_pads(p); },
      "neither 'damage.csv' nor 'features.csv' has a column 'hardness'",
      "a covariate that is in neither table");
    p.covariates.clear();
    const std::vector<PadLink>     beside = link_pads(read_pads(p), p);
    const std::vector<std::string> lines  = warnings_of_weak_links(beside);
    check(lines.size() == 2 &&
            lines[0].find("'crack_density_per_m': 25 cells are known, ") !=
              std::string::npos,
          "few cells are warned of: " + (lines.empty() ? "" : lines[0]));
    p.shared_causes                        = {};
    const std::vector<PadLink> plain_links = link_pads(read_pads(p), p);
    for (std::size_t i = 0; i < beside.size(); ++i)
      check(plain_links[i].test.conditional.n_effective >
              1.5 * beside[i].test.conditional.n_effective,
            "25 cells without causes are worth more: " +
              std::to_string(plain_links[i].test.conditional.n_effective));
  }



  /** A cell of which next to nothing was seen has no say in links. */
  void
  thin_cells()
  {
    write_damage(0., 0.);
    const auto links = [](const double coverage_of_row, const double least) {
      {
        std::ofstream out("features.csv");
        out << "x_m,y_m,coverage,feature\n";
        for (unsigned int j = 0; j < n; ++j)
          for (unsigned int i = 0; i < n; ++i)
            out << place(i) << "," << place(j) << ","
                << (j == 0 ? coverage_of_row : 1.) << "," << value(i, j)
                << "\n";
      }
      CorrelationParameters p;
      p.damage_tables  = {"damage.csv"};
      p.feature_tables = {"features.csv"};
      p.indices        = {"index"};
      p.shared_causes  = {};
      p.least_coverage = least;
      const auto pads  = read_pads(p);
      return std::pair(link_pads(pads, p)[0].test.n_cells,
                       warnings_of_thin_cells(pads, p));
    };
    check(links(.3, .1).first == 25 && links(.3, .1).second.empty(),
          "cells seen to 30 % count");
    const auto [n_cells, lines] = links(.02, .1);
    check(n_cells == 20 && lines.size() == 1 &&
            lines[0].find("5 of 25 cells") != std::string::npos,
          "cells seen to 2 % are left out and told: " +
            (lines.empty() ? "" : lines[0]));
    check(links(.02, 0.).first == 25 && links(.02, 0.).second.empty(),
          "unless all are wanted");
  }



  /** Distances between cells are those on the pad. */
  void
  long_cells()
  {
    std::ofstream("damage.csv") << "node,x_m,y_m,area_m2,index\n"
                                   "0,0,0,1e-5,1\n1,0.01,0,1e-5,2\n"
                                   "2,0,0.002,1e-5,3\n3,0.01,0.002,1e-5,5\n";
    std::ofstream("features.csv") << "x_m,y_m,feature\n0,0,1\n";
    const PadMaps pad = read();
    for (const GridMap &map :
         {pad.indices.at("index"), pad.features.at("feature")})
      {
        check_close(map.spacing()[0], .01, 1e-12, "along x");
        check_close(map.spacing()[1], .002, 1e-12, "along y");
        check(map.place(3) == std::array<double, 2>{{.01, .002}},
              "places of nodes");
      }
  }



  void
  nowhere()
  {
    write_damage(.13, 0.);
    write_features(.2, 0.);
    check_throws<InputError>([] { read(); },
                             "lies in no cell",
                             "features on neither the pad nor its centre");
  }



  void
  names()
  {
    for (const auto &[column, text] :
         {std::pair("damage_m5_per_s", "damage (slope 5) in 1/s"),
          std::pair("friction_power_w_per_m2", "friction power in W/m^2"),
          std::pair("wear_index_pa_m_per_s", "wear index in Pa m/s"),
          std::pair("damage_m3_per_application",
                    "damage (slope 3) per application"),
          std::pair("crack_density_per_m", "crack density in 1/m"),
          std::pair("wear_rate_m_per_s", "wear rate in m/s"),
          std::pair("wear_depth_per_application_m",
                    "wear depth per application in m"),
          std::pair("wear_index_per_application_pa_m",
                    "wear index per application in Pa m"),
          std::pair("friction_energy_per_application_j_per_m2",
                    "friction energy per application in J/m^2"),
          std::pair("impulse_per_impact_pa_s", "impulse per impact in Pa s"),
          std::pair("friction_power_w", "friction power in W"),
          std::pair("exfoliated_area_m2", "exfoliated area in m^2"),
          std::pair("dirlik_over_counting_m2",
                    "dirlik over counting (slope 2)"),
          std::pair("contact_duty", "contact duty")})
      check(QuantityText(column).with_unit() == text, text);
  }

  /** Fifteen silent and fifteen squealing pads have more choices than are
   * counted. The p-value is that of a million permutations by numpy. */
  void
  groups_of_pads()
  {
    std::vector<double> means;
    for (unsigned int i = 0; i < 30; ++i)
      means.push_back(std::sin(1.7 * i * i + .3) + (i < 15 ? 0. : .45));
    const auto p_of = [](const std::vector<double> &values) {
      write_damage(0., 0.);
      write_features(0., 0.);
      CorrelationParameters p;
      p.damage_tables           = std::vector<std::string>(30, "damage.csv");
      p.feature_tables          = std::vector<std::string>(30, "features.csv");
      p.indices                 = {"index"};
      p.features                = {"feature"};
      std::vector<PadMaps> pads = read_pads(p);
      for (std::size_t i = 0; i < values.size(); ++i)
        {
          for (auto &[name, map] : pads[i].features)
            for (double &v : map.values)
              v = values[i];
          pads[i].is_silent = i < 15;
        }
      return compare_groups(pads, p).front().p_value;
    };
    const double p = p_of(means);
    check_close(p, .0506, .003, "p of more pads than can be counted");
    std::sort(means.begin(), means.begin() + 15);
    std::sort(means.begin() + 15, means.end(), std::greater<double>());
    check_close(p_of(means) / p, 1., 1e-12, "whatever their order");
  }

  /** A feature among many that are unlinked is held against all of them; and
   * every feature of any pad is compared. */
  void
  many_features_of_groups()
  {
    write_damage(0., 0.);
    constexpr unsigned int n_pads = 10, n_features = 12;
    for (unsigned int pad = 0; pad < n_pads; ++pad)
      {
        std::ofstream out("features_" + std::to_string(pad) + ".csv");
        out << "x_m,y_m";
        for (unsigned int f = 0; f < n_features; ++f)
          out << ",f" << f;
        // the first pad lacks the one that tells the groups apart
        out << (pad > 0 ? ",told\n0,0" : "\n0,0");
        for (unsigned int f = 0; f < n_features; ++f)
          out << "," << std::sin(3.7 * pad * pad + 1.3 * f * pad + f);
        out << (pad > 0 ? "," + std::to_string(pad < 5 ? pad : 10 * pad) : "")
            << "\n";
      }
    CorrelationParameters p;
    p.damage_tables = std::vector<std::string>(n_pads, "damage.csv");
    for (unsigned int pad = 0; pad < n_pads; ++pad)
      {
        p.feature_tables.push_back("features_" + std::to_string(pad) + ".csv");
        p.groups.push_back(pad < 5 ? "silent" : "squealing");
      }
    p.indices                             = {"index"};
    const std::vector<PadMaps>     pads   = read_pads(p);
    const std::vector<GroupResult> groups = compare_groups(pads, p);
    check(groups.size() == n_features + 1 && groups.back().feature == "told",
          "features of any pad are compared");
    check(groups.back().n_silent == 4 && groups.back().n_squealing == 5,
          "with the pads that have them");
    std::vector<double> single;
    for (const GroupResult &g : groups)
      single.push_back(g.p_value);
    const std::vector<double> adjusted = holm(single);
    for (std::size_t i = 0; i < groups.size(); ++i)
      check(groups[i].p_adjusted == adjusted[i] &&
              (groups[i].verdict != Verdict::undecided) ==
                (adjusted[i] <= p.level),
            groups[i].feature + ": Holm's p-value decides");
    check(groups.back().p_value < p.level &&
            groups.back().verdict == Verdict::undecided &&
            groups.back().reason.find("13 features") != std::string::npos,
          "what the numbers of pads cannot decide among 13 features is "
          "undecided: " +
            groups.back().reason);
    const std::vector<std::string> lines =
      warnings_of_lacking_features(pads, p);
    check(lines.size() == 1 &&
            lines[0].find("'told': pad 1 ") != std::string::npos,
          "the pad that lacks it is named: " + (lines.empty() ? "" : lines[0]));
  }

  /** Means of pads weigh what was seen of the face; angles of lines are no
   * features. */
  void
  means_of_pads()
  {
    write_damage(0., 0.);
    {
      std::ofstream out("features.csv");
      out << "x_m,y_m,coverage,feature,crack_angle_deg\n";
      for (unsigned int j = 0; j < n; ++j)
        for (unsigned int i = 0; i < n; ++i)
          out << place(i) << "," << place(j) << "," << (i == 0 ? .01 : 1.)
              << "," << (i == 0 ? 1000. : 0.) << ",89\n";
    }
    CorrelationParameters p;
    p.damage_tables  = {"damage.csv", "damage.csv"};
    p.feature_tables = {"features.csv", "features.csv"};
    p.groups         = {"silent", "squealing"};
    p.indices        = {"index"};
    const auto pads  = read_pads(p);
    check(pads[0].features.size() == 1, "an angle of lines is no feature");
    const auto groups = compare_groups(pads, p);
    check(groups.size() == 1, "one feature of two groups");
    check_close(groups[0].mean_silent,
                1000. * .01 / 4.01,
                1e-9,
                "mean over what was seen");
    p.features = {"crack_angle_deg"};
    check_throws<InputError>([&]() { read_pads(p); },
                             "crack_along_sliding",
                             "an angle of lines is refused by name");
  }

  /** Rows of images: those of the pad count where there are such, known from
   * its centre on, and several images without a pad lie nowhere. */
  void
  rows_of_images()
  {
    const auto write = [](const std::vector<std::string> &images,
                          const unsigned int              first) {
      std::ofstream out("features.csv");
      out << "image,x_m,y_m,coverage,feature\n";
      for (const std::string &image : images)
        for (unsigned int j = 0; j < n; ++j)
          for (unsigned int i = first; i < n - first; ++i)
            out << image << "," << place(i) << "," << place(j) << ",1,"
                << value(i, j) + (image == "pad" ? 0. : 100.) << "\n";
    };
    // A cell beside the centre, and the border of the pad was not seen: no
    // place is outside, and yet all are known from the centre on.
    write_damage(2e-3, 0.);
    write({"field", "pad"}, 1);
    const PadMaps pad = read();
    Worst         difference;
    unsigned int  n_seen = 0;
    for (std::size_t k = 0; k < n * n; ++k)
      if (const double seen = pad.features.at("feature").values[k];
          std::isfinite(seen))
        {
          difference.add(std::abs(seen - pad.indices.at("index").values[k]));
          ++n_seen;
        }
    check(n_seen == n * (n - 2), "the cells that were seen");
    check_within(difference, 1e-12, "cells of a pad beside the centre");
    write({"field_1", "field_2"}, 0);
    check_throws<InputError>([]() { read(); },
                             "none laid on the pad",
                             "two images without a pad are refused");
    write_damage(0., 0.);
    write({"field_1"}, 0);
    check_throws<InputError>([]() { read(); },
                             "'field_1', which is not laid on the pad",
                             "one image without a place is refused");
  }
} // namespace

int
main()
{
  shifts();
  places_of_parts();
  rows_of_images();
  means_of_pads();
  rows_of_a_cell();
  covariates();
  thin_cells();
  long_cells();
  nowhere();
  names();
  groups_of_pads();
  many_features_of_groups();
}
