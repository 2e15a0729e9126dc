// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/base/number_text.h>
#include <squeal/base/run_log.h>
#include <squeal/base/timers.h>
#include <squeal/base/worst_of.h>
#include <squeal/discretization/even_faces.h>
#include <squeal/model/adaptive_cea.h>
#include <squeal/model/finer_modes.h>
#include <squeal/model/growth_errors.h>
#include <squeal/model/second_solutions.h>
#include <squeal/scene/modulus_table.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace squeal
{
  namespace
  {
    /** Squared contributions that the refined cells of a step hold. */
    constexpr double refined_share = 0.7;

    bool
    is_adaptive(const DiscretizationParameters &p)
    {
      return p.refinement ==
             DiscretizationParameters::Refinement::contact_error;
    }

    unsigned int
    loudest_of(const ComplexPairs &pairs)
    {
      unsigned int loudest = 0;
      for (unsigned int i = 1; i < pairs.size(); ++i)
        if (pairs.sigma(i) > pairs.sigma(loudest))
          loudest = i;
      return loudest;
    }

    /** Those of all pairs that grow and of the least damped others; NaN for the
     * rest, which would cost a sixth of an analysis. */
    PairErrors
    errors_of_loudest(const Model        &model,
                      const Pencil       &pencil,
                      const ComplexPairs &pairs,
                      RunLog             &log,
                      Timers             &timers)
    {
      if (pairs.left.cols() != pairs.right.cols()) // of the direct solver
        return pair_mesh_errors(model, pencil, pairs);
      constexpr std::size_t n_estimated = 8;
      std::vector<int>      order(pairs.size());
      std::iota(order.begin(), order.end(), 0);
      std::sort(order.begin(), order.end(), [&](const int a, const int b) {
        return pairs.sigma(a) > pairs.sigma(b);
      });
      std::size_t n = std::min(n_estimated, order.size());
      while (n < order.size() && pairs.sigma(order[n]) > 0.)
        ++n;
      order.resize(n);
      const PairErrors some = pair_errors_with_locking(
        model, pencil, select_pairs(pairs, order), log, timers);
      PairErrors result = PairErrors::unknown(pairs.size());
      for (std::size_t i = 0; i < n; ++i)
        {
          result.lambda[order[i]]    = some.lambda[i];
          result.at_points[order[i]] = some.at_points[i];
        }
      return result;
    }

    /** Whether growing pairs are sought in a second solution. */
    bool
    has_second_solution(const Model &model)
    {
      return model.discretization()->degree() > 1 &&
             !ModulusTables(model.parameters().scene).depend_on_frequency();
    }

    /** Of a frequency, from which on quadratic elements are so rough that what
     * they change of a growth rate says little of what is left. */
    constexpr double rough = 0.01;

    /** Warns of growing pairs of quadratic elements that are so rough. */
    void
    warn_of_rough_mesh(const Model        &model,
                       const ComplexPairs &pairs,
                       const PairErrors   &errors,
                       RunLog             &log)
    {
      unsigned int n_rough = 0;
      double       largest = 0.;
      for (Eigen::Index k = 0; k < errors.lambda.size(); ++k)
        if (const double share =
              std::abs(errors.lambda[k].imag()) / std::abs(pairs.lambda[k]);
            grows(pairs, k) && share > rough)
          {
            ++n_rough;
            largest = std::max(largest, share);
          }
      if (n_rough > 0 && model.discretization()->degree() == 2)
        log.warning("the mesh shifts the frequencies of " +
                    counted(n_rough, "growing pair") + " by up to " +
                    rounded_text(100. * largest, 2) +
                    " %: on so rough a mesh growth rates need not near their "
                    "limit from one side, and their mesh errors may be five "
                    "times too small; raise Discretization/Degree or refine");
    }

    /** Puts better errors of growing pairs in the place of those of the cells,
     * where they are known, and says where those of the cells stay: they know
     * little. */
    void
    take_growth_errors(const Eigen::VectorXcd &better,
                       const Model            &model,
                       const ComplexPairs     &pairs,
                       PairErrors             &errors,
                       RunLog                 &log)
    {
      unsigned int n_growing = 0, n_by_cells = 0;
      for (Eigen::Index k = 0; k < better.size(); ++k)
        {
          const bool            growing = grows(pairs, k);
          std::complex<double> &error   = errors.lambda[k];
          n_growing += growing;
          if (!std::isnan(better[k].real()))
            error = better[k];
          else if (growing && !std::isnan(error.real()))
            {
              ++n_by_cells;
              error.real(at_least_by_frequency(
                error.real(), error.imag(), pairs.lambda[k]));
            }
        }
      warn_of_rough_mesh(model, pairs, errors, log);
      if (n_by_cells == 0)
        return;
      const std::string text =
        "mesh errors of growth rates: of " + std::to_string(n_by_cells) +
        " of " + std::to_string(n_growing) +
        " growing pairs estimated cell by cell, to first order";
      if (has_second_solution(model))
        log.warning(text +
                    ", which may be several times too small: not found again "
                    "in a second solution; raise Discretization/Degree");
      else
        log.info("  " + text + ": there is no second solution");
    }

    /** Least share of what the mesh before has changed that is left. */
    constexpr double least_left = 0.1;

    /** Of growth rates: by what the refinement from the mesh before, if there
     * is one, has changed, else by one degree less. */
    Eigen::VectorXcd
    errors_of_growth(const Model        &model,
                     const ComplexPairs &pairs,
                     const PairErrors   &errors,
                     const CoarserPairs &before,
                     SecondSolutions    &second,
                     Timers             &timers)
    {
      const Eigen::VectorXcd result =
        growth_errors(model, pairs, errors, before, least_left);
      for (unsigned int k = 0; k < pairs.size(); ++k)
        if (grows(pairs, k) && std::isnan(result[k].real()))
          return growth_errors_by_lower_degree(
            model, pairs, errors, second, timers);
      return result;
    }

    /** Of all pairs on a mesh that is to be refined, else of the loudest. */
    PairErrors
    errors_after(const CoarserPairs &before,
                 const Model        &model,
                 const Pencil       &pencil,
                 const ComplexPairs &pairs,
                 SecondSolutions    &second,
                 RunLog             &log,
                 Timers             &timers)
    {
      PairErrors errors =
        is_adaptive(model.parameters().discretization)
          ? pair_errors_with_locking(model, pencil, pairs, log, timers)
          : errors_of_loudest(model, pencil, pairs, log, timers);
      if (nearly_incompressible_bodies(model.parameters().scene).empty())
        take_growth_errors(
          errors_of_growth(model, pairs, errors, before, second, timers),
          model,
          pairs,
          errors,
          log);
      return errors;
    }

    /** How far the pairs are from what is asked of the mesh. */
    struct Excess
    {
      unsigned int    loudest;
      double          growth_rate; /**< of the loudest, error over tolerance */
      Eigen::VectorXd frequency;   /**< of every pair, error over tolerance */

      bool
      is_met() const
      {
        return growth_rate <= 1. && worst_of(frequency) <= 1.;
      }
    };

    Excess
    excess_of(const ComplexPairs             &pairs,
              const PairErrors               &errors,
              const DiscretizationParameters &p)
    {
      Excess result{loudest_of(pairs), 0., Eigen::VectorXd(pairs.size())};
      result.growth_rate = std::abs(errors.lambda[result.loudest].real()) /
                           p.growth_rate_tolerance;
      for (unsigned int k = 0; k < pairs.size(); ++k)
        result.frequency[k] = std::abs(errors.lambda[k].imag()) /
                              (p.tolerance * std::abs(pairs.lambda[k]));
      return result;
    }

    /** What each cell gives to the unstable pairs and to the loudest one, and
     * to the frequencies that are not good enough yet: on a mesh that detunes
     * the pairs nothing may be unstable at all. Of an unstable pair the complex
     * part counts: its growth rate hangs on the detuning of its modes, and real
     * parts alone, of both signs, leave frequencies and with them the detuning
     * far off. */
    std::vector<double>
    indicators(const ComplexPairs             &pairs,
               const PairErrors               &errors,
               const Excess                   &excess,
               const DiscretizationParameters &p)
    {
      std::vector<double> result(errors.cell.cols(), 0.);
      for (unsigned int k = 0; k < pairs.size(); ++k)
        {
          const bool counts = (k == excess.loudest || grows(pairs, k)) &&
                              excess.growth_rate > 1.,
                     detuned = excess.frequency[k] > 1.;
          for (Eigen::Index i = 0; i < errors.cell.cols(); ++i)
            {
              if (counts)
                result[i] +=
                  std::abs(errors.cell(k, i)) / p.growth_rate_tolerance;
              if (detuned)
                result[i] += std::abs(errors.cell(k, i).imag()) /
                             (p.tolerance * std::abs(pairs.lambda[k]));
            }
        }
      return result;
    }

    /** Motions without stiffness: lambda = 0 is defective there (x and t x),
     * and friction must not decide on which side of the axis it is found. */
    void
    warn_of_free_motions(const Model        &model,
                         const ModeSolution &modes,
                         RunLog             &log)
    {
      const Parameters &p    = model.parameters();
      const std::string free = free_motions(model, modes);
      if (free.empty())
        return;
      if (p.eigen.lowest_frequency == 0.)
        throw InputError(free +
                         ": raise Eigenvalues/Lowest frequency above 0, or "
                         "hold them by Scene/Supports or Scene/Springs");
      log.warning(free);
    }
  } // namespace



  Table
  mesh_steps_table()
  {
    using Type = Table::Type;
    return Table(
      {{"mesh", Type::integer, "", "number of the mesh"},
       {"unknowns", Type::integer, "", "free unknowns"},
       {"frequency_hz", Type::real, "Hz", "of the loudest pair", 7},
       {"sigma_per_s", Type::real, "1/s", "its growth rate", 5},
       {"sigma_error_mesh_per_s",
        Type::real,
        "1/s",
        "estimated: growth rate on an infinitely fine mesh less this one",
        3},
       {"frequency_error_mesh_rel",
        Type::real,
        "",
        "largest estimated error of a frequency, relative",
        2},
       {"cpu_seconds", Type::real, "s", "since the start", 3}});
  }



  PairErrors
  loudest_pair_errors(const Model        &model,
                      const Pencil       &pencil,
                      const ComplexPairs &pairs,
                      SecondSolutions    &second,
                      RunLog             &log,
                      Timers             &timers)
  {
    Timers::Section section(timers, "Solve: mesh error of the pairs");
    return errors_after({}, model, pencil, pairs, second, log, timers);
  }



  MeshedCea
  solve_cea_adaptively(Model &model, RunLog &log, Timers &timers, Table *steps)
  {
    const auto  &p = model.parameters().discretization;
    CoarserPairs before; // of the mesh that was refined
    for (unsigned int cycle = 0;; ++cycle)
      {
        MeshedCea result{solve_modes_adaptively(model, log, timers), {}, {}};
        if (result.modes.modes.shapes.cols() +
              result.modes.modes.supplement.cols() ==
            0)
          refuse_empty_band(model.parameters(), result.modes);
        if (cycle == 0)
          warn_of_free_motions(model, result.modes, log);
        result.solution = solve_cea(model, result.modes, log, timers);
        if (result.solution.pairs.size() == 0)
          {
            warn_of_growth_left_out(result.solution, "", log);
            refuse_empty_band(model.parameters(), result.modes);
          }
        const ComplexPairs &pairs = result.solution.pairs;
        if (p.estimate_error || is_adaptive(p))
          {
            Timers::Section section(timers, "Solve: mesh error of the pairs");
            SecondSolutions second;
            result.errors = errors_after(
              before, model, *result.modes.pencil, pairs, second, log, timers);
          }
        else
          result.errors = PairErrors::unknown(pairs.size());
        if (!is_adaptive(p))
          return result;

        const Excess       excess = excess_of(pairs, result.errors, p);
        const unsigned int k      = excess.loudest;
        const double       error  = result.errors.lambda[k].real();
        const double       worst  = p.tolerance * worst_of(excess.frequency);
        log.info("  mesh " + std::to_string(cycle) + ": " +
                 std::to_string(model.n_unknowns()) +
                 " unknowns, growth rate of the loudest pair " +
                 rounded_text(pairs.sigma(k), 5) +
                 " 1/s, estimated error by the mesh " + rounded_text(error, 2) +
                 " 1/s; of frequencies at most " + rounded_text(worst, 2) +
                 ", relative");
        if (steps)
          steps->add_row({cycle,
                          model.n_unknowns(),
                          pairs.frequency(k),
                          pairs.sigma(k),
                          error,
                          worst,
                          timers.total_cpu()});
        if (excess.is_met())
          return result;
        if (cycle + 1 >= p.maximum_cycles ||
            model.n_unknowns() >= p.maximum_dofs)
          {
            log.warning("the mesh was not refined to the asked tolerances: "
                        "raise Discretization/Maximum dofs or "
                        "Maximum cycles");
            return result;
          }
        before = coarser_pairs(model, pairs);
        {
          Timers::Section section(timers, "Setup: refinement");
          model.discretization()->refine(
            indicators(pairs, result.errors, excess, p),
            refined_share,
            even_faces(*model.discretization()));
        }
        model.assemble(timers);
      }
  }
} // namespace squeal
