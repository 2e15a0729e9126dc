// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/sweep/exceptional_point.h>

#include <Eigen/LU>
#include <Eigen/QR>

#include <algorithm>
#include <cmath>

namespace squeal
{
  namespace
  {
    using Complex = std::complex<double>;

    // Of the length of the line:
    constexpr double longest_step = 0.1, least_step = 1e-10, probe_step = 1e-5,
                     start_step  = 1e-4;
    constexpr double real_margin = 0.05, imaginary_margin = 1.;
    /** Half-difference of eigenvalues that are one, of |lambda|. */
    constexpr double no_split = 1e-6;
    /** Of eigenvalues that are one, the condition within their plane: a double
     * eigenvalue with two vectors has 1. */
    constexpr double least_coupling = 100.;

    Eigen::MatrixXcd
    orthonormal(const Eigen::MatrixXcd &vectors)
    {
      return Eigen::HouseholderQR<Eigen::MatrixXcd>(vectors).householderQ() *
             Eigen::MatrixXcd::Identity(vectors.rows(), vectors.cols());
    }

    /** Of the two eigenvalues of @p N the one nearest to 0, with its vector. */
    struct NearestEigenvalue
    {
      explicit NearestEigenvalue(const Eigen::Matrix2cd &N)
      {
        const Complex half = 0.5 * N.trace();
        const Complex root = std::sqrt(half * half - N.determinant());
        const Complex sum = half + root, difference = half - root;
        const bool    is_sum = std::abs(sum) < std::abs(difference);
        value                = is_sum ? sum : difference;
        // What is left of the other one is a multiple of the vector.
        Eigen::Matrix2cd rest = N;
        rest.diagonal().array() -= is_sum ? difference : sum;
        vector = rest.col(
          rest.col(0).squaredNorm() < rest.col(1).squaredNorm() ? 1 : 0);
      }

      Complex          value;
      Eigen::Vector2cd vector;
    };

    /**
     * Two eigenvalues at complex coordinates and the planes of their vectors.
     *
     * With B = Q' X and C^T = Y^T Q' of the right and the left plane, times
     * lambda, [Q B; C^T 0] [U; W] = [0; I]
     * gives a matrix W(lambda) with two rows that is singular where Q is.
     * W'(lambda) = -V^T Q' U, V being the same of the transposed Q, so that
     * lambda plus the eigenvalues of N = -W'^-1 W are the two to first order.
     * Where they are nearly one, lambda is their mean, which is smooth where
     * they coalesce as their squared half-difference and the planes are; where
     * they are apart, each of them.
     */
    class EigenvaluePlane
    {
    public:
      EigenvaluePlane(const ContinuedPencil  &p,
                      const Eigen::MatrixXcd &right_vectors,
                      const Eigen::MatrixXcd &left_vectors)
        : pencil(&p)
      {
        const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(p.basis);
        for (const bool of_left : {false, true})
          {
            const Eigen::MatrixXcd &x = of_left ? left_vectors : right_vectors;
            Eigen::MatrixXcd        y(p.basis.cols(), 2);
            y.real()                 = qr.solve(x.real().eval());
            y.imag()                 = qr.solve(x.imag().eval());
            (of_left ? left : right) = y;
          }
      }

      /** From guesses of the mean and of the square; false where that leads
       * nowhere. */
      bool
      go_to(const Complex coordinate, const Complex guess, const Complex square)
      {
        std::optional<ContinuedMatrices> m = pencil->at(coordinate);
        if (!m)
          return false;
        // Stiff directions and soft ones alike.
        const Eigen::VectorXd scale =
          (m->stiffness.diagonal().cwiseAbs() +
           std::norm(guess) * m->mass.diagonal().cwiseAbs())
            .cwiseMax(1e-300)
            .cwiseSqrt()
            .cwiseInverse();
        for (Eigen::MatrixXcd *A : {&m->mass, &m->damping, &m->stiffness})
          *A = scale.asDiagonal() * *A * scale.asDiagonal();
        right            = scale.cwiseInverse().asDiagonal() * right;
        left             = scale.cwiseInverse().asDiagonal() * left;
        mean             = guess;
        half             = std::sqrt(square);
        bool   converged = false;
        double before    = 1e300;
        for (unsigned int step = 0; step < 20 && !converged; ++step)
          {
            const double change = std::abs(half) > nearly_one * std::abs(mean)
                                    ? improve_each(*m)
                                    : improve_mean(*m);
            if (!(change < 0.5 * std::abs(mean)))
              return false;
            // As far as rounding of stiff problems lets it.
            converged =
              change <= 1e-12 * std::abs(mean) ||
              (change <= 1e-8 * std::abs(mean) && change > 0.3 * before);
            before = change;
          }
        right = scale.asDiagonal() * right;
        left  = scale.asDiagonal() * left;
        return converged;
      }

