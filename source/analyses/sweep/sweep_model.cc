// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/analyses/sweep/sweep_axis_check.h>
#include <squeal/analyses/sweep/sweep_model.h>
#include <squeal/analyses/sweep/sweep_scene_check.h>
#include <squeal/base/dense_products.h>
#include <squeal/base/exceptions.h>
#include <squeal/base/memory.h>
#include <squeal/discretization/eigenvalue_error.h>
#include <squeal/model/contact_states.h>
#include <squeal/model/linear_solver.h>
#include <squeal/model/point_forces.h>
#include <squeal/output/cea_quantities.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace squeal
{
  namespace
  {
    using Complex = std::complex<double>;

    /** Under which the form of the kinetic energy of a part is kept. */
    std::string
    form_name(const BodyInertia &part)
    {
      return "energy by " + part.term.name;
    }
  } // namespace



  SweepModel::SweepModel(RunContext                    &context,
                         const std::vector<SweepScene> &scenes,
                         const std::size_t              i,
                         Block                         *vectors)
    : parameters(scenes[i].parameters)
    , sweep_grid(parameters)
    , contact_states(contact_states_of(parameters, sweep_grid, context))
    , full(parameters, context.timers, contact_states)
    , parts(full.linearized().system, sweep_grid)
    , file(basis_file(context, scenes[i].name))
  {
    for (const auto &term : parts.merged().terms)
      symmetric.push_back(term.matrix->is_symmetric());
    full.print_summary(context.log);
    check_axes_of_sweep(sweep_grid, full.linearized().system, scenes);
    if (!read(context))
      build(context, vectors);
  }

  const Parameters &
  SweepModel::run_parameters() const
  {
    return parameters;
  }
  const SceneParameters &
  SweepModel::scene() const
  {
    return parameters.scene;
  }

  const Model &
  SweepModel::model() const
  {
    return full;
  }
  const SweepGrid &
  SweepModel::grid() const
  {
    return sweep_grid;
  }
  const ParametricSystem &
  SweepModel::system() const
  {
    return parts;
  }
  const ReducedModel &
  SweepModel::reduced() const
  {
    return small;
  }
  Band
  SweepModel::band() const
  {
    return {parameters.eigen.lowest_frequency,
            parameters.eigen.highest_frequency};
  }
  bool
  SweepModel::is_reused() const
  {
    return reused;
  }
  const std::vector<BasisRound> &
  SweepModel::history() const
  {
    return rounds;
  }
  unsigned int
  SweepModel::n_factors() const
  {
    return factors;
  }
  double
  SweepModel::basis_seconds() const
  {
    return small.numbers.at("basis seconds")(0);
  }
  bool
  SweepModel::has_contact_states() const
  {
    return !contact_states.empty();
  }

  std::vector<ContactStates>
  SweepModel::contact_at(const SweepPoint &point) const
  {
    return contact_of_number(contact_states, sweep_grid.state_number(point));
  }

  unsigned int
  SweepModel::n_closed(const SweepPoint &point) const
  {
    // Pairs without states of their own are closed everywhere.
    unsigned int n = 0;
    for (const ContactStates &of_pair : contact_at(point))
      for (const ContactState &state : of_pair)
        n += state.status.size() - std::count(state.status.begin(),
                                              state.status.end(),
                                              ContactStatus::open);
    return n;
  }

  bool
  SweepModel::is_at_contact_change(const SweepPoint &point) const
  {
    const double distance =
      1e-4 * (sweep_grid.is_logarithmic(0)
                ? 1.
                : sweep_grid.upper(0) - sweep_grid.lower(0));
    SweepPoint before = point, after = point;
    before[0] -= distance;
    after[0] += distance;
    return sweep_grid.state_number(before) != sweep_grid.state_number(after);
  }

  const std::vector<bool> &
  SweepModel::symmetric_parts() const
  {
    return symmetric;
  }

  ComplexPairs
  SweepModel::solve(const SweepPoint &point, const bool with_estimates) const
  {
    return solve_point(
      small, point, parts.coefficients(point), band(), with_estimates);
  }

  bool
  SweepModel::enlarge(const SweepPoint &point)
  {
    ModelCell         &cell = small.cell_of(point);
    const unsigned int n =
      std::min(cell.local.n_basis + 4, cell.local.n_total() - 1);
    const bool grows   = n > cell.local.n_basis;
    cell.local.n_basis = n;
    return grows;
  }



  bool
  SweepModel::is_within(const WorstError &worst, const double factor) const
  {
    return worst.frequency <= factor * parameters.sweep.frequency_tolerance &&
           worst.sigma <= factor * parameters.sweep.sigma_tolerance;
  }

  bool
  SweepModel::is_certified(const ComplexPairs &pairs,
                           const SweepPoint   &point) const
  {
    WorstError own;
    add_to_worst(pairs, point, own);
    return is_within(own, 1.);
  }

  ComplexPairs
  SweepModel::solve_certified(const SweepPoint &point, WorstError &worst)
  {
    WorstError   own;
    ComplexPairs pairs;
    do
      {
        pairs = solve(point);
        own   = {};
        add_to_worst(pairs, point, own);
      }
    while (!is_within(own, 1.) && enlarge(point));
    if (!is_within(own, 1.))
      {
        std::ostringstream text;
        text << "the basis of the sweep does not reach its tolerance at "
             << text_of(sweep_grid, point) << ": error " << own.frequency
             << " of a frequency, " << own.sigma
             << " 1/s of a sigma; raise Sweep/Frequency tolerance and Sigma "
                "tolerance";
        throw ComputationError(text.str());
      }
    add_to_worst(pairs, point, worst);
    return pairs;
  }

  ComplexPairs
  SweepModel::solve_between(const SweepPoint &point) const
  {
    const ComplexPairs pairs = solve(point);
    WorstError         own;
    add_to_worst(pairs, point, own);
    return is_within(own, 100.)
             ? pairs
             : solve_point_in_cell(
                 small, point, parts.coefficients(point), band());
  }

  void
  SweepModel::build(RunContext &context, Block *vectors)
  {
    const double start = cpu_seconds();
    {
      Timers::Section section(context.timers, "Assemble: end of the axes");
      check_scene_of_sweep(
        parameters, sweep_grid, parts, contact_states, context.timers);
    }
    BasisOptions options;
    options.band                = band();
    options.frequency_tolerance = parameters.sweep.frequency_tolerance;
    options.sigma_tolerance     = parameters.sweep.sigma_tolerance;
    options.maximum_basis       = parameters.sweep.maximum_basis;
    options.factor_storage = factor_storage(parameters, *parts.merged().space);
    BasisBuilder builder(parts, options);
    {
      Timers::Section section(context.timers, "Solve: certified basis");
      small = builder.build(
        [&](const BasisRound &round) {
          context.log.info(
            "  basis " + std::to_string(round.basis_size) + ", " +
            std::to_string(round.n_factors) +
            " factors: worst estimated error " +
            rounded_text(round.worst.frequency, 2) + " of a frequency, " +
            rounded_text(round.worst.sigma, 2) + " 1/s of a sigma, at " +
            text_of(sweep_grid, round.worst.sigma_at));
        },
        vectors ? *vectors : Block());
    }
    rounds                   = builder.history();
    factors                  = builder.anchors().size();
    small.numbers["factors"] = Eigen::MatrixXd::Constant(1, 1, factors);
    add_quantities(context, builder.vectors());
    add_mesh_errors(context, builder.vectors());
    if (vectors)
      *vectors = builder.vectors();
    small.numbers["basis seconds"] =
      Eigen::MatrixXd::Constant(1, 1, cpu_seconds() - start);
    put_rounds();
    return_freed_memory();
    if (context.is_root)
      {
        Timers::Section section(context.timers, "Write: basis");
        write_reduced_model(small, fingerprint().text(), file);
      }
    context.log.info(
      "  common basis of " + std::to_string(small.n_total()) + " vectors, " +
      std::to_string(small.cells.size()) + " cells with at most " +
      std::to_string(small.largest_basis()) + "; " + std::to_string(factors) +
      " factors, " + std::to_string(builder.n_factors_on_disk()) +
      " of them on disk, whose inertia proves every mode");
  }



  void
  SweepModel::add_quantities(RunContext &context, const Block &basis)
  {
    Timers::Section section(context.timers, "Solve: energies and names");
    const auto      forms = full.energy_forms(basis);
    for (unsigned int i = 0; i < forms.size(); ++i)
      small.forms[form_name(full.inertia()[i])] = forms[i];
    const Block all = full.linearized().expand(basis);
    if (full.namer().n_coordinates() > 0)
      small.functionals["names"] = full.namer().coordinates(all);
    for (unsigned int i = 0; i < full.linearized().contacts.size(); ++i)
      {
        const ContactMotion motion = contact_motion(full, i);
        const std::string   number = std::to_string(i);
        small.functionals["source sliding " + number] =
          motion.tangential_source->apply(all);
        small.functionals["target normal " + number] =
          motion.normal_target->apply(all);
      }
  }

  void
  SweepModel::add_mesh_errors(RunContext &context, const Block &basis)
  {
    if (!full.discretization() || !full.discretization()->has_mesh() ||
        !parameters.discretization.estimate_error)
      return;
    Timers::Section section(context.timers, "Solve: discretisation error");
    // Those of the scene as it stands in the file; what a pair at another
    // point is made of tells its error.
    const double       top = 2. * M_PI * parameters.eigen.highest_frequency;
    const ReducedModes modes =
      reduced_modes(small.parts,
                    parts.coefficients(parameters.scene),
                    symmetric,
                    1.2 * top * top);
    Eigen::Index n = 0;
    while (n < modes.omega_squared.size() &&
           modes.omega_squared[n] < 1.2 * top * top)
      ++n;
    const Block full_shapes =
      full.linearized().expand(Block(basis * modes.shapes.leftCols(n)));
    const ModeErrors errors = estimate_mode_errors(
      *full.discretization(),
      full_shapes,
      modes.omega_squared.head(n),
      undamped_forces(full, full_shapes, modes.omega_squared.head(n)));
    small.numbers["mesh modes"]  = modes.shapes.leftCols(n);
    small.numbers["mesh errors"] = errors.frequency;
  }



  Eigen::MatrixXd
  SweepModel::energy_shares(const SweepPoint       &point,
                            const Eigen::MatrixXcd &vectors) const
  {
    const SceneParameters &scene = sweep_grid.scene(point);
    Eigen::MatrixXd        shares =
      Eigen::MatrixXd::Zero(full.body_names().size(), vectors.cols());
    for (const auto &part : full.inertia())
      shares.row(part.body) +=
        part.term.coefficients(scene).mass *
        vectors.conjugate()
          .cwiseProduct(times(small.forms.at(form_name(part)), vectors))
          .real()
          .colwise()
          .sum();
    for (Eigen::Index j = 0; j < shares.cols(); ++j)
      shares.col(j) /= std::max(shares.col(j).sum(), 1e-300);
    return shares;
  }

  std::vector<ModeName>
  SweepModel::names(const Eigen::MatrixXcd &vectors,
                    const Eigen::MatrixXd  &shares,
                    const Eigen::VectorXcd &eigenvalues) const
  {
    const auto rows = small.functionals.find("names");
    if (rows == small.functionals.end())
      {
        std::vector<ModeName> result(vectors.cols());
        for (std::size_t i = 0; i < result.size(); ++i)
          {
            result[i].text         = "mode " + std::to_string(i + 1);
            result[i].alternatives = {result[i].text};
          }
        return result;
      }
    return full.namer().name_coordinates(
      times(rows->second, vectors), shares, eigenvalues);
  }



  SweepModel::Modes
  SweepModel::undamped(const SweepPoint &point) const
  {
    Modes        result;
    const double top = 2. * M_PI * parameters.eigen.highest_frequency;
    // What friction makes of the modes is in V, hence they are too.
    const ModelCell   &cell = small.cell_of(point);
    const unsigned int n_V  = cell.local.n_basis;
    // A part of the box where nothing moves in the band.
    if (n_V == 0)
      return result;
    std::vector<Eigen::MatrixXd> leading;
    for (const auto &part : cell.local.parts)
      leading.push_back(part.topLeftCorner(n_V, n_V));
    result.modes = reduced_modes(
      leading, parts.coefficients(point), symmetric, 1.2 * top * top);
    result.modes.shapes = cell.turn.leftCols(n_V) * result.modes.shapes;
    const Eigen::MatrixXcd vectors = result.modes.shapes.cast<Complex>();
    result.names                   = names(vectors,
                         energy_shares(point, vectors),
                         Complex(0., 1.) *
                           result.modes.omega_squared.cwiseMax(0.).cwiseSqrt());
    const Eigen::Index n           = result.modes.omega_squared.size();
    result.mesh_errors.assign(n, std::nan(""));
    const auto known = small.numbers.find("mesh modes");
    if (known == small.numbers.end())
      return result;
    const Eigen::MatrixXd mac =
      (known->second.transpose() * result.modes.shapes).cwiseAbs2();
    const auto &errors = small.numbers.at("mesh errors");
    for (Eigen::Index j = 0; j < n; ++j)
      if (const double weight = mac.col(j).sum(); weight > 0.5)
        result.mesh_errors[j] = mac.col(j).dot(errors.col(0)) / weight;
    return result;
  }
} // namespace squeal
