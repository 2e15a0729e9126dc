// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_cycle_period_maps_h
#define squeal_cycle_period_maps_h

#include <squeal/cycle/period_map.h>

#include <functional>
#include <memory>

namespace squeal
{
  /**
   * States of one model in the modes of another one of the same unknowns, whose
   * bodies, loads or contacts differ a little: deviations q - q_0 from steady
   * sliding are carried by phi_to^T M_to phi_from, so that statics, which the
   * difference changes, stay those of each model. Forces of nodes are the same
   * in both.
   */
  struct ModeChange
  {
    Eigen::MatrixXd modes;       /**< phi_to^T M_to phi_from */
    Eigen::VectorXd from_steady; /**< q_0 of either */
    Eigen::VectorXd to_steady;

    MotionState     carried(const MotionState &state) const;
    MotionState     carried_difference(const MotionState &difference) const;
    StepCorrections carried(const StepCorrections &corrections) const;
  };

  /** The motions of a model for every value of a parameter. */
  struct PeriodMaps
  {
    using Map = std::shared_ptr<const PeriodMap>;

    /** Throws ComputationError where there is no steady sliding. */
    std::function<Map(double)> at;
    /** Between two values of the parameter; empty: all share the modes. */
    std::function<ModeChange(double from, double to)> change;

    Map
    operator()(const double parameter) const
    {
      return at(parameter);
    }
    /** Null where the model cannot be made or does not slide steadily. */
    Map find(const double parameter) const;

    bool
    share_modes() const
    {
      return !change;
    }

    /** @p what, of the modes at @p from, in those at @p to. */
    template <typename What>
    What
    carried(const What &what, const double from, const double to) const
    {
      return share_modes() || from == to ? what
                                         : change(from, to).carried(what);
    }
    MotionState carried_difference(const MotionState &difference,
                                   const double       from,
                                   const double       to) const;
  };
} // namespace squeal

#endif
