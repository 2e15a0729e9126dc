// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/eigen/direct_solver.h>

#include <parpack.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

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
    template <typename Operator>
    void
    arnoldi(const Operator    &apply,
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
  } // namespace



  DirectSolver::DirectSolver(const Pencil &p, const Complex s)
    : pencil(p)
    , shift(s)
    , factor(std::make_unique<MumpsFactorization<Complex>>(
        p.space(),
        MumpsFactorization<Complex>::Symmetry::general))
  {
    std::vector<int>     rows, columns;
    std::vector<Complex> values;
    pencil.quadratic_entries(shift, rows, columns, values);
    factor->factorize(std::move(rows), std::move(columns), std::move(values));
  }



  Eigen::VectorXcd
  DirectSolver::apply(const Eigen::VectorXcd &z) const
  {
    const Eigen::Index n = z.size() / 2;
    ComplexBlock       uv(n, 2);
    uv << z.head(n), z.tail(n);
    const Pencil::Products p = pencil.apply(uv);
    const ComplexBlock     right =
      -(p.mass.col(1) + p.damping.col(0) + shift * p.mass.col(0));
    const ComplexBlock x = factor->solve(right);
    Eigen::VectorXcd   result(2 * n);
    result << x, z.head(n) + shift * x;
    return result;
  }



  ComplexPairs
  DirectSolver::solve(const unsigned int n_pairs, const double tolerance) const
  {
    const RowSpace    &space = *pencil.space();
    const Eigen::Index n     = space.n_owned();
    const unsigned int total = 2 * space.n_global();
    const unsigned int nev   = std::min(n_pairs, total - 2);
    const unsigned int ncv   = std::min(2 * nev + 20, total);
    Eigen::VectorXcd   values;
    Eigen::MatrixXcd   vectors;
    arnoldi([this](const Eigen::VectorXcd &z) { return apply(z); },
            static_cast<a_int>(2 * n),
            static_cast<a_int>(nev),
            static_cast<a_int>(ncv),
            tolerance,
            MPI_Comm_c2f(space.communicator()),
            2 * space.first_owned(),
            values,
            vectors);

    std::vector<Eigen::Index> order(nev);
    std::iota(order.begin(), order.end(), 0);
    const auto lambda = [&](const Eigen::Index i) {
      return shift + 1. / values[i];
    };
    std::sort(order.begin(), order.end(), [&](const auto a, const auto b) {
      return std::make_pair(lambda(a).imag(), lambda(a).real()) <
             std::make_pair(lambda(b).imag(), lambda(b).real());
    });
    ComplexPairs pairs;
    pairs.lambda.resize(nev);
    pairs.right.resize(n, nev);
    for (unsigned int k = 0; k < nev; ++k)
      {
        pairs.lambda[k]    = lambda(order[k]);
        pairs.right.col(k) = vectors.col(order[k]).head(n);
      }
    ComplexBlock    R;
    Eigen::VectorXd denominators;
    pairs.residual = relative_residuals(
      pencil, pairs.lambda, pencil.apply(pairs.right), R, denominators);
    pairs.noise_floor = 4. * std::numeric_limits<double>::epsilon() *
                        pencil.stiffness_rounding_size(pairs.right).array() /
                        denominators.array();
    pairs.left           = ComplexBlock::Zero(n, nev);
    pairs.left_residual  = Eigen::VectorXd::Constant(nev, std::nan(""));
    pairs.error_estimate = Eigen::VectorXd::Constant(nev, std::nan(""));
    pairs.condition      = Eigen::VectorXd::Constant(nev, 1.);
    pairs.pair_partner.assign(nev, -1);
    return pairs;
  }
} // namespace squeal
