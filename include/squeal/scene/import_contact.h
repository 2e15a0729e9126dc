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
  } // namespace import
} // namespace squeal

#endif
