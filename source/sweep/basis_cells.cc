// SPDX-License-Identifier: LGPL-2.1-or-later

// The cells of a parameter box and the part of the common basis each needs.

#include <squeal/base/worst_of.h>
#include <squeal/eigen/certified_solver.h>
#include <squeal/eigen/free_motion.h>
#include <squeal/sweep/basis_builder.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <limits>

namespace squeal
{
  namespace
  {
    /** Directions of a cell that shift its eigenvalues by less, relative, are
     * left out. */
    constexpr double cell_floor = 1e-13;
    /** Of the lower end of the band, below which snapshots count alike. */
    constexpr double least_of_band = 0.01;

    constexpr unsigned int most_cells = 64;

    /** Bases that are tried: from the first in such steps. */
    constexpr unsigned int smallest_basis = 16, basis_step = 4;

    /** Of all of [V W], times the condition of the pair: well below the
     * smallest errors that an estimate is to tell. */
    constexpr double judge_accuracy = 2e-11;

    /** Errors of pairs against the true ones of a wider band; infinite where
     * one is missing. */
    WorstError
    error_of(ComplexPairs        pairs,
             const ComplexPairs &truth,
             const SweepPoint   &point,
             const Band         &band)
    {
      unsigned int n_inside = 0;
      for (unsigned int i = 0; i < truth.size(); ++i)
        n_inside += truth.frequency(i) > (1. + 1e-4) * band.lowest &&
                    truth.frequency(i) < (1. - 1e-4) * band.highest;
      WorstError worst;
      if (pairs.size() < n_inside)
        {
          worst.frequency = worst.sigma = worst.relative =
            std::numeric_limits<double>::infinity();
          return worst;
        }
      estimate_errors(pairs, truth.lambda);
      add_to_worst(pairs, point, worst);
      worst.relative =
        worst_of(pairs.error_estimate.array() / pairs.condition.array());
      return worst;
    }
  } // namespace



  double
  excess(const WorstError &worst, const BasisOptions &options)
  {
    return worst_of(worst.frequency / options.frequency_tolerance,
                    worst.sigma / options.sigma_tolerance);
  }



  void
  add_to_worst(const ComplexPairs &pairs,
               const SweepPoint   &point,
               WorstError         &worst)
  {
    for (unsigned int i = 0; i < pairs.size(); ++i)
      {
        // The share of the shift along either direction is not kept: all of it
        // counts for both.
        const double shift =
          pairs.error_estimate[i] * std::abs(pairs.lambda[i]);
        worst.relative = worst_of(worst.relative, pairs.error_estimate[i]);
        // Over |lambda|: overdamped motions have no frequency.
        if (is_worse(pairs.error_estimate[i], worst.frequency))
          {
            worst.frequency    = pairs.error_estimate[i];
            worst.frequency_at = point;
          }
        if (is_worse(shift, worst.sigma))
          {
            worst.sigma    = shift;
            worst.sigma_at = point;
          }
      }
  }



  std::vector<ModelCell>
  BasisBuilder::make_cells() const
  {
    const SweepGrid &grid = system.grid();
    const unsigned   d    = grid.n_axes();
    SweepPoint       low(d), high(d);
    for (unsigned int a = 0; a < d; ++a)
      {
        low[a]  = grid.lower(a);
        high[a] = grid.upper(a);
      }
    std::vector<unsigned int> n(d, 1);
    unsigned int              total = 1;
    for (unsigned int a = 0; a < d; ++a)
      {
        SweepPoint other = low;
        other[a]         = high[a];
        const double length =
          distance(system.coefficients(low), system.coefficients(other));
        // An axis that does not move the symmetric parts, friction, is halved.
        n[a] =
          length == 0.
            ? 2
            : std::max(1, static_cast<int>(length / options.cell_size + 0.5));
        n[a] = std::max(1u, std::min(n[a], most_cells / total));
        total *= n[a];
      }
    std::vector<ModelCell> cells;
    for (unsigned int c = 0; c < total; ++c)
      {
        ModelCell    cell;
        unsigned int rest = c;
        cell.lower = cell.upper = low;
        for (unsigned int a = 0; a < d; ++a)
          {
            const unsigned int i = rest % n[a];
            rest /= n[a];
            cell.lower[a] = low[a] + (high[a] - low[a]) * i / n[a];
            cell.upper[a] = low[a] + (high[a] - low[a]) * (i + 1) / n[a];
          }
        cells.push_back(cell);
      }
    return cells;
  }

