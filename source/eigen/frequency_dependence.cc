// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/eigen/dense_quadratic_of_band.h>
#include <squeal/eigen/frequency_dependence.h>
#include <squeal/eigen/standard_pairs.h>

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>

namespace squeal
{
  namespace
  {
    using Complex = std::complex<double>;

    /** Residual at which improvement ends, and the one that will do. */
    constexpr double residual_asked = 1e-13, residual_enough = 1e-9;
    /** Windows beyond which the count is given up. */
    constexpr unsigned int most_windows = 256;

    /** The matrices of the pencil at one frequency. */
    struct Matrices
    {
      Matrices(const std::vector<ReducedPart>      &parts,
               const std::vector<TermCoefficients> &c)
        : M(Eigen::MatrixXd::Zero(parts.front().matrix.rows(),
                                  parts.front().matrix.rows()))
        , C(M)
        , K(M)
      {
        for (std::size_t i = 0; i < parts.size(); ++i)
          {
            if (c[i].mass != 0.)
              M += c[i].mass * parts[i].matrix;
            if (c[i].damping != 0.)
              C += c[i].damping * parts[i].matrix;
            if (c[i].stiffness != 0.)
              K += c[i].stiffness * parts[i].matrix;
          }
      }

      Eigen::MatrixXd  M, C;
      Eigen::MatrixXcd K;
    };

    std::vector<ReducedPart>
    with_coefficients(std::vector<ReducedPart>             parts,
                      const std::vector<TermCoefficients> &c)
    {
      for (std::size_t i = 0; i < parts.size(); ++i)
        parts[i].coefficients = c[i];
      return parts;
    }

    DensePairs
    selected(const DensePairs &pairs, const std::vector<Eigen::Index> &kept)
    {
      DensePairs result;
      result.lambda = pairs.lambda(kept);
      result.right  = pairs.right(Eigen::all, kept);
      result.left   = pairs.left(Eigen::all, kept);
      return result;
    }
  } // namespace



  FrequencyDependentPairs::FrequencyDependentPairs(
    const Coefficients &coefficients,
    const double        f_lowest,
    const double        f_highest)
    : at(coefficients)
    , lowest(2. * M_PI * std::max(0.99 * f_lowest, 1e-3 * f_highest))
    , highest(2. * M_PI * 1.01 * f_highest)
  {
  }

  std::vector<TermCoefficients>
  FrequencyDependentPairs::coefficients(const Complex lambda) const
  {
    return at(lambda.imag());
  }

  unsigned int
  FrequencyDependentPairs::n_searches() const
  {
    return searches;
  }



  double
  FrequencyDependentPairs::lowest_frequency() const
  {
    return lowest / (2. * M_PI);
  }

  std::complex<double>
  FrequencyDependentPairs::growth_below() const
  {
    return growth;
  }



  DensePairs
  FrequencyDependentPairs::solve(const std::vector<ReducedPart> &parts)
  {
    if (starts_anew || !follow(parts))
      last = search(parts);
    starts_anew = false;
    look_below(parts);
    return last.pairs;
  }

  void
  FrequencyDependentPairs::look_below(const std::vector<ReducedPart> &parts)
  {
    std::vector<ReducedPart> there = with_coefficients(parts, at(lowest));
    growth                         = fastest_growth_below(
      solve_dense_quadratic_of_band(there, false, 0., 0., highest).lambda,
      lowest,
      highest);
    // A loss factor has no meaning without vibration, and would turn what
    // diverges into a motion of negative frequency.
    for (ReducedPart &part : there)
      part.coefficients.stiffness = part.coefficients.stiffness.real();
    const Complex without_vibration = fastest_growth_below(
      solve_dense_quadratic_of_band(there, false, 0., 0., highest).lambda,
      1e-12 * highest,
      highest);
    if (without_vibration.real() > growth.real())
      growth = without_vibration;
  }

  bool
  FrequencyDependentPairs::is_complete(const std::vector<ReducedPart> &parts)
  {
    int sum = 0;
    for (const int sense : last.sense)
      sum += sense;
    starts_anew = sum != count(parts) || has_doubles();
    return !starts_anew;
  }



  int
  FrequencyDependentPairs::count(const std::vector<ReducedPart> &parts) const
  {
    const auto n_above = [&](const double omega) {
      const Matrices m(parts, at(omega));
      return static_cast<int>(n_eigenvalues_above(m.M, m.C, m.K, omega));
    };
    return n_above(lowest) - n_above(highest);
  }

