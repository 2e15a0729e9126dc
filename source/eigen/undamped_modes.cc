// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/base/number_text.h>
#include <squeal/eigen/mass_basis.h>
#include <squeal/eigen/undamped_modes.h>

#include "arpack_modes.h"
#include "mode_coupling.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

// deal.II declares it too, but its BLAS declarations contradict Eigen's.
extern "C" void dsyevd_(const char *,
                        const char *,
                        const int *,
                        double *,
                        const int *,
                        double *,
                        double *,
                        const int *,
                        int *,
                        const int *,
                        int *);

namespace squeal
{
  namespace
  {
    /** Eigenvalues, ascending, and orthonormal vectors of a symmetric matrix.
     */
    struct SymmetricPairs
    {
      Eigen::VectorXd values;
      Eigen::MatrixXd vectors;

      explicit SymmetricPairs(const Eigen::MatrixXd &A)
        : values(A.rows())
        , vectors(A)
      {
        const int           n = static_cast<int>(A.rows());
        std::vector<double> work(1 + 6 * n + 2 * std::size_t(n) * n);
        std::vector<int>    whole_work(3 + 5 * n);
        const int           n_work = static_cast<int>(work.size()),
                  n_whole          = static_cast<int>(whole_work.size());
        int info                   = 0;
        dsyevd_("V",
                "L",
                &n,
                vectors.data(),
                &n,
                values.data(),
                work.data(),
                &n_work,
                whole_work.data(),
                &n_whole,
                &info);
        if (info != 0)
          throw ComputationError("LAPACK found no eigenvalues of the projected "
                                 "modes (info = " +
                                 std::to_string(info) + ")");
      }
    };

    /** The space grows by one part in so many before it is looked at again. */
    constexpr Eigen::Index look_again = 12;

    /** Two steps of so many project twice. */
    constexpr unsigned int clean_again = 8;

    Block random_block(const RowSpace    &space,
                       const unsigned int n_columns,
                       const unsigned int seed);

    /** True where the inverse amplifies a random vector so much that an
     * eigenvalue must lie on the shift, to nine digits. */
    bool
    is_on_eigenvalue(const Pencil                     &pencil,
                     const MumpsFactorization<double> &factor,
                     const double                      shift)
    {
      const RowSpace &space = *pencil.space();
      const Block     x     = random_block(space, 1, 7);
      const Block     Mx    = pencil.multiply_mass(x);
      const Block     y     = factor.solve(Mx);
      Eigen::MatrixXd sizes(1, 2);
      sizes << x.cwiseProduct(Mx).sum(),
        y.cwiseProduct(pencil.multiply_mass(y)).sum();
      space.sum(sizes);
      return std::sqrt(std::abs(sizes(0, 1) / sizes(0, 0))) * std::abs(shift) >
             1e9;
    }
  } // namespace



  ShiftedInverse::ShiftedInverse(const Pencil        &pencil,
                                 const double         shift,
                                 const FactorStorage &storage)
    : shift_value(shift)
  {
    factor = std::make_unique<MumpsFactorization<double>>(
      pencil.space(), MumpsFactorization<double>::Symmetry::symmetric, storage);
    for (unsigned int attempt = 0;; ++attempt)
      {
        const bool last = attempt == 4;
        try
          {
            Triplets entries = pencil.undamped_entries(shift_value);
            factor->factorize(std::move(entries.rows),
                              std::move(entries.columns),
                              std::move(entries.values));
            if (last || !is_on_eigenvalue(pencil, *factor, shift_value))
              return;
          }
        catch (const NotEnoughMemory &)
          {
            throw;
          }
        catch (const ComputationError &)
          {
            if (last)
              throw;
          }
        shift_value = shift * (1. + 1e-6 * std::pow(10., attempt)) +
                      (shift == 0. ? 1. : 0.);
      }
  }

  Block
  ShiftedInverse::solve(const Block &right_hand_sides) const
  {
    return factor->solve(right_hand_sides);
  }

  double
  ShiftedInverse::shift() const
  {
    return shift_value;
  }

