// SPDX-License-Identifier: LGPL-2.1-or-later

// Estimated errors of bodies that hardly change their volume are within a
// factor 3 of the true ones, from a Poisson ratio of 0.3 to 0.4999, of modes
// and of complex pairs with friction.

#include "scenes.h"
#include "worst.h"

#include <squeal/base/run_log.h>
#include <squeal/base/timers.h>
#include <squeal/model/adaptive_cea.h>
#include <squeal/model/finer_modes.h>
#include <squeal/model/mode_solution.h>

#include <deal.II/base/mpi.h>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  ModeSolution
  solve(const Parameters &p, const bool with_errors)
  {
    Timers        timers;
    RunLog        log(false);
    squeal::Model model(p, timers);
    return with_errors ? solve_modes_adaptively(model, log, timers)
                       : solve_modes(model, log, timers);
  }

  /** @p p of degree @p degree beside the same mesh with two degrees more. */
  void
  test_scene(const std::string &name, Parameters p, const unsigned int degree)
  {
    for (const double nu : {.3, .45, .46, .49, .4999})
      {
        p.scene.bodies[0].poisson_ratio = nu;
        p.discretization.degree         = degree;
        p.discretization.estimate_error = true;
        const ModeSolution coarse       = solve(p, true);
        p.discretization.degree         = degree + 2;
        const ModeSolution fine         = solve(p, false);
        const unsigned int n = coarse.n_up_to(p.eigen.highest_frequency);
        check(n >= 5, name + ": enough modes");
        Worst ratios;
        for (unsigned int i = 0; i < n; ++i)
          {
            const double exact =
              coarse.modes.frequency(i) / fine.modes.frequency(i) - 1.;
            const double ratio = coarse.discretisation_error[i] / exact;
            check(ratio > 1. / 3. && ratio < 3.,
                  name + ", nu = " + number(nu) + ", mode " +
                    std::to_string(i) + ", true error " + number(exact) +
                    ": estimated over true " + number(ratio));
            ratios.add(ratio);
          }
        std::cout << name << ", nu = " << nu << ": " << ratios.smallest()
                  << " to " << ratios.largest() << std::endl;
      }
  }

  /** A soft pad that is pressed on a block, held at its back. */
  Parameters
  pad_on_block()
  {
    Parameters p;
    auto      &s = p.scene;
    s.bodies     = {
          make_block("base", {{0., 0., -.01}}, {{.03, .03, .01}}, {{3, 3, 1}}),
          make_block("pad", {{0., 0., 0.}}, {{.01, .01, .01}}, {{2, 2, 2}})};
    s.bodies[1].young_modulus = 1e8;
    s.bodies[1].density       = 2000.;
    s.supports = {make_clamp("base", "z_min"), make_clamp("pad", "z_max")};
    ContactParameters c;
    c.name                    = "c";
    c.source_body             = "pad";
    c.source_face             = "z_min";
    c.target_body             = "base";
    c.target_face             = "z_max";
    c.formulation             = ContactParameters::Formulation::mortar;
    c.friction_coefficient    = .3;
    s.contacts                = {c};
    p.eigen.highest_frequency = 16000.;
    return p;
  }

  MeshedCea
  solve_pairs(const Parameters &p)
  {
    Timers        timers;
    RunLog        log(false);
    squeal::Model model(p, timers);
    return solve_cea_adaptively(model, log, timers);
  }

  /** Frequencies of complex pairs beside those of two degrees more. */
  void
  test_pairs()
  {
    Parameters p = pad_on_block();
    for (const double nu : {.49, .4999})
      {
        p.scene.bodies[1].poisson_ratio = nu;
        p.discretization.degree         = 2;
        p.discretization.estimate_error = true;
        const MeshedCea coarse          = solve_pairs(p);
        p.discretization.degree         = 4;
        p.discretization.estimate_error = false;
        const ComplexPairs  fine        = solve_pairs(p).solution.pairs;
        const ComplexPairs &pairs       = coarse.solution.pairs;
        unsigned int        n_known     = 0;
        for (unsigned int k = 0; k < pairs.size() && k < fine.size(); ++k)
          {
            const double stated = coarse.errors.lambda[k].imag();
            if (std::isnan(stated))
              continue;
            ++n_known;
            const double exact = fine.lambda[k].imag() - pairs.lambda[k].imag();
            std::cout << "pad on block, nu = " << nu << ": "
                      << pairs.frequency(k) << " Hz, " << pairs.sigma(k)
                      << " 1/s, off by " << exact / (2. * M_PI)
                      << " Hz, stated " << stated / (2. * M_PI) << " Hz"
                      << std::endl;
            check(stated / exact > 1. / 3. && stated / exact < 3.,
                  "pad on block, nu = " + number(nu) + ", pair at " +
                    number(pairs.frequency(k)) + " Hz: stated over true " +
                    number(stated / exact));
          }
        check(n_known >= 4, "the errors of the pairs are known");
      }
  }

  void
  test_materials()
  {
    SceneParameters scene;
    scene.bodies        = {make_annulus({{8, 2, 1}})};
    auto      &body     = scene.bodies[0];
    const auto is_found = [&] {
      return !nearly_incompressible_bodies(scene).empty();
    };
    for (const double nu : {-.5, .3, .45})
      {
        body.poisson_ratio = nu;
        check(!is_found(), "the cells' own errors hold");
      }
    body.poisson_ratio = .46;
    check(is_found(), "and beyond 0.45 they do not");
    body.material_model = BodyParameters::MaterialModel::orthotropic;
    body.young_moduli   = {{2., 1., 1.}};
    body.poisson_ratios = {{.3, .3, .3}};
    check(!is_found(), "orthotropic");
    // Columns of the compliance without a change of volume: nu12 = nu13 = 1/2,
    // nu23 = 1 - nu21 = 3/4.
    body.poisson_ratios = {{.749, .5, .5}};
    check(is_found(), "orthotropic, nearly without change of volume");
  }
} // namespace



int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize init(argc, argv, 1);
  test_materials();
  test_pairs();
  Parameters disc;
  disc.scene.bodies            = {make_annulus({{8, 2, 1}})};
  disc.scene.supports          = {make_clamp("disc", "inner")};
  disc.eigen.highest_frequency = 3500.;
  test_scene("clamped disc", disc, 3);
  Parameters pad;
  pad.scene.bodies = {
    make_block("pad", {{0., 0., 0.}}, {{.02, .02, .01}}, {{2, 2, 1}})};
  pad.scene.bodies[0].young_modulus = 1e8;
  pad.scene.bodies[0].density       = 1200.;
  pad.scene.supports                = {make_clamp("pad", "z_min")};
  pad.eigen.highest_frequency       = 12000.;
  test_scene("clamped pad", pad, 2);
}
