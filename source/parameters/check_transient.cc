// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/parameters/face_geometry.h>

#include <squeal/parameters/checks.h>
#include <squeal/parameters/choices.h>
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
      using Analysis = Parameters::Analysis;
      using Kind     = SupportParameters::Kind;
      using State    = ContactParameters::State;

      bool
      slides(const SceneParameters &scene)
      {
        return std::any_of(scene.contacts.begin(),
                           scene.contacts.end(),
                           [](const auto &c) { return c.sliding_speed > 0.; });
      }

      /** What steady sliding needs of a scene. */
      void
      check_pressed_scene(const Parameters &p)
      {
        const SceneParameters &scene = p.scene;
        if (scene.contacts.empty())
          refuse_entry("Scene",
                       "Contacts",
                       "is empty: steady sliding and transients need a pair");
        for (const ContactParameters &c : scene.contacts)
          {
            const std::string section = "Scene/Contact " + c.name;
            if (c.target_body == "ground")
              refuse_entry(section,
                           "Target body",
                           "= ground: steady sliding needs meshed bodies");
            if (scene.kind == SceneParameters::Kind::bodies)
              require_body(scene, c.target_body, section, "Target body");
            if (c.friction_slope != 0.)
              refuse_entry(section,
                           "Friction slope",
                           "must be 0: steady sliding and transients take the "
                           "coefficient over the slip rate from 'Friction "
                           "law'");
          }
        if (scene.loads.empty())
          refuse_entry("Scene",
                       "Loads",
                       "is empty: name the force that presses the bodies "
                       "together and add its section 'Load <name>'");
      }

      /** Wear needs sliding; without any, the speed does not matter. */
      void
      check_run_in(const Parameters &p)
      {
        if (p.preload.run_in != PreloadParameters::RunIn::archard ||
            !slides(p.scene))
          return;
        for (const ContactParameters &c : p.scene.contacts)
          if (c.sliding_speed == 0.)
            refuse_entry("Preload",
                         "Run-in",
                         "= archard: nothing wears in contact " +
                           in_quotes(c.name) +
                           ", whose 'Sliding speed' is 0; run-in is computed "
                           "for scenes whose pairs all slide");
      }

      void
      check_stiffness(const Parameters &p)
      {
        const PreloadParameters &l = p.preload;
        if (l.stiffness_entry.empty() != l.stiffness_values.empty())
          refuse_entry("Preload",
                       "Stiffness values",
                       "and 'Stiffness entry' belong together: give both or "
                       "none");
        if (l.stiffness_entry.empty())
          return;
        if (l.run_in == PreloadParameters::RunIn::archard)
          refuse_entry("Preload",
                       "Stiffness entry",
                       "has nothing to show with 'Run-in = archard': the depth "
                       "of what is worn is arbitrary, and so is an approach");
        if (!starts_with(l.stiffness_entry, "Scene/"))
          refuse_entry("Preload",
                       "Stiffness entry",
                       "= " + in_quotes(l.stiffness_entry) +
                         ": only numbers of the scene can be changed");
        try
          {
            get_number(p, l.stiffness_entry);
          }
        catch (const InputError &e)
          {
            refuse_entry(
              "Preload", "Stiffness entry", std::string(": ") + e.what());
          }
      }

      void
      check_times(const Parameters &p)
      {
        const TransientParameters &t = p.transient;
        if (!(t.time_step < t.end_time))
          refuse_entry("Transient",
                       "Time step",
                       "= " + format_number(t.time_step) +
                         " s must be below 'End time' = " +
                         format_number(t.end_time) + " s");
        if (t.sample_interval < t.time_step)
          refuse_entry("Transient",
                       "Sample interval",
                       "= " + format_number(t.sample_interval) +
                         " s is below the time step");
        if (!(t.sample_interval * p.eigen.highest_frequency <= 0.4))
          refuse_entry("Transient",
                       "Sample interval",
                       "= " + format_number(t.sample_interval) +
                         " s is too long for 'Eigenvalues/Highest frequency' "
                         "= " +
                         format_number(p.eigen.highest_frequency) +
                         " Hz: at most 0.4 of its period");
        if (t.interface_cut_off > 0. && t.interface_cut_off < t.cut_off)
          refuse_entry("Transient",
                       "Interface cut-off",
                       "must be 0 or not below 'Cut-off'");
        if (t.cut_off < p.eigen.highest_frequency)
          refuse_entry("Transient",
                       "Cut-off",
                       "must not be below 'Eigenvalues/Highest frequency'");
        if (t.history_start > t.end_time)
          refuse_entry("Transient", "History start", "is after 'End time'");
        if (!slides(p.scene))
          refuse_entry(p.scene.contacts.size() == 1
                         ? "Scene/Contact " + p.scene.contacts.back().name
                         : "Scene/Contacts",
                       "Sliding speed",
                       "must be greater than 0 for a transient, of one pair at "
                       "least; let it fall by 'Transient/Final speed ratio'");
      }

      void
      check_integrators(const Parameters &p)
      {
        const TransientParameters &t     = p.transient;
        const auto                 named = [&](const std::string &name) {
          return t.integrators.empty() ? choice_name(t.integrator) == name
                                                       : std::find(t.integrators.begin(),
                                                   t.integrators.end(),
                                                   name) != t.integrators.end();
        };
        if (named("explicit") &&
            p.discretization.mass != DiscretizationParameters::Mass::lumped)
          refuse_entry("Discretization",
                       "Mass",
                       "must be lumped for 'Transient/Integrator = explicit'");
        const bool all_unknowns = named("explicit") || named("implicit");
        if (all_unknowns && t.cut_off_damping > 0.)
          refuse_entry("Transient",
                       "Cut-off damping",
                       "belongs to the reduced integrator, whose modes end at "
                       "'Cut-off'");
        for (const ContactParameters &c : p.scene.contacts)
          if (all_unknowns &&
              c.formulation == ContactParameters::Formulation::springs)
            refuse_entry("Scene/Contact " + c.name,
                         "Formulation",
                         "= springs: the integrators of the finite elements "
                         "need mortar contact");
      }

      /** Whether anything but the contact joins the body to another one. */
      bool
      is_joined(const SceneParameters &scene, const std::string &body)
      {
        return std::any_of(scene.bodies.begin(),
                           scene.bodies.end(),
                           [&](const auto &b) {
                             return b.shape == BodyParameters::Shape::layer &&
                                    (b.name == body || b.layer_body == body);
                           }) ||
               std::any_of(scene.ties.begin(),
                           scene.ties.end(),
                           [&](const auto &t) {
                             return t.source_body == body ||
                                    t.target_body == body;
                           }) ||
               std::any_of(scene.springs.begin(),
                           scene.springs.end(),
                           [&](const auto &s) {
                             return s.other_body != "ground" &&
                                    (s.body == body || s.other_body == body);
                           });
      }

      [[noreturn]] void
      refuse_corotating(const std::string &text)
      {
        refuse_entry("Transient", "Disc frame", "= corotating " + text);
      }

      /** A pair that slides because the mesh of its target turns about z. */
      void
      check_turning_pair(const SceneParameters   &scene,
                         const ContactParameters &c)
      {
        if (c.formulation != ContactParameters::Formulation::mortar)
          refuse_corotating("needs 'Scene/Contact " + c.name +
                            "/Formulation = mortar'");
        if (c.friction_direction != ContactParameters::FrictionDirection::slip)
          refuse_corotating("needs 'Scene/Contact " + c.name +
                            "/Friction direction = slip': the target turns "
                            "about z");
        for (const auto &body : scene.bodies)
          if (body.name == c.target_body)
            {
              if (body.shape == BodyParameters::Shape::rigid)
                refuse_corotating("needs a meshed target: body '" + body.name +
                                  "' is rigid");
              if (body.rotation_speed != 0.)
                refuse_corotating("has the turning in its mesh: set "
                                  "'Scene/Body " +
                                  body.name + "/Rotation speed = 0'");
              if (body.rotation_axis[0] != 0. || body.rotation_axis[1] != 0.)
                refuse_corotating("turns meshes about z: the 'Rotation axis' "
                                  "of body '" +
                                  body.name + "' is another one");
            }
        if (is_joined(scene, c.target_body))
          refuse_corotating("cannot turn body '" + c.target_body +
                            "': a tie or a spring joins it to another body");
        for (const auto &mass : scene.lumped_masses)
          if (mass.body == c.target_body)
            refuse_corotating("leaves out Coriolis and centrifugal forces of "
                              "'Scene/Lumped mass " +
                              mass.name + "': give the body density instead");
        for (const auto &other : scene.contacts)
          if (other.source_body == c.target_body ||
              (other.target_body == c.target_body &&
               !(other.sliding_speed > 0.)))
            refuse_corotating("cannot turn body '" + c.target_body +
                              "': contact " + in_quotes(other.name) +
                              " holds it as a pair at rest or as a source");
      }

      /** A target whose mesh turns. */
      void
      check_disc_frame(const Parameters &p)
      {
        const TransientParameters &t = p.transient;
        if (t.disc_frame != TransientParameters::DiscFrame::corotating)
          return;
        for (const auto &[name, value] :
             choices(TransientParameters::Integrator()))
          if (value == TransientParameters::Integrator::reduced &&
              (t.integrators.empty() ? value == t.integrator
                                     : std::find(t.integrators.begin(),
                                                 t.integrators.end(),
                                                 name) != t.integrators.end()))
            refuse_corotating("needs 'Integrator = explicit' or 'implicit': "
                              "the " +
                              name +
                              " model holds the disc's flexibility at the "
                              "contact of the start only");
        for (const ContactParameters &c : p.scene.contacts)
          if (c.sliding_speed > 0.)
            check_turning_pair(p.scene, c);
      }

      void
      check_tops(const Parameters &p)
      {
        const TransientParameters &t        = p.transient;
        const auto                &supports = p.scene.supports;
        const bool                 has_top =
          std::any_of(supports.begin(), supports.end(), [&](const auto &s) {
            return s.name == t.top_support;
          });
        if (!t.tops.empty() && !has_top)
          refuse_entry("Transient",
                       "Top support",
                       "= " + in_quotes(t.top_support) +
                         " is not one of 'Scene/Supports'");
        const bool is_held =
          std::find(t.tops.begin(), t.tops.end(), "held") != t.tops.end() ||
          std::any_of(supports.begin(), supports.end(), [](const auto &s) {
            return s.kind == Kind::held;
          });
        if (is_held && t.start == TransientParameters::Start::ramp)
          refuse_entry("Transient",
                       "Start",
                       "= ramp: a held support is kept where the loads have "
                       "moved it; start from steady sliding");
        if (t.start == TransientParameters::Start::ramp && t.compare_with_cea)
          refuse_entry(
            "Transient", "Compare with CEA", "needs 'Start = steady sliding'");
        for (const ContactParameters &c : p.scene.contacts)
          if (c.sliding_speed > 0. && !c.transverse_slip_term &&
              t.compare_with_cea)
            refuse_entry("Scene/Contact " + c.name,
                         "Transverse slip term",
                         "must be true with 'Transient/Compare with CEA': in "
                         "time friction turns with the slip rate, and it must "
                         "in the eigenvalues");
        if (t.final_speed_ratio != 1. && t.compare_with_cea)
          refuse_entry("Transient",
                       "Compare with CEA",
                       "needs 'Final speed ratio = 1': eigenvalues belong to "
                       "one sliding speed");
      }

      void
      check_files(const TransientParameters &t)
      {
        require_saved_name(t.checkpoint_file, "Transient", "Checkpoint file");
        require_inside(t.campaign_table, "Transient", "Campaign table");
        const std::string &name   = t.campaign_table;
        const std::string  ending = ".csv";
        if (name.size() <= ending.size() ||
            name.substr(name.size() - ending.size()) != ending ||
            name == "phases.csv")
          refuse_entry("Transient",
                       "Campaign table",
                       "= " + in_quotes(name) +
                         ": give the table a name of its own that ends in "
                         "'.csv'");
      }
    } // namespace



    void
    check_transient(const Parameters &p)
    {
      check_imported(p);
      bool has_preload_state = false;
      for (const ContactParameters &c : p.scene.contacts)
        if (c.state == State::preload)
          {
            has_preload_state = true;
            if (p.analysis == Analysis::work_precision &&
                p.work_precision.problem ==
                  WorkPrecisionParameters::Problem::eigenvalues)
              refuse_entry("Scene/Contact " + c.name,
                           "Contact state",
                           "= preload holds for one mesh: it is not available "
                           "in ladders");
            if (p.analysis == Analysis::sweep &&
                c.formulation != ContactParameters::Formulation::springs)
              refuse_entry("Scene/Contact " + c.name,
                           "Formulation",
                           "must be springs: contact states that change over a "
                           "sweep need it");
          }
      const bool is_pressed =
        p.analysis == Analysis::preload || p.analysis == Analysis::transient ||
        p.analysis == Analysis::limit_cycle || p.analysis == Analysis::triggers;
      if ((is_pressed || has_preload_state) &&
          p.discretization.refinement ==
            DiscretizationParameters::Refinement::eigenvalue_error)
        refuse_entry("Discretization",
                     "Refinement",
                     "= eigenvalue error: steady sliding and transients stay "
                     "on one mesh; use none or uniform");
      if (p.discretization.mass == DiscretizationParameters::Mass::lumped &&
          (p.discretization.estimate_error ||
           p.discretization.refinement ==
             DiscretizationParameters::Refinement::eigenvalue_error ||
           p.discretization.refinement ==
             DiscretizationParameters::Refinement::contact_error))
        refuse_entry("Discretization",
                     "Mass",
                     "= lumped: errors are estimated for consistent masses; "
                     "set 'Estimate error = false' and no refinement by it");
      if (is_pressed || has_preload_state)
        {
          check_pressed_scene(p);
          check_run_in(p);
        }
      if (p.analysis == Analysis::preload)
        check_stiffness(p);
      else if (is_pressed)
        check_damping_in_time(p.scene);
      if (p.analysis == Analysis::limit_cycle)
        {
          check_limit_cycle(p);
          check_tops(p);
        }
      if (p.analysis == Analysis::triggers)
        {
          check_periodic_motions(p);
          check_tops(p);
          check_triggers(p);
        }
      if (p.analysis == Analysis::transient)
        {
          check_times(p);
          check_triggers(p);
          check_integrators(p);
          check_disc_frame(p);
          check_tops(p);
          check_files(p.transient);
        }
      if (is_pressed || has_preload_state)
        check_turning_in_time(p.scene);
    }
  } // namespace prm
} // namespace squeal