  unsigned int
  ShiftedInverse::n_modes_below() const
  {
    return factor->n_negative_pivots();
  }

  double
  ShiftedInverse::n_factor_entries() const
  {
    return factor->n_factor_entries();
  }

  FactorPlace
  ShiftedInverse::place() const
  {
    return factor->place();
  }

  double
  ShiftedInverse::needed_memory() const
  {
    return factor->needed_memory();
  }



  void
  UndampedModes::release_start()
  {
    supplement.resize(0, 0);
    mass_products.resize(0, 0);
    stiffness_products.resize(0, 0);
  }

  double
  UndampedModes::frequency(const unsigned int i) const
  {
    // A NaN stays one in this order of std::max.
    return std::sqrt(std::max(omega_squared[i], 0.)) / (2. * M_PI);
  }



  namespace
  {
    /** Random numbers that depend on the global row only, so that any number
     * of ranks starts alike. */
    Block
    random_block(const RowSpace    &space,
                 const unsigned int n_columns,
                 const unsigned int seed)
    {
      Block result(space.n_owned(), n_columns);
      for (unsigned int i = 0; i < space.n_owned(); ++i)
        {
          std::minstd_rand generator(12345 + 1000003 * seed +
                                     space.first_owned() + i);
          generator.discard(3);
          for (unsigned int j = 0; j < n_columns; ++j)
            result(i, j) =
              2. * double(generator()) / double(generator.max()) - 1.;
        }
      return result;
    }



    /** Unknowns without mass: no mode beyond the others belongs to them. */
    unsigned int
    count_massless(const Pencil &pencil)
    {
      const RowSpace &space = *pencil.space();
      const Block     Mx    = pencil.multiply_mass(random_block(space, 1, 11));
      Eigen::MatrixXd n(1, 1);
      n(0, 0) = double((Mx.array() == 0.).count());
      space.sum(n);
      return static_cast<unsigned int>(std::lround(n(0, 0)));
    }



    /** The Krylov space of S M (S the shifted inverse) in mass-orthonormal
     * blocks, and the projection T = Q^T M S M Q. */
    struct BlockKrylov
    {
      BlockKrylov(const Pencil         &pencil,
                  const ShiftedInverse &inverse,
                  const ModeOptions    &options)
        : inverse(inverse)
        , space(pencil.space())
        , basis(pencil)
        , n_massless(count_massless(pencil))
      {
        if (options.deflated.cols() > 0)
          n_deflated = basis.extend(options.deflated, 1e-8).cols();
        add_random(pencil, options);
      }

      /** A fresh random block: the start, and again where the space has become
       * invariant (a multiple eigenvalue has more shapes than a block). */
      void
      add_random(const Pencil &pencil, const ModeOptions &options)
      {
        // One solve filters rigid noise out of the random numbers.
        n_last = basis
                   .extend(inverse.solve(pencil.multiply_mass(random_block(
                             *space, options.block_size, n_starts++))),
                           1e-8)
                   .cols();
      }

      /** One block step with full reorthogonalisation. */
      void
      extend()
      {
        const Eigen::Index n = basis.size() - n_deflated, b = n_last;
        Eigen::MatrixXd    h;
        const Block        W =
          inverse.solve(Block(basis.mass_products().rightCols(b)));
        // What one projection leaves of the last two blocks grows from step to
        // step: two in a row without it begin anew.
        const Block next =
          basis.extend(W, 1e-13, &h, n_steps++ % clean_again < 2);

        Eigen::MatrixXd grown                   = Eigen::MatrixXd::Zero(n, n);
        grown.topLeftCorner(T.rows(), T.cols()) = T;
        grown.rightCols(b)                      = h.bottomRows(n);
        grown.bottomRows(b)                     = h.bottomRows(n).transpose();
        T        = 0.5 * (grown + grown.transpose());
        coupling = inner_products(
          *space, basis.mass_products().rightCols(next.cols()), W);
        n_last = next.cols();
      }

