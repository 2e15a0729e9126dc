// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/base/timers.h>
#include <squeal/discretization/point_evaluator.h>
#include <squeal/eigen/certified_solver.h>
#include <squeal/model/growth_errors.h>
#include <squeal/model/other_degree.h>
#include <squeal/scene/modulus_table.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace squeal
{
  namespace
  {
    using Complex = std::complex<double>;

    /** Of the band beyond the growing pairs, in which they are sought again. */
    constexpr double reach = 0.15;
    /** Least squared cosine of the shapes of a pair found again. Two modes
     * that lock in share half of each of theirs. */
    constexpr double least_likeness = 0.3;
    /** The same over that of the most alike. */
    constexpr double least_of_best = 0.6;
    constexpr double largest_ratio = 1.;
    /** With a lower degree, and with one that is 1. */
    constexpr double least_ratio = 0.1, least_ratio_linear = 0.01;
    /** Least relative error of a growth rate over that of its frequency. */
    constexpr double least_share = 2.;
    /** Of a frequency: a pair farther away than that on the side to which no
     * finer mesh leads is another one. */
    constexpr double farthest_against = 0.05;

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

    /** Pairs of the lower degree about those of @p pairs that grow. */
    ComplexPairs
    pairs_of(const OtherDegree     &coarse,
             const ComplexPairs    &pairs,
             const EigenParameters &p)
    {
      double lowest = std::numeric_limits<double>::infinity(), highest = 0.;
      for (unsigned int k = 0; k < pairs.size(); ++k)
        if (pairs.sigma(k) > 0.)
          {
            lowest  = std::min(lowest, pairs.frequency(k));
            highest = std::max(highest, pairs.frequency(k));
          }
      CertifiedOptions options;
      options.lowest_frequency    = (1. - reach) * lowest;
      options.highest_frequency   = (1. + reach) * highest;
      options.residual_tolerance  = std::max(1e-6, p.residual_tolerance);
      options.error_tolerance     = std::max(1e-6, p.error_tolerance);
      options.maximum_enrichments = p.maximum_enrichments;
      ModeOptions of_modes;
      of_modes.tolerance = p.mode_tolerance;
      const ShiftedInverse inverse(
        *coarse.pencil, std::pow(2. * M_PI * options.highest_frequency, 2));
      UndampedModes modes = undamped_modes(*coarse.pencil, inverse, of_modes);
      if (modes.shapes.cols() == 0)
        return {};
      CertifiedSolver solver(*coarse.pencil, inverse, modes);
      modes.release_start();
      return solver.solve(options);
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
      const double left = change.real() * ratio;
      const double floor =
        least_share * lambda.real() * std::abs(of_cells) / std::abs(lambda);
      return {std::copysign(std::max(std::abs(left), floor), left), frequency};
    }

    Eigen::VectorXcd
    all_unknown(const ComplexPairs &pairs)
    {
      return Eigen::VectorXcd::Constant(pairs.size(),
                                        Complex(std::nan(""), std::nan("")));
    }

    /** Whether two solutions of the model can tell growth rates. */
    bool
    has_errors(const Model &model, const ComplexPairs &pairs)
    {
      const Discretization *d = model.discretization();
      // With moduli that follow the frequency the second solution would need
      // them too: the estimate of the cells stands.
      return d && d->has_mesh() &&
             !ModulusTables(model.parameters().scene).depend_on_frequency() &&
             pairs.lambda.real().maxCoeff() > 0.;
    }
  } // namespace



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
    Eigen::VectorXcd result = all_unknown(pairs);
    if (!has_errors(model, pairs) || coarser.lambda.size() == 0)
      return result;
    const Eigen::MatrixXd likeness =
      (coarser.shapes.adjoint() * coarser_pairs(model, pairs).shapes)
        .cwiseAbs2();
    for (unsigned int k = 0; k < pairs.size(); ++k)
      {
        const int i = found_again(coarser.lambda, likeness.col(k));
        if (pairs.sigma(k) <= 0. || i < 0)
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
                                Timers             &timers)
  {
    const Eigen::VectorXcd unknown = all_unknown(pairs);
    if (!has_errors(model, pairs) || model.discretization()->degree() < 2)
      return unknown;
    const unsigned int degree = model.discretization()->degree() - 1;
    Timers::Section    section(timers, "Solve: pairs of the lower degree");
    const OtherDegree  lower = with_degree(model, degree, timers);
    ComplexPairs       coarse;
    try
      {
        coarse = pairs_of(lower, pairs, model.parameters().eigen);
      }
    catch (const ComputationError &)
      {
        return unknown; // the estimate of the cells stands
      }
    if (coarse.size() == 0)
      return unknown;
    return growth_errors(
      model,
      pairs,
      errors,
      {coarse.lambda,
       shapes_at_corners(*lower.space, lower.system, coarse.right)},
      degree > 1 ? least_ratio : least_ratio_linear);
  }
} // namespace squeal
