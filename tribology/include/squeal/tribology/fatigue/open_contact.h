// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_fatigue_open_contact_h
#define squeal_tribology_fatigue_open_contact_h

namespace squeal::tribology
{
  /** Share of the largest stress of a history up to which a value is what
   * rounding or the tolerance of a contact law leaves of none: it counts as 0,
   * the stress of an open contact. */
  constexpr double rest_of_none = 1e-6;
} // namespace squeal::tribology

#endif
