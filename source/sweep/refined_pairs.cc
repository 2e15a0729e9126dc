// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/dense_products.h>
#include <squeal/eigen/shifted_hessenberg.h>
#include <squeal/eigen/standard_pairs.h>
#include <squeal/sweep/refined_pairs.h>

#include <Eigen/LU>
#include <Eigen/QR>

#include <algorithm>
#include <memory>
#include <numeric>
#include <optional>
#include <vector>

namespace squeal
{
  namespace
  {
    using Complex = std::complex<double>;

    /** Conditions from which neighbours are refined together. */
    constexpr double close_condition = 30.;

    /** Q(lambda) = lambda^2 M + lambda C + K + i H of small dense matrices. */
    class Quadratic
    {
    public:
      /** For eigenvalues up to the circular frequency @p highest. */
      Quadratic(const PointMatrices &m, const double highest)
        : matrices(m)
      {
        if (m.rayleigh)
          plane = std::make_unique<ShiftedHessenberg>(m.K, m.M, highest);
      }

      /** Bases of the right and the left invariant subspace at @p lambda: two
       * steps of Q^-1 Q' from X and Y, orthonormal columns. */
      void
      iterate(const Complex     lambda,
              Eigen::MatrixXcd &X,
              Eigen::MatrixXcd &Y) const
      {
        const Solver solver(*this, lambda);
        for (unsigned int step = 0; step < 2; ++step)
          {
            X = orthonormal(solver.solve(derivative(lambda, X, false)));
            Y =
              orthonormal(solver.solve_transposed(derivative(lambda, Y, true)));
          }
      }

      static Eigen::MatrixXcd
      orthonormal(const Eigen::MatrixXcd &Z)
      {
        return Eigen::HouseholderQR<Eigen::MatrixXcd>(Z).householderQ() *
               Eigen::MatrixXcd::Identity(Z.rows(), Z.cols());
      }

      /** Roots of the quadratic problem between two bases nearest to a
       * lambda, one a column of the vectors. */
      struct Roots
      {
        Eigen::VectorXcd lambda;
        Eigen::MatrixXcd right, left; /**< empty unless asked for */
      };

      Roots
      roots(const Eigen::MatrixXcd &Y,
            const Eigen::MatrixXcd &Z,
            const Complex           lambda,
            const bool              with_vectors) const
      {
        const Eigen::Index m = Z.cols();
        // About lambda, for what counts is the small difference.
        const Eigen::MatrixXcd M = Y.transpose() * times(matrices.M, Z);
        const Eigen::MatrixXcd Q = Y.transpose() * at(lambda, Z);
        const Eigen::MatrixXcd dQ =
          Y.transpose() * derivative(lambda, Z, false);
        const Eigen::PartialPivLU<Eigen::MatrixXcd> factor(M);
        Eigen::MatrixXcd A = Eigen::MatrixXcd::Zero(2 * m, 2 * m);
        A.topRightCorner(m, m).setIdentity();
        A.bottomLeftCorner(m, m)  = -factor.solve(Q);
        A.bottomRightCorner(m, m) = -factor.solve(dQ);
        const StandardPairs pairs = standard_pairs(A);
        std::vector<int>    order(2 * m);
        std::iota(order.begin(), order.end(), 0);
        std::sort(order.begin(), order.end(), [&](const int a, const int b) {
          return std::abs(pairs.values[a]) < std::abs(pairs.values[b]);
        });
        order.resize(m);
        Roots result;
        result.lambda = pairs.values(order).array() + lambda;
        if (with_vectors)
          {
            result.right = Z * pairs.right.topRows(m)(Eigen::all, order);
            // The last block of a left vector is M^T times that of Q.
            const Eigen::MatrixXcd last =
              pairs.left.bottomRows(m)(Eigen::all, order);
            const Eigen::MatrixXcd y = factor.transpose().solve(last);
            result.left              = Y * y;
          }
        return result;
      }

      /** To mass norm 1. */
      void
      normalise(Eigen::Ref<Eigen::VectorXcd> x) const
      {
        x /= std::sqrt(x.dot(times(matrices.M, x).col(0)).real());
      }

    private:
      Eigen::MatrixXcd
      at(const Complex lambda, const Eigen::MatrixXcd &Z) const
      {
        Eigen::MatrixXcd result = times(matrices.K, Z) +
                                  lambda * times(matrices.C, Z) +
                                  lambda * lambda * times(matrices.M, Z);
        if (matrices.H.size() > 0)
          result += Complex(0., 1.) * times(matrices.H, Z);
        return result;
      }

