// SPDX-License-Identifier: LGPL-2.1-or-later

// A link of which nothing can be said tells why: too few cells beside what is
// taken out, a map that is the same everywhere, or a map that is a combination
// of what is taken out, of which more cells would tell no more.
#include <squeal/tribology/statistics/pad_tables.h>

#include <cmath>
#include <fstream>

#include "check.h"

using namespace squeal;
using namespace squeal::testing;
using namespace squeal::tribology;

namespace
{
  constexpr unsigned int n = 11; // nodes along each edge, 2 mm apart

  double
  pressure(const unsigned int k)
  {
    return std::round(1e3 * (1. + std::sin(1. + 7. * k)));
  }

  /** Tables of all nodes; the features of the first @p n_rows of them only, of
   * which @p coverage is seen. */
  void
  write_tables(const unsigned int n_rows, const double coverage = 1.)
  {
    std::ofstream damage("damage.csv"), features("features.csv");
    damage << "x_m,y_m,area_m2,index,flat,pressure,driver\n";
    features << "x_m,y_m,coverage,feature,even,alike\n";
    for (unsigned int k = 0; k < n * n; ++k)
      {
        const double x = 2e-3 * (k % n), y = 2e-3 * (k / n);
        damage << x << "," << y << ",4e-6," << std::cos(3. * k * k) << ",7,"
               << pressure(k) << "," << pressure(k) << "\n";
        if (k < n_rows)
          features << x << "," << y << "," << coverage << ","
                   << std::sin(2. * k * k) << ",5," << 3. * pressure(k) << "\n";
      }
  }

  /** The one warning of @p index against @p feature. */
  void
  check_reason(const std::string &index,
               const std::string &feature,
               const bool         has_covariate,
               const Silence      silence,
               const std::string &words)
  {
    CorrelationParameters p;
    p.damage_tables  = {"damage.csv"};
    p.feature_tables = {"features.csv"};
    p.indices        = {index};
    p.features       = {feature};
    if (has_covariate)
      p.covariates = {"driver"};
    const std::vector<PadLink> links = link_pads(read_pads(p), p);
    check(links.size() == 1 && !links[0].test.conditional.is_known &&
            links[0].test.conditional.silence == silence &&
            links[0].test.verdict == Verdict::undecided,
          index + " against " + feature + " is undecided");
    const std::vector<std::string> lines = warnings_of_weak_links(links);
    check(lines.size() == 1 && lines[0].find(words) != std::string::npos,
          words + ": " + (lines.empty() ? "no warning" : lines[0]));
  }
} // namespace



int
main()
{
  write_tables(n * n);
  check_reason("flat",
               "feature",
               false,
               Silence::index_constant,
               "pad 1, index 'flat': it is the same in all cells");
  check_reason("index",
               "even",
               false,
               Silence::feature_constant,
               "pad 1, feature 'even': it is the same in all cells");
  check_reason("pressure",
               "feature",
               true,
               Silence::index_explained,
               "pad 1, index 'pressure': it is a combination of the terms");
  check_reason("index",
               "alike",
               true,
               Silence::feature_explained,
               "pad 1, feature 'alike': it is a combination of the terms");
  write_tables(12);
  check_reason("index",
               "feature",
               false,
               Silence::few_cells,
               "pad 1, feature 'feature': 12 cells are known, too few beside");
  // one cell alone is the same everywhere, and so is none
  write_tables(1);
  check_reason("index",
               "feature",
               false,
               Silence::few_cells,
               "pad 1, feature 'feature': 1 cell is known, too few: nothing");
  write_tables(n * n, 0.);
  check_reason("index",
               "feature",
               false,
               Silence::few_cells,
               "pad 1, feature 'feature': 0 cells are known, too few: nothing");
}
