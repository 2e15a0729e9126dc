// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/dense_products.h>
#include <squeal/sweep/sensitivity.h>

namespace squeal
{
  namespace
  {
    using Complex = std::complex<double>;

    /** Relative step of the coefficients' differences; they are polynomials of
     * the second degree in every entry, so that it causes no error. */
    constexpr double step = 1e-2;

    /** d/d ln p of the coefficients. */
    std::vector<TermCoefficients>
    derivatives(const ParametricSystem &system,
                const SweepPoint       &point,
                const unsigned int      entry)
    {
      const auto up =
        system.coefficients(system.grid().scene(point, entry, 1. + step));
      const auto down =
        system.coefficients(system.grid().scene(point, entry, 1. - step));
      std::vector<TermCoefficients> result;
      for (std::size_t i = 0; i < up.size(); ++i)
        result.push_back({(up[i].mass - down[i].mass) / (2. * step),
                          (up[i].damping - down[i].damping) / (2. * step),
                          (up[i].stiffness - down[i].stiffness) / (2. * step)});
      return result;
    }

    /** Q' x and (lambda^2 dM + lambda dC + dK) x. */
    struct Products
    {
      Eigen::VectorXcd derivative, change;
    };

    Products
    products(const ReducedModel                  &model,
             const std::vector<TermCoefficients> &coefficients,
             const std::vector<TermCoefficients> &change,
             const Complex                        lambda,
             const Eigen::VectorXcd              &x)
    {
      Products result{Eigen::VectorXcd::Zero(x.size()),
                      Eigen::VectorXcd::Zero(x.size())};
      for (std::size_t p = 0; p < coefficients.size(); ++p)
        {
          const Complex q =
            2. * lambda * coefficients[p].mass + coefficients[p].damping;
          const Complex d = lambda * lambda * change[p].mass +
                            lambda * change[p].damping + change[p].stiffness;
          if (q == 0. && d == 0.)
            continue;
          const Eigen::VectorXcd Ax = times(model.parts[p], x);
          result.derivative += q * Ax;
          result.change += d * Ax;
        }
      return result;
    }

    Complex
    product(const Eigen::VectorXcd &y, const Eigen::VectorXcd &x)
    {
      return (y.transpose() * x)(0);
    }
  } // namespace



  Eigen::VectorXcd
  sensitivities(const ReducedModel     &model,
                const ParametricSystem &system,
                const SweepPoint       &point,
                const ComplexPairs     &pairs,
                const unsigned int      entry)
  {
    const auto       coefficients = system.coefficients(point);
    const auto       change       = derivatives(system, point, entry);
    Eigen::VectorXcd result(pairs.size());
    for (unsigned int i = 0; i < pairs.size(); ++i)
      {
        const Products p = products(
          model, coefficients, change, pairs.lambda[i], pairs.right.col(i));
        result[i] = -product(pairs.left.col(i), p.change) /
                    product(pairs.left.col(i), p.derivative);
      }
    return result;
  }



  PairSensitivity
  pair_sensitivity(const ReducedModel     &model,
                   const ParametricSystem &system,
                   const SweepPoint       &point,
                   const ComplexPairs     &pairs,
                   const unsigned int      entry,
                   const int               i,
                   const int               j)
  {
    // (d_i + d_j) / 2 and (lambda_i - lambda_j) (d_i - d_j) / 2: the poles of
    // the two cancel in the first, and the factor removes them from the second.
    const Eigen::VectorXcd d =
      sensitivities(model, system, point, pairs, entry);
    return {0.5 * (d[i] + d[j]),
            0.5 * (pairs.lambda[i] - pairs.lambda[j]) * (d[i] - d[j])};
  }
} // namespace squeal