      Eigen::MatrixXcd
      right_vectors() const
      {
        return pencil->basis * right;
      }
      Eigen::MatrixXcd
      left_vectors() const
      {
        return pencil->basis * left;
      }
      /** Of half the difference, 1/s^2. */
      Complex
      square() const
      {
        return half * half;
      }

      Complex mean     = 0.; /**< of the two, 1/s */
      Complex half     = 0.; /**< half their difference, 1/s */
      double  coupling = 0.; /**< of two that are nearly one, the size of N less
                                its mean, 1/s */

    private:
      /** Half-differences below which the mean is sought, of |lambda|. */
      static constexpr double nearly_one = 1e-2;

      struct Linearized
      {
        Eigen::MatrixXcd U, V;
        Eigen::Matrix2cd W, slope;
      };

      Linearized
      linearized(const ContinuedMatrices &m, const Complex lambda) const
      {
        const Eigen::Index n  = m.mass.rows();
        Eigen::MatrixXcd   G  = Eigen::MatrixXcd::Zero(n + 2, n + 2),
                         unit = Eigen::MatrixXcd::Zero(n + 2, 2);
        G.topLeftCorner(n, n) =
          lambda * (lambda * m.mass + m.damping) + m.stiffness;
        // By which all other pairs are kept out of W.
        const Eigen::MatrixXcd slope =
          lambda * (2. * lambda * m.mass + m.damping);
        G.topRightCorner(n, 2)   = slope * right;
        G.bottomLeftCorner(2, n) = left.transpose() * slope;
        unit.bottomRows(2).setIdentity();
        const Eigen::PartialPivLU<Eigen::MatrixXcd> lu(G);
        const Eigen::MatrixXcd                      x = lu.solve(unit);
        const Eigen::MatrixXcd y = lu.transpose().solve(unit);
        Linearized             result;
        result.U = x.topRows(n);
        result.V = y.topRows(n);
        result.W = x.bottomRows(2);
        result.slope =
          -result.V.transpose() *
          (2. * lambda * (m.mass * result.U) + m.damping * result.U);
        return result;
      }

      /** One step; how far the mean moves. */
      double
      improve_mean(const ContinuedMatrices &m)
      {
        right                  = orthonormal(right);
        left                   = orthonormal(left);
        const Linearized l     = linearized(m, mean);
        right                  = l.U;
        left                   = l.V;
        Eigen::Matrix2cd N     = -l.slope.inverse() * l.W;
        const Complex    shift = 0.5 * N.trace();
        N.diagonal().array() -= shift;
        half     = std::sqrt(-N.determinant());
        coupling = N.norm();
        mean += shift;
        return std::abs(shift);
      }

      /** One step; how far the eigenvalue that moves farthest does. */
      double
      improve_each(const ContinuedMatrices &m)
      {
        right = orthonormal(right);
        left  = orthonormal(left);
        Eigen::MatrixXcd x(right.rows(), 2), y(left.rows(), 2);
        Complex          lambda[2] = {mean - half, mean + half};
        double           change[2];
        for (int k = 0; k < 2; ++k)
          {
            const Linearized        l = linearized(m, lambda[k]);
            const NearestEigenvalue of_right(
              Eigen::Matrix2cd(-l.slope.inverse() * l.W)),
              of_left(Eigen::Matrix2cd(-l.slope.transpose().inverse() *
                                       l.W.transpose()));
            x.col(k) = l.U * of_right.vector;
            y.col(k) = l.V * of_left.vector;
            x.col(k).normalize();
            y.col(k).normalize();
            lambda[k] += of_right.value;
            change[k] = std::abs(of_right.value);
          }
        right = x;
        left  = y;
        mean  = 0.5 * (lambda[0] + lambda[1]);
        half  = 0.5 * (lambda[1] - lambda[0]);
        return std::max(change[0], change[1]);
      }

      const ContinuedPencil *pencil;
      Eigen::MatrixXcd       right, left;
    };

    struct Iterate
    {
      Complex coordinate, mean, square;
    };

    bool
    lies_by(const Stretch &line, const Complex z, const double margin)
    {
      const double length = line.upper - line.lower;
      return z.real() >= line.lower - margin * length &&
             z.real() <= line.upper + margin * length &&
             std::abs(z.imag()) <= (imaginary_margin + margin) * length;
    }

