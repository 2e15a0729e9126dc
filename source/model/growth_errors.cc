// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/base/run_log.h>
#include <squeal/base/timers.h>
#include <squeal/discretization/point_evaluator.h>
#include <squeal/model/finer_modes.h>
#include <squeal/model/growth_errors.h>
#include <squeal/model/second_solutions.h>
#include <squeal/scene/modulus_table.h>

#include <algorithm>
#include <cmath>

namespace squeal
{
  namespace
  {
    using Complex = std::complex<double>;

    /** Of the lowest frequency of the pairs below it, in which they are sought
     * again; where the second solution is the finer one its frequencies are
     * lower. */
    constexpr double reach = 0.15, reach_to_finer = 0.3;
    /** The same above the highest one for linear elements: what bends on few of
     * them has more than twice its frequency. */
    constexpr double reach_of_linear = 1.5;
    /** Least squared cosine of the shapes of a pair found again. Two modes
     * that lock in share half of each of theirs. */
    constexpr double least_likeness = 0.3;
    /** The same over that of the most alike. */
    constexpr double least_of_best = 0.6;
    constexpr double largest_ratio = 1.;
    /** With a lower degree, and with one that is 1. */
    constexpr double least_ratio = 0.1, least_ratio_linear = 0.01;
    /** With one that is 1 and has the pair far away. */
    constexpr double least_ratio_far = 1. / 6.;
    /** Least relative error of a growth rate over that of its frequency. */
    constexpr double least_share = 2.;
    /** Of a frequency: a pair farther away than that on the side to which no
     * finer mesh leads is another one. */
    constexpr double farthest_against = 0.05;

    /** Of an eigenvalue: a growth rate below is what the solver and rounding
     * leave of 0, and its sign is chance. */
    constexpr double resolved = 1e-10;

    /** Displacements at the corners of the coarse mesh, body after body. */
    Functionals
    at_corners(const Discretization &d)
    {
      const PointEvaluator          evaluator(d);
      const CoarseMesh             &mesh = d.coarse_mesh();
      std::vector<Functionals::Row> rows;
      for (unsigned int b = 0; b < d.scene().bodies.size(); ++b)
        {
          std::vector<unsigned int> corners;
          for (const auto &cell : mesh.cells)
            if (cell.material_id == b)
              corners.insert(
                corners.end(), cell.vertices.begin(), cell.vertices.end());
          std::sort(corners.begin(), corners.end());
          corners.erase(std::unique(corners.begin(), corners.end()),
                        corners.end());
          std::vector<dealii::Point<3>> points;
          for (const unsigned int i : corners)
            points.push_back(mesh.vertices[i]);
          const auto found = evaluator.displacements(b, points);
          for (std::size_t i = 0; i < points.size(); ++i)
            if (found.found[i])
              rows.insert(
                rows.end(), found.rows[i].begin(), found.rows[i].end());
        }
      return {d.space(), std::move(rows)};
    }

    /** Shapes of @p pairs there, each of norm 1. */
    Eigen::MatrixXcd
    shapes_at_corners(const Discretization   &d,
                      const LinearizedSystem &system,
                      const ComplexBlock     &vectors)
    {
      const Functionals corners = at_corners(d);
      Eigen::MatrixXcd  shapes(corners.n_rows(), vectors.cols());
      shapes.real() = corners.apply(system.expand(Block(vectors.real())));
      shapes.imag() = corners.apply(system.expand(Block(vectors.imag())));
      shapes.colwise().normalize();
      return shapes;
    }

    ComplexPairs
    growing(const ComplexPairs &pairs)
    {
      std::vector<int> numbers;
      for (unsigned int k = 0; k < pairs.size(); ++k)
        if (grows(pairs, k))
          numbers.push_back(k);
      return select_pairs(pairs, numbers);
    }

    /** The one that @p likeness calls the same and that grows fastest; -1 for
     * none. Where the coarser one has not locked in, the two partners are
     * alike. */
    int
    found_again(const Eigen::VectorXcd &coarse, const Eigen::VectorXd &likeness)
    {
      const double least =
        std::max(least_likeness, least_of_best * likeness.maxCoeff());
      int best = -1;
      for (int i = 0; i < coarse.size(); ++i)
        if (likeness[i] >= least &&
            (best < 0 || coarse[i].real() > coarse[best].real()))
          best = i;
      return best;
    }

