// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/parameters/declarations.h>

#include <cmath>

namespace squeal
{
  namespace prm
  {
    namespace
    {
      void
      declare_tie(Schema &schema, TieParameters &t)
      {
        schema.add("Source body",
                   t.source_body,
                   Allowed::text(),
                   "Body that carries the multiplier of a mortar tie.");
        schema.add("Source face", t.source_face, Allowed::text(), "Its face.");
        schema.add("Target body",
                   t.target_body,
                   Allowed::text(),
                   "The other body. A rigid one couples the source face "
                   "rigidly to a point with mass and inertia.");
        schema.add("Target face",
                   t.target_face,
                   Allowed::text(),
                   "Its face; empty for a rigid body.");
        schema.add("Kind",
                   t.kind,
                   "Common nodes (conforming: the face meshes match, and "
                   "nothing else of the scene is on them), a mortar condition "
                   "(no support holds the source where the target is free), "
                   "or the first where possible.");
      }



      void
      normalise(Vector3 &v)
      {
        const double length = std::hypot(v[0], v[1], v[2]);
        for (double &component : v)
          component /= length;
      }



      void
      declare_spring_points(Schema &schema, SpringParameters &s)
      {
        schema.add("First point",
                   s.first_point,
                   Allowed::vector(),
                   "Where the first spring is attached.",
                   "m");
        schema.declare({schema.section_path(),
                        "Last point",
                        "",
                        Allowed::vector().or_empty("the first point"),
                        "Where the last spring is attached; the others are "
                        "evenly spaced between the two.",
                        "m",
                        [&s](const std::string &text) {
                          s.last_point = s.first_point;
                          if (!text.empty())
                            from_text(text, s.last_point);
                        }});
        schema.add("Number",
                   s.number,
                   Allowed::integer(1, 100000),
                   "Number of equal springs.");
        schema.declare({schema.section_path(),
                        "Direction",
                        to_text(s.direction),
                        Allowed::direction(),
                        "Direction the springs act in; its length does not "
                        "matter.",
                        "none",
                        [&s](const std::string &text) {
                          from_text(text, s.direction);
                          normalise(s.direction);
                        }});
      }



      void
      declare_spring(Schema &schema, SpringParameters &s)
      {
        schema.add("Kind",
                   s.kind,
                   "A row of point springs, or an elastic bed on a face.");
        schema.add("Body", s.body, Allowed::text(), "Body the springs act on.");
        schema.add("Other body",
                   s.other_body,
                   Allowed::text(),
                   "Body at the other end, at the same points, or 'ground'.");
        schema.add("Face",
                   s.face,
                   Allowed::text(),
                   "Face of an elastic bed; empty for point springs.");
        declare_spring_points(schema, s);
        schema
          .add("Stiffness",
               s.stiffness,
               Allowed::number(0.),
               "Stiffness of each point spring, or of the bed per area.",
               "N/m")
          .affine()
          .per_area("N/m^3");
        schema
          .add("Dashpot",
               s.dashpot,
               Allowed::number(0.),
               "Viscous damper in parallel with each point spring, or of "
               "the bed per area.",
               "N s/m")
          .affine()
          .per_area("N s/m^3");
        schema
          .add("Stiffnesses",
               s.stiffnesses,
               Allowed::vector(),
               "Stiffnesses along x, y and z of each point, or of the bed "
               "per area, beside 'Stiffness' along 'Direction'.",
               "N/m")
          .affine()
          .per_area("N/m^3");
        schema
          .add("Dashpots",
               s.dashpots,
               Allowed::vector(),
               "Viscous dampers along x, y and z of each point, or of the "
               "bed per area.",
               "N s/m")
          .affine()
          .per_area("N s/m^3");
        schema
          .add("Stiffness damping",
               s.stiffness_damping,
               Allowed::number(0.),
               "Damping over stiffness of the springs; with "
               "'Scene/Damping/Model = per part' only.",
               "s")
          .affine();
        schema
          .add("Structural damping",
               s.structural_damping,
               Allowed::number(0., 2.),
               "Loss factor of the springs; with 'Scene/Damping/Model = "
               "per part' only.")
          .affine();
      }



      void
      declare_support(Schema &schema, SupportParameters &s)
      {
        schema.add("Body", s.body, Allowed::text(), "Body that is held.");
        schema.add(
          "Face", s.face, Allowed::text(), "Its face; empty for a rigid body.");
        schema.add("Kind",
                   s.kind,
                   "All displacements are held (clamped), those listed in "
                   "'Components', or the face moves along its normal (x, y or "
                   "z) without tilting, free across it (guided); held: guided, "
                   "and kept along the normal where the loads have moved it; "
                   "free: nothing is held.");
        schema.add("Components",
                   s.components,
                   Allowed::list(
                     Allowed::one_of({"x", "y", "z", "rx", "ry", "rz"}), 0, 6),
                   "Directions held by 'Kind = components'; the rotations rx, "
                   "ry, rz are for rigid bodies.");
      }



      void
      declare_lumped_mass(Schema &schema, LumpedMassParameters &m)
      {
        schema.add("Body", m.body, Allowed::text(), "Body that carries it.");
        schema.add(
          "Point",
          m.point,
          Allowed::vector(),
          "Where it is fixed while the body's 'Angle' is 0: it turns with the "
          "body.",
          "m");
        schema.add("Mass", m.mass, Allowed::number(0.), "Its mass.", "kg")
          .affine();
      }



