// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/transient/kept_inverse.h>

namespace squeal
{
  template <typename Scalar>
  void
  KeptInverse<Scalar>::invert(const Eigen::MatrixXd  &J,
                              const std::vector<int> &closed,
                              const std::vector<int> &open)
  {
    // Rows of open nodes are those of the identity.
    inverse = Matrix::Identity(J.rows(), J.cols());
    if (closed.empty())
      return;
    const Matrix square     = J(closed, closed).template cast<Scalar>();
    const Matrix part       = square.partialPivLu().inverse();
    inverse(closed, closed) = part;
    if (!open.empty())
      {
        const Matrix rest     = J(closed, open).template cast<Scalar>();
        inverse(closed, open) = Matrix(-part * rest);
      }
  }



  template <typename Scalar>
  void
  KeptInverse<Scalar>::clear()
  {
    difference.resize(0, inverse.cols());
    columns.resize(inverse.rows(), 0);
    small.resize(0, 0);
  }



  template <typename Scalar>
  void
  KeptInverse<Scalar>::extend(const Eigen::MatrixXd           &changes,
                              const std::vector<unsigned int> &places,
                              const std::vector<unsigned int> &nodes)
  {
    const Eigen::Index n_old = columns.cols(), n = 3 * nodes.size();
    difference.conservativeResize(n, inverse.cols());
    columns.conservativeResize(inverse.rows(), n);
    small.conservativeResize(n, n);
    for (Eigen::Index k = n_old; k < n; k += 3)
      columns.template middleCols<3>(k) =
        inverse.template middleCols<3>(3 * nodes[k / 3]);
    const Matrix rows = changes.cast<Scalar>();
    for (std::size_t i = 0; i < places.size(); ++i)
      difference.template middleRows<3>(3 * places[i]) =
        rows.template middleRows<3>(3 * i);
    // New columns of all rows, then all columns of the new rows.
    if (n > n_old)
      small.rightCols(n - n_old).noalias() =
        difference * columns.rightCols(n - n_old);
    if (n_old > 0 && !places.empty())
      {
        const Matrix products = rows * columns.leftCols(n_old);
        for (std::size_t i = 0; i < places.size(); ++i)
          small.template middleRows<3>(3 * places[i]).leftCols(n_old) =
            products.template middleRows<3>(3 * i);
      }
    factorize();
  }



  template <typename Scalar>
  void
  KeptInverse<Scalar>::factorize()
  {
    if (small.rows() > 0)
      small_factor.compute(
        Matrix(small + Matrix::Identity(small.rows(), small.cols())));
  }



  template <typename Scalar>
  Eigen::VectorXd
  KeptInverse<Scalar>::apply(const Eigen::VectorXd &v) const
  {
    using Vector  = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;
    Vector change = inverse * Vector(v.cast<Scalar>());
    if (columns.cols() > 0)
      change.noalias() -=
        columns * Vector(small_factor.solve(Vector(difference * change)));
    return change.template cast<double>();
  }

  template struct KeptInverse<float>;
  template struct KeptInverse<double>;
} // namespace squeal
