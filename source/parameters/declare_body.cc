// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/parameters/declarations.h>

namespace squeal
{
  namespace prm
  {
    namespace
    {
      void
      declare_geometry(Schema &schema, BodyParameters &b)
      {
        schema.add("Shape",
                   b.shape,
                   "What the body is. Faces: annulus inner, outer, bottom, "
                   "top; block x_min, x_max, y_min, y_max, z_min, z_max; "
                   "cylinder side, bottom, top; gmsh, abaqus, nastran: the "
                   "surfaces of the mesh file; layer outer, sides; rigid: "
                   "none.");
        schema.add("Position",
                   b.position,
                   Allowed::vector(),
                   "Centre of the bottom face (annulus, block, cylinder), "
                   "centre of gravity (rigid), or offset added to the mesh "
                   "file's coordinates.",
                   "m");
        schema.add("Size",
                   b.size,
                   Allowed::list(Allowed::positive(), 3, 3),
                   "Edge lengths of a block along x, y and z.",
                   "m");
        schema.add("Inner radius",
                   b.inner_radius,
                   Allowed::positive(),
                   "Inner radius of an annulus.",
                   "m");
        schema.add("Outer radius",
                   b.outer_radius,
                   Allowed::positive(),
                   "Outer radius of an annulus or radius of a cylinder.",
                   "m");
        schema.add("Height",
                   b.height,
                   Allowed::positive(),
                   "Height of an annulus or cylinder along z.",
                   "m");
        schema.add("Cells",
                   b.cells,
                   Allowed::list(Allowed::integer(1, 10000), 3, 3),
                   "Cells of the coarse mesh: along x, y, z of a block; round "
                   "the circumference, along radius and height of an annulus; "
                   "a cylinder takes the first (raised to 4, 8, 16, ...) and "
                   "the last.");
        schema.add("Mesh file",
                   b.mesh_file,
                   Allowed::file(),
                   "File with hexahedra of a gmsh (.msh), abaqus (.inp) or "
                   "nastran (.bdf) body, relative to the parameter file.");
        schema.add("Physical volume",
                   b.physical_volume,
                   Allowed::text(),
                   "What of the mesh file is the body: a physical volume "
                   "(gmsh), an element set or instance (abaqus), the number of "
                   "a property, or 'set' and that of a set of elements "
                   "(nastran); empty: all cells.");
        schema.add("Mesh faces",
                   b.mesh_faces,
                   Allowed::list(Allowed::text(), 0, 64),
                   "Surfaces of the mesh file that are faces of the body, and "
                   "of abaqus and nastran files also node sets: a face has all "
                   "its corners in the set. Empty: all surfaces.");
        schema.add("Mesh length unit",
                   b.mesh_length_unit,
                   Allowed::positive(),
                   "Unit of lengths in the mesh file: 0.001 for millimetres.",
                   "m");
        schema.add("Mesh mass unit",
                   b.mesh_mass_unit,
                   Allowed::positive(),
                   "Unit of masses in the mesh file's materials: 1000 for "
                   "models in mm, tonne, s. Times are in s.",
                   "kg");
      }



      void
      declare_layer(Schema &schema, BodyParameters &b)
      {
        schema.add("Layer body",
                   b.layer_body,
                   Allowed::text(),
                   "Body that a layer lies on, glued to it: one that stands "
                   "before the layer in 'Bodies', another layer too.");
        schema.add("Layer face",
                   b.layer_face,
                   Allowed::text(),
                   "Face of that body that the layer covers as a whole. What "
                   "pressed on it, held it or touched it takes the face "
                   "'outer' of the layer.");
        schema.add("Thickness",
                   b.thickness,
                   Allowed::positive(),
                   "Thickness of a layer along the normals of that face.",
                   "m");
        schema.add("Element layers",
                   b.element_layers,
                   Allowed::integer(1, 1000),
                   "Cells of a layer across its thickness; along the face it "
                   "has those of the face.");
      }



      void
      declare_modulus_table(Schema &schema, BodyParameters &b)
      {
        schema.add("Modulus table file",
                   b.modulus_table_file,
                   Allowed::file(),
                   "Table with the columns frequency_Hz, temperature_C, "
                   "storage_modulus_Pa, loss_factor and, if the modulus "
                   "depends on it, pressure_Pa, relative to the "
                   "parameter file. Each pair gets the complex modulus at its "
                   "own frequency; 'Young modulus' and 'Structural damping' "
                   "are not used, and the loss factor counts whatever "
                   "'Scene/Damping/Model' is.");
        schema.add("Temperature",
                   b.temperature,
                   Allowed::number(-273.15, 5000.),
                   "Temperature at which that table is read.",
                   "degrees Celsius");
        schema.add("Pressure",
                   b.pressure,
                   Allowed::number(0.),
                   "Pressure on the lining at which that table is read, if it "
                   "has the column pressure_Pa; in an operating matrix with "
                   "'Pressures' that of each condition.",
                   "Pa");
        schema.add("Modulus extrapolation",
                   b.modulus_extrapolation,
                   "What holds outside the frequencies, temperatures and "
                   "pressures of that table: nothing, or the value at its "
                   "nearest end.");
      }



