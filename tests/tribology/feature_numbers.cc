// SPDX-License-Identifier: LGPL-2.1-or-later

// One cell that is no number takes no feature out of a correlation: the table
// is refused with its line. Remarks stay out, and are named.
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
  constexpr unsigned int n = 5; // nodes along each edge, 2 mm apart

  /** A table on all nodes, @p cell in its second line (the third of the
   * file). */
  void
  write(const std::string &file,
        const std::string &column,
        const std::string &cell,
        const std::string &other = "")
  {
    std::ofstream out(file);
    out << "x_m,y_m,area_m2,feature," << column << "\n";
    for (unsigned int k = 0; k < n * n; ++k)
      out << 2e-3 * (k % n) - 4e-3 << "," << 2e-3 * (k / n) - 4e-3 << ",4e-6,"
          << std::sin(1. + k) << ","
          << (k == 1          ? cell
              : other.empty() ? std::to_string(.5 + k)
                              : other)
          << "\n";
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
  refused(const CorrelationParameters &p,
          const std::string           &cell,
          const std::string           &other = "")
  {
    write("features.csv", "width", cell, other);
    check_throws<InputError>([&p] { read_pads(p); },
                             "features.csv:3: column 'width': '" + cell,
                             cell + " is no number");
  }
} // namespace



int
main()
{
  write("damage.csv", "index", "7");
  const CorrelationParameters all = parameters();
  for (const char *cell : {"NA", "-", "1.0D-1", "inf", "-inf", "0.3 um"})
    refused(all, cell);
  write("features.csv", "width", "\"1,5\"", "\"2,5\"");
  check_throws<InputError>([&all] { read_pads(all); },
                           "features.csv:2: column 'width': '2,5' is not a "
                           "finite number; leave the cell empty",
                           "quoted decimal commas between commas");

  write("features.csv", "width", "");
  PadMaps pad = std::move(read_pads(all)[0]);
  check(pad.features.count("width") == 1 && pad.texts.empty() &&
          std::isnan(pad.features.at("width").values[1]) &&
          pad.features.at("width").values[2] == 2.5,
        "an empty cell is a missing value");

  write("features.csv", "remark", "scratched", "fine");
  const std::vector<PadMaps> pads = read_pads(all);
  check(pads[0].features.size() == 1 && pads[0].features.count("feature") == 1,
        "remarks are no feature");
  const std::vector<std::string> warnings = warnings_of_texts(pads, all);
  check(warnings.size() == 1 &&
          warnings[0].find("'features.csv' hold no numbers and are no "
                           "features: remark") != std::string::npos,
        "which is said");

  CorrelationParameters named = all;
  named.features              = {"feature"};
  write("features.csv", "width", "NA");
  check(read_pads(named)[0].features.size() == 1,
        "features that are named leave the other columns alone");
  named.features = {"feature", "width"};
  refused(named, "NA");
  named.features   = {"feature"};
  named.covariates = {"width"};
  refused(named, "inf");
  refused(named, "NA");
}
