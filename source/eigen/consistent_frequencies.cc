// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/eigen/consistent_frequencies.h>
#include <squeal/eigen/standard_pairs.h>

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace squeal
{
  namespace
  {
    using Complex = std::complex<double>;

    /** Crossings nearer than this, relative, are looked at together: of
     * coalesced pairs the orders are those of rounding. */
    constexpr double same_frequency = 1e-11;
  } // namespace



  LocalPencil::LocalPencil(
    const std::vector<ReducedPart>                                   &parts,
    const Eigen::MatrixXcd                                           &X,
    const Eigen::MatrixXcd                                           &Y,
    const std::function<std::vector<TermCoefficients>(const double)> &at)
    : coefficients(at)
  {
    for (const auto &part : parts)
      projected.push_back(Y.transpose() * (part.matrix * X));
  }



  DensePairs
  LocalPencil::at_frequency(const double omega) const
  {
    const Eigen::Index n = projected.front().rows();
    const auto         c = coefficients(omega);
    Eigen::MatrixXcd   M = Eigen::MatrixXcd::Zero(n, n), C = M, K = M;
    for (std::size_t i = 0; i < projected.size(); ++i)
      {
        M += c[i].mass * projected[i];
        C += c[i].damping * projected[i];
        K += c[i].stiffness * projected[i];
      }
    // lambda = s + s / t with s = omega, away from all eigenvalues near i
    // omega.
    const double                                s = omega;
    const Eigen::PartialPivLU<Eigen::MatrixXcd> Q(K + s * C + s * s * M);
    Eigen::MatrixXcd A         = Eigen::MatrixXcd::Zero(2 * n, 2 * n);
    A.topRightCorner(n, n)     = Eigen::MatrixXcd::Identity(n, n);
    A.bottomLeftCorner(n, n)   = -s * s * Q.solve(M);
    A.bottomRightCorner(n, n)  = -s * Q.solve(C + 2. * s * M);
    const StandardPairs    all = standard_pairs(A);
    const Eigen::MatrixXcd left =
      Q.transpose().solve(Eigen::MatrixXcd(all.left.bottomRows(n)));
    std::vector<std::pair<Complex, Eigen::Index>> upper;
    for (Eigen::Index i = 0; i < 2 * n; ++i)
      if (all.values[i] != 0.)
        if (const Complex lambda = s + s / all.values[i]; lambda.imag() > 0.)
          upper.emplace_back(lambda, i);
    std::sort(upper.begin(), upper.end(), [](const auto &a, const auto &b) {
      return std::make_pair(a.first.imag(), a.first.real()) >
             std::make_pair(b.first.imag(), b.first.real());
    });
    DensePairs result;
    result.lambda.resize(upper.size());
    result.right.resize(n, upper.size());
    result.left.resize(n, upper.size());
    for (std::size_t k = 0; k < upper.size(); ++k)
      {
        result.lambda[k]    = upper[k].first;
        result.right.col(k) = all.right.col(upper[k].second).head(n);
        result.left.col(k)  = left.col(upper[k].second);
      }
    return result;
  }



  double
  LocalPencil::crossing(const Eigen::Index order,
                        const double       lower,
                        const double       upper,
                        const double       at_lower,
                        const double       at_upper) const
  {
    // Regula falsi (Illinois) from the middle, where the function is nearly
    // constant: one step of fixed-point iteration first.
    double       a = lower, b = upper, fa = at_lower, fb = at_upper;
    double       x     = 0.5 * (a + b);
    const double floor = 4. * std::numeric_limits<double>::epsilon();
    for (unsigned int step = 0; step < 200; ++step)
      {
        const DensePairs pairs = at_frequency(x);
        const double     own =
          order < pairs.lambda.size() ? pairs.lambda[order].imag() : 0.;
        const double f = own - x;
        if (std::abs(f) <= floor * x || b - a <= floor * x)
          break;
        if ((f > 0.) == (fa > 0.))
          {
            a  = x;
            fa = f;
            fb *= step > 1 ? 0.5 : 1.;
          }
        else
          {
            b  = x;
            fb = f;
            fa *= step > 1 ? 0.5 : 1.;
          }
        const double secant = a - fa * (b - a) / (fb - fa);
        x                   = step == 0 && own > a && own < b ? own : secant;
        if (!(x > a && x < b))
          x = 0.5 * (a + b);
      }
    return x;
  }



  std::vector<LocalPencil::Pair>
  LocalPencil::pairs_between(const double lower, const double upper) const
  {
    const DensePairs first = at_frequency(lower), last = at_frequency(upper);
    struct Crossing
    {
      double       omega;
      Eigen::Index order;
      int          sense;
    };
    std::vector<Crossing> crossings;
    const auto            height =
      [](const DensePairs &pairs, const Eigen::Index k, const double omega) {
        return (k < pairs.lambda.size() ? pairs.lambda[k].imag() : 0.) - omega;
      };
    const Eigen::Index n = std::max(first.lambda.size(), last.lambda.size());
    for (Eigen::Index k = 0; k < n; ++k)
      {
        const double a = height(first, k, lower), b = height(last, k, upper);
        if ((a > 0.) != (b > 0.))
          crossings.push_back(
            {crossing(k, lower, upper, a, b), k, a > 0. ? 1 : -1});
      }
    std::sort(crossings.begin(),
              crossings.end(),
              [](const auto &a, const auto &b) { return a.omega < b.omega; });
    std::vector<Pair> result;
    for (std::size_t i = 0, end = 0; i < crossings.size(); i = end)
      {
        double sum = 0.;
        for (end = i;
             end < crossings.size() &&
             crossings[end].omega <= (1. + same_frequency) * crossings[i].omega;
             ++end)
          sum += crossings[end].omega;
        const DensePairs here = at_frequency(sum / (end - i));
        for (std::size_t k = i; k < end; ++k)
          if (const Eigen::Index order = crossings[k].order;
              order < here.lambda.size())
            result.push_back({here.lambda[order],
                              here.right.col(order),
                              here.left.col(order),
                              crossings[k].sense});
      }
    return result;
  }
} // namespace squeal
