// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>

#include <squeal/parameters/checks.h>
#include <squeal/parameters/numbers.h>
#include <squeal/parameters/text.h>

#include <algorithm>
#include <map>
#include <set>

namespace squeal
{
  namespace prm
  {
    namespace
    {
      using Analysis = Parameters::Analysis;

      void
      check_points(const Parameters &parameters)
      {
        const MeasurementParameters &m = parameters.measurement;
        if (m.points.empty() && m.shapes_file.empty())
          return;
        const bool has_bodies =
          parameters.scene.kind == SceneParameters::Kind::bodies;
        if (!has_bodies && parameters.scene.node_table_file.empty())
          refuse_entry("Measurement",
                       "Points",
                       "need 'Scene/Node table file': without it imported "
                       "matrices have no places");
        std::set<std::pair<unsigned int, Vector3>> seen;
        std::map<unsigned int, unsigned int>       first_at_node;
        for (unsigned int i = 0; i < m.points.size(); ++i)
          {
            const std::string section = "Measurement/Point " + m.points[i].name;
            if (has_bodies)
              require_body(parameters.scene, m.points[i].body, section, "Body");
            const auto &first =
              m.points[first_at_node.emplace(m.node(i), i).first->second];
            if (first.body != m.points[i].body ||
                first.position != m.points[i].position)
              refuse_entry(section,
                           "Node",
                           "= " + std::to_string(m.node(i)) +
                             " is also the number of point " +
                             in_quotes(first.name) +
                             ", which has another body or position: a number "
                             "stands for one place (0: the place in the list "
                             "of points)");
            if (!seen.insert({m.node(i), m.points[i].direction}).second)
              refuse_entry(section,
                           "Node",
                           "= " + std::to_string(m.node(i)) +
                             " has this direction already: a node has one "
                             "signal for each direction");
          }
      }



      void
      check_frequency_response(const Parameters &parameters)
      {
        if (parameters.analysis != Analysis::frequency_response)
          return;
        const MeasurementParameters       &m = parameters.measurement;
        const FrequencyResponseParameters &f = parameters.frequency_response;
        const std::string                  section = "Frequency response";
        if (m.points.empty())
          refuse_entry("Measurement",
                       "Points",
                       "is empty: name at least one point and add its section "
                       "'Point <name>'");
        for (const auto &[name, list] :
             {std::make_pair("Excitations", &f.excitations),
              std::make_pair("Responses", &f.responses)})
          for (const std::string &point : *list)
            if (m.find(point) < 0)
              refuse_entry(section,
                           name,
                           "contains " + in_quotes(point) +
                             ", which is not in 'Measurement/Points'");
        if (f.scale == FrequencyResponseParameters::Scale::logarithmic &&
            !(parameters.eigen.lowest_frequency > 0.))
          refuse_entry(section,
                       "Scale",
                       "= logarithmic needs 'Eigenvalues/Lowest frequency' "
                       "above 0");
        if (!f.states.empty() && parameters.scene.contacts.empty())
          refuse_entry(
            section, "Contact states", "need a contact: the scene has none");
      }



      void
      check_number(const Parameters              &parameters,
                   const UpdatedNumberParameters &n)
      {
        const std::string section = "Updating/Number " + n.name;
        if (n.entries.empty())
          refuse_entry(section,
                       "Entries",
                       "is empty: name a number of the scene, such as 'Scene/"
                       "Body pad/Young modulus'");
        for (const std::string &path : n.entries)
          {
            double value = 0.;
            try
              {
                value = get_number(parameters, path);
              }
            catch (const InputError &e)
              {
                refuse_entry(section, "Entries", std::string(": ") + e.what());
              }
            if (!starts_with(path, "Scene/"))
              refuse_entry(section,
                           "Entries",
                           "contains " + in_quotes(path) +
                             ": only numbers of the scene can be fitted");
            if (!(value > 0.))
              refuse_entry(section,
                           "Entries",
                           "contains " + in_quotes(path) + " = " +
                             format_number(value) +
                             ": the fit starts from values above 0");
          }
        const double start = get_number(parameters, n.entries[0]);
        if (!(n.lower > 0. && n.lower < n.upper))
          refuse_entry(
            section,
            "Lower",
            "= " + format_number(n.lower) +
              " must be above 0 and below 'Upper' = " + format_number(n.upper));
        if (start < n.lower || start > n.upper)
          refuse_entry(section,
                       "Lower",
                       "and 'Upper' leave out the value of the scene, " +
                         format_number(start) + ", where the fit starts");
      }



      void
      check_updating(const Parameters &parameters)
      {
        if (parameters.analysis != Analysis::updating)
          return;
        const UpdatingParameters &u = parameters.updating;
        if (u.numbers.empty())
          refuse_entry("Updating",
                       "Numbers",
                       "is empty: name at least one number and add its "
                       "section 'Number <name>'");
        for (const ContactParameters &contact : parameters.scene.contacts)
          if (contact.state == ContactParameters::State::preload)
            refuse_entry("Scene/Contact " + contact.name,
                         "Contact state",
                         "= preload: an updating keeps the contact of its "
                         "start, which numbers that are fitted would change; "
                         "take 'full' or 'stick'");
        std::set<std::string> seen;
        for (const UpdatedNumberParameters &n : u.numbers)
          {
            check_number(parameters, n);
            for (const std::string &path : n.entries)
              if (!seen.insert(path).second)
                refuse_entry("Updating/Number " + n.name,
                             "Entries",
                             "contains " + in_quotes(path) +
                               ", which is fitted already");
          }
        const MeasurementParameters &m = parameters.measurement;
        require_file(
          m.frequencies_file, "Measurement", "Frequencies file", true);
        if (u.pairing == UpdatingParameters::Pairing::shape &&
            (m.shapes_file.empty() || m.points.empty()))
          refuse_entry("Updating",
                       "Pairing",
                       "= shape needs 'Measurement/Shapes file' and "
                       "'Measurement/Points'");
      }
    } // namespace



    void
    check_response(const Parameters &parameters)
    {
      check_points(parameters);
      check_frequency_response(parameters);
      check_updating(parameters);
      require_file(parameters.measurement.shapes_file,
                   "Measurement",
                   "Shapes file",
                   false);
    }
  } // namespace prm
} // namespace squeal
