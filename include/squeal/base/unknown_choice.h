// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_base_unknown_choice_h
#define squeal_base_unknown_choice_h

#include <stdexcept>
#include <string>

namespace squeal
{
  /**
   * What stands behind a switch over all enumerators of @p what: the compiler
   * refuses a switch that leaves one out, and a value that is none of them ends
   * the run instead of computing what another one means.
   */
  [[noreturn]] inline void
  unknown_choice(const char *what)
  {
    throw std::logic_error(std::string("internal error: a ") + what +
                           " that nothing was written for");
  }
} // namespace squeal

#endif
