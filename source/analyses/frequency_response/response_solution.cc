// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/analyses/frequency_response/response_solution.h>
#include <squeal/base/exceptions.h>
#include <squeal/base/memory.h>
#include <squeal/base/worst_of.h>
#include <squeal/eigen/modal_response.h>
#include <squeal/model/cea_solution.h>
#include <squeal/output/record_unknowns.h>

#include <algorithm>
#include <cmath>

namespace squeal
{
  namespace
  {
    std::vector<unsigned int>
    places(const MeasurementParameters    &m,
           const std::vector<std::string> &names)
    {
      std::vector<unsigned int> result;
      for (const auto &name : names)
        result.push_back(m.find(name));
      if (names.empty())
        for (unsigned int i = 0; i < m.points.size(); ++i)
          result.push_back(i);
      return result;
    }

    /** Of an eigenvalue, what the solver and rounding leave of a growth rate
     * that is 0. */
    constexpr double no_damping = 1e-10;

    /** Refuses frequencies, of the grid or of the checks, at which a mode
     * without damping answers without bound. */
    void
    refuse_resonances(const StateResponse       &state,
                      const std::vector<double> &frequencies,
                      const std::string         &entries)
    {
      for (unsigned int k = 0; k < state.pairs.size(); ++k)
        for (const double f : frequencies)
          if (const double own = state.pairs.frequency(k);
              state.is_undamped(k) && std::abs(f - own) <= no_damping * own)
            throw InputError(
              entries + ": " + rounded_text(f, 8) +
              " Hz is the frequency of mode " + state.names[k].text +
              ", which has no damping, so that the response there has no "
              "bound: give the scene damping or change these entries");
    }

    /** Checked frequencies: in the middles of equal parts of the band. */
    std::vector<double>
    checked_frequencies(const ResponseGrid &grid, const unsigned int n)
    {
      const double first = grid.frequencies.front(),
                   last  = grid.frequencies.back();
      std::vector<double> result;
      for (unsigned int i = 0; i < n; ++i)
        {
          const double s = (i + 0.5) / n;
          result.push_back(grid.is_even ? first + s * (last - first)
                                        : first * std::pow(last / first, s));
        }
      return result;
    }
  } // namespace



  ResponseGrid::ResponseGrid(const Parameters &p)
    : excitations(places(p.measurement, p.frequency_response.excitations))
    , responses(places(p.measurement, p.frequency_response.responses))
    , is_even(p.frequency_response.scale ==
              FrequencyResponseParameters::Scale::linear)
  {
    using Quantity     = FrequencyResponseParameters::Quantity;
    const auto  &f     = p.frequency_response;
    const double first = p.eigen.lowest_frequency,
                 last  = p.eigen.highest_frequency;
    for (unsigned int i = 0; i < f.number; ++i)
      {
        const double s = double(i) / (f.number - 1);
        frequencies.push_back(is_even ? first + s * (last - first)
                                      : first * std::pow(last / first, s));
      }
    power    = f.quantity == Quantity::receptance ? 0
               : f.quantity == Quantity::mobility ? 1
                                                  : 2;
    quantity = power == 0   ? "receptance"
               : power == 1 ? "mobility"
                            : "accelerance";
    unit     = power == 0 ? "m/N" : power == 1 ? "m/(N s)" : "m/(N s^2)";
  }

  std::complex<double>
  ResponseGrid::factor(const double frequency) const
  {
    const double omega = 2. * M_PI * frequency;
    return power == 0   ? std::complex<double>(1.)
           : power == 1 ? std::complex<double>(0., omega)
                        : std::complex<double>(-omega * omega);
  }

  double
  ResponseCheck::error() const
  {
    return worst_of((superposed - exact).cwiseAbs()) /
           worst_of(exact.cwiseAbs());
  }

  double
  StateResponse::worst_check() const
  {
    double worst = 0.;
    for (const auto &check : checks)
      worst = worst_of(worst, check.error());
    return worst;
  }

  Eigen::MatrixXd
  StateResponse::size_of_functions() const
  {
    constexpr double rounding = 1e-10;
    if (checks.empty())
      return {};
    Eigen::MatrixXd size = Eigen::MatrixXd::Zero(checks.front().exact.rows(),
                                                 checks.front().exact.cols());
    for (const ResponseCheck &check : checks)
      size += check.exact.cwiseAbs2();
    size                  = (size / checks.size()).cwiseSqrt();
    const double smallest = rounding * worst_of(size);
    return size.unaryExpr(
      [=](const double s) { return s > smallest ? s : std::nan(""); });
  }

  StateResponse::WorstFunction
  StateResponse::worst_function() const
  {
    const Eigen::MatrixXd size = size_of_functions();
    WorstFunction         worst;
    for (const ResponseCheck &check : checks)
      for (Eigen::Index j = 0; j < size.cols(); ++j)
        for (Eigen::Index i = 0; i < size.rows(); ++i)
          if (const double difference =
                std::abs(check.superposed(i, j) - check.exact(i, j));
              // What is no number is the worst there is.
              size(i, j) > 0. && !std::isnan(worst.error) &&
              !(difference / size(i, j) <= worst.error))
            worst = {difference / size(i, j), i, j};
    return worst;
  }

