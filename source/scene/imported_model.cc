// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>

#include <squeal/scene/import_contact.h>
#include <squeal/scene/import_numbering.h>
#include <squeal/scene/import_tables.h>
#include <squeal/scene/imported_model.h>

#include <algorithm>
#include <cmath>

namespace squeal
{
  namespace
  {
    using import::Numbering;
    using Role = MatrixPartParameters::Role;

    bool
    is_stiffness(const ImportedMatrix &part)
    {
      return part.role == Role::stiffness || part.role == Role::normal_contact;
    }

    void
    check_roles(const SceneParameters &scene)
    {
      const auto has = [&](const Role role) {
        return std::any_of(
          scene.matrix_parts.begin(),
          scene.matrix_parts.end(),
          [role](const auto &part) { return part.role == role; });
      };
      if (!has(Role::mass))
        throw InputError("Scene/Matrix parts: no part has the role mass");
      if (!has(Role::stiffness))
        throw InputError("Scene/Matrix parts: no part has the role stiffness");
    }

    /** Bodies and positions by the node table. */
    void
    place_unknowns(const std::vector<NodeTableRow> &table,
                   const Numbering                 &numbering,
                   ImportedModel                   &model)
    {
      model.body_of.assign(model.n_dofs, 0);
      if (table.empty())
        {
          model.bodies = {"model"};
          return;
        }
      model.positions.resize(model.n_dofs);
      for (const NodeTableRow &row : table)
        {
          const unsigned int dof = numbering.find(row.label).value();
          const auto         body =
            std::find(model.bodies.begin(), model.bodies.end(), row.body);
          model.body_of[dof]   = body - model.bodies.begin();
          model.positions[dof] = row.position;
          if (body == model.bodies.end())
            model.bodies.push_back(row.body);
        }
    }

    /** Sum over the parts for which @p counts holds of factor times diagonal. */
    template <typename Predicate>
    std::vector<double>
    diagonal(const ImportedModel &model, const Predicate &counts)
    {
      std::vector<double> sum(model.n_dofs, 0.);
      for (const ImportedMatrix &part : model.parts)
        if (counts(part))
          for (std::size_t k = 0; k < part.values.size(); ++k)
            if (part.rows[k] == part.columns[k])
              sum[part.rows[k]] += part.factor * part.values[k];
      return sum;
    }

    void
    check_diagonals(const ImportedModel &model, const Numbering &numbering)
    {
      const std::vector<double> mass = diagonal(
        model, [](const auto &part) { return part.role == Role::mass; });
      std::vector<double> stiffness = diagonal(model, is_stiffness);
      std::vector<const ImportedContact *> contacts = {&model.contact};
      for (const ImportedContact &contact : model.contacts)
        contacts.push_back(&contact);
      for (const ImportedContact *contact : contacts)
        for (const ImportedContact::Row &row : contact->normal)
          for (const auto &[dof, weight] : row)
            stiffness[dof] += std::abs(weight);
      for (unsigned int i = 0; i < model.n_dofs; ++i)
        {
          const std::string name =
            numbering.describe(model.original_numbers[i]);
          if (mass[i] < 0.)
            throw InputError("Scene/Matrix parts: " + name +
                             " has a negative mass on the diagonal");
          if (mass[i] == 0. && stiffness[i] == 0.)
            throw InputError(
              "Scene/Matrix parts: " + name +
              " has neither mass nor stiffness of its own; it is unconnected "
              "or a Lagrange multiplier (doc/import.md)");
        }
    }

    /** Unknowns with a huge number on the diagonal of a stiffness part. */
    std::vector<bool>
    find_held(const ImportedModel &model)
    {
      std::vector<bool> is_held(model.n_dofs, false);
      for (const ImportedMatrix &part : model.parts)
        if (is_stiffness(part))
          for (std::size_t k = 0; k < part.values.size(); ++k)
            if (part.rows[k] == part.columns[k] &&
                std::abs(part.values[k]) >= held_stiffness)
              is_held[part.rows[k]] = true;
      return is_held;
    }

    /** The names of loads or contacts. */
    template <typename Section>
    std::vector<std::string>
    names_of(const std::vector<Section> &sections)
    {
      std::vector<std::string> result;
      for (const Section &section : sections)
        result.push_back(section.name);
      return result;
    }

    /** Loads and far faces of the node table. */
    void
    take_columns(const std::vector<NodeTableRow> &table,
                 const Numbering                 &numbering,
                 const SceneParameters           &scene,
                 ImportedModel                   &model)
    {
      model.loads.assign(scene.loads.size(),
                         std::vector<double>(model.n_dofs, 0.));
      model.far_faces.assign(scene.contacts.size(),
                             std::vector<double>(model.n_dofs, 0.));
      for (const NodeTableRow &row : table)
        {
          const unsigned int dof = numbering.find(row.label).value();
          for (std::size_t l = 0; l < row.forces.size(); ++l)
            model.loads[l][dof] = row.forces[l];
          for (std::size_t c = 0; c < row.far_weights.size(); ++c)
            model.far_faces[c][dof] = row.far_weights[c];
        }
      for (std::size_t c = 0; c < model.far_faces.size(); ++c)
        if (table.empty() || std::isnan(table.front().far_weights[c]))
          model.far_faces[c].clear();
    }

