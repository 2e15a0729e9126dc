// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_base_program_id_h
#define squeal_base_program_id_h

#include <string>

namespace squeal
{
  /** What tells the running executable from any that was compiled from other
   * sources or otherwise: the number that the linker makes of its content
   * (build id), or its checksum where it has none. */
  std::string program_id();
} // namespace squeal

#endif
