// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/base/number_text.h>
#include <squeal/base/unknown_choice.h>
#include <squeal/parameters/choices.h>
#include <squeal/parameters/entry_traits.h>
#include <squeal/parameters/number_access.h>
#include <squeal/run/campaign_runs.h>
#include <squeal/sweep/sweep_grid.h>

#include <algorithm>
#include <cmath>

namespace squeal
{
  namespace
  {
    /** The values of all entries of an axis at one of its points. */
    using EntryValues = std::vector<double>;

    /** Those of all its points. */
    std::vector<EntryValues>
    axis_points(const SweepAxisParameters &a)
    {
      std::vector<EntryValues> result;
      if (a.scale == SweepAxisParameters::Scale::list)
        {
          for (const double value : a.values)
            {
              result.emplace_back(a.entries.size(), value);
              if (!a.entry_values.empty())
                for (std::size_t i = 0; i < a.entries.size(); ++i)
                  result.back()[i] = listed_value(a, i, value);
            }
          return result;
        }
      for (unsigned int i = 0; i < a.number; ++i)
        {
          const double s = a.number > 1 ? double(i) / (a.number - 1) : 0.;
          result.emplace_back();
          for (std::size_t entry = 0; entry < a.entries.size(); ++entry)
            result.back().push_back(entry_value(a, entry, s));
        }
      return result;
    }

    bool
    is_friction(const SweepAxisParameters &a)
    {
      return std::all_of(
        a.entries.begin(), a.entries.end(), &is_friction_entry);
    }

    double
    shown_value(const SweepAxisParameters::ShownAs shown_as, const double value)
    {
      using ShownAs = SweepAxisParameters::ShownAs;
      switch (shown_as)
        {
        case ShownAs::value:
          return value;
        case ShownAs::common_logarithm:
          return std::log10(value);
        case ShownAs::milli:
          return 1e3 * value;
        case ShownAs::kilo:
          return 1e-3 * value;
        case ShownAs::mega:
          return 1e-6 * value;
        case ShownAs::giga:
          return 1e-9 * value;
        }
      unknown_choice("way of showing");
    }

    /** Combinations of the points of some axes. */
    std::vector<std::vector<EntryValues>>
    combinations(const std::vector<SweepAxisParameters> &axes,
                 const bool                              friction)
    {
      std::vector<std::vector<EntryValues>> all = {{}};
      for (const auto &axis : axes)
        if (is_friction(axis) == friction)
          {
            std::vector<std::vector<EntryValues>> next;
            for (const auto &head : all)
              for (const EntryValues &values : axis_points(axis))
                {
                  next.push_back(head);
                  next.back().push_back(values);
                }
            all = next;
          }
      return all;
    }

    Parameters
    at_point(const Parameters                       &p,
             const std::vector<SweepAxisParameters> &axes,
             const std::vector<EntryValues>         &points,
             const bool                              friction)
    {
      std::vector<std::string> entries;
      std::vector<double>      values;
      std::size_t              i = 0;
      for (const auto &axis : axes)
        if (is_friction(axis) == friction)
          {
            entries.insert(
              entries.end(), axis.entries.begin(), axis.entries.end());
            values.insert(values.end(), points[i].begin(), points[i].end());
            ++i;
          }
      return entries.empty() ? p : with_values(p, entries, values);
    }

    /** Of each axis the values of its entries, in the order of the axes. */
    std::vector<EntryValues>
    in_order(const std::vector<SweepAxisParameters> &axes,
             const std::vector<EntryValues>         &others,
             const std::vector<EntryValues>         &frictions)
    {
      std::vector<EntryValues> result;
      std::size_t              i = 0, k = 0;
      for (const auto &axis : axes)
        result.push_back(is_friction(axis) ? frictions[k++] : others[i++]);
      return result;
    }

    /** What tables show of an axis: its first entry. */
    std::vector<double>
    shown_values(const std::vector<SweepAxisParameters> &axes,
                 const std::vector<EntryValues>         &points)
    {
      std::vector<double> result;
      for (std::size_t i = 0; i < axes.size(); ++i)
        result.push_back(shown_value(axes[i].shown_as, points[i][0]));
      return result;
    }

    /** Enters what a run sets by itself among its entries, as if the parameter
     * file said so. */
    void
    set_used(Parameters &p, const std::string &path, const std::string &value)
    {
      for (auto &[name, text] : p.used)
        if (name == path)
          text = value;
    }

    /** The same run by each integrator asked for. */
    std::vector<CampaignRun>
    by_integrators(const CampaignRun &run)
    {
      const auto &asked = run.parameters.transient.integrators;
      if (asked.empty())
        return {run};
      std::vector<CampaignRun> result;
      for (const auto &[name, integrator] :
           choices(TransientParameters::Integrator()))
        if (std::find(asked.begin(), asked.end(), name) != asked.end())
          {
            result.push_back(run);
            result.back().parameters.transient.integrator = integrator;
            set_used(result.back().parameters, "Transient/Integrator", name);
          }
      return result;
    }