  bool
  FrequencyDependentPairs::has_doubles() const
  {
    const DensePairs &p = last.pairs;
    for (Eigen::Index i = 0; i + 1 < p.lambda.size(); ++i)
      for (Eigen::Index j = i + 1; j < p.lambda.size(); ++j)
        if (std::abs(p.lambda[i] - p.lambda[j]) <
              1e-9 * std::abs(p.lambda[i]) &&
            std::abs(p.right.col(i).dot(p.right.col(j))) > 1. - 1e-8)
          return true;
    return false;
  }



  FrequencyDependentPairs::Found
  FrequencyDependentPairs::search(const std::vector<ReducedPart> &parts)
  {
    ++searches;
    const int n_expected = count(parts);
    for (n_windows = std::max(4u, 2 * n_windows); n_windows <= most_windows;
         n_windows *= 2)
      {
        Found              all;
        std::vector<Found> found;
        Eigen::Index       n   = 0;
        int                sum = 0;
        for (unsigned int k = 0; k < n_windows; ++k)
          {
            const double step = std::log(highest / lowest) / n_windows;
            found.push_back(window(parts,
                                   lowest * std::exp(k * step),
                                   k + 1 == n_windows
                                     ? highest
                                     : lowest * std::exp((k + 1) * step)));
            n += found.back().size();
            for (const int sense : found.back().sense)
              sum += sense;
          }
        if (sum != n_expected)
          continue;
        const Eigen::Index size = parts.front().matrix.rows();
        all.pairs.lambda.resize(n);
        all.pairs.right.resize(size, n);
        all.pairs.left.resize(size, n);
        Eigen::Index first = 0;
        for (const Found &own : found)
          {
            const Eigen::Index m               = own.size();
            all.pairs.lambda.segment(first, m) = own.pairs.lambda;
            if (m > 0)
              {
                all.pairs.right.middleCols(first, m) = own.pairs.right;
                all.pairs.left.middleCols(first, m)  = own.pairs.left;
              }
            all.sense.insert(
              all.sense.end(), own.sense.begin(), own.sense.end());
            first += m;
          }
        n_windows /= 2; // the same again next time
        return all;
      }
    throw ComputationError(
      "the pairs whose moduli follow their frequency could not be told "
      "apart: " +
      std::to_string(n_expected) +
      " are there by the count at the ends of the band; change Eigenvalues/"
      "Lowest frequency or Highest frequency a little");
  }



  FrequencyDependentPairs::Found
  FrequencyDependentPairs::window(const std::vector<ReducedPart> &parts,
                                  const double                    lower,
                                  const double                    upper) const
  {
    const double     middle = std::sqrt(lower * upper);
    const DensePairs dense  = solve_dense_quadratic_of_band(
      with_coefficients(parts, at(middle)), false, 0., 0., highest);
    // A pair may be carried here from beyond the window by its modulus.
    const double margin = std::max(0.3 * (upper - lower), 0.03 * middle);
    std::vector<Eigen::Index> near;
    for (Eigen::Index i = 0; i < dense.lambda.size(); ++i)
      if (const double omega = dense.lambda[i].imag();
          omega > lower - margin && omega < upper + margin)
        near.push_back(i);
    if (near.empty())
      return {};
    const DensePairs  basis = selected(dense, near);
    const LocalPencil local(parts, basis.right, basis.left, at);
    const double      overlap = 0.1 * (upper - lower);
    const auto pairs = local.pairs_between(lower - overlap, upper + overlap);
    Found      found;
    found.pairs.lambda.resize(pairs.size());
    found.pairs.right.resize(basis.right.rows(), pairs.size());
    found.pairs.left.resize(basis.left.rows(), pairs.size());
    for (std::size_t k = 0; k < pairs.size(); ++k)
      {
        found.pairs.lambda[k]    = pairs[k].lambda;
        found.pairs.right.col(k) = (basis.right * pairs[k].right).normalized();
        found.pairs.left.col(k)  = (basis.left * pairs[k].left).normalized();
        found.sense.push_back(pairs[k].sense);
      }
    if (!improve(parts, found))
      return {}; // the count will miss them
    std::vector<Eigen::Index> kept;
    Found                     result;
    for (Eigen::Index k = 0; k < found.pairs.lambda.size(); ++k)
      if (const double omega = found.pairs.lambda[k].imag();
          omega >= lower && omega < upper)
        {
          kept.push_back(k);
          result.sense.push_back(found.sense[k]);
        }
    result.pairs = selected(found.pairs, kept);
    return result;
  }



