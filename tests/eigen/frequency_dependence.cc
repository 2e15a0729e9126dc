// SPDX-License-Identifier: LGPL-2.1-or-later

// Pairs whose stiffness depends on their own frequency: every scalar solution
// of a pencil that falls apart into scalars is found once, doublets twice,
// also where the modulus rises so steeply that a pair has three frequencies.

#include <squeal/eigen/frequency_dependence.h>

#include <Eigen/QR>

#include "check.h"
#include "worst.h"

#include <algorithm>
#include <random>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  using Complex = std::complex<double>;

  /** a + E(omega) (1 + i eta(omega)) b on each diagonal, turned by one
   * orthogonal matrix. */
  struct Scalars
  {
    Eigen::VectorXd                      a, b;
    std::function<Complex(const double)> modulus;
    double                               alpha = 0.; /**< C = alpha M */

    std::vector<ReducedPart>
    parts() const
    {
      const Eigen::Index n = a.size();
      std::mt19937       random(7);
      Eigen::MatrixXd    R(n, n);
      for (Eigen::Index i = 0; i < n * n; ++i)
        R.data()[i] = random() / 4294967296. - .5;
      const Eigen::MatrixXd Q =
        Eigen::HouseholderQR<Eigen::MatrixXd>(R).householderQ();
      return {{Eigen::MatrixXd::Identity(n, n), {}},
              {Q * a.asDiagonal() * Q.transpose(), {}},
              {Q * b.asDiagonal() * Q.transpose(), {}}};
    }

    std::vector<TermCoefficients>
    at(const double omega) const
    {
      return {{1., alpha, 0.}, {0., 0., 1.}, {0., 0., modulus(omega)}};
    }

    /** Im lambda of number i with the modulus at omega. */
    Complex
    lambda(const Eigen::Index i, const double omega) const
    {
      const Complex kappa = a[i] + modulus(omega) * b[i];
      return -.5 * alpha + std::sqrt(.25 * alpha * alpha - kappa);
    }

    /** All solutions between two frequencies, by a fine scan and bisection. */
    std::vector<Complex>
    solutions(const double lowest, const double highest) const
    {
      std::vector<Complex> all;
      for (Eigen::Index i = 0; i < a.size(); ++i)
        {
          const auto f = [&](const double x) {
            return std::abs(lambda(i, x).imag()) - x;
          };
          const double step = 1e-4 * lowest;
          for (double x = lowest; x < highest; x += step)
            if ((f(x) > 0.) != (f(x + step) > 0.))
              {
                double low = x, high = x + step;
                for (unsigned int k = 0; k < 60; ++k)
                  {
                    const double middle = .5 * (low + high);
                    ((f(middle) > 0.) == (f(low) > 0.) ? low : high) = middle;
                  }
                const Complex l = lambda(i, low);
                all.push_back(l.imag() > 0. ? l : Complex(l.real(), -l.imag()));
                if (l.imag() < 0.)
                  all.back() = -alpha - l;
              }
        }
      std::sort(all.begin(), all.end(), [](const auto p, const auto q) {
        return p.imag() < q.imag();
      });
      return all;
    }
  };

  void
  finds_all(const Scalars &scalars, const std::string &what)
  {
    const auto              parts = scalars.parts();
    FrequencyDependentPairs finder(
      [&](const double omega) { return scalars.at(omega); },
      100. / .99,
      1000. / 1.01);
    const DensePairs found = finder.solve(parts);
    check(finder.is_complete(parts), what + ": the count is met");
    const auto expected =
      scalars.solutions(200. * M_PI, 2000. * M_PI * (1. - 1e-12));
    check(static_cast<std::size_t>(found.lambda.size()) == expected.size(),
          what + ": " + std::to_string(expected.size()) + " pairs, " +
            std::to_string(found.lambda.size()) + " found");
    Worst error, residual;
    for (Eigen::Index k = 0; k < found.lambda.size(); ++k)
      {
        const Complex l = found.lambda[k];
        error.add(std::abs(l - expected[k]) / std::abs(l));
        const auto       c = finder.coefficients(l);
        Eigen::VectorXcd r = Eigen::VectorXcd::Zero(scalars.a.size()), s = r;
        for (std::size_t i = 0; i < parts.size(); ++i)
          {
            const Complex q =
              l * l * c[i].mass + l * c[i].damping + c[i].stiffness;
            r += q * (parts[i].matrix * found.right.col(k));
            s += q * (parts[i].matrix.transpose() * found.left.col(k));
          }
        residual.add(r.norm() / std::norm(l));
        residual.add(s.norm() / std::norm(l));
      }
    check(error.is_within(1e-11),
          what + ": error " + internal::digits(error.largest()));
    check(residual.is_within(1e-11),
          what + ": residuals " + internal::digits(residual.largest()));
    // the same basis again, and a larger one
    check((finder.solve(parts).lambda - found.lambda).norm() <
            1e-10 * found.lambda.norm(),
          what + ": the last pairs are found again");
    check(finder.n_searches() == 1, what + ": by one search");
  }

  Scalars
  spread(const unsigned int n, const double share)
  {
    Scalars s;
    s.a.resize(n);
    s.b.resize(n);
    for (unsigned int i = 0; i < n; ++i)
      {
        const double omega = 2. * M_PI * 60. * std::pow(30., (i + .37) / n);
        const double part  = share * (.5 + .5 * std::sin(3. * i));
        s.a[i]             = (1. - part) * omega * omega;
        s.b[i]             = part * omega * omega;
      }
    s.modulus = [](const double omega) {
      return std::pow(omega / 2000., .4) * Complex(1., .3 + 1e-4 * omega);
    };
    return s;
  }
} // namespace

int
main()
{
  Scalars s = spread(40, .6);
  finds_all(s, "a modulus by a power of the frequency");
  s.alpha = 30.;
  finds_all(s, "with damping beside it");
  s             = spread(20, .6);
  Scalars twice = s;
  twice.a.resize(40);
  twice.b.resize(40);
  twice.a << s.a, s.a;
  twice.b << s.b, s.b;
  finds_all(twice, "doublets");
  // Nearly as steep as the square of the frequency, the most there can be.
  s         = spread(16, .9);
  s.modulus = [](const double omega) {
    return (1. + 11. / (1. + std::pow(2000. / omega, 3.))) * Complex(1., .1);
  };
  finds_all(s, "a steep modulus");
}
