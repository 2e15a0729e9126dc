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

    /** What to do where the lag of falling friction needs steps of @p shortest,
     * s. The full integrators have a lag too, which the mass of the nodes
     * bears.
     */
    std::string
    way_out_of_lag(const ReducedContactModel &model, const double shortest)
    {
      const std::string other =
        " or, with mortar contact, 'Integrator = implicit'";
      const double largest = largest_stable_step(model, shortest);
      if (!(largest < shortest))
        return "take a longer step" + other;
      return "no step of this model is long enough (the largest stable one "
             "is " +
             rounded_text(largest, 3) + " s): take a law that is less steep" +
             other;
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
  warn_of_kinks(const SceneParameters &scene, RunLog &log)
  {
    for (const ContactParameters &contact : scene.contacts)
      if (const std::string remark = remark_on_kink(contact); !remark.empty())
        log.warning(remark);
  }



  void
  warn_of_short_lag(const PressedModel  &pressed,
                    const SteadySliding &steady,
                    const Parameters    &p,
                    RunLog              &log)
  {
    const TransientParameters &t = p.transient;
    if (t.integrator != TransientParameters::Integrator::reduced)
      return;
    const ReducedContactModel &model    = pressed.model();
    const NodalFriction        friction = pressed.sliding_friction();
    // The speed changes linearly, through zero where it turns back: the largest
    // is that of an end, and all below it is passed through or slid at.
    const double largest_speed =
      std::max(1., std::abs(t.final_speed_ratio)) * pressed.speed();
    Eigen::VectorXd steepest(model.n_nodes()), about(model.n_nodes());
    for (unsigned int j = 0; j < model.n_nodes(); ++j)
      {
        const FrictionLaw law(p.scene.contacts[pressed.nodes().pair_of(j)]);
        steepest[j] = law.steepest_fall(largest_speed * model.speed_ratio[j]);
        about[j]    = steepest[j] > 0. ? std::max(0., -friction.slope[j]) : 0.;
      }
    const LagLimit limit = lag_limit(model, steady, steepest, t.time_step);
    if (!(limit.shortest > t.time_step))
      return;
    const LagLimit in_steady = lag_limit(model, steady, about, t.time_step);
    log.warning(
      "'Transient/Time step' = " + rounded_text(t.time_step, 3) +
      " s is below the " + rounded_text(limit.shortest, 3) +
      " s that friction which falls so steeply needs on a massless contact (" +
      std::to_string(limit.n_above) + " of " +
      std::to_string(steady.n_with(ContactStatus::slip)) +
      " slipping nodes; in steady sliding " +
      rounded_text(in_steady.shortest, 3) +
      " s): nodes may jump between sticking and slipping, and a limit cycle "
      "is then no result; " +
      way_out_of_lag(model, limit.shortest));
  }
} // namespace squeal