    /** Secant steps to the root of the square; @p here ends there. */
    bool
    reach_root(EigenvaluePlane &plane,
               Iterate          before,
               Iterate         &here,
               const Stretch   &line)
    {
      const double length = line.upper - line.lower;
      for (unsigned int step = 0; step < 60; ++step)
        {
          const Complex difference = here.square - before.square;
          if (difference == 0.)
            return false;
          const Complex last   = here.coordinate - before.coordinate;
          Complex       change = -here.square / difference * last;
          // The two are followed, no others taken up on the way.
          if (std::abs(change) > longest_step * length)
            change *= longest_step * length / std::abs(change);
          const Complex z = here.coordinate + change, share = change / last;
          if (!lies_by(line, z, 0.5) ||
              !plane.go_to(z,
                           here.mean + (here.mean - before.mean) * share,
                           here.square + difference * share))
            return false;
          before = here;
          here   = {z, plane.mean, plane.square()};
          if (std::abs(change) <= least_step * length)
            return true;
        }
      return false;
    }

    /** Whether the plane at a root of the square is that of an eigenvalue with
     * one vector, and the root a simple one, round which the two are exchanged.
     */
    bool
    is_exceptional(const EigenvaluePlane &plane,
                   const Iterate         &root,
                   const double           length)
    {
      const double split = std::sqrt(std::abs(root.square));
      if (split > no_split * std::abs(root.mean) ||
          plane.coupling < least_coupling * split)
        return false;
      Complex change[2];
      for (int k = 0; k < 2; ++k)
        {
          EigenvaluePlane near = plane;
          if (!near.go_to(root.coordinate + (k + 1.) * probe_step * length,
                          root.mean,
                          root.square))
            return false;
          change[k] = near.square() - root.square;
        }
      // Twice the change of a simple root, four times that of a double one.
      return std::abs(change[1] - 2. * change[0]) < 0.5 * std::abs(change[0]);
    }

    /** The two of a point on the line in a small problem. */
    std::optional<EigenvaluePlane>
    plane_at(const TrackedPoint    &point,
             const int              branch_1,
             const int              branch_2,
             const ContinuedPencil &pencil,
             Iterate               &iterate)
    {
      const int        i = point.pair_of(branch_1), j = point.pair_of(branch_2);
      Eigen::MatrixXcd right(point.pairs.right.rows(), 2),
        left(point.pairs.left.rows(), 2);
      right << point.pairs.right.col(i), point.pairs.right.col(j);
      left << point.pairs.left.col(i), point.pairs.left.col(j);
      EigenvaluePlane plane(pencil, right, left);
      const Complex   half =
        0.5 * (point.pairs.lambda[j] - point.pairs.lambda[i]);
      if (!plane.go_to(
            point.coordinate, point.pairs.lambda[i] + half, half * half))
        return {};
      iterate = {point.coordinate, plane.mean, plane.square()};
      return plane;
    }
  } // namespace



  std::optional<Coalescence>
  coalescence_of(const Continuation &continuation,
                 const TrackedPoint &a,
                 const TrackedPoint &b,
                 const int           branch_1,
                 const int           branch_2,
                 const Stretch      &line)
  {
    const double length   = line.upper - line.lower;
    const auto   problems = continuation(0.5 * (a.coordinate + b.coordinate));
    Iterate      before, here;
    auto         first = plane_at(a, branch_1, branch_2, problems[0], before),
         plane         = plane_at(b, branch_1, branch_2, problems[0], here);
    if (!first || !plane)
      return {};
    if (std::abs(before.square) < std::abs(here.square))
      {
        std::swap(first, plane);
        std::swap(before, here);
      }
    if (!reach_root(*plane, before, here, line))
      return {};
    for (std::size_t k = 1; k < problems.size(); ++k)
      {
        EigenvaluePlane better(
          problems[k], plane->right_vectors(), plane->left_vectors());
        const Complex aside = here.coordinate + start_step * length;
        if (!better.go_to(aside, here.mean, here.square))
          return {};
        before = {aside, better.mean, better.square()};
        if (!better.go_to(here.coordinate, here.mean, here.square))
          return {};
        here = {here.coordinate, better.mean, better.square()};
        if (!reach_root(better, before, here, line))
          return {};
        plane = better;
      }
    const Complex z = here.coordinate;
    if (z.real() < line.lower - real_margin * length ||
        z.real() > line.upper + real_margin * length ||
        std::abs(z.imag()) > imaginary_margin * length ||
        !is_exceptional(*plane, here, length))
      return {};
    Coalescence result{z, here.mean, {here.mean, here.mean}};
    if (plane->go_to(z.real(), here.mean, here.square))
      {
        result.beside[0] = plane->mean - plane->half;
        result.beside[1] = plane->mean + plane->half;
      }
    return result;
  }
} // namespace squeal
