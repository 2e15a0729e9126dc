// SPDX-License-Identifier: LGPL-2.1-or-later
#include "residual_directions.h"

#include <squeal/base/exceptions.h>
#include <squeal/base/worst_of.h>
#include <squeal/eigen/certified_solver.h>
#include <squeal/eigen/eigenvalue_condition.h>
#include <squeal/eigen/hidden_directions.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

namespace squeal
{
  namespace
  {
    using Complex = std::complex<double>;

    /** Residual up to which a basis that can not improve any more is accepted:
     * that of contact springs of 1e14 N/m. */
    constexpr double exhausted_residual = 1e-4;

    /** Number of the value in @p values nearest to @p lambda. */
    Eigen::Index
    nearest(const Eigen::VectorXcd &values, const Complex lambda)
    {
      Eigen::Index best;
      (values.array() - lambda).abs().minCoeff(&best);
      return best;
    }

    Block
    side_by_side(const Block &a, const Block &b)
    {
      Block both(a.rows(), a.cols() + b.cols());
      both << a, b;
      return both;
    }
  } // namespace



  CertifiedSolver::CertifiedSolver(const Pencil         &p,
                                   const ShiftedInverse &s,
                                   const UndampedModes  &modes,
                                   PairFinder           *f,
                                   const BasisProducts   products)
    : pencil(p)
    , inverse(p, s)
    , finder(f)
    , reduced(p, products)
  {
    const Block        start = side_by_side(modes.shapes, modes.supplement);
    const Eigen::Index n     = start.cols();
    reduced.start(start,
                  modes.mass_products.leftCols(n),
                  modes.stiffness_products.leftCols(n));
    HiddenSearch{pencil, inverse, std::sqrt(std::max(s.shift(), 0.)), pencil}
      .extend(reduced);
  }

  CertifiedSolver::CertifiedSolver(const Pencil          &p,
                                   const CertifiedSolver &other,
                                   const UndampedModes   &modes,
                                   const ComplexPairs    &pairs)
    : pencil(p)
    , inverse(p, other.inverse)
    , finder(nullptr)
    , reduced(p,
              other.reduced.keeps_products() ? BasisProducts::kept
                                             : BasisProducts::computed_anew)
  {
    const RowSpace    &space = *pencil.space();
    const Block       &modal = modes.shapes;
    const Block        mass  = pencil.multiply_mass(modal);
    const Eigen::Index n     = pairs.size();
    reduced.start(modal, mass, pencil.multiply_undamped_stiffness(modal));
    ComplexBlock beyond(modal.rows(), 2 * n);
    beyond << pairs.right, pairs.left;
    const Eigen::MatrixXd re = inner_products(space, mass, beyond.real()),
                          im = inner_products(space, mass, beyond.imag());
    beyond.real() -= modal * re;
    beyond.imag() -= modal * im;
    reduced.extend(compress(space, beyond, Eigen::VectorXd::Ones(2 * n), 0.));
    // The highest of the modes is at the edge of the band or a little beyond.
    const Eigen::VectorXd &squares = modes.omega_squared;
    const double           edge_squared =
      squares.size() > 0 ? squares[squares.size() - 1] : 0.;
    HiddenSearch{pencil, inverse, std::sqrt(std::max(edge_squared, 0.)), pencil}
      .extend(reduced);
  }

  const std::vector<BasisEnrichment> &
  CertifiedSolver::history() const
  {
    return steps;
  }

  const ReducedBasis &
  CertifiedSolver::basis() const
  {
    return reduced;
  }

  std::complex<double>
  CertifiedSolver::growth_below_band() const
  {
    return growth_below;
  }

  std::complex<double>
  CertifiedSolver::growth_left_out() const
  {
    return growth_not_certified;
  }

  bool
  CertifiedSolver::leave_out_growth(const ComplexPairs &pairs,
                                    const double        highest)
  {
    const Complex before = growth_not_certified;
    for (const Complex l : pairs.lambda)
      if (grows_beyond_band(l, highest) &&
          l.real() > growth_not_certified.real())
        growth_not_certified = l;
    return growth_not_certified != before;
  }

