// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_base_inputs_read_h
#define squeal_base_inputs_read_h

#include <map>
#include <string>

namespace squeal
{
  /**
   * The content of an input file: a mesh, a matrix, a table, measured shapes.
   * As read_file(), and what was read is remembered for inputs_read().
   * Parameter files are read by read_file(): what they say is in the
   * parameters.
   */
  std::string read_input_file(const std::string &path);

  /** What tells one content from another: "1234 bytes, checksum
   * 0123456789abcdef". */
  std::string content_of(const std::string &bytes);

  /** Every input file that this process has read, by its absolute name: the
   * content_of() what was read last. */
  std::map<std::string, std::string> inputs_read();

  /** The content_of() the file @p path as this process has read it; a file that
   * it has not read yet is read now. "missing" where that is not possible. */
  std::string content_of_input(const std::string &path);
} // namespace squeal

#endif
