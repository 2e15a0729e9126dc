// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_analyses_run_figures_h
#define squeal_analyses_run_figures_h

#include <squeal/parameters/parameters.h>

#include <limits>
#include <string>
#include <vector>

namespace squeal
{
  class RunLog;
  class Timers;

  /** One number that comes out of steady sliding or of a transient. */
  struct RunFigure
  {
    std::string name;  /**< as the column of preload.csv or transient.csv */
    double      value; /**< NaN where the run has none */
    /** What the run itself states as its error, in the unit of the value; NaN
     * where it states none. */
    double stated = std::numeric_limits<double>::quiet_NaN();
    /** An error by itself, whose true value is 0. */
    bool is_error = false;
    /** What differences and stated errors are measured by, in the unit of the
     * value; NaN: the value itself. Of a position the value says nothing, which
     * may be 0 by symmetry or by where the scene stands. */
    double scale = std::numeric_limits<double>::quiet_NaN();

    /** @p difference over the scale or, without one, over the size of @p value.
     */
    double relative(const double difference, const double value) const;
  };

  /** What one run gives without its files, and what it takes: for analyses that
   * compare runs of another one. */
  struct RunFigures
  {
    std::vector<RunFigure> figures;
    unsigned int           n_unknowns = 0;
    unsigned int           n_modes = 0, n_steps = 0; /**< of a transient */
    std::string            verdict;        /**< "unstable, limit cycle", ... */
    double                 seconds   = 0.; /**< CPU time of the process */
    double                 memory_mb = 0.; /**< its peak so far */

    /** Whether there are figures; if not the verdict says why. */
    bool is_solved() const;
    /** The figure called @p name; NaN in place of one that is not there. */
    double value_of(const std::string &name) const;
  };

  /** Steady sliding under the full load as `Analysis = preload` computes it.
   * Times and memory are left to the caller. Throws InputError,
   * ComputationError. */
  RunFigures figures_of_preload(const Parameters &parameters, Timers &timers);

  /** One transient to its end, without history and checkpoints, likewise. */
  RunFigures figures_of_transient(const Parameters &parameters,
                                  RunLog           &log,
                                  Timers           &timers);
} // namespace squeal

#endif
