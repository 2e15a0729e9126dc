// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/eigen/certified_solver.h>
#include <squeal/eigen/dense_quadratic.h>
#include <squeal/sweep/point_solver.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace squeal
{
  namespace
  {
    using Complex = std::complex<double>;

    /** Conditions from which neighbours are shifted together. */
    constexpr double close_condition = 30.;

    /** A Z with A real. */
    Eigen::MatrixXcd
    times(const Eigen::Ref<const Eigen::MatrixXd> &A, const Eigen::MatrixXcd &Z)
    {
      Eigen::MatrixXd both(Z.rows(), 2 * Z.cols());
      both << Z.real(), Z.imag();
      const Eigen::MatrixXd product = A * both;
      Eigen::MatrixXcd      result(A.rows(), Z.cols());
      result.real() = product.leftCols(Z.cols());
      result.imag() = product.rightCols(Z.cols());
      return result;
    }

    /** Blocks of M, C, K, H of the same place. */
    struct Blocks
    {
      Eigen::MatrixXd M, C, K, H;

      /** Q(lambda_j) z_j for every column. */
      Eigen::MatrixXcd
      apply(const Eigen::VectorXcd &lambda, const Eigen::MatrixXcd &Z) const
      {
        Eigen::MatrixXcd result =
          times(K, Z) + times(C, Z) * lambda.asDiagonal() +
          times(M, Z) * lambda.cwiseProduct(lambda).asDiagonal();
        if (H.size() > 0)
          result += Complex(0., 1.) * times(H, Z);
        return result;
      }
    };

    Blocks
    blocks(const PointMatrices &p,
           const unsigned int   row,
           const unsigned int   column,
           const unsigned int   n_rows,
           const unsigned int   n_columns,
           const bool           transposed = false)
    {
      const auto part = [&](const Eigen::MatrixXd &A) -> Eigen::MatrixXd {
        if (A.size() == 0)
          return A;
        const auto block = A.block(row, column, n_rows, n_columns);
        return transposed ? Eigen::MatrixXd(block.transpose())
                          : Eigen::MatrixXd(block);
      };
      return {part(p.M), part(p.C), part(p.K), part(p.H)};
    }

    DensePairs
    dense_pairs(const PointMatrices &p, const unsigned int n)
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
      return solve_dense_quadratic(parts, p.rayleigh, p.alpha, p.beta);
    }



    /** Pairs of the band with conditions; vectors scaled to y^T Q' x = 2
     * lambda where that is possible. */
    ComplexPairs
    band_pairs(const PointMatrices &p, const unsigned int n, const Band &band)
    {
      const DensePairs dense = dense_pairs(p, n);
      std::vector<int> kept;
      for (Eigen::Index i = 0; i < dense.lambda.size(); ++i)
        {
          // Overdamped motions far beyond the band pass through it.
          const double f = dense.lambda[i].imag() / (2. * M_PI);
          if (f >= band.lowest && f <= band.highest &&
              std::abs(dense.lambda[i]) <= 4. * M_PI * band.highest)
            kept.push_back(i);
        }
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
        pairs.noise_floor                  = Eigen::VectorXd::Zero(k);
      pairs.condition.resize(k);
      pairs.pair_partner.assign(k, -1);
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
          pairs.condition[j] = 2. * std::abs(pairs.lambda[j]) * mass_x *
                               mass_y / std::max(std::abs(d), 1e-300);
        }
      return pairs;
    }



    /** What W adds: z = Q_WW^-1 r of the right vectors, of the left ones on
     * request, and D = l^T z: entry (a, b) has l of pair a and z of pair b. */
    struct Complement
    {
      Eigen::MatrixXcd right, left, D;
    };

    Complement
    complement(const PointMatrices &p,
               const unsigned int   n,
               const ComplexPairs  &pairs,
               const bool           with_left)
    {
      const unsigned int     w  = p.M.rows() - n;
      const Blocks           WV = blocks(p, n, 0, w, n);
      const Blocks           VW = blocks(p, 0, n, n, w, true);
      const Blocks           WW = blocks(p, n, n, w, w);
      const Eigen::MatrixXcd r  = WV.apply(pairs.lambda, pairs.right);
      const Eigen::MatrixXcd l  = VW.apply(pairs.lambda, pairs.left);
      // One real factor at the middle of the pairs' frequencies; W is far above
      // them, so a few corrections do.
      double centre = 0.;
      for (Eigen::Index j = 0; j < pairs.lambda.size(); ++j)
        centre += std::norm(pairs.lambda[j]) / pairs.lambda.size();
      const Eigen::PartialPivLU<Eigen::MatrixXd> factor(WW.K - centre * WW.M);
      const auto solve = [&](const Eigen::MatrixXcd &b, const bool transposed) {
        Eigen::MatrixXd both(b.rows(), 2 * b.cols());
        both << b.real(), b.imag();
        const Eigen::MatrixXd x =
          transposed ? Eigen::MatrixXd(factor.transpose().solve(both))
                     : Eigen::MatrixXd(factor.solve(both));
        Eigen::MatrixXcd result(b.rows(), b.cols());
        result.real() = x.leftCols(b.cols());
        result.imag() = x.rightCols(b.cols());
        return result;
      };
      Complement result;
      result.right = solve(r, false);
      for (unsigned int i = 0; i < 2; ++i)
        result.right += solve(r - WW.apply(pairs.lambda, result.right), false);
      result.D = l.transpose() * result.right;
      if (with_left)
        {
          const Blocks WWt = blocks(p, n, n, w, w, true);
          result.left      = solve(l, true);
          for (unsigned int i = 0; i < 2; ++i)
            result.left +=
              solve(l - WWt.apply(pairs.lambda, result.left), true);
        }
      return result;
    }

    int
    neighbour(const Eigen::VectorXcd &lambda, const Eigen::Index a)
    {
      int    best     = -1;
      double distance = 1e300;
      for (Eigen::Index b = 0; b < lambda.size(); ++b)
        if (b != a && std::abs(lambda[b] - lambda[a]) < distance)
          {
            best     = b;
            distance = std::abs(lambda[b] - lambda[a]);
          }
      return best;
    }

    /** Eigenvalues with the shifts by W. */
    Eigen::VectorXcd
    shifted_eigenvalues(const PointMatrices    &p,
                        const unsigned int      n,
                        const ComplexPairs     &pairs,
                        const Eigen::MatrixXcd &D)
    {
      const Eigen::MatrixXcd Mx = times(p.M.topLeftCorner(n, n), pairs.right);
      const Eigen::MatrixXcd Cx = times(p.C.topLeftCorner(n, n), pairs.right);
      Eigen::VectorXcd       d(pairs.size()), better = pairs.lambda;
      for (unsigned int a = 0; a < pairs.size(); ++a)
        d[a] = (pairs.left.col(a).transpose() *
                (2. * pairs.lambda[a] * Mx.col(a) + Cx.col(a)))(0);
      for (unsigned int a = 0; a < pairs.size(); ++a)
        {
          better[a] += D(a, a) / d[a];
          const int b = neighbour(pairs.lambda, a);
          if (b < 0 || pairs.condition[a] < close_condition)
            continue;
          Eigen::Matrix2cd B;
          B << pairs.lambda[a] + D(a, a) / d[a], D(a, b) / d[a], D(b, a) / d[b],
            pairs.lambda[b] + D(b, b) / d[b];
          const Complex mean = 0.5 * B.trace();
          const Complex half = 0.5 * (B(0, 0) - B(1, 1));
          const Complex root = std::sqrt(half * half + B(0, 1) * B(1, 0));
          better[a]          = std::abs(mean + root - pairs.lambda[a]) <
                          std::abs(mean - root - pairs.lambda[a])
                                 ? mean + root
                                 : mean - root;
        }
      return better;
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
        if (c.mass == 0. && c.damping == 0. && c.stiffness == 0.)
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
    const Complement c = complement(p, n, pairs, corrected);
    estimate_errors(pairs, shifted_eigenvalues(p, n, pairs, c.D));
    if (corrected)
      {
        ComplexBlock right(N, pairs.size()), left(N, pairs.size());
        right << pairs.right, -c.right;
        left << pairs.left, -c.left;
        pairs.right = right;
        pairs.left  = left;
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
      with_estimates
              ? solve_point(cell.local, coefficients, band)
              : band_pairs(PointMatrices(cell.local, coefficients, n), n, band);
    const auto V = cell.turn.leftCols(n);
    pairs.right  = times(V, pairs.right);
    pairs.left   = times(V, pairs.left);
    return pairs;
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
