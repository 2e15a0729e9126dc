// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_base_state_files_h
#define squeal_base_state_files_h

#include <string>

namespace squeal
{
  /** Whether @p name stays below the folder that it is relative to: no absolute
   * name, no way up. */
  bool stays_inside(const std::string &name);

  /**
   * What a later run continues from. By their first bytes squeal tells these
   * files from results and from those of others: HDF5 files begin as
   * sealed_file.h says, texts with state_text_head().
   */
  namespace state_kind
  {
    constexpr const char *checkpoint = "checkpoint";
    constexpr const char *basis      = "basis";
    constexpr const char *rows       = "campaign rows";
    constexpr const char *samples    = "samples of a history";
    constexpr const char *changes    = "changes of a history";
  } // namespace state_kind

  /** How a text file (JSON) of a @p kind begins. */
  std::string state_text_head(const std::string &kind);

  /** Whether @p path is a file that squeal has made as one of this @p kind,
   * damaged or not. */
  bool is_state_file(const std::string &path, const std::string &kind);

  /** The same for any kind. */
  bool is_state_file(const std::string &path);

  /** Gives the file @p path another name beside it, "name.kept1.h5" or the first
   * number that is free, and returns that. Throws InputError. */
  std::string set_aside(const std::string &path);
} // namespace squeal

#endif
