// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/eigen/dense_quadratic.h>
#include <squeal/eigen/dense_quadratic_of_band.h>
#include <squeal/eigen/dense_scaling.h>
#include <squeal/eigen/standard_pairs.h>

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <complex>
#include <vector>

namespace squeal
{
  namespace
  {
    using Complex = std::complex<double>;

    Eigen::MatrixXd
    sum(const std::vector<ReducedPart> &parts,
        double (*coefficient)(const TermCoefficients &))
    {
      const Eigen::Index n      = parts.front().matrix.rows();
      Eigen::MatrixXd    result = Eigen::MatrixXd::Zero(n, n);
      for (const auto &part : parts)
        if (const double c = coefficient(part.coefficients); c != 0.)
          result += c * part.matrix;
      return result;
    }

    double
    mass_of(const TermCoefficients &c)
    {
      return c.mass;
    }
    double
    damping_of(const TermCoefficients &c)
    {
      return c.damping;
    }
    double
    stiffness_of(const TermCoefficients &c)
    {
      return c.stiffness.real();
    }
    double
    loss_of(const TermCoefficients &c)
    {
      return c.stiffness.imag();
    }



    /** Of |lambda|, and of the size of the wanted ones: an imaginary part that
     * rounding makes of two real eigenvalues that are one number. */
    constexpr double rounding_of_real = 1e-11, rounding_of_size = 1e-14;

    /** The eigenvalues of real matrices, among which equal real ones are not a
     * pair of conjugates: of that only one would be kept. */
    std::vector<Complex>
    of_real_matrices(std::vector<Complex> lambda, const double size)
    {
      for (Complex &l : lambda)
        if (std::abs(l.imag()) <=
            rounding_of_real * std::abs(l) + rounding_of_size * size)
          l.imag(0.);
      return lambda;
    }

    /** Each pair of conjugates once, ascending in frequency. */
    DensePairs
    select(const std::vector<Complex> &lambda,
           const std::vector<int>     &column,
           const Eigen::MatrixXcd     &right,
           const Eigen::MatrixXcd     &left)
    {
      std::vector<std::size_t> kept;
      for (std::size_t i = 0; i < lambda.size(); ++i)
        if (lambda[i].imag() >= 0.)
          kept.push_back(i);
      std::sort(kept.begin(), kept.end(), [&](const auto a, const auto b) {
        return std::make_pair(lambda[a].imag(), lambda[a].real()) <
               std::make_pair(lambda[b].imag(), lambda[b].real());
      });
      DensePairs result;
      result.lambda.resize(kept.size());
      result.right.resize(right.rows(), kept.size());
      result.left.resize(left.rows(), kept.size());
      for (std::size_t k = 0; k < kept.size(); ++k)
        {
          const Complex l     = lambda[kept[k]];
          result.lambda[k]    = {l.real(), std::abs(l.imag())}; // no -0
          result.right.col(k) = right.col(column[kept[k]]).normalized();
          result.left.col(k)  = left.col(column[kept[k]]).normalized();
        }
      return result;
    }

    template <typename Matrix>
    constexpr bool has_real_entries =
      std::is_same<typename Matrix::Scalar, double>::value;

    /** A^-T B. */
    template <typename Matrix>
    Eigen::MatrixXcd
    solve_transposed(const Eigen::PartialPivLU<Matrix> &factor,
                     const Eigen::MatrixXcd            &B)
    {
      if constexpr (has_real_entries<Matrix>)
        {
          Eigen::MatrixXd both(B.rows(), 2 * B.cols());
          both << B.real(), B.imag();
          const Eigen::MatrixXd x = factor.transpose().solve(both);
          Eigen::MatrixXcd      result(B.rows(), B.cols());
          result.real() = x.leftCols(B.cols());
          result.imag() = x.rightCols(B.cols());
          return result;
        }
      else
        return factor.transpose().solve(B);
    }



    /** (K + kappa_0 M)^-1 M with eigenvalues nu = 1 / (kappa + kappa_0): the
     * wanted kappa are the largest nu. */
    template <typename Matrix>
    struct Inverted
    {
      Inverted(const Matrix &K, const Eigen::MatrixXd &M, const double highest)
        : kappa_0(typical_kappa(K.real(), M, least_kappa(highest)))
      {
        using Scalar   = typename Matrix::Scalar;
        const Matrix A = K + (kappa_0 * M).template cast<Scalar>();
        D              = unit_diagonal_scales(A.cwiseAbs());
        factor.compute(Matrix(D.asDiagonal() * A * D.asDiagonal()));
        matrix = factor.solve(Matrix(
          (D.asDiagonal() * M * D.asDiagonal()).template cast<Scalar>()));
      }

