// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/parameters/checks.h>
#include <squeal/parameters/choices.h>
#include <squeal/parameters/face_geometry.h>
#include <squeal/parameters/numbers.h>

#include <array>
#include <cmath>
#include <vector>

namespace squeal
{
  namespace prm
  {
    namespace
    {
      using Shape = BodyParameters::Shape;

      void
      require_positive(const double       value,
                       const std::string &section,
                       const std::string &entry)
      {
        if (!(value > 0.))
          refuse_entry(section,
                       entry,
                       "= " + format_number(value) + " must be greater than 0");
      }



      void
      require_positive(const Vector3     &values,
                       const std::string &section,
                       const std::string &entry)
      {
        for (const double value : values)
          require_positive(value, section, entry);
      }



      void
      check_radii(const BodyParameters &body, const std::string &section)
      {
        require_positive(body.outer_radius, section, "Outer radius");
        require_positive(body.height, section, "Height");
        if (body.shape != Shape::annulus)
          return;
        require_positive(body.inner_radius, section, "Inner radius");
        if (!(body.outer_radius > body.inner_radius))
          refuse_entry(section,
                       "Outer radius",
                       "= " + format_number(body.outer_radius) +
                         " m must be greater than 'Inner radius' = " +
                         format_number(body.inner_radius) + " m");
        if (body.cells[0] < 3)
          refuse_entry(section,
                       "Cells",
                       "= " + std::to_string(body.cells[0]) +
                         ", ...: an annulus needs at least 3 cells round its "
                         "circumference");
      }



      void
      check_shape(const BodyParameters &body, const std::string &section)
      {
        switch (body.shape)
          {
          case Shape::annulus:
          case Shape::cylinder:
            check_radii(body, section);
            break;
          case Shape::block:
            require_positive(body.size, section, "Size");
            break;
          case Shape::gmsh:
          case Shape::abaqus:
          case Shape::nastran:
            require_file(body.mesh_file, section, "Mesh file", true);
            break;
          case Shape::layer:
            require_positive(body.thickness, section, "Thickness");
            break;
          case Shape::rigid:
            require_positive(body.mass, section, "Mass");
            require_positive(body.inertia, section, "Inertia");
            break;
          }
        for (const unsigned int n : body.cells)
          if (n == 0)
            refuse_entry(section, "Cells", "must be at least 1 each");
        const auto &axis = body.rotation_axis;
        const bool  is_round =
          body.shape == Shape::annulus || body.shape == Shape::cylinder;
        if (!(std::hypot(axis[0], axis[1], axis[2]) > 0.))
          refuse_entry(section, "Rotation axis", "must not be 0, 0, 0");
        if ((is_round || body.rotation_speed != 0.) &&
            (axis[0] != 0. || axis[1] != 0.))
          refuse_entry(section,
                       "Rotation axis",
                       "must be along z for annuli and cylinders, whose axis "
                       "that is, and where 'Rotation speed' is not 0");
        // A cylinder may be a bolt that a disc takes with it.
        const bool stays_in_place =
          body.rotation_speed != 0. ||
          (body.angle != 0. && body.shape == Shape::annulus);
        if (is_round && stays_in_place && !turns_about_own_axis(body))
          refuse_entry(section,
                       "Rotation centre",
                       "is not on the body's own axis: an annulus that is "
                       "turned ('Angle', 'Analysis = angles') and a round body "
                       "with a 'Rotation speed' would move; give 'Position' "
                       "instead");
        // A block that turns is not at rest in the fixed frame, and a rigid
        // body has no terms of turning.
        if (body.rotation_speed != 0. &&
            (body.shape == Shape::block || body.shape == Shape::rigid))
          refuse_entry(section,
                       "Rotation speed",
                       "= " + format_number(body.rotation_speed) +
                         " rad/s is for meshed bodies of revolution; a " +
                         choice_name(body.shape) + " needs 0");
      }



      /** Refuses the @p numbers of a body that takes its material from
       * elsewhere where they are not those of a body without entries. */
      void
      refuse_ignored(
        const BodyParameters &body,
        const std::string    &section,
        const std::vector<std::pair<const char *, double BodyParameters::*>>
                          &numbers,
        const std::string &reason)
      {
        const BodyParameters plain;
        for (const auto &[entry, number] : numbers)
          if (body.*number != plain.*number)
            refuse_entry(section,
                         entry,
                         "= " + format_number(body.*number) +
                           " would be ignored: " + reason +
                           " (one that comes with an 'include' is set to its "
                           "default, " +
                           format_number(plain.*number) + ")");
      }



