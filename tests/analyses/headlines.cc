// SPDX-License-Identifier: LGPL-2.1-or-later

// What the first screen says: the largest of all errors with its source, and
// verdicts that do not contradict what stands beside them.

#include "check.h"

#include <squeal/analyses/transient/transient_verdict.h>
#include <squeal/output/headline_error.h>

#include <limits>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  const double unknown = std::numeric_limits<double>::quiet_NaN();

  bool
  has(const std::string &text, const std::string &part)
  {
    return text.find(part) != std::string::npos;
  }

  void
  errors()
  {
    check(headline_error({{"reduction", 1e-9}, {"mesh", 2e-3}}) ==
            rounded_text(2e-3, 2) + " (mesh)",
          "the mesh's error is the headline where it is the largest");
    check(has(headline_error({{"mesh", 2e-3}, {"reduction", 5e-3}}, " Hz"),
              rounded_text(5e-3, 2) + " Hz (reduction)"),
          "another one where that is");
    const std::string without =
      headline_error({{"reduction", 1e-9}, {"mesh", unknown}});
    check(has(without, "(reduction)") &&
            has(without, "mesh error not estimated"),
          "a mesh error that is not estimated is said: " + without);
    check(headline_error({{"mesh", unknown}}) == "mesh error not estimated",
          "alone too");

    Table table({{"error", Table::Type::real, "", ""}});
    check(std::isnan(error_of_column("mesh", table, "error").second) &&
            std::isnan(error_of_column("mesh", table, "none").second),
          "an empty or missing column knows nothing");
    table.add_row({1e-3});
    table.add_row({Cell()});
    table.add_row({4e-3});
    table.add_row({Cell()});
    const ErrorSource source = error_of_column("mesh", table, "error");
    check(source.second == 4e-3 && source.first == "mesh, known for 2 of 4",
          "the largest of a column, and of how many: " + source.first);
  }

  void
  verdicts()
  {
    TransientFigures f;
    TriggerOutcome   none, squeal, temporary;
    squeal.text    = "squeal after the trigger";
    temporary.text = "temporary after the trigger";
    f.verdict      = "stable";
    check(explained_verdict(f, none) == "stable" &&
            explained_verdict(f, temporary) == "stable" && !squeals(f, none),
          "stable is stable where nothing else is there");
    const std::string both = explained_verdict(f, squeal);
    check(has(both, "stable about steady sliding") &&
            has(both, "squeals after the trigger") &&
            has(both, "a limit cycle stands beside it") && squeals(f, squeal),
          "beside a squeal after the trigger it is explained: " + both);
    f.has_limit_cycle = true;
    check(has(explained_verdict(f, none), "a limit cycle stands beside it"),
          "and beside a limit cycle");
    f.verdict = "unstable";
    check(explained_verdict(f, squeal) == "unstable", "unstable says it all");
  }

  void
  rates()
  {
    TransientFigures f;
    BranchResult     good, bad;
    good.fit.rate     = 1220.;
    good.fit.rate_ci  = 0.5;
    good.fit.end      = 0.01;
    good.fit.is_valid = true;
    bad               = good;
    bad.frequency     = 6636.7;
    bad.fit.rate      = 861.4;
    bad.fit.rate_ci   = 1082.;
    bad.fit.is_valid  = false;
    f.branches        = {good};
    f.leading         = 0;
    check(left_out_text(f).empty(), "nothing is left out of good fits");
    f.branches.push_back(bad);
    check(has(left_out_text(f), "1 of 2 pairs") &&
            has(left_out_text(f), "6636.7 Hz"),
          "what is left out is named: " + left_out_text(f));
    f.leading = 1;
    check(has(reason_for_no_rate(f), "861.4 +- 1082 1/s"),
          "and why the leading pair has no rate: " + reason_for_no_rate(f));
    f.branches[1].fit = GrowthFit();
    check(has(reason_for_no_rate(f), "no linear phase"),
          "which is another reason than that it has no linear phase");
  }
} // namespace



int
main()
{
  errors();
  verdicts();
  rates();
}