  bool
  FrequencyDependentPairs::improve(const std::vector<ReducedPart> &parts,
                                   Found                          &found) const
  {
    const Eigen::Index n = found.size();
    if (n == 0)
      return true;
    DensePairs &p        = found.pairs;
    double      previous = std::numeric_limits<double>::max();
    for (unsigned int step = 0; step < 12; ++step)
      {
        // With its own pencil, so near to its eigenvalue that little else is
        // left of any start.
        double worst = 0.;
        auto   next  = p;
        for (Eigen::Index k = 0; k < n; ++k)
          {
            const Complex          l = p.lambda[k];
            const Matrices         m(parts, at(l.imag()));
            const Eigen::MatrixXcd Q = l * l * m.M + l * m.C + m.K;
            const Eigen::VectorXcd x = p.right.col(k), Mx = m.M * x,
                                   Kx = m.K * x;
            worst                     = std::max(
              worst, (Q * x).norm() / (std::norm(l) * Mx.norm() + Kx.norm()));
            if (!std::isfinite(worst))
              return false;
            const Eigen::PartialPivLU<Eigen::MatrixXcd> factor(Q);
            const Eigen::MatrixXd                       D = m.C;
            next.right.col(k) =
              factor.solve(Eigen::VectorXcd(2. * l * Mx + D * x)).normalized();
            const Eigen::VectorXcd y = p.left.col(k);
            next.left.col(k) =
              factor.transpose()
                .solve(Eigen::VectorXcd(2. * l * (m.M.transpose() * y) +
                                        D.transpose() * y))
                .normalized();
          }
        if (worst <= residual_asked ||
            (worst <= residual_enough && worst > 0.1 * previous))
          return true;
        previous = worst;
        if (!next.right.allFinite() || !next.left.allFinite())
          return worst <= residual_enough;
        const LocalPencil local(parts, next.right, next.left, at);
        const double      low = p.lambda.imag().minCoeff(),
                     high     = p.lambda.imag().maxCoeff();
        const auto pairs      = local.pairs_between(0.97 * low, 1.03 * high);
        if (static_cast<Eigen::Index>(pairs.size()) != n)
          return false;
        for (Eigen::Index k = 0; k < n; ++k)
          {
            p.lambda[k]    = pairs[k].lambda;
            p.right.col(k) = (next.right * pairs[k].right).normalized();
            p.left.col(k)  = (next.left * pairs[k].left).normalized();
            found.sense[k] = pairs[k].sense;
          }
      }
    return false;
  }



  bool
  FrequencyDependentPairs::follow(const std::vector<ReducedPart> &parts)
  {
    const Eigen::Index n = last.size(), size = parts.front().matrix.rows(),
                       before = last.pairs.right.rows();
    if (n == 0)
      return false;
    // Coordinates of a smaller basis are the first of this one.
    Found now = last;
    now.pairs.right.conservativeResize(size, n);
    now.pairs.left.conservativeResize(size, n);
    now.pairs.right.bottomRows(size - before).setZero();
    now.pairs.left.bottomRows(size - before).setZero();
    // Neighbours together, a few at a time.
    constexpr Eigen::Index most  = 10;
    const auto            &omega = last.pairs.lambda;
    for (Eigen::Index first = 0, end = 0; first < n; first = end)
      {
        end = first + 1;
        while (end < n &&
               (end - first < most ||
                omega[end].imag() < (1. + 1e-4) * omega[end - 1].imag()))
          ++end;
        std::vector<Eigen::Index> group;
        for (Eigen::Index k = first; k < end; ++k)
          group.push_back(k);
        Found own;
        own.pairs = selected(now.pairs, group);
        own.sense.assign(now.sense.begin() + first, now.sense.begin() + end);
        if (!improve(parts, own))
          return false;
        now.pairs.lambda.segment(first, end - first)   = own.pairs.lambda;
        now.pairs.right.middleCols(first, end - first) = own.pairs.right;
        now.pairs.left.middleCols(first, end - first)  = own.pairs.left;
        std::copy(
          own.sense.begin(), own.sense.end(), now.sense.begin() + first);
      }
    last = std::move(now);
    return true;
  }
} // namespace squeal