      void
      check_mesh_file_entries(const BodyParameters &body,
                              const std::string    &section)
      {
        require_positive(body.mesh_length_unit, section, "Mesh length unit");
        require_positive(body.mesh_mass_unit, section, "Mesh mass unit");
        if (!body.material_from_mesh_file)
          return;
        const std::string entry = "Material from mesh file";
        if (body.shape != Shape::abaqus && body.shape != Shape::nastran)
          refuse_entry(section,
                       entry,
                       "= true is for bodies of 'Shape = abaqus' and "
                       "'nastran', whose files hold materials");
        if (body.material_model != BodyParameters::MaterialModel::isotropic)
          refuse_entry(section,
                       entry,
                       "= true takes an isotropic material: remove it or "
                       "'Material model = orthotropic'");
        refuse_ignored(body,
                       section,
                       {{"Young modulus", &BodyParameters::young_modulus},
                        {"Poisson ratio", &BodyParameters::poisson_ratio},
                        {"Density", &BodyParameters::density}},
                       "'" + entry +
                         " = true' takes that of the file; remove one of "
                         "them");
      }



      /** The mesh file of a body that reads none, the mass of a meshed one. */
      void
      refuse_entries_of_shapes(const BodyParameters &body,
                               const std::string    &section)
      {
        const BodyParameters plain;
        const bool           reads = body.has_mesh_file();
        const std::string    of    = "is for 'Shape = ",
                          ignored  = "' and would be ignored by a " +
                                    choice_name(body.shape) + ": remove it";
        for (const auto &[entry, is_set] :
             {std::make_pair("Mesh file", body.mesh_file != plain.mesh_file),
              std::make_pair("Physical volume",
                             body.physical_volume != plain.physical_volume),
              std::make_pair("Mesh length unit",
                             body.mesh_length_unit != plain.mesh_length_unit)})
          if (is_set && !reads)
            refuse_entry(
              section, entry, of + "gmsh', 'abaqus' or 'nastran" + ignored);
        if (body.mass != plain.mass && body.shape != Shape::rigid)
          refuse_entry(section, "Mass", of + "rigid" + ignored);
      }



      /** Entries of layers and modulus tables that the body does not use. */
      void
      check_layer_entries(const BodyParameters &body,
                          const std::string    &section)
      {
        if (body.shape == Shape::layer)
          {
            if (body.angle != 0.)
              refuse_entry(section,
                           "Angle",
                           "= " + format_number(body.angle) +
                             ": a layer turns with the body that it lies on");
            if (body.rotation_speed != 0.)
              refuse_entry(section,
                           "Rotation speed",
                           "= " + format_number(body.rotation_speed) +
                             " rad/s: a layer turns with the body that it lies "
                             "on");
            if (body.material_model != BodyParameters::MaterialModel::isotropic)
              refuse_entry(section,
                           "Material model",
                           "= orthotropic: a layer follows a curved face and "
                           "has no axes in space; set 'isotropic'");
            return;
          }
        for (const auto &[entry, value] :
             {std::make_pair("Layer body", &body.layer_body),
              std::make_pair("Layer face", &body.layer_face)})
          if (!value->empty())
            refuse_entry(
              section, entry, "= '" + *value + "' is for 'Shape = layer'");
      }



      /** Entries of a modulus table of a body that has none. */
      void
      refuse_entries_of_tables(const BodyParameters &body,
                               const std::string    &section)
      {
        const std::string none =
          " is that of a 'Modulus table file', and the body has none";
        if (body.pressure != 0.)
          refuse_entry(section,
                       "Pressure",
                       "= " + format_number(body.pressure) + none +
                         "; loads stand in 'Scene/Load'");
        if (body.temperature != BodyParameters().temperature)
          refuse_entry(section,
                       "Temperature",
                       "= " + format_number(body.temperature) + none +
                         "; remove it");
        if (body.modulus_extrapolation !=
            BodyParameters().modulus_extrapolation)
          refuse_entry(section,
                       "Modulus extrapolation",
                       "= " + choice_name(body.modulus_extrapolation) + none +
                         "; remove it");
      }



      void
      check_modulus_table(const BodyParameters &body,
                          const std::string    &section)
      {
        const std::string entry = "Modulus table file";
        if (!body.has_modulus_table())
          return refuse_entries_of_tables(body, section);
        if (body.shape == Shape::rigid)
          refuse_entry(section, entry, "is for meshed bodies, not rigid ones");
        if (body.material_model != BodyParameters::MaterialModel::isotropic)
          refuse_entry(section, entry, "is for 'Material model = isotropic'");
        if (body.material_from_mesh_file)
          refuse_entry(section,
                       entry,
                       "and 'Material from mesh file' both give a modulus: "
                       "remove one of them");
        if (body.structural_damping != 0.)
          refuse_entry(section,
                       "Structural damping",
                       "= " + format_number(body.structural_damping) +
                         " would be ignored: 'Modulus table file' gives the "
                         "loss factor; remove it");
        require_file(body.modulus_table_file, section, entry, true);
      }



