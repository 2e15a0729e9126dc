// SPDX-License-Identifier: LGPL-2.1-or-later

// What drives a transient, and its integrator.

#include <squeal/analyses/transient/transient_run.h>
#include <squeal/base/unknown_choice.h>
#include <squeal/model/load_checks.h>
#include <squeal/transient/explicit_transient.h>
#include <squeal/transient/implicit_transient.h>
#include <squeal/transient/reduced_transient.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace squeal
{
  namespace
  {
    double
    half_sine(const double time, const double start, const double duration)
    {
      const double s = (time - start) / duration;
      return s > 0. && s < 1. ? std::sin(M_PI * s) : 0.;
    }

    /** From 0 to 1, smooth. */
    double
    ramp(const double time, const double duration)
    {
      if (time >= duration)
        return 1.;
      return time <= 0. ? 0. : 0.5 * (1. - std::cos(M_PI * time / duration));
    }

    /** mu over time, and the laws of several pairs or over the slip rate. */
    void
    set_friction(const ContactNodes        &nodes,
                 const TransientParameters &t,
                 TransientDrive            &drive)
    {
      const FrictionLaws laws = nodes.laws();
      const bool         is_one_number =
        laws.is_constant() && nodes.pairs().size() == 1;
      if (!is_one_number)
        drive.laws = std::make_shared<const FrictionLaws>(laws);
      drive.friction = [mu = is_one_number ? laws.of(0).at_rest() : 0.,
                        t](const double time) {
        return mu + t.friction_impulse * half_sine(time,
                                                   t.friction_impulse_time,
                                                   t.friction_impulse_duration);
      };
    }

    /** Loads of one ramp are the load of the model; otherwise each is a force
     * with a ramp of its own. */
    void
    set_loads(const PressedModel &pressed,
              const Parameters   &p,
              TransientDrive     &drive)
    {
      const auto &loads = p.scene.loads;
      const bool ramped = p.transient.start == TransientParameters::Start::ramp;
      double     longest = 0., shortest = std::numeric_limits<double>::max();
      for (const auto &load : loads)
        {
          longest  = std::max(longest, load.ramp_time);
          shortest = std::min(shortest, load.ramp_time);
        }
      const bool is_one_ramp = !ramped || !(shortest < longest);
      drive.load = [ramped, is_one_ramp, longest](const double time) {
        if (!is_one_ramp)
          return 0.;
        return ramped ? ramp(time, longest) : 1.;
      };
      if (!is_one_ramp)
        for (const auto &load : loads)
          drive.forces.push_back(
            {pressed.force(load),
             [duration = load.ramp_time](const double time) {
               return ramp(time, duration);
             }});
    }
  } // namespace



  TransientDrive
  make_drive(const PressedModel &pressed, const Parameters &p)
  {
    const TransientParameters t = p.transient;
    TransientDrive            drive;
    set_friction(pressed.nodes(), t, drive);
    drive.speed = [speed = pressed.speed(), t](const double time) {
      return speed * (1. + (t.final_speed_ratio - 1.) * time / t.end_time);
    };
    set_loads(pressed, p, drive);
    if (!t.hammer.body.empty())
      drive.forces.push_back(
        {pressed.force(load_of(t.hammer)), [t](const double time) {
           return half_sine(time, t.hammer.time, t.hammer.duration);
         }});
    std::vector<ModalForce> further;
    for (const auto &force : drive.forces)
      further.push_back(force.force);
    drive.flexibility = pressed.flexibility_of(further);
    return drive;
  }



  std::unique_ptr<TransientIntegrator>
  make_integrator(const PressedModel  &pressed,
                  const SteadySliding &steady,
                  const Parameters    &p)
  {
    using Integrator   = TransientParameters::Integrator;
    const auto  &t     = p.transient;
    const auto   drive = make_drive(pressed, p);
    const double force = steady.resultant()[0] / pressed.model().n_nodes();
    const auto   method =
      t.contact_method == TransientParameters::ContactMethod::newton
          ? ContactSolver::Method::newton
          : ContactSolver::Method::gauss_seidel;
    switch (t.integrator)
      {
      case Integrator::implicit:
        return std::make_unique<ImplicitTransient>(pressed.full_model(steady),
                                                   t.step(),
                                                   drive,
                                                   force,
                                                   t.tolerance,
                                                   method);
      case Integrator::explicit_:
        return std::make_unique<ExplicitTransient>(pressed.full_model(steady),
                                                   t.step(),
                                                   drive,
                                                   force,
                                                   t.tolerance,
                                                   method,
                                                   t.beta_2);
      case Integrator::reduced:
        return std::make_unique<ReducedTransient>(
          pressed.model(), t.step(), drive, force, t.tolerance, method);
      }
    unknown_choice("integrator");
  }
} // namespace squeal