  Eigen::MatrixXd
  BasisBuilder::energy_matrix(const SweepPoint &point) const
  {
    const double       omega        = 2. * M_PI * options.band.highest;
    const auto         coefficients = system.coefficients(point);
    const Eigen::Index N            = model.n_total();
    Eigen::MatrixXd    A            = Eigen::MatrixXd::Zero(N, N);
    // Friction's symmetric part is indefinite and far above the rest.
    for (std::size_t p = 0; p < coefficients.size(); ++p)
      if (symmetric[p])
        A += (coefficients[p].stiffness.real() +
              omega * omega * coefficients[p].mass) *
             model.parts[p];
    return 0.5 * (A + A.transpose());
  }

  double
  BasisBuilder::weight_of(const std::complex<double> lambda) const
  {
    // That of a free motion, 0 but for rounding, would count more than all the
    // rest. What is held counts in full, below the band as well: a basis that
    // holds a low mode in part has an eigenvalue for it inside the band.
    const double least = least_of_band * 2. * M_PI * options.band.lowest;
    return 1. / std::max(std::abs(lambda), least);
  }

  std::vector<unsigned int>
  BasisBuilder::training_near(const ModelCell &cell) const
  {
    std::vector<unsigned int> own;
    for (double margin = 0.25;
         own.size() < std::min<std::size_t>(10, training.size());
         margin *= 1.5)
      {
        own.clear();
        for (unsigned int i = 0; i < training.size(); ++i)
          if (cell.contains(training[i], margin))
            own.push_back(i);
      }
    return own;
  }

  Eigen::MatrixXd
  BasisBuilder::free_motions(const SweepPoint &point) const
  {
    const double       omega = 2. * M_PI * options.band.highest;
    const ReducedModes modes = reduced_modes(
      model.parts, system.coefficients(point), symmetric, omega * omega);
    std::vector<Eigen::Index> kept;
    for (Eigen::Index i = 0; i < modes.omega_squared.size(); ++i)
      if (is_free_motion(modes.omega_squared[i], omega * omega))
        kept.push_back(i);
    return modes.shapes(Eigen::all, kept);
  }

  Eigen::MatrixXd
  BasisBuilder::directions_of(const ModelCell                 &cell,
                              const std::vector<unsigned int> &own,
                              const double                     floor) const
  {
    // Right and left vectors all over the cell and its surroundings, the most
    // needed directions first: in the energy a direction counts by the shift
    // of the eigenvalue that it causes.
    const unsigned int                N      = model.n_total();
    const SweepPoint                  middle = 0.5 * (cell.lower + cell.upper);
    const Eigen::LLT<Eigen::MatrixXd> energy(energy_matrix(middle));
    const Eigen::MatrixXd             L = energy.matrixL();
    // What nothing holds comes first and whole: of a defective pair at 0 Hz
    // the snapshots hold what rounding left.
    const Eigen::MatrixXd free = L.transpose() * free_motions(middle);
    const Eigen::Index    m    = free.cols();
    Eigen::MatrixXd       Q    = Eigen::MatrixXd::Identity(N, m);
    if (m > 0)
      Q = Eigen::HouseholderQR<Eigen::MatrixXd>(free).householderQ() * Q;
    Eigen::MatrixXd gram = Eigen::MatrixXd::Zero(N, N);
    for (const unsigned int i : own)
      {
        const ComplexPairs &pairs = snapshots[i];
        Eigen::MatrixXd     X(N, 4 * pairs.size());
        X << pairs.right.real(), pairs.right.imag(), pairs.left.real(),
          pairs.left.imag();
        for (unsigned int j = 0; j < pairs.size(); ++j)
          for (unsigned int k = 0; k < 4; ++k)
            X.col(k * pairs.size() + j) *= weight_of(pairs.lambda[j]);
        X = (L.transpose() * X).eval();
        X -= Q * (Q.transpose() * X).eval();
        gram += X * X.transpose();
      }
    // Kept apart from the rest to rounding.
    gram -= Q * (Q.transpose() * gram).eval();
    gram -= (gram * Q).eval() * Q.transpose();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> pod(gram);
    Eigen::Index                                         n_kept = 0;
    while (n_kept < N - m && pod.eigenvalues()[N - 1 - n_kept] > floor)
      ++n_kept;
    Eigen::MatrixXd U(N, m + n_kept);
    U << Q, pod.eigenvectors().rightCols(n_kept).rowwise().reverse();
    const Eigen::MatrixXd Phi =
      L.transpose().triangularView<Eigen::Upper>().solve(U);
    return Eigen::HouseholderQR<Eigen::MatrixXd>(Phi).householderQ() *
           Eigen::MatrixXd::Identity(N, U.cols());
  }