    /** The run of one point, still without a key. */
    CampaignRun
    run_at(const Parameters                       &p,
           const std::vector<SweepAxisParameters> &axes,
           const std::vector<EntryValues>         &others,
           const std::vector<EntryValues>         &frictions,
           const std::string                      &top)
    {
      CampaignRun run{at_point(p, axes, frictions, true),
                      shown_values(axes, in_order(axes, others, frictions)),
                      top,
                      {}};
      auto       &scene = run.parameters.scene;
      for (auto &contact : scene.contacts)
        contact.state = ContactParameters::State::full;
      for (auto &support : scene.supports)
        if (!top.empty() && support.name == p.transient.top_support)
          for (const auto &[name, kind] : choices(SupportParameters::Kind()))
            if (name == top)
              {
                support.kind = kind;
                set_used(run.parameters,
                         "Scene/Support " + support.name + "/Kind",
                         name);
              }
      // Node fields and frames are not kept in a campaign.
      run.parameters.transient.history_start       = 1e300;
      run.parameters.transient.animation_frames    = 0;
      run.parameters.discretization.estimate_error = false;
      set_used(run.parameters, "Transient/History start", "never");
      set_used(run.parameters, "Transient/Animation frames", "0");
      set_used(run.parameters, "Discretization/Estimate error", "false");
      return run;
    }



    /** The row of a run shows the values of the axes, under their names. */
    Fingerprint
    fingerprint_of(const CampaignRun                      &run,
                   const std::vector<SweepAxisParameters> &axes)
    {
      Fingerprint fingerprint(run.parameters, Fingerprint::Purpose::motion);
      for (std::size_t i = 0; i < axes.size(); ++i)
        fingerprint.add("axis " + axes[i].name, shortest_text(run.shown[i]));
      fingerprint.add("top", run.top);
      return fingerprint;
    }
  } // namespace



  std::string
  shown_unit(const SweepAxisParameters &axis, const SceneParameters &scene)
  {
    using ShownAs          = SweepAxisParameters::ShownAs;
    const std::string unit = unit_of_entry(axis.entries[0], scene);
    switch (axis.shown_as)
      {
      case ShownAs::value:
        return unit;
      case ShownAs::common_logarithm:
        return "";
      case ShownAs::milli:
        return "m" + unit;
      case ShownAs::kilo:
        return "k" + unit;
      case ShownAs::mega:
        return "M" + unit;
      case ShownAs::giga:
        return "G" + unit;
      }
    unknown_choice("way of showing");
  }



  std::string
  shown_title(const SweepAxisParameters &axis, const SceneParameters &scene)
  {
    if (axis.shown_as == SweepAxisParameters::ShownAs::common_logarithm)
      return "log10 of " + axis_title(axis.entries, scene);
    const std::string unit = shown_unit(axis, scene);
    return symbol_of_entries(axis.entries, scene) +
           (unit.empty() ? "" : " in " + unit);
  }



  namespace
  {
    /** A group shares the directions of sliding, which a sign turns. */
    void
    check_signs_of_friction(const std::vector<ContactParameters> &contacts)
    {
      for (const auto &contact : contacts)
        if (contact.friction_coefficient < 0.)
          throw InputError("Scene/Contact " + contact.name +
                           "/Friction coefficient: a campaign needs one of at "
                           "least 0, here and on the axes of 'Sweep'");
    }
  } // namespace

  std::vector<std::vector<CampaignRun>>
  campaign_groups(const Parameters &p)
  {
    const auto              &axes = p.sweep.axes;
    std::vector<std::string> tops = p.transient.tops;
    if (tops.empty())
      tops.push_back("");
    std::vector<std::vector<CampaignRun>> groups;
    for (const std::string &top : tops)
      for (const auto &others : combinations(axes, false))
        {
          const Parameters base = at_point(p, axes, others, false);
          groups.emplace_back();
          for (const auto &frictions : combinations(axes, true))
            for (CampaignRun &run :
                 by_integrators(run_at(base, axes, others, frictions, top)))
              {
                check_signs_of_friction(run.parameters.scene.contacts);
                run.fingerprint = fingerprint_of(run, axes);
                groups.back().push_back(run);
              }
        }
    return groups;
  }



  std::vector<CampaignRun>
  all_runs(const std::vector<std::vector<CampaignRun>> &groups)
  {
    std::vector<CampaignRun> runs;
    for (const auto &group : groups)
      runs.insert(runs.end(), group.begin(), group.end());
    return runs;
  }
} // namespace squeal
