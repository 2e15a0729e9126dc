// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/transient/slow_part.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <limits>

namespace squeal
{
  namespace
  {
    constexpr std::size_t values_per_coefficient = 8;
    /** Of a sum of squares. */
    constexpr double rounding = 16. * std::numeric_limits<double>::epsilon();

    /** Legendre's polynomials up to a degree at @p x, from -1 to 1, and their
     * slopes. */
    struct Polynomials
    {
      Polynomials(const double x, const unsigned int degree)
        : values(Eigen::RowVectorXd::Ones(degree + 1))
        , slopes(Eigen::RowVectorXd::Zero(degree + 1))
      {
        for (unsigned int k = 1; k <= degree; ++k)
          {
            const double before = k > 1 ? values[k - 2] : 0.;
            values[k] =
              ((2. * k - 1.) * x * values[k - 1] - (k - 1.) * before) / k;
            slopes[k] = k * values[k - 1] + x * slopes[k - 1];
          }
      }

      Eigen::RowVectorXd values, slopes;
    };

    /** What the nearest combination of the columns of @p a leaves of @p b. */
    Eigen::VectorXd
    left_over(const Eigen::MatrixXd &a, const Eigen::VectorXd &b)
    {
      return b - a * a.colPivHouseholderQr().solve(b);
    }

    /** Sum of the squares of the numbers of n values less their mean. */
    double
    spread(const double n)
    {
      return n * (n * n - 1.) / 12.;
    }
  } // namespace



  std::vector<double>
  rms_beside_slow_part(const std::vector<SignalPiece> &pieces,
                       const unsigned int              n_groups,
                       const unsigned int              degree)
  {
    double total = 0.;
    for (const SignalPiece &piece : pieces)
      total += piece.n;
    // Two rows a piece: its mean and the slope of its line, each with the root
    // of its weight, so that the squares of what is left add up to those of the
    // values about the polynomial.
    const auto      n      = static_cast<Eigen::Index>(pieces.size());
    Eigen::MatrixXd a      = Eigen::MatrixXd::Zero(2 * n, degree + 1);
    Eigen::VectorXd b      = Eigen::VectorXd::Zero(2 * n), beside(n);
    double          before = 0.;
    for (Eigen::Index i = 0; i < n; ++i)
      {
        const SignalPiece &piece = pieces[i];
        const double       x     = (2. * before + piece.n) / total - 1.,
                     of_mean     = std::sqrt(piece.n),
                     of_line     = std::sqrt(spread(piece.n));
        const Polynomials p(x, degree);
        before += piece.n;
        beside[i] = piece.square;
        if (!(piece.n > 0.))
          continue;
        a.row(2 * i) = of_mean * p.values;
        b[2 * i]     = of_mean * piece.mean;
        if (!(of_line > 0.))
          continue;
        a.row(2 * i + 1) = of_line * 2. / total * p.slopes;
        b[2 * i + 1]     = piece.moment / of_line;
        beside[i] -= b[2 * i + 1] * b[2 * i + 1];
        // Rounding of what is taken away is all that a straight piece leaves.
        if (beside[i] < rounding * piece.square)
          beside[i] = 0.;
      }
    const Eigen::VectorXd rest = left_over(a, b);
    std::vector<double>   result;
    for (unsigned int g = 0; g < n_groups; ++g)
      {
        double values = 0., square = 0.;
        for (Eigen::Index i = g * n / n_groups; i < (g + 1) * n / n_groups; ++i)
          {
            values += pieces[i].n;
            square += beside[i] + rest.segment<2>(2 * i).squaredNorm();
          }
        result.push_back(values > 0. ? std::sqrt(square / values) : 0.);
      }
    return result;
  }



  std::vector<double>
  without_slow_part(const std::vector<double> &signal,
                    const unsigned int         degree)
  {
    const std::size_t n = signal.size();
    if (n == 0)
      return {};
    const std::size_t most =
      std::max<std::size_t>(n / values_per_coefficient, 1) - 1;
    const auto      used = std::min<std::size_t>(degree, most);
    Eigen::MatrixXd a(n, used + 1);
    for (std::size_t i = 0; i < n; ++i)
      a.row(i) = Polynomials((2. * i + 1.) / n - 1., used).values;
    const Eigen::VectorXd rest =
      left_over(a, Eigen::Map<const Eigen::VectorXd>(signal.data(), n));
    return {rest.data(), rest.data() + n};
  }
} // namespace squeal
