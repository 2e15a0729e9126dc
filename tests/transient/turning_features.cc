// SPDX-License-Identifier: LGPL-2.1-or-later

// What turning does to a disc with its mesh: Coriolis and centrifugal forces
// on a disc that is free, and forces that vary once a turn where the disc has a
// feature.

#include "transient/turning_brake.h"
#include "worst.h"

#include <deal.II/base/mpi.h>

#include <chrono>
#include <complex>
#include <cstdio>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  /** A motion of the whole disc along x or y, all others at rest. */
  Block
  translation(const Discretization &d, const unsigned int direction)
  {
    Block result = Block::Zero(d.space()->n_owned(), 1);
    std::vector<dealii::types::global_dof_index> dofs(
      d.dof_handler().get_fe().n_dofs_per_cell());
    for (const auto &cell : d.dof_handler().active_cell_iterators())
      {
        cell->get_dof_indices(dofs);
        for (unsigned int i = 0; i < dofs.size(); ++i)
          if (cell->material_id() == 0 &&
              d.dof_handler().get_fe().system_to_component_index(i).first ==
                direction)
            for (const auto &[row, weight] : d.expansion(dofs[i]))
              result(row) = 1.;
      }
    return result;
  }

  /** A free disc that is pushed goes straight on. In axes that turn with it,
   * counterclockwise, that is the spiral V t exp(-i Omega t). */
  void
  check_spiral(FullTransient         &run,
               const Reduced         &r,
               const Eigen::VectorXd &pushed,
               const double           omega,
               const std::string     &name)
  {
    const double V = 1e-3, end = 4e-3;
    run.start(Eigen::VectorXd::Zero(r.model.n_modes()),
              V * r.basis.mass_shapes.transpose() * pushed,
              Eigen::VectorXd::Zero(3 * r.model.n_nodes()));
    Worst worst;
    while (run.time() < end)
      {
        run.advance();
        const Eigen::VectorXd      x = run.observed_motion();
        const std::complex<double> spiral =
          V * run.time() * std::polar(1., -omega * run.time());
        worst.add(std::abs(std::complex<double>(x[0], x[1]) - spiral) /
                  (V * end));
      }
    std::printf("%s: turned by %.3f rad, largest distance from the straight "
                "line %.1e of its length, imbalance %.1e\n",
                name.c_str(),
                omega * end,
                worst.largest(),
                run.ledger().imbalance());
    check(std::abs(omega) * end > .7, "the disc has turned");
    check_below(worst.largest(), 2e-6, name + ": a pushed disc goes straight");
    check_below(run.ledger().imbalance(), 1e-6, name + ": the ledger closes");
  }

  void
  inertia()
  {
    SceneParameters scene = turning_brake({{16, 3, 1}}, 2);
    scene.supports        = {};
    scene.damping         = {};
    const Reduced r(scene, 12e3, 0., true, 1);
    const Block   x       = translation(r.discretization, 0),
                y         = translation(r.discretization, 1);
    const Block M_x       = r.pencil.multiply_mass(x),
                M_y       = r.pencil.multiply_mass(y);
    FullContactModel full = full_model(r);
    full.initial_gap.setOnes(); // nothing touches
    full.observers.resize(x.rows(), 2);
    full.observers << M_x / x.col(0).dot(M_x.col(0)),
      M_y / y.col(0).dot(M_y.col(0));
    full.turning = std::make_shared<TurningContacts>(turning_contact(r, 0));
    full.inertia =
      std::make_shared<const TurningInertia>(r.discretization,
                                             full.turning->rates(),
                                             r.separated.expand,
                                             r.separated.restrict_forces);
    const double   omega = fast * full.turning->rates().at("disc");
    TransientDrive d     = drive(0.);
    d.load               = [](double) { return 0.; };
    const double      dt = stable_step(r);
    ExplicitTransient forward(full, dt, d, 1.);
    check_spiral(forward, r, x.col(0), omega, "explicit");
    ImplicitTransient trapezoidal(full, 2e-6, d, 1.);
    check_spiral(trapezoidal, r, x.col(0), omega, "implicit");
  }



  /** Amplitudes of the normal force at the first @p n harmonics of the last of
   * @p turns turns, N. */
  std::vector<double>
  harmonics(const SceneParameters &scene,
            const double           turns,
            const unsigned int     n,
            const double           speed)
  {
    const Reduced       r(scene, 12e3, 0., true, 1);
    const double        period = 2. * M_PI * .1075 / speed;
    const SteadySliding steady = steady_sliding(r.model, mu);
    FullContactModel    full   = full_model(r);
    full.turning = std::make_shared<TurningContacts>(turning_contact(r, 100));
    TransientDrive turning = drive(0.);
    turning.speed          = [speed](double) { return speed; };
    ExplicitTransient run(
      full, stable_step(r), turning, load / r.model.n_nodes());
    run.start(steady.coordinates,
              Eigen::VectorXd::Zero(r.model.n_modes()),
              steady.forces);
    std::vector<std::complex<double>> sums(n);
    unsigned int                      n_samples = 0, n_steps = 0;
    const auto                        begin = std::chrono::steady_clock::now();
    while (run.time() < turns * period)
      {
        run.advance();
        ++n_steps;
        if (run.time() < (turns - 1.) * period)
          continue;
        double force = -steady.resultant()[0];
        for (unsigned int j = 0; j < r.model.n_nodes(); ++j)
          force += run.forces()[3 * j];
        for (unsigned int k = 0; k < n; ++k)
          sums[k] +=
            force * std::polar(1., -2. * M_PI * k * run.time() / period);
        ++n_samples;
      }
    check_below(run.ledger().imbalance(), 1e-10, "the ledger closes");
    std::vector<double> result;
    for (const auto &sum : sums)
      result.push_back((result.empty() ? 1. : 2.) * std::abs(sum) / n_samples);
    std::printf("%u steps, %.0f steps/s, imbalance %.1e, harmonics",
                n_steps,
                n_steps / std::chrono::duration<double>(
                            std::chrono::steady_clock::now() - begin)
                            .count(),
                run.ledger().imbalance());
    for (const double x : result)
      std::printf(" %.2e", x);
    std::printf(" N\n");
    return result;
  }

  void
  feature()
  {
    // A stiff column on the support makes a force of the disc's height.
    const auto add = [](SceneParameters        &scene,
                        const std::string      &body,
                        const dealii::Point<3> &x,
                        const double            stiffness) {
      SpringParameters spring;
      spring.name        = body;
      spring.body        = body;
      spring.first_point = spring.last_point = {{x[0], x[1], x[2]}};
      spring.stiffness                       = stiffness;
      scene.springs.push_back(spring);
    };
    SceneParameters scene = turning_brake({{16, 3, 1}}, 1);
    add(scene, "support", {.1075, 0., .11}, 2e7);
    const auto without = harmonics(scene, 1.2, 17, 40.);
    add(scene, "disc", {-.12, 0., 0.}, 1e8);
    const auto   with = harmonics(scene, 1.2, 17, 40.);
    const double other =
      *std::max_element(without.begin() + 1, without.begin() + 12);
    check_below(other, 1e-3 * load, "an even disc: nothing varies in a turn");
    check(with[1] > 10. * other, "a stiff place of the rim: once a turn");
  }
} // namespace

int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const std::string                        which = argc > 1 ? argv[1] : "";
  if (which == "feature")
    feature();
  else if (which == "inertia")
    inertia();
  else
    check(false, "an argument: feature or inertia");
}
