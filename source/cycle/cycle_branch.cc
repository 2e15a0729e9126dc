// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/unknown_choice.h>
#include <squeal/cycle/branch_run.h>

#include <algorithm>
#include <cmath>

namespace squeal
{
  namespace
  {
    /** By how much frequencies and forces of one branch may be beside those of
     * its neighbouring points, in shares of themselves. */
    constexpr double beside_frequency = 1e-4, beside_force = 1e-2;

    /** Of the shortest period, Hz: a motion may have been found as a multiple
     * of it. */
    double
    frequency_of(const BranchPoint &point)
    {
      return point.figures.frequency * point.figures.repetitions();
    }

    bool
    is_between(const double a,
               const double b,
               const double value,
               const double share = 0.)
    {
      const double more = share * std::abs(value);
      return value >= std::min(a, b) - more && value <= std::max(a, b) + more;
    }
  } // namespace



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
      case BranchEnd::small:
        return "has nearly vanished";
      case BranchEnd::turn:
        return "turns too sharply";
      case BranchEnd::joined:
        return "joins another branch";
      case BranchEnd::not_found:
        return "not converged";
      }
    unknown_choice("end of a branch");
  }



  bool
  lies_on(const CycleBranch &branch, const BranchPoint &point)
  {
    for (std::size_t i = 0; i + 1 < branch.points.size(); ++i)
      {
        const BranchPoint &a = branch.points[i], &b = branch.points[i + 1];
        if (is_between(a.parameter, b.parameter, point.parameter) &&
            is_between(frequency_of(a),
                       frequency_of(b),
                       frequency_of(point),
                       beside_frequency) &&
            is_between(a.figures.rms_normal,
                       b.figures.rms_normal,
                       point.figures.rms_normal,
                       beside_force))
          return true;
      }
    return false;
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