  void
  CertifiedSolver::look_below_band(const DensePairs       &dense,
                                   const CertifiedOptions &options)
  {
    growth_below = fastest_growth_below(dense.lambda,
                                        2. * M_PI * options.lowest_frequency,
                                        2. * M_PI * options.highest_frequency);
  }



  void
  CertifiedSolver::extend(const Block &directions)
  {
    reduced.extend(directions);
  }

  void
  CertifiedSolver::answer_with(std::shared_ptr<const ShiftedInverse> other)
  {
    others.push_back(std::move(other));
  }

  DensePairs
  CertifiedSolver::solve_reduced()
  {
    return finder ? finder->solve(reduced.parts()) : reduced.solve();
  }

  std::vector<std::vector<TermCoefficients>>
  CertifiedSolver::coefficients(const Eigen::VectorXcd &lambda) const
  {
    std::vector<std::vector<TermCoefficients>> result(lambda.size());
    for (Eigen::Index k = 0; k < lambda.size(); ++k)
      if (finder)
        result[k] = finder->coefficients(lambda[k]);
      else
        for (const auto &part : reduced.parts())
          result[k].push_back(part.coefficients);
    return result;
  }



  CertifiedSolver::Candidates
  CertifiedSolver::candidates(const DensePairs       &dense,
                              const CertifiedOptions &options) const
  {
    std::vector<int> kept;
    for (Eigen::Index i = 0; i < dense.lambda.size(); ++i)
      if (is_of_band(dense.lambda[i],
                     options.lowest_frequency,
                     options.highest_frequency) &&
          (growth_not_certified == 0. ||
           !grows_beyond_band(dense.lambda[i], options.highest_frequency)))
        kept.push_back(i);
    const Eigen::Index n = kept.size();
    Candidates         result;
    ComplexPairs      &pairs = result.pairs;
    pairs.lambda.resize(n);
    pairs.condition.resize(n);
    pairs.residual = pairs.left_residual = Eigen::VectorXd::Zero(n);
    pairs.error_estimate                 = Eigen::VectorXd::Zero(n);
    pairs.pair_partner.assign(n, -1);
    Eigen::MatrixXcd &right = result.right, &left = result.left;
    right.resize(dense.right.rows(), n);
    left.resize(dense.left.rows(), n);
    for (Eigen::Index k = 0; k < n; ++k)
      {
        pairs.lambda[k] = dense.lambda[kept[k]];
        right.col(k)    = dense.right.col(kept[k]);
        left.col(k)     = dense.left.col(kept[k]);
      }
    // Basis coordinates are mass-orthonormal: their 2-norm is the mass norm.
    Eigen::MatrixXcd Mx = Eigen::MatrixXcd::Zero(right.rows(), n), Cx = Mx;
    const auto       of_pairs = coefficients(pairs.lambda);
    for (std::size_t i = 0; n > 0 && i < reduced.parts().size(); ++i)
      {
        const Eigen::MatrixXcd product = reduced.parts()[i].matrix * right;
        for (Eigen::Index k = 0; k < n; ++k)
          {
            Mx.col(k) += of_pairs[k][i].mass * product.col(k);
            Cx.col(k) += of_pairs[k][i].damping * product.col(k);
          }
      }
    for (Eigen::Index k = 0; k < n; ++k)
      {
        const Complex d    = (left.col(k).transpose() *
                           (2. * pairs.lambda[k] * Mx.col(k) + Cx.col(k)))(0);
        pairs.condition[k] = eigenvalue_condition(
          pairs.lambda[k], right.col(k).norm() * left.col(k).norm(), d);
      }
    return result;
  }



