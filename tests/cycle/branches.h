// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tests_cycle_branches_h
#define squeal_tests_cycle_branches_h

// What tests of branches of periodic motions over friction share.

#include "cycle/two_modes.h"
#include "scenes.h"

#include <squeal/cycle/branch_run.h>
#include <squeal/cycle/cycle_search.h>
#include <squeal/transient/linearized_motion.h>

#include <cstdio>
#include <memory>
#include <string>

namespace squeal
{
  namespace testing
  {
    /** Of a period. */
    constexpr unsigned int n_steps = 600;

    inline LinearizedMotion
    about_sliding(const ReducedContactModel &m,
                  const double               mu,
                  const double               speed)
    {
      return linearize(m, steady_sliding(m, mu), mu, speed);
    }

    /** Where the largest growth rate is nothing. */
    inline double
    critical_friction(const ReducedContactModel &m,
                      const double               speed,
                      double                     high = .5)
    {
      double low = .1;
      while (high - low > 1e-12)
        {
          const double middle = .5 * (low + high);
          const bool   grows =
            (about_sliding(m, middle, speed).lambda.real().array() > 0.).any();
          (grows ? high : low) = middle;
        }
      return high;
    }

    inline void
    print(const CycleBranch &branch, const std::string &name)
    {
      for (const BranchPoint &x : branch.points)
        {
          const Figures f = figures_of(x.motion.orbit);
          std::printf("%s: mu %.6f, %.6f Hz, rms %.6f N, largest multiplier "
                      "%.5f, trivial %+.1e, %u changes, %u iterations%s\n",
                      name.c_str(),
                      x.parameter,
                      f.frequency,
                      f.rms,
                      x.multipliers.largest,
                      x.multipliers.trivial.real() - 1.,
                      x.n_changes,
                      x.motion.iterations,
                      x.is_fold ? ", fold" : "");
        }
      std::printf("%s: ends by %s, %s\n",
                  name.c_str(),
                  branch_end_text(branch.first_end).c_str(),
                  branch_end_text(branch.last_end).c_str());
    }

    inline PeriodMaps
    over_friction(const ReducedContactModel &m, const double speed)
    {
      PeriodMaps maps;
      maps.at = [&m, speed](const double mu) {
        return std::make_shared<const PeriodMap>(m, mu, speed, 1., 1e-12);
      };
      return maps;
    }

    struct Start
    {
      PeriodicMotion motion;
      BranchSettings settings;
    };

    inline Start
    start_of(const ReducedContactModel &m,
             const PeriodMaps          &maps,
             const double               start_at,
             const unsigned int         n        = n_steps,
             const double               settling = 600.)
    {
      const auto  map  = maps(start_at);
      const Orbit tail = map->run(
        later(*map, disturbed(steady_sliding(m, start_at)), settling, .02),
        20.,
        2000);
      const auto      return_ = recurrences(m, tail, 2., 8.).back();
      Start           start;
      BranchSettings &s    = start.settings;
      s.lower              = .2;
      s.upper              = .7;
      s.n_points           = 400;
      s.largest_step       = .02;
      s.shooting.n_steps   = n;
      s.shooting.tolerance = 1e-8;
      start.motion         = shoot(*map, tail.end(), return_.first, s.shooting);
      check(start.motion.status == CycleStatus::converged,
            "the start of the branch");
      return start;
    }
  } // namespace testing
} // namespace squeal

#endif
