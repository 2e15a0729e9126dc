// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/eigen/dense_quadratic.h>

#include <Eigen/LU>

#include <cmath>
#include <complex>

extern "C"
{
  void dgeev_(const char *,
              const char *,
              const int *,
              double *,
              const int *,
              double *,
              double *,
              double *,
              const int *,
              double *,
              const int *,
              double *,
              const int *,
              int *);
  void zgeev_(const char *,
              const char *,
              const int *,
              std::complex<double> *,
              const int *,
              std::complex<double> *,
              std::complex<double> *,
              const int *,
              std::complex<double> *,
              const int *,
              std::complex<double> *,
              const int *,
              double *,
              int *);
}

namespace squeal
{
  namespace
  {
    using Complex = std::complex<double>;

    /** All eigenvalues of A with right vectors and left ones, w^T A = mu w^T.
     */
    struct StandardPairs
    {
      Eigen::VectorXcd values;
      Eigen::MatrixXcd right, left;
    };

    void
    check(const int info)
    {
      if (info != 0)
        throw ComputationError("LAPACK's eigen-solver failed on the reduced "
                               "problem (info = " +
                               std::to_string(info) +
                               "): a parameter is out of all proportion");
    }

    StandardPairs
    standard_pairs(Eigen::MatrixXd A)
    {
      const int       n = static_cast<int>(A.rows());
      Eigen::VectorXd re(n), im(n);
      Eigen::MatrixXd L(n, n), R(n, n);
      double          best = 0.;
      int             size = -1, info = 0;
      dgeev_("V",
             "V",
             &n,
             A.data(),
             &n,
             re.data(),
             im.data(),
             L.data(),
             &n,
             R.data(),
             &n,
             &best,
             &size,
             &info);
      size = static_cast<int>(best);
      std::vector<double> work(size);
      dgeev_("V",
             "V",
             &n,
             A.data(),
             &n,
             re.data(),
             im.data(),
             L.data(),
             &n,
             R.data(),
             &n,
             work.data(),
             &size,
             &info);
      check(info);
      StandardPairs result;
      result.values.resize(n);
      result.right.resize(n, n);
      result.left.resize(n, n);
      for (int j = 0; j < n; ++j)
        {
          result.values[j] = {re[j], im[j]};
          if (im[j] == 0.)
            {
              result.right.col(j) = R.col(j).cast<Complex>();
              result.left.col(j)  = L.col(j).cast<Complex>();
            }
          else if (im[j] > 0.)
            {
              // LAPACK's left vectors satisfy u^H A = mu u^H.
              result.values[j + 1]    = {re[j], -im[j]};
              result.right.col(j)     = R.col(j) + Complex(0, 1) * R.col(j + 1);
              result.right.col(j + 1) = result.right.col(j).conjugate();
              result.left.col(j)      = L.col(j) - Complex(0, 1) * L.col(j + 1);
              result.left.col(j + 1)  = result.left.col(j).conjugate();
              ++j;
            }
        }
      return result;
    }

    StandardPairs
    standard_pairs(Eigen::MatrixXcd A)
    {
      const int           n = static_cast<int>(A.rows());
      StandardPairs       result;
      Eigen::MatrixXcd    L(n, n), R(n, n);
      std::vector<double> real_work(2 * n);
      Complex             best = 0.;
      int                 size = -1, info = 0;
      result.values.resize(n);
      zgeev_("V",
             "V",
             &n,
             A.data(),
             &n,
             result.values.data(),
             L.data(),
             &n,
             R.data(),
             &n,
             &best,
             &size,
             real_work.data(),
             &info);
      size = static_cast<int>(best.real());
      std::vector<Complex> work(size);
      zgeev_("V",
             "V",
             &n,
             A.data(),
             &n,
             result.values.data(),
             L.data(),
             &n,
             R.data(),
             &n,
             work.data(),
             &size,
             real_work.data(),
             &info);
      check(info);
      result.right = R;
      result.left  = L.conjugate();
      return result;
    }



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



