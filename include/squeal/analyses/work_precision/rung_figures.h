// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_analyses_work_precision_rung_figures_h
#define squeal_analyses_work_precision_rung_figures_h

#include <squeal/parameters/parameters.h>

#include <limits>
#include <string>
#include <vector>

namespace squeal
{
  class RunLog;
  class Timers;

  /** One number that comes out of a rung. */
  struct RungFigure
  {
    std::string name;  /**< as the column of preload.csv or transient.csv */
    double      value; /**< NaN where the run has none */
    /** What the run itself states as its error, in the unit of the value; NaN
     * where it states none. */
    double stated = std::numeric_limits<double>::quiet_NaN();
    /** An error by itself, whose true value is 0. */
    bool is_error = false;
  };

  /** What steady sliding or a transient with the settings of a rung gives, and
   * what that takes. */
  struct RungFigures
  {
    std::vector<RungFigure> figures;
    unsigned int            n_unknowns = 0;
    unsigned int            n_modes = 0, n_steps = 0; /**< of a transient */
    std::string             verdict;        /**< "unstable, limit cycle", ... */
    double                  seconds   = 0.; /**< CPU time of the process */
    double                  memory_mb = 0.; /**< its peak so far */

    /** Whether there are figures; if not the verdict says why. */
    bool is_solved() const;
    /** The figure called @p name; NaN in place of one that is not there. */
    double value_of(const std::string &name) const;
  };

  /** Solves @p p, made by parameters_of_rung() of a problem other than
   * `eigenvalues`. Throws ComputationError. */
  RungFigures solve_rung(const Parameters &p, RunLog &log, Timers &timers);
} // namespace squeal

#endif
