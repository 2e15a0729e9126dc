// SPDX-License-Identifier: LGPL-2.1-or-later

// The cells of a parameter box and the part of the common basis each needs.

#include <squeal/sweep/basis_builder.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/QR>

#include <algorithm>

namespace squeal
{
  namespace
  {
    /** Directions of a cell that shift its eigenvalues by less, relative, are
     * left out. */
    constexpr double cell_floor = 1e-13;

    constexpr unsigned int most_cells = 64;
  } // namespace



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
        n[a] = std::max(1, static_cast<int>(length / options.cell_size + 0.5));
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

  void
  BasisBuilder::fit_cell(ModelCell &cell) const
  {
    // Right and left vectors all over the cell and its surroundings, the most
    // needed directions first: in the energy a direction counts by the shift
    // of the eigenvalue that it causes.
    const unsigned int        N    = model.n_total();
    Eigen::MatrixXd           gram = Eigen::MatrixXd::Zero(N, N);
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
    for (const unsigned int i : own)
      {
        const ComplexPairs &pairs = snapshots[i];
        Eigen::MatrixXd     X(N, 4 * pairs.size());
        X << pairs.right.real(), pairs.right.imag(), pairs.left.real(),
          pairs.left.imag();
        const Eigen::VectorXd weights =
          pairs.lambda.cwiseAbs().cwiseInverse().replicate(4, 1);
        gram += X * weights.cwiseProduct(weights).asDiagonal() * X.transpose();
      }
    const PointMatrices centre(
      model, system.coefficients(0.5 * (cell.lower + cell.upper)), N);
    const double    omega = 2. * M_PI * options.band.highest;
    Eigen::MatrixXd A     = centre.K + omega * omega * centre.M;
    A                     = 0.5 * (A + A.transpose()).eval();
    const Eigen::LLT<Eigen::MatrixXd>                    energy(A);
    const Eigen::MatrixXd                                L = energy.matrixL();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> pod(L.transpose() *
                                                             gram * L);
    Eigen::Index                                         n_kept = 0;
    while (n_kept < N && pod.eigenvalues()[N - 1 - n_kept] > cell_floor)
      ++n_kept;
    const Eigen::MatrixXd U =
      pod.eigenvectors().rightCols(n_kept).rowwise().reverse();
    const Eigen::MatrixXd Phi =
      L.transpose().triangularView<Eigen::Upper>().solve(U);
    const Eigen::HouseholderQR<Eigen::MatrixXd> qr(Phi);
    cell.turn = qr.householderQ() * Eigen::MatrixXd::Identity(N, n_kept);
    result.project(cell);

    const auto is_good = [&](const unsigned int n) {
      cell.local.n_basis = n;
      WorstError worst;
      for (const unsigned int i : own)
        {
          add_to_worst(solve_point(cell.local,
                                   system.coefficients(training[i]),
                                   options.band),
                       training[i],
                       worst);
          if (excess(worst, options) > options.safety)
            return false;
        }
      return true;
    };
    unsigned int low = 1, high = n_kept - 1;
    while (high - low > 1)
      {
        const unsigned int middle      = (low + high) / 2;
        (is_good(middle) ? high : low) = middle;
      }
    cell.local.n_basis = high;
  }
} // namespace squeal
