// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/number_text.h>
#include <squeal/base/run_log.h>
#include <squeal/contact/friction_law.h>
#include <squeal/model/drive_warnings.h>
#include <squeal/model/pressed_model.h>
#include <squeal/transient/lag_limit.h>
#include <squeal/transient/modal_step.h>

#include <algorithm>
#include <cmath>

namespace squeal
{
  namespace
  {
    void
    warn_of_early_trigger(const std::string &entry,
                          const double       time,
                          const double       longest,
                          RunLog            &log)
    {
      if (time < longest)
        log.warning("'" + entry + "' = " + rounded_text(time, 4) +
                    " s is before the end of the longest 'Ramp time', " +
                    rounded_text(longest, 4) +
                    " s: what follows the trigger is not told from what the "
                    "load does that comes on");
    }

    /** What to do where the lag of friction that falls or @p rises needs steps
     * of @p shortest, s. The full integrators have a lag too, which the mass of
     * the nodes bears where friction falls. */
    std::string
    way_out_of_lag(const ReducedContactModel &model,
                   const double               shortest,
                   const bool                 rises)
    {
      const std::string other =
        rises ? "" : " or, with mortar contact, 'Integrator = implicit'";
      const double largest = largest_stable_step(model, shortest);
      if (!(largest < shortest))
        return "take a longer step" + other;
      return "no step of this model is long enough (the largest stable one "
             "is " +
             rounded_text(largest, 3) + " s): take a law that is less steep" +
             other;
    }

    /** What rising friction does to a node in a step of the full integrators,
     * its mass must bear. */
    void
    warn_of_long_lag(const double rise, RunLog &log)
    {
      if (rise > 0.)
        log.warning(
          "friction rises with the slip rate by up to " +
          rounded_text(rise, 3) +
          " s/m and follows it a step later: unless 'Transient/Time step' is "
          "short against the mass of a contact node over its normal force "
          "times that rise, nodes jump between sticking and slipping, and "
          "mean forces, a vibration and a limit cycle are no results; see "
          "whether nodes stick that slip in steady sliding");
    }
  } // namespace



  void
  warn_of_drive(const Parameters &p, RunLog &log)
  {
    const TransientParameters &t       = p.transient;
    double                     longest = 0.;
    for (const auto &load : p.scene.loads)
      longest = std::max(longest, load.ramp_time);
    if (t.start != TransientParameters::Start::ramp)
      return;
    if (!t.hammer.body.empty())
      warn_of_early_trigger(
        "Transient/Hammer/Time", t.hammer.time, longest, log);
    if (t.friction_impulse != 0.)
      warn_of_early_trigger("Transient/Friction impulse time",
                            t.friction_impulse_time,
                            longest,
                            log);
  }



  void
  warn_of_short_lag(const PressedModel  &pressed,
                    const SteadySliding &steady,
                    const Parameters    &p,
                    RunLog              &log)
  {
    const TransientParameters &t        = p.transient;
    const ReducedContactModel &model    = pressed.model();
    const NodalFriction        friction = pressed.sliding_friction();
    // The speed changes linearly, through zero where it turns back: the largest
    // is that of an end, and all below it is passed through or slid at.
    const double largest_speed =
      std::max(1., std::abs(t.final_speed_ratio)) * pressed.speed();
    Eigen::VectorXd steepest(model.n_nodes()), about(model.n_nodes());
    double          largest_rise = 0.;
    bool            rises        = false;
    for (unsigned int j = 0; j < model.n_nodes(); ++j)
      {
        const FrictionLaw law(p.scene.contacts[pressed.nodes().pair_of(j)]);
        const double      speed = largest_speed * model.speed_ratio[j];
        // Friction that falls holds what sticks at rest; under friction that
        // rises slip which begins there chatters.
        const double fall = steady.status[j] == ContactStatus::slip
                              ? law.steepest_fall(speed)
                              : 0.,
                     rise = law.steepest_rise(speed);
        steepest[j]       = lag_slope(fall, rise);
        about[j] = lag_slope(fall > 0. ? std::max(0., -friction.slope[j]) : 0.,
                             rise > 0. ? std::max(0., friction.slope[j]) : 0.);
        rises = rises || 2. * rise > fall;
        if (steady.status[j] != ContactStatus::open)
          largest_rise = std::max(largest_rise, rise);
      }
    if (t.integrator != TransientParameters::Integrator::reduced)
      return warn_of_long_lag(largest_rise, log);
    const LagLimit limit = lag_limit(model, steady, steepest, t.time_step);
    if (!(limit.shortest > t.time_step))
      return;
    const LagLimit in_steady = lag_limit(model, steady, about, t.time_step);
    log.warning(
      "'Transient/Time step' = " + rounded_text(t.time_step, 3) +
      " s is below the " + rounded_text(limit.shortest, 3) +
      " s that friction which " + (rises ? "rises" : "falls") +
      " so steeply needs on a massless contact (" +
      std::to_string(limit.n_above) + " of " +
      std::to_string(steady.n_closed()) + " closed nodes; in steady sliding " +
      rounded_text(in_steady.shortest, 3) +
      " s): nodes may jump between sticking and slipping, and " +
      (rises ? "mean forces, a vibration and a limit cycle are then no results"
             : "a limit cycle is then no result") +
      "; " + way_out_of_lag(model, limit.shortest, rises));
  }
} // namespace squeal
