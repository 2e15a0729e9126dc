// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/analyses/sweep/sweep_axis_check.h>
#include <squeal/base/exceptions.h>
#include <squeal/base/unknown_choice.h>
#include <squeal/contact/contact_terms.h>
#include <squeal/parameters/text.h>

#include <algorithm>
#include <functional>
#include <sstream>

namespace squeal
{
  namespace
  {
    /** Whether the contact state of a point differs from that of its neighbour
     * along axis @p a anywhere on the grid. */
    bool
    changes_states(const SweepGrid &grid, const unsigned int a)
    {
      if (grid.n_states() < 2)
        return false;
      const std::vector<unsigned int> &state  = grid.states();
      const std::size_t                n      = grid.coordinates(a).size();
      std::size_t                      stride = 1;
      for (unsigned int b = 0; b < a; ++b)
        stride *= grid.coordinates(b).size();
      for (std::size_t i = 0; i + stride < state.size(); ++i)
        if (i / stride % n + 1 < n && state[i] != state[i + stride])
          return true;
      return false;
    }

    /** The points of the grid's lower ends, centre and upper ends: a factor of
     * what is looked at may be zero at one of them. */
    std::vector<SweepPoint>
    points_to_look_at(const SweepGrid &grid)
    {
      std::vector<SweepPoint> result;
      for (const double share : {0., .5, 1.})
        {
          SweepPoint point(grid.n_axes());
          for (unsigned int b = 0; b < grid.n_axes(); ++b)
            point[b] = grid.lower(b) + share * (grid.upper(b) - grid.lower(b));
          result.push_back(point);
        }
      return result;
    }

    bool
    acts(const SweepGrid    &grid,
         const AffineSystem &system,
         const unsigned int  a)
    {
      if (grid.coordinates(a).size() < 2 || changes_states(grid, a))
        return true;
      for (SweepPoint point : points_to_look_at(grid))
        {
          point[a]                    = grid.coordinates(a).front();
          const SceneParameters first = grid.scene(point);
          for (const double x : grid.coordinates(a))
            {
              point[a] = x;
              if (change_matrices(system, first, grid.scene(point)))
                return true;
            }
        }
      return false;
    }



    /** Whether a tenth more of entry @p e, counted through those of the axes
     * and those beside them, changes anything; one that is 0 has no tenth. */
    bool
    acts_by_itself(const SweepGrid    &grid,
                   const AffineSystem &system,
                   const unsigned int  e)
    {
      bool is_zero = true;
      for (const SweepPoint &point : points_to_look_at(grid))
        if (grid.entry_value(point, e) != 0.)
          {
            is_zero                      = false;
            const SceneParameters before = grid.scene(point);
            if (change_matrices(system, before, grid.scene(point, e, 1.1)))
              return true;
          }
      return is_zero;
    }

    /** Whether numbers may act by steady sliding alone, which decides what is
     * closed in the contact. */
    bool
    has_preload(const SceneParameters &scene)
    {
      return std::any_of(
        scene.contacts.begin(), scene.contacts.end(), [](const auto &contact) {
          return contact.state == ContactParameters::State::preload;
        });
    }

    bool
    ends_with(const std::string &text, const std::string &end)
    {
      return text.size() >= end.size() &&
             text.compare(text.size() - end.size(), end.size(), end) == 0;
    }

    /** Where damping of the scene comes from, for an entry of damping. */
    std::string
    reason_of_damping(const SceneParameters &scene, const std::string &entry)
    {
      using Model       = DampingParameters::Model;
      const bool is_own = entry.rfind("Scene/Damping/", 0) != 0;
      switch (scene.damping.model)
        {
        case Model::none:
          return "'Scene/Damping/Model = none' leaves all damping out";
        case Model::whole_model:
          if (is_own)
            return "'Scene/Damping/Model = whole model' takes damping from the "
                   "section Scene/Damping; 'per part' takes that of each part";
          break;
        case Model::per_part:
          if (!is_own)
            return "'Scene/Damping/Model = per part' takes the damping of each "
                   "part, not that of the section Scene/Damping";
          break;
        }
      return "nothing that it damps has stiffness or mass here";
    }

    /** Whether the pair that an entry belongs to sticks all over. */
    bool
    belongs_to_sticking_pair(const SceneParameters &scene,
                             const std::string     &entry)
    {
      return std::any_of(
        scene.contacts.begin(), scene.contacts.end(), [&](const auto &contact) {
          return contact.state != ContactParameters::State::preload &&
                 status_of_face(contact) == ContactStatus::stick &&
                 prm::section_of(entry) == "Scene/Contact " + contact.name;
        });
    }

