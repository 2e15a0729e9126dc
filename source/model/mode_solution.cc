// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/base/memory.h>
#include <squeal/base/run_log.h>
#include <squeal/base/timers.h>
#include <squeal/base/worst_of.h>
#include <squeal/discretization/eigenvalue_error.h>
#include <squeal/discretization/even_faces.h>
#include <squeal/eigen/dense_quadratic.h>
#include <squeal/eigen/free_motion.h>
#include <squeal/model/finer_modes.h>
#include <squeal/model/linear_solver.h>
#include <squeal/model/mode_solution.h>
#include <squeal/model/point_forces.h>
#include <squeal/model/turning_modes.h>

#include <deal.II/distributed/tria.h>

#include <cmath>
#include <limits>

namespace squeal
{
  namespace
  {
    /** Squared contributions that the refined cells of a step hold. */
    constexpr double refined_share_of_modes = 0.7;

    constexpr double not_known = std::numeric_limits<double>::quiet_NaN();

    double
    shift_of(const Parameters &parameters)
    {
      const double omega = 2. * M_PI * parameters.eigen.highest_frequency;
      return omega * omega;
    }
  } // namespace



  unsigned int
  ModeSolution::n_up_to(const double highest) const
  {
    unsigned int n = 0;
    while (n < modes.omega_squared.size() &&
           is_between(modes.frequency(n), 0., highest))
      ++n;
    return n;
  }



  namespace
  {
    /** Factorises at @p shift and finds all modes below it. */
    void
    find_modes(const Parameters &parameters,
               const double      shift,
               ModeSolution     &solution,
               RunLog           &log,
               Timers           &timers)
    {
      {
        Timers::Section section(timers, "Solve: factorisation");
        solution.inverse.reset();
        solution.inverse = std::make_unique<ShiftedInverse>(
          *solution.pencil,
          shift,
          factor_storage(parameters, *solution.pencil->space()));
        return_freed_memory();
      }
      if (solution.inverse->place() == FactorPlace::disk)
        log.info("  " + linear_solver_text(*solution.inverse) +
                 "; results are the same but for rounding");
      log.info("  " + std::to_string(solution.inverse->n_modes_below()) +
               " modes below " +
               rounded_text(std::sqrt(shift) / (2. * M_PI), 6) +
               " Hz by the inertia of the factor");
      Timers::Section section(timers, "Solve: undamped modes");
      ModeOptions     options;
      options.tolerance = parameters.eigen.mode_tolerance;
      solution.modes =
        undamped_modes(*solution.pencil, *solution.inverse, options);
      return_freed_memory();
    }

    /** More modes than those of the band, as long as turning carries further
     * ones into it. */
    void
    find_modes_carried_into_band(const Model  &model,
                                 ModeSolution &solution,
                                 RunLog       &log,
                                 Timers       &timers)
    {
      const double highest = std::sqrt(shift_of(model.parameters()));
      for (unsigned int pass = 0; pass < 8; ++pass)
        {
          const double limit =
            limit_of_turning_modes(model, solution.modes, highest);
          if (limit <= 1.001 * solution.inverse->shift())
            return;
          find_modes(model.parameters(), limit, solution, log, timers);
        }
      log.warning("turning may carry motions into the band that are not among "
                  "the modes: lower Rotation speed or raise Eigenvalues/"
                  "Highest frequency");
    }
  } // namespace



