// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_base_base64_h
#define squeal_base_base64_h

#include <string>

namespace squeal
{
  /** @p bytes as base64 text (RFC 4648, with padding). */
  std::string base64(const std::string &bytes);
} // namespace squeal

#endif
