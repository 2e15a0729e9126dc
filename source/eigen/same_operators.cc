// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/eigen/same_operators.h>

#include <random>

namespace squeal
{
  namespace
  {
    /** What two assemblies of one operator may differ by. */
    constexpr double rounding = 1e-11;

    bool
    have_same_rows(const Pencil &a, const Pencil &b)
    {
      // Every rank must come to the same answer.
      Eigen::MatrixXd differ(1, 1);
      differ(0, 0) = a.space()->n_owned() != b.space()->n_owned();
      a.space()->sum(differ);
      return differ(0, 0) == 0.;
    }

    Block
    random_vector(const RowSpace &space)
    {
      std::mt19937_64                        generator(space.first_owned());
      std::uniform_real_distribution<double> between(-1., 1.);
      Block                                  result(space.n_owned(), 1);
      for (Eigen::Index i = 0; i < result.rows(); ++i)
        result(i, 0) = between(generator);
      return result;
    }

    /** Columns of @p x and @p y in pairs; false where one is no number. */
    template <typename Vectors>
    bool
    same_columns(const RowSpace &space, const Vectors &x, const Vectors &y)
    {
      Eigen::MatrixXd squares(2, x.cols());
      squares.row(0) = x.colwise().squaredNorm();
      squares.row(1) = (x - y).colwise().squaredNorm();
      space.sum(squares);
      return (squares.row(1).array() <=
              rounding * rounding * squares.row(0).array())
        .all();
    }
  } // namespace



  bool
  same_operators(const Pencil &a, const Pencil &b)
  {
    if (!have_same_rows(a, b))
      return false;
    const RowSpace        &space = *a.space();
    const ComplexBlock     v     = random_vector(space);
    const Pencil::Products x = a.apply(v), y = b.apply(v);
    return same_columns(space, x.mass, y.mass) &&
           same_columns(space, x.damping, y.damping) &&
           same_columns(space, x.stiffness, y.stiffness);
  }

  bool
  same_symmetric_operators(const Pencil &a, const Pencil &b)
  {
    if (!have_same_rows(a, b))
      return false;
    const RowSpace &space = *a.space();
    const Block     v     = random_vector(space);
    return same_columns(space, a.multiply_mass(v), b.multiply_mass(v)) &&
           same_columns(space, a.multiply_damping(v), b.multiply_damping(v)) &&
           same_columns(space,
                        a.multiply_undamped_stiffness(v),
                        b.multiply_undamped_stiffness(v));
  }
} // namespace squeal
