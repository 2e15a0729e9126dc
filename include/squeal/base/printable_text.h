// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_base_printable_text_h
#define squeal_base_printable_text_h

#include <string>

namespace squeal
{
  /** @p text as a terminal can show it and any program can read it: bytes that
   * are no UTF-8 and control characters, line ends and tabs apart, become '?'.
   * Messages cite what damaged files hold. */
  std::string printable_text(const std::string &text);
} // namespace squeal

#endif