      const double                kappa_0;
      Eigen::VectorXd             D; /**< scales of the unknowns */
      Eigen::PartialPivLU<Matrix> factor;
      Matrix                      matrix;
    };



    /** Both lambda of each kappa; a conjugate pair of kappa gives, with the
     * signs taken here, both members of the pair with Im lambda > 0. */
    template <typename Matrix>
    DensePairs
    solve_rayleigh(const Matrix          &K,
                   const Eigen::MatrixXd &M,
                   const double           alpha,
                   const double           beta,
                   const double           highest)
    {
      const Inverted<Matrix> inverted(K, M, highest);
      const StandardPairs    pairs = standard_pairs(inverted.matrix);
      const Eigen::MatrixXcd right = inverted.D.asDiagonal() * pairs.right;
      const Eigen::MatrixXcd left =
        inverted.D.asDiagonal() * solve_transposed(inverted.factor, pairs.left);
      std::vector<Complex> lambda;
      std::vector<int>     column;
      for (Eigen::Index i = 0; i < pairs.values.size(); ++i)
        {
          if (pairs.values[i] == 0.)
            continue; // a direction without mass
          const Complex kappa = 1. / pairs.values[i] - inverted.kappa_0;
          const Complex b     = alpha + beta * kappa;
          const Complex root  = std::sqrt(b * b - 4. * kappa);
          // The larger root first, the other from the product: no cancellation.
          const Complex big =
            -0.5 * (b + (std::real(std::conj(b) * root) >= 0. ? root : -root));
          lambda.push_back(big);
          lambda.push_back(big == 0. ? 0. : kappa / big);
          column.insert(column.end(), 2, i);
        }
      return select(has_real_entries<Matrix>
                      ? of_real_matrices(lambda, std::sqrt(inverted.kappa_0))
                      : lambda,
                    column,
                    right,
                    left);
    }



    /** With lambda = s + 1 / theta, s real and of the size of the wanted
     * frequencies: theta^2 Q(s) + theta Q'(s) + M = 0, linearised. */
    template <typename Matrix>
    struct Companion
    {
      Companion(const Matrix          &K,
                const Eigen::MatrixXd &M,
                const Eigen::MatrixXd &C,
                const double           highest)
        : s(std::sqrt(typical_kappa(K.real(), M, least_kappa(highest))))
      {
        using Scalar         = typename Matrix::Scalar;
        const Eigen::Index n = M.rows();
        const Matrix       Q = K + (s * C + s * s * M).template cast<Scalar>();
        D                    = unit_diagonal_scales(Q.cwiseAbs());
        const auto scaled    = [&](const auto &X) {
          return Matrix(D.asDiagonal() * X.template cast<Scalar>() *
                        D.asDiagonal());
        };
        factor.compute(scaled(Q));
        // theta = t / s balances the blocks.
        matrix                        = Matrix::Zero(2 * n, 2 * n);
        matrix.topRightCorner(n, n)   = Matrix::Identity(n, n);
        matrix.bottomLeftCorner(n, n) = -s * s * factor.solve(scaled(M));
        matrix.bottomRightCorner(n, n) =
          -s * factor.solve(scaled(Eigen::MatrixXd(C + 2. * s * M)));
      }

      const double                s;
      Eigen::VectorXd             D; /**< scales of the unknowns */
      Eigen::PartialPivLU<Matrix> factor;
      Matrix                      matrix;
    };

