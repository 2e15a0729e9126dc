// SPDX-License-Identifier: LGPL-2.1-or-later
#include "dominant_eigenvalues.h"

#include <squeal/base/exceptions.h>

#include <Eigen/Eigenvalues>

#include <parpack.h>

#include <algorithm>
#include <string>
#include <vector>

namespace squeal
{
  namespace
  {
    using Complex = std::complex<double>;

    double _Complex *
    raw(Complex *pointer)
    {
      return reinterpret_cast<double _Complex *>(pointer);
    }

    /** znaupd's reverse communication in the plain mode with a given map. */
    void
    arnoldi(const LinearStep  &apply,
            const a_int        n,
            const a_int        nev,
            const a_int        ncv,
            const double       tolerance,
            const MPI_Fint     comm,
            const unsigned int first_row,
            Eigen::VectorXcd  &values,
            Eigen::MatrixXcd  &vectors)
    {
      Eigen::VectorXcd     residual(n), work(3 * n);
      Eigen::MatrixXcd     V(n, ncv);
      std::vector<Complex> small(3 * ncv * ncv + 5 * ncv);
      // PARPACK's header declares the real work array as complex.
      std::vector<Complex> real_work(ncv);
      for (a_int i = 0; i < n; ++i)
        residual[i] = {1. + 0.5 * std::sin(1.7 * (first_row + i)),
                       0.3 * std::cos(2.3 * (first_row + i))};
      a_int parameters[11]{}, pointers[14]{}, ido = 0, info = 1;
      parameters[0] = 1;
      parameters[2] = 300;
      parameters[3] = 1;
      parameters[6] = 1;
      while (true)
        {
          pznaupd_c(comm,
                    &ido,
                    "I",
                    n,
                    "LM",
                    nev,
                    tolerance,
                    raw(residual.data()),
                    ncv,
                    raw(V.data()),
                    n,
                    parameters,
                    pointers,
                    raw(work.data()),
                    raw(small.data()),
                    static_cast<a_int>(small.size()),
                    raw(real_work.data()),
                    &info);
          if (ido == 99)
            break;
          Eigen::Map<Eigen::VectorXcd>(work.data() + pointers[1] - 1, n) =
            apply(
              Eigen::Map<Eigen::VectorXcd>(work.data() + pointers[0] - 1, n));
        }
      if (info != 0)
        throw ComputationError(
          "the direct solver did not converge (ARPACK info " +
          std::to_string(info) +
          "): ask for fewer pairs or move Eigenvalues/"
          "Direct shift frequency");
      std::vector<a_int> select(ncv);
      Eigen::VectorXcd   d(nev + 1), workev(2 * ncv);
      vectors.resize(n, nev);
      pzneupd_c(comm,
                1,
                "A",
                select.data(),
                raw(d.data()),
                raw(vectors.data()),
                n,
                0.,
                raw(workev.data()),
                "I",
                n,
                "LM",
                nev,
                tolerance,
                raw(residual.data()),
                ncv,
                raw(V.data()),
                n,
                parameters,
                pointers,
                raw(work.data()),
                raw(small.data()),
                static_cast<a_int>(small.size()),
                raw(real_work.data()),
                &info);
      values = d.head(nev);
    }



    /** The eigenvalues of a small operator, at most @p most of them, the
     * largest first, but for zeros, which stand for infinite lambda; @p apply
     * takes and gives the rows of this rank, first those of one half of the
     * vector, then those of the other. @p shift_size is |shift|. */
    void
    dense_eigenvalues(const LinearStep  &apply,
                      const RowSpace    &space,
                      const unsigned int most,
                      const double       shift_size,
                      Eigen::VectorXcd  &values,
                      Eigen::MatrixXcd  &vectors)
    {
      const Eigen::Index N = space.n_global(), n = space.n_owned(),
                         first    = space.first_owned();
      const auto own_rows_of_half = [&](auto &A, const Eigen::Index half) {
        return A.middleRows(half * N + first, n);
      };
      Eigen::MatrixXd re = Eigen::MatrixXd::Zero(2 * N, 2 * N), im = re;
      for (Eigen::Index j = 0; j < 2 * N; ++j)
        {
          Eigen::VectorXcd unit = Eigen::VectorXcd::Zero(2 * n);
          if (const Eigen::Index row = j % N - first; row >= 0 && row < n)
            unit[(j / N) * n + row] = 1.;
          const Eigen::VectorXcd z = apply(unit);
          for (const Eigen::Index half : {0, 1})
            {
              own_rows_of_half(re, half).col(j) = z.segment(half * n, n).real();
              own_rows_of_half(im, half).col(j) = z.segment(half * n, n).imag();
            }
        }
      space.sum(re);
      space.sum(im);
      const Eigen::ComplexEigenSolver<Eigen::MatrixXcd> solver(
        re.cast<Complex>() + Complex(0., 1.) * im.cast<Complex>());
      if (solver.info() != Eigen::Success)
        throw ComputationError("the direct solver did not converge");
      const Eigen::VectorXd size = solver.eigenvalues().cwiseAbs();
      // A defective zero becomes the root of rounding.
      const double zero = 1e-7 * std::min(size.maxCoeff(), 1. / shift_size);
      std::vector<Eigen::Index> kept;
      for (Eigen::Index i = 0; i < 2 * N; ++i)
        if (size[i] > zero)
          kept.push_back(i);
      std::stable_sort(
        kept.begin(), kept.end(), [&](const auto a, const auto b) {
          return size[a] > size[b];
        });
      kept.resize(std::min<std::size_t>(kept.size(), most));
      values                     = solver.eigenvalues()(kept);
      const Eigen::MatrixXcd all = solver.eigenvectors()(Eigen::all, kept);
      vectors.resize(2 * n, kept.size());
      vectors << own_rows_of_half(all, 0), own_rows_of_half(all, 1);
    }
  } // namespace



  void
  dominant_eigenvalues(const LinearStep  &apply,
                       const RowSpace    &space,
                       const unsigned int most,
                       const double       tolerance,
                       const double       shift_size,
                       Eigen::VectorXcd  &values,
                       Eigen::MatrixXcd  &vectors)
  {
    const unsigned int total = 2 * space.n_global();
    if (most + 2 > total)
      dense_eigenvalues(apply, space, most, shift_size, values, vectors);
    else
      arnoldi(apply,
              static_cast<a_int>(2 * space.n_owned()),
              static_cast<a_int>(most),
              static_cast<a_int>(std::min(2 * most + 20, total)),
              tolerance,
              MPI_Comm_c2f(space.communicator()),
              2 * space.first_owned(),
              values,
              vectors);
  }
} // namespace squeal
