// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_base_scratch_directory_h
#define squeal_base_scratch_directory_h

#include <string>

namespace squeal
{
  /**
   * A folder for files that live as long as this object, such as the factors of
   * a matrix that do not fit into memory. Its hidden name is unique, so that
   * ranks and runs keep apart; the destructor removes it with all that is in
   * it.
   */
  class ScratchDirectory
  {
  public:
    /** Makes the folder in @p parent. Throws InputError where that fails. */
    explicit ScratchDirectory(const std::string &parent);
    ~ScratchDirectory();
    ScratchDirectory(const ScratchDirectory &)            = delete;
    ScratchDirectory &operator=(const ScratchDirectory &) = delete;

    const std::string &path() const;

  private:
    std::string directory;
  };

  /** Removes the folders that runs have left in @p parent that were killed.
   * Nobody else may be using them. */
  void remove_scratch_directories(const std::string &parent);
} // namespace squeal

#endif
