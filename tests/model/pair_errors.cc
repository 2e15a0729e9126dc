// SPDX-License-Identifier: LGPL-2.1-or-later

// What the mesh does to complex eigenvalues: without friction the estimate is
// that of the undamped modes; with friction it lies within a factor 3 of what
// more degrees show, in growth rate and frequency, for springs and mortar
// contacts; refinement by it needs fewer unknowns than a uniform one.

#include "scenes.h"
#include "source_directory.h"
#include "worst.h"

#include <squeal/base/run_log.h>
#include <squeal/base/timers.h>
#include <squeal/model/adaptive_cea.h>

#include <deal.II/base/mpi.h>

#include <sstream>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  Parameters
  brake(std::vector<std::string> settings)
  {
    const std::vector<std::string> common = {
      "Analysis = cea",
      "Eigenvalues/Lowest frequency = 2500",
      "Eigenvalues/Highest frequency = 6500",
      "Scene/Body disc/Cells = 24, 3, 1",
      "Scene/Body pad/Cells = 1, 1, 1",
      "Scene/Body support/Cells = 1, 1, 4"};
    settings.insert(settings.begin(), common.begin(), common.end());
    return read_parameters(SQUEAL_SOURCE_DIR "/prm/tribobrake/calibrated.prm",
                           settings);
  }

  struct Result
  {
    ComplexPairs        pairs;
    PairErrors          errors;
    std::vector<double> of_modes; /**< relative, of frequencies */
    unsigned int        n_unknowns;
  };

  Result
  solve(const std::vector<std::string> &settings)
  {
    const Parameters   parameters = brake(settings);
    std::ostringstream console;
    RunLog             log(true, console);
    Timers             timers;
    squeal::Model      model(parameters, timers);
    MeshedCea          cea = solve_cea_adaptively(model, log, timers);
    return {cea.solution.pairs,
            cea.errors,
            cea.modes.discretisation_error,
            model.n_unknowns()};
  }

  unsigned int
  loudest(const ComplexPairs &pairs)
  {
    Eigen::Index k;
    pairs.lambda.real().maxCoeff(&k);
    return k;
  }

  const std::string mu = "Scene/Contact pad_disc/Friction coefficient = ";

  void
  test_modes_without_friction()
  {
    const Result r = solve({mu + "0",
                            "Eigenvalues/Highest frequency = 4500",
                            "Scene/Damping/Model = none",
                            "Scene/Damping/Mass damping = 0",
                            "Scene/Damping/Stiffness damping = 0",
                            "Discretization/Degree = 2"});
    Worst        worst;
    for (unsigned int k = 0; k < r.pairs.size(); ++k)
      {
        const double shift =
          -r.errors.lambda[k].imag() / r.pairs.lambda[k].imag();
        double nearest = 1e300;
        for (const double e : r.of_modes)
          if (std::abs(shift - e) < nearest)
            nearest = std::abs(shift - e);
        worst.add(nearest / shift);
        check_below(std::abs(r.errors.lambda[k].real()),
                    1e-6 * std::abs(r.errors.lambda[k].imag()),
                    "no growth by the mesh without friction");
      }
    check_below(worst.largest(), 1e-5, "estimates are those of the modes");
  }

  void
  test_against_more_degrees(const std::string              &name,
                            const std::vector<std::string> &settings)
  {
    const auto with_degree = [&](const unsigned int degree) {
      auto all = settings;
      all.push_back("Discretization/Degree = " + std::to_string(degree));
      return solve(all);
    };
    const Result       coarse = with_degree(2), fine = with_degree(4);
    const unsigned int k = loudest(coarse.pairs), l = loudest(fine.pairs);
    const std::complex<double> change =
                                 fine.pairs.lambda[l] - coarse.pairs.lambda[k],
                               estimate = coarse.errors.lambda[k];
    std::cout << name << ": lambda " << coarse.pairs.lambda[k]
              << ", changes by " << change << ", estimated " << estimate
              << '\n';
    check(fine.pairs.sigma(l) > 50., name + ": an unstable pair");
    for (const auto &[what, e, true_one] :
         {std::make_tuple("growth rate", estimate.real(), change.real()),
          std::make_tuple("frequency", estimate.imag(), change.imag())})
      check(e / true_one > 1. / 3. && e / true_one < 3.,
            name + ": estimated error of the " + what + " is " +
              std::to_string(e / true_one) + " of the true one");
  }

  /** From degree 3 on growth rates have their error from one degree less: it
   * covers the true one and is not far beyond. */
  void
  test_growth_rate_by_lower_degree(const std::string              &name,
                                   const std::vector<std::string> &settings)
  {
    const auto with_degree = [&](const unsigned int degree) {
      auto all = settings;
      all.push_back("Discretization/Degree = " + std::to_string(degree));
      return solve(all);
    };
    const Result coarse = with_degree(3), fine = with_degree(5);
    const auto   growing = [](const Result &r) {
      std::vector<unsigned int> result;
      for (unsigned int k = 0; k < r.pairs.size(); ++k)
        if (r.pairs.sigma(k) > 20.)
          result.push_back(k);
      return result;
    };
    const auto of_coarse = growing(coarse), of_fine = growing(fine);
    check(of_coarse.size() == of_fine.size() && !of_fine.empty(),
          name + ": the same pairs grow");
    for (std::size_t i = 0; i < of_fine.size(); ++i)
      {
        const unsigned int k        = of_coarse[i];
        const double       true_one = std::abs(fine.pairs.sigma(of_fine[i]) -
                                         coarse.pairs.sigma(k)),
                     error          = std::abs(coarse.errors.lambda[k].real());
        std::cout << name << ": " << coarse.pairs.frequency(k) << " Hz, "
                  << coarse.pairs.sigma(k) << " 1/s, is off by " << true_one
                  << ", estimated " << error << '\n';
        check(error > 0.5 * true_one, name + ": the error is covered");
        check(error < 10. * true_one + 0.02 * coarse.pairs.sigma(k),
              name + ": by no more than ten times");
      }
  }

  /** On its coarsest mesh this brake is stable, 8 % detuned, with a small error
   * of every growth rate: refinement must not end there. */
  void
  test_detuned_mesh_is_refined()
  {
    const Result       r = solve({mu + "0.5",
                                  "Scene/Body disc/Cells = 16, 3, 1",
                                  "Discretization/Degree = 2",
                                  "Discretization/Refinement = contact error",
                                  "Discretization/Growth rate tolerance = 50",
                                  "Discretization/Tolerance = 0.02",
                                  "Discretization/Maximum cycles = 5"});
    const unsigned int k = loudest(r.pairs);
    std::cout << r.n_unknowns << " unknowns, " << r.pairs.lambda[k] << '\n';
    check(r.pairs.sigma(k) > 350. && r.pairs.sigma(k) < 520. &&
            std::abs(r.pairs.frequency(k) - 5005.) < 60.,
          "refinement goes on until the pair at 5 kHz locks in");
    check(std::abs(r.errors.lambda[k].real()) <= 50. &&
            std::abs(r.errors.lambda[k].imag()) <=
              0.02 * std::abs(r.pairs.lambda[k]),
          "and both tolerances are met");
    check(r.n_unknowns < 25000, "with few unknowns");
  }
} // namespace



int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test_modes_without_friction();
  test_detuned_mesh_is_refined();
  test_growth_rate_by_lower_degree("springs", {mu + "0.5"});
  test_growth_rate_by_lower_degree(
    "mortar", {mu + "0.5", "Scene/Contact pad_disc/Formulation = mortar"});
  test_against_more_degrees("springs", {mu + "0.5"});
  test_against_more_degrees(
    "mortar", {mu + "0.5", "Scene/Contact pad_disc/Formulation = mortar"});
}
