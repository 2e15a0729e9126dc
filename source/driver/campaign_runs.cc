// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/driver/campaign_runs.h>
#include <squeal/driver/entry_units.h>
#include <squeal/driver/transient_results.h>
#include <squeal/parameters/choices.h>

#include <algorithm>
#include <cmath>

namespace squeal
{
  namespace
  {
    std::vector<double>
    axis_values(const SweepAxisParameters &a)
    {
      if (a.scale == SweepAxisParameters::Scale::list)
        return a.values;
      std::vector<double> result;
      for (unsigned int i = 0; i < a.number; ++i)
        {
          const double s = a.number > 1 ? double(i) / (a.number - 1) : 0.;
          result.push_back(a.scale == SweepAxisParameters::Scale::logarithmic
                             ? a.from[0] * std::pow(a.to[0] / a.from[0], s)
                             : (1. - s) * a.from[0] + s * a.to[0]);
        }
      return result;
    }

    bool
    is_friction(const SweepAxisParameters &a)
    {
      for (const auto &entry : a.entries)
        if (entry.find("/Friction coefficient") == std::string::npos)
          return false;
      return true;
    }

    bool
    is_logarithm(const std::string &axis)
    {
      return axis.rfind("log10_", 0) == 0;
    }

    bool
    is_in_mpa(const std::string &axis)
    {
      return axis.size() > 4 && axis.substr(axis.size() - 4) == "_mpa";
    }

    /** What a table shows of a value: names tell. */
    double
    shown_value(const std::string &axis, const double value)
    {
      if (is_logarithm(axis))
        return std::log10(value);
      return is_in_mpa(axis) ? 1e-6 * value : value;
    }

    /** Combinations of the values of some axes. */
    std::vector<std::vector<double>>
    combinations(const std::vector<SweepAxisParameters> &axes,
                 const bool                              friction)
    {
      std::vector<std::vector<double>> all = {{}};
      for (const auto &axis : axes)
        if (is_friction(axis) == friction)
          {
            std::vector<std::vector<double>> next;
            for (const auto &head : all)
              for (const double value : axis_values(axis))
                {
                  next.push_back(head);
                  next.back().push_back(value);
                }
            all = next;
          }
      return all;
    }

    Parameters
    at_point(Parameters                              p,
             const std::vector<SweepAxisParameters> &axes,
             const std::vector<double>              &values,
             const bool                              friction)
    {
      std::size_t i = 0;
      for (const auto &axis : axes)
        if (is_friction(axis) == friction)
          {
            for (const auto &entry : axis.entries)
              p = with_value(p, entry, values[i]);
            ++i;
          }
      return p;
    }

    std::vector<double>
    shown_values(const std::vector<SweepAxisParameters> &axes,
                 const std::vector<double>              &others,
                 const std::vector<double>              &frictions)
    {
      std::vector<double> result;
      std::size_t         i = 0, k = 0;
      for (const auto &axis : axes)
        result.push_back(shown_value(
          axis.name, is_friction(axis) ? frictions[k++] : others[i++]));
      return result;
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
          }
      return result;
    }

    /** The run of one point, still without a key. */
    CampaignRun
    run_at(const Parameters                       &p,
           const std::vector<SweepAxisParameters> &axes,
           const std::vector<double>              &others,
           const std::vector<double>              &frictions,
           const std::string                      &top)
    {
      CampaignRun run{at_point(p, axes, frictions, true),
                      shown_values(axes, others, frictions),
                      top,
                      ""};
      auto       &scene       = run.parameters.scene;
      scene.contacts[0].state = ContactParameters::State::full;
      for (auto &support : scene.supports)
        if (!top.empty() && support.name == p.transient.top_support)
          for (const auto &[name, kind] : choices(SupportParameters::Kind()))
            if (name == top)
              support.kind = kind;
      // Node fields and frames are not kept in a campaign.
      run.parameters.transient.history_start       = 1e300;
      run.parameters.transient.animation_frames    = 0;
      run.parameters.discretization.estimate_error = false;
      return run;
    }



    /** Axes may be numbers that the key of the motion does not name. */
    std::string
    key_of(const CampaignRun &run, const std::vector<SweepAxisParameters> &axes)
    {
      std::string key = key_of_motion(run.parameters);
      for (std::size_t i = 0; i < axes.size(); ++i)
        key += axes[i].name + " " + shortest_text(run.shown[i]) + "\n";
      return key;
    }
  } // namespace



  std::string
  shown_unit(const SweepAxisParameters &axis, const SceneParameters &scene)
  {
    if (is_logarithm(axis.name))
      return "";
    return is_in_mpa(axis.name) ? "MPa" : unit_of_entry(axis.entries[0], scene);
  }



  std::vector<std::vector<CampaignRun>>
  campaign_groups(const Parameters &p)
  {
    if (p.scene.contacts[0].friction_coefficient < 0.)
      throw InputError("Scene/Contact/Friction coefficient: a campaign needs "
                       "one of at least 0");
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
                run.key = key_of(run, axes);
                groups.back().push_back(run);
              }
        }
    return groups;
  }
} // namespace squeal
