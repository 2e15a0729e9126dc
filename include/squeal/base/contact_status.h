// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_base_contact_status_h
#define squeal_base_contact_status_h

#include <cstdint>

namespace squeal
{
  /** What a contact node does; the numbers are those of history files. */
  enum class ContactStatus : std::uint8_t
  {
    open  = 0,
    stick = 1,
    slip  = 2
  };
} // namespace squeal

#endif
