// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/base/number_text.h>
#include <squeal/eigen/dense_quadratic.h>
#include <squeal/eigen/direct_solver.h>

#include <Eigen/Eigenvalues>

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

    /** Imaginary part over the distance from the shift that may be rounding:
     * two real eigenvalues that nearly meet are good to its root. */
    constexpr double as_good_as_real = 1e-6;

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



    /** The eigenvalues of a small operator, at most @p most of them, the
     * largest first, but for zeros, which stand for infinite lambda; @p apply
     * takes and gives the rows of this rank, first those of one half of the
     * vector, then those of the other. @p shift_size is |shift|. */
    template <typename Operator>
    void
    dense_eigenvalues(const Operator    &apply,
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



  double
  reach_of(const Eigen::VectorXcd &lambda, const std::complex<double> shift)
  {
    double result = 0.;
    for (const Complex l : lambda)
      result = std::max(result, 1.001 * std::abs(l - shift));
    return result;
  }



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
    // The second half, lambda x, in units of the shift: otherwise rounding of
    // the larger half would move all eigenvalues.
    const double       scale = std::abs(shift) > 0. ? std::abs(shift) : 1.;
    const Eigen::Index n     = z.size() / 2;
    ComplexBlock       uv(n, 2);
    uv << z.head(n), scale * z.tail(n);
    const Pencil::Products p = pencil.apply(uv);
    const ComplexBlock     right =
      -(p.mass.col(1) + p.damping.col(0) + shift * p.mass.col(0));
    const ComplexBlock x = factor->solve(right);
    Eigen::VectorXcd   result(2 * n);
    result << x, (z.head(n) + shift * x) / scale;
    return result;
  }



  ComplexPairs
  DirectSolver::solve(const unsigned int n_pairs, const double tolerance) const
  {
    const RowSpace    &space = *pencil.space();
    const Eigen::Index n     = space.n_owned();
    const unsigned int total = 2 * space.n_global();
    const auto step = [this](const Eigen::VectorXcd &z) { return apply(z); };
    Eigen::VectorXcd values;
    Eigen::MatrixXcd vectors;
    if (n_pairs + 2 > total)
      dense_eigenvalues(step, space, n_pairs, std::abs(shift), values, vectors);
    else
      arnoldi(step,
              static_cast<a_int>(2 * n),
              static_cast<a_int>(n_pairs),
              static_cast<a_int>(std::min(2 * n_pairs + 20, total)),
              tolerance,
              MPI_Comm_c2f(space.communicator()),
              2 * space.first_owned(),
              values,
              vectors);

    const unsigned int        nev = values.size();
    std::vector<Eigen::Index> order(nev);
    std::iota(order.begin(), order.end(), 0);
    const auto lambda = [&](const Eigen::Index i) {
      const Complex away = 1. / values[i], l = shift + away;
      // A band that starts at 0 must not lose what does not vibrate by the
      // sign of rounding.
      return std::abs(l.imag()) <= as_good_as_real * std::abs(away)
               ? Complex(l.real(), 0.)
               : l;
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

  DirectPairs
  DirectSolver::solve_within(const double       radius,
                             const unsigned int n_pairs) const
  {
    for (unsigned int n = n_pairs;; n += 4 + n / 2)
      {
        DirectPairs result{solve(n), shift, 0.};
        if (result.pairs.size() < n)
          {
            result.reach = std::numeric_limits<double>::infinity();
            return result;
          }
        for (const Complex l : result.pairs.lambda)
          result.reach = std::max(result.reach, std::abs(l - shift));
        if (result.reach >= radius || n >= 8 * n_pairs)
          return result;
      }
  }



  namespace
  {
    /** Of |lambda|, within which two eigenvalues are the same one, also next to
     * a coalescence. */
    constexpr double same_pair = 1e-3;
    /** Of an end of the band: a pair there may be on either side of it. */
    constexpr double end_of_band = 1e-6;
    /** Residual of a pair that the direct solver has not found yet. */
    constexpr double not_converged = 1e-5;
    /** Pairs that a sentence names. */
    constexpr Eigen::Index most_named = 4;
  } // namespace

  std::vector<unsigned int>
  pairs_missing(const Eigen::VectorXcd &known,
                const DirectPairs      &direct,
                const double            lowest,
                const double            highest)
  {
    std::vector<unsigned int> missing;
    std::vector<bool>         is_taken(known.size(), false);
    for (unsigned int k = 0; k < direct.pairs.size(); ++k)
      {
        const std::complex<double> lambda = direct.pairs.lambda[k];
        const double               size   = std::abs(lambda);
        if (!is_of_band(lambda,
                        (1. + end_of_band) * lowest,
                        (1. - end_of_band) * highest) ||
            size <= share_of_rigid_motions * 2. * M_PI * highest ||
            !(direct.pairs.residual[k] <= not_converged))
          continue;
        Eigen::Index best     = -1;
        double       distance = same_pair * size;
        for (Eigen::Index i = 0; i < known.size(); ++i)
          if (const double d = std::abs(known[i] - lambda);
              d <= distance && !is_taken[i])
            {
              distance = d;
              best     = i;
            }
        if (best < 0)
          missing.push_back(k);
        else
          is_taken[best] = true;
      }
    return missing;
  }

  std::string
  text_of_missing(Eigen::VectorXcd missing)
  {
    if (missing.size() == 0)
      return "";
    std::stable_sort(missing.begin(), missing.end(), [](auto a, auto b) {
      return a.real() > b.real();
    });
    std::string text = "the direct solver has " +
                       std::to_string(missing.size()) +
                       (missing.size() == 1 ? " pair" : " pairs") +
                       " in the band that the certified one lacks: ";
    const Eigen::Index n = std::min(missing.size(), most_named);
    for (Eigen::Index i = 0; i < n; ++i)
      text += (i > 0 ? ", " : "") +
              rounded_text(missing[i].imag() / (2. * M_PI), 5) +
              " Hz with sigma " + rounded_text(missing[i].real(), 3) + " 1/s";
    return text + (missing.size() > n ? " and others" : "") +
           "; what direct_check.csv holds is right: raise 'Eigenvalues/Highest "
           "frequency' to have them in the tables";
  }
} // namespace squeal
