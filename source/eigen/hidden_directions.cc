// SPDX-License-Identifier: LGPL-2.1-or-later
#include "random_of_row.h"
#include "residual_directions.h"

#include <squeal/base/worst_of.h>
#include <squeal/eigen/hidden_directions.h>
#include <squeal/eigen/reduced_basis.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace squeal
{
  namespace
  {
    /** Random columns: as many copies of one decoupled part can be found. */
    constexpr unsigned int n_columns = 4;
    constexpr unsigned int n_steps = 4, n_improvements = 5;
    constexpr unsigned int most_searches = 8;

    /** Edges of the band up to which a pair is looked at in a first space, also
     * one that grows, and taken from the improved one: there the undamped modes
     * of the complement are not, since V holds those up to sqrt(2) times the
     * edge. */
    constexpr double first_reach = 3., first_reach_of_growth = 1e4,
                     last_reach = 1.2;
    /** Of those that are looked at, what grows and the nearest first. */
    constexpr Eigen::Index most_candidates = 8;

    /** Residual at which a pair is known well enough to start from. */
    constexpr double good_start = 1e-5;

    /** Share of a column that is rounding when V is taken out. */
    constexpr double least_share = 1e-8;

    /** Over the stiffness or the inertia of the same matrix at the edge of the
     * band, damping that can not move a pair into the band. */
    constexpr double small_damping = 0.3;

    /** What the undamped modes do not have, at |lambda| of the edge of the
     * band: forces of the position and of the velocity. */
    class Coupling
    {
    public:
      Coupling(const Pencil &pencil, const double edge)
      {
        for (const auto &part : pencil.parts())
          {
            const TermCoefficients &c        = part.coefficients;
            const double            velocity = edge * c.damping;
            const double position = c.stiffness.real() - edge * edge * c.mass,
                         own      = std::abs(c.stiffness) + // of one of them
                               edge * edge * std::abs(c.mass);
            // Proportional damping of a matrix leaves its modes alone.
            const bool is_small =
              part.symmetric && std::abs(velocity) <= small_damping * own;
            if (velocity != 0. && !is_small)
              terms.push_back({part.matrix.get(), 0., velocity});
            if (!part.symmetric && position != 0.)
              terms.push_back({part.matrix.get(), position, 0.});
          }
        for (const Term &term : terms)
          {
            has_position = has_position || term.position != 0.;
            has_velocity = has_velocity || term.velocity != 0.;
          }
      }

      bool
      acts() const
      {
        return has_position || has_velocity;
      }

      /** Of the columns in turn: both kinds of forces, then each alone, since
       * one may hide what the other does. */
      Block
      forces(const Block &X) const
      {
        Block result = Block::Zero(X.rows(), X.cols());
        for (const Term &term : terms)
          {
            const Block AX = term.matrix->multiply(X);
            for (Eigen::Index j = 0; j < X.cols(); ++j)
              if (const bool alone = has_position && has_velocity && j % 2 == 1;
                  !alone || (j % 4 == 1) == (term.position != 0.))
                result.col(j) += (term.position + term.velocity) * AX.col(j);
          }
        return result;
      }

    private:
      struct Term
      {
        const LinearOperator *matrix;
        double                position, velocity; /**< one of them is 0 */
      };
      std::vector<Term> terms;
      bool              has_position = false, has_velocity = false;
    };

    Block
    random_columns(const RowSpace &space, const unsigned int seed)
    {
      Block result(space.n_owned(), n_columns);
      for (unsigned int i = 0; i < space.n_owned(); ++i)
        for (unsigned int j = 0; j < n_columns; ++j)
          result(i, j) =
            random_of_row(space.first_owned() + i, seed * n_columns + j);
      return result;
    }

    /** Takes V out of the columns of @p W; those that are nothing else become
     * zero, the others have norm 1. */
    Block
    outside_of(const Pencil &metric, const Eigen::Ref<const Block> &V, Block W)
    {
      const RowSpace       &space  = *metric.space();
      const Eigen::VectorXd before = space.norms(W);
      for (unsigned int twice = 0; twice < 2; ++twice)
        W -= V * inner_products(space, V, metric.multiply_mass(W));
      const Eigen::VectorXd after = space.norms(W);
      for (Eigen::Index j = 0; j < W.cols(); ++j)
        if (after[j] > least_share * before[j])
          W.col(j) /= after[j];
        else
          W.col(j).setZero();
      return W;
    }

    /** The columns of @p W that are not zero on all ranks. */
    Block
    without_zeros(const RowSpace &space, const Block &W)
    {
      const Eigen::VectorXd     norms = space.norms(W);
      std::vector<Eigen::Index> kept;
      for (Eigen::Index j = 0; j < W.cols(); ++j)
        if (norms[j] > 0.)
          kept.push_back(j);
      return W(Eigen::all, kept);
    }

    DensePairs
    select(const DensePairs &all, const std::vector<Eigen::Index> &kept)
    {
      DensePairs result;
      result.lambda = all.lambda(kept);
      result.right  = all.right(Eigen::all, kept);
      result.left   = all.left(Eigen::all, kept);
      return result;
    }

    /** Those of the pairs that are of a band @p reach times as wide. */
    DensePairs
    near_band(const DensePairs &all, const double edge, const double reach)
    {
      std::vector<Eigen::Index> kept;
      for (Eigen::Index i = 0; i < all.lambda.size(); ++i)
        if (is_of_band(all.lambda[i], 0., reach * edge / (2. * M_PI)))
          kept.push_back(i);
      return select(all, kept);
    }

    /** Those that may turn out to be of the band, first what grows. */
    DensePairs
    candidates(const DensePairs &all, const double edge)
    {
      std::vector<Eigen::Index> kept;
      for (Eigen::Index i = 0; i < all.lambda.size(); ++i)
        if (const std::complex<double> l = all.lambda[i];
            is_of_band(l, 0., first_reach * edge / (2. * M_PI)) ||
            (l.real() > 0. && std::abs(l) <= first_reach_of_growth * edge))
          kept.push_back(i);
      const auto order = [&](const Eigen::Index k) {
        return std::make_pair(all.lambda[k].real() <= 0.,
                              std::abs(all.lambda[k]));
      };
      std::stable_sort(
        kept.begin(), kept.end(), [&](const auto a, const auto b) {
          return order(a) < order(b);
        });
      if (static_cast<Eigen::Index>(kept.size()) > most_candidates)
        kept.resize(most_candidates);
      return select(all, kept);
    }
  } // namespace



  Block
  HiddenSearch::directions(const Eigen::Ref<const Block> &V,
                           const unsigned int             seed) const
  {
    const RowSpace &space = *pencil.space();
    Block           none(space.n_owned(), 0);
    const Coupling  coupling(pencil, edge);
    if (!(edge > 0.) || !coupling.acts())
      return none;
    ReducedBasis complement(pencil);
    const auto   extend = [&](Block W) {
      W = without_zeros(space, outside_of(metric, V, std::move(W)));
      if (W.cols() > 0)
        complement.extend(std::move(W));
    };
    // Each column goes its own way: mixed ones would no longer be those of one
    // kind of forces.
    Block last = random_columns(space, seed);
    for (unsigned int step = 0; step < n_steps; ++step)
      {
        last = outside_of(metric, V, inverse.solve(coupling.forces(last)));
        extend(last);
      }
    if (complement.size() == 0)
      return none;

    DensePairs all = complement.solve();
    for (unsigned int i = 0; i < n_improvements; ++i)
      {
        const DensePairs near = candidates(all, edge);
        if (near.lambda.size() == 0)
          return none;
        PairResiduals right =
                        complement.residuals(near.lambda, near.right, false),
                      left = complement.residuals(near.lambda, near.left, true);
        if (worst_of(right.relative) <= good_start &&
            worst_of(left.relative) <= good_start)
          break;
        const unsigned int before = complement.size();
        extend(inverse.solve(
          compress(space, right.vectors, good_start * right.denominators, 1.)));
        extend(inverse.solve_transposed(
          compress(space, left.vectors, good_start * left.denominators, 1.)));
        if (complement.size() == before)
          break;
        all = complement.solve();
      }
    const DensePairs   near = near_band(all, edge, last_reach);
    const Eigen::Index n    = near.lambda.size();
    if (n == 0)
      return none;
    ComplexBlock both(space.n_owned(), 2 * n);
    both << complement.lift(near.right), complement.lift(near.left);
    return compress(space, both, Eigen::VectorXd::Ones(2 * n), 0.);
  }



  void
  HiddenSearch::extend(ReducedBasis &basis) const
  {
    for (unsigned int seed = 0; seed < most_searches; ++seed)
      {
        Block hidden = directions(basis.vectors(), seed);
        if (hidden.cols() == 0 || basis.extend(std::move(hidden)) == 0)
          return;
      }
  }
} // namespace squeal