  double
  StateResponse::worst_value() const
  {
    const Eigen::MatrixXd size  = size_of_functions();
    double                worst = 0.;
    for (const ResponseCheck &check : checks)
      for (Eigen::Index j = 0; j < size.cols(); ++j)
        for (Eigen::Index i = 0; i < size.rows(); ++i)
          if (size(i, j) > 0. && check.exact(i, j) != 0.)
            worst = worst_of(
              worst, std::abs(check.superposed(i, j) / check.exact(i, j) - 1.));
    return worst;
  }

  bool
  StateResponse::is_undamped(const unsigned int k) const
  {
    return std::abs(pairs.sigma(k)) <= no_damping * std::abs(pairs.lambda[k]);
  }

  std::string
  StateResponse::unstable() const
  {
    std::string text;
    for (unsigned int i = 0; i < pairs.size(); ++i)
      if (is_unstable(pairs, i))
        text += (text.empty() ? "" : ", ") + names[i].text + " at " +
                rounded_text(pairs.frequency(i), 5) + " Hz";
    return text;
  }



  StateResponse
  solve_response(const Parameters                 &parameters,
                 const std::string                &state,
                 const ResponseGrid               &grid,
                 const std::vector<MeasuredShape> &measured,
                 RunContext                       &context)
  {
    using Residual = FrequencyResponseParameters::Residual;
    const auto &f  = parameters.frequency_response;
    context.log.heading("Contact state: " + state);
    Parameters p             = parameters;
    p.eigen.lowest_frequency = 0.; // slow modes move the whole band
    p.eigen.highest_frequency *= f.margin;
    p.eigen.solver = EigenParameters::Solver::certified;
    Model        model(p, context.timers);
    ModeSolution modes =
      solve_modes_adaptively(model, context.log, context.timers);
    if (const std::string free = free_motions(model, modes); !free.empty())
      throw InputError(free +
                       ": responses are superposed of modes from 0 Hz on, "
                       "wherever the band begins, and there free motions have "
                       "no bounded one: hold them by Scene/Supports, or by "
                       "Scene/Springs so soft that the band does not feel "
                       "them");
    const CeaSolution solution =
      solve_cea(model, modes, context.log, context.timers);
    warn_of_growth_left_out(
      solution, "contact state " + state + ": ", context.log);

    StateResponse result;
    result.state      = state;
    result.n_unknowns = model.n_unknowns();
    if (context.record.n_dofs == 0)
      record_unknowns(model, context.record);
    result.has_loss_factors = modes.pencil->has_structural_damping();
    result.names = pair_quantities(model, modes, solution.pairs).names;
    const MeasuredPoints points(model);
    const Block          forces       = points.vectors(grid.excitations);
    const Block          observations = points.vectors(grid.responses);
    ModalResponse response(*modes.pencil, solution.pairs, forces, observations);
    result.pairs  = solution.pairs;
    result.shapes = points.sample(solution.pairs.right);
    result.pairs.right.resize(0, 0);
    result.pairs.left.resize(0, 0);
    modes.inverse.reset();
    return_freed_memory();
    const auto checked = checked_frequencies(grid, f.checks);
    refuse_resonances(result,
                      grid.frequencies,
                      "Eigenvalues/Lowest frequency, Highest frequency and "
                      "Frequency response/Number");
    refuse_resonances(result, checked, "Frequency response/Checks");

    const DirectResponse direct(*modes.pencil, forces, observations);
    if (f.residual != Residual::none)
      {
        Timers::Section section(context.timers, "Solve: residual terms");
        response.set_flexibility(direct.solve(0.));
        if (f.residual == Residual::flexibility_and_inertia)
          {
            const double top = 2. * M_PI * grid.frequencies.back();
            response.set_inertia(top, direct.solve(top));
          }
      }
    {
      Timers::Section section(context.timers, "Solve: superposition");
      for (const double frequency : grid.frequencies)
        result.values.push_back(grid.factor(frequency) *
                                response.receptance(2. * M_PI * frequency));
    }
    for (unsigned int j = 0; j < grid.excitations.size(); ++j)
      {
        Eigen::MatrixXcd residues(grid.responses.size(), result.pairs.size());
        for (unsigned int i = 0; i < grid.responses.size(); ++i)
          residues.row(i) = response.residues(i, j).transpose();
        result.residues.push_back(residues);
      }
    for (const double frequency : checked)
      {
        Timers::Section section(context.timers, "Solve: direct check");
        const double    omega             = 2. * M_PI * frequency;
        const std::complex<double> factor = grid.factor(frequency);
        result.checks.push_back({frequency,
                                 factor * direct.solve(omega),
                                 factor * response.receptance(omega)});
      }
    if (!measured.empty())
      {
        result.mac   = points.mac(measured, result.shapes);
        result.comac = points.comac(measured, result.shapes, result.mac);
      }

    context.log.info(
      "  " + std::to_string(result.pairs.size()) + " modes up to " +
      rounded_text(p.eigen.highest_frequency, 6) + " Hz superposed");
    if (!result.checks.empty())
      context.log.info("  largest difference to direct solutions at " +
                       std::to_string(result.checks.size()) + " frequencies: " +
                       rounded_text(result.worst_check(), 2) +
                       " of the largest response there");
    return result;
  }
} // namespace squeal