      void
      declare_material(Schema &schema, BodyParameters &b)
      {
        const Allowed three_positive = Allowed::list(Allowed::positive(), 3, 3);
        schema.add("Material model",
                   b.material_model,
                   "Elastic law: 'Young modulus' and 'Poisson ratio', or "
                   "'Young moduli', 'Shear moduli' and 'Poisson ratios'.");
        schema
          .add("Young modulus",
               b.young_modulus,
               Allowed::positive(),
               "Young's modulus of an isotropic material.",
               "Pa")
          .affine();
        schema.add("Poisson ratio",
                   b.poisson_ratio,
                   Allowed::number(0., 0.4999),
                   "Poisson's ratio of an isotropic material; at 0.5 the "
                   "stiffness would be infinite.");
        schema
          .add("Density",
               b.density,
               Allowed::positive(),
               "Mass density of a meshed body.",
               "kg/m^3")
          .affine();
        schema.add("Young moduli",
                   b.young_moduli,
                   three_positive,
                   "E1, E2, E3 of an orthotropic material along its axes 1, 2 "
                   "and 3.",
                   "Pa");
        schema.add("Shear moduli",
                   b.shear_moduli,
                   three_positive,
                   "G23, G13, G12 of an orthotropic material.",
                   "Pa");
        schema.add("Poisson ratios",
                   b.poisson_ratios,
                   Allowed::list(Allowed::number(-10., 10.), 3, 3),
                   "nu23, nu13, nu12 of an orthotropic material; nu12 is the "
                   "contraction along 2 under tension along 1.");
        schema.add("Material axis 1",
                   b.material_axis_1,
                   Allowed::vector(),
                   "Direction, of any length, of the axis 1 of an orthotropic "
                   "material. It does not turn with 'Angle', but "
                   "'Analysis = angles' turns it with the body.");
        schema.add("Material axis 2",
                   b.material_axis_2,
                   Allowed::vector(),
                   "A direction in the plane of the axes 1 and 2 of an "
                   "orthotropic material; its part across axis 1 is the axis "
                   "2, and axis 3 is across both, right-handed.");
        schema.add("Material from mesh file",
                   b.material_from_mesh_file,
                   "The elastic constants and the density of the body are "
                   "those that an abaqus or nastran file gives its cells; the "
                   "parameters_used.prm of the run has them as numbers and "
                   "false here. If false and they differ, the log says so.");
        schema.add(
          "Mass", b.mass, Allowed::positive(), "Mass of a rigid body.", "kg");
        schema.add("Inertia",
                   b.inertia,
                   three_positive,
                   "Moments of inertia of a rigid body about x, y and z "
                   "through its centre of gravity; with an 'Angle' these axes "
                   "turn with it.",
                   "kg m^2");
      }
    } // namespace



    void
    declare_body(Schema &schema, BodyParameters &b)
    {
      declare_geometry(schema, b);
      declare_layer(schema, b);
      declare_material(schema, b);
      declare_modulus_table(schema, b);
      schema
        .add("Mass damping",
             b.mass_damping,
             Allowed::number(0.),
             "Damping matrix over mass matrix of the body; with "
             "'Scene/Damping/Model = per part' only.",
             "1/s")
        .affine();
      schema
        .add("Stiffness damping",
             b.stiffness_damping,
             Allowed::number(0.),
             "Damping matrix over stiffness matrix of a meshed body; with "
             "'Scene/Damping/Model = per part' only.",
             "s")
        .affine();
      schema
        .add("Structural damping",
             b.structural_damping,
             Allowed::number(0., 2.),
             "Loss factor of the material of a meshed body; with "
             "'Scene/Damping/Model = per part' only.")
        .affine();
      schema
        .add("Rotation speed",
             b.rotation_speed,
             Allowed::number(),
             "Speed about the z axis for the gyroscopic and convective "
             "terms of a body that turns through the fixed frame; 0 "
             "leaves them out.",
             "rad/s")
        .affine();
      schema.add("Rotation axis",
                 b.rotation_axis,
                 Allowed::vector(),
                 "Direction, of any length, of the axis that the body turns "
                 "about as the target of a contact with 'Friction direction = "
                 "slip'; the sense of turning follows the right hand.");
      schema.declare({schema.section_path(),
                      "Rotation centre",
                      "",
                      Allowed::vector().or_empty("the position"),
                      "A point of that axis.",
                      "m",
                      [&b](const std::string &text) {
                        b.rotation_centre.reset();
                        if (text.empty())
                          return;
                        b.rotation_centre.emplace();
                        from_text(text, *b.rotation_centre);
                      }});
      schema.add(
        "Angle",
        b.angle,
        Allowed::number(),
        "What the mesh and lumped masses on it, or the centre of gravity, the "
        "inertia and the contact points of a rigid body are turned by about "
        "that axis, such as the angle at which a disc with vanes stands; "
        "springs and measurement points stay where they are ('Analysis = "
        "angles' turns springs between two turning bodies). Annuli and "
        "cylinders turn about z only, annuli about their own axis.",
        "deg");
    }
  } // namespace prm
} // namespace squeal