    /** What the coarser one of two eigenvalues tells of the error of the finer
     * one, see growth_errors(); @p of_cells: what its cells say of its
     * frequency, rad/s. */
    Complex
    error_by_change(const Complex lambda,
                    const Complex coarser,
                    const double  of_cells,
                    const double  least)
    {
      const Complex change = lambda - coarser;
      // Where the error of the frequency is not known (bodies that turn) all
      // of the change may be left.
      if (std::isnan(of_cells))
        return {change.real(), of_cells};
      const bool is_against =
        change.imag() * of_cells < 0. &&
        std::abs(change.imag()) < farthest_against * std::abs(lambda);
      const double ratio =
        is_against ? largest_ratio
                   : std::clamp(std::abs(of_cells) / std::abs(change.imag()),
                                least,
                                largest_ratio);
      const double frequency =
        is_against
          ? std::copysign(std::max(std::abs(of_cells), std::abs(change.imag())),
                          of_cells)
          : of_cells;
      return {at_least_by_frequency(change.real() * ratio, of_cells, lambda),
              frequency};
    }

    Eigen::VectorXcd
    all_unknown(const ComplexPairs &pairs)
    {
      return Eigen::VectorXcd::Constant(pairs.size(),
                                        Complex(std::nan(""), std::nan("")));
    }

    /** Moduli that follow the frequency would be needed in the second solution
     * too. */
    bool
    can_be_solved_twice(const Model &model)
    {
      return !ModulusTables(model.parameters().scene).depend_on_frequency();
    }

    /** Whether two solutions of the model can tell growth rates. */
    bool
    has_errors(const Model &model, const ComplexPairs &pairs)
    {
      const Discretization *d          = model.discretization();
      bool                  some_grows = false;
      for (unsigned int k = 0; k < pairs.size(); ++k)
        some_grows = some_grows || grows(pairs, k);
      return d && d->has_mesh() && can_be_solved_twice(model) && some_grows;
    }

    /** Errors of @p pairs against those of @p finer. */
    Eigen::VectorXcd
    against_finer(const ComplexPairs    &pairs,
                  const ComplexPairs    &finer,
                  const Eigen::MatrixXd &likeness,
                  const double           factor)
    {
      Eigen::VectorXcd result = all_unknown(pairs);
      for (unsigned int k = 0; k < pairs.size(); ++k)
        {
          Eigen::Index i = 0;
          if (likeness.col(k).maxCoeff(&i) < least_likeness)
            continue;
          // Of two partners the one that grows is that of the one that grows.
          if (grows(pairs, k))
            i = found_again(finer.lambda, likeness.col(k));
          const Complex left = factor * (finer.lambda[i] - pairs.lambda[k]);
          result[k]          = {
                     grows(pairs, k)
                       ? at_least_by_frequency(left.real(), left.imag(), pairs.lambda[k])
                       : left.real(),
            left.imag()};
        }
      return result;
    }

    /** Of pairs whose errors have come from one degree more. */
    Eigen::VectorXcd
    those_that_grow(const ComplexPairs &pairs, const PairErrors &errors)
    {
      Eigen::VectorXcd result = all_unknown(pairs);
      for (unsigned int k = 0; k < pairs.size(); ++k)
        if (grows(pairs, k))
          result[k] = errors.lambda[k];
      return result;
    }

    /** Of all @p pairs against one degree less, where those of @p sought are
     * looked for up to the share @p above beyond them; NaN of those not found
     * again. */
    Eigen::VectorXcd
    against_lower_degree(const Model        &model,
                         const ComplexPairs &pairs,
                         const PairErrors   &errors,
                         const ComplexPairs &sought,
                         const double        above,
                         const double        least,
                         SecondSolutions    &second,
                         Timers             &timers)
    {
      const unsigned int        degree = model.discretization()->degree() - 1;
      SecondSolutions::Solution lower;
      try
        {
          lower = second.solve(model, degree, sought, reach, above, timers);
        }
      catch (const ComputationError &)
        {
          return all_unknown(pairs);
        }
      if (lower.pairs.size() == 0)
        return all_unknown(pairs);
      return growth_errors(model,
                           pairs,
                           errors,
                           {lower.pairs.lambda,
                            shapes_at_corners(*lower.scene->space,
                                              lower.scene->system,
                                              lower.pairs.right)},
                           least);
    }

    bool
    cells_lock(const Model &model)
    {
      return !nearly_incompressible_bodies(model.parameters().scene).empty();
    }

    /** Of all @p pairs against one degree more; NaN of those not found again. */
    Eigen::VectorXcd
    pair_errors_by_next_degree(const Model        &model,
                               const ComplexPairs &pairs,
                               Timers             &timers)
    {
      if (!can_be_solved_twice(model))
        return all_unknown(pairs);
      const unsigned int degree = model.discretization()->degree();
      Timers::Section    section(timers, "Solve: pairs of the next degree");
      SecondSolutions    second;
      SecondSolutions::Solution fine;
      try
        {
          fine = second.solve(
            model, degree + 1, pairs, reach_to_finer, reach, timers);
        }
      catch (const ComputationError &)
        {
          return all_unknown(pairs);
        }
      const ComplexPairs &finer = fine.pairs;
      if (finer.size() == 0)
        return all_unknown(pairs);
      const Eigen::MatrixXd likeness =
        (shapes_at_corners(*fine.scene->space, fine.scene->system, finer.right)
           .adjoint() *
         coarser_pairs(model, pairs).shapes)
          .cwiseAbs2();
      return against_finer(pairs, finer, likeness, 0.5 * (degree + 1.));
    }
  } // namespace