    template <typename Rows>
    void
    remove_from_rows(Rows                            &rows,
                     const std::vector<unsigned int> &new_numbers,
                     const unsigned int               n_new)
    {
      for (ImportedContact::Row &row : rows)
        {
          ImportedContact::Row kept;
          for (const auto &[dof, weight] : row)
            if (new_numbers[dof] < n_new)
              kept.emplace_back(new_numbers[dof], weight);
          row = std::move(kept);
        }
    }

    void
    remove_from_contact(const std::vector<unsigned int> &new_numbers,
                        const unsigned int               n_new,
                        ImportedContact                 &contact)
    {
      for (auto *rows :
           {&contact.normal, &contact.sliding, &contact.transverse})
        remove_from_rows(*rows, new_numbers, n_new);
      for (auto *sides : {&contact.target, &contact.source})
        for (auto &rows : *sides)
          remove_from_rows(rows, new_numbers, n_new);
    }

    template <typename T>
    void
    keep(std::vector<T> &values, const std::vector<unsigned int> &kept)
    {
      if (values.empty())
        return;
      std::vector<T> result;
      for (const unsigned int i : kept)
        result.push_back(values[i]);
      values = std::move(result);
    }

    void
    remove_held(ImportedModel &model)
    {
      const std::vector<bool>   is_held = find_held(model);
      std::vector<unsigned int> new_numbers(model.n_dofs, model.n_dofs);
      for (unsigned int i = 0; i < model.n_dofs; ++i)
        if (is_held[i])
          model.held.push_back(i);
        else
          {
            new_numbers[i] = model.original_numbers.size();
            model.original_numbers.push_back(i);
          }
      if (model.held.empty())
        return;
      if (model.original_numbers.empty())
        throw InputError("Scene/Matrix parts: every unknown is held by a huge "
                         "diagonal stiffness");
      model.n_dofs = model.original_numbers.size();
      for (ImportedMatrix &part : model.parts)
        import::renumber_entries(part, new_numbers, model.n_dofs);
      remove_from_contact(new_numbers, model.n_dofs, model.contact);
      for (ImportedContact &contact : model.contacts)
        remove_from_contact(new_numbers, model.n_dofs, contact);
      for (auto *columns : {&model.loads, &model.far_faces})
        for (auto &column : *columns)
          keep(column, model.original_numbers);
      keep(model.labels, model.original_numbers);
      keep(model.positions, model.original_numbers);
      keep(model.body_of, model.original_numbers);
    }

    /** Lower triangle of (A + sign A^T)/2 of sorted entries. */
    Triplets
    lower_part(const ImportedMatrix &matrix, const double sign)
    {
      // Mirrored entries fall on the same place and add up.
      Triplets lower;
      for (std::size_t k = 0; k < matrix.values.size(); ++k)
        {
          const int    row    = static_cast<int>(matrix.rows[k]);
          const int    column = static_cast<int>(matrix.columns[k]);
          const double half   = .5 * matrix.values[k];
          if (row > column)
            lower.add(row, column, half);
          else if (row < column)
            lower.add(column, row, sign * half);
          else if (sign > 0.)
            lower.add(row, row, 2. * half);
        }
      return lower;
    }
  } // namespace



  ImportedModel
  read_imported_model(const SceneParameters &scene)
  {
    check_roles(scene);
    ImportedModel model;
    for (const MatrixPartParameters &part : scene.matrix_parts)
      model.parts.push_back(read_matrix(part));

    std::vector<NodeTableRow> table;
    if (!scene.node_table_file.empty())
      table = read_node_table(
        scene.node_table_file, names_of(scene.loads), names_of(scene.contacts));
    const Numbering numbering(model.parts, table, scene.node_table_file);
    for (ImportedMatrix &part : model.parts)
      numbering.renumber(part);
    model.n_dofs = numbering.n_dofs();
    model.labels = numbering.labels();
    place_unknowns(table, numbering, model);
    take_columns(table, numbering, scene, model);
    if (!scene.contacts.empty())
      model.contacts = import::assemble_contacts(
        read_contact_pattern(scene.contact_pattern_file, true),
        names_of(scene.contacts),
        numbering,
        scene.contact_pattern_file);
    else if (!scene.contact_pattern_file.empty())
      model.contact = import::assemble_contact(
        read_contact_pattern(scene.contact_pattern_file),
        numbering,
        scene.contact_pattern_file);
    remove_held(model);
    check_diagonals(model, numbering);
    return model;
  }



  Triplets
  lower_symmetric_part(const ImportedMatrix &matrix)
  {
    return lower_part(matrix, 1.);
  }



  Triplets
  lower_skew_part(const ImportedMatrix &matrix)
  {
    return lower_part(matrix, -1.);
  }
} // namespace squeal
