// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Derivatives of eigenvalues of a coarse TriboBrake by numbers of its scene
// against central differences of direct solutions.
#include <squeal/sweep/sensitivity.h>

#include "check.h"
#include "coarse_brake.h"
#include "worst.h"

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  using Complex = std::complex<double>;

  /** Of the logarithm of a number, for differences of the fourth order. */
  constexpr double step = 2e-3;

  /** Direct solutions stop at a few 1e-7 1/s, their differences have errors of
   * some 2e-4 1/s: smaller sensitivities have no five digits to compare, but
   * must not differ by more. */
  constexpr double comparable = 25.;

  /** Whether no other eigenvalue is where the steps lead to. */
  bool
  is_alone(const Eigen::VectorXcd &values,
           const unsigned int      i,
           const Eigen::VectorXcd &derivatives)
  {
    for (Eigen::Index j = 0; j < values.size(); ++j)
      if (j != i && std::abs(values[j] - values[i]) <
                      50. * step * std::abs(derivatives[j] - derivatives[i]))
        return false;
    return true;
  }

  Complex
  nearest(const Eigen::VectorXcd &values, const Complex wanted)
  {
    Complex best = values[0];
    for (const Complex &v : values)
      if (std::abs(v - wanted) < std::abs(best - wanted))
        best = v;
    return best;
  }

  /** d/d ln p of what @p value takes from direct solutions. */
  template <typename Function>
  Complex
  derivative(const std::vector<ComplexPairs> &solutions, const Function &value)
  {
    return (8. * (value(solutions[2]) - value(solutions[1])) -
            (value(solutions[3]) - value(solutions[0]))) /
           (12. * step);
  }

  /** At -2, -1, 1 and 2 steps of an entry. */
  std::vector<ComplexPairs>
  about(const CoarseBrake &brake,
        const SweepPoint  &point,
        const unsigned int entry)
  {
    std::vector<ComplexPairs> result;
    for (const int k : {-2, -1, 1, 2})
      result.push_back(
        brake.direct(brake.grid.scene(point, entry, std::exp(k * step))));
    return result;
  }

  /** Mean and squared half-difference of the two eigenvalues nearest to
   * @p wanted. */
  std::pair<Complex, Complex>
  pair_near(const ComplexPairs &pairs, const Complex wanted)
  {
    const Complex    p    = nearest(pairs.lambda, wanted);
    Eigen::VectorXcd rest = pairs.lambda;
    for (Complex &v : rest)
      if (v == p)
        v = 0.;
    const Complex q = nearest(rest, wanted);
    return {0.5 * (p + q), 0.25 * (p - q) * (p - q)};
  }

  void
  away_from_coalescence(const CoarseBrake &brake, const ReducedModel &model)
  {
    const unsigned int n_entries =
      brake.grid.entries().size() + brake.grid.other_entries().size();
    check(n_entries == 6, "two swept numbers and four others");
    const auto   spread = brake.grid.spread(300);
    Worst        worst;
    unsigned int n_pairs = 0;
    for (unsigned int k = 0; k < 8; ++k)
      {
        const SweepPoint   point = spread[spread.size() - 1 - k];
        const ComplexPairs pairs = solve_point_refined(
          model, point, brake.system.coefficients(point), brake.options.band);
        const unsigned int     entry     = k % n_entries;
        const auto             solutions = about(brake, point, entry);
        const Eigen::VectorXcd d =
          sensitivities(model, brake.system, point, pairs, entry);
        for (unsigned int i = 0; i < pairs.size(); ++i)
          if (pairs.condition[i] < 3. && is_alone(pairs.lambda, i, d))
            {
              n_pairs += std::abs(d[i]) > comparable;
              const Complex reference =
                derivative(solutions, [&](const ComplexPairs &p) {
                  return nearest(p.lambda, pairs.lambda[i]);
                });
              worst.add(std::abs(d[i] - reference) /
                        std::max(std::abs(d[i]), comparable));
            }
      }
    std::cout << n_pairs << " pairs, worst " << worst.largest() << "\n";
    check(n_pairs > 30, "pairs away from coalescence");
    check(worst.largest() < 1e-5,
          "sensitivities are central differences to 1e-5");
  }

  void
  beside_a_coalescence(const CoarseBrake &brake, const ReducedModel &model)
  {
    // The closest encounter on a line: the largest condition of all points,
    // then of those around the best.
    SweepPoint   point(2), at(2);
    unsigned int a      = 0;
    double       most   = 0.;
    const auto   search = [&](const double from, const double by, const int n) {
      for (int k = 0; k <= n; ++k)
        {
          point << from + k * by, 0.5;
          const ComplexPairs pairs = brake.solve(model, point);
          for (unsigned int i = 0; i < pairs.size(); ++i)
            if (pairs.condition[i] > most)
              {
                most = pairs.condition[i];
                at   = point;
                a    = i;
              }
        }
    };
    search(9., 0.02, 100);
    search(at[0] - 0.015, 0.005, 6);
    check(most > 20., "a nearly coalesced pair");
    const ComplexPairs pairs = solve_point_refined(
      model, at, brake.system.coefficients(at), brake.options.band);
    unsigned int b = a == 0 ? 1 : a - 1;
    for (unsigned int i = 0; i < pairs.size(); ++i)
      if (i != a && std::abs(pairs.lambda[i] - pairs.lambda[a]) <
                      std::abs(pairs.lambda[b] - pairs.lambda[a]))
        b = i;
    for (const unsigned int entry : {0u, 1u})
      {
        const PairSensitivity own =
          pair_sensitivity(model, brake.system, at, pairs, entry, a, b);
        const auto    solutions = about(brake, at, entry);
        const Complex centre    = 0.5 * (pairs.lambda[a] + pairs.lambda[b]);
        const Complex mean = derivative(solutions, [&](const ComplexPairs &p) {
          return pair_near(p, centre).first;
        });
        const Complex square =
          derivative(solutions, [&](const ComplexPairs &p) {
            return pair_near(p, centre).second;
          });
        const double mean_error   = std::abs(own.mean / mean - 1.);
        const double square_error = std::abs(own.square / square - 1.);
        std::cout << mean_error << " " << square_error << "\n";
        check(mean_error < 1e-5,
              "mean of a nearly coalesced pair, entry " +
                std::to_string(entry));
        check(square_error < 1e-5,
              "squared half-difference, entry " + std::to_string(entry));
      }
  }
} // namespace

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const CoarseBrake                        brake(
    {"Sweep/Sensitivities = Scene/Body pad/Young modulus, Scene/Contact "
                                                   "pad_disc/Friction coefficient, Scene/Body disc/Young modulus, "
                                                   "Scene/Body support/Density, Scene/Spring lower_left/Stiffness, "
                                                   "Scene/Damping/Stiffness damping"});
  BasisBuilder       builder(brake.system, brake.options);
  const ReducedModel model = builder.build();
  away_from_coalescence(brake, model);
  beside_a_coalescence(brake, model);
}
