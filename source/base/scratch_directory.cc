// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/base/files.h>
#include <squeal/base/scratch_directory.h>

#include <cerrno>
#include <cstring>
#include <filesystem>

#include <stdlib.h>

namespace squeal
{
  namespace fs = std::filesystem;

  namespace
  {
    const std::string scratch_prefix =
      std::string(partial_file_prefix) + "scratch.";

    /** What mkdtemp() puts its own characters in place of. */
    const std::string unknown_characters(6, 'X');
  } // namespace



  ScratchDirectory::ScratchDirectory(const std::string &parent)
    : directory(
        (fs::path(parent) / (scratch_prefix + unknown_characters)).string())
  {
    if (!::mkdtemp(directory.data()))
      throw InputError("cannot create a folder in '" + parent +
                       "': " + std::strerror(errno));
  }

  ScratchDirectory::~ScratchDirectory()
  {
    std::error_code ignored;
    fs::remove_all(directory, ignored);
  }

  const std::string &
  ScratchDirectory::path() const
  {
    return directory;
  }



  void
  remove_scratch_directories(const std::string &parent)
  {
    std::error_code ignored;
    for (const auto &entry : fs::directory_iterator(parent, ignored))
      if (entry.is_directory(ignored) && !entry.is_symlink(ignored) &&
          entry.path().filename().string().rfind(scratch_prefix, 0) == 0)
        fs::remove_all(entry.path(), ignored);
  }
} // namespace squeal
