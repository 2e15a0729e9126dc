// SPDX-License-Identifier: LGPL-2.1-or-later

// The eigenvalues of a brake do not depend on the number of ranks, with spring
// contact, with mortar contact and on a locally refined mesh.

#include "scenes.h"
#include "worst.h"

#include <squeal/eigen/direct_solver.h>

#include <deal.II/base/mpi.h>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  constexpr double top = 6000.;

  void
  check_equal(const Eigen::VectorXcd &a,
              const Eigen::VectorXcd &b,
              const std::string      &name)
  {
    check(a.size() == b.size() && a.size() > 5,
          name + ": as many pairs: " + std::to_string(a.size()));
    Worst worst;
    for (Eigen::Index i = 0; i < a.size(); ++i)
      worst.add((b.array() - a[i]).abs().minCoeff<Eigen::PropagateNaN>() /
                std::abs(a[i]));
    check_below(
      worst.largest(), 1e-8, name + ": eigenvalues of one and two ranks");
  }

  void
  test_certified(const SceneParameters &scene, const std::string &name)
  {
    Model alone(scene, 2, top, MPI_COMM_SELF),
      all(scene, 2, top, MPI_COMM_WORLD);
    check(all.pencil.space()->n_global() == alone.pencil.space()->n_global(),
          name + ": as many unknowns");
    check(all.pencil.space()->n_owned() < all.pencil.space()->n_global(),
          name + ": the unknowns are spread");
    check_equal(all.solve(band(500., top)).lambda,
                alone.solve(band(500., top)).lambda,
                name);
    const auto a = undamped_modes(all.pencil, all.inverse),
               b = undamped_modes(alone.pencil, alone.inverse);
    check(a.n_certified == b.n_certified, name + ": as many modes");
    const unsigned int n = a.n_certified;
    check_below(
      // Relative to the largest: those of rigid motions are rounding.
      (a.omega_squared.head(n) - b.omega_squared.head(n))
          .cwiseAbs()
          .maxCoeff<Eigen::PropagateNaN>() /
        b.omega_squared[n - 1],
      1e-8,
      name + ": undamped modes on two ranks");
  }

  void
  test_direct()
  {
    const SceneParameters scene = coarse_brake(.5);
    const Model           alone(scene, 1, top, MPI_COMM_SELF),
      all(scene, 1, top, MPI_COMM_WORLD);
    const std::complex<double> shift(0., M_PI * top);
    check_equal(DirectSolver(all.pencil, shift).solve(8).lambda,
                DirectSolver(alone.pencil, shift).solve(8).lambda,
                "direct solver");
  }

  Eigen::VectorXcd
  refined(const MPI_Comm communicator)
  {
    const SceneParameters scene = coarse_brake(.5);
    Discretization        d(scene, {}, 1, communicator);
    std::vector<double>   marks(d.triangulation().n_active_cells(), 1e-6);
    for (const auto &cell : d.dof_handler().active_cell_iterators())
      if (cell->is_locally_owned() && cell->material_id() == 0 &&
          cell->center()[0] > .09)
        marks[cell->active_cell_index()] = 1.;
    d.refine(marks, .99);
    const auto           linearized = linearized_system(d, assemble_bodies(d));
    const Pencil         pencil(linearized.system, scene);
    const ShiftedInverse inverse(pencil, std::pow(2. * M_PI * top, 2));
    const UndampedModes  modes = undamped_modes(pencil, inverse);
    return CertifiedSolver(pencil, inverse, modes)
      .solve(band(500., top))
      .lambda;
  }
} // namespace



int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize init(argc, argv, 1);
  check(dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) == 2,
        "two ranks");
  SceneParameters scene = coarse_brake(.5);
  test_certified(scene, "springs");
  scene.contacts[0].formulation = ContactParameters::Formulation::mortar;
  test_certified(scene, "mortar");
  test_direct();
  check_equal(refined(MPI_COMM_WORLD), refined(MPI_COMM_SELF), "hanging nodes");
  return 0;
}
