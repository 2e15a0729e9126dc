// SPDX-License-Identifier: LGPL-2.1-or-later

// The quadratic pencil of an AffineSystem at one set of parameters.

#include <squeal/base/sum_operator.h>
#include <squeal/discretization/affine_system.h>

#include <cmath>

namespace squeal
{
  namespace
  {
    bool
    is_zero(const TermCoefficients &c)
    {
      return c.mass == 0. && c.damping == 0. && c.stiffness == 0.;
    }

    /** The factor f with a = f b, or 0 where a and b are not proportional. */
    double
    ratio(const TermCoefficients &a, const TermCoefficients &b)
    {
      const double f     = b.mass != 0. ? a.mass / b.mass
                           : b.stiffness.real() != 0.
                             ? a.stiffness.real() / b.stiffness.real()
                           : b.damping != 0. ? a.damping / b.damping
                                             : 0.;
      const auto   close = [](const double x, const double y) {
        return std::abs(x - y) <= 1e-14 * std::abs(x);
      };
      return close(a.mass, f * b.mass) && close(a.damping, f * b.damping) &&
                 close(a.stiffness.real(), f * b.stiffness.real()) &&
                 close(a.stiffness.imag(), f * b.stiffness.imag())
               ? f
               : 0.;
    }
  } // namespace



  Pencil::Pencil(const AffineSystem &system, const SceneParameters &parameters)
    : row_space(system.space)
  {
    struct Group
    {
      TermCoefficients               coefficients;
      bool                           symmetric;
      std::vector<SumOperator::Part> parts;
    };
    std::vector<Group> groups;
    for (const auto &term : system.terms)
      {
        const TermCoefficients c         = term.coefficients(parameters);
        const bool             symmetric = term.matrix->is_symmetric();
        if (is_zero(c))
          continue;
        bool placed = false;
        for (auto &group : groups)
          if (const double f = ratio(c, group.coefficients);
              f != 0. && symmetric == group.symmetric)
            {
              group.parts.emplace_back(f, term.matrix);
              placed = true;
              break;
            }
        if (!placed)
          groups.push_back({c, symmetric, {{1., term.matrix}}});
      }
    for (auto &group : groups)
      all_parts.push_back(
        {std::make_shared<SumOperator>(std::move(group.parts)),
         group.coefficients,
         group.symmetric});
  }



  Pencil
  Pencil::unmerged(const AffineSystem    &system,
                   const SceneParameters &parameters)
  {
    Pencil pencil;
    pencil.row_space = system.space;
    for (const auto &term : system.terms)
      pencil.all_parts.push_back({term.matrix,
                                  term.coefficients(parameters),
                                  term.matrix->is_symmetric()});
    return pencil;
  }



  const std::vector<Pencil::Part> &
  Pencil::parts() const
  {
    return all_parts;
  }

  std::shared_ptr<const RowSpace>
  Pencil::space() const
  {
    return row_space;
  }

  bool
  Pencil::has_structural_damping() const
  {
    for (const auto &part : all_parts)
      if (part.coefficients.stiffness.imag() != 0.)
        return true;
    return false;
  }



  bool
  Pencil::is_rayleigh_damped(double &alpha, double &beta) const
  {
    bool have_alpha = false, have_beta = false;
    alpha = beta = 0.;
    for (const auto &part : all_parts)
      {
        const auto  &c = part.coefficients;
        const double k = c.stiffness.real();
        if (c.stiffness.imag() != 0. || (c.mass != 0.) == (k != 0.))
          return false;
        const double value  = c.damping / (c.mass != 0. ? c.mass : k);
        double      &common = c.mass != 0. ? alpha : beta;
        bool        &have   = c.mass != 0. ? have_alpha : have_beta;
        if (have && std::abs(value - common) > 1e-12 * std::abs(common))
          return false;
        common = value;
        have   = true;
      }
    return true;
  }



  bool
  Pencil::is_viscously_damped() const
  {
    for (const auto &part : all_parts)
      if (part.coefficients.stiffness.imag() != 0. ||
          (part.coefficients.damping != 0. && !part.symmetric))
        return false;
    return true;
  }

  Pencil
  Pencil::combined(const double mass,
                   const double damping,
                   const double stiffness) const
  {
    Pencil result;
    result.row_space = row_space;
    for (const auto &part : all_parts)
      if (part.symmetric)
        {
          const auto      &c = part.coefficients;
          TermCoefficients sum;
          sum.stiffness = mass * c.mass + damping * c.damping +
                          stiffness * c.stiffness.real();
          if (!is_zero(sum))
            result.all_parts.push_back({part.matrix, sum, true});
        }
    return result;
  }



