// SPDX-License-Identifier: LGPL-2.1-or-later

// What the mesh does to complex eigenvalues: without friction the estimate is
// that of the undamped modes; with friction it lies within a factor 3 of what
// more degrees show, in growth rate and frequency, for springs and mortar
// contacts, of stable pairs too; refinement by it needs fewer unknowns than a
// uniform one.

#include "scenes.h"
#include "source_directory.h"
#include "worst.h"

#include <squeal/base/run_log.h>
#include <squeal/base/timers.h>
#include <squeal/model/adaptive_cea.h>

#include <deal.II/base/mpi.h>

#include <fstream>
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
      "Eigenvalues/Highest frequency = 5500",
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
  solve(const Parameters &parameters)
  {
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

  Result
  solve(const std::vector<std::string> &settings)
  {
    return solve(brake(settings));
  }

  unsigned int
  loudest(const ComplexPairs &pairs)
  {
    Eigen::Index k;
    pairs.lambda.real().maxCoeff(&k);
    return k;
  }

  const std::string mu = "Scene/Contact pad_disc/Friction coefficient = ";

  /** Of meshes that others are compared with only the pairs count. */
  const std::string no_errors = "Discretization/Estimate error = false";

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

  /** The loudest pair of @p coarse against more degrees: its error is known
   * within a factor of 3, in growth rate and frequency. */
  void
  test_loudest_pair(const std::string &name,
                    const Result      &coarse,
                    const Result      &fine)
  {
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

  /** Growth rates above @p least 1/s have their error from one degree less: it
   * covers the true one and is not far beyond. */
  void
  test_growth_rate_by_lower_degree(const std::string &name,
                                   const Result      &coarse,
                                   const Result      &fine,
                                   const double       least = 20.)
  {
    const auto growing = [least](const Result &r) {
      std::vector<unsigned int> result;
      for (unsigned int k = 0; k < r.pairs.size(); ++k)
        if (r.pairs.sigma(k) > least)
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

  /** The same brake with degrees 2, 3 and 4. */
  void
  test_against_more_degrees(const std::string              &name,
                            const std::vector<std::string> &settings)
  {
    const auto with_degree = [&](const unsigned int degree) {
      auto all = settings;
      all.push_back("Discretization/Degree = " + std::to_string(degree));
      if (degree == 4)
        all.push_back(no_errors);
      return solve(all);
    };
    const Result fine = with_degree(4);
    test_loudest_pair(name, with_degree(2), fine);
    test_growth_rate_by_lower_degree(name, with_degree(3), fine);
  }

  /** A pad on a disc of few cells, whose stable pairs up to 1 kHz are far
   * enough apart to be those of the same order with more degrees. */
  const std::string disc_and_pad = R"(
    set Analysis = cea
    subsection Eigenvalues
      set Lowest frequency  = 0
      set Highest frequency = 1000
    end
    subsection Scene
      set Bodies   = disc, pad
      set Springs  = hub, back, side
      set Contacts = c
      subsection Body disc
        set Shape         = annulus
        set Inner radius  = .04
        set Outer radius  = .1
        set Height        = .01
        set Position      = 0, 0, -.01
        set Cells         = 8, 1, 1
        set Young modulus = 1e11
        set Density       = 7200
      end
      subsection Body pad
        set Shape         = block
        set Size          = .03, .04, .012
        set Position      = .07, 0, 0
        set Cells         = 1, 1, 1
        set Young modulus = 5e9
        set Density       = 2500
      end
      subsection Spring hub
        set Kind        = area
        set Body        = disc
        set Face        = inner
        set Stiffnesses = 1e9, 1e9, 1e9
      end
      subsection Spring back
        set Kind        = area
        set Body        = pad
        set Face        = z_max
        set Stiffnesses = 1e9, 1e9, 1e10
      end
      subsection Spring side
        set Kind        = area
        set Body        = pad
        set Face        = y_max
        set Stiffnesses = 1e10, 1e11, 1e10
      end
      subsection Contact c
        set Source body          = pad
        set Source face          = z_min
        set Target body          = disc
        set Target face          = top
        set Formulation          = mortar
        set Friction coefficient = .5
        set Normal force         = 1200
        set Sliding speed        = 1
      end
    end
    )";

  /** Every frequency that the mesh shifts has its error within a factor of 3,
   * and on its side. */
  void
  test_stable_pairs_on_mortar(const std::string &coefficient)
  {
    std::ofstream("disc_and_pad.prm") << disc_and_pad;
    const auto with_degree = [&](const std::string &degree) {
      std::vector<std::string> all = {
        "Discretization/Degree = " + degree,
        "Scene/Contact c/Friction coefficient = " + coefficient};
      if (degree == "5")
        all.push_back(no_errors);
      return solve(read_parameters("disc_and_pad.prm", all));
    };
    const Result coarse = with_degree("3"), fine = with_degree("5");
    check(coarse.pairs.size() == fine.pairs.size() && fine.pairs.size() >= 3,
          "as many pairs with more degrees");
    unsigned int n_judged = 0;
    for (unsigned int k = 0; k < fine.pairs.size(); ++k)
      {
        const double change =
          (fine.pairs.lambda[k] - coarse.pairs.lambda[k]).imag();
        // What is hardly off is off by other things than the contact.
        if (std::abs(change) < 1e-4 * std::abs(fine.pairs.lambda[k]))
          continue;
        ++n_judged;
        const double estimate = coarse.errors.lambda[k].imag();
        std::cout << "mu " << coefficient << ": " << coarse.pairs.lambda[k]
                  << ", changes by " << change << " rad/s, estimated "
                  << estimate << '\n';
        check(estimate / change > 1. / 3. && estimate / change < 3.,
              "pair " + std::to_string(k + 1) + " with mu = " + coefficient +
                ": estimated error of the frequency is " +
                std::to_string(estimate / change) + " of the true one");
      }
    check(n_judged >= 3, "pairs that the mesh shifts");
  }

  /** A thin disc on one layer of cells, on which linear elements have twice the
   * frequency of the growing pair, and a pad with a plate on its back. */
  const std::string thin_disc = R"(
    set Analysis = cea
    subsection Eigenvalues
      set Lowest frequency   = 300
      set Highest frequency  = 2500
    end
    subsection Scene
      set Bodies   = disc, pad, plate
      set Ties     = glue
      set Supports = bore
      set Springs  = side, back
      set Contacts = c
      subsection Body disc
        set Shape         = annulus
        set Inner radius  = .04
        set Outer radius  = .12
        set Height        = .01
        set Position      = 0, 0, -.01
        set Cells         = 20, 2, 1
        set Young modulus = 110e9
        set Poisson ratio = .27
        set Density       = 7200
      end
      subsection Body pad
        set Size          = .03, .06, .012
        set Position      = .095, 0, 0
        set Cells         = 2, 3, 1
        set Young modulus = 6e9
        set Density       = 2500
      end
      subsection Body plate
        set Size          = .03, .06, .005
        set Position      = .095, 0, .012
        set Cells         = 2, 3, 1
        set Density       = 7850
      end
      subsection Tie glue
        set Source body = pad
        set Source face = z_max
        set Target body = plate
        set Target face = z_min
      end
      subsection Support bore
        set Body = disc
        set Face = inner
      end
      subsection Spring side
        set Kind        = area
        set Body        = plate
        set Face        = y_max
        set Stiffnesses = 0, 2e11, 0
      end
      subsection Spring back
        set Kind        = area
        set Body        = plate
        set Face        = z_max
        set Stiffnesses = 2e10, 0, 1e9
      end
      subsection Contact c
        set Source body          = pad
        set Source face          = z_min
        set Target body          = disc
        set Target face          = top
        set Formulation          = mortar
        set Friction direction   = slip
        set Friction coefficient = .6
        set Transverse slip term = true
        set Sliding speed        = 2
        set Friction slope       = -0.01
        set Normal force         = 500
        set Contact state        = full
      end
      subsection Damping
        set Model             = whole model
        set Stiffness damping = 1e-8
        set Mass damping      = 5
      end
    end
    )";

  /** The pair is found again although linear elements have it far away: the
   * stated error covers the true one. */
  void
  test_pair_far_away_in_linear_elements()
  {
    std::ofstream("thin_disc.prm") << thin_disc;
    const auto with_degree = [](const std::string &degree) {
      std::vector<std::string> all = {"Discretization/Degree = " + degree};
      if (degree == "4")
        all.push_back(no_errors);
      return solve(read_parameters("thin_disc.prm", all));
    };
    const Result fine = with_degree("4");
    for (const std::string degree : {"2", "3"})
      test_growth_rate_by_lower_degree(
        "thin disc, p = " + degree, with_degree(degree), fine, 0.);
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
  test_pair_far_away_in_linear_elements();
  test_stable_pairs_on_mortar("0");
  test_stable_pairs_on_mortar("0.5");
  test_against_more_degrees("springs", {mu + "0.5"});
  test_against_more_degrees(
    "mortar", {mu + "0.5", "Scene/Contact pad_disc/Formulation = mortar"});
}
