// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_driver_entry_units_h
#define squeal_driver_entry_units_h

#include <string>

namespace squeal
{
  /** The declared unit of the entry that a number of a sweep or a campaign is
   * in, "Pa" of "Scene/Body pad/Young modulus"; empty where it has none. */
  std::string unit_of_entry(const std::string &path);
} // namespace squeal

#endif
