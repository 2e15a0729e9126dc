// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_contact_imported_geometry_h
#define squeal_contact_imported_geometry_h

#include <squeal/contact/contact_geometry.h>
#include <squeal/scene/imported_model.h>

namespace squeal
{
  /**
   * Where a contact of an imported model touches: its point pairs with the
   * frames and rows of the file, on the unknowns of @p space. It has no pieces
   * of a face, which the file does not tell.
   */
  ContactGeometry imported_geometry(std::shared_ptr<const RowSpace> space,
                                    const ImportedContact          &contact);
} // namespace squeal

#endif
