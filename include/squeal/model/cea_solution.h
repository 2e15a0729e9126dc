// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_model_cea_solution_h
#define squeal_model_cea_solution_h

#include <squeal/eigen/certified_solver.h>
#include <squeal/model/mode_solution.h>
#include <squeal/results/table.h>

#include <complex>
#include <memory>
#include <string>
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
    /** From where on pairs were sought, Hz: the lowest frequency of the band
     * or, where moduli follow the frequency, a thousandth of the highest if
     * that is more. */
    double lowest_frequency = 0.;
    /** Whether motions below the band were looked at, and the one of them that
     * grows fastest, 1/s; 0 where none grows. Not certified. */
    bool                 has_looked_below = false;
    std::complex<double> growth_below     = 0.;
    /** CertifiedSolver::growth_left_out(), 1/s. */
    std::complex<double> growth_left_out = 0.;
  };

  /** What is known of motions below the lowest frequency that was sought, among
   * them divergence, which has frequency 0; empty where the band starts at 0.
   */
  std::string text_below_band(const CeaSolution     &solution,
                              const EigenParameters &parameters);

  /** That motions grow so fast that the basis does not certify them, and are
   * left out; empty where there are none. */
  std::string text_of_growth_left_out(const CeaSolution &solution);

  /** Clauses of both kinds of growth that the tables do not have, below the
   * band and left out, "; " between them; empty where nothing grows there. A
   * verdict that nothing grows does not hold beside them. */
  std::string text_of_growth_outside(const CeaSolution     &solution,
                                     const EigenParameters &parameters);

  /** Warns of the growth that is left out; the text follows @p where. */
  void warn_of_growth_left_out(const CeaSolution &solution,
                               const std::string &where,
                               RunLog            &log);

  /** Warns of both kinds; the text follows @p where. */
  void warn_of_growth_outside(const CeaSolution     &solution,
                              const EigenParameters &parameters,
                              const std::string     &where,
                              RunLog                &log);

  /** That nobody has looked, for analyses that see the band alone; empty where
   * it starts at 0. */
  std::string text_unseen_below_band(const EigenParameters &parameters);

  /** Solves with the solver of the parameters (certified or direct). Where
   * that of another scene can start from the certified one, it is left in @p
   * kept (optional); @p modes must live as long. */
  CeaSolution solve_cea(const Model                      &model,
                        ModeSolution                     &modes,
                        RunLog                           &log,
                        Timers                           &timers,
                        std::unique_ptr<CertifiedSolver> *kept = nullptr);

  /** Solves the pencil of @p solver, whose moduli are the same for all pairs.
   */
  CeaSolution solve_whole_band(CertifiedSolver       &solver,
                               const EigenParameters &parameters,
                               RunLog                &log);

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
