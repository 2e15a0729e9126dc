// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/eigen/standard_pairs.h>

#include <complex>
#include <string>
#include <vector>

// deal.II declares these too, but its BLAS declarations contradict Eigen's.
extern "C"
{
  void dgeevx_(const char *balance,
               const char *left,
               const char *right,
               const char *sense,
               const int  *n,
               double     *A,
               const int  *stride,
               double     *real_parts,
               double     *imaginary_parts,
               double     *L,
               const int  *left_stride,
               double     *R,
               const int  *right_stride,
               int        *first,
               int        *last,
               double     *scale,
               double     *norm,
               double     *value_condition,
               double     *vector_condition,
               double     *work,
               const int  *n_work,
               int        *whole_work,
               int        *info);
  void zgeevx_(const char           *balance,
               const char           *left,
               const char           *right,
               const char           *sense,
               const int            *n,
               std::complex<double> *A,
               const int            *stride,
               std::complex<double> *values,
               std::complex<double> *L,
               const int            *left_stride,
               std::complex<double> *R,
               const int            *right_stride,
               int                  *first,
               int                  *last,
               double               *scale,
               double               *norm,
               double               *value_condition,
               double               *vector_condition,
               std::complex<double> *work,
               const int            *n_work,
               double               *real_work,
               int                  *info);
}

namespace squeal
{
  namespace
  {
    using Complex = std::complex<double>;

    /** Calls @p geevx (workspace, its size, info): first for the size, then for
     * the pairs. */
    template <typename Number, typename Function>
    void
    with_workspace(const Function &geevx)
    {
      Number best = 0.;
      int    size = -1, info = 0;
      geevx(&best, &size, &info);
      size = static_cast<int>(std::real(best));
      std::vector<Number> work(size);
      geevx(work.data(), &size, &info);
      if (info != 0)
        throw ComputationError("LAPACK's eigen-solver failed on the reduced "
                               "problem (info = " +
                               std::to_string(info) +
                               "): a parameter is out of all proportion");
    }

    /** LAPACK may never come back from a matrix that holds NaN. */
    template <typename Matrix>
    void
    refuse_infinite(const Matrix &A)
    {
      if (!A.allFinite())
        throw ComputationError("the matrix of a reduced eigenvalue problem "
                               "holds a number that is not finite: a "
                               "parameter is out of all proportion");
    }

    /** What both drivers give back beside the pairs. */
    struct Balance
    {
      explicit Balance(const int n)
        : scale(n)
        , vector_condition(n)
      {
      }

      int                 first = 0, last = 0;
      double              norm = 0.;
      std::vector<double> scale, vector_condition;
    };

    StandardPairs
    empty_pairs(const Eigen::Index n)
    {
      StandardPairs result;
      result.values.resize(n);
      result.right.resize(n, n);
      result.left.resize(n, n);
      result.reciprocal_condition.resize(n);
      return result;
    }

    /** Complex vectors of the pairs of real columns that LAPACK packs them
     * in. LAPACK's left vectors u satisfy u^H A = mu u^H. */
    void
    unpack(const Eigen::VectorXd &re,
           const Eigen::VectorXd &im,
           const Eigen::MatrixXd &L,
           const Eigen::MatrixXd &R,
           StandardPairs         &result)
    {
      const Complex i(0., 1.);
      for (Eigen::Index j = 0; j < re.size(); ++j)
        {
          result.values[j] = {re[j], im[j]};
          if (!(im[j] > 0.))
            {
              result.right.col(j) = R.col(j).cast<Complex>();
              result.left.col(j)  = L.col(j).cast<Complex>();
              continue;
            }
          result.values[j + 1]    = {re[j], -im[j]};
          result.right.col(j)     = R.col(j) + i * R.col(j + 1);
          result.right.col(j + 1) = result.right.col(j).conjugate();
          result.left.col(j)      = L.col(j) - i * L.col(j + 1);
          result.left.col(j + 1)  = result.left.col(j).conjugate();
          ++j;
        }
    }
  } // namespace



  StandardPairs
  standard_pairs(Eigen::MatrixXd A)
  {
    const int     n      = static_cast<int>(A.rows());
    StandardPairs result = empty_pairs(n);
    if (n == 0)
      return result;
    refuse_infinite(A);
    Eigen::VectorXd  re(n), im(n);
    Eigen::MatrixXd  L(n, n), R(n, n);
    Balance          balance(n);
    std::vector<int> whole_work(2 * n);
    with_workspace<double>([&](double *work, const int *size, int *info) {
      dgeevx_("B",
              "V",
              "V",
              "E",
              &n,
              A.data(),
              &n,
              re.data(),
              im.data(),
              L.data(),
              &n,
              R.data(),
              &n,
              &balance.first,
              &balance.last,
              balance.scale.data(),
              &balance.norm,
              result.reciprocal_condition.data(),
              balance.vector_condition.data(),
              work,
              size,
              whole_work.data(),
              info);
    });
    unpack(re, im, L, R, result);
    return result;
  }



  StandardPairs
  standard_pairs(Eigen::MatrixXcd A)
  {
    const int     n      = static_cast<int>(A.rows());
    StandardPairs result = empty_pairs(n);
    if (n == 0)
      return result;
    refuse_infinite(A);
    Balance             balance(n);
    std::vector<double> real_work(2 * n);
    with_workspace<Complex>([&](Complex *work, const int *size, int *info) {
      zgeevx_("B",
              "V",
              "V",
              "E",
              &n,
              A.data(),
              &n,
              result.values.data(),
              result.left.data(),
              &n,
              result.right.data(),
              &n,
              &balance.first,
              &balance.last,
              balance.scale.data(),
              &balance.norm,
              result.reciprocal_condition.data(),
              balance.vector_condition.data(),
              work,
              size,
              real_work.data(),
              info);
    });
    result.left = result.left.conjugate().eval();
    return result;
  }



  Eigen::VectorXcd
  standard_values(Eigen::MatrixXcd A)
  {
    const int        n = static_cast<int>(A.rows()), one = 1;
    Eigen::VectorXcd values(n);
    if (n == 0)
      return values;
    refuse_infinite(A);
    Balance             balance(n);
    std::vector<double> real_work(2 * n), condition(n);
    Complex             no_vector;
    with_workspace<Complex>([&](Complex *work, const int *size, int *info) {
      zgeevx_("B",
              "N",
              "N",
              "N",
              &n,
              A.data(),
              &n,
              values.data(),
              &no_vector,
              &one,
              &no_vector,
              &one,
              &balance.first,
              &balance.last,
              balance.scale.data(),
              &balance.norm,
              condition.data(),
              balance.vector_condition.data(),
              work,
              size,
              real_work.data(),
              info);
    });
    return values;
  }
} // namespace squeal
