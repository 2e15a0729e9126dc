// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/contact/friction_law.h>
#include <squeal/model/contact_states.h>
#include <squeal/model/pressed_model.h>
#include <squeal/parameters/entry_traits.h>
#include <squeal/parameters/number_access.h>
#include <squeal/parameters/text.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace squeal
{
  namespace
  {
    using State = ContactParameters::State;

    /** Points that differ in the size of the friction coefficient alone have
     * one flexibility of the contact. */
    std::map<std::vector<double>, std::vector<std::size_t>>
    points_by_flexibility(const SweepGrid &grid)
    {
      const std::vector<std::string> entries = grid.entries();
      std::map<std::vector<double>, std::vector<std::size_t>> result;
      for (std::size_t i = 0; i < grid.n_points(); ++i)
        {
          const SweepPoint    point = grid.point(i);
          std::vector<double> key;
          const auto          values = grid.values(point);
          for (std::size_t e = 0; e < entries.size(); ++e)
            if (!is_friction_entry(entries[e]))
              key.push_back(values[e]);
          for (const auto &contact : grid.scene(point).contacts)
            key.push_back(contact.friction_coefficient < 0.);
          result[key].push_back(i);
        }
      return result;
    }

    /** States of all pairs at all points, in the order of the grid. */
    std::vector<std::vector<ContactStates>>
    states_of_points(const Parameters &parameters,
                     const SweepGrid  &grid,
                     RunContext       &context)
    {
      const Model model(parameters, context.timers, {}, Model::Contacts::open);
      const auto  groups = points_by_flexibility(grid);
      std::vector<std::vector<ContactStates>> result(grid.n_points());
      Progress                                progress(
        context.log, "contact of steady sliding", groups.size());
      for (const auto &[key, points] : groups)
        {
          const Parameters   here = without_damping(with_values(
            parameters, grid.entries(), grid.values(grid.point(points[0]))));
          const PressedModel pressed =
            pressed_for_states(here, model, context.timers);
          for (const std::size_t i : points)
            {
              const SweepPoint point = grid.point(i);
              try
                {
                  result[i] = pressed.states_of(
                    pressed
                      .with_friction(friction_sizes(grid.scene(point).contacts))
                      .steady(parameters.preload.tolerance, context.timers)
                      .sliding);
                }
              catch (const ComputationError &error)
                {
                  throw ComputationError("at " + text_of(grid, point) + ": " +
                                         error.what());
                }
            }
          progress.advance();
        }
      return result;
    }

    /** The status of all nodes, pair after pair. */
    std::vector<ContactStatus>
    joined_status(const std::vector<ContactStates> &pairs)
    {
      std::vector<ContactStatus> result;
      for (const ContactStates &states : pairs)
        for (const ContactState &state : states)
          result.insert(result.end(), state.status.begin(), state.status.end());
      return result;
    }

    /** True where forces at the contact enter the matrices: by damping across
     * the sliding or by a friction coefficient that depends on the speed. */
    bool
    forces_matter(const SceneParameters &scene)
    {
      return std::any_of(scene.contacts.begin(),
                         scene.contacts.end(),
                         [](const ContactParameters &contact) {
                           return contact.state == State::preload &&
                                  has_slip_rate_terms(contact);
                         });
    }

    bool
    forces_matter(const SweepGrid &grid)
    {
      for (std::size_t i = 0; i < grid.n_points(); ++i)
        if (forces_matter(grid.scene(grid.point(i))))
          return true;
      return false;
    }

    /** True where all forces agree to 1e-9 of the largest of their pair. */
    bool
    same_forces(const std::vector<ContactStates> &a,
                const std::vector<ContactStates> &b)
    {
      for (std::size_t pair = 0; pair < a.size(); ++pair)
        for (std::size_t k = 0; k < a[pair].size(); ++k)
          {
            const Eigen::Map<const Eigen::VectorXd> f(
              a[pair][k].force_share.data(), a[pair][k].force_share.size()),
              g(b[pair][k].force_share.data(), b[pair][k].force_share.size());
            if (!((f - g).lpNorm<Eigen::Infinity>() <=
                  1e-9 * f.lpNorm<Eigen::Infinity>()))
              return false;
          }
      return true;
    }

    /** Points whose contact makes the same matrices, in the order of the
     * status: where forces enter them, equal status is not enough. */
    std::vector<std::vector<std::size_t>>
    points_of_one_contact(const std::vector<std::vector<ContactStates>> &all,
                          const bool forces_matter)
    {
      std::map<std::vector<ContactStatus>,
               std::vector<std::vector<std::size_t>>>
        of_status;
      for (std::size_t i = 0; i < all.size(); ++i)
        {
          auto &groups = of_status[joined_status(all[i])];
          auto  group =
            std::find_if(groups.begin(), groups.end(), [&](const auto &points) {
              return !forces_matter || same_forces(all[points[0]], all[i]);
            });
          if (group == groups.end())
            groups.push_back({i});
          else
            group->push_back(i);
        }
      std::vector<std::vector<std::size_t>> result;
      for (auto &[status, groups] : of_status)
        result.insert(result.end(), groups.begin(), groups.end());
      return result;
    }

    unsigned int
    n_closed(const std::vector<ContactStatus> &status)
    {
      return status.size() -
             std::count(status.begin(), status.end(), ContactStatus::open);
    }
  } // namespace



  std::vector<ContactStates>
  contact_states_of(const Parameters &parameters,
                    SweepGrid        &grid,
                    RunContext       &context)
  {
    const SceneParameters &scene = parameters.scene;
    if (!has_preload_state(scene))
      return {};
    const auto all = states_of_points(parameters, grid, context);
    // State k of every pair holds where the contact of all pairs is the k-th.
    std::vector<ContactStates> different(scene.contacts.size());
    std::vector<unsigned int>  state_of_point(all.size());
    unsigned int               fewest = -1u, most = 0, n_states = 0;
    std::size_t                n_nodes = 0;
    for (const auto &points : points_of_one_contact(all, forces_matter(grid)))
      {
        const auto status = joined_status(all[points[0]]);
        for (const std::size_t i : points)
          state_of_point[i] = n_states;
        const auto &middle = all[points[points.size() / 2]];
        for (std::size_t pair = 0; pair < different.size(); ++pair)
          if (scene.contacts[pair].state == State::preload)
            different[pair].insert(
              different[pair].end(), middle[pair].begin(), middle[pair].end());
        ++n_states;
        n_nodes = status.size();
        fewest  = std::min(fewest, n_closed(status));
        most    = std::max(most, n_closed(status));
      }
    context.log.info(
      "  contact of steady sliding: " + std::to_string(n_states) +
      " different states at " + std::to_string(all.size()) + " points, " +
      std::to_string(fewest) + " to " + std::to_string(most) + " of " +
      std::to_string(n_nodes) + " points closed");
    grid.set_states(state_of_point);
    return different;
  }



  std::vector<ContactStates>
  contact_of_number(const std::vector<ContactStates> &of_pairs,
                    const unsigned int                number)
  {
    std::vector<ContactStates> result;
    for (const ContactStates &states : of_pairs)
      result.push_back(states.empty() ? ContactStates()
                                      : ContactStates{states.at(number)});
    return result;
  }



  ChangedContact::ChangedContact(const Parameters &p, Timers &t)
    : parameters(p)
    , timers(t)
    , model(p, t, {}, Model::Contacts::open)
  {
  }

  bool
  ChangedContact::is_that(const SceneParameters            &scene,
                          const std::vector<ContactStates> &held) const
  {
    Parameters changed    = parameters;
    changed.scene         = scene;
    const Parameters here = without_damping(changed);
    try
      {
        const auto own =
          preload_states(pressed_for_states(here, model, timers), here, timers);
        return joined_status(own) == joined_status(held) &&
               (!forces_matter(scene) || same_forces(held, own));
      }
    catch (const ComputationError &)
      {
        // Nothing slides steadily with these numbers: a contact of its own.
        return false;
      }
  }
} // namespace squeal
