// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/assignment.h>
#include <squeal/eigen/mode_naming.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <numeric>

namespace squeal
{
  namespace
  {
    /** The last column of each run of neighbours closer than the tolerance. */
    template <typename Values>
    std::vector<unsigned int>
    ends_of_clusters(const Values &values, const double tolerance)
    {
      std::vector<unsigned int> ends;
      const unsigned int        n = values.size();
      for (unsigned int i = 0; i < n; ++i)
        if (i + 1 == n || std::abs(values[i + 1] - values[i]) >
                            tolerance * std::abs(values[i + 1]))
          ends.push_back(i + 1);
      return ends;
    }

    /** +1 or -1 such that the first of the largest entries becomes positive. */
    double
    sign_of(const Eigen::VectorXd &coordinates)
    {
      const double limit = 0.999 * coordinates.cwiseAbs().maxCoeff();
      for (const double value : coordinates)
        if (std::abs(value) >= limit)
          return value < 0. ? -1. : 1.;
      return 1.;
    }

    /** Columns of eigenvalues that differ by less, relatively, are named by
     * their space: a weakly held disc splits its in-plane doublets by some
     * 1e-6, and friction mixes such pairs by chance. */
    constexpr double multiple_tolerance = 1e-5;
    /** Columns whose Gram matrix has a smaller eigenvalue are nearly one
     * vector, as those of a pair next to its lock-in: they have no space. */
    constexpr double independent = 0.05;

    /** Orthonormal columns that diagonalise the form of the weights in the
     * space of the normalised columns of @p C, largest value first; empty if
     * they are nearly dependent. */
    Eigen::MatrixXcd
    shapes_of_space(const Eigen::MatrixXcd &C, const Eigen::VectorXd &weights)
    {
      using Solver = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXcd>;
      const Solver gram(C.adjoint() * C);
      if (!(gram.eigenvalues()[0] > independent))
        return {};
      const Eigen::MatrixXcd Q =
        C * gram.eigenvectors() *
        gram.eigenvalues().cwiseSqrt().cwiseInverse().asDiagonal();
      const Solver form(Q.adjoint() * weights.asDiagonal() * Q);
      return Q * form.eigenvectors().rowwise().reverse();
    }
  } // namespace



  Eigen::VectorXd
  ModeNamer::mirror_weights() const
  {
    Eigen::VectorXd weights(total_coordinates);
    for (const auto &body : bodies)
      {
        const Eigen::VectorXd part = body.disc ? body.disc->mirror_weights()
                                               : body.solid->mirror_weights();
        weights.segment(body.first_coordinate, part.size()) = part;
      }
    return weights;
  }



  std::vector<unsigned int>
  ModeNamer::order_of_shapes(const Eigen::MatrixXd &coordinates) const
  {
    std::vector<unsigned int> order(coordinates.cols());
    std::iota(order.begin(), order.end(), 0);
    std::vector<std::pair<unsigned int, std::string>> keys(order.size());
    for (const auto &body : bodies)
      if (body.disc)
        for (unsigned int i = 0; i < order.size(); ++i)
          {
            const Eigen::VectorXd own = coordinates.col(i).segment(
              body.first_coordinate, body.disc->n_coordinates());
            // Motions of other bodies come first and stay as they are.
            if (own.squaredNorm() < 0.5 * coordinates.col(i).squaredNorm())
              continue;
            const auto shape =
              body.disc->classify(own.cast<std::complex<double>>()).front();
            // "+" sorts before "-".
            keys[i] = {1 + shape.nodal_diameters, shape.parity};
          }
    std::stable_sort(order.begin(),
                     order.end(),
                     [&](const unsigned int a, const unsigned int b) {
                       return keys[a] < keys[b];
                     });
    return order;
  }



  Block
  ModeNamer::separate_multiple(const Block               &modes,
                               const std::vector<double> &frequencies,
                               const double               tolerance) const
  {
    AssertDimension(frequencies.size(), modes.cols());
    Block result = modes;
    if (bodies.empty())
      return result;
    const Eigen::VectorXd weights = mirror_weights();
    unsigned int          begin   = 0;
    for (const unsigned int end : ends_of_clusters(frequencies, tolerance))
      {
        const unsigned int n = end - begin;
        if (n > 1)
          {
            const Block           cluster = modes.middleCols(begin, n);
            const Eigen::MatrixXd C       = coordinates(cluster);
            const Eigen::MatrixXd form =
              C.transpose() * weights.asDiagonal() * C;
            const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(form);
            Eigen::MatrixXd R = eigen.eigenvectors().rowwise().reverse();
            for (unsigned int i = 0; i < n; ++i)
              R.col(i) *= sign_of(C * R.col(i));
            const auto order = order_of_shapes(C * R);
            for (unsigned int i = 0; i < n; ++i)
              result.col(begin + i) = cluster * R.col(order[i]);
          }
        begin = end;
      }
    return result;
  }



  Eigen::MatrixXcd
  ModeNamer::separated(const Eigen::MatrixXcd &coordinates,
                       const Eigen::VectorXcd &eigenvalues) const
  {
    Eigen::MatrixXcd result = coordinates;
    if (eigenvalues.size() == 0)
      return result;
    AssertDimension(eigenvalues.size(), coordinates.cols());
    const Eigen::VectorXd weights = mirror_weights();
    unsigned int          begin   = 0;
    for (const unsigned int end :
         ends_of_clusters(eigenvalues, multiple_tolerance))
      {
        const unsigned int     n = end - begin;
        const Eigen::MatrixXcd members =
          coordinates.middleCols(begin, n).colwise().normalized();
        const Eigen::MatrixXcd shapes =
          n > 1 ? shapes_of_space(members, weights) : Eigen::MatrixXcd();
        if (shapes.cols() > 0)
          {
            // The given order unless a member clearly is another shape.
            std::vector<std::vector<double>> costs(n, std::vector<double>(n));
            for (unsigned int i = 0; i < n; ++i)
              for (unsigned int j = 0; j < n; ++j)
                costs[i][j] = (i == j ? 0. : 0.1) -
                              std::norm(shapes.col(j).dot(members.col(i)));
            const auto shape = smallest_assignment(costs);
            for (unsigned int i = 0; i < n; ++i)
              result.col(begin + i) = shapes.col(shape[i]);
          }
        begin = end;
      }
    return result;
  }
} // namespace squeal