    template <typename Matrix>
    DensePairs
    solve_companion(const Matrix          &K,
                    const Eigen::MatrixXd &M,
                    const Eigen::MatrixXd &C,
                    const double           highest)
    {
      const Companion<Matrix> companion(K, M, C, highest);
      const Eigen::Index      n     = M.rows();
      const StandardPairs     pairs = standard_pairs(companion.matrix);
      const Eigen::MatrixXcd  right =
        companion.D.asDiagonal() * pairs.right.topRows(n);
      const Eigen::MatrixXcd left =
        companion.D.asDiagonal() *
        solve_transposed(companion.factor, pairs.left.bottomRows(n));
      std::vector<Complex> lambda;
      std::vector<int>     column;
      for (Eigen::Index i = 0; i < 2 * n; ++i)
        if (pairs.values[i] != 0.)
          {
            lambda.push_back(companion.s + companion.s / pairs.values[i]);
            column.push_back(i);
          }
      return select(has_real_entries<Matrix>
                      ? of_real_matrices(lambda, companion.s)
                      : lambda,
                    column,
                    right,
                    left);
    }
  } // namespace



  DensePairs
  solve_dense_quadratic(const std::vector<ReducedPart> &parts,
                        const bool                      rayleigh,
                        const double                    alpha,
                        const double                    beta)
  {
    return solve_dense_quadratic_of_band(parts, rayleigh, alpha, beta, 0.);
  }

  DensePairs
  solve_dense_quadratic_of_band(const std::vector<ReducedPart> &parts,
                                const bool                      rayleigh,
                                const double                    alpha,
                                const double                    beta,
                                const double                    highest)
  {
    const Eigen::MatrixXd M = sum(parts, mass_of), C = sum(parts, damping_of),
                          K = sum(parts, stiffness_of);
    if (rayleigh)
      return solve_rayleigh<Eigen::MatrixXd>(K, M, alpha, beta, highest);
    const Eigen::MatrixXd H = sum(parts, loss_of);
    if (H.isZero(0.))
      return solve_companion<Eigen::MatrixXd>(K, M, C, highest);
    const Eigen::MatrixXcd complex_k =
      K.cast<Complex>() + Complex(0., 1.) * H.cast<Complex>();
    return C.isZero(0.)
             ? solve_rayleigh<Eigen::MatrixXcd>(complex_k, M, 0., 0., highest)
             : solve_companion<Eigen::MatrixXcd>(complex_k, M, C, highest);
  }



  namespace
  {
    /** Growth over |lambda| that is more than rounding. */
    constexpr double least_growth = 1e-4;
    /** Over the highest circular frequency of a band: |lambda| of what decays
     * and of what grows, up to which it is one of the band. */
    constexpr double largest_decaying = 2., largest_growing = 1e4;
  } // namespace

  bool
  is_between(const double f, const double lowest, const double highest)
  {
    constexpr double rounding = 1e-9;
    return f >= (1. - rounding) * lowest && f <= (1. + rounding) * highest;
  }

  bool
  is_of_band(const Complex lambda, const double lowest, const double highest)
  {
    return is_between(lambda.imag() / (2. * M_PI), lowest, highest) &&
           std::abs(lambda) <=
             (lambda.real() > 0. ? largest_growing : largest_decaying) * 2. *
               M_PI * highest;
  }

  bool
  grows_beyond_band(const Complex lambda, const double highest)
  {
    return lambda.real() > 0. &&
           std::abs(lambda) > largest_decaying * 2. * M_PI * highest;
  }

  std::complex<double>
  fastest_growth_below(const Eigen::VectorXcd &lambda,
                       const double            lowest,
                       const double            highest)
  {
    Complex fastest = 0.;
    for (const Complex l : lambda)
      if (l.imag() < lowest && std::abs(l) > share_of_rigid_motions * highest &&
          l.real() > std::max(least_growth * std::abs(l), fastest.real()))
        fastest = l;
    return fastest;
  }



  Eigen::Index
  n_eigenvalues_above(const Eigen::MatrixXd  &M,
                      const Eigen::MatrixXd  &C,
                      const Eigen::MatrixXcd &K,
                      const double            omega)
  {
    Eigen::Index n = 0;
    if (C.isZero(0.))
      {
        const Inverted<Eigen::MatrixXcd> inverted(K, M, omega);
        for (const Complex nu : standard_values(inverted.matrix))
          n += nu != 0. &&
               std::abs(std::sqrt(inverted.kappa_0 - 1. / nu).imag()) > omega;
        return n;
      }
    const Companion<Eigen::MatrixXcd> companion(K, M, C, omega);
    for (const Complex t : standard_values(companion.matrix))
      n += t != 0. && (companion.s + companion.s / t).imag() > omega;
    return n;
  }
} // namespace squeal