      void
      declare_load(Schema &schema, LoadParameters &l)
      {
        schema.add("Body", l.body, Allowed::text(), "Body that is loaded.");
        schema.add(
          "Face", l.face, Allowed::text(), "Its face; empty for a rigid body.");
        schema.add("Force",
                   l.force,
                   Allowed::vector(),
                   "Resultant of the force, spread evenly over the face.",
                   "N");
        schema.add("Pressure",
                   l.pressure,
                   Allowed::number(),
                   "Pressure on the face, against its outward normal; positive "
                   "pushes on the body.",
                   "Pa");
        schema.add("Moment",
                   l.moment,
                   Allowed::vector(),
                   "Moment on a rigid body about its centre of gravity.",
                   "N m");
        schema.add("Ramp time",
                   l.ramp_time,
                   Allowed::number(0.),
                   "Time of the smooth rise from 0 to the full force.",
                   "s");
      }



      void
      declare_damping(Schema &schema, DampingParameters &d)
      {
        schema.enter_section("Damping", "Damping of the scene.");
        schema.add("Model",
                   d.model,
                   "None; of the whole model by the three entries below, "
                   "springs and contact included; or of each body, spring and "
                   "contact by its own entries. Dashpots always count.");
        schema
          .add("Mass damping",
               d.mass_damping,
               Allowed::number(0.),
               "alpha of C = alpha M + beta K for the whole model.",
               "1/s")
          .affine();
        schema
          .add("Stiffness damping",
               d.stiffness_damping,
               Allowed::number(0.),
               "beta of C = alpha M + beta K for the whole model.",
               "s")
          .affine();
        schema
          .add("Structural damping",
               d.structural_damping,
               Allowed::number(0., 2.),
               "Loss factor eta of K (1 + i eta) for the whole model.")
          .affine();
        schema.leave_section();
      }



      void
      declare_matrix_part(Schema &schema, MatrixPartParameters &m)
      {
        schema.add("File",
                   m.file,
                   Allowed::file(),
                   "File of the matrix, relative to the parameter file.");
        schema.add("Role",
                   m.role,
                   "What the matrix is: mass, damping or stiffness; the "
                   "symmetric stiffness of the contact springs; the "
                   "non-symmetric friction part, which is multiplied by the "
                   "coefficient of friction; or another non-symmetric part of "
                   "the stiffness, which is not.");
        schema.add("Format",
                   m.format,
                   "Format of the file; automatic: from its ending and first "
                   "lines.");
        schema.add("Matrix name",
                   m.matrix_name,
                   Allowed::text(),
                   "Name of the matrix in a file with several; empty: the "
                   "only one.");
        schema
          .add("Factor",
               m.factor,
               Allowed::number(),
               "Number that multiplies the matrix.")
          .affine();
      }



      void
      declare_imported_model(Schema &schema, SceneParameters &scene)
      {
        schema.add("Contact pattern file",
                   scene.contact_pattern_file,
                   Allowed::file(),
                   "CSV file with the point pairs of the contact of an "
                   "imported model, relative to the parameter file; empty: "
                   "none.");
        schema
          .add("Contact normal stiffness",
               scene.contact_normal_stiffness,
               Allowed::number(0.),
               "Normal stiffness of each point pair of that file.",
               "N/m")
          .affine();
        schema
          .add("Friction coefficient",
               scene.friction_coefficient,
               Allowed::number(-5., 5.),
               "Coefficient of friction of an imported model.")
          .friction()
          .affine();
        schema.add("Node table file",
                   scene.node_table_file,
                   Allowed::file(),
                   "CSV file 'dof, node, component, x, y, z, body' of an "
                   "imported model, relative to the parameter file; empty: "
                   "none.");
      }
    } // namespace



    void
    declare_scene(Schema &schema, SceneParameters &scene)
    {
      schema.enter_section("Scene", "What vibrates.");
      schema.add(
        "Name", scene.name, Allowed::text(), "Name of the scene in reports.");
      schema.add("Kind",
                 scene.kind,
                 "Bodies that are described below, or matrices of another "
                 "program.");
      for (const SectionFamily &family : section_families())
        if (family.parent == "Scene")
          declare_list(schema, family);
      declare_imported_model(schema, scene);

      declare_members(
        schema, family_named("Bodies"), scene.bodies, &declare_body);
      declare_members(schema, family_named("Ties"), scene.ties, &declare_tie);
      declare_members(
        schema, family_named("Springs"), scene.springs, &declare_spring);
      declare_members(
        schema, family_named("Supports"), scene.supports, &declare_support);
      declare_members(schema,
                      family_named("Lumped masses"),
                      scene.lumped_masses,
                      &declare_lumped_mass);
      declare_members(
        schema, family_named("Loads"), scene.loads, &declare_load);
      declare_members(
        schema, family_named("Contacts"), scene.contacts, &declare_contact);
      declare_damping(schema, scene.damping);
      declare_members(schema,
                      family_named("Matrix parts"),
                      scene.matrix_parts,
                      &declare_matrix_part);
      schema.leave_section();
    }
  } // namespace prm
} // namespace squeal
