// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/base/memory.h>
#include <squeal/base/run_log.h>
#include <squeal/base/timers.h>
#include <squeal/base/worst_of.h>
#include <squeal/eigen/dense_quadratic.h>
#include <squeal/model/cea_solution.h>
#include <squeal/model/frequency_pencil.h>
#include <squeal/model/linear_solver.h>

#include <algorithm>
#include <cmath>

namespace squeal
{
  namespace
  {
    CertifiedOptions
    certified_options(const EigenParameters &p)
    {
      CertifiedOptions options;
      options.lowest_frequency    = p.lowest_frequency;
      options.highest_frequency   = p.highest_frequency;
      options.residual_tolerance  = p.residual_tolerance;
      options.error_tolerance     = p.error_tolerance;
      options.maximum_enrichments = p.maximum_enrichments;
      return options;
    }

    BasisProducts
    products_of(const Model &model, const ModeSolution &modes)
    {
      return basis_products(model.parameters(),
                            *modes.pencil->space(),
                            modes.modes.mass_products.cols());
    }

    CeaSolution
    solve_certified(CertifiedSolver       &solver,
                    const EigenParameters &p,
                    RunLog                &log)
    {
      CeaSolution solution;
      solution.pairs =
        solver.solve(certified_options(p), [&](const BasisEnrichment &step) {
          log.info("  basis " + std::to_string(step.basis_size) +
                   ": worst residual " + rounded_text(step.worst_residual, 2) +
                   ", worst error estimate " +
                   rounded_text(step.worst_estimate, 2));
          return_freed_memory();
        });
      solution.history         = solver.history();
      solution.basis_size      = solver.basis().size();
      solution.growth_left_out = solver.growth_left_out();
      return solution;
    }

    /** Adds the modes with the moduli at both ends of the band. Those below its
     * upper end must be as many as the inertia of the factor counts. */
    void
    take_modes_at_ends_of_band(const FrequencyPencil &pencil,
                               const Parameters      &parameters,
                               CertifiedSolver       &solver,
                               RunLog                &log)
    {
      const EigenParameters &p = parameters.eigen;
      const double           f = p.highest_frequency;
      ModeOptions            options;
      options.tolerance = p.mode_tolerance;
      unsigned int n    = 0;
      for (const double end : {p.lowest_frequency, f})
        {
          const Pencil at_end  = pencil.merged_at(end);
          const auto   inverse = std::make_shared<const ShiftedInverse>(
            at_end,
            std::pow(2. * M_PI * f, 2),
            factor_storage(parameters, *at_end.space()));
          solver.extend(undamped_modes(at_end, *inverse, options).shapes);
          n = inverse->n_modes_below();
          solver.answer_with(inverse);
        }
      log.info("  " + std::to_string(n) +
               " modes below the end of the band with the moduli there, by "
               "the inertia of the factor");
      if (pencil.n_modes_below(solver.basis(), f) < n)
        throw ComputationError(
          "the basis misses a mode with the moduli at the end of the band: "
          "change Eigenvalues/Highest frequency a little");
    }


    /** The pairs of a scene whose moduli follow the frequency of each pair. */
    CeaSolution
    solve_over_frequency(const Model        &model,
                         const ModeSolution &modes,
                         RunLog             &log,
                         Timers             &timers)
    {
      Timers::Section section(timers, "Solve: eigenvalues over frequency");
      const auto     &p = model.parameters();
      log.info("  moduli follow the frequency of each pair; undamped modes, "
               "steady sliding and mesh errors take those of " +
               rounded_text(reference_frequency(p.eigen), 5) + " Hz");
      const FrequencyPencil pencil(
        model.linearized().system, p.scene, ModulusTables(p.scene));
      FrequencyDependentPairs finder(pencil.coefficients(),
                                     p.eigen.lowest_frequency,
                                     p.eigen.highest_frequency);
      CertifiedSolver         solver(pencil.pencil(),
                             *modes.inverse,
                             modes.modes,
                             &finder,
                             products_of(model, modes));
      take_modes_at_ends_of_band(pencil, p, solver, log);
      CeaSolution solution = solve_certified(solver, p.eigen, log);
      solution.lowest_frequency =
        std::max(p.eigen.lowest_frequency, finder.lowest_frequency());
      solution.has_looked_below = true;
      solution.growth_below     = finder.growth_below();
      return solution;
    }
  } // namespace



  CeaSolution
  solve_whole_band(CertifiedSolver       &solver,
                   const EigenParameters &p,
                   RunLog                &log)
  {
    CeaSolution solution      = solve_certified(solver, p, log);
    solution.lowest_frequency = p.lowest_frequency;
    solution.has_looked_below = true;
    solution.growth_below     = solver.growth_below_band();
    return solution;
  }

  namespace
  {
    /** Iterations of the direct solver end without a word. */
    void
    warn_of_residuals(const EigenParameters &p,
                      const ComplexPairs    &pairs,
                      RunLog                &log)
    {
      if (pairs.size() == 0)
        return;
      if (const double worst = worst_of(pairs.residual);
          !(worst <= p.residual_tolerance))
        log.warning("the direct solver leaves a relative residual of " +
                    rounded_text(worst, 2) +
                    ", more than 'Eigenvalues/Residual tolerance' = " +
                    rounded_text(p.residual_tolerance, 2) +
                    ": pairs may be wrong by as much, and others missing");
    }
  } // namespace

