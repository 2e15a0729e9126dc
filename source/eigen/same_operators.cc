// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/eigen/same_operators.h>

#include <cmath>
#include <random>
#include <utility>

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

    /** What mass, damping and stiffness do to a vector, and the sizes row by
     * row, |A| |v|, that rounding is a share of. */
    struct RowsOfOperators
    {
      ComplexBlock mass, damping, stiffness;
    };

    /** Those of the symmetric parts alone, or of all. */
    enum class ComparedParts
    {
      all,
      symmetric
    };

    RowsOfOperators
    sizes_of_rows(const Pencil       &pencil,
                  const Block        &v,
                  const ComparedParts which)
    {
      const Block     size = v.cwiseAbs();
      RowsOfOperators result;
      result.mass = result.damping = result.stiffness =
        ComplexBlock::Zero(v.rows(), v.cols());
      for (const auto &part : pencil.parts())
        if (which == ComparedParts::all || part.symmetric)
          {
            const Block z = part.matrix->multiply_absolute(size);
            const auto &c = part.coefficients;
            result.mass += std::abs(c.mass) * z;
            result.damping += std::abs(c.damping) * z;
            result.stiffness += std::abs(c.stiffness) * z;
          }
      // Of a row without a dashpot of its own damping is rounding: small is
      // what is so beside its critical damping.
      result.damping +=
        2. * (result.mass.cwiseProduct(result.stiffness)).cwiseSqrt();
      return result;
    }

    RowsOfOperators
    products_of(const Pencil &pencil, const Block &v, const ComparedParts which)
    {
      if (which == ComparedParts::symmetric)
        return {pencil.multiply_mass(v),
                pencil.multiply_damping(v),
                pencil.multiply_undamped_stiffness(v)};
      Pencil::Products p = pencil.apply(v);
      return {std::move(p.mass), std::move(p.damping), std::move(p.stiffness)};
    }

    /** Whether no row of @p x and @p y differs by more than rounding of its
     * own @p size: that of the whole vector would be the one of the stiffest
     * spring. False where one is no number. */
    bool
    same_rows(const RowSpace     &space,
              const ComplexBlock &x,
              const ComplexBlock &y,
              const ComplexBlock &size)
    {
      Eigen::MatrixXd n_same(1, 1);
      n_same(0, 0) =
        ((x - y).cwiseAbs().array() <= rounding * size.real().array()).count();
      space.sum(n_same);
      return n_same(0, 0) == space.n_global() * x.cols();
    }

    bool
    same_parts(const Pencil &a, const Pencil &b, const ComparedParts which)
    {
      if (!have_same_rows(a, b))
        return false;
      const RowSpace       &space = *a.space();
      const Block           v     = random_vector(space);
      const RowsOfOperators sizes = sizes_of_rows(a, v, which);
      const RowsOfOperators x     = products_of(a, v, which),
                            y     = products_of(b, v, which);
      return same_rows(space, x.mass, y.mass, sizes.mass) &&
             same_rows(space, x.damping, y.damping, sizes.damping) &&
             same_rows(space, x.stiffness, y.stiffness, sizes.stiffness);
    }
  } // namespace



  bool
  same_operators(const Pencil &a, const Pencil &b)
  {
    return same_parts(a, b, ComparedParts::all);
  }

  bool
  same_symmetric_operators(const Pencil &a, const Pencil &b)
  {
    return same_parts(a, b, ComparedParts::symmetric);
  }
} // namespace squeal
