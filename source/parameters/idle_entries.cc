// SPDX-License-Identifier: LGPL-2.1-or-later
#include "idle_entries.h"

#include <squeal/parameters/checks.h>
#include <squeal/parameters/choices.h>
#include <squeal/parameters/text.h>

#include <algorithm>
#include <set>
#include <vector>

namespace squeal
{
  namespace prm
  {
    namespace
    {
      using Shape = BodyParameters::Shape;

      /** An entry without effect, whatever its value. */
      struct IdleEntry
      {
        std::string path;
        std::string cause_path; /**< the entry that makes it idle */
        std::string cause;      /**< in words */
        /** By check_body(), as long as it is not the default. */
        bool is_refused = false;
      };

      /** An entry of the geometry or the mass of a body. */
      struct EntryOfShapes
      {
        const char        *name;
        std::vector<Shape> shapes; /**< that use it */
        bool               is_refused = false;
      };

      const std::vector<EntryOfShapes> &
      entries_of_shapes()
      {
        static const std::vector<Shape>
          round = {Shape::annulus, Shape::cylinder},
          read  = {Shape::gmsh, Shape::abaqus, Shape::nastran},
          made  = {Shape::annulus, Shape::block, Shape::cylinder};
        static const std::vector<EntryOfShapes> entries = {
          {"Size", {Shape::block}},
          {"Inner radius", {Shape::annulus}},
          {"Outer radius", round},
          {"Height", round},
          {"Cells", made},
          {"Mesh file", read, true},
          {"Physical volume", read, true},
          {"Mesh length unit", read, true},
          {"Mesh faces", read},
          {"Mesh mass unit", {Shape::abaqus, Shape::nastran}},
          {"Thickness", {Shape::layer}},
          {"Element layers", {Shape::layer}},
          {"Mass", {Shape::rigid}, true},
          {"Inertia", {Shape::rigid}}};
        return entries;
      }

      /** Entries that a run changes: those of the axes of a sweep or a
       * campaign, of sensitivities, of updating and of the stiffness of a
       * pressed pad, without the components of a vector. What they make idle at
       * the start is of use later. */
      std::set<std::string>
      varied_entries(const Parameters &p)
      {
        std::set<std::string> varied;
        const auto            add = [&varied](const auto &paths) {
          for (const std::string &path : paths)
            varied.insert(normal_path(path.substr(0, path.find('['))));
        };
        for (const SweepAxisParameters &axis : p.sweep.axes)
          add(axis.entries);
        add(p.sweep.sensitivities);
        for (const UpdatedNumberParameters &number : p.updating.numbers)
          add(number.entries);
        if (!p.preload.stiffness_entry.empty())
          add(std::vector<std::string>{p.preload.stiffness_entry});
        return varied;
      }

      bool
      holds_any(const std::set<std::string>     &varied,
                const std::string               &section,
                const std::vector<const char *> &entries)
      {
        return std::any_of(
          entries.begin(), entries.end(), [&](const char *entry) {
            return varied.count(section + entry) > 0;
          });
      }

      /** Whether a contact or a turning asks for the axis of @p body. */
      bool
      has_use_of_axis(const Parameters            &p,
                      const std::set<std::string> &varied,
                      const BodyParameters        &body)
      {
        if (holds_any(varied,
                      "Scene/Body " + body.name + "/",
                      {"Angle", "Rotation speed"}) ||
            body.rotation_speed != 0. || body.angle != 0. ||
            p.analysis == Parameters::Analysis::angles)
          return true;
        // A layer that rubs has the axis of what it lies on.
        return std::any_of(
          p.scene.contacts.begin(),
          p.scene.contacts.end(),
          [&](const ContactParameters &c) {
            return c.target_body != "ground" &&
                   (c.target_body == body.name ||
                    std::any_of(p.scene.bodies.begin(),
                                p.scene.bodies.end(),
                                [&](const auto &other) {
                                  return other.shape == Shape::layer &&
                                         other.name == c.target_body;
                                }));
          });
      }

      void
      add_of_bodies(const Parameters            &p,
                    const std::set<std::string> &varied,
                    std::vector<IdleEntry>      &idle)
      {
        for (const BodyParameters &body : p.scene.bodies)
          {
            const std::string section = "Scene/Body " + body.name + "/";
            for (const EntryOfShapes &e : entries_of_shapes())
              if (std::count(e.shapes.begin(), e.shapes.end(), body.shape) == 0)
                idle.push_back({section + e.name,
                                section + "Shape",
                                "'Shape = " + choice_name(body.shape) + "'",
                                e.is_refused});
            if (!has_use_of_axis(p, varied, body))
              for (const char *entry : {"Rotation axis", "Rotation centre"})
                idle.push_back({section + entry,
                                "Scene/Contacts",
                                "the body is no target of a contact"});
          }
      }

