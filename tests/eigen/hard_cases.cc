// SPDX-License-Identifier: LGPL-2.1-or-later

// Parameters far from the usual ones, through the same solver: strong and
// backward friction, pads from rubber to harder than diamond, contact springs
// from nothing to rigid, a band that ends on a mode, thin and nearly
// incompressible bodies, targets with hanging nodes.

#include "scenes.h"
#include "worst.h"

#include <squeal/base/exceptions.h>
#include <squeal/eigen/direct_solver.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <string>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  using Complex = std::complex<double>;

  constexpr double top = 6000.;

  /** Certified pairs beside those of the direct solver. */
  void
  check_against_direct(const SceneParameters &scene, const std::string &name)
  {
    Model              model(scene, 2, top);
    const ComplexPairs pairs = model.solve(band(500., top));
    check(pairs.size() > 4, name + ": pairs in the band");
    const DirectSolver direct(model.pencil, Complex(100., M_PI * top));
    const ComplexPairs exact = direct.solve(pairs.size() + 12);
    for (unsigned int i = 0; i < pairs.size(); ++i)
      {
        const std::string which =
          name + ", " + number(pairs.frequency(i)) + " Hz";
        check_below(pairs.noise_floor[i], 1e-4, which + ": the floor itself");
        check(pairs.residual[i] <= std::max(1e-8, pairs.noise_floor[i]),
              which + ": residual " + number(pairs.residual[i]) +
                " is below the tolerance or the floor " +
                number(pairs.noise_floor[i]));
        // The direct solver is good to some 1e-8 far from its shift.
        check_below(distance(exact.lambda, pairs.lambda[i]),
                    1e-7 * std::max(1., pairs.condition[i]),
                    which + ": certified against direct");
      }
  }

  void
  test_friction()
  {
    for (const double mu : {1.5, -1.5})
      check_against_direct(coarse_brake(mu), "mu = " + number(mu));
    Model      a(coarse_brake(1.5), 2, top), b(coarse_brake(-1.5), 2, top);
    const auto x = a.solve(band(500., top)), y = b.solve(band(500., top));
    check(x.size() == y.size(), "as many pairs backwards");
    for (unsigned int i = 0; i < x.size(); ++i)
      check_below(distance(y.lambda, x.lambda[i]),
                  1e-8 * std::max(1., x.condition[i]),
                  "mu = -1.5 mirrors mu = 1.5, " + number(x.frequency(i)) +
                    " Hz");
  }

  void
  test_stiffness_ranges()
  {
    // Rubber: a pad of 1e6 Pa has hundreds of modes in the band, and damping
    // is what the closed form says.
    {
      SceneParameters s         = coarse_brake(0.);
      s.bodies[1].young_modulus = 1e6;
      Model              model(s, 2, 2000.);
      const ComplexPairs pairs = model.solve(band(500., 2000.));
      check(pairs.size() > 20, "pairs of a brake with a pad of 1e6 Pa");
      for (unsigned int i = 0; i < pairs.size(); ++i)
        {
          const Complex l = pairs.lambda[i];
          check(pairs.residual[i] <= std::max(1e-8, pairs.noise_floor[i]),
                "E_pad = 1e6: residual " + number(pairs.residual[i]));
          check_below(std::abs(l.real() + .5 * (s.damping.mass_damping +
                                                s.damping.stiffness_damping *
                                                  std::norm(l))) /
                        std::abs(l),
                      1e-8,
                      "E_pad = 1e6: damping at " + number(pairs.frequency(i)));
        }
    }
    for (const double young : {1e9, 1e13})
      {
        SceneParameters s         = coarse_brake(.3);
        s.bodies[1].young_modulus = young;
        check_against_direct(s, "E_pad = " + number(young));
      }
    for (const double k : {1e4, 1e6})
      {
        SceneParameters s              = coarse_brake(.3);
        s.contacts[0].normal_stiffness = k;
        check_against_direct(s, "k_n = " + number(k));
      }
  }

  /** Stiffer than every body: the rounding of the springs' forces hides the
   * other terms of the residual, which stops at the floor that the table
   * states; the eigenvalues themselves keep their digits. */
  void
  test_rigid_springs()
  {
    for (const double k : {1e10, 1e11, 1e12, 1e14})
      {
        SceneParameters s              = coarse_brake(.3);
        s.contacts[0].normal_stiffness = k;
        check_against_direct(s, "k_n = " + number(k));
      }
  }

  void
  test_band_ends_on_a_mode()
  {
    const SceneParameters scene = coarse_brake(0.);
    Model                 model(scene, 2, top);
    const UndampedModes   modes = undamped_modes(model.pencil, model.inverse);
    const double          beta  = scene.damping.stiffness_damping,
                 alpha          = scene.damping.mass_damping;
    for (const unsigned int k : {modes.n_certified - 2, modes.n_certified / 2})
      {
        const double f = modes.frequency(k);
        Model        on_mode(scene, 2, f);
        const auto   pairs = on_mode.solve(band(500., f * (1. + 1e-9)));
        unsigned int n     = 0;
        for (unsigned int i = 0; i < modes.omega_squared.size(); ++i)
          if (modes.frequency(i) > 500. && modes.frequency(i) <= f)
            ++n;
        check(pairs.size() == n,
              "a band up to the mode at " + number(f) +
                " Hz: " + std::to_string(pairs.size()) + " pairs");
        const Complex last = pairs.lambda[n - 1];
        check_below(
          std::abs(last.real() + .5 * (alpha + beta * std::norm(last))) /
            std::abs(last),
          1e-8,
          "the mode at the shift has its damping");
        check_below(std::abs(std::abs(last) / (2. * M_PI * f) - 1.),
                    1e-8,
                    "and its frequency");
      }
  }



  Eigen::VectorXd
  elastic_frequencies(const SceneParameters &scene,
                      const unsigned int     degree,
                      const double           highest)
  {
    const Model         model(scene, degree, highest);
    const UndampedModes modes = undamped_modes(model.pencil, model.inverse);
    return modes.omega_squared.segment(6, modes.n_certified - 6)
             .array()
             .sqrt() /
           (2. * M_PI);
  }

  /** A free disc of 1 mm, so that no edge is singular: with locking neither
   * the mesh nor the degree would help. Cells of 23 mm are far too coarse for
   * p = 2 there, so that its order 4 is not seen yet. */
  void
  test_thin_disc()
  {
    SceneParameters s;
    s.bodies          = {make_annulus({{24, 3, 1}}, .001)};
    const double lim  = 420.;
    const auto   f4   = elastic_frequencies(s, 4, lim),
               f2     = elastic_frequencies(s, 2, lim),
               f3     = elastic_frequencies(s, 3, lim);
    s.bodies[0].cells = {{48, 6, 1}};
    const auto fine   = elastic_frequencies(s, 2, lim);
    const auto error  = [&](const Eigen::VectorXd &f) {
      const Eigen::Index n = std::min(f.size(), f4.size());
      check(n >= 6, "modes of the thin disc: " + std::to_string(n));
      return (f.head(n).array() / f4.head(n).array() - 1.)
        .abs()
        .maxCoeff<Eigen::PropagateNaN>();
    };
    check_below(error(f2), .06, "free disc of 1 mm, p = 2");
    check_below(error(fine), error(f2) / 4., "half the cell size, p = 2");
    check_below(error(f3), error(f2) / 8., "the same cells, p = 3");
  }

  /** Nu = 0.49 in the pad of the brake: p = 2 and p = 3 against p = 4. */
  void
  test_incompressible_pad()
  {
    SceneParameters s;
    s.bodies = {
      make_block("pad", {{0., 0., 0.}}, {{.01, .01, .01}}, {{3, 3, 3}})};
    s.bodies[0].young_modulus = 1e9;
    s.bodies[0].density       = 2500.;
    s.bodies[0].poisson_ratio = .49;
    const auto f2             = elastic_frequencies(s, 2, 6e4),
               f3             = elastic_frequencies(s, 3, 6e4),
               f4             = elastic_frequencies(s, 4, 6e4);
    const Eigen::Index n      = 10;
    check(std::min(f2.size(), std::min(f3.size(), f4.size())) >= n,
          "modes of the free pad");
    check_below((f2.head(n).array() / f4.head(n).array() - 1.)
                  .maxCoeff<Eigen::PropagateNaN>(),
                .02,
                "pad with nu = 0.49, p = 2");
    check_below((f3.head(n).array() / f4.head(n).array() - 1.)
                  .maxCoeff<Eigen::PropagateNaN>(),
                1e-3,
                "pad with nu = 0.49, p = 3");
  }



  /** A pad on a clamped plate whose mesh is refined under one half of it. */
  Eigen::VectorXcd
  pairs_on_plate(const ContactParameters::Formulation formulation,
                 const unsigned int                   refinements,
                 const bool                           hanging)
  {
    SceneParameters s;
    s.bodies = {
      make_block("plate", {{0., 0., -.01}}, {{.06, .06, .01}}, {{4, 4, 1}}),
      make_block("pad", {{.002, .001, 0.}}, {{.02, .02, .02}}, {{2, 2, 2}})};
    s.bodies[1].young_modulus = 2e10;
    s.bodies[1].density       = 2500.;
    s.supports = {make_clamp("plate", "x_min"), make_clamp("pad", "z_max")};
    ContactParameters contact;
    contact.name        = "pad on plate";
    contact.source_body = "pad";
    contact.source_face = "z_min";
    contact.target_body = "plate";
    contact.target_face = "z_max";
    contact.formulation = formulation;
    contact.layout      = ContactParameters::SpringLayout::quadrature;
    contact.normal_stiffness_per_area = 1e13;
    contact.friction_coefficient      = .4;
    s.contacts                        = {contact};
    Discretization d(s, Model::parameters(refinements), 3, MPI_COMM_SELF);
    if (hanging)
      {
        std::vector<double> marks(d.triangulation().n_active_cells(), 0.);
        for (const auto &cell : d.dof_handler().active_cell_iterators())
          if (cell->material_id() == 0 && cell->center()[0] > 0. &&
              cell->center()[0] < .02)
            marks[cell->active_cell_index()] = 1.;
        const unsigned int n = d.triangulation().n_active_cells();
        d.refine(marks, .99);
        check(d.triangulation().n_active_cells() > n, "the plate is refined");
      }
    const LinearizedSystem system = linearized_system(d, assemble_bodies(d));
    const Pencil           pencil(system.system, s);
    const ShiftedInverse   inverse(pencil, std::pow(2. * M_PI * 2e4, 2));
    const UndampedModes    modes = undamped_modes(pencil, inverse);
    return CertifiedSolver(pencil, inverse, modes).solve(band(0., 2e4)).lambda;
  }

  void
  test_hanging_target()
  {
    using Formulation = ContactParameters::Formulation;
    for (const auto formulation : {Formulation::springs, Formulation::mortar})
      {
        const std::string name =
          formulation == Formulation::springs ? "springs" : "mortar";
        const auto coarse = pairs_on_plate(formulation, 0, false),
                   local  = pairs_on_plate(formulation, 0, true),
                   fine   = pairs_on_plate(formulation, 1, false);
        check(local.size() >= 4 && local.size() == fine.size(),
              name + ": pairs: " + std::to_string(local.size()));
        Worst worst, worst_coarse;
        for (const Complex lambda : fine)
          {
            worst.add(distance(local, lambda));
            worst_coarse.add(distance(coarse, lambda));
          }
        // As near to the uniformly fine mesh as the coarse one at least.
        check_below(worst.largest(),
                    1.001 * worst_coarse.largest(),
                    name + " on a target with hanging nodes");
        check_below(
          worst_coarse.largest(), 1e-2, name + ": coarse against fine");
      }
  }
} // namespace



int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize init(argc, argv, 1);
  const std::string                        what = argc > 1 ? argv[1] : "";
  if (what == "friction")
    test_friction();
  else if (what == "stiffness")
    test_stiffness_ranges();
  else if (what == "rigid_springs")
    test_rigid_springs();
  else if (what == "shift")
    test_band_ends_on_a_mode();
  else if (what == "locking")
    {
      test_thin_disc();
      test_incompressible_pad();
    }
  else if (what == "hanging")
    test_hanging_target();
  else
    check(false,
          "one argument: friction, stiffness, rigid_springs, shift, "
          "locking, hanging");
}