      /** Entries of an orthotropic material of a body that is none. */
      void
      refuse_orthotropic_entries(const BodyParameters &body,
                                 const std::string    &section)
      {
        const BodyParameters                plain;
        const std::pair<const char *, bool> entries[] = {
          {"Young moduli", body.young_moduli != plain.young_moduli},
          {"Shear moduli", body.shear_moduli != plain.shear_moduli},
          {"Poisson ratios", body.poisson_ratios != plain.poisson_ratios},
          {"Material axis 1", body.material_axis_1 != plain.material_axis_1},
          {"Material axis 2", body.material_axis_2 != plain.material_axis_2}};
        for (const auto &[entry, is_set] : entries)
          if (is_set)
            refuse_entry(section,
                         entry,
                         "would be ignored: set 'Material model = orthotropic' "
                         "or remove it");
      }



      void
      check_material_axes(const BodyParameters &body,
                          const std::string    &section)
      {
        const auto [a, b, c] = body.material_axis_1;
        const auto [u, v, w] = body.material_axis_2;
        const double across =
          std::hypot(b * w - c * v, c * u - a * w, a * v - b * u);
        if (!(across > 1e-6 * std::hypot(a, b, c) * std::hypot(u, v, w)))
          refuse_entry(section,
                       "Material axis 2",
                       "must not lie along 'Material axis 1', and neither may "
                       "be 0, 0, 0");
      }



      /** The flexibility matrix of the normal strains must be positive
       * definite: its leading minors, made free of units, are positive. */
      void
      check_orthotropic(const BodyParameters &body, const std::string &section)
      {
        require_positive(body.young_moduli, section, "Young moduli");
        require_positive(body.shear_moduli, section, "Shear moduli");
        const auto [e1, e2, e3]       = body.young_moduli;
        const auto [nu23, nu13, nu12] = body.poisson_ratios;
        const double a                = nu12 * nu12 * e2 / e1;
        const double b                = nu13 * nu13 * e3 / e1;
        const double c                = nu23 * nu23 * e3 / e2;
        // as close to 0 as an isotropic material with nu = 0.4999 comes
        const double                                         smallest = 1e-4;
        const std::array<std::pair<double, const char *>, 3> pairs    = {
             {{a, "nu12^2 E2/E1"}, {b, "nu13^2 E3/E1"}, {c, "nu23^2 E3/E2"}}};
        for (const auto &[product, name] : pairs)
          if (!(1. - product > smallest))
            refuse_entry(section,
                         "Poisson ratios",
                         std::string(": ") + name + " = " +
                           format_number(product) +
                           " must be below 1, or the material gives energy");
        const double minor = 1. - a - b - c - 2. * nu12 * nu23 * nu13 * e3 / e1;
        if (!(minor > smallest))
          refuse_entry(section,
                       "Poisson ratios",
                       ": 1 - nu12^2 E2/E1 - nu13^2 E3/E1 - nu23^2 E3/E2 - 2 "
                       "nu12 nu23 nu13 E3/E1 = " +
                         format_number(minor) +
                         " must be positive, or the material gives energy; "
                         "make the ratios smaller");
      }
    } // namespace



    void
    check_body(const BodyParameters &body)
    {
      const std::string section = "Scene/Body " + body.name;
      if (body.name == "ground")
        refuse_entry("Scene",
                     "Bodies",
                     "may not contain 'ground', which is the fixed "
                     "surroundings");
      check_shape(body, section);
      check_mesh_file_entries(body, section);
      refuse_entries_of_shapes(body, section);
      check_layer_entries(body, section);
      check_modulus_table(body, section);
      if (body.shape == Shape::rigid)
        return;
      require_positive(body.density, section, "Density");
      if (body.material_model == BodyParameters::MaterialModel::orthotropic)
        {
          refuse_ignored(body,
                         section,
                         {{"Young modulus", &BodyParameters::young_modulus},
                          {"Poisson ratio", &BodyParameters::poisson_ratio}},
                         "'Material model = orthotropic' has 'Young moduli' "
                         "and 'Poisson ratios'; remove it");
          check_orthotropic(body, section);
          check_material_axes(body, section);
          return;
        }
      refuse_orthotropic_entries(body, section);
      require_positive(body.young_modulus, section, "Young modulus");
      if (!(body.poisson_ratio > -1. && body.poisson_ratio < 0.5))
        refuse_entry(section,
                     "Poisson ratio",
                     "= " + format_number(body.poisson_ratio) +
                       " must be below 0.5");
    }
  } // namespace prm
} // namespace squeal
