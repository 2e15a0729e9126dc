// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef tests_sweep_coarse_brake_h
#define tests_sweep_coarse_brake_h

#include "source_directory.h"

#include <squeal/contact/contact_terms.h>
#include <squeal/eigen/direct_solver.h>
#include <squeal/sweep/basis_builder.h>

#include <deal.II/distributed/tria.h>

#include <deal.II/fe/mapping.h>

#include <functional>
#include <string>
#include <vector>

namespace squeal
{
  namespace testing
  {
    /** A TriboBrake of few cells over the box of the shipped stability map. The
     * cost of a sweep is that of dense solves with its basis, which every cell
     * of pad and support makes larger. */
    struct CoarseBrake
    {
      /** @p refine is called with the mesh before anything is assembled, @p
       * states with the grid for contact states of its points. */
      explicit CoarseBrake(
        const std::vector<std::string>                  &settings = {},
        const std::function<void(Discretization &)>     &refine   = {},
        const std::function<ContactStates(SweepGrid &)> &states   = {})
        : parameters(read(settings))
        , discretization(parameters.scene,
                         parameters.discretization,
                         2,
                         MPI_COMM_SELF)
        , grid(parameters)
        , linearized([&]() {
          if (refine)
            refine(discretization);
          std::vector<ContactStates> all;
          if (states)
            all.push_back(states(grid));
          return linearized_system(
            discretization, assemble_bodies(discretization), all);
        }())
        , system(linearized.system, grid)
      {
        options.band                = {2000., 6000.};
        options.frequency_tolerance = parameters.sweep.frequency_tolerance;
        options.sigma_tolerance     = parameters.sweep.sigma_tolerance;
      }

      ComplexPairs
      solve(const ReducedModel &model, const SweepPoint &point) const
      {
        return solve_point(
          model, point, system.coefficients(point), options.band);
      }

      /** Without a basis, pairs about the middle of the band. */
      ComplexPairs
      direct(const SceneParameters &scene) const
      {
        const Pencil       pencil(system.merged(), scene);
        const DirectSolver solver(
          pencil, {0., M_PI * (options.band.lowest + options.band.highest)});
        return solver.solve(n_direct);
      }

      Parameters       parameters;
      Discretization   discretization;
      SweepGrid        grid;
      LinearizedSystem linearized;
      ParametricSystem system;
      BasisOptions     options;
      unsigned int     n_direct = 26;

    private:
      static Parameters
      read(std::vector<std::string> settings)
      {
        settings.insert(settings.begin(),
                        {"Scene/Body disc/Cells = 16, 3, 1",
                         "Scene/Body pad/Cells = 1, 1, 1",
                         "Scene/Body support/Cells = 1, 1, 6"});
        return read_parameters(
          SQUEAL_SOURCE_DIR "/prm/tribobrake/stability_map.prm", settings);
      }
    };
  } // namespace testing
} // namespace squeal

#endif