  CeaSolution
  solve_cea(const Model                      &model,
            ModeSolution                     &modes,
            RunLog                           &log,
            Timers                           &timers,
            std::unique_ptr<CertifiedSolver> *kept)
  {
    const auto &p = model.parameters().eigen;
    if (ModulusTables(model.parameters().scene).depend_on_frequency())
      return solve_over_frequency(model, modes, log, timers);
    CeaSolution solution;
    if (p.solver == EigenParameters::Solver::direct)
      {
        Timers::Section section(timers, "Solve: direct eigenvalues");
        solution.pairs            = solve_direct(model, modes);
        solution.lowest_frequency = p.lowest_frequency;
        warn_of_residuals(p, solution.pairs, log);
        return solution;
      }
    Timers::Section section(timers, "Solve: certified eigenvalues");
    auto            solver = std::make_unique<CertifiedSolver>(*modes.pencil,
                                                    *modes.inverse,
                                                    modes.modes,
                                                    nullptr,
                                                    products_of(model, modes));
    modes.modes.release_start();
    return_freed_memory();
    solution = solve_whole_band(*solver, p, log);
    if (kept)
      *kept = std::move(solver);
    return solution;
  }



  std::string
  text_unseen_below_band(const EigenParameters &p)
  {
    if (p.lowest_frequency == 0.)
      return "";
    return "not looked at: what grows below " +
           rounded_text(p.lowest_frequency, 5) +
           " Hz, divergence (without vibration) included, is seen with "
           "'Eigenvalues/Lowest frequency = 0' only";
  }

  namespace
  {
    /** Of a growing motion that is not certified. */
    std::string
    text_of_growth(const std::complex<double> lambda)
    {
      // Rounding leaves a frequency where there is none.
      return (std::abs(lambda.imag()) < 1e-9 * std::abs(lambda)
                ? std::string("divergence: a motion grows without vibration")
                : "a motion at " +
                    rounded_text(lambda.imag() / (2. * M_PI), 5) +
                    " Hz grows") +
             ", by about " + rounded_text(lambda.real(), 3) + " 1/s";
    }

    /** What to do to have a motion below in the tables. */
    std::string
    how_to_see(const CeaSolution &solution, const EigenParameters &p)
    {
      return solution.lowest_frequency > p.lowest_frequency
               ? "moduli that follow the frequency are sought from a "
                 "thousandth "
                 "of 'Eigenvalues/Highest frequency' on: lower that, or give "
                 "the "
                 "modulus as a number"
               : "set 'Eigenvalues/Lowest frequency = 0' to have it in the "
                 "tables";
    }
  } // namespace



  std::string
  text_below_band(const CeaSolution &solution, const EigenParameters &p)
  {
    const double lowest = solution.lowest_frequency;
    if (lowest == 0. || !solution.has_looked_below)
      return text_unseen_below_band(p);
    const std::complex<double> lambda = solution.growth_below;
    if (lambda == 0.)
      return "nothing grows below " + rounded_text(lowest, 5) +
             " Hz in the basis of the band, divergence included; not "
             "certified" +
             (lowest > p.lowest_frequency
                ? "; pairs there that do not grow are not in the tables: " +
                    how_to_see(solution, p)
                : "");
    return text_of_growth(lambda) +
           ", below the band: " + how_to_see(solution, p);
  }

  std::string
  text_of_growth_left_out(const CeaSolution &solution)
  {
    return solution.growth_left_out == 0.
             ? ""
             : text_of_growth(solution.growth_left_out) +
                 ", faster than the band vibrates; what grows so fast is not "
                 "in the tables, since the basis does not certify it: raise "
                 "'Eigenvalues/Highest frequency' or 'Eigenvalues/Maximum "
                 "enrichments'";
  }



  namespace
  {
    bool
    grows_below(const CeaSolution &solution)
    {
      return solution.lowest_frequency > 0. &&
             solution.growth_below.real() > 0.;
    }
  } // namespace

  std::string
  text_of_growth_outside(const CeaSolution &solution, const EigenParameters &p)
  {
    const std::string below    = grows_below(solution)
                                   ? text_below_band(solution, p)
                                   : "",
                      left_out = text_of_growth_left_out(solution);
    return below + (below.empty() || left_out.empty() ? "" : "; ") + left_out;
  }



  void
  warn_of_growth_left_out(const CeaSolution &solution,
                          const std::string &where,
                          RunLog            &log)
  {
    if (const std::string text = text_of_growth_left_out(solution);
        !text.empty())
      log.warning(where + text);
  }

  void
  warn_of_growth_outside(const CeaSolution     &solution,
                         const EigenParameters &p,
                         const std::string     &where,
                         RunLog                &log)
  {
    if (grows_below(solution))
      log.warning(where + text_below_band(solution, p));
    warn_of_growth_left_out(solution, where, log);
  }
} // namespace squeal