    /** What is likely behind an entry that changes nothing. */
    std::string
    reason_of(const SceneParameters &scene, const std::string &entry)
    {
      if (ends_with(entry, " damping"))
        return reason_of_damping(scene, entry);
      if (ends_with(entry, "/Tangential stiffness"))
        return "it acts where nodes stick, and in steady sliding none does";
      if (ends_with(entry, "/Normal stiffness per area"))
        return "it belongs to springs of the layout 'quadrature'";
      if (ends_with(entry, "/Normal stiffness"))
        return "it belongs to springs of the layout 'grid'";
      if (belongs_to_sticking_pair(scene, entry))
        return "the pair sticks, by its 'Contact state' or at rest: it has no "
               "sliding friction; take the entry off the axis";
      if (ends_with(entry, "/Sliding speed"))
        return "friction does not depend on speed here: its law is constant "
               "and 'Transverse slip term' is off, or 'Normal force' or the "
               "friction coefficient is 0";
      if (ends_with(entry, "/Friction slope") ||
          ends_with(entry, "/Normal force"))
        return "a slope of friction and the transverse slip term, which goes "
               "with the friction coefficient, act by 'Normal force', and one "
               "factor is 0 or the term is off";
      if (ends_with(entry, "/Friction coefficient"))
        return "no node of the contact slides, or its friction comes by "
               "another entry";
      return "nothing of the scene depends on it as it stands";
    }

    bool
    have_same_statuses(const SweepGrid &a, const SweepGrid &b)
    {
      const SceneParameters mine   = a.scene(a.spread(1).back()),
                            others = b.scene(b.spread(1).back());
      for (std::size_t i = 0; i < mine.contacts.size(); ++i)
        if (status_of_face(mine.contacts[i]) !=
            status_of_face(others.contacts[i]))
          return false;
      return true;
    }

    /** Whether @p test holds with the numbers of any scene of the sweep, the
     * one of @p grid first: a factor that is 0 in one of them (the friction
     * coefficient) need not be 0 in all. Where faces that slide here stick
     * there, the terms of this scene tell nothing of that one. */
    bool
    holds_in_any(const SweepGrid                              &grid,
                 const std::vector<SweepScene>                &scenes,
                 const std::function<bool(const SweepGrid &)> &test)
    {
      return test(grid) ||
             std::any_of(
               scenes.begin(), scenes.end(), [&](const SweepScene &scene) {
                 const SweepGrid other(scene.parameters);
                 return !have_same_statuses(grid, other) || test(other);
               });
    }

    /** Refuses an entry that moves along with others, which do act. */
    void
    check_entries_of_axis(const SweepGrid               &grid,
                          const AffineSystem            &system,
                          const std::vector<SweepScene> &scenes,
                          const unsigned int             a,
                          const unsigned int             first)
    {
      const SweepAxisParameters &axis = grid.axis(a);
      for (std::size_t i = 0; i < axis.entries.size(); ++i)
        if (!holds_in_any(grid, scenes, [&](const SweepGrid &g) {
              return acts_by_itself(g, system, first + i);
            }))
          throw InputError(
            "Sweep/Axis " + axis.name + ": '" + axis.entries[i] +
            "' moves along with other entries, but neither mass nor damping "
            "nor stiffness changes with it: " +
            reason_of(grid.scene(grid.spread(1).back()), axis.entries[i]));
    }
  } // namespace



  void
  check_axes_of_sweep(const SweepGrid               &grid,
                      const AffineSystem            &system,
                      const std::vector<SweepScene> &scenes)
  {
    const SceneParameters scene = grid.scene(grid.spread(1).back());
    unsigned int          first = 0; // entry of the axis, of all
    for (unsigned int a = 0; a < grid.n_axes(); ++a)
      {
        const SweepAxisParameters &axis = grid.axis(a);
        if (holds_in_any(grid, scenes, [&](const SweepGrid &g) {
              return acts(g, system, a);
            }))
          {
            if (axis.entries.size() > 1 && grid.coordinates(a).size() > 1 &&
                !has_preload(scene))
              check_entries_of_axis(grid, system, scenes, a, first);
            first += axis.entries.size();
            continue;
          }
        std::ostringstream text;
        text << "Sweep/Axis " << axis.name
             << ": neither mass nor damping nor stiffness changes from "
             << grid.value(a, grid.lower(a)) << " to "
             << grid.value(a, grid.upper(a));
        for (const std::string &entry : axis.entries)
          text << "; '" << entry << "': " << reason_of(scene, entry);
        throw InputError(text.str());
      }
    for (unsigned int e = 0; e < grid.other_entries().size(); ++e)
      if (!holds_in_any(grid, scenes, [&](const SweepGrid &g) {
            return acts_by_itself(g, system, first + e);
          }))
        throw InputError(
          "Sweep: '" + grid.other_entries()[e] +
          "' is to be varied beside the axes, but neither mass nor damping nor "
          "stiffness changes with it: " +
          reason_of(scene, grid.other_entries()[e]));
  }
} // namespace squeal
