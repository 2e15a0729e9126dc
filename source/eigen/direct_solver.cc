// SPDX-License-Identifier: LGPL-2.1-or-later
#include "dominant_eigenvalues.h"

#include <squeal/base/number_text.h>
#include <squeal/eigen/dense_quadratic.h>
#include <squeal/eigen/direct_solver.h>

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



  double
  DirectSolver::scale_of_rate() const
  {
    return std::abs(shift) > 0. ? std::abs(shift) : 1.;
  }

  Eigen::VectorXcd
  DirectSolver::apply(const Eigen::VectorXcd &z) const
  {
    const double       scale = scale_of_rate();
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
    const Eigen::Index n = pencil.space()->n_owned();
    Eigen::VectorXcd   values;
    Eigen::MatrixXcd   vectors;
    dominant_eigenvalues([this](const Eigen::VectorXcd &z) { return apply(z); },
                         *pencil.space(),
                         n_pairs,
                         tolerance,
                         std::abs(shift),
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
    pairs.condition      = Eigen::VectorXd::Constant(nev, std::nan(""));
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
