// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_scene_import_contact_h
#define squeal_scene_import_contact_h

#include <squeal/scene/import_numbering.h>
#include <squeal/scene/imported_model.h>

namespace squeal
{
  namespace import
  {
    /**
     * The sparse rows of a contact pattern read from @p file_name. Throws
     * InputError that names file, line and pair for an unknown that is not in
     * @p numbering, a coefficient given twice, a pair without a normal or a
     * sliding row, transverse rows for some pairs only, and a pair between two
     * bodies that a rigid translation would open, close or shear.
     */
    ImportedContact assemble_contact(const std::vector<ContactTerm> &terms,
                                     const Numbering                &numbering,
                                     const std::string              &file_name);

    /**
     * The same for each of the @p contacts that a scene names, with places,
     * sides and directions. Throws for a contact without pairs, one that is
     * not among them, and pairs without transverse rows or with directions
     * that are no frame.
     */
    std::vector<ImportedContact> assemble_contacts(
      const std::vector<ContactTerm> &terms,
      const std::vector<std::string> &contacts,
      const Numbering                &numbering,
      const std::string              &file_name);
  } // namespace import
} // namespace squeal

#endif