      Eigen::MatrixXcd
      derivative(const Complex           lambda,
                 const Eigen::MatrixXcd &Z,
                 const bool              transposed) const
      {
        // M is symmetric.
        return 2. * lambda * times(matrices.M, Z) +
               (transposed ? transpose_times(matrices.C, Z)
                           : times(matrices.C, Z));
      }

      /** Q(lambda)^-1 of one lambda. */
      class Solver
      {
      public:
        Solver(const Quadratic &q, const Complex lambda)
        {
          const PointMatrices &m = q.matrices;
          if (q.plane)
            {
              // Q = (1 + beta lambda) (K + s M).
              scale = 1. / (1. + m.beta * lambda);
              in_plane.emplace(
                q.plane->factor(lambda * (lambda + m.alpha) * scale));
              return;
            }
          Eigen::MatrixXcd Q = m.K + lambda * m.C + lambda * lambda * m.M;
          if (m.H.size() > 0)
            Q += Complex(0., 1.) * m.H;
          alone.compute(Q);
        }

        Eigen::MatrixXcd
        solve(const Eigen::MatrixXcd &B) const
        {
          if (in_plane)
            return scale * in_plane->solve(B);
          return alone.solve(B);
        }

        Eigen::MatrixXcd
        solve_transposed(const Eigen::MatrixXcd &B) const
        {
          if (in_plane)
            return scale * in_plane->solve_transposed(B);
          return alone.transpose().solve(B);
        }

      private:
        Complex                                  scale = 1.;
        std::optional<ShiftedHessenberg::Factor> in_plane;
        Eigen::PartialPivLU<Eigen::MatrixXcd>    alone;
      };

      const PointMatrices               &matrices;
      std::unique_ptr<ShiftedHessenberg> plane;
    };

    /** The other member of a pair in need of it, or -1. */
    int
    neighbour(const ComplexPairs &pairs, const unsigned int a)
    {
      if (pairs.condition[a] < close_condition)
        return -1;
      int best = -1;
      for (unsigned int b = 0; b < pairs.size(); ++b)
        if (b != a &&
            (best < 0 || std::abs(pairs.lambda[b] - pairs.lambda[a]) <
                           std::abs(pairs.lambda[best] - pairs.lambda[a])))
          best = b;
      return best;
    }

    Eigen::MatrixXcd
    columns(const Eigen::MatrixXcd &vectors,
            const Eigen::Index      n,
            const int               a,
            const int               b)
    {
      Eigen::MatrixXcd result = Eigen::MatrixXcd::Zero(n, b < 0 ? 1 : 2);
      result.col(0).head(vectors.rows()) = vectors.col(a);
      if (b >= 0)
        result.col(1).head(vectors.rows()) = vectors.col(b);
      return result;
    }
  } // namespace



  RefinedPairs
  refine_pairs(const PointMatrices &matrices,
               const ComplexPairs  &pairs,
               const bool           with_vectors)
  {
    const Eigen::Index N = matrices.M.rows();
    const Quadratic    quadratic(
      matrices, pairs.size() > 0 ? pairs.lambda.imag().maxCoeff() : 0.);
    RefinedPairs result;
    result.lambda = pairs.lambda;
    if (with_vectors)
      {
        result.right.resize(N, pairs.size());
        result.left.resize(N, pairs.size());
      }
    for (unsigned int a = 0; a < pairs.size(); ++a)
      {
        const int     b = neighbour(pairs, a);
        const Complex centre =
          b < 0 ? pairs.lambda[a] : 0.5 * (pairs.lambda[a] + pairs.lambda[b]);
        Eigen::MatrixXcd Z = columns(pairs.right, N, a, b);
        Eigen::MatrixXcd Y = columns(pairs.left, N, a, b);
        quadratic.iterate(centre, Z, Y);
        const Quadratic::Roots roots =
          quadratic.roots(Y, Z, centre, with_vectors);
        // Of two, both members choose as suits both best.
        Eigen::Index best = 0;
        if (b >= 0)
          {
            const auto away = [&](const int pair, const Eigen::Index i) {
              return std::abs(roots.lambda[i] - pairs.lambda[pair]);
            };
            best = away(a, 0) + away(b, 1) <= away(a, 1) + away(b, 0) ? 0 : 1;
          }
        result.lambda[a] = roots.lambda[best];
        if (!with_vectors)
          continue;
        result.right.col(a) = roots.right.col(best);
        result.left.col(a)  = roots.left.col(best);
        quadratic.normalise(result.right.col(a));
        quadratic.normalise(result.left.col(a));
      }
    return result;
  }
} // namespace squeal
