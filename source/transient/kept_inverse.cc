// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/transient/kept_inverse.h>

namespace squeal
{
  namespace
  {
    /** Applications after which the whole inverse pays. */
    constexpr unsigned int worth_inverting = 60;
  } // namespace



  bool
  NodeRows::is_near(const NodeRows &other) const
  {
    return status == other.status &&
           (status == ContactStatus::open ||
            std::abs(friction - other.friction) <= 1e-3) &&
           (status != ContactStatus::slip ||
            ((direction - other.direction).squaredNorm() <= 0.01 &&
             std::abs(turning - other.turning) <= 0.1 * (1. + other.turning) &&
             std::abs(along - other.along) <= 0.02));
  }

  bool
  NodeRows::is_limited() const
  {
    return status == ContactStatus::slip && along == 0.;
  }



  template <typename Scalar>
  void
  KeptInverse<Scalar>::invert(const Jacobian              &J,
                              const std::vector<NodeRows> &nodes)
  {
    using Vector = Eigen::Matrix<Scalar, 3, 1>;
    base         = nodes;
    inverse.resize(0, 0);
    applications = 0;
    unknowns.clear();
    for (std::size_t j = 0; j < nodes.size(); ++j)
      {
        const Eigen::Index first = 3 * j;
        const auto d = nodes[j].direction.template cast<Scalar>().eval();
        if (nodes[j].is_limited())
          {
            const Scalar mu = static_cast<Scalar>(nodes[j].friction);
            const Vector across(0, -d[1], d[0]);
            unknowns.push_back(
              {first, Vector::Unit(0), Vector(1, mu * d[0], mu * d[1])});
            unknowns.push_back({first, across, across});
          }
        else if (nodes[j].status != ContactStatus::open)
          for (int c = 0; c < 3; ++c)
            unknowns.push_back({first, Vector::Unit(c), Vector::Unit(c)});
      }
    const Eigen::Index m = unknowns.size();
    equations.resize(m, J.cols());
    Rows square(m, m);
    for (Eigen::Index i = 0; i < m; ++i)
      {
        const Unknown &u   = unknowns[i];
        auto           row = equations.row(i);
        if (u.row[0] == Scalar(1))
          row = J.row(u.first).template cast<Scalar>();
        else
          row = u.row[1] * J.row(u.first + 1).template cast<Scalar>() +
                u.row[2] * J.row(u.first + 2).template cast<Scalar>();
        for (Eigen::Index k = 0; k < m; ++k)
          square(i, k) =
            row.template segment<3>(unknowns[k].first).dot(unknowns[k].motion);
      }
    if (m > 0)
      factor.compute(square);
  }



  template <typename Scalar>
  template <typename Right>
  Right
  KeptInverse<Scalar>::solve(const Right &R) const
  {
    if (inverse.size() > 0)
      return inverse * R;
    // The part of the solution that the equations need not be solved for.
    Right result = R;
    for (std::size_t j = 0; j < base.size(); ++j)
      {
        auto x = result.template middleRows<3>(3 * j);
        if (base[j].status != ContactStatus::open && !base[j].is_limited())
          x.setZero();
        else if (base[j].is_limited())
          for (Eigen::Index k = 0; k < x.cols(); ++k)
            {
              const auto   d  = base[j].direction.template cast<Scalar>();
              const Scalar mu = static_cast<Scalar>(base[j].friction);
              const Scalar along =
                d[0] * x(1, k) + d[1] * x(2, k) - mu * x(0, k);
              x.col(k) << 0, along * d[0], along * d[1];
            }
      }
    if (unknowns.empty())
      return result;
    Right y = -(equations * result);
    for (std::size_t i = 0; i < unknowns.size(); ++i)
      y.row(i) += unknowns[i].row.transpose() *
                  R.template middleRows<3>(unknowns[i].first);
    y = factor.solve(y).eval();
    for (std::size_t i = 0; i < unknowns.size(); ++i)
      result.template middleRows<3>(unknowns[i].first) +=
        unknowns[i].motion * y.row(i);
    return result;
  }



  template <typename Scalar>
  void
  KeptInverse<Scalar>::clear()
  {
    const Eigen::Index n = 3 * base.size();
    difference.resize(0, n);
    columns.resize(n, 0);
    small.resize(0, 0);
  }



  template <typename Scalar>
  void
  KeptInverse<Scalar>::extend(const Jacobian                  &changes,
                              const std::vector<unsigned int> &places,
                              const std::vector<unsigned int> &nodes)
  {
    const Eigen::Index all   = 3 * base.size();
    const Eigen::Index n_old = columns.cols(), n = 3 * nodes.size();
    difference.conservativeResize(n, all);
    columns.conservativeResize(all, n);
    small.conservativeResize(n, n);
    if (n > n_old)
      {
        Matrix units = Matrix::Zero(all, n - n_old);
        for (Eigen::Index k = n_old; k < n; ++k)
          units(3 * nodes[k / 3] + k % 3, k - n_old) = 1;
        columns.rightCols(n - n_old) = solve(units);
      }
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
  KeptInverse<Scalar>::apply(const Eigen::VectorXd &v)
  {
    using Vector = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;
    if (++applications == worth_inverting)
      inverse = solve(Matrix(Matrix::Identity(v.size(), v.size())));
    Vector change = solve(Vector(v.cast<Scalar>()));
    if (columns.cols() > 0)
      change.noalias() -=
        columns * Vector(small_factor.solve(Vector(difference * change)));
    return change.template cast<double>();
  }



  template <typename Scalar>
  const typename KeptInverse<Scalar>::Matrix &
  KeptInverse<Scalar>::changed_columns() const
  {
    return columns;
  }

  template <typename Scalar>
  const typename KeptInverse<Scalar>::Matrix &
  KeptInverse<Scalar>::change_matrix() const
  {
    return small;
  }

  template <typename Scalar>
  unsigned int
  KeptInverse<Scalar>::n_applied() const
  {
    return applications;
  }

  template <typename Scalar>
  void
  KeptInverse<Scalar>::restore(const Matrix      &changed_columns,
                               const Matrix      &change_matrix,
                               const unsigned int n_applied)
  {
    // Both have grown bit by bit: they are taken as they were.
    columns = changed_columns;
    small   = change_matrix;
    factorize();
    applications         = n_applied;
    const Eigen::Index m = 3 * base.size();
    if (n_applied >= worth_inverting)
      inverse = solve(Matrix(Matrix::Identity(m, m)));
  }

  template class KeptInverse<float>;
  template class KeptInverse<double>;
} // namespace squeal
