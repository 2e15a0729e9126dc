// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/parameters/checks.h>
#include <squeal/parameters/numbers.h>
#include <squeal/parameters/text.h>

#include <algorithm>

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
      }
    } // namespace



    void
    check_triggers(const Parameters &p)
    {
      if (p.analysis != Parameters::Analysis::triggers)
        return;
      check_blows(p);
      check_window(p);
      check_constant_drive(p.transient);
    }
  } // namespace prm
} // namespace squeal
