// SPDX-License-Identifier: LGPL-2.1-or-later

// The pairs of a scene by the direct solver, alone and beside certified ones.

#include <squeal/base/run_log.h>
#include <squeal/base/timers.h>
#include <squeal/base/worst_of.h>
#include <squeal/eigen/dense_quadratic.h>
#include <squeal/eigen/direct_solver.h>
#include <squeal/model/cea_solution.h>

#include <algorithm>
#include <cmath>

namespace squeal
{
  namespace
  {
    /** Frequency, Hz, nearest to which the direct solver looks. */
    double
    shift_frequency(const EigenParameters &p)
    {
      return p.direct_shift_frequency >= 0.
               ? p.direct_shift_frequency
               : 0.5 * (p.lowest_frequency + p.highest_frequency);
    }

    DirectSolver
    direct_solver(const Model &model, const ModeSolution &modes)
    {
      return {*modes.pencil,
              {0., 2. * M_PI * shift_frequency(model.parameters().eigen)}};
    }

    /** Pairs by the direct solver of the band and some beyond it; where their
     * number is not given, as far as to @p stated eigenvalues. */
    DirectPairs
    direct_pairs_of(const DirectSolver     &solver,
                    const Model            &model,
                    const ModeSolution     &modes,
                    const Eigen::VectorXcd &stated = {})
    {
      const auto                &p = model.parameters().eigen;
      const double               f = shift_frequency(p);
      const std::complex<double> shift(0., 2. * M_PI * f);
      if (p.number_of_pairs > 0)
        return solver.solve_within(0., p.number_of_pairs);
      // Within the distance to the farther edge of the band there may be as
      // many modes on the other side of it.
      unsigned int n = 4;
      const double reach =
        std::max(p.highest_frequency - f, f - p.lowest_frequency);
      for (unsigned int i = 0; i < modes.modes.omega_squared.size(); ++i)
        if (std::abs(modes.modes.frequency(i) - f) <= 1.02 * reach)
          ++n;
      return solver.solve_within(reach_of(stated, shift), n);
    }

    ComplexPairs
    in_band(const ComplexPairs &all, const EigenParameters &p)
    {
      std::vector<int> kept;
      for (unsigned int i = 0; i < all.size(); ++i)
        if (is_between(
              all.frequency(i), p.lowest_frequency, p.highest_frequency))
          kept.push_back(i);
      return select_pairs(all, kept);
    }
  } // namespace



  ComplexPairs
  solve_direct(const Model &model, const ModeSolution &modes)
  {
    const DirectSolver solver = direct_solver(model, modes);
    ComplexPairs pairs = in_band(direct_pairs_of(solver, model, modes).pairs,
                                 model.parameters().eigen);
    solver.find_conditions(pairs);
    return pairs;
  }



  Table
  compare_with_direct(const Model        &model,
                      const ModeSolution &modes,
                      const ComplexPairs &certified,
                      RunLog             &log,
                      Timers             &timers)
  {
    Timers::Section   section(timers, "Solve: direct check");
    const DirectPairs found = direct_pairs_of(
      direct_solver(model, modes), model, modes, certified.lambda);
    const ComplexPairs &direct = found.pairs;
    using Type                 = Table::Type;
    Table  table({{"index", Type::integer, "", "number of the pair, from 1"},
                  {"frequency_hz", Type::real, "Hz", "certified", 7},
                  {"sigma_per_s", Type::real, "1/s", "certified", 6},
                  {"direct_frequency_hz", Type::real, "Hz", "direct", 7},
                  {"direct_sigma_per_s", Type::real, "1/s", "direct", 6},
                  {"difference_rel", Type::real, "", "|d lambda| / |lambda|", 2},
                  {"error_estimate_rel", Type::real, "", "estimated", 2},
                  {"noise_floor_rel", Type::real, "", "rounding", 2},
                  {"condition", Type::real, "", "of the eigenvalue", 2}});
    double worst           = 0.;
    unsigned int n_reached = 0;
    ComplexPairs copy      = certified;
    estimate_errors(copy, direct.lambda);
    for (unsigned int i = 0; i < certified.size(); ++i)
      {
        std::vector<Cell> row = {
          i + 1, certified.frequency(i), certified.sigma(i)};
        if (found.has_reached(certified.lambda[i]))
          {
            Eigen::Index best;
            (direct.lambda.array() - certified.lambda[i]).abs().minCoeff(&best);
            row.insert(row.end(),
                       {direct.frequency(best),
                        direct.sigma(best),
                        copy.error_estimate[i]});
            worst = worst_of(worst, copy.error_estimate[i]);
            ++n_reached;
          }
        else
          row.resize(6);
        row.insert(row.end(),
                   {or_missing(certified.error_estimate[i]),
                    certified.noise_floor[i],
                    unbounded(certified.condition[i])});
        table.add_row(row);
      }
    const auto missing =
      pairs_missing(certified.lambda,
                    found,
                    model.parameters().eigen.lowest_frequency,
                    model.parameters().eigen.highest_frequency);
    for (const unsigned int k : missing)
      {
        std::vector<Cell> row(9);
        row[3] = direct.frequency(k);
        row[4] = direct.sigma(k);
        table.add_row(row);
        // All of it is wrong.
        worst = worst_of(worst, 1.);
      }
    log.info(
      "  direct solver: " +
      std::to_string(in_band(direct, model.parameters().eigen).size()) +
      " pairs in the band (certified: " + std::to_string(certified.size()) +
      ", " + std::to_string(n_reached) +
      " of them within its reach), largest relative difference " +
      rounded_text(worst, 2));
    const std::string text = text_of_missing(direct.lambda(missing));
    if (!text.empty())
      log.warning(text);
    return table;
  }
} // namespace squeal
