// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_base_input_file_h
#define squeal_base_input_file_h

#include <string>

namespace squeal
{
  /**
   * What keeps @p path from being read as a file, as the end of a sentence
   * ("no such file", "is a directory", "is a pipe (FIFO), not a file"); empty
   * where it is a regular file. To open a pipe or a socket can wait for ever,
   * and a device may have no end: whoever opens a file for reading asks first.
   */
  std::string input_file_fault(const std::string &path);

  /** Throws InputError, one line with the path, where there is such a fault. */
  void require_input_file(const std::string &path);
} // namespace squeal

#endif
