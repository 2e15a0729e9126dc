// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>

#include <squeal/parameters/checks.h>
#include <squeal/parameters/declarations.h>
#include <squeal/parameters/entry_traits.h>
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
      using Scale = SweepAxisParameters::Scale;

      /** Whole runs at the points of the axes instead of a sweep of one model.
       */
      bool
      is_campaign_of_runs(const Parameters &p)
      {
        return p.analysis == Parameters::Analysis::transient ||
                   p.analysis == Parameters::Analysis::triggers
                 ? !p.sweep.axes.empty()
                 : p.analysis == Parameters::Analysis::limit_cycle &&
                     p.limit_cycle.campaign;
      }

      /** How finely the runs of a campaign are computed. Limit cycles have
       * steps and a tolerance of their own. */
      bool
      is_resolution_of(const Parameters &p, const std::string &path)
      {
        return is_campaign_of_runs(p) && is_resolution_entry(path) &&
               (p.analysis == Parameters::Analysis::transient ||
                (path != "Transient/Time step" &&
                 path != "Transient/Tolerance"));
      }

      /** The entry must be there and be one number. */
      void
      require_number(const Parameters  &parameters,
                     const std::string &section,
                     const std::string &name,
                     const std::string &path)
      {
        try
          {
            get_number(parameters, path);
          }
        catch (const InputError &e)
          {
            refuse_entry(section, name, std::string(": ") + e.what());
          }
        if (starts_with(path, "Scene/"))
          return;
        if (is_resolution_of(parameters, path))
          return;
        const std::string of_runs =
          !is_campaign_of_runs(parameters) ? ""
          : parameters.analysis == Parameters::Analysis::transient
            ? ", and how finely a transient is "
              "computed: "
              "'Discretization/Degree', "
              "'Refinements', 'Transient/Time "
              "step', 'Cut-off', 'Interface "
              "cut-off', 'Tolerance'"
            : ", and how finely limit cycles "
              "are computed: "
              "'Discretization/Degree', "
              "'Refinements', "
              "'Transient/Cut-off', 'Interface "
              "cut-off'";
        refuse_entry(section,
                     name,
                     "contains " + in_quotes(path) +
                       ": only numbers of the scene can be swept" + of_runs);
      }

      void
      require_allowed(const GenericSchema &schema,
                      const std::string   &section,
                      const std::string   &name,
                      const std::string   &path,
                      const double         value)
      {
        const std::string    plain = path.substr(0, path.rfind('['));
        const Schema::Entry *entry = schema->find(generic_path(plain));
        if (entry != nullptr && !entry->allowed.is_list() &&
            !entry->allowed.matches(format_number(value)))
          refuse_entry(section,
                       name,
                       "= " + format_number(value) + ": " + in_quotes(plain) +
                         " must be " + entry->allowed.words());
      }

      void
      check_range(const SweepAxisParameters &a, const std::string &section)
      {
        const std::size_t n = a.entries.size();
        for (const auto &[name, values] :
             {std::make_pair("From", &a.from), std::make_pair("To", &a.to)})
          if (values->size() != 1 && values->size() != n)
            refuse_entry(section,
                         name,
                         "has " + std::to_string(values->size()) +
                           " numbers: give one for all entries, or one for "
                           "each of the " +
                           std::to_string(n));
        for (std::size_t i = 0; i < n; ++i)
          {
            const double from = a.from[a.from.size() == 1 ? 0 : i];
            const double to   = a.to[a.to.size() == 1 ? 0 : i];
            if (a.scale == Scale::logarithmic && !(from > 0. && to > 0.))
              refuse_entry(
                section, "Scale", "= logarithmic needs From and To above 0");
            if (a.number > 1 && from == to)
              refuse_entry(section,
                           "To",
                           "= " + format_number(to) +
                             " is From: there is nothing to sweep");
          }
      }

      /** Refuses values that have no logarithm. */
      void
      require_positive(const SweepAxisParameters &a)
      {
        const bool is_list = a.scale == Scale::list;
        for (const auto *values :
             {is_list ? &a.values : &a.from, is_list ? &a.values : &a.to})
          for (const double value : *values)
            if (!(value > 0.))
              refuse_entry("Sweep/Axis " + a.name,
                           "Shown as",
                           "= common logarithm needs values above 0");
      }



      /** The sense of sliding is looked at in the scene as it stands: where a
       * body turns, an axis must not reverse what belongs to it, and a body
       * that stands still there has no matrices of its turning. */
      void
      require_same_sense(const Parameters          &p,
                         const SweepAxisParameters &a,
                         const std::string         &section)
      {
        const auto turns = [](const BodyParameters &body) {
          return body.rotation_speed != 0.;
        };
        const bool something_turns =
          std::any_of(p.scene.bodies.begin(), p.scene.bodies.end(), turns);
        const auto turns_body = [](const std::string &path) {
          return generic_path(path) == "Scene/Body <name>/Rotation speed";
        };
        std::vector<double> values =
          a.entry_values.empty() ? a.values : a.entry_values;
        if (a.scale != Scale::list)
          {
            values = a.from;
            values.insert(values.end(), a.to.begin(), a.to.end());
          }
        for (const auto &path : a.entries)
          if (turns_body(path) || (something_turns && is_friction_entry(path)))
            for (const double value : values)
              if (value * get_number(p, path) < 0. ||
                  (value != 0. && get_number(p, path) == 0.))
                refuse_entry(section,
                             "Entries",
                             "contains " + in_quotes(path) + ", which is " +
                               format_number(get_number(p, path)) +
                               " in the scene and " + format_number(value) +
                               " in the sweep: where a body turns it must "
                               "have one sign in both");
      }



      /** The values of entry @p i of an axis: both ends of a range. */
      std::vector<double>
      values_of_entry(const SweepAxisParameters &a, const std::size_t i)
      {
        const auto of = [i](const std::vector<double> &all) {
          return all[all.size() == 1 ? 0 : i];
        };
        if (a.scale != Scale::list)
          return {of(a.from), of(a.to)};
        if (a.entry_values.empty())
          return a.values;
        const auto first = a.entry_values.begin() + i * a.values.size();
        return {first, first + a.values.size()};
      }

      /** Terms of the slip rate go by the 'Sliding speed', which the scene has
       * as its bodies turn: an axis that moves one of the two entries moves
       * the other by the same factor. */
      void
      require_one_speed(const Parameters          &p,
                        const SweepAxisParameters &a,
                        const std::string         &section,
                        const std::string         &sliding,
                        const std::string         &turning)
      {
        const auto at = [&](const std::string &path) {
          return std::find(a.entries.begin(), a.entries.end(), path) -
                 a.entries.begin();
        };
        const std::size_t i = at(sliding), k = at(turning),
                          n = a.entries.size();
        if (i == n && k == n)
          return;
        if (i == n || k == n)
          refuse_entry(section,
                       "Entries",
                       "contains " + in_quotes(i == n ? turning : sliding) +
                         " without " + in_quotes(i == n ? sliding : turning) +
                         ": the pair has terms of the slip rate, and both are "
                         "of one motion: put them on one axis");
        const auto speeds = values_of_entry(a, i),
                   turns  = values_of_entry(a, k);
        for (std::size_t j = 0; j < speeds.size(); ++j)
          {
            const double by = speeds[j] / get_number(p, sliding),
                         to = turns[j] / get_number(p, turning);
            if (!(std::abs(by - to) <= 0.1 * std::abs(to)))
              refuse_entry(section,
                           "Entries",
                           ": " + in_quotes(sliding) + " = " +
                             format_number(speeds[j]) + " and " +
                             in_quotes(turning) + " = " +
                             format_number(turns[j]) +
                             " are not in the ratio that they have in the "
                             "scene, but both are of one motion");
          }
      }

      /** The same for all pairs with such terms whose bodies turn: pairs that
       * slide. A pair gets none by the sweep: its speed is looked at in the
       * scene as it stands. */
      void
      require_sliding_with_turning(const Parameters          &p,
                                   const SweepAxisParameters &a,
                                   const std::string         &section)
      {
        for (const ContactParameters &c : p.scene.contacts)
          for (const BodyParameters &body : p.scene.bodies)
            {
              const BodyParameters &carrier = turning_body(p.scene, body);
              const std::string     contact = "Scene/Contact " + c.name;
              const std::string     slope   = contact + "/Friction slope";
              if (c.state == ContactParameters::State::stick ||
                  (body.name != c.source_body && body.name != c.target_body) ||
                  carrier.rotation_speed == 0.)
                continue;
              if (c.transverse_slip_term || c.friction_slope != 0. ||
                  c.friction_law != ContactParameters::FrictionLaw::constant)
                require_one_speed(p,
                                  a,
                                  section,
                                  contact + "/Sliding speed",
                                  "Scene/Body " + carrier.name +
                                    "/Rotation speed");
              else if (std::count(a.entries.begin(), a.entries.end(), slope))
                refuse_entry(section,
                             "Entries",
                             "contains " + in_quotes(slope) +
                               ", which is 0 in the scene: where a body "
                               "turns it must not be 0 there, so that "
                               "'Sliding speed' is compared with the turning");
            }
      }



      /** Loads press pairs whose contact is that of steady sliding. */
      void
      require_effect_of_normal_force(const Parameters  &p,
                                     const std::string &section,
                                     const std::string &name,
                                     const std::string &path)
      {
        const bool is_pressed =
          p.analysis == Parameters::Analysis::limit_cycle ||
          p.analysis == Parameters::Analysis::triggers;
        for (const ContactParameters &c : p.scene.contacts)
          if ((c.state == ContactParameters::State::preload || is_pressed) &&
              path == "Scene/Contact " + c.name + "/Normal force")
            refuse_entry(section,
                         name,
                         "contains " + in_quotes(path) +
                           ", which has no effect: " +
                           (is_pressed ? "in this analysis"
                                       : "with 'Contact state = preload'") +
                           " the loads of the scene press the pair");
      }



      /** A number for each entry at each value, of lists only. */
      void
      check_entry_values(const SweepAxisParameters &a,
                         const std::string         &section)
      {
        if (a.entry_values.empty())
          return;
        if (a.scale != Scale::list)
          refuse_entry(
            section, "Entry values", "are for 'Scale = list'; leave it empty");
        const std::size_t n = a.entries.size() * a.values.size();
        if (a.entry_values.size() != n)
          refuse_entry(
            section,
            "Entry values",
            "has " + std::to_string(a.entry_values.size()) + " numbers: give " +
              std::to_string(n) + ", one for each of the " +
              std::to_string(a.entries.size()) + " entries at each of the " +
              std::to_string(a.values.size()) + " values");
      }



      void
      check_suggestions(const Parameters &parameters)
      {
        if (parameters.sweep.suggestions == 0)
          return;
        if (parameters.sweep.sensitivities.empty())
          refuse_entry("Sweep",
                       "Suggestions",
                       "needs the numbers that may be changed: list them in "
                       "Sensitivities");
        for (const ContactParameters &c : parameters.scene.contacts)
          if (parameters.analysis == Parameters::Analysis::sweep &&
              c.state == ContactParameters::State::preload)
            refuse_entry("Sweep",
                         "Suggestions",
                         "do not follow contact points that a change opens or "
                         "closes, as in pair " +
                           in_quotes(c.name) +
                           " with 'Contact state = preload': set it to 0 and "
                           "make the number to be changed an axis, each point "
                           "of which has its own contact state");
      }



      void
      check_axis(const Parameters          &parameters,
                 const GenericSchema       &schema,
                 const SweepAxisParameters &a)
      {
        const std::string section = "Sweep/Axis " + a.name;
        if (a.entries.empty())
          refuse_entry(section,
                       "Entries",
                       "is empty: name a number of the scene, such as 'Scene/"
                       "Body pad/Young modulus'");
        for (const auto &path : a.entries)
          {
            require_number(parameters, section, "Entries", path);
            require_effect_of_normal_force(
              parameters, section, "Entries", path);
          }
        require_same_sense(parameters, a, section);
        if (a.scale == Scale::list)
          {
            if (a.values.empty())
              refuse_entry(section,
                           "Values",
                           "is empty: the scale 'list' needs its values");
            for (std::size_t i = 1; i < a.values.size(); ++i)
              if (!(a.values[i - 1] < a.values[i]))
                refuse_entry(section,
                             "Values",
                             "must ascend, but " + format_number(a.values[i]) +
                               " follows " + format_number(a.values[i - 1]));
            check_entry_values(a, section);
            require_sliding_with_turning(parameters, a, section);
            const bool is_own = !a.entry_values.empty();
            for (std::size_t i = 0; i < a.entries.size(); ++i)
              for (std::size_t k = 0; k < a.values.size(); ++k)
                require_allowed(schema,
                                section,
                                is_own ? "Entry values" : "Values",
                                a.entries[i],
                                is_own ? a.entry_values[i * a.values.size() + k]
                                       : a.values[k]);
            return;
          }
        check_entry_values(a, section);
        check_range(a, section);
        require_sliding_with_turning(parameters, a, section);
        for (std::size_t i = 0; i < a.entries.size(); ++i)
          {
            require_allowed(schema,
                            section,
                            "From",
                            a.entries[i],
                            a.from[a.from.size() == 1 ? 0 : i]);
            require_allowed(schema,
                            section,
                            "To",
                            a.entries[i],
                            a.to[a.to.size() == 1 ? 0 : i]);
          }
      }
    } // namespace



    void
    check_sweep(const Parameters &parameters)
    {
      require_saved_name(parameters.sweep.basis_file, "Sweep", "Basis file");
      const SweepParameters &s           = parameters.sweep;
      const bool             is_campaign = is_campaign_of_runs(parameters);
      const bool             is_branch =
        parameters.analysis == Parameters::Analysis::limit_cycle &&
        !is_campaign && !s.axes.empty();
      if (parameters.analysis != Parameters::Analysis::sweep && !is_campaign &&
          !is_branch)
        return;
      if (s.axes.empty())
        refuse_entry("Sweep",
                     "Axes",
                     "is empty: name at least one axis and add its section "
                     "'Axis <name>'");
      if (s.boundary_tolerance > 0. && s.axes.size() != 2)
        refuse_entry(
          "Sweep", "Boundary tolerance", "needs exactly two axes; set it to 0");
      const GenericSchema      schema;
      std::vector<std::string> seen;
      double                   n_points = 1.;
      for (const auto &axis : s.axes)
        {
          check_axis(parameters, schema, axis);
          check_scatter(s, axis);
          if (!is_campaign &&
              axis.shown_as != SweepAxisParameters::ShownAs::value)
            refuse_entry("Sweep/Axis " + axis.name,
                         "Shown as",
                         "is for campaigns of runs; a sweep shows the "
                         "value itself");
          if (axis.shown_as == SweepAxisParameters::ShownAs::common_logarithm)
            require_positive(axis);
          n_points *=
            axis.scale == Scale::list ? axis.values.size() : axis.number;
          for (const auto &path : axis.entries)
            {
              if (std::find(seen.begin(), seen.end(), path) != seen.end())
                refuse_entry("Sweep/Axis " + axis.name,
                             "Entries",
                             "contains " + in_quotes(path) +
                               ", which is swept already");
              seen.push_back(path);
            }
        }
      if (n_points > 1e7)
        refuse_entry("Sweep",
                     "Axes",
                     "ask for " + format_number(n_points) +
                       " points: at most 1e7 are allowed");
      for (const auto &path : s.sensitivities)
        {
          require_number(parameters, "Sweep", "Sensitivities", path);
          require_effect_of_normal_force(
            parameters, "Sweep", "Sensitivities", path);
        }
      check_suggestions(parameters);
    }
  } // namespace prm
} // namespace squeal
