// SPDX-License-Identifier: LGPL-2.1-or-later
#include "abaqus_keywords.h"
#include "abaqus_reader.h"

#include <squeal/base/exceptions.h>

#include <squeal/parameters/text.h>

#include <cmath>
#include <optional>

// Parts, instances and materials of an Abaqus input file.

namespace squeal
{
  using dealii::Tensor;
  using import::upper_case;

  MeshFile
  AbaqusReader::read()
  {
    bool has_keyword = false;
    while (next_keyword())
      {
        has_keyword = true;
        take();
      }
    if (!has_keyword)
      throw InputError(text.name() +
                       " is no Abaqus input file: it has no keywords");
    for (const auto &[is_open, what] :
         {std::pair(!open_part.empty(), "*PART"),
          std::pair(!open_instance.empty(), "*INSTANCE"),
          std::pair(is_assembly_open, "*ASSEMBLY")})
      if (is_open)
        throw InputError(text.name() + " is truncated: it ends inside " + what);
    text.check_last_line_is_complete();
    finish();
    return std::move(file);
  }



  void
  AbaqusReader::take()
  {
    const std::string &name = keyword.name;
    if (const char *way = abaqus::way_out_of(name))
      text.fail_at(keyword.line, "*" + name + " is not read: " + way);
    if (has_option("INPUT"))
      text.fail_at(keyword.line,
                   "*" + name +
                     ", INPUT=... is not followed: put the files together");
    if (name == "PART")
      begin_part();
    else if (name == "END PART")
      end_part();
    else if (name == "ASSEMBLY")
      is_assembly_open = true;
    else if (name == "END ASSEMBLY")
      is_assembly_open = false;
    else if (name == "INSTANCE")
      begin_instance();
    else if (name == "END INSTANCE")
      end_instance();
    else if (name == "NODE")
      read_nodes();
    else if (name == "ELEMENT")
      read_elements();
    else if (name == "NSET" || name == "ELSET")
      read_set(name == "NSET");
    else if (name == "SURFACE")
      read_surface();
    else if (name == "SOLID SECTION")
      read_section();
    else if (name == "MATERIAL")
      {
        if (!materials
               .emplace(upper_case(needed("NAME")), file.materials.size())
               .second)
          text.fail_at(keyword.line,
                       "material " + prm::in_quotes(needed("NAME")) +
                         " is there twice");
        file.materials.push_back({needed("NAME"), "", 0., 0., 0.});
      }
    else if (name == "ELASTIC")
      read_elastic();
    else if (name == "DENSITY")
      read_density();
    else if (name == "TIE")
      read_tie();
    else if (name == "STEP")
      read_step();
    else if (name == "VISCOELASTIC")
      read_viscoelastic();
    else if (abaqus::changes_model(name))
      file.passed_over.insert("*" + name);
  }



  void
  AbaqusReader::begin_part()
  {
    if (!open_part.empty() || is_assembly_open)
      text.fail_at(keyword.line, "*PART within another one or the assembly");
    open_part = upper_case(needed("NAME"));
    if (parts.count(open_part) > 0)
      text.fail_at(keyword.line,
                   "part " + prm::in_quotes(needed("NAME")) +
                     " is there twice");
    current = &parts[open_part];
  }

  void
  AbaqusReader::end_part()
  {
    if (open_part.empty())
      text.fail_at(keyword.line, "*END PART without *PART");
    resolve_sections(*current);
    open_part.clear();
    current = &model;
  }

  void
  AbaqusReader::begin_instance()
  {
    if (!open_part.empty() || !open_instance.empty())
      text.fail_at(keyword.line, "*INSTANCE within a part or an instance");
    open_instance         = needed("NAME");
    const auto         it = parts.find(upper_case(needed("PART")));
    const unsigned int n  = keyword.line;
    if (it == parts.end())
      text.fail_at(n,
                   "there is no part " + prm::in_quotes(option("PART")) +
                     " before this line");
    if (instances.count(upper_case(open_instance)) > 0)
      text.fail_at(
        n, "instance " + prm::in_quotes(open_instance) + " is there twice");
    draft = it->second;
    read_place();
    current = &draft;
  }

  void
  AbaqusReader::read_place()
  {
    place = {};
    if (!next_data())
      return;
    if (fields.size() > 3)
      text.fail("a translation has 3 numbers; a rotation stands in the line "
                "behind it");
    for (unsigned int c = 0; c < 3; ++c)
      place.shift[c] = real(c, "translation");
    if (!next_data())
      return;
    auto &turn = place.turn;
    if (fields.size() != 7)
      text.fail("a rotation has 7 numbers: two points and an angle");
    for (unsigned int c = 0; c < 7; ++c)
      turn[c] = real(c, "rotation");
    if (turn[0] == turn[3] && turn[1] == turn[4] && turn[2] == turn[5])
      text.fail("the two points of the rotation's axis are the same");
    if (next_data())
      text.fail("an instance has a translation and a rotation, no third line");
  }

