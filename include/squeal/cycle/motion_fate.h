// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_cycle_motion_fate_h
#define squeal_cycle_motion_fate_h

#include <squeal/cycle/period_map.h>
#include <squeal/transient/steady_sliding.h>

#include <optional>
#include <string>
#include <vector>

namespace squeal
{
  /** What a motion beside a stable steady sliding ends in. */
  enum class MotionFate
  {
    returns,  /**< steady sliding */
    squeals,  /**< a vibration that lasts */
    undecided /**< neither until the longest time */
  };

  std::string fate_text(const MotionFate fate);

  /** How motions are judged; times in s. */
  struct FateSettings
  {
    double step    = 0.; /**< of time */
    double window  = 0.; /**< rounded to whole steps */
    double hold    = 0.; /**< that a window's verdict has to last */
    double longest = 0.; /**< from its start, then a motion is undecided */
  };

  /** What a motion does in a window. */
  struct MotionWindow
  {
    double time = 0.; /**< s, of its end */
    /** Root mean square of the norm of the energy away from steady sliding,
     * sqrt(J). */
    double amplitude  = 0.;
    double rms_normal = 0.;   /**< of the normal resultant about its mean, N, or
                                 of the moment that is judged, of the pair where
                                 that is largest */
    std::string judged_force; /**< that moment; empty: there is none */
    /** See rms_forces_of(), N. */
    double rms_forces   = 0.;
    bool   is_as_steady = false; /**< every node keeps its status of steady
                                    sliding in all steps */
    /** Largest angle between the friction of a node that slips and that of
     * steady sliding, rad. */
    double friction_turn = 0.;
  };

  /** A motion at one time. */
  struct MotionPlace
  {
    MotionState state;
    ContactPast past = {};
    double      time = 0.; /**< s */
  };

  /** A motion up to where it is decided. */
  struct FollowedMotion
  {
    MotionFate                fate = MotionFate::undecided;
    std::vector<MotionWindow> windows;
    MotionPlace               end;
    /** Mean of `rms_forces` over the last windows that were judged, N. */
    double       lasting_forces() const;
    unsigned int n_judged = 1; /**< of the last windows */
  };

  /** A motion whose friction turns by no more from that of steady sliding, rad,
   * and in which no node opens or sticks, is the linear one: what is left out
   * is of the square of it. */
  constexpr double linear_turn = 0.02;

  /**
   * Follows motions of a model with a stable steady sliding window by window
   * until it is clear what they end in.
   *
   * A motion returns when in all windows of the hold time no node has left the
   * status that it has in steady sliding and no friction has turned by more
   * than linear_turn, so that the motion is the linear one, which decays, and
   * when its amplitude has fallen over them. It squeals when
   * it is none of these and the forces of all windows of the hold time are
   * those of a known vibration that lasts, within 5 %; where none is known,
   * when they agree so well with their mean at the longest time.
   *
   * Steps are those of PeriodMap::run_plainly().
   */
  class MotionFollower
  {
  public:
    /** References are kept. Throws InputError for steps that are too long. */
    MotionFollower(const PeriodMap     &map,
                   const SteadySliding &steady,
                   const FateSettings  &settings);

    /** @p place a window later, and what it does until then. Throws
     * ComputationError where a step has no solution. */
    MotionWindow advance(MotionPlace &place) const;

    /** The steps of @p n_windows, which @p place moves on by. */
    Orbit orbit(MotionPlace &place, const unsigned int n_windows) const;

    /** @p lasting: `rms_forces` of the vibration that lasts, N, if known. */
    FollowedMotion follow(MotionPlace                  start,
                          const std::optional<double> &lasting) const;

    const PeriodMap &
    period_map() const
    {
      return map;
    }
    const SteadySliding &
    steady_sliding() const
    {
      return steady;
    }
    /** Length of a window of whole steps, s. */
    double window() const;

  private:
    bool has_returned(const std::vector<MotionWindow> &windows) const;
    bool lasts(const std::vector<MotionWindow> &windows,
               const double                     forces) const;

    const PeriodMap     &map;
    const SteadySliding &steady;
    const FateSettings   settings;
    const MotionState    rest;
    const unsigned int   n_steps, n_hold; /**< of a window; windows */
  };

  /** The state after a blow of the size @p impulse, N s, on steady sliding: a
   * half sine of @p duration, s, by steps of about @p step; @p unit: the force
   * of 1 N. */
  MotionPlace struck_motion(const PeriodMap     &map,
                            const SteadySliding &steady,
                            const ModalForce    &unit,
                            const double         impulse,
                            const double         duration,
                            const double         step);
} // namespace squeal

#endif
