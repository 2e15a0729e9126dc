// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/parameters/checks.h>
#include <squeal/parameters/entry_traits.h>
#include <squeal/parameters/text.h>

#include <algorithm>

namespace squeal
{
  namespace prm
  {
    void
    check_branch(const std::vector<SweepAxisParameters> &axes)
    {
      if (axes.empty())
        return;
      if (axes.size() > 1)
        refuse_entry("Sweep",
                     "Axes",
                     "has more than one: a branch of limit cycles is followed "
                     "over one axis");
      const SweepAxisParameters &axis    = axes.front();
      const std::string          section = "Sweep/Axis " + axis.name;
      for (const std::string &entry : axis.entries)
        if (is_resolution_entry(entry))
          refuse_entry(section,
                       "Entries",
                       "has " + in_quotes(entry) +
                         ": branches of limit cycles are followed over "
                         "numbers of bodies, contacts, supports and loads");
      if (axis.scale == SweepAxisParameters::Scale::list)
        refuse_entry(section,
                     "Scale",
                     "must be linear or logarithmic for branches of limit "
                     "cycles");
      for (std::size_t i = 0; i < axis.from.size(); ++i)
        if (!(axis.to[std::min(i, axis.to.size() - 1)] > axis.from[i]))
          refuse_entry(
            section, "From", "must be below 'To' for branches of limit cycles");
      for (std::size_t i = 0; i < axis.entries.size(); ++i)
        {
          const std::string &entry = axis.entries[i];
          const double from = axis.from[std::min(i, axis.from.size() - 1)];
          if ((is_friction_entry(entry) && !(from >= 0.)) ||
              (entry_of(entry) == "Sliding speed" && !(from > 0.)))
            refuse_entry(section,
                         "From",
                         "must be positive: along a branch the direction of "
                         "sliding is that of the scene");
        }
    }
  } // namespace prm
} // namespace squeal