  CertifiedSolver::Residuals
  CertifiedSolver::evaluate_residuals(Candidates             &c,
                                      const CertifiedOptions &options)
  {
    ComplexPairs      &pairs = c.pairs;
    const Eigen::Index n     = pairs.size();
    Residuals          result;
    const auto         of_pairs = coefficients(pairs.lambda);
    result.right   = reduced.residuals(of_pairs, pairs.lambda, c.right, false);
    pairs.residual = result.right.relative;
    if (rounding_sizes.size() != n)
      rounding_sizes = pencil.stiffness_rounding_size(reduced.lift(c.right));
    pairs.noise_floor = 4. * std::numeric_limits<double>::epsilon() *
                        rounding_sizes.array() /
                        result.right.denominators.array();
    result.met = (pairs.residual.array() <=
                  pairs.noise_floor.array().max(options.residual_tolerance))
                   .all();
    if (left_met && !result.met)
      return result;
    result.left = reduced.residuals(of_pairs, pairs.lambda, c.left, true);
    pairs.left_residual = result.left.relative;
    left_met =
      worst_of(pairs.left_residual) <= std::sqrt(options.residual_tolerance);
    return result;
  }



  unsigned int
  CertifiedSolver::enrich(const ComplexPairs     &pairs,
                          Residuals             &&residuals,
                          const CertifiedOptions &options)
  {
    const RowSpace &space        = *pencil.space();
    PairResiduals  &right        = residuals.right;
    const auto      right_scales = [&](const auto &sizes) {
      return Eigen::VectorXd(sizes.array() * right.denominators.array());
    };
    if (residuals.met)
      // What is left to know is by how much the eigenvalues still change:
      // every residual counts, however small it is.
      return reduced.extend(inverse.solve(
        compress(space, right.vectors, right_scales(pairs.residual), 0.1)));
    const Eigen::VectorXd tolerances =
      Eigen::VectorXd::Constant(pairs.size(), options.residual_tolerance);
    const Block residual_directions =
      compress(space, right.vectors, right_scales(tolerances), 0.3);
    // Where memory is short every group of directions is taken in as it comes;
    // all at once share the products with the matrices.
    Block        all;
    unsigned int n_added = 0;
    const auto   add     = [&](Block directions) {
      if (!reduced.keeps_products())
        n_added += reduced.extend(std::move(directions));
      else if (all.cols() == 0)
        all = std::move(directions);
      else
        all = side_by_side(all, directions);
    };
    Block answers = inverse.solve(residual_directions);
    // The responses to the inertia forces too: two steps of the Krylov space
    // for one evaluation of the residuals.
    Block inertia;
    if (others.empty())
      inertia = pencil.multiply_mass(answers);
    add(std::move(answers));
    if (others.empty())
      add(inverse.solve(inertia));
    inertia.resize(0, 0);
    for (const auto &other : others)
      add(other->solve(residual_directions));
    // Left residuals enter the eigenvalue's error only as a product with the
    // right ones: the square root of the tolerance is enough for them.
    if (residuals.left.vectors.cols() > 0)
      {
        const Block left_directions = compress(
          space,
          residuals.left.vectors,
          std::sqrt(options.residual_tolerance) * residuals.left.denominators,
          0.3);
        add(inverse.solve_transposed(left_directions));
        for (const auto &other : others)
          add(other->solve(left_directions));
      }
    return reduced.keeps_products() ? reduced.extend(std::move(all)) : n_added;
  }



  namespace
  {
    /** Largest change of an eigenvalue by the last enrichment that is small
     * enough to serve as the bound of what is left. */
    constexpr double negligible_change = 1e-11;

    /** Takes the errors of the pairs of an @p earlier, smaller basis as bounds
     * of those of @p pairs; false where they are too large for that. */
    bool
    adopt_estimates(ComplexPairs &pairs, const ComplexPairs &earlier)
    {
      if (earlier.size() == 0 ||
          !(worst_of(earlier.error_estimate) <= negligible_change))
        return false;
      // Partners of nearly coalesced pairs.
      estimate_errors(pairs, pairs.lambda);
      for (unsigned int i = 0; i < pairs.size(); ++i)
        {
          const auto   k    = nearest(earlier.lambda, pairs.lambda[i]);
          const double away = std::abs(earlier.lambda[k] - pairs.lambda[i]);
          // Of a nearly defective pair each member moves by the root.
          const double bound = pairs.condition[i] < coalescence_condition
                                 ? negligible_change
                                 : std::sqrt(negligible_change);
          if (!(away <= bound * std::abs(pairs.lambda[i])))
            return false;
          pairs.error_estimate[i] = earlier.error_estimate[k];
        }
      return true;
    }

