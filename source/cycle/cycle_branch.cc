// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/unknown_choice.h>
#include <squeal/cycle/branch_run.h>

namespace squeal
{
  std::string
  branch_end_text(const BranchEnd end)
  {
    switch (end)
      {
      case BranchEnd::range:
        return "end of the range";
      case BranchEnd::points:
        return "as many points as asked for";
      case BranchEnd::onset:
        return "onset";
      case BranchEnd::turn:
        return "turns too sharply";
      case BranchEnd::not_found:
        return "not converged";
      }
    unknown_choice("end of a branch");
  }



  CycleBranch
  follow_branch(const PeriodMaps     &maps,
                const PeriodicMotion &start,
                const double          parameter,
                const BranchSettings &settings)
  {
    BranchRun run(maps, start, parameter, settings);
    run.advance();
    return run.branch();
  }
} // namespace squeal
