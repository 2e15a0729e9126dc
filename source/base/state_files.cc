// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/base/input_file.h>
#include <squeal/base/sealed_file.h>
#include <squeal/base/state_files.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

namespace squeal
{
  namespace fs = std::filesystem;

  bool
  stays_inside(const std::string &name)
  {
    const fs::path path(name);
    return !path.empty() && !path.is_absolute() &&
           std::find(path.begin(), path.end(), "..") == path.end();
  }

  std::string
  state_text_head(const std::string &kind)
  {
    return "{\n \"format\": \"squeal " + kind + "\"";
  }



  bool
  is_state_file(const std::string &path, const std::string &kind)
  {
    // to open a pipe would wait for whoever fills it
    if (!input_file_fault(path).empty())
      return false;
    if (is_sealed_file(path, kind))
      return true;
    const std::string head = state_text_head(kind);
    std::string       start(head.size(), '\0');
    std::ifstream     in(path, std::ios::binary);
    return in.read(start.data(), start.size()) && start == head;
  }

  bool
  is_state_file(const std::string &path)
  {
    for (const char *kind : {state_kind::checkpoint,
                             state_kind::basis,
                             state_kind::rows,
                             state_kind::samples,
                             state_kind::changes})
      if (is_state_file(path, kind))
        return true;
    return false;
  }



  std::string
  set_aside(const std::string &path)
  {
    const fs::path from(path);
    for (unsigned int i = 1;; ++i)
      {
        const fs::path to =
          from.parent_path() / (from.stem().string() + ".kept" +
                                std::to_string(i) + from.extension().string());
        std::error_code error;
        if (fs::exists(to, error))
          continue;
        fs::rename(from, to, error);
        if (error)
          throw InputError("cannot rename '" + path + "': " + error.message());
        return to.string();
      }
  }
} // namespace squeal
