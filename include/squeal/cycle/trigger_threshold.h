// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_cycle_trigger_threshold_h
#define squeal_cycle_trigger_threshold_h

#include <squeal/cycle/motion_fate.h>

#include <functional>
#include <vector>

namespace squeal
{
  /** The smallest impulse that leads to squeal, as trials tell it. */
  struct TriggerThreshold
  {
    enum class Status
    {
      bracketed,            /**< to the tolerance */
      undecided,            /**< a trial inside the bracket is */
      no_squeal,            /**< the largest impulse returns */
      undecided_at_largest, /**< the largest impulse is */
      none_returns,         /**< down to a millionth of the smallest one */
      not_there             /**< a guess of the bracket has not held */
    };
    struct Trial
    {
      double     impulse; /**< N s */
      MotionFate fate;
    };

    Status status = Status::undecided;
    double lower  = 0.; /**< N s; it returns, 0: nothing does so for ever */
    double upper  = 0.; /**< N s; it squeals */
    std::vector<Trial> trials; /**< in their order */
    /** Along the ladder, from nothing on: how often what a motion ends in
     * changes; more than once: a larger impulse returns again. */
    unsigned int n_changes = 0;

    bool
    is_found() const
    {
      return status == Status::bracketed || status == Status::undecided;
    }
    double
    middle() const
    {
      return .5 * (lower + upper);
    }
  };

  std::string threshold_text(const TriggerThreshold::Status status);

  using FateOfImpulse = std::function<MotionFate(const double impulse)>;

  /**
   * Tries the largest of the ascending impulses @p ladder, then all others from
   * below, then bisects between the smallest that squeals and the largest below
   * it that returns until their distance is @p tolerance of the upper one.
   */
  TriggerThreshold find_threshold(const FateOfImpulse       &fate,
                                  const std::vector<double> &ladder,
                                  const double               tolerance);

  /** The same from a guess: the bracket of @p near is widened by its own width
   * to either side, then by twice that and so on, until it holds; `not_there`
   * where that reaches a half and twice as much. */
  TriggerThreshold find_threshold_near(const FateOfImpulse    &fate,
                                       const TriggerThreshold &near,
                                       const double            tolerance);
} // namespace squeal

#endif
