// SPDX-License-Identifier: LGPL-2.1-or-later

// A sweep beside direct solutions and beside a modal basis.

#include <squeal/analyses/sweep/sweep_solution.h>
#include <squeal/base/worst_of.h>
#include <squeal/eigen/certified_solver.h>
#include <squeal/eigen/direct_solver.h>
#include <squeal/sweep/contact_cells.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace squeal
{
  namespace
  {
    using Type = Table::Type;

    /** Distance of the points beside lock-ins, decades or shares of a range:
     * half of the 1e-4 they are asked for. */
    constexpr double beside = 5e-5;

    std::vector<SweepPoint>
    check_points(const SweepModel    &model,
                 const SweepSolution &solution,
                 const unsigned int   n)
    {
      const SweepGrid        &grid = model.grid();
      std::vector<SweepPoint> lock_ins, result;
      const double            unit =
        grid.is_logarithmic(0) ? 1. : grid.upper(0) - grid.lower(0);
      for (const auto &line : solution.lines)
        for (const auto &e : line.exceptional)
          {
            SweepPoint point = line.start;
            point[0]         = e.coordinate.real() +
                       (lock_ins.size() % 2 ? 1. : -1.) * beside * unit;
            if (point[0] > grid.lower(0) && point[0] < grid.upper(0))
              lock_ins.push_back(point);
          }
      const std::size_t n_lock = std::min<std::size_t>(lock_ins.size(), n / 3);
      for (std::size_t i = 0; i < n_lock; ++i)
        result.push_back(lock_ins[i * lock_ins.size() / n_lock]);
      // Not those that the basis was trained at: the far end of the sequence.
      const auto spread = grid.spread(1000 + n);
      for (std::size_t i = 0; result.size() < n; ++i)
        result.push_back(spread[spread.size() - 1 - i]);
      return result;
    }

    unsigned int
    nearest(const Eigen::VectorXcd &values, const std::complex<double> lambda)
    {
      unsigned int best = 0;
      for (Eigen::Index i = 0; i < values.size(); ++i)
        if (std::abs(values[i] - lambda) < std::abs(values[best] - lambda))
          best = i;
      return best;
    }

    /** Largest error of those of @p pairs that the direct solver has reached.
     */
    double
    largest_error(ComplexPairs pairs, const DirectPairs &direct)
    {
      double worst = 0.;
      estimate_errors(pairs, direct.pairs.lambda);
      for (unsigned int i = 0; i < pairs.size(); ++i)
        if (direct.has_reached(pairs.lambda[i]))
          worst = worst_of(worst, pairs.error_estimate[i]);
      return worst;
    }
  } // namespace



  DirectPairs
  direct_pairs(const SweepModel       &model,
               const SweepPoint       &point,
               const SceneParameters  &scene,
               const Band             &band,
               const Eigen::VectorXcd &stated)
  {
    const double centre = 0.5 * (band.lowest + band.highest);
    // Beyond the ends of the band, for what grows or decays fast there.
    const double               radius = 1.25 * (band.highest - centre);
    const std::complex<double> shift(0., 2. * M_PI * centre);
    const Pencil               pencil(model.system().merged(), scene);
    const DirectSolver         solver(pencil, shift);
    // At first as many as there are modes in reach, and some more.
    const auto   modes = model.undamped(point);
    unsigned int n     = 6;
    for (Eigen::Index i = 0; i < modes.modes.omega_squared.size(); ++i)
      if (std::abs(std::sqrt(std::max(modes.modes.omega_squared[i], 0.)) /
                     (2. * M_PI) -
                   centre) < radius)
        ++n;
    return solver.solve_within(
      std::max(2. * M_PI * radius, reach_of(stated, shift)), n);
  }



  namespace
  {
    /** Whether a true error, relative as the others, is beyond the tolerances
     * of the sweep and beyond what was stated, rounding aside. */
    bool
    is_false(const double           error,
             const double           stated,
             const double           rounding,
             const double           size,
             const SweepParameters &p)
    {
      return (error > p.frequency_tolerance ||
              error * size > p.sigma_tolerance) &&
             error > 3. * stated + 10. * rounding;
    }
  } // namespace


  Table
  direct_check_table(SweepModel          &model,
                     const SweepSolution &solution,
                     RunContext          &context)
  {
    Timers::Section  section(context.timers, "Solve: direct checks");
    const SweepGrid &grid = model.grid();
    Table            table;
    for (unsigned int a = 0; a < grid.n_axes(); ++a)
      table.add_column(
        {grid.axis(a).name, Type::real, "", grid.axis(a).entries[0], 7});
    for (const Table::Column &column : std::vector<Table::Column>{
           {"frequency_hz", Type::real, "Hz", "of the sweep", 8},
           {"sigma_per_s", Type::real, "1/s", "of the sweep", 7},
           {"direct_frequency_hz", Type::real, "Hz", "direct", 8},
           {"direct_sigma_per_s", Type::real, "1/s", "direct", 7},
           {"error_rel", Type::real, "", "|dlambda| / |lambda|", 2},
           {"error_estimate_rel", Type::real, "", "estimated", 2},
           {"condition", Type::real, "", "of the eigenvalue", 2}})
      table.add_column(column);
    double       worst = 0., least_ratio = 1e300, largest_ratio = 0.;
    unsigned int n_outside = 0, n_judged = 0, n_beyond = 0, n_held = 0,
                 n_false = 0;
    std::string  missing; // at the first point where any is
    unsigned int n_missing = 0;
    Progress     progress(
      context.log, "direct checks", context.parameters.sweep.direct_checks);
    for (const auto &point :
         check_points(model, solution, context.parameters.sweep.direct_checks))
      {
        n_held += !has_known_contact(grid, point);
        WorstError         estimated;
        const ComplexPairs pairs  = model.solve_certified(point, estimated);
        const DirectPairs  direct = direct_pairs(
          model, point, grid.scene(point), model.band(), pairs.lambda);
        ComplexPairs copy = pairs;
        estimate_errors(copy, direct.pairs.lambda);
        for (unsigned int i = 0; i < pairs.size(); ++i)
          {
            const bool        is_reached = direct.has_reached(pairs.lambda[i]);
            std::vector<Cell> row;
            for (unsigned int a = 0; a < grid.n_axes(); ++a)
              row.emplace_back(grid.value(a, point[a]));
            row.insert(row.end(), {pairs.frequency(i), pairs.sigma(i)});
            if (is_reached)
              {
                const unsigned int k =
                  nearest(direct.pairs.lambda, pairs.lambda[i]);
                row.insert(row.end(),
                           {direct.pairs.frequency(k),
                            direct.pairs.sigma(k),
                            copy.error_estimate[i]});
              }
            else
              row.resize(row.size() + 3);
            row.insert(
              row.end(),
              {pairs.error_estimate[i], unbounded(pairs.condition[i])});
            table.add_row(row);
            n_beyond += !is_reached;
            if (!is_reached)
              continue;
            worst = worst_of(worst, copy.error_estimate[i]);
            n_false += is_false(copy.error_estimate[i],
                                pairs.error_estimate[i],
                                copy.noise_floor[i],
                                std::abs(pairs.lambda[i]),
                                context.parameters.sweep);
            if (copy.error_estimate[i] > 1e-10)
              {
                const double ratio =
                  pairs.error_estimate[i] / copy.error_estimate[i];
                least_ratio   = std::min(least_ratio, ratio);
                largest_ratio = std::max(largest_ratio, ratio);
                ++n_judged;
                n_outside += ratio < 1. / 3. || ratio > 3.;
              }
          }
        const auto lacking = pairs_missing(
          pairs.lambda, direct, model.band().lowest, model.band().highest);
        for (const unsigned int k : lacking)
          {
            std::vector<Cell> row;
            for (unsigned int a = 0; a < grid.n_axes(); ++a)
              row.emplace_back(grid.value(a, point[a]));
            row.resize(row.size() + 2);
            row.insert(row.end(),
                       {direct.pairs.frequency(k), direct.pairs.sigma(k)});
            row.resize(row.size() + 3);
            table.add_row(row);
            // All of it is wrong.
            worst = worst_of(worst, 1.);
          }
        n_missing += !lacking.empty();
        if (missing.empty())
          if (const std::string text =
                text_of_missing(direct.pairs.lambda(lacking));
              !text.empty())
            missing = "at " + text_of(grid, point) + " " + text;
        progress.advance();
      }
    if (n_missing > 0)
      {
        context.log.warning(
          missing + "; so at " + std::to_string(n_missing) + " of the " +
          std::to_string(context.parameters.sweep.direct_checks) +
          " points of the direct checks");
        context.record.figures.emplace_back("missing", missing);
      }
    context.log.info(
      "  direct checks: largest error " + rounded_text(worst, 2) +
      (n_judged > 0
         ? "; estimate over error from " + rounded_text(least_ratio, 2) +
             " to " + rounded_text(largest_ratio, 2) + " (" +
             std::to_string(n_outside) + " of " + std::to_string(n_judged) +
             " errors above 1e-10 beyond a factor of 3)"
         : "") +
      (n_beyond > 0 ? "; " + std::to_string(n_beyond) +
                        " pairs are beyond the reach of the direct solver"
                    : ""));
    if (n_false > 0)
      context.log.warning(
        std::to_string(n_false) + " of the pairs of the direct checks " +
        (n_false == 1 ? "is" : "are") +
        " farther from the direct solution than Sweep/Frequency tolerance and "
        "Sigma tolerance allow, and than three times the stated error: what "
        "direct_check.csv holds is right, not the error that the sweep states");
    if (n_held > 0)
      context.log.info(
        "  at " + std::to_string(n_held) +
        " of these points, whose neighbours on the grid differ in their "
        "contact states, the direct solutions hold the state that the sweep "
        "holds: what that changes is not in the error");
    context.record.figures.emplace_back("largest true error",
                                        rounded_text(worst, 2));
    return table;
  }



  Table
  comparison_table(const SweepModel &model,
                   const SweepSolution &,
                   RunContext &context)
  {
    const SweepGrid  &grid = model.grid();
    Table             table({{"method", Type::text, "", "what is repeated"},
                             {"points", Type::integer, "", "parameter points"},
                             {"cpu_s", Type::real, "s", "for all points", 4},
                             {"measured_points",
                              Type::integer,
                              "",
                              "points that were timed; the rest is extrapolated"},
                             {"error_rel",
                              Type::real,
                              "",
                              "largest |dlambda| / |lambda| at the points timed",
                              2},
                             {"cost_ratio", Type::real, "", "over this sweep", 3}});
    const std::size_t n_points = grid.n_points();
    // What this sweep took: basis, points, tracking, edges.
    double own = model.basis_seconds();
    for (const auto &entry : context.timers.entries())
      if (entry.name == "Solve: points, branches" ||
          entry.name == "Solve: edges and peaks" ||
          entry.name.rfind("Assemble", 0) == 0 ||
          entry.name.rfind("Setup", 0) == 0)
        own += entry.own_cpu;

    // Frictionless modes at the centre, up to as many as a sweep would keep.
    const double         top    = 2. * M_PI * model.band().highest;
    const SweepPoint     centre = grid.spread(1).back();
    const double         start  = cpu_seconds();
    const Pencil         pencil(model.system().merged(), grid.scene(centre));
    const ShiftedInverse inverse(pencil, 4. * top * top);
    const UndampedModes  modes = undamped_modes(pencil, inverse);
    LocalModel           modal;
    for (const auto &term : model.system().merged().terms)
      modal.parts.push_back(inner_products(
        *pencil.space(), modes.shapes, term.matrix->multiply(modes.shapes)));
    modal.n_basis                       = modes.shapes.cols();
    double                  modal_error = 0.;
    std::vector<SweepPoint> timed;
    for (const std::size_t i : {n_points / 4, (3 * n_points) / 5})
      timed.push_back(grid.point(i));
    std::vector<ComplexPairs> modal_pairs;
    for (std::size_t i = 0; i < n_points; ++i)
      {
        const SweepPoint   point = grid.point(i);
        const ComplexPairs pairs = solve_point_in_full(
          modal, model.system().coefficients(point), model.band());
        for (const auto &t : timed)
          if (t == point)
            modal_pairs.push_back(pairs);
      }
    const double modal_cpu = cpu_seconds() - start;

    double direct_cpu = 0., own_error = 0.;
    for (std::size_t t = 0; t < timed.size(); ++t)
      {
        const ComplexPairs mine            = model.solve(timed[t]);
        const double       start_of_direct = cpu_seconds();
        const DirectPairs  direct          = direct_pairs(
          model, timed[t], grid.scene(timed[t]), model.band(), mine.lambda);
        direct_cpu += cpu_seconds() - start_of_direct;
        own_error = worst_of(own_error, largest_error(mine, direct));
        if (modal_pairs.at(t).size() > 0)
          modal_error =
            worst_of(modal_error, largest_error(modal_pairs[t], direct));
      }
    direct_cpu *= double(n_points) / timed.size();
    table.add_row({"certified sweep, basis included",
                   n_points,
                   own,
                   n_points,
                   own_error,
                   1.});
    table.add_row({"one frictionless modal basis of " +
                     std::to_string(modal.n_basis) + " modes",
                   n_points,
                   modal_cpu,
                   n_points,
                   modal_error,
                   modal_cpu / own});
    table.add_row({"direct solution of every point (extrapolated)",
                   n_points,
                   direct_cpu,
                   timed.size(),
                   0.,
                   direct_cpu / own});
    std::ostringstream text;
    table.print(text);
    context.log.heading("Beside other ways");
    context.log.info(text.str());
    return table;
  }
} // namespace squeal