  Pencil::Products
  Pencil::apply(const ComplexBlock &X, const bool transposed) const
  {
    Products result{ComplexBlock::Zero(X.rows(), X.cols()),
                    ComplexBlock::Zero(X.rows(), X.cols()),
                    ComplexBlock::Zero(X.rows(), X.cols())};
    Block    both(X.rows(), 2 * X.cols());
    both.leftCols(X.cols())  = X.real();
    both.rightCols(X.cols()) = X.imag();
    for (const auto &part : all_parts)
      {
        const Block Z = transposed ? part.matrix->multiply_transposed(both)
                                   : part.matrix->multiply(both);
        const auto &c = part.coefficients;
        for (Eigen::Index j = 0; j < X.cols(); ++j)
          {
            const auto re = Z.col(j), im = Z.col(X.cols() + j);
            if (c.mass != 0.)
              {
                result.mass.col(j).real() += c.mass * re;
                result.mass.col(j).imag() += c.mass * im;
              }
            if (c.damping != 0.)
              {
                result.damping.col(j).real() += c.damping * re;
                result.damping.col(j).imag() += c.damping * im;
              }
            if (c.stiffness != 0.)
              {
                const double k = c.stiffness.real(), h = c.stiffness.imag();
                result.stiffness.col(j).real() += k * re - h * im;
                result.stiffness.col(j).imag() += k * im + h * re;
              }
          }
      }
    return result;
  }

  Pencil::Products
  Pencil::apply(const ComplexBlock &X) const
  {
    return apply(X, false);
  }

  Pencil::Products
  Pencil::apply_transposed(const ComplexBlock &X) const
  {
    return apply(X, true);
  }



  Block
  Pencil::multiply_symmetric(
    const Block &X,
    double (*coefficient)(const TermCoefficients &)) const
  {
    Block result;
    for (const auto &part : all_parts)
      if (const double c = coefficient(part.coefficients);
          part.symmetric && c != 0.)
        {
          if (result.size() > 0)
            part.matrix->add_product(c, X, result);
          else
            {
              result = part.matrix->multiply(X);
              if (c != 1.)
                result *= c;
            }
        }
    return result.size() > 0 ? result : Block(Block::Zero(X.rows(), X.cols()));
  }

  Block
  Pencil::multiply_mass(const Block &X) const
  {
    return multiply_symmetric(X,
                              [](const TermCoefficients &c) { return c.mass; });
  }

  Block
  Pencil::multiply_damping(const Block &X) const
  {
    return multiply_symmetric(
      X, [](const TermCoefficients &c) { return c.damping; });
  }

  Block
  Pencil::multiply_undamped_stiffness(const Block &X) const
  {
    return multiply_symmetric(
      X, [](const TermCoefficients &c) { return c.stiffness.real(); });
  }



  Eigen::VectorXd
  Pencil::stiffness_rounding_size(const ComplexBlock &X) const
  {
    Block       sum  = Block::Zero(X.rows(), X.cols());
    const Block size = X.cwiseAbs();
    for (const auto &part : all_parts)
      if (part.coefficients.stiffness != 0.)
        sum += std::abs(part.coefficients.stiffness) *
               part.matrix->multiply_absolute(size);
    return row_space->norms(sum);
  }



  Triplets
  Pencil::undamped_entries(const double shift) const
  {
    Triplets triplets;
    for (const auto &part : all_parts)
      {
        const auto  &c = part.coefficients;
        const double f = c.stiffness.real() - shift * c.mass;
        if (part.symmetric && f != 0.)
          part.matrix->append_to(triplets, f, true);
      }
    return triplets;
  }

  void
  Pencil::quadratic_entries(const std::complex<double>         lambda,
                            std::vector<int>                  &rows,
                            std::vector<int>                  &columns,
                            std::vector<std::complex<double>> &values) const
  {
    for (const auto &part : all_parts)
      {
        const auto &c = part.coefficients;
        const auto  f =
          lambda * lambda * c.mass + lambda * c.damping + c.stiffness;
        Triplets triplets;
        part.matrix->append_to(triplets, 1., false);
        rows.insert(rows.end(), triplets.rows.begin(), triplets.rows.end());
        columns.insert(
          columns.end(), triplets.columns.begin(), triplets.columns.end());
        for (const double a : triplets.values)
          values.push_back(f * a);
      }
  }
} // namespace squeal
