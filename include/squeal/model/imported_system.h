// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_model_imported_system_h
#define squeal_model_imported_system_h

#include <squeal/contact/contact_terms.h>
#include <squeal/scene/imported_model.h>

namespace squeal
{
  /** The parts of an imported model on rows of their own, and its mass. */
  LinearizedSystem imported_parts(const ImportedModel &model);

  /** Sum of the parts of role mass, with the factors of the files' scene. */
  std::shared_ptr<const LinearOperator> imported_mass(
    const ImportedModel &model);

  /** The same with the factors of @p scene. */
  std::shared_ptr<const LinearOperator> imported_mass(
    const ImportedModel   &model,
    const SceneParameters &scene);

  /** Rigid translations of the unknowns along x, y, z; of one body where
   * @p body is given. Zero without names of unknowns. */
  Block translations(const ImportedModel &model, const std::string &body = "");

  /**
   * Adds the contact of an imported model, closed: the point pairs of its
   * pattern, or those of the scene's contacts as springs, slipping or sticking
   * as a whole unless @p states are given, one list a contact.
   */
  void add_imported_contact(const SceneParameters            &scene,
                            const ImportedModel              &model,
                            const std::vector<ContactStates> &states,
                            LinearizedSystem                 &system);

  /** Enters the contacts of the scene, cut open. */
  void add_open_contacts(const ImportedModel &model, LinearizedSystem &system);
} // namespace squeal

#endif