      void
      add_of_contacts(const SceneParameters  &scene,
                      std::vector<IdleEntry> &idle)
      {
        using Formulation = ContactParameters::Formulation;
        for (const ContactParameters &c : scene.contacts)
          {
            const std::string section = "Scene/Contact " + c.name + "/";
            const auto        add = [&](const std::string               &cause,
                                 const std::string               &choice,
                                 const std::vector<const char *> &entries) {
              for (const char *entry : entries)
                idle.push_back({section + entry,
                                section + cause,
                                "'" + cause + " = " + choice + "'"});
            };
            if (c.formulation != Formulation::springs)
              add("Formulation",
                  choice_name(c.formulation),
                  {"Spring layout",
                   "Grid",
                   "Normal stiffness",
                   "Tangential stiffness",
                   "Normal stiffness per area"});
            else if (c.layout == ContactParameters::SpringLayout::grid)
              add("Spring layout",
                  choice_name(c.layout),
                  {"Normal stiffness per area"});
            else
              add("Spring layout",
                  choice_name(c.layout),
                  {"Grid", "Normal stiffness"});
          }
      }

      void
      add_of_springs(const SceneParameters       &scene,
                     const std::set<std::string> &varied,
                     std::vector<IdleEntry>      &idle)
      {
        for (const SpringParameters &spring : scene.springs)
          if (const std::string section = "Scene/Spring " + spring.name + "/";
              spring.stiffness == 0. && spring.dashpot == 0. &&
              !holds_any(varied, section, {"Stiffness", "Dashpot"}))
            idle.push_back({section + "Direction",
                            section + "Stiffnesses",
                            "'Stiffness' and 'Dashpot' are 0"});
      }

      /** Adds the ramps of loads where nothing comes on in time and no scene is
       * written for runs in which it does. */
      void
      add_of_ramps(const Parameters &p, std::vector<IdleEntry> &idle)
      {
        using Analysis       = Parameters::Analysis;
        const bool is_motion = p.analysis == Analysis::transient ||
                               (p.analysis == Analysis::work_precision &&
                                p.work_precision.problem ==
                                  WorkPrecisionParameters::Problem::transient);
        const bool writes_scene =
          p.output.export_matrices && (p.analysis == Analysis::transient ||
                                       p.analysis == Analysis::preload);
        if (writes_scene || (is_motion && p.transient.start ==
                                            TransientParameters::Start::ramp))
          return;
        for (const LoadParameters &load : p.scene.loads)
          idle.push_back({"Scene/Load " + load.name + "/Ramp time",
                          is_motion ? "Transient/Start" : "Analysis",
                          is_motion
                            ? "'Start = " + choice_name(p.transient.start) + "'"
                            : "'Analysis = " + choice_name(p.analysis) + "'"});
      }

      void
      add_of_analysis(const Parameters &p, std::vector<IdleEntry> &idle)
      {
        using Refinement  = DiscretizationParameters::Refinement;
        const auto &d     = p.discretization;
        const bool  is_it = d.refinement == Refinement::none ||
                           d.refinement == Refinement::uniform;
        if (is_it && p.analysis != Parameters::Analysis::work_precision)
          idle.push_back({"Discretization/Tolerance",
                          "Discretization/Refinement",
                          "'Refinement = " + choice_name(d.refinement) + "'"});
        if (p.eigen.solver == EigenParameters::Solver::certified &&
            !(p.eigen.compare_direct &&
              p.analysis == Parameters::Analysis::cea))
          idle.push_back({"Eigenvalues/Number of pairs",
                          "Eigenvalues/Solver",
                          "'Solver = certified'"});
        if (d.refinement != Refinement::contact_error)
          idle.push_back({"Discretization/Growth rate tolerance",
                          "Discretization/Refinement",
                          "'Refinement = " + choice_name(d.refinement) + "'"});
        if (p.analysis != Parameters::Analysis::cea)
          idle.push_back({"Eigenvalues/Compare with direct",
                          "Analysis",
                          "'Analysis = " + choice_name(p.analysis) + "'"});
        add_of_ramps(p, idle);
      }

      std::vector<IdleEntry>
      idle_entries(const Parameters &p)
      {
        std::vector<IdleEntry> idle;
        add_of_analysis(p, idle);
        if (p.scene.kind != SceneParameters::Kind::bodies)
          return idle;
        const std::set<std::string> varied = varied_entries(p);
        add_of_bodies(p, varied, idle);
        add_of_contacts(p.scene, idle);
        add_of_springs(p.scene, varied, idle);
        return idle;
      }

      /** Whether @p cause, if it is set at all, was set by a later file than
       * @p entry. */
      bool
      is_overruled(const RawEntry &entry, const RawEntry *cause)
      {
        return cause != nullptr && entry.order < cause->order;
      }
    } // namespace



    bool
    settle_idle_entries(const PrmTree &tree,
                        Schema        &schema,
                        Parameters    &parameters)
    {
      bool        has_dropped = false;
      std::string named;
      for (const IdleEntry &idle : idle_entries(parameters))
        {
          const Schema::Entry *entry = schema.find(idle.path);
          const RawEntry      *raw   = tree.find(idle.path);
          if (entry == nullptr || raw == nullptr ||
              schema.value(*entry) == entry->default_value)
            continue;
          if (is_overruled(*raw, tree.find(idle.cause_path)))
            {
              if (idle.is_refused)
                schema.set({idle.path,
                            entry->default_value,
                            raw->location,
                            raw->directory});
              has_dropped = has_dropped || idle.is_refused;
            }
          else if (!idle.is_refused)
            named += (named.empty() ? "" : ", ") + in_quotes(idle.path) + " (" +
                     idle.cause + ")";
        }
      if (!named.empty())
        parameters.notes.push_back("entries without effect: " + named);
      if (has_dropped)
        schema.assign();
      return has_dropped;
    }
  } // namespace prm
} // namespace squeal