  double
  at_least_by_frequency(const double               growth,
                        const double               frequency,
                        const std::complex<double> lambda)
  {
    const double floor =
      least_share * lambda.real() * std::abs(frequency) / std::abs(lambda);
    return std::copysign(std::max(std::abs(growth), floor), growth);
  }



  bool
  grows(const ComplexPairs &pairs, const unsigned int k)
  {
    return pairs.sigma(k) > resolved * std::abs(pairs.lambda[k]);
  }



  CoarserPairs
  coarser_pairs(const Model &model, const ComplexPairs &pairs)
  {
    const Discretization *d = model.discretization();
    if (!d || !d->has_mesh())
      return {};
    return {pairs.lambda,
            shapes_at_corners(*d, model.linearized(), pairs.right)};
  }



  Eigen::VectorXcd
  growth_errors(const Model        &model,
                const ComplexPairs &pairs,
                const PairErrors   &errors,
                const CoarserPairs &coarser,
                const double        least)
  {
    if (cells_lock(model))
      return those_that_grow(pairs, errors);
    Eigen::VectorXcd result = all_unknown(pairs);
    if (!has_errors(model, pairs) || coarser.lambda.size() == 0)
      return result;
    const Eigen::MatrixXd likeness =
      (coarser.shapes.adjoint() * coarser_pairs(model, pairs).shapes)
        .cwiseAbs2();
    for (unsigned int k = 0; k < pairs.size(); ++k)
      {
        const int i = found_again(coarser.lambda, likeness.col(k));
        if (!grows(pairs, k) || i < 0)
          continue;
        result[k] = error_by_change(
          pairs.lambda[k], coarser.lambda[i], errors.lambda[k].imag(), least);
      }
    return result;
  }



  Eigen::VectorXcd
  growth_errors_by_lower_degree(const Model        &model,
                                const ComplexPairs &pairs,
                                const PairErrors   &errors,
                                SecondSolutions    &second,
                                Timers             &timers)
  {
    if (cells_lock(model))
      return those_that_grow(pairs, errors);
    if (!has_errors(model, pairs) || model.discretization()->degree() < 2)
      return all_unknown(pairs);
    const bool       is_linear = model.discretization()->degree() == 2;
    Timers::Section  section(timers, "Solve: pairs of the lower degree");
    Eigen::VectorXcd result =
      against_lower_degree(model,
                           pairs,
                           errors,
                           growing(pairs),
                           reach,
                           is_linear ? least_ratio_linear : least_ratio,
                           second,
                           timers);
    std::vector<int> missing;
    for (unsigned int k = 0; k < pairs.size(); ++k)
      if (grows(pairs, k) && std::isnan(result[k].real()))
        missing.push_back(k);
    if (!is_linear || missing.empty())
      return result;
    const Eigen::VectorXcd far =
      against_lower_degree(model,
                           pairs,
                           errors,
                           select_pairs(pairs, missing),
                           reach_of_linear,
                           least_ratio_far,
                           second,
                           timers);
    for (const int k : missing)
      result[k] = far[k];
    return result;
  }



  PairErrors
  pair_errors_with_locking(const Model        &model,
                           const Pencil       &pencil,
                           const ComplexPairs &pairs,
                           RunLog             &log,
                           Timers             &timers)
  {
    PairErrors errors = pair_mesh_errors(model, pencil, pairs);
    if (!cells_lock(model) || errors.lambda.array().isNaN().all())
      return errors;
    const std::string body =
      nearly_incompressible_bodies(model.parameters().scene).front();
    errors.lambda        = pair_errors_by_next_degree(model, pairs, timers);
    const auto n_unknown = errors.lambda.array().isNaN().count();
    if (n_unknown == 0)
      log.info("  " + body +
               " hardly changes its volume: mesh errors of pairs are those "
               "against one degree more");
    else
      log.warning(
        body + " hardly changes its volume: the mesh errors of " +
        std::to_string(n_unknown) + " of " + std::to_string(pairs.size()) +
        " pairs are left empty, as " +
        (can_be_solved_twice(model)
           ? "the pairs were not found again with one degree more"
           : "moduli that follow the frequency have no second solution"));
    return errors;
  }
} // namespace squeal
