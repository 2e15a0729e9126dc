// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/parameters/checks.h>
#include <squeal/parameters/entry_traits.h>

#include <algorithm>

namespace squeal
{
  namespace prm
  {
    namespace
    {
      using State = ContactParameters::State;

      /** A branch over friction keeps the directions of the scene, which a
       * negative coefficient has turned. */
      void
      check_forward_sliding(const Parameters &p)
      {
        for (const auto &axis : p.sweep.axes)
          if (std::any_of(
                axis.entries.begin(), axis.entries.end(), &is_friction_entry))
            for (const auto &contact : p.scene.contacts)
              if (contact.friction_coefficient < 0.)
                refuse_entry("Scene/Contact " + contact.name,
                             "Friction coefficient",
                             "must not be negative for a branch over friction: "
                             "turn the sliding by its direction or the "
                             "'Rotation speed'");
      }

      /** What a limit cycle has nothing of, as it stands under constant loads,
       * speeds and friction and has a period in place of samples. */
      void
      check_nothing_passes(const Parameters &p)
      {
        const TransientParameters &t = p.transient;
        if (t.start != TransientParameters::Start::steady_sliding)
          refuse_entry("Transient",
                       "Start",
                       "must be steady sliding: limit cycles start from there");
        if (t.final_speed_ratio != 1.)
          refuse_entry("Transient",
                       "Final speed ratio",
                       "must be 1: limit cycles have one sliding speed");
        if (t.friction_impulse != 0.)
          refuse_entry("Transient",
                       "Friction impulse",
                       "must be 0: limit cycles start from a growing pair");
        if (!t.hammer.body.empty())
          refuse_entry("Transient/Hammer",
                       "Body",
                       "must be empty: limit cycles start from a growing pair");
        if (t.animation_frames > 0)
          refuse_entry("Transient",
                       "Animation frames",
                       "must be 0: they are the last samples of a transient");
        if (t.compare_with_cea)
          refuse_entry("Transient",
                       "Compare with CEA",
                       "must be false: it compares the growth of a transient");
        for (const ContactParameters &c : p.scene.contacts)
          if (c.state == State::stick)
            refuse_entry("Scene/Contact " + c.name,
                         "Contact state",
                         "= stick: limit cycles are those about steady "
                         "sliding; use full or preload");
      }
    } // namespace



    void
    check_periodic_motions(const Parameters &p)
    {
      const TransientParameters &t = p.transient;
      for (const ContactParameters &c : p.scene.contacts)
        {
          const std::string section = "Scene/Contact " + c.name;
          if (c.friction_law != ContactParameters::FrictionLaw::constant)
            refuse_entry(section,
                         "Friction law",
                         "must be constant: limit cycles have one "
                         "coefficient at all slip rates");
          if (c.sliding_speed == 0.)
            refuse_entry(section,
                         "Sliding speed",
                         "= 0: limit cycles need pairs that slide; what "
                         "sticks for ever may stick anywhere");
        }
      if (t.integrator != TransientParameters::Integrator::reduced)
        refuse_entry("Transient",
                     "Integrator",
                     "must be reduced: limit cycles are those of the "
                     "reduced model");
      if (t.disc_frame != TransientParameters::DiscFrame::eulerian)
        refuse_entry("Transient",
                     "Disc frame",
                     "must be eulerian: a turning mesh has no short period");
      if (t.cut_off < p.eigen.highest_frequency)
        refuse_entry("Transient",
                     "Cut-off",
                     "must not be below 'Eigenvalues/Highest frequency'");
      if (!t.integrators.empty())
        refuse_entry("Transient",
                     "Integrators",
                     "must be empty: limit cycles are those of the reduced "
                     "model");
    }



    void
    check_limit_cycle(const Parameters &p)
    {
      check_periodic_motions(p);
      check_nothing_passes(p);
      if (p.limit_cycle.starts > 0 && !p.limit_cycle.campaign &&
          !p.sweep.axes.empty())
        refuse_entry("Limit cycle",
                     "Starts",
                     "must be 0 for a branch over an axis of 'Sweep': motions "
                     "from other starts are followed at the points of a "
                     "'Campaign' or beside a single cycle");
      if (p.limit_cycle.searches > 0 &&
          (p.limit_cycle.campaign || p.sweep.axes.empty()))
        refuse_entry("Limit cycle",
                     "Searches along axis",
                     "needs a branch, over an axis of 'Sweep' and without "
                     "'Campaign'");
      if (p.limit_cycle.searches == 1)
        refuse_entry("Limit cycle",
                     "Searches along axis",
                     "= 1: must be 0, or at least 2 for both ends of the axis");
      if (!p.limit_cycle.campaign)
        {
          check_branch(p.sweep.axes);
          check_forward_sliding(p);
        }
      else if (p.limit_cycle.frequency > 0.)
        refuse_entry("Limit cycle",
                     "Pair frequency",
                     "must be 0 with 'Campaign', which follows every growing "
                     "pair");
    }
  } // namespace prm
} // namespace squeal
