// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/analyses/updating/updating_model.h>
#include <squeal/base/assignment.h>
#include <squeal/base/exceptions.h>
#include <squeal/base/memory.h>
#include <squeal/model/cea_solution.h>
#include <squeal/output/cea_quantities.h>
#include <squeal/parameters/names.h>
#include <squeal/parameters/text.h>
#include <squeal/sweep/parametric_system.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace squeal
{
  namespace
  {
    using Complex = std::complex<double>;

    /** Modes may leave the band by this while the numbers change. */
    constexpr double band_margin = 1.25;

    /** Relative step of the coefficients' differences; they are polynomials of
     * the second degree, so that it causes no error. */
    constexpr double step = 1e-2;

    constexpr double no_partner = 1e6;

    /** A measured frequency may lie outside the band by this factor; no mode
     * of the band can be fitted to one further away. */
    constexpr double furthest = 2.;

    std::vector<TermCoefficients>
    coefficients(const AffineSystem &system, const SceneParameters &scene)
    {
      std::vector<TermCoefficients> result;
      for (const auto &term : system.terms)
        result.push_back(term.coefficients(scene));
      return result;
    }

    /** Refuses frequencies that no mode of the band can have, such as kHz. */
    void
    refuse_far_frequencies(const std::vector<MeasuredFrequency> &data,
                           const EigenParameters                &band,
                           const std::string                    &path)
    {
      for (std::size_t i = 0; i < data.size(); ++i)
        if (const double f = data[i].frequency;
            f * furthest < band.lowest_frequency ||
            f > furthest * band.highest_frequency)
          throw InputError(path + ":" + std::to_string(i + 2) +
                           ": frequency_hz = " + rounded_text(f, 6) +
                           " Hz lies outside the band of section Eigenvalues, "
                           "from " +
                           rounded_text(band.lowest_frequency, 6) + " to " +
                           rounded_text(band.highest_frequency, 6) +
                           " Hz, by more than a factor of 2: give it in Hz, "
                           "widen the band, or remove the row");
    }

    /** Refuses entries that change no matrix, alone or along with others. */
    void
    require_effects(const AffineSystem                     &system,
                    const UpdatingParameters               &updating,
                    const std::vector<std::vector<double>> &starts,
                    NumberSetter                           &setter)
    {
      std::vector<double> values;
      for (const auto &entries : starts)
        values.insert(values.end(), entries.begin(), entries.end());
      const SceneParameters start = setter.scene(values);
      std::size_t           i     = 0;
      for (const auto &number : updating.numbers)
        for (const auto &path : number.entries)
          {
            std::vector<double> moved = values;
            moved[i++] *= 1. + step;
            if (!change_matrices(system, start, setter.scene(moved)))
              throw InputError("'Updating/Number " + number.name +
                               "/Entries' contains '" + path +
                               "', but neither mass nor damping nor stiffness "
                               "of the scene changes with it: remove it");
          }
    }

    /** Pairing by shape needs one shape for every frequency: which of two is
     * meant by a name that both have cannot be told. */
    void
    refuse_equal_names(const std::vector<MeasuredFrequency> &data,
                       const std::string                    &path)
    {
      std::set<std::string> seen;
      for (std::size_t i = 0; i < data.size(); ++i)
        if (!seen.insert(data[i].name).second)
          throw InputError(path + ":" + std::to_string(i + 2) + ": name '" +
                           data[i].name +
                           "' is there twice: with 'Updating/Pairing = shape' "
                           "every frequency needs the name of a shape of its "
                           "own");
    }

    /** The measured shape of each frequency, found by its name. */
    std::vector<MeasuredShape>
    shapes_of(const std::vector<MeasuredFrequency> &data,
              const MeasurementParameters          &m,
              RunLog                               &log)
    {
      refuse_equal_names(data, m.frequencies_file);
      const std::vector<MeasuredShape> all = read_measured_shapes(m, log);
      std::vector<std::string>         names;
      for (const auto &shape : all)
        names.push_back(shape.name);
      std::vector<MeasuredShape> result;
      for (const auto &frequency : data)
        {
          const std::string &name = frequency.name;
          const auto         n = std::count(names.begin(), names.end(), name);
          if (n == 0)
            throw InputError(m.shapes_file + ": has no shape called '" + name +
                             "', which the frequencies name" +
                             prm::did_you_mean(name, names));
          if (n > 1)
            throw InputError(m.shapes_file + ": has " + std::to_string(n) +
                             " shapes called '" + name +
                             "', which the frequencies name: give each a name "
                             "(dataset 55: a title) of its own");
          result.push_back(
            all[std::find(names.begin(), names.end(), name) - names.begin()]);
        }
      return result;
    }

    ComplexBlock
    times(const LinearOperator &A, const ComplexBlock &X)
    {
      ComplexBlock result(X.rows(), X.cols());
      result.real() = A.multiply(X.real());
      result.imag() = A.multiply(X.imag());
      return result;
    }

  } // namespace



  std::vector<MeasuredFrequency>
  read_measured_frequencies(const std::string &path)
  {
    using Type                           = Table::Type;
    const Table                    table = read_csv(path,
                                 {{"name", Type::text, "", ""},
                                                     {"frequency_hz", Type::real, "Hz", ""},
                                                     {"weight", Type::real, "", ""}});
    std::vector<MeasuredFrequency> result;
    for (std::size_t r = 0; r < table.n_rows(); ++r)
      {
        const MeasuredFrequency m{table.text(r, "name"),
                                  table.real(r, "frequency_hz"),
                                  table.real(r, "weight")};
        for (const auto &[column, value] :
             {std::make_pair("frequency_hz", m.frequency),
              std::make_pair("weight", m.weight)})
          if (!(value > 0.))
            throw InputError(path + ":" + std::to_string(r + 2) + ": " +
                             column + " must be a number above 0");
        result.push_back(m);
      }
    if (result.empty())
      throw InputError(path + ": has no measured frequency");
    return result;
  }



  double
  UpdatingEvaluation::objective() const
  {
    return 0.5 * residuals.squaredNorm();
  }



  UpdatingModel::UpdatingModel(RunContext &context)
    : context(context)
    , current(context.parameters)
    , data(read_measured_frequencies(
        context.parameters.measurement.frequencies_file))
  {
    const auto &u = context.parameters.updating;
    const auto &m = context.parameters.measurement;
    if (data.size() < u.numbers.size())
      throw InputError(m.frequencies_file + ": " + std::to_string(data.size()) +
                       " frequencies cannot determine the " +
                       std::to_string(u.numbers.size()) +
                       " numbers of Updating/Numbers");
    refuse_far_frequencies(data, context.parameters.eigen, m.frequencies_file);
    if (u.pairing == UpdatingParameters::Pairing::shape)
      shapes = shapes_of(data, m, context.log);
    std::vector<std::string> paths;
    for (const auto &number : u.numbers)
      {
        starts.emplace_back();
        for (const auto &path : number.entries)
          {
            require_affine("Updating/Number " + number.name + "/Entries", path);
            paths.push_back(path);
            starts.back().push_back(get_number(context.parameters, path));
          }
      }
    setter = std::make_unique<NumberSetter>(context.parameters, paths);
    current.eigen.lowest_frequency /= band_margin;
    current.eigen.highest_frequency *= band_margin;
    current.eigen.solver = EigenParameters::Solver::certified;
    full                 = std::make_unique<Model>(current, context.timers);
    full->print_summary(context.log);
    require_effects(full->linearized().system, u, starts, *setter);
    if (current.discretization.refinement ==
        DiscretizationParameters::Refinement::eigenvalue_error)
      solve_modes_adaptively(*full, context.log, context.timers);
    if (u.pairing == UpdatingParameters::Pairing::shape)
      points = std::make_unique<MeasuredPoints>(*full);
  }

  unsigned int
  UpdatingModel::n_numbers() const
  {
    return starts.size();
  }
  const std::vector<MeasuredFrequency> &
  UpdatingModel::measured() const
  {
    return data;
  }
  const Model &
  UpdatingModel::model() const
  {
    return *full;
  }
  double
  UpdatingModel::start_value(const unsigned int number,
                             const unsigned int entry) const
  {
    return starts[number][entry];
  }
  double
  UpdatingModel::lower(const unsigned int number) const
  {
    return std::log(context.parameters.updating.numbers[number].lower /
                    starts[number][0]);
  }
  double
  UpdatingModel::upper(const unsigned int number) const
  {
    return std::log(context.parameters.updating.numbers[number].upper /
                    starts[number][0]);
  }



  const SceneParameters &
  UpdatingModel::scene(const Eigen::VectorXd &logarithms)
  {
    std::vector<double> values;
    for (unsigned int n = 0; n < starts.size(); ++n)
      for (const double start : starts[n])
        values.push_back(start * std::exp(logarithms[n]));
    return setter->scene(values);
  }



  std::vector<int>
  UpdatingModel::first_pairing(const ComplexPairs             &pairs,
                               const std::vector<std::string> &names) const
  {
    std::vector<std::vector<double>> costs(
      data.size(), std::vector<double>(pairs.size(), no_partner));
    Eigen::MatrixXd values;
    if (points)
      values = points->mac(shapes, points->sample(pairs.right));
    for (std::size_t i = 0; i < data.size(); ++i)
      for (unsigned int k = 0; k < pairs.size(); ++k)
        if (points)
          costs[i][k] = 1. - values(i, k);
        else if (data[i].name.empty() || is_called(names[k], data[i].name))
          costs[i][k] =
            std::abs(std::log(pairs.frequency(k) / data[i].frequency));
    const std::vector<int> partner = smallest_assignment(costs);
    for (std::size_t i = 0; i < data.size(); ++i)
      {
        if (partner[i] >= 0 && costs[i][partner[i]] < no_partner)
          continue;
        std::string known;
        for (unsigned int k = 0; k < pairs.size(); ++k)
          known += (k ? "; " : "") + names[k] + " at " +
                   rounded_text(pairs.frequency(k), 4) + " Hz";
        throw InputError(context.parameters.measurement.frequencies_file +
                         ": no mode of the band is called '" + data[i].name +
                         "' or is left for it; there are " + known);
      }
    return partner;
  }

  Eigen::VectorXd
  UpdatingModel::mac_of(const ComplexPairs &pairs) const
  {
    return points
             ? Eigen::VectorXd(
                 points->mac(shapes, points->sample(pairs.right)).diagonal())
             : Eigen::VectorXd();
  }

  void
  UpdatingModel::warn_of_first(const UpdatingEvaluation &first) const
  {
    const double minimum = context.parameters.updating.minimum_mac;
    for (Eigen::Index i = 0; i < first.mac_measured.size(); ++i)
      if (!(first.mac_measured[i] >= minimum))
        context.log.warning(
          "at the start the measured shape '" + data[i].name + "' (" +
          rounded_text(data[i].frequency, 5) + " Hz) is paired with " +
          first.names[i] + " at " + rounded_text(first.frequencies[i], 5) +
          " Hz, which is like it with a MAC of " +
          rounded_text(first.mac_measured[i], 2) +
          " only, below 'Updating/Minimum MAC': where they are not the same "
          "mode, it pulls the numbers away from their values");
  }

  std::vector<int>
  UpdatingModel::next_pairing(const Pencil       &pencil,
                              const ComplexPairs &pairs,
                              Eigen::VectorXd    &mac) const
  {
    const RowSpace &space = *pencil.space();
    const auto      mass  = [&](const ComplexBlock &X) {
      ComplexBlock result(X.rows(), X.cols());
      result.real() = pencil.multiply_mass(X.real());
      result.imag() = pencil.multiply_mass(X.imag());
      return result;
    };
    const ComplexBlock     MX = mass(pairs.right);
    const ComplexBlock     MR = mass(reference);
    const Eigen::MatrixXcd cross =
      space.dot(ComplexBlock(reference.conjugate()), MX);
    const Eigen::VectorXd own =
      space.dot(ComplexBlock(pairs.right.conjugate()), MX).diagonal().real();
    const Eigen::VectorXd old =
      space.dot(ComplexBlock(reference.conjugate()), MR).diagonal().real();
    std::vector<std::vector<double>> costs(data.size());
    for (std::size_t i = 0; i < data.size(); ++i)
      for (unsigned int k = 0; k < pairs.size(); ++k)
        costs[i].push_back(1. - std::norm(cross(i, k)) / (own[k] * old[i]));
    const std::vector<int> partner = smallest_assignment(costs);
    for (std::size_t i = 0; i < data.size(); ++i)
      {
        if (partner[i] < 0)
          throw ComputationError("Updating: modes have left the band: widen "
                                 "section Eigenvalues or narrow the bounds");
        mac[i] = 1. - costs[i][partner[i]];
      }
    return partner;
  }



  Eigen::MatrixXcd
  UpdatingModel::derivatives(const Pencil          &pencil,
                             const ComplexPairs    &pairs,
                             const Eigen::VectorXd &logarithms)
  {
    const RowSpace        &space  = *pencil.space();
    const AffineSystem    &system = full->linearized().system;
    const Pencil::Products P      = pencil.apply(pairs.right);
    const Eigen::VectorXcd norms =
      (2. * space.dot(pairs.left, P.mass) * pairs.lambda.asDiagonal() +
       space.dot(pairs.left, P.damping))
        .diagonal();
    std::vector<std::vector<TermCoefficients>> up, down;
    for (unsigned int n = 0; n < n_numbers(); ++n)
      for (const double sign : {1., -1.})
        {
          Eigen::VectorXd moved = logarithms;
          moved[n] += std::log1p(sign * step);
          (sign > 0. ? up : down).push_back(coefficients(system, scene(moved)));
        }
    Eigen::MatrixXcd result = Eigen::MatrixXcd::Zero(pairs.size(), n_numbers());
    for (std::size_t t = 0; t < system.terms.size(); ++t)
      {
        Eigen::VectorXcd product; // y^T A x
        for (unsigned int n = 0; n < n_numbers(); ++n)
          {
            const double mass = (up[n][t].mass - down[n][t].mass) / (2. * step),
                         damping = (up[n][t].damping - down[n][t].damping) /
                                   (2. * step);
            const Complex stiffness =
              (up[n][t].stiffness - down[n][t].stiffness) / (2. * step);
            if (mass == 0. && damping == 0. && stiffness == 0.)
              continue;
            if (product.size() == 0)
              product =
                space
                  .dot(pairs.left, times(*system.terms[t].matrix, pairs.right))
                  .diagonal();
            for (unsigned int k = 0; k < pairs.size(); ++k)
              {
                const Complex l = pairs.lambda[k];
                result(k, n) -= (l * l * mass + l * damping + stiffness) *
                                product[k] / norms[k];
              }
          }
      }
    return result;
  }



  UpdatingEvaluation
  UpdatingModel::evaluate(const Eigen::VectorXd &logarithms)
  {
    // Model and its terms read the numbers from here.
    current.scene      = scene(logarithms);
    ModeSolution modes = solve_modes(*full, context.log, context.timers);
    if (const std::string free = free_motions(*full, modes);
        is_first && !free.empty() && current.eigen.lowest_frequency == 0.)
      throw InputError(free + ": raise Eigenvalues/Lowest frequency above 0, "
                              "or hold them");
    const CeaSolution solution =
      solve_cea(*full, modes, context.log, context.timers);
    warn_of_growth_left_out(solution, "", context.log);
    if (solution.pairs.size() < data.size())
      throw InputError("Eigenvalues: " + std::to_string(solution.pairs.size()) +
                       " modes are in the band, " +
                       std::to_string(data.size()) + " were measured");
    const PairQuantities quantities =
      pair_quantities(*full, modes, solution.pairs);
    std::vector<std::string> names;
    for (const auto &name : quantities.names)
      names.push_back(name.text);

    UpdatingEvaluation result;
    result.logarithms = logarithms;
    result.mac        = Eigen::VectorXd::Ones(data.size());
    const std::vector<int> partner =
      is_first ? first_pairing(solution.pairs, names)
               : next_pairing(*modes.pencil, solution.pairs, result.mac);
    const ComplexPairs pairs = select_pairs(solution.pairs, partner);
    result.mac_measured      = mac_of(pairs);
    modes.inverse.reset();
    return_freed_memory();
    const Eigen::MatrixXcd change =
      derivatives(*modes.pencil, pairs, logarithms);
    result.frequencies.resize(data.size());
    result.residuals.resize(data.size());
    result.jacobian.resize(data.size(), n_numbers());
    for (std::size_t i = 0; i < data.size(); ++i)
      {
        const double w        = std::sqrt(data[i].weight);
        result.frequencies[i] = pairs.frequency(i);
        result.residuals[i] =
          w * (result.frequencies[i] / data[i].frequency - 1.);
        result.jacobian.row(i) =
          w / (2. * M_PI * data[i].frequency) * change.row(i).imag();
        result.names.push_back(names[partner[i]]);
      }
    if (is_first || result.objective() < best)
      {
        best      = result.objective();
        reference = pairs.right;
      }
    if (is_first)
      warn_of_first(result);
    is_first = false;
    return result;
  }
} // namespace squeal
