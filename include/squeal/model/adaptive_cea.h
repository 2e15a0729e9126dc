// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_model_adaptive_cea_h
#define squeal_model_adaptive_cea_h

#include <squeal/model/cea_solution.h>
#include <squeal/model/pair_errors.h>

namespace squeal
{
  class SecondSolutions;

  /** Complex pairs on the last mesh, with what the mesh does to them. */
  struct MeshedCea
  {
    ModeSolution modes;
    CeaSolution  solution;
    PairErrors   errors; /**< NaN where they were not estimated */
  };

  /**
   * Solves for the complex pairs of @p model. With `Refinement = contact error`
   * the mesh is refined where the growth rates of the unstable pairs (of the
   * least stable one where none is unstable) arise, source faces of mortar
   * contacts and ties as a whole, until the estimated errors of the growth rate
   * of the loudest pair and of the frequencies of all are below the tolerances:
   * frequencies decide which pairs lock in. The contact states of steady
   * sliding are those of each mesh. With any other refinement it is
   * solve_modes_adaptively() and solve_cea(). @p steps receives one row a mesh.
   */
  MeshedCea solve_cea_adaptively(Model  &model,
                                 RunLog &log,
                                 Timers &timers,
                                 Table  *steps = nullptr);

  /** Errors by the mesh of all pairs that grow and of the least damped others,
   * as solve_cea_adaptively() gives them on one mesh: growth rates by a
   * solution of one degree less, of @p second, where that finds the pair again.
   * NaN for the rest. */
  PairErrors loudest_pair_errors(const Model        &model,
                                 const Pencil       &pencil,
                                 const ComplexPairs &pairs,
                                 SecondSolutions    &second,
                                 RunLog             &log,
                                 Timers             &timers);

  /** The columns of the steps: one mesh a row. */
  Table mesh_steps_table();
} // namespace squeal

#endif
