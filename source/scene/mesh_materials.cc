// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/base/number_text.h>
#include <squeal/parameters/checks.h>
#include <squeal/parameters/numbers.h>

#include <squeal/scene/mesh_materials.h>
#include <squeal/scene/mesh_selection.h>

#include <cmath>
#include <map>

namespace squeal
{
  namespace
  {
    /** The material with SI units. */
    MeshFile::Material
    in_si(MeshFile::Material material, const BodyParameters &body)
    {
      const double length = body.mesh_length_unit, mass = body.mesh_mass_unit;
      material.young_modulus *= mass / length;
      material.density *= mass / (length * length * length);
      return material;
    }

    std::string
    values(const double E, const double nu, const double rho)
    {
      return "E " + rounded_text(E, 6) + " Pa, nu " + rounded_text(nu, 6) +
             ", rho " + rounded_text(rho, 6) + " kg/m^3";
    }

    bool
    agree(const double a, const double b)
    {
      return std::abs(a - b) <= 1e-6 * std::max(std::abs(a), std::abs(b));
    }

    /** Of what is wrong with a body its checks say more than its mesh file. */
    void
    check_before_reading(const Parameters &p)
    {
      try
        {
          for (const BodyParameters &body : p.scene.bodies)
            if (body.material_from_mesh_file)
              prm::check_body(body);
        }
      catch (const InputError &e)
        {
          throw InputError((p.file.empty() ? "" : p.file + ": ") + e.what());
        }
    }
  } // namespace



  void
  take_mesh_materials(SceneParameters &scene)
  {
    for (BodyParameters &body : scene.bodies)
      {
        if (!body.material_from_mesh_file)
          continue;
        const MeshFile      file = read_mesh_file(body);
        const MeshSelection selection(file, body);
        const int           position = selection.material();
        if (position < 0)
          selection.fail("gives the cells of the body no material");
        const auto m = in_si(file.materials[position], body);
        if (!m.fault.empty())
          selection.fail("has a material that cannot be taken: '" + m.name +
                         "' " + m.fault + ": give it in the parameter file");
        if (!(m.young_modulus > 0. && m.density > 0. && m.poisson_ratio >= 0. &&
              m.poisson_ratio <= .4999))
          selection.fail("has a material that cannot be taken: '" + m.name +
                         "' has " +
                         values(m.young_modulus, m.poisson_ratio, m.density));
        body.material_model = BodyParameters::MaterialModel::isotropic;
        body.young_modulus  = m.young_modulus;
        body.poisson_ratio  = m.poisson_ratio;
        body.density        = m.density;
      }
  }

  void
  take_mesh_materials(Parameters &p)
  {
    check_before_reading(p);
    std::vector<BodyParameters *> bodies;
    for (BodyParameters &body : p.scene.bodies)
      if (body.material_from_mesh_file)
        bodies.push_back(&body);
    take_mesh_materials(p.scene);
    for (BodyParameters *body : bodies)
      {
        body->material_from_mesh_file = false;
        const std::string section     = "Scene/Body " + body->name + "/";
        const std::map<std::string, std::string> taken = {
          {section + "Material from mesh file", "false"},
          {section + "Young modulus", prm::format_number(body->young_modulus)},
          {section + "Poisson ratio", prm::format_number(body->poisson_ratio)},
          {section + "Density", prm::format_number(body->density)}};
        for (auto &[path, text] : p.used)
          if (const auto entry = taken.find(path); entry != taken.end())
            text = entry->second;
      }
  }



  std::string
  material_remark(const BodyParameters &body, const MeshFile &file)
  {
    const MeshSelection selection(file, body);
    std::set<int>       positions;
    std::vector<long>   without;
    for (const auto &element : file.elements)
      if (selection.holds(element))
        {
          if (element.material >= 0)
            positions.insert(element.material);
          else
            without.push_back(element.tag);
        }
    std::string others;
    for (const int position : positions)
      {
        const auto m = in_si(file.materials[position], body);
        if (m.fault.empty() &&
            body.material_model == BodyParameters::MaterialModel::isotropic &&
            agree(m.young_modulus, body.young_modulus) &&
            agree(m.poisson_ratio, body.poisson_ratio) &&
            agree(m.density, body.density))
          continue;
        others +=
          (others.empty() ? "'" : ", '") + m.name + "', which " +
          (m.fault.empty()
             ? "has " + values(m.young_modulus, m.poisson_ratio, m.density)
             : m.fault);
      }
    if (!others.empty())
      others = "gives its cells the material " + others;
    // Files of a mesh alone have no materials.
    if (!without.empty() && !file.materials.empty())
      others += (others.empty() ? "gives " : ", and ") +
                std::to_string(without.size()) +
                " of its cells (first: element " +
                std::to_string(without.front()) + ") no material that is read";
    if (others.empty())
      return "";
    return "body '" + body.name + "' has " +
           (body.material_model == BodyParameters::MaterialModel::isotropic
              ? values(body.young_modulus, body.poisson_ratio, body.density)
              : "an orthotropic material") +
           "; mesh file '" + body.mesh_file + "' " + others;
  }
} // namespace squeal
