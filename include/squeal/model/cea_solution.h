// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_model_cea_solution_h
#define squeal_model_cea_solution_h

#include <squeal/eigen/certified_solver.h>
#include <squeal/model/mode_solution.h>
#include <squeal/results/table.h>

#include <vector>

namespace squeal
{
  class RunLog;
  class Timers;

  /** Complex pairs in the band and how the basis got there. */
  struct CeaSolution
  {
    ComplexPairs                 pairs;
    std::vector<BasisEnrichment> history; /**< empty for the direct solver */
    unsigned int                 basis_size = 0;
  };

  /** Solves with the solver of the parameters (certified or direct). */
  CeaSolution solve_cea(const Model  &model,
                        ModeSolution &modes,
                        RunLog       &log,
                        Timers       &timers);

  /** Pairs of the band by the direct solver. */
  ComplexPairs solve_direct(const Model &model, const ModeSolution &modes);

  /** direct_check.csv: every certified pair beside the direct one; nearly
   * coalesced pairs by mean and squared half-difference. */
  Table compare_with_direct(const Model        &model,
                            const ModeSolution &modes,
                            const ComplexPairs &certified,
                            RunLog             &log,
                            Timers             &timers);
} // namespace squeal

#endif
