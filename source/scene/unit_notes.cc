// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/base/number_text.h>
#include <squeal/scene/coarse_mesh.h>
#include <squeal/scene/unit_notes.h>

#include <algorithm>
#include <cmath>

namespace squeal
{
  namespace
  {
    constexpr double largest_scene = 10., smallest_scene = 1e-3, // m
      lowest_modulus = 2.5e5,                                    // Pa
      lowest_density = 25., highest_density = 1e6;               // kg/m^3

    /** Longest edge of the box around all vertices, m; 0 without any. */
    double
    extent_of_mesh(const CoarseMesh &mesh)
    {
      if (mesh.vertices.empty())
        return 0.;
      dealii::Point<3> low = mesh.vertices.front(), high = low;
      for (const dealii::Point<3> &x : mesh.vertices)
        for (unsigned int c = 0; c < 3; ++c)
          {
            low[c]  = std::min(low[c], x[c]);
            high[c] = std::max(high[c], x[c]);
          }
      const dealii::Tensor<1, 3> edges = high - low;
      return std::max({edges[0], edges[1], edges[2]});
    }

    std::string
    note_on_extent(const SceneParameters &scene)
    {
      double size = 0.;
      try
        {
          size = extent_of_mesh(make_coarse_mesh(scene));
        }
      catch (const InputError &)
        {
          return ""; // the run says what is wrong with the mesh
        }
      if (size == 0. || (size >= smallest_scene && size <= largest_scene))
        return "";
      const auto from_file =
        std::find_if(scene.bodies.begin(),
                     scene.bodies.end(),
                     [](const auto &body) { return body.has_mesh_file(); });
      return "the scene is " + rounded_text(size, 3) +
             " m long, which no brake is: lengths are in m" +
             (from_file == scene.bodies.end()
                ? ""
                : ", and a mesh file in mm needs 'Scene/Body " +
                    from_file->name + "/Mesh length unit = 0.001' (it is " +
                    shortest_text(from_file->mesh_length_unit) + ")");
    }

    std::string
    text_of_modulus(const std::string &entry,
                    const std::string &reaches,
                    const double       modulus)
    {
      return "'" + entry + "' " + reaches + " " + rounded_text(modulus, 4) +
             " Pa, softer than any solid of a brake: moduli are in Pa, and one "
             "in MPa needs the factor 1e6";
    }

    void
    note_material(const BodyParameters &body, std::vector<std::string> &notes)
    {
      const std::string section = "Scene/Body " + body.name + "/";
      const bool        is_isotropic =
        body.material_model == BodyParameters::MaterialModel::isotropic;
      const double modulus = lowest_young_modulus(body);
      if (modulus < lowest_modulus)
        notes.push_back(text_of_modulus(
          section + (is_isotropic ? "Young modulus" : "Young moduli"),
          is_isotropic ? "is" : "goes down to",
          modulus));
      if (body.density < lowest_density || body.density > highest_density)
        notes.push_back("'" + section +
                        "Density' = " + rounded_text(body.density, 4) +
                        " kg/m^3 is that of no solid of a brake: one in g/cm^3 "
                        "needs the factor 1000, one in t/mm^3 1e12");
    }

    /** The lowest value of entry number @p e of an axis. */
    double
    lowest_value(const SweepAxisParameters &axis, const std::size_t e)
    {
      if (axis.scale != SweepAxisParameters::Scale::list)
        return std::min(axis.from[axis.from.size() > 1 ? e : 0],
                        axis.to[axis.to.size() > 1 ? e : 0]);
      const std::size_t n      = axis.values.size();
      const bool        is_own = !axis.entry_values.empty();
      const auto        first =
        is_own ? axis.entry_values.begin() + e * n : axis.values.begin();
      return *std::min_element(first, first + n);
    }
  } // namespace



  double
  lowest_young_modulus(const BodyParameters &body)
  {
    return body.material_model == BodyParameters::MaterialModel::isotropic
             ? body.young_modulus
             : *std::min_element(body.young_moduli.begin(),
                                 body.young_moduli.end());
  }



  std::vector<std::string>
  notes_on_units(const SceneParameters &scene)
  {
    std::vector<std::string> notes;
    if (scene.kind != SceneParameters::Kind::bodies)
      return notes;
    if (const std::string note = note_on_extent(scene); !note.empty())
      notes.push_back(note);
    for (const BodyParameters &body : scene.bodies)
      if (body.shape != BodyParameters::Shape::rigid)
        note_material(body, notes);
    return notes;
  }



  std::vector<std::string>
  notes_on_units(const SweepParameters &sweep)
  {
    const std::string        ending = "/Young modulus";
    std::vector<std::string> notes;
    for (const SweepAxisParameters &axis : sweep.axes)
      for (std::size_t e = 0; e < axis.entries.size(); ++e)
        {
          const std::string &entry = axis.entries[e];
          if (entry.size() > ending.size() &&
              entry.substr(entry.size() - ending.size()) == ending &&
              lowest_value(axis, e) < lowest_modulus)
            notes.push_back(
              text_of_modulus(entry, "goes down to", lowest_value(axis, e)));
        }
    return notes;
  }



  void
  note_units(Parameters &p)
  {
    for (const auto &notes : {notes_on_units(p.scene), notes_on_units(p.sweep)})
      p.notes.insert(p.notes.end(), notes.begin(), notes.end());
  }
} // namespace squeal