    bool
    estimates_met(const ComplexPairs &pairs, const CertifiedOptions &options)
    {
      return (pairs.error_estimate.array() <=
              pairs.noise_floor.array().max(options.error_tolerance))
        .all();
    }

    /** Tells a basis that still improves from one at the rounding floor. */
    class Stagnation
    {
    public:
      /** To be told the worst residual of every step. */
      bool
      is_reached(const double residual)
      {
        n_idle = residual > 0.5 * best ? n_idle + 1 : 0;
        best   = std::min(best, residual);
        return n_idle >= 2;
      }

    private:
      double       best   = std::numeric_limits<double>::max();
      unsigned int n_idle = 0;
    };

    [[noreturn]] void
    throw_stalled(const double residual)
    {
      std::ostringstream text;
      text << "the certified basis stalls at a residual of " << residual
           << ": raise Eigenvalues/Maximum enrichments or Eigenvalues/"
              "Residual tolerance; unknowns of imported matrices without mass "
              "that friction or damping acts on can cause it: condense them "
              "statically before";
      throw ComputationError(text.str());
    }
  } // namespace



  ComplexPairs
  CertifiedSolver::solve(
    const CertifiedOptions                             &options,
    const std::function<void(const BasisEnrichment &)> &report)
  {
    DensePairs   dense = solve_reduced();
    Stagnation   stagnation;
    ComplexPairs earlier;
    for (unsigned int step = 0;; ++step)
      {
        Candidates    current = candidates(dense, options);
        ComplexPairs &pairs   = current.pairs;
        if (pairs.size() == 0)
          {
            look_below_band(dense, options);
            pairs.right = pairs.left =
              ComplexBlock(reduced.vectors().rows(), 0);
            return pairs;
          }
        const unsigned int size      = reduced.size();
        Residuals          residuals = evaluate_residuals(current, options);
        const bool         met       = residuals.met;
        // Converged further than anybody asked: no need to know how far.
        const bool   known = met && adopt_estimates(pairs, earlier);
        unsigned int added = 0;
        if (known)
          residuals.right.vectors.resize(0, 0);
        else
          {
            added = enrich(pairs, std::move(residuals), options);
            dense = solve_reduced();
            estimate_errors(pairs, dense.lambda);
          }
        earlier            = pairs;
        const double worst = worst_of(pairs.residual);
        steps.push_back({size, worst, worst_of(pairs.error_estimate)});
        if (report)
          report(steps.back());

        const bool certain = estimates_met(pairs, options);
        // Where no direction is new, or none helps, the residual is what
        // rounding leaves of it; the table says how much that is.
        const bool at_floor = !known &&
                              (stagnation.is_reached(worst) || added == 0) &&
                              certain && worst <= exhausted_residual;
        if (at_floor)
          pairs.noise_floor = pairs.noise_floor.cwiseMax(pairs.residual);
        const bool done = (met && certain) || at_floor;
        if (done && (!finder || finder->is_complete(reduced.parts())))
          {
            look_below_band(dense, options);
            reduced.release_products();
            pairs.right = reduced.lift(current.right);
            pairs.left  = reduced.lift(current.left);
            return pairs;
          }
        if (done)
          dense = solve_reduced();
        if ((added == 0 && !done) || step >= options.maximum_enrichments)
          {
            if (!leave_out_growth(pairs, options.highest_frequency))
              throw_stalled(worst);
            // The other pairs have rounds of their own.
            step       = 0;
            stagnation = {};
          }
      }
  }
} // namespace squeal
