// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/dense_products.h>
#include <squeal/eigen/certified_solver.h>
#include <squeal/eigen/dense_quadratic_of_band.h>
#include <squeal/eigen/dense_scaling.h>
#include <squeal/eigen/eigenvalue_condition.h>
#include <squeal/sweep/point_solver.h>
#include <squeal/sweep/refined_pairs.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace squeal
{
  namespace
  {
    using Complex = std::complex<double>;

    DensePairs
    dense_pairs(const PointMatrices &p, const unsigned int n, const Band &band)
    {
      std::vector<ReducedPart> parts(3);
      parts[0] = {p.M.topLeftCorner(n, n), {1., 0., 0.}};
      parts[1] = {p.K.topLeftCorner(n, n), {0., 0., 1.}};
      if (p.rayleigh)
        parts.pop_back();
      else
        parts[2] = {p.C.topLeftCorner(n, n), {0., 1., 0.}};
      if (p.H.size() > 0)
        parts.push_back({p.H.topLeftCorner(n, n), {0., 0., Complex(0., 1.)}});
      return solve_dense_quadratic_of_band(
        parts, p.rayleigh, p.alpha, p.beta, 2. * M_PI * band.highest);
    }



    /** Of the entries of reduced matrices, relative, and the largest condition
     * that it is multiplied by: eigenvalues next to a coalescence are moved by
     * the root of rounding. */
    constexpr double rounding_of_entries      = 1e-14,
                     worst_rounding_condition = 1e8;

    /** Of the largest 1 / (kappa + kappa_0) that solve_dense_quadratic() finds,
     * which is next to 1 / kappa_0. */
    constexpr double rounding_of_solver = 2e-15;

    /** |y|^T (|lambda^2 M| + |lambda C| + |K|) |x| of each pair: what the
     * rounding of the entries is a share of. */
    Eigen::VectorXd
    rounding_sizes(const PointMatrices &p, const ComplexPairs &pairs)
    {
      const Eigen::Index    n = pairs.right.rows(), k = pairs.size();
      const Eigen::MatrixXd x = pairs.right.cwiseAbs(),
                            y = pairs.left.cwiseAbs();
      const auto size         = [&](const Eigen::MatrixXd &A) {
        return Eigen::VectorXd(
          y.cwiseProduct(A.topLeftCorner(n, n).cwiseAbs() * x)
            .colwise()
            .sum()
            .transpose());
      };
      if (k == 0)
        return Eigen::VectorXd();
      const Eigen::VectorXd l = pairs.lambda.cwiseAbs();
      Eigen::VectorXd       result =
        l.cwiseAbs2().cwiseProduct(size(p.M)) + size(p.K);
      if (!p.C.isZero(0.))
        result += l.cwiseProduct(size(p.C));
      if (p.H.size() > 0)
        result += size(p.H);
      return result;
    }



    /** Pairs of the band with conditions; vectors scaled to y^T Q' x = 2
     * lambda where that is possible. */
    ComplexPairs
    band_pairs(const PointMatrices &p, const unsigned int n, const Band &band)
    {
      const DensePairs dense = dense_pairs(p, n, band);
      std::vector<int> kept;
      for (Eigen::Index i = 0; i < dense.lambda.size(); ++i)
        if (is_of_band(dense.lambda[i], band.lowest, band.highest))
          kept.push_back(i);
      const Eigen::Index k = kept.size();
      ComplexPairs       pairs;
      pairs.lambda.resize(k);
      pairs.right.resize(n, k);
      pairs.left.resize(n, k);
      for (Eigen::Index j = 0; j < k; ++j)
        {
          pairs.lambda[j]    = dense.lambda[kept[j]];
          pairs.right.col(j) = dense.right.col(kept[j]);
          pairs.left.col(j)  = dense.left.col(kept[j]);
        }
      pairs.residual = pairs.left_residual = pairs.error_estimate =
        Eigen::VectorXd::Zero(k);
      pairs.noise_floor = Eigen::VectorXd::Zero(k);
      pairs.condition.resize(k);
      pairs.pair_partner.assign(k, -1);
      const Eigen::VectorXd sizes = rounding_sizes(p, pairs);
      const double          kappa_0 =
        typical_kappa(p.K.topLeftCorner(n, n),
                      p.M.topLeftCorner(n, n),
                      least_kappa(2. * M_PI * band.highest));
      const Eigen::MatrixXcd Mx = times(p.M.topLeftCorner(n, n), pairs.right);
      const Eigen::MatrixXcd My = times(p.M.topLeftCorner(n, n), pairs.left);
      const Eigen::MatrixXcd Cx = times(p.C.topLeftCorner(n, n), pairs.right);
      for (Eigen::Index j = 0; j < k; ++j)
        {
          const double mass_x =
            std::sqrt(pairs.right.col(j).dot(Mx.col(j)).real());
          const double mass_y =
            std::sqrt(pairs.left.col(j).dot(My.col(j)).real());
          const Complex d = (pairs.left.col(j).transpose() *
                             (2. * pairs.lambda[j] * Mx.col(j) + Cx.col(j)))(0);
          pairs.right.col(j) /= mass_x;
          pairs.left.col(j) /= mass_y;
          pairs.condition[j] =
            eigenvalue_condition(pairs.lambda[j], mass_x * mass_y, d);
          const double kappa = std::norm(pairs.lambda[j]);
          pairs.noise_floor[j] =
            std::min(pairs.condition[j], worst_rounding_condition) *
            std::max(rounding_of_entries * sizes[j] /
                       (mass_x * mass_y * std::max(kappa, 1e-300)),
                     rounding_of_solver * (1. + kappa / kappa_0));
        }
      return pairs;
    }
  } // namespace



  PointMatrices::PointMatrices(
    const LocalModel                    &model,
    const std::vector<TermCoefficients> &coefficients,
    const unsigned int                   n)
  {
    M = C = K       = Eigen::MatrixXd::Zero(n, n);
    rayleigh        = true;
    bool have_alpha = false, have_beta = false;
    for (std::size_t i = 0; i < coefficients.size(); ++i)
      {
        const TermCoefficients &c = coefficients[i];
        const auto              A = model.parts[i].topLeftCorner(n, n);
        const double            k = c.stiffness.real();
        if (c.mass != 0.)
          M += c.mass * A;
        if (c.damping != 0.)
          C += c.damping * A;
        if (k != 0.)
          K += k * A;
        if (c.stiffness.imag() != 0.)
          {
            if (H.size() == 0)
              H = Eigen::MatrixXd::Zero(n, n);
            H += c.stiffness.imag() * A;
          }
        if (c.is_zero())
          continue;
        if (c.stiffness.imag() != 0. || (c.mass != 0.) == (k != 0.))
          {
            rayleigh = false;
            continue;
          }
        const double value  = c.damping / (c.mass != 0. ? c.mass : k);
        double      &common = c.mass != 0. ? alpha : beta;
        bool        &have   = c.mass != 0. ? have_alpha : have_beta;
        if (have && std::abs(value - common) > 1e-12 * std::abs(common))
          rayleigh = false;
        common = value;
        have   = true;
      }
  }



  ComplexPairs
  solve_point(const LocalModel                    &model,
              const std::vector<TermCoefficients> &coefficients,
              const Band                          &band,
              const bool                           corrected)
  {
    const unsigned int  n = model.n_basis, N = model.n_total();
    const PointMatrices p(model, coefficients, N);
    ComplexPairs        pairs = band_pairs(p, n, band);
    if (pairs.size() == 0 || N == n)
      return pairs;
    const RefinedPairs refined = refine_pairs(p, pairs, corrected);
    estimate_errors(pairs, refined.lambda);
    if (corrected)
      {
        pairs.lambda = refined.lambda;
        pairs.right  = refined.right;
        pairs.left   = refined.left;
      }
    return pairs;
  }

  ComplexPairs
  solve_point(const ReducedModel                  &model,
              const Eigen::VectorXd               &point,
              const std::vector<TermCoefficients> &coefficients,
              const Band                          &band,
              const bool                           with_estimates)
  {
    const ModelCell   &cell = model.cell_of(point);
    const unsigned int n    = cell.local.n_basis;
    ComplexPairs       pairs =
      with_estimates ? solve_point(cell.local, coefficients, band)
                           : solve_point_in_basis(cell.local, coefficients, band);
    const auto V = cell.turn.leftCols(n);
    pairs.right  = times(V, pairs.right);
    pairs.left   = times(V, pairs.left);
    return pairs;
  }

  ComplexPairs
  solve_point_in_cell(const ReducedModel                  &model,
                      const Eigen::VectorXd               &point,
                      const std::vector<TermCoefficients> &coefficients,
                      const Band                          &band)
  {
    const ModelCell &cell = model.cell_of(point);
    ComplexPairs pairs    = solve_point_in_full(cell.local, coefficients, band);
    pairs.right           = times(cell.turn, pairs.right);
    pairs.left            = times(cell.turn, pairs.left);
    return pairs;
  }

  ComplexPairs
  solve_point_refined(const ReducedModel                  &model,
                      const Eigen::VectorXd               &point,
                      const std::vector<TermCoefficients> &coefficients,
                      const Band                          &band)
  {
    ComplexPairs pairs = solve_point(model, point, coefficients, band, false);
    const PointMatrices matrices(
      {model.parts, model.n_total()}, coefficients, model.n_total());
    const RefinedPairs refined = refine_pairs(matrices, pairs, true);
    estimate_errors(pairs, refined.lambda);
    pairs.lambda = refined.lambda;
    pairs.right  = refined.right;
    pairs.left   = refined.left;
    return pairs;
  }

  ComplexPairs
  solve_point_in_basis(const LocalModel                    &model,
                       const std::vector<TermCoefficients> &coefficients,
                       const Band                          &band)
  {
    const unsigned int n = model.n_basis;
    return band_pairs(PointMatrices(model, coefficients, n), n, band);
  }

  ComplexPairs
  solve_point_in_full(const LocalModel                    &model,
                      const std::vector<TermCoefficients> &coefficients,
                      const Band                          &band)
  {
    const unsigned int N = model.n_total();
    return band_pairs(PointMatrices(model, coefficients, N), N, band);
  }



  namespace
  {
    /** K and M of the parts that take part. */
    void
    symmetric_pencil(const std::vector<Eigen::MatrixXd>  &parts,
                     const std::vector<TermCoefficients> &coefficients,
                     const std::vector<bool>             &symmetric,
                     Eigen::MatrixXd                     &K,
                     Eigen::MatrixXd                     &M)
    {
      K = M = Eigen::MatrixXd::Zero(parts.front().rows(), parts.front().cols());
      for (std::size_t i = 0; i < parts.size(); ++i)
        if (symmetric[i])
          {
            K += coefficients[i].stiffness.real() * parts[i];
            M += coefficients[i].mass * parts[i];
          }
    }
  } // namespace

  ReducedModes
  reduced_modes(const std::vector<Eigen::MatrixXd>  &parts,
                const std::vector<TermCoefficients> &coefficients,
                const std::vector<bool>             &symmetric,
                const double                         omega_squared)
  {
    Eigen::MatrixXd K, M;
    symmetric_pencil(parts, coefficients, symmetric, K, M);
    // The largest 1 / (kappa + kappa_0): stiff contact directions must not
    // drown the wanted ones.
    const Eigen::MatrixXd A = K + omega_squared * M;
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solver(
      0.5 * (M + M.transpose()), 0.5 * (A + A.transpose()));
    const Eigen::Index N = K.rows();
    Eigen::Index       n = 0;
    while (n < N && solver.eigenvalues()[N - 1 - n] >= 0.5 / omega_squared)
      ++n;
    ReducedModes modes;
    modes.omega_squared.resize(n);
    modes.shapes.resize(N, n);
    for (Eigen::Index i = 0; i < n; ++i)
      {
        const double nu        = solver.eigenvalues()[N - 1 - i];
        modes.omega_squared[i] = 1. / nu - omega_squared;
        modes.shapes.col(i) =
          solver.eigenvectors().col(N - 1 - i) / std::sqrt(nu);
      }
    return modes;
  }

  unsigned int
  n_modes_below(const std::vector<Eigen::MatrixXd>  &parts,
                const std::vector<TermCoefficients> &coefficients,
                const std::vector<bool>             &symmetric,
                const double                         omega_squared)
  {
    Eigen::MatrixXd K, M;
    symmetric_pencil(parts, coefficients, symmetric, K, M);
    const Eigen::MatrixXd A = K - omega_squared * M;
    const Eigen::VectorXd s =
      A.diagonal().cwiseAbs().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(
      s.asDiagonal() * A * s.asDiagonal(), Eigen::EigenvaluesOnly);
    return (solver.eigenvalues().array() < 0.).count();
  }
} // namespace squeal