  ModeSolution
  solve_modes(const Model &model, RunLog &log, Timers &timers)
  {
    const Parameters &parameters = model.parameters();
    ModeSolution      solution;
    solution.pencil =
      std::make_unique<Pencil>(model.linearized().system, parameters.scene);
    find_modes(parameters, shift_of(parameters), solution, log, timers);
    if (has_turning_body(parameters.scene))
      find_modes_carried_into_band(model, solution, log, timers);
    Timers::Section     section(timers, "Solve: names and energies");
    std::vector<double> frequencies;
    for (unsigned int i = 0; i < solution.modes.omega_squared.size(); ++i)
      frequencies.push_back(solution.modes.frequency(i));
    // Names look at the displacements of all unknowns, dependent ones too.
    if (model.discretization() && model.linearized().contacts.empty() &&
        model.n_unknowns() == model.discretization()->space()->n_global())
      {
        auto &modes = solution.modes;
        modes.shapes =
          model.namer().separate_multiple(modes.shapes, frequencies);
        const Eigen::Index n = modes.shapes.cols();
        modes.mass_products.leftCols(n) =
          solution.pencil->multiply_mass(modes.shapes);
        modes.stiffness_products.leftCols(n) =
          solution.pencil->multiply_undamped_stiffness(modes.shapes);
      }
    solution.energy_shares = model.energy_shares(solution.modes.shapes);
    // The eigenvalue of an undamped mode is i omega.
    solution.names = model.namer().name(
      model.linearized().expand(solution.modes.shapes),
      solution.energy_shares,
      std::complex<double>(0., 1.) *
        solution.modes.omega_squared.cwiseMax(0.).cwiseSqrt());
    solution.discretisation_error.assign(frequencies.size(), not_known);
    return solution;
  }



  ModeSolution
  solve_modes_adaptively(Model  &model,
                         RunLog &log,
                         Timers &timers,
                         Table  *steps)
  {
    const auto &parameters = model.parameters();
    const auto &p          = parameters.discretization;
    const bool  adaptive =
      p.refinement == DiscretizationParameters::Refinement::eigenvalue_error;
    for (unsigned int cycle = 0;; ++cycle)
      {
        ModeSolution solution = solve_modes(model, log, timers);
        if (!model.discretization() || !model.discretization()->has_mesh() ||
            !(adaptive || p.estimate_error))
          return solution;

        const unsigned int n =
          solution.n_up_to(parameters.eigen.highest_frequency);
        ModeErrors errors;
        {
          Timers::Section section(timers, "Solve: discretisation error");
          const Block     full =
            model.linearized().expand(Block(solution.modes.shapes.leftCols(n)));
          errors = estimate_mode_errors(
            *model.discretization(),
            full,
            solution.modes.omega_squared.head(n),
            undamped_forces(model, full, solution.modes.omega_squared.head(n)));
        }
        const auto locking = nearly_incompressible_bodies(parameters.scene);
        if (!locking.empty())
          {
            errors.frequency =
              errors_by_next_degree(model,
                                    solution.modes.omega_squared.head(n),
                                    shift_of(parameters),
                                    timers);
            log.info("  " + locking.front() +
                     " hardly changes its volume: errors of all modes are "
                     "those against one degree more");
          }
        double worst = 0.;
        for (unsigned int i = 0; i < n; ++i)
          {
            solution.discretisation_error[i] = errors.frequency[i];
            if (solution.modes.frequency(i) >=
                parameters.eigen.lowest_frequency)
              worst = worst_of(worst, solution.discretisation_error[i]);
          }
        log.info("  mesh " + std::to_string(cycle) + ": " +
                 std::to_string(model.n_unknowns()) +
                 " unknowns, estimated relative frequency error at most " +
                 rounded_text(worst, 3));
        if (steps)
          steps->add_row(
            {cycle, model.n_unknowns(), worst, timers.total_cpu()});
        if (!adaptive || worst <= p.tolerance)
          return solution;
        if (cycle + 1 >= p.maximum_cycles ||
            model.n_unknowns() >= p.maximum_dofs)
          {
            log.warning("the mesh was not refined to the asked tolerance: "
                        "raise Discretization/Maximum dofs or Maximum cycles");
            return solution;
          }
        {
          Timers::Section section(timers, "Setup: refinement");
          model.discretization()->refine(errors.cell,
                                         refined_share_of_modes,
                                         even_faces(*model.discretization()));
        }
        model.assemble(timers);
      }
  }



