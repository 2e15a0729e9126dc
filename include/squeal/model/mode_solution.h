// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_model_mode_solution_h
#define squeal_model_mode_solution_h

#include <squeal/discretization/eigenvalue_error.h>
#include <squeal/eigen/undamped_modes.h>
#include <squeal/model/model.h>
#include <squeal/results/table.h>

#include <memory>
#include <vector>

namespace squeal
{
  class RunLog;
  class Timers;

  /** The undamped modes of a model with all that is known of them. */
  struct ModeSolution
  {
    std::unique_ptr<Pencil>         pencil;
    std::unique_ptr<ShiftedInverse> inverse;
    UndampedModes                   modes;
    std::vector<ModeName>           names;
    Eigen::MatrixXd                 energy_shares; /**< bodies x modes */
    /** Estimated relative frequency error of each mode by the mesh; NaN where
     * it was not estimated. */
    std::vector<double> discretisation_error;

    /** Number of modes with frequency up to @p highest (Hz). */
    unsigned int n_up_to(const double highest) const;
  };

  /**
   * Factorises at the upper edge of the band and computes every mode below it,
   * proven complete by the inertia. Doublets are turned into "+" and "-" shapes
   * and all modes named.
   */
  ModeSolution solve_modes(const Model &model, RunLog &log, Timers &timers);

  /**
   * Refines the mesh of @p model, if its parameters ask for it, until the
   * estimated relative frequency error of every mode in the band is below the
   * tolerance; returns the modes on the last mesh, with error estimates where
   * asked for. @p steps (optional) receives one row a mesh.
   */
  ModeSolution solve_modes_adaptively(Model  &model,
                                      RunLog &log,
                                      Timers &timers,
                                      Table  *steps = nullptr);

  /** Refuses a band without modes or eigenvalues: throws InputError with the
   * frequency of the mode next to it, where one is known. */
  [[noreturn]] void refuse_empty_band(const Parameters   &parameters,
                                      const ModeSolution &solution);

  /**
   * What moves without being held, by the names of the bodies: "6 motions at
   * 0 Hz are held by nothing, of the bodies pad, support"; empty if nothing
   * does. What counts is said of find_free_motions().
   */
  std::string free_motions(const Model &model, const ModeSolution &solution);

  /** modes.csv of the modes within the band. */
  Table mode_table(const Model &model, const ModeSolution &solution);
} // namespace squeal

#endif
