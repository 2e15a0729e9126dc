// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_analyses_limit_cycle_branch_models_h
#define squeal_analyses_limit_cycle_branch_models_h

#include <squeal/cycle/period_maps.h>
#include <squeal/model/pressed_scene.h>

#include <memory>

namespace squeal
{
  class RunContext;

  /** Steady sliding at one value of the parameter and the motions about it. */
  struct BranchModel
  {
    BranchModel(const double coordinate, const SteadyModel &about);
    BranchModel(const double                        coordinate,
                std::shared_ptr<const PressedScene> scene,
                const double                        tolerance,
                Timers                             &timers);

    const double                              coordinate;
    const std::shared_ptr<const PressedScene> scene; /**< or null */
    const SteadyModel                         about;
    const PeriodMap                           map;
  };

  /**
   * The scene along the only axis of `Sweep`, by its coordinate (SweepGrid).
   * Over coefficients of friction all have the modes of the pressed model; over
   * other numbers the bodies are assembled and reduced anew at every value. The
   * last ones that were asked for are kept.
   */
  class BranchModels
  {
  public:
    /** Both are kept. */
    BranchModels(RunContext &context, const PressedModel &pressed);
    ~BranchModels();

    /** Throws ComputationError where there is no steady sliding. */
    std::shared_ptr<const BranchModel> at(const double coordinate) const;

    /** The motions of these models, which live as long as any of the maps. */
    PeriodMaps maps() const;

  private:
    class Kept;
    const std::shared_ptr<Kept> kept;
  };
} // namespace squeal

#endif
