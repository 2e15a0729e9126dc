// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/base/unknown_choice.h>

#include <squeal/parameters/checks.h>
#include <squeal/parameters/choices.h>
#include <squeal/parameters/glued_bodies.h>
#include <squeal/parameters/numbers.h>
#include <squeal/parameters/text.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace squeal
{
  namespace prm
  {
    namespace
    {
      using Refinement = DiscretizationParameters::Refinement;

      void
      check_refinement(const DiscretizationParameters &d)
      {
        if (d.refinement == Refinement::none && d.refinements > 0)
          refuse_entry("Discretization",
                       "Refinements",
                       "= " + std::to_string(d.refinements) +
                         " would be ignored: set 'Discretization/Refinement' "
                         "to 'uniform', 'eigenvalue error' or 'contact "
                         "error', or remove it");
      }



      /** Analyses that solve on the mesh as it is. */
      void
      check_eigenvalue_error(const Parameters &parameters)
      {
        using Analysis     = Parameters::Analysis;
        const bool is_kept = parameters.analysis == Analysis::sweep ||
                             (parameters.analysis == Analysis::work_precision &&
                              parameters.work_precision.problem !=
                                WorkPrecisionParameters::Problem::eigenvalues);
        if (is_kept && parameters.discretization.refinement ==
                         Refinement::eigenvalue_error)
          refuse_entry("Discretization",
                       "Refinement",
                       "= eigenvalue error would be ignored by 'Analysis = " +
                         choice_name(parameters.analysis) +
                         "', which stays on one mesh: set none or uniform");
      }



      void
      check_contact_error(const Parameters &parameters)
      {
        const auto &d = parameters.discretization;
        if (d.refinement != Refinement::contact_error)
          return;
        if (parameters.analysis != Parameters::Analysis::cea)
          refuse_entry("Discretization",
                       "Refinement",
                       "= contact error is for 'Analysis = cea'; other "
                       "analyses take the mesh that it ends with: set "
                       "'uniform' or 'eigenvalue error'");
        if (parameters.scene.contacts.empty())
          refuse_entry("Discretization",
                       "Refinement",
                       "= contact error needs a contact; set 'eigenvalue "
                       "error'");
        for (const BodyParameters &body : parameters.scene.bodies)
          if (body.rotation_speed != 0.)
            refuse_entry(
              "Discretization",
              "Refinement",
              "= contact error knows no gyroscopic terms, but body " +
                in_quotes(body.name) + " has a 'Rotation speed'");
        if (parameters.eigen.solver == EigenParameters::Solver::direct)
          refuse_entry("Eigenvalues",
                       "Solver",
                       "= direct has no left vectors, which 'Refinement = "
                       "contact error' needs; set 'certified'");
      }



      void
      check_band(const EigenParameters &e)
      {
        if (!(e.lowest_frequency < e.highest_frequency))
          refuse_entry("Eigenvalues",
                       "Lowest frequency",
                       "= " + format_number(e.lowest_frequency) +
                         " Hz must be below 'Highest frequency' = " +
                         format_number(e.highest_frequency) + " Hz");
      }



      /** Whether both axes of rotation are the same line. */
      bool
      turn_about_one_line(const BodyParameters &a, const BodyParameters &b)
      {
        return a.rotation_axis == b.rotation_axis &&
               have_centres_on_one_axis(a, b);
      }



      /** Refuses bodies that would stay behind or cannot be turned: what is
       * glued turns as one, and a layer with what it lies on. */
      void
      check_turned_as_one(const SceneParameters  &scene,
                          const AnglesParameters &a)
      {
        const auto body_of = [&](const std::string &name) -> const auto &
        {
          return require_body(scene, name, "Angles", "Turning bodies");
        };
        const auto turns = [&](const BodyParameters &body) {
          return std::count(a.bodies.begin(), a.bodies.end(), body.name) > 0;
        };
        for (const std::string &name : a.bodies)
          {
            if (body_of(name).shape == BodyParameters::Shape::layer)
              refuse_entry("Angles",
                           "Turning bodies",
                           "contains the layer " + in_quotes(name) +
                             ", which turns with the body that it lies on: "
                             "name that body alone");
            const std::set<std::string> glued = glued_to(scene, name);
            for (const BodyParameters &other : scene.bodies)
              if (const BodyParameters &body = turning_body(scene, other);
                  glued.count(other.name) > 0 && !turns(body))
                refuse_entry("Angles",
                             "Turning bodies",
                             "leaves out " + in_quotes(body.name) +
                               ", which a tie or a layer glues to " +
                               in_quotes(name) +
                               " and which would stand still: name it too");
            BodyParameters turned = body_of(name);
            turned.angle          = 1.;
            check_body(turned);
          }
      }



      void
      check_angles(const Parameters &parameters)
      {
        const AnglesParameters &a = parameters.angles;
        if (parameters.analysis != Parameters::Analysis::angles)
          return;
        if (parameters.scene.kind == SceneParameters::Kind::matrices)
          throw InputError("'Analysis = angles' turns meshes, which imported "
                           "matrices do not have");
        if (a.bodies.empty())
          refuse_entry(
            "Angles", "Turning bodies", "is empty: name the bodies that turn");
        const BodyParameters &first = require_body(
          parameters.scene, a.bodies[0], "Angles", "Turning bodies");
        for (const std::string &name : a.bodies)
          if (!turn_about_one_line(
                first,
                require_body(
                  parameters.scene, name, "Angles", "Turning bodies")))
            refuse_entry(
              "Angles",
              "Turning bodies",
              "turn about different lines: give " + in_quotes(name) +
                " the 'Rotation axis' and the 'Rotation centre' of " +
                in_quotes(a.bodies[0]) +
                " (without an entry the centre is the 'Position' of "
                "each body)");
        check_turned_as_one(parameters.scene, a);
        if (a.number > 1 && a.from == a.to)
          refuse_entry("Angles", "To", "is 'From': there is nothing to turn");
      }



      /** Refuses conditions that would make equal what the scene keeps apart:
       * one pressure for all loads, one speed for all contacts. */
      void
      check_one_for_all(const OperatingMatrixParameters &m,
                        const SceneParameters           &scene,
                        const std::string               &section)
      {
        std::set<double> pressures, speeds;
        for (const auto &load : scene.loads)
          if (load.pressure != 0.)
            pressures.insert(load.pressure);
        for (const auto &contact : scene.contacts)
          if (contact.sliding_speed > 0.)
            speeds.insert(contact.sliding_speed);
        for (const auto &load : scene.loads)
          if (!m.pressures.empty() && load.pressure < 0.)
            refuse_entry("Scene/Load " + load.name,
                         "Pressure",
                         "= " + format_number(load.pressure) +
                           " pulls, and 'Operating matrix/Pressures' would "
                           "make it push: it must not be negative there");
        const auto refuse = [&](const std::string      &entry,
                                const std::string      &of,
                                const std::set<double> &values) {
          refuse_entry(section,
                       entry,
                       "gives all " + of + " one value, but they have " +
                         format_number(*values.begin()) + " to " +
                         format_number(*values.rbegin()) +
                         " in the scene: make them equal there");
        };
        if (!m.pressures.empty() && pressures.size() > 1)
          refuse("Pressures", "loads", pressures);
        if (!m.speeds.empty() && speeds.size() > 1)
          refuse("Speeds", "contacts", speeds);
        for (const auto &body : scene.bodies)
          if (!m.speeds.empty() && body.rotation_speed != 0.)
            refuse_entry(section,
                         "Speeds",
                         "would leave the 'Rotation speed' of body " +
                           in_quotes(body.name) + " at " +
                           format_number(body.rotation_speed) +
                           " rad/s: remove one of them");
      }



      /** Whether friction in steady sliding depends on the 'Sliding speed': by
       * its law, or by the transverse term, which divides the friction by it.
       * The damping of a 'Friction slope' is the same at every speed. */
      bool
      depends_on_speed(const ContactParameters &c)
      {
        using Law = ContactParameters::FrictionLaw;
        const bool is_pressed =
          c.state == ContactParameters::State::preload || c.normal_force != 0.;
        return c.sliding_speed > 0. &&
               (c.friction_law == Law::table ||
                (c.friction_law == Law::exponential && c.decay_speed > 0.) ||
                (c.transverse_slip_term && is_pressed));
      }



      void
      check_operating_matrix(const Parameters &parameters)
      {
        const OperatingMatrixParameters &m       = parameters.operating_matrix;
        const SceneParameters           &scene   = parameters.scene;
        const std::string                section = "Operating matrix";
        if (parameters.analysis != Parameters::Analysis::operating_matrix)
          return;
        const auto any = [](const auto &list, const auto &is_it) {
          return std::any_of(list.begin(), list.end(), is_it);
        };
        const bool has_tables = any(
          scene.bodies, [](const auto &b) { return b.has_modulus_table(); });
        if (!m.pressures.empty() && !has_tables && !presses_contacts(scene))
          refuse_entry(section,
                       "Pressures",
                       "needs a load with a 'Pressure' and a contact with "
                       "'Contact state = preload', or a body whose 'Modulus "
                       "table file' has the column pressure_Pa: nothing else "
                       "knows of it");
        if (!m.temperatures.empty() && !has_tables)
          refuse_entry(section,
                       "Temperatures",
                       "needs a body with a 'Modulus table file': nothing "
                       "else knows of it");
        if (!m.speeds.empty() && !any(scene.contacts, &depends_on_speed))
          refuse_entry(section,
                       "Speeds",
                       "needs a contact with a 'Sliding speed' whose friction "
                       "depends on it, by its 'Friction law' or by the "
                       "'Transverse slip term' with a normal force: nothing "
                       "else knows of it");
        check_one_for_all(m, scene, section);
        if (m.both_directions &&
            (scene.contacts.empty() || any(scene.contacts, [](const auto &c) {
               return c.friction_coefficient == 0.;
             })))
          refuse_entry(section,
                       "Both directions",
                       "= true turns the sign of 'Friction coefficient', which "
                       "every contact needs then");
      }



      /** Whether an analysis writes its matrices; one of several runs has no
       * folder for each. */
      bool
      writes_matrices(const Parameters &parameters)
      {
        using Analysis = Parameters::Analysis;
        switch (parameters.analysis)
          {
          case Analysis::modes:
          case Analysis::cea:
          case Analysis::preload:
            return true;
          case Analysis::work_precision:
            return parameters.work_precision.problem ==
                   WorkPrecisionParameters::Problem::eigenvalues;
          case Analysis::transient:
            return parameters.sweep.axes.empty() &&
                   parameters.transient.tops.empty() &&
                   parameters.transient.integrators.empty();
          case Analysis::sweep:
          case Analysis::frequency_response:
          case Analysis::updating:
          case Analysis::angles:
          case Analysis::limit_cycle:
          case Analysis::operating_matrix:
          case Analysis::triggers:
            return false;
          }
        unknown_choice("analysis");
      }
      /** What a condition of a check is written as by mistake and would be
       * taken for a text that no row has. */
      void
      check_conditions(const std::string &section, const std::string &where)
      {
        const auto refuse = [&](const std::string &what) {
          refuse_entry(section, "Where", "= " + in_quotes(where) + ": " + what);
        };
        const std::string joint = " and ";
        for (std::size_t first = 0; first < where.size();)
          {
            const std::size_t last =
              std::min(where.find(joint, first), where.size());
            const std::string text = where.substr(first, last - first);
            first                  = last + joint.size();
            const std::size_t sign = text.find_first_of("=!<>");
            if (sign == std::string::npos)
              refuse("write it as 'column = value'");
            const bool is_long =
              text[sign] != '=' && text.compare(sign + 1, 1, "=") == 0;
            const std::string value =
              trim(text.substr(sign + (is_long ? 2 : 1)));
            if (!value.empty() &&
                std::string("=<>!").find(value[0]) != std::string::npos)
              refuse("the comparisons are =, !=, <, <=, > and >=");
            if (!value.empty() && (value[0] == '"' || value[0] == '\''))
              refuse("write the value without quotes");
            for (const char *other : {" AND ", " And ", " && "})
              if (value.find(other) != std::string::npos)
                refuse("write 'and' between conditions");
          }
      }
    } // namespace



    void
    check_result_check(const ResultCheckParameters &c)
    {
      const std::string section = "Result checks/Check " + c.name;
      if (c.table.empty())
        refuse_entry(section,
                     "Table",
                     "is empty: name a result table such as 'modes.csv'");
      if (c.column.empty())
        refuse_entry(section,
                     "Column",
                     "is empty: name a column of the table, or 'count'");
      check_conditions(section, c.where);
      const std::size_t equals = c.nearest.find('=');
      if (!c.nearest.empty() && (equals == std::string::npos || equals == 0 ||
                                 !parse_number(c.nearest.substr(equals + 1))))
        refuse_entry(section,
                     "Nearest",
                     "= " + in_quotes(c.nearest) +
                       ": write it as 'column = number'");
      if (c.relative_tolerance == 0. && c.absolute_tolerance == 0. &&
          c.column != "count")
        refuse_entry(section,
                     "Relative tolerance",
                     "and 'Absolute tolerance' are both 0: no computed "
                     "number is exact");
    }



    void
    check_export(const Parameters &parameters)
    {
      if (!parameters.output.export_matrices || writes_matrices(parameters))
        return;
      const bool is_campaign =
                   parameters.analysis == Parameters::Analysis::transient,
                 is_ladder =
                   parameters.analysis == Parameters::Analysis::work_precision;
      refuse_entry(
        "Output",
        "Export matrices",
        "= true would be ignored by 'Analysis = " +
          choice_name(parameters.analysis) + "'" +
          (is_campaign ? " over several runs" : "") +
          (is_ladder
             ? " of '" + choice_name(parameters.work_precision.problem) + "'"
             : "") +
          ": 'modes', 'cea', 'preload', 'work precision' of "
          "eigenvalues and a "
          "single 'transient' write them; take one of these, or "
          "remove it");
    }



    void
    check_analysis(const Parameters &parameters)
    {
      if (parameters.output.directory.empty())
        refuse_entry("", "Output directory", "is empty: name a folder");
      check_refinement(parameters.discretization);
      check_band(parameters.eigen);
      check_work_precision(parameters);
      check_angles(parameters);
      check_operating_matrix(parameters);
      check_modulus_tables(parameters);
      check_eigenvalue_error(parameters);
      check_contact_error(parameters);
      check_sweep(parameters);
      check_transient(parameters);
      check_response(parameters);
      check_export(parameters);
      for (const ResultCheckParameters &check : parameters.result_checks)
        check_result_check(check);
    }
  } // namespace prm



  bool
  presses_contacts(const SceneParameters &scene)
  {
    return std::any_of(scene.loads.begin(),
                       scene.loads.end(),
                       [](const auto &l) { return l.pressure != 0.; }) &&
           std::any_of(
             scene.contacts.begin(), scene.contacts.end(), [](const auto &c) {
               return c.state == ContactParameters::State::preload;
             });
  }



  void
  Parameters::check() const
  {
    try
      {
        prm::check_analysis(*this);
        prm::check_scene(scene);
      }
    catch (const InputError &e)
      {
        if (file.empty())
          throw;
        throw InputError(file + ": " + e.what());
      }
  }
} // namespace squeal
