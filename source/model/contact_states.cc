// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/model/contact_states.h>
#include <squeal/model/pressed_model.h>
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

    /** Statics do not depend on it; modes below are taken out of them. */
    constexpr double cut_off_of_statics = 1000.; // Hz

    bool
    is_friction(const std::string &path)
    {
      const std::string entry = "/Friction coefficient";
      return path.size() > entry.size() &&
             path.compare(path.size() - entry.size(), entry.size(), entry) == 0;
    }

    std::string
    text_of(const SweepGrid &grid, const SweepPoint &point)
    {
      std::string text;
      for (unsigned int a = 0; a < grid.n_axes(); ++a)
        text += (a > 0 ? ", " : "") + grid.axis(a).name + " = " +
                rounded_text(grid.value(a, point[a]), 5);
      return text;
    }

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
            if (!is_friction(entries[e]))
              key.push_back(values[e]);
          key.push_back(grid.scene(point).contacts[0].friction_coefficient <
                        0.);
          result[key].push_back(i);
        }
      return result;
    }

    /** States of all points, in the order of the grid. */
    ContactStates
    states_of_points(const Parameters &parameters,
                     const SweepGrid  &grid,
                     RunContext       &context)
    {
      const Discretization discretization(parameters.scene,
                                          parameters.discretization,
                                          parameters.discretization.degree,
                                          MPI_COMM_WORLD);
      const auto           bodies = assemble_bodies(discretization);
      const auto           groups = points_by_flexibility(grid);
      ContactStates        result(grid.n_points());
      Progress             progress(
        context.log, "contact of steady sliding", groups.size());
      for (const auto &[key, points] : groups)
        {
          const Parameters here = with_values(
            parameters, grid.entries(), grid.values(grid.point(points[0])));
          PressedModel pressed(
            here, discretization, bodies, cut_off_of_statics, context.timers);
          for (const std::size_t i : points)
            {
              const SweepPoint point = grid.point(i);
              pressed.set_friction(
                std::abs(grid.scene(point).contacts[0].friction_coefficient));
              try
                {
                  result[i] = pressed.state_of(pressed.steady(
                    parameters.preload.tolerance, context.timers));
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

    unsigned int
    n_closed(const ContactState &state)
    {
      return state.status.size() - std::count(state.status.begin(),
                                              state.status.end(),
                                              ContactStatus::open);
    }
  } // namespace



  std::vector<ContactStates>
  contact_states_of(const Parameters &parameters,
                    SweepGrid        &grid,
                    RunContext       &context)
  {
    const auto &contacts = parameters.scene.contacts;
    if (parameters.scene.kind != SceneParameters::Kind::bodies ||
        contacts.empty() || contacts[0].state != State::preload)
      return {};
    const ContactStates all = states_of_points(parameters, grid, context);
    std::map<std::vector<ContactStatus>, std::vector<std::size_t>> members;
    for (std::size_t i = 0; i < all.size(); ++i)
      members[all[i].status].push_back(i);
    ContactStates             different;
    std::vector<unsigned int> state_of_point(all.size());
    unsigned int              fewest = all[0].status.size(), most = 0;
    for (const auto &[status, points] : members)
      {
        for (const std::size_t i : points)
          state_of_point[i] = different.size();
        different.push_back(all[points[points.size() / 2]]);
        fewest = std::min(fewest, n_closed(different.back()));
        most   = std::max(most, n_closed(different.back()));
      }
    context.log.info(
      "  contact of steady sliding: " + std::to_string(different.size()) +
      " different states at " + std::to_string(all.size()) + " points, " +
      std::to_string(fewest) + " to " + std::to_string(most) + " of " +
      std::to_string(all[0].status.size()) + " points closed");
    grid.set_states(state_of_point);
    return {different};
  }
} // namespace squeal
