// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/parameters/checks.h>
#include <squeal/parameters/numbers.h>
#include <squeal/parameters/text.h>

#include <algorithm>
#include <cmath>

namespace squeal
{
  namespace prm
  {
    namespace
    {
      const std::string triggers_section = "Triggers";

      void
      check_blows(const Parameters &p)
      {
        const TriggersParameters &t = p.triggers;
        if (p.measurement.points.empty())
          refuse_entry("Measurement",
                       "Points",
                       "is empty: name the points that are struck and add "
                       "their sections 'Point <name>'");
        for (const std::string &point : t.points)
          {
            if (p.measurement.find(point) < 0)
              refuse_entry(triggers_section,
                           "Points",
                           "contains " + in_quotes(point) +
                             ", which is not in 'Measurement/Points'");
            if (std::count(t.points.begin(), t.points.end(), point) > 1)
              refuse_entry(triggers_section,
                           "Points",
                           "contains " + in_quotes(point) + " twice");
          }
        if (t.impulses.empty())
          refuse_entry(triggers_section,
                       "Impulses",
                       "is empty: name at least one that leads to squeal");
        if (std::adjacent_find(t.impulses.begin(),
                               t.impulses.end(),
                               [](const double a, const double b) {
                                 return !(a < b);
                               }) != t.impulses.end())
          refuse_entry(triggers_section, "Impulses", "must ascend");
      }

      void
      check_window(const Parameters &p)
      {
        const TriggersParameters &t    = p.triggers;
        const double              step = p.transient.time_step;
        if (!(10. * step <= t.window))
          refuse_entry(triggers_section,
                       "Window",
                       "= " + format_number(t.window) +
                         " s must be ten 'Transient/Time step' (" +
                         format_number(step) + " s) at least");
        if (!(10. * step <= t.duration))
          refuse_entry(triggers_section,
                       "Duration",
                       "= " + format_number(t.duration) +
                         " s must be ten 'Transient/Time step' (" +
                         format_number(step) + " s) at least");
        if (!(2. * t.window <= t.hold))
          refuse_entry(triggers_section,
                       "Hold time",
                       "= " + format_number(t.hold) +
                         " s must be two 'Window' at least");
        if (!(2. * t.hold <= t.longest))
          refuse_entry(triggers_section,
                       "Longest time",
                       "= " + format_number(t.longest) +
                         " s must be twice 'Hold time' at least");
      }

      void
      check_constant_drive(const TransientParameters &t)
      {
        if (!t.hammer.body.empty())
          refuse_entry("Transient/Hammer",
                       "Body",
                       "must be empty: the blows of 'Analysis = triggers' are "
                       "those of 'Triggers/Points'");
        if (t.friction_impulse != 0.)
          refuse_entry("Transient",
                       "Friction impulse",
                       "must be 0: the blows of 'Analysis = triggers' are "
                       "those of 'Triggers/Points'");
        if (t.final_speed_ratio != 1.)
          refuse_entry("Transient",
                       "Final speed ratio",
                       "must be 1: steady sliding has one speed");
        if (t.start != TransientParameters::Start::steady_sliding)
          refuse_entry(
            "Transient", "Start", "must be steady sliding: blows strike that");
      }

      /** Steps of a half sine: with fewer its impulse is off by more than 1 %,
       * and between two steps it is none. */
      constexpr double fewest_steps = 10.;

      void
      check_duration(const double       duration,
                     const double       step,
                     const std::string &section,
                     const std::string &entry)
      {
        // Ten steps as they are written.
        if (!(fewest_steps * step <= duration * (1. + 1e-9)))
          refuse_entry(section,
                       entry,
                       "= " + format_number(duration) +
                         " s must be ten time steps (" + format_number(step) +
                         " s) at least: the steps would not follow the half "
                         "sine");
      }

      void
      check_hammer(const TransientParameters &t)
      {
        const HammerParameters &hammer  = t.hammer;
        const std::string       section = "Transient/Hammer";
        if (hammer.body.empty())
          return;
        if (!(hammer.time < t.end_time))
          refuse_entry(section,
                       "Time",
                       "is not before 'Transient/End time': nothing is struck");
        if (hammer.force == Vector3{})
          refuse_entry(section,
                       "Force",
                       "= 0, 0, 0: nothing is struck; give the largest force, "
                       "or leave 'Body' empty");
        check_duration(hammer.duration, t.step(), section, "Duration");
      }

      /** Size of the least coefficient of a pair at any slip rate. */
      double
      least_friction(const ContactParameters &c)
      {
        return c.friction_law == ContactParameters::FrictionLaw::table
                 ? *std::min_element(c.friction_coefficients.begin(),
                                     c.friction_coefficients.end())
                 : std::abs(c.friction_coefficient);
      }

      /** The steps would cut the half sine off at a coefficient of 0. */
      void
      check_size_of_impulse(const Parameters &p)
      {
        const double impulse = p.transient.friction_impulse;
        for (const ContactParameters &c : p.scene.contacts)
          if (const double least = least_friction(c);
              c.sliding_speed > 0. && impulse + least < 0.)
            refuse_entry("Transient",
                         "Friction impulse",
                         "= " + format_number(impulse) +
                           " takes the friction of contact " +
                           in_quotes(c.name) +
                           " below 0: it is added to the size of the "
                           "coefficient, and must be at least " +
                           format_number(-least));
      }

      void
      check_friction_impulse(const Parameters &p)
      {
        const TransientParameters &t       = p.transient;
        const std::string          section = "Transient";
        if (t.friction_impulse == 0.)
          return;
        if (!(t.friction_impulse_time < t.end_time))
          refuse_entry(section,
                       "Friction impulse time",
                       "is not before 'End time': there would be no impulse");
        check_duration(t.friction_impulse_duration,
                       t.step(),
                       section,
                       "Friction impulse duration");
        check_size_of_impulse(p);
      }

      /** Hammer and friction impulse of a transient. */
      void
      check_strikes(const Parameters &p)
      {
        check_hammer(p.transient);
        check_friction_impulse(p);
      }
    } // namespace



    void
    check_triggers(const Parameters &p)
    {
      if (p.analysis == Parameters::Analysis::transient)
        check_strikes(p);
      if (p.analysis != Parameters::Analysis::triggers)
        return;
      check_blows(p);
      check_window(p);
      check_constant_drive(p.transient);
      for (const ContactParameters &c : p.scene.contacts)
        if (c.state == ContactParameters::State::stick)
          refuse_entry("Scene/Contact " + c.name,
                       "Contact state",
                       "= stick: the blows of 'Analysis = triggers' strike "
                       "steady sliding; use full or preload");
    }
  } // namespace prm
} // namespace squeal