  bool
  BasisBuilder::choose_sizes(ModelCell                       &cell,
                             const std::vector<unsigned int> &own) const
  {
    result.project(cell);
    // Against what the common basis finds there, the last round included.
    const auto error = [&](const unsigned int n, const unsigned int i) {
      cell.local.n_basis = n;
      return error_of(solve_point_in_basis(cell.local,
                                           system.coefficients(training[i]),
                                           options.band),
                      snapshots[i],
                      training[i],
                      options.band);
    };
    // Not monotone in n: what friction makes of a direction of the contact that
    // V holds in part may have an eigenvalue anywhere.
    const unsigned int n_kept = cell.turn.cols();
    const auto smallest = [&](const unsigned int from, const auto &is_enough) {
      unsigned int n = std::min(from, n_kept);
      while (!std::all_of(own.begin(), own.end(), [&](const unsigned int i) {
        return is_enough(error(n, i));
      }))
        {
          if (n == n_kept)
            return n_kept + 1;
          n = std::min(n + basis_step, n_kept);
        }
      return n;
    };
    const unsigned int n =
      smallest(smallest_basis, [&](const WorstError &worst) {
        return excess(worst, options) <= options.safety;
      });
    if (n > n_kept)
      return false;
    const unsigned int n_total =
      smallest(n + basis_step, [&](const WorstError &worst) {
        return worst.relative <= judge_accuracy;
      });
    cell.turn.conservativeResize(Eigen::NoChange, std::min(n_total, n_kept));
    cell.local.n_basis = n;
    // A W that is short of its accuracy still judges V; with nothing in it the
    // error would be stated as 0.
    return n < n_kept;
  }

  void
  BasisBuilder::fit_cell(ModelCell &cell) const
  {
    const Eigen::Index              N   = model.n_total();
    const std::vector<unsigned int> own = training_near(cell);
    // All of them where the needed ones do not suffice. There W may be short
    // of its accuracy, which is of rounding then, but not empty: what it holds
    // is what V is judged by, unless V is all there is.
    const bool is_all = rounds.back().basis_size == N;
    cell.turn         = directions_of(cell, own, cell_floor);
    if (!choose_sizes(cell, own))
      {
        cell.turn = directions_of(cell, own, -1.);
        choose_sizes(cell, own);
        if (cell.local.n_basis >= cell.turn.cols() && !is_all)
          {
            // The basis as it was before the last round, and that round.
            cell.turn          = Eigen::MatrixXd::Identity(N, N);
            cell.local.n_basis = rounds.back().basis_size;
          }
      }
    // Anew, not cut: products of another size round in another way, and a run
    // that reads this cell has the same bits.
    result.project(cell);
  }
} // namespace squeal
