// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/sweep/continued_pencils.h>

#include <algorithm>
#include <cmath>

namespace squeal
{
  namespace
  {
    using Complex = std::complex<double>;

    /** A basis that is larger has a smaller one before it. */
    constexpr unsigned int small_basis = 100;
    /** Of the largest value of a coefficient. */
    constexpr double fit_tolerance = 1e-10;
    /** How far polynomials that are no lines are continued, half lengths. */
    constexpr double farthest = 2.;

    /** mass, damping, stiffness and loss of every part, one after the other. */
    Eigen::RowVectorXd
    values_at(const ParametricSystem &system, SweepPoint point, const double x)
    {
      point[0]                        = x;
      const auto         coefficients = system.coefficients(point);
      Eigen::RowVectorXd result(4 * coefficients.size());
      for (std::size_t p = 0; p < coefficients.size(); ++p)
        result.segment<4>(4 * p) << coefficients[p].mass,
          coefficients[p].damping, coefficients[p].stiffness.real(),
          coefficients[p].stiffness.imag();
      return result;
    }

    /** Lagrange's polynomials of @p nodes. */
    Eigen::RowVectorXcd
    lagrange(const std::vector<double> &nodes, const Complex z)
    {
      Eigen::RowVectorXcd result(nodes.size());
      for (std::size_t i = 0; i < nodes.size(); ++i)
        {
          Complex product = 1.;
          for (std::size_t k = 0; k < nodes.size(); ++k)
            if (k != i)
              product *= (z - nodes[k]) / (nodes[i] - nodes[k]);
          result[i] = product;
        }
      return result;
    }

    /** Where one law holds about @p x: a segment of a list, and the points that
     * have the contact state of the nearest one. */
    Stretch
    stretch_of_law(const SweepGrid &grid, const SweepPoint &start, double x)
    {
      const std::vector<double> &at = grid.coordinates(0);
      Stretch                    s{grid.lower(0), grid.upper(0)};
      x = std::clamp(x, s.lower, s.upper);
      if (grid.axis(0).scale == SweepAxisParameters::Scale::list)
        for (const double value : at)
          {
            if (value <= x && value < s.upper)
              s.lower = value;
            if (value > x && value < s.upper)
              s.upper = value;
          }
      const auto state_at = [&](const double y) {
        SweepPoint point = start;
        point[0]         = y;
        return grid.state_number(point);
      };
      if (grid.n_states() < 2)
        return s;
      const unsigned int state = state_at(x);
      for (std::size_t k = 0; k + 1 < at.size(); ++k)
        {
          const double change   = 0.5 * (at[k] + at[k + 1]),
                       rounding = 1e-9 * (at[k + 1] - at[k]);
          if (state_at(at[k]) != state && change <= x)
            s.lower = std::max(s.lower, change + rounding);
          if (state_at(at[k + 1]) != state && change > x)
            s.upper = std::min(s.upper, change - rounding);
        }
      return s;
    }

    /** The coefficients at @p z, or nothing. */
    std::optional<Eigen::RowVectorXcd>
    continued_coefficients(const ParametricSystem &system,
                           const SweepPoint       &start,
                           const Complex           z)
    {
      const Stretch law = stretch_of_law(system.grid(), start, z.real());
      for (const unsigned int degree : {1u, 2u, 4u, 8u, 12u})
        {
          // Lines from afar, what bends from as far as z is from the axis.
          const double whole  = 0.5 * (law.upper - law.lower),
                       half   = degree == 1
                                  ? whole
                                  : std::min(
                                    whole,
                                    std::max(std::abs(z.imag()), 0.02 * whole)),
                       middle = std::clamp(
                         z.real(),
                         law.lower + half,
                         std::max(law.upper - half, law.lower + half));
          if (!(half > 0.) ||
              (degree > 1 && std::abs(z - middle) > farthest * half))
            return {};
          std::vector<double> nodes;
          for (unsigned int k = 0; k <= degree; ++k)
            nodes.push_back(middle - half * std::cos(M_PI * (2. * k + 1.) /
                                                     (2. * (degree + 1))));
          Eigen::MatrixXd samples(nodes.size(),
                                  values_at(system, start, middle).size());
          for (std::size_t k = 0; k < nodes.size(); ++k)
            samples.row(k) = values_at(system, start, nodes[k]);
          const Eigen::RowVectorXd size =
            samples.cwiseAbs().colwise().maxCoeff();
          bool fits = true;
          for (const double share : {-0.95, -0.55, 0.05, 0.65, 0.9})
            {
              const double             x = middle + share * half;
              const Eigen::RowVectorXd error =
                (lagrange(nodes, x).real() * samples -
                 values_at(system, start, x))
                  .cwiseAbs();
              fits =
                fits && (error.array() <= fit_tolerance * size.array()).all();
            }
          if (fits)
            return Eigen::RowVectorXcd(lagrange(nodes, z) *
                                       samples.cast<Complex>());
        }
      return {};
    }

    /** Of the leading @p n vectors of the parts. */
    std::optional<ContinuedMatrices>
    continued_matrices(const ParametricSystem             &system,
                       const std::vector<Eigen::MatrixXd> &parts,
                       const Eigen::Index                  n,
                       const SweepPoint                   &start,
                       const Complex                       z)
    {
      const auto c = continued_coefficients(system, start, z);
      if (!c)
        return {};
      const Eigen::MatrixXcd zero = Eigen::MatrixXcd::Zero(n, n);
      ContinuedMatrices      result{zero, zero, zero};
      for (std::size_t p = 0; p < parts.size(); ++p)
        {
          const auto    A    = parts[p].topLeftCorner(n, n);
          const Complex mass = (*c)[4 * p], damping = (*c)[4 * p + 1],
                        stiffness =
                          (*c)[4 * p + 2] + Complex(0., 1.) * (*c)[4 * p + 3];
          if (mass != 0.)
            result.mass += mass * A;
          if (damping != 0.)
            result.damping += damping * A;
          if (stiffness != 0.)
            result.stiffness += stiffness * A;
        }
      return result;
    }
  } // namespace



  Continuation
  continuation_of(const ParametricSystem &system,
                  const ReducedModel     &model,
                  const SweepPoint       &start)
  {
    return [&system, &model, start](const double x) {
      std::vector<ContinuedPencil> result;
      const Eigen::Index           N = model.n_total();
      if (N > small_basis)
        {
          SweepPoint point         = start;
          point[0]                 = x;
          const ModelCell   &cell  = model.cell_of(point);
          const Eigen::Index n     = cell.local.n_basis;
          const auto        &parts = cell.local.parts;
          result.push_back({[&system, &parts, n, start](const Complex z) {
                              return continued_matrices(
                                system, parts, n, start, z);
                            },
                            cell.turn.leftCols(n)});
        }
      result.push_back({[&system, &model, N, start](const Complex z) {
                          return continued_matrices(
                            system, model.parts, N, start, z);
                        },
                        Eigen::MatrixXd::Identity(N, N)});
      return result;
    };
  }
} // namespace squeal