  void
  refuse_empty_band(const Parameters &parameters, const ModeSolution &solution)
  {
    const auto  &p       = parameters.eigen;
    double       nearest = std::numeric_limits<double>::infinity();
    const double centre  = 0.5 * (p.lowest_frequency + p.highest_frequency);
    for (unsigned int i = 0; i < solution.modes.omega_squared.size(); ++i)
      if (const double f = solution.modes.frequency(i);
          std::abs(f - centre) < std::abs(nearest - centre))
        nearest = f;
    // Motions whose frequencies contact and friction take away: real
    // eigenvalues, or stiffnesses too many orders apart for the reduced model.
    if (is_between(nearest, p.lowest_frequency, p.highest_frequency))
      throw InputError(
        "Eigenvalues/Lowest frequency and Highest frequency: of the modes in "
        "the band, as that at " +
        rounded_text(nearest, 6) +
        " Hz, friction and damping leave no eigenvalue there: look whether a "
        "stiffness of Scene is too large, or widen the band");
    throw InputError(
      "Eigenvalues/Lowest frequency and Highest frequency: the band from " +
      rounded_text(p.lowest_frequency, 6) + " to " +
      rounded_text(p.highest_frequency, 6) + " Hz holds no modes; " +
      (std::isfinite(nearest)
         ? "the one next to it is at " + rounded_text(nearest, 6) + " Hz"
         : "raise Highest frequency"));
  }



  std::string
  free_motions(const Model &model, const ModeSolution &solution)
  {
    const bool is_read =
      model.parameters().scene.kind == SceneParameters::Kind::matrices;
    FreeMotions free = find_free_motions(
      *solution.pencil,
      solution.modes,
      solution.inverse->shift(),
      is_read ? rounding_of_read_stiffness : rounding_of_computed_stiffness);
    // Of turning bodies elastic motions may have lost their stiffness too.
    if (free.shapes.cols() > 0 && has_turning_body(model.parameters().scene))
      free = free_motions_at_rest(model, solution.inverse->shift());
    if (free.shapes.cols() == 0)
      return "";
    // The sum over all of them does not depend on how they are combined.
    const Eigen::VectorXd shares =
      model.energy_shares(free.shapes).rowwise().sum();
    std::string bodies;
    for (Eigen::Index b = 0; b < shares.size(); ++b)
      if (shares[b] > 1e-3)
        bodies += (bodies.empty() ? "" : ", ") + model.body_names()[b];
    return free.text(", of the bodies " + bodies);
  }



  Table
  mode_table(const Model &model, const ModeSolution &solution)
  {
    using Type = Table::Type;
    Table table({{"index", Type::integer, "", "number of the mode, from 1"},
                 {"frequency_hz", Type::real, "Hz", "natural frequency", 7},
                 {"name", Type::text, "", "(nodal circles, nodal diameters)"},
                 {"nodal_circles", Type::integer, "", "of the disc"},
                 {"nodal_diameters", Type::integer, "", "of the disc"},
                 {"parity", Type::text, "", "+ antinode, - node at the pad"}});
    for (const auto &body : model.body_names())
      table.add_column({"ke_share_" + body,
                        Type::real,
                        "",
                        "share of the kinetic energy in " + body,
                        3});
    table.add_column({"error_estimate_rel",
                      Type::real,
                      "",
                      "estimated relative frequency error of the mesh",
                      2});
    table.add_column({"family", Type::text, "", "kind of motion"});
    table.add_column(
      {"residual_rel", Type::real, "", "relative residual of the pair", 2});
    const auto  &p      = model.parameters().eigen;
    unsigned int number = 0;
    for (unsigned int i = 0; i < solution.n_up_to(p.highest_frequency); ++i)
      {
        if (!is_between(solution.modes.frequency(i),
                        p.lowest_frequency,
                        p.highest_frequency))
          continue;
        const ModeName &name = solution.names[i];
        // A near tie may leave them open.
        const auto count = [](const int n) { return n < 0 ? Cell() : Cell(n); };
        std::vector<Cell> row{++number,
                              solution.modes.frequency(i),
                              name.text,
                              count(name.nodal_circles),
                              count(name.nodal_diameters),
                              name.parity};
        for (Eigen::Index b = 0; b < solution.energy_shares.rows(); ++b)
          row.emplace_back(solution.energy_shares(b, i));
        row.emplace_back(or_missing(solution.discretisation_error[i]));
        row.emplace_back(name.family);
        row.emplace_back(solution.modes.residual[i]);
        table.add_row(row);
      }
    return table;
  }
} // namespace squeal
