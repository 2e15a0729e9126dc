// SPDX-License-Identifier: LGPL-2.1-or-later

// Mortar ties and contacts pass on tractions in the error estimates of modes: a
// mortar tie of matching meshes states the errors of a conforming one, however
// different the moduli; of unlike meshes, and where a soft body slides on a
// stiff one, stated errors lie within a factor 3 of those against more degrees.

#include "scenes.h"
#include "worst.h"

#include <squeal/base/run_log.h>
#include <squeal/base/timers.h>
#include <squeal/model/mode_solution.h>

#include <deal.II/base/mpi.h>

#include <algorithm>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  constexpr double soft = 5e7, stiff = 2.1e11; // Pa

  Parameters
  block_on_plate(const double                       E_block,
                 const double                       E_plate,
                 const std::array<unsigned int, 3> &cells,
                 const double                       top)
  {
    Parameters p;
    auto      &s = p.scene;
    s.bodies     = {
          make_block("plate", {{0., 0., -.01}}, {{.06, .04, .01}}, {{3, 2, 1}}),
          make_block("block", {{0., 0., 0.}}, {{.06, .04, .02}}, cells)};
    s.bodies[0].young_modulus = E_plate;
    s.bodies[1].young_modulus = E_block;
    s.bodies[1].density       = 1500.;
    s.supports                = {make_clamp("plate", "x_min")};
    p.eigen.highest_frequency = top;
    return p;
  }

  struct Modes
  {
    std::vector<double> frequencies, errors;
  };

  Modes
  solve(Parameters p, const unsigned int degree)
  {
    p.discretization.degree = degree;
    Timers             timers;
    RunLog             log(false);
    squeal::Model      model(p, timers);
    const ModeSolution solution = solve_modes_adaptively(model, log, timers);
    Modes              result;
    for (unsigned int i = 0; i < solution.n_up_to(p.eigen.highest_frequency);
         ++i)
      {
        result.frequencies.push_back(solution.modes.frequency(i));
        result.errors.push_back(solution.discretisation_error[i]);
      }
    return result;
  }

  Parameters
  tied(Parameters p, const TieParameters::Kind kind)
  {
    p.scene.ties = {make_tie("block", "z_min", "plate", "z_max", kind)};
    return p;
  }

  void
  test_matching_meshes(const std::string &name,
                       const double       E_block,
                       const double       E_plate,
                       const double       top)
  {
    const Parameters p = block_on_plate(E_block, E_plate, {{3, 2, 2}}, top);
    for (const unsigned int degree : {1, 2})
      {
        const Modes joined =
                      solve(tied(p, TieParameters::Kind::conforming), degree),
                    mortar =
                      solve(tied(p, TieParameters::Kind::mortar), degree);
        check(mortar.errors.size() == joined.errors.size() &&
                !mortar.errors.empty(),
              name + ": the same modes");
        Worst worst;
        for (std::size_t i = 0; i < joined.errors.size(); ++i)
          worst.add(mortar.errors[i] / joined.errors[i] - 1.);
        check_below(worst.largest(),
                    1e-4,
                    name + ", degree " + std::to_string(degree) +
                      ": errors are those of the conforming tie");
      }
  }

  /** The first modes of degree 2 against those of degree 4. */
  void
  test_against_more_degrees(const std::string &name, const Parameters &p)
  {
    const Modes coarse = solve(p, 2), fine = solve(p, 4);
    check(coarse.errors.size() >= 3 && fine.errors.size() >= 3,
          name + ": some modes");
    for (std::size_t i = 0; i < 3; ++i)
      {
        const double true_one =
                       coarse.frequencies[i] / fine.frequencies[i] - 1.,
                     ratio = coarse.errors[i] / true_one;
        check(ratio > 1. / 3. && ratio < 3.,
              name + ": the error of mode " + std::to_string(i + 1) + " is " +
                std::to_string(ratio) + " of the true one, " +
                std::to_string(true_one));
      }
  }

  Parameters
  sliding(Parameters p)
  {
    auto &s = p.scene;
    s.supports.push_back(make_clamp("block", "z_max"));
    s.contacts.resize(1);
    auto &c                = s.contacts[0];
    c.name                 = "c";
    c.source_body          = "block";
    c.source_face          = "z_min";
    c.target_body          = "plate";
    c.target_face          = "z_max";
    c.formulation          = ContactParameters::Formulation::mortar;
    c.friction_coefficient = .3;
    return p;
  }
} // namespace

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test_matching_meshes("soft on stiff", soft, stiff, 3000.);
  test_matching_meshes("stiff on soft", stiff, soft, 1500.);
  test_matching_meshes("equal", stiff, stiff, 20000.);
  for (const auto &[name, E_block, E_plate, top] :
       {std::make_tuple("soft on stiff", soft, stiff, 3000.),
        std::make_tuple("stiff on soft", stiff, soft, 1500.)})
    test_against_more_degrees(
      std::string(name) + ", unlike meshes",
      tied(block_on_plate(E_block, E_plate, {{4, 3, 2}}, top),
           TieParameters::Kind::mortar));
  test_against_more_degrees(
    "sliding", sliding(block_on_plate(soft, stiff, {{4, 3, 2}}, 3000.)));
}