      const ShiftedInverse           &inverse;
      std::shared_ptr<const RowSpace> space;
      MassBasis                       basis;
      unsigned int                    n_massless;
      Eigen::MatrixXd                 T;
      Eigen::MatrixXd coupling; /**< of the last block to what is left out */
      unsigned int    n_last = 0, n_deflated = 0, n_starts = 0, n_steps = 0;
    };



    UndampedModes
    ritz_modes(const Pencil                &pencil,
               const SymmetricPairs        &ritz,
               const Eigen::VectorXd       &errors,
               std::unique_ptr<BlockKrylov> krylov,
               const double                 shift,
               const double                 tolerance)
    {
      const Eigen::VectorXd &theta = ritz.values;
      const auto             Q =
        krylov->basis.vectors().middleCols(krylov->n_deflated, theta.size());
      const auto MQ = krylov->basis.mass_products().middleCols(
        krylov->n_deflated, theta.size());
      std::vector<int> kept, rest;
      for (Eigen::Index i = 0; i < theta.size(); ++i)
        if (theta[i] < 0. && errors[i] <= tolerance * std::abs(theta[i]))
          kept.push_back(i);
      // Above the shift: theta descending is omega^2 ascending.
      for (Eigen::Index i = theta.size() - 1; i >= 0 && theta[i] > 0.; --i)
        if (errors[i] <= tolerance * theta[i])
          kept.push_back(i);
        else if (theta[i] * shift > 0.25)
          rest.push_back(i);
      std::sort(kept.begin(), kept.end(), [&](const int a, const int b) {
        return shift + 1. / theta[a] < shift + 1. / theta[b];
      });

      std::vector<int> order = kept;
      order.insert(order.end(), rest.begin(), rest.end());
      const Eigen::MatrixXd all           = ritz.vectors(Eigen::all, order);
      const Eigen::VectorXd inverse_theta = theta(order).cwiseInverse();
      UndampedModes         modes;
      modes.omega_squared = shift + inverse_theta.head(kept.size()).array();
      Block both          = Q * all;
      modes.mass_products = MQ * all;
      if (krylov->n_massless > 0)
        {
          // Rounding moves unknowns without mass, which products with M do not
          // see. One more inverse step brings them where the others ask for
          // (Nour-Omid, Parlett, Ericsson and Jensen 1987).
          both = krylov->inverse.solve(modes.mass_products) *
                 inverse_theta.asDiagonal();
          modes.mass_products = pencil.multiply_mass(both);
        }
      krylov.reset(); // the largest of all that there is
      modes.shapes             = both.leftCols(kept.size());
      modes.supplement         = both.rightCols(rest.size());
      modes.stiffness_products = pencil.multiply_undamped_stiffness(both);
      set_residuals(modes, *pencil.space());
      return modes;
    }



    /** All modes below a limit, which an inertia has counted. */
    struct Wanted
    {
      double       limit; /**< of omega^2 */
      unsigned int n;
    };

    /** @p wanted beyond the shift: the others between shift and limit converge
     * after those that lie as far below it. */
    UndampedModes
    block_lanczos(const Pencil         &pencil,
                  const ShiftedInverse &inverse,
                  const ModeOptions    &options,
                  const Wanted         &wanted)
    {
      const unsigned int n_wanted  = wanted.n;
      const auto         is_wanted = [&](const double theta) {
        return theta < 0. || theta * (wanted.limit - inverse.shift()) > 1.;
      };
      auto own = std::make_unique<BlockKrylov>(pencil, inverse, options);
      BlockKrylov       &krylov = *own;
      const unsigned int n_total =
        pencil.space()->n_global() - krylov.n_massless;
      Eigen::Index next_look = n_wanted + options.block_size;
      while (true)
        {
          krylov.extend();
          const Eigen::Index n = krylov.T.rows();
          if (krylov.n_last == 0 && n < n_total)
            krylov.add_random(pencil, options);
          const bool whole = krylov.n_last == 0 || n >= n_total;
          // A dense eigenproblem at every step would cost more than the steps.
          if (!whole && n < next_look)
            continue;
          next_look = n + n / look_again;
          const SymmetricPairs ritz(krylov.T);
          Eigen::VectorXd      errors = Eigen::VectorXd::Zero(n);
          if (!whole && krylov.coupling.rows() > 0)
            errors = (krylov.coupling *
                      ritz.vectors.bottomRows(krylov.coupling.cols()))
                       .colwise()
                       .norm();
          unsigned int n_converged = 0;
          for (Eigen::Index i = 0; i < n; ++i)
            if (is_wanted(ritz.values[i]) &&
                errors[i] <= options.tolerance * std::abs(ritz.values[i]))
              ++n_converged;
          // Nothing may remain that has not converged below the limit, and a
          // hidden mode must not keep the iteration going for ever.
          unsigned int n_seen = 0;
          for (Eigen::Index i = 0; i < n; ++i)
            if (const double theta = ritz.values[i];
                is_wanted(theta) &&
                std::abs(theta) > 1e-9 / std::abs(inverse.shift()))
              ++n_seen;
          const bool stagnant = n_converged == n_seen && n > 3 * n_wanted + 200;
          if (n_converged >= n_wanted || whole || stagnant)
            return ritz_modes(pencil,
                              ritz,
                              errors,
                              std::move(own),
                              inverse.shift(),
                              options.tolerance);
        }
    }