  void
  AbaqusReader::end_instance()
  {
    if (open_instance.empty())
      text.fail_at(keyword.line, "*END INSTANCE without *INSTANCE");
    // Its own nodes move with those of the part.
    place_instance(draft, place);
    resolve_sections(draft);
    Instance  &instance      = instances[upper_case(open_instance)];
    const auto first_node    = model.points.size(),
               first_element = model.elements.size();
    for (const auto &[number, i] : draft.number_of_node)
      instance.nodes[number] = first_node + i;
    for (const auto &[number, i] : draft.number_of_element)
      instance.elements[number] = first_element + i;
    add_instance(model, draft, open_instance);
    open_instance.clear();
    current = &model;
  }



  void
  AbaqusReader::read_section()
  {
    current->sections.push_back({needed("ELSET"),
                                 keyword.line,
                                 {},
                                 upper_case(needed("MATERIAL")),
                                 !option("ORIENTATION").empty()});
  }

  /** Sets may grow behind the section that names them. */
  void
  AbaqusReader::resolve_sections(AbaqusPart &part) const
  {
    for (auto &section : part.sections)
      {
        if (section.set.empty())
          continue;
        const auto it = part.element_sets.find(upper_case(section.set));
        if (it == part.element_sets.end())
          text.fail_at(section.line,
                       "there is no set of elements " +
                         prm::in_quotes(section.set));
        section.elements = it->second.members;
        section.set.clear();
      }
  }

  void
  AbaqusReader::read_elastic()
  {
    if (file.materials.empty())
      text.fail_at(keyword.line, "*ELASTIC without *MATERIAL");
    auto      &material = file.materials.back();
    const auto type     = upper_case(option("TYPE"));
    if (!type.empty() && type.compare(0, 3, "ISO") != 0)
      material.fault = "is not isotropic (*ELASTIC, TYPE=" + type + ")";
    if (!next_data())
      text.fail_at(keyword.line, "*ELASTIC without numbers");
    material.young_modulus = real(0, "Young's modulus");
    material.poisson_ratio = real(1, "Poisson's ratio");
    if (next_data() && material.fault.empty())
      material.fault = "depends on temperature";
  }

  void
  AbaqusReader::read_density()
  {
    if (file.materials.empty())
      text.fail_at(keyword.line, "*DENSITY without *MATERIAL");
    auto &material = file.materials.back();
    if (!next_data())
      text.fail_at(keyword.line, "*DENSITY without a number");
    material.density = real(0, "density");
    if (next_data() && material.fault.empty())
      material.fault = "depends on temperature";
  }

  void
  AbaqusReader::read_tie()
  {
    const std::string name = option("NAME");
    while (next_data())
      {
        if (data(0).empty() || data(1).empty())
          text.fail("a tie needs the names of two surfaces");
        file.ties.push_back({name, data(0), data(1)});
      }
  }

  void
  AbaqusReader::read_viscoelastic()
  {
    if (file.materials.empty())
      text.fail_at(keyword.line, "*VISCOELASTIC without *MATERIAL");
    if (auto &fault = file.materials.back().fault; fault.empty())
      fault = "depends on frequency (*VISCOELASTIC)";
  }

  /** Steps say what is analysed; their end is looked for, and what of the model
   * stands in them. */
  void
  AbaqusReader::read_step()
  {
    const unsigned int line = keyword.line;
    while (next_keyword())
      if (keyword.name == "END STEP")
        return;
      else if (abaqus::changes_model(keyword.name))
        file.passed_over.insert("*" + keyword.name);
    throw InputError(text.name() +
                     " is truncated: it ends inside the *STEP of line " +
                     std::to_string(line));
  }



  void
  AbaqusReader::finish()
  {
    if (model.points.empty() || model.elements.empty())
      throw InputError(
        text.name() + " is truncated or holds no mesh: it has no " +
        (model.points.empty() ? "nodes" : "elements") +
        (parts.empty() ? "" : "; its parts need an *ASSEMBLY of instances"));
    // Sums of large numbers and axes of rotation of almost no length.
    for (const auto &x : model.points)
      if (!std::isfinite(x.norm_square()))
        throw InputError(text.name() +
                         ": an instance is moved or turned to places that "
                         "are no numbers");
    resolve_sections(model);
    for (const auto &section : model.sections)
      if (section.is_oriented)
        {
          if (const auto it = materials.find(section.material);
              it != materials.end() && file.materials[it->second].fault.empty())
            file.materials[it->second].fault = "has axes of its own";
        }
    add_to_mesh(model, wanted, materials, file);
  }


  MeshFile
  read_abaqus_mesh(const std::string              &name,
                   const std::vector<std::string> &sets)
  {
    return AbaqusReader(name, sets).read();
  }
} // namespace squeal
