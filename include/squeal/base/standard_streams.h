// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_base_standard_streams_h
#define squeal_base_standard_streams_h

#include <string>

namespace squeal
{
  /**
   * Puts something unusable in the place of standard streams that the caller
   * has closed (">&-"). Else the first file that is opened would get their
   * number, and what is printed would land in it. To be called first in main(),
   * before a library opens files.
   */
  void occupy_closed_streams();

  /**
   * Flushes std::cout and throws InputError, one line with the system's reason,
   * where something that was printed has not arrived; @p remark is what follows
   * the reason. To be called after the last line.
   */
  void require_printed(const std::string &remark = "");
} // namespace squeal

#endif