    /** Modes pass whose products with M and K are diagonal to this; good ones
     * have 1e-7 and less. */
    constexpr double largest_coupling = 1e-4;

    /** Sets n_certified; throws where a mode below the limit is missing or is
     * none. */
    void
    certify(UndampedModes &modes, const Wanted &wanted, const RowSpace &space)
    {
      unsigned int n_below = 0;
      while (n_below < modes.omega_squared.size() &&
             modes.omega_squared[n_below] < wanted.limit)
        ++n_below;
      if (n_below != wanted.n)
        throw ComputationError(
          "the inertia of the factor proves " + std::to_string(wanted.n) +
          " modes below " +
          rounded_text(std::sqrt(wanted.limit) / (2. * M_PI), 6) +
          " Hz, but the Lanczos iteration found " + std::to_string(n_below) +
          ": tighten Eigenvalues/Mode tolerance");
      const double worst =
        worst_coupling(modes, n_below, std::abs(wanted.limit), space);
      if (!(worst <= largest_coupling))
        throw ComputationError(
          "the undamped modes are coupled by " + rounded_text(worst, 2) + " (" +
          rounded_text(largest_coupling, 1) +
          " is the most that passes): lower Eigenvalues/Highest frequency, of "
          "which " +
          std::to_string(n_below) + " modes lie below");
      modes.n_certified = n_below;
    }
  } // namespace



  void
  set_residuals(UndampedModes &modes, const RowSpace &space)
  {
    const Eigen::Index n  = modes.shapes.cols();
    const auto         MX = modes.mass_products.leftCols(n);
    const auto         KX = modes.stiffness_products.leftCols(n);
    modes.residual =
      space.norms(Block(KX - MX * modes.omega_squared.asDiagonal())).array() /
      (space.norms(Block(KX)).array() +
       modes.omega_squared.array().abs() * space.norms(Block(MX)).array());
  }



  UndampedModes
  undamped_modes(const Pencil         &pencil,
                 const ShiftedInverse &inverse,
                 const ModeOptions    &options)
  {
    const Wanted  wanted = {inverse.shift(), inverse.n_modes_below()};
    UndampedModes modes  = options.algorithm == ModeAlgorithm::arpack
                             ? arpack_modes(pencil, inverse, options)
                             : block_lanczos(pencil, inverse, options, wanted);
    certify(modes, wanted, *pencil.space());
    return modes;
  }



  UndampedModes
  undamped_modes(const Pencil      &pencil,
                 const double       limit,
                 const ModeOptions &options)
  {
    const auto wanted = [&]() -> Wanted {
      const ShiftedInverse end(pencil, limit);
      return {end.shift(), end.n_modes_below()};
    }();
    const ShiftedInverse inverse(pencil, 0.5 * wanted.limit);
    UndampedModes modes = block_lanczos(pencil, inverse, options, wanted);
    certify(modes, wanted, *pencil.space());
    return modes;
  }
} // namespace squeal