    DensePairs
    select(const Eigen::VectorXcd &lambda,
           const Eigen::MatrixXcd &right,
           const Eigen::MatrixXcd &left)
    {
      std::vector<Eigen::Index> kept;
      for (Eigen::Index i = 0; i < lambda.size(); ++i)
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
          result.lambda[k]    = lambda[kept[k]];
          result.right.col(k) = right.col(kept[k]).normalized();
          result.left.col(k)  = left.col(kept[k]).normalized();
        }
      return result;
    }



    /** lambda of each kappa; a conjugate pair of kappa gives, with the signs
     * taken here, both members of the pair with Im lambda > 0. */
    DensePairs
    solve_rayleigh(const std::vector<ReducedPart> &parts,
                   const double                    alpha,
                   const double                    beta)
    {
      const Eigen::MatrixXd                      M = sum(parts, mass_of);
      const Eigen::MatrixXd                      K = sum(parts, stiffness_of);
      const Eigen::PartialPivLU<Eigen::MatrixXd> factor(M);
      const StandardPairs                        pairs =
        standard_pairs(Eigen::MatrixXd(factor.solve(K)));
      const Eigen::Index     n = pairs.values.size();
      const Eigen::MatrixXcd left =
        M.transpose().cast<Complex>().partialPivLu().solve(pairs.left);
      Eigen::VectorXcd lambda(2 * n);
      Eigen::MatrixXcd right2(n, 2 * n), left2(n, 2 * n);
      for (Eigen::Index i = 0; i < n; ++i)
        {
          const Complex kappa = pairs.values[i];
          const Complex b     = alpha + beta * kappa;
          const Complex root  = std::sqrt(b * b - 4. * kappa);
          // The larger root first, the other from the product: no cancellation.
          const Complex big =
            -0.5 * (b + (std::real(std::conj(b) * root) >= 0. ? root : -root));
          const Complex small = big == 0. ? 0. : kappa / big;
          lambda[2 * i]       = big;
          lambda[2 * i + 1]   = small;
          for (const Eigen::Index j : {2 * i, 2 * i + 1})
            {
              right2.col(j) = pairs.right.col(i);
              left2.col(j)  = left.col(i);
            }
        }
      return select(lambda, right2, left2);
    }



    template <typename Matrix>
    DensePairs
    solve_companion(const Matrix          &K,
                    const Eigen::MatrixXd &M,
                    const Eigen::MatrixXd &C)
    {
      const Eigen::Index                         n = M.rows();
      const Eigen::PartialPivLU<Eigen::MatrixXd> factor(M);
      const auto                                 solve = [&](const Matrix &B) {
        using Scalar = typename Matrix::Scalar;
        return Matrix(M.template cast<Scalar>().partialPivLu().solve(B));
      };
      // lambda = scale mu balances the blocks.
      const double scale =
        std::sqrt(std::max(1e-300, K.norm() / std::max(1e-300, M.norm())));
      Matrix A                 = Matrix::Zero(2 * n, 2 * n);
      A.topRightCorner(n, n)   = Matrix::Identity(n, n);
      A.bottomLeftCorner(n, n) = -solve(K) / (scale * scale);
      A.bottomRightCorner(n, n) =
        -factor.solve(C).template cast<typename Matrix::Scalar>() / scale;
      const StandardPairs    pairs = standard_pairs(A);
      const Eigen::MatrixXcd left =
        M.transpose().cast<Complex>().partialPivLu().solve(
          pairs.left.bottomRows(n));
      return select(scale * pairs.values, pairs.right.topRows(n), left);
    }
  } // namespace



  DensePairs
  solve_dense_quadratic(const std::vector<ReducedPart> &parts,
                        const bool                      rayleigh,
                        const double                    alpha,
                        const double                    beta)
  {
    if (rayleigh)
      return solve_rayleigh(parts, alpha, beta);
    const Eigen::MatrixXd M = sum(parts, mass_of), C = sum(parts, damping_of),
                          K = sum(parts, stiffness_of);
    const Eigen::MatrixXd H = sum(parts, loss_of);
    if (H.isZero(0.))
      return solve_companion<Eigen::MatrixXd>(K, M, C);
    return solve_companion<Eigen::MatrixXcd>(
      K.cast<Complex>() + Complex(0., 1.) * H.cast<Complex>(), M, C);
  }
} // namespace squeal
