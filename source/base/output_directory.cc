// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/base/files.h>
#include <squeal/base/input_file.h>
#include <squeal/base/output_directory.h>
#include <squeal/base/scratch_directory.h>
#include <squeal/base/state_files.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <vector>

#include <fnmatch.h>

namespace squeal
{
  namespace fs = std::filesystem;

  namespace
  {
    const std::string manifest_name = manifest_file_name;
    const std::string manifest_head =
      "# squeal manifest 1: results of earlier runs, removed with Overwrite";

    /** Names in the manifest of @p directory that stay inside it; a file
     * edited by hand must not make us delete elsewhere. */
    std::vector<std::string>
    listed_files(const fs::path &directory)
    {
      std::vector<std::string> names;
      if (!input_file_fault((directory / manifest_name).string()).empty())
        return names;
      std::ifstream in(directory / manifest_name);
      for (std::string line; std::getline(in, line);)
        {
          const fs::path name = fs::path(line).lexically_normal();
          if (line.empty() || line[0] == '#' || name.is_absolute() ||
              name.begin() == name.end() || *name.begin() == "..")
            continue;
          names.push_back(name.string());
        }
      return names;
    }

    /** Throws InputError where the folder of the result @p name is reached
     * through a link out of @p directory: what lies there now need not be what
     * was written. */
    void
    require_inside(const fs::path &directory, const fs::path &name)
    {
      const fs::path  folder = (directory / name).parent_path();
      std::error_code error;
      const fs::path  whole = fs::weakly_canonical(directory, error);
      const fs::path  real  = fs::weakly_canonical(folder, error);
      if (std::mismatch(whole.begin(), whole.end(), real.begin(), real.end())
            .first != whole.end())
        throw InputError("the folder '" + folder.string() +
                         "' of earlier results is a symbolic link that leaves "
                         "the output directory, behind which nothing is "
                         "removed: remove the link or choose another Output "
                         "directory");
    }

    /** Removes the files @p names and the folders that become empty by it. */
    void
    remove_files(const fs::path                 &directory,
                 const std::vector<std::string> &names)
    {
      std::error_code    ignored;
      std::set<fs::path> folders;
      for (const std::string &name : names)
        {
          const fs::path path = directory / name;
          if (!fs::is_directory(path, ignored))
            fs::remove(path, ignored);
          fs::remove(partial_file(path.string()), ignored);
          for (fs::path folder = fs::path(name).parent_path(); !folder.empty();
               folder          = folder.parent_path())
            folders.insert(folder);
        }
      // deepest first; a folder that still holds something stays
      for (auto folder = folders.rbegin(); folder != folders.rend(); ++folder)
        fs::remove(directory / *folder, ignored);
    }

    /** Whether @p result is the file @p input, lies in a folder of that name, or
     * is, or lies in, one of those that * and ? in its path stand for. */
    bool
    is_read(const fs::path &input, const fs::path &result)
    {
      fs::path              folder;
      std::vector<fs::path> patterns;
      for (const fs::path &part : fs::absolute(input))
        if (part.empty()) // behind a slash at the end
          continue;
        else if (!patterns.empty() ||
                 part.string().find_first_of("*?") != std::string::npos)
          patterns.push_back(part);
        else
          folder /= part;
      std::error_code error;
      const fs::path  whole = fs::weakly_canonical(folder, error);
      auto [end, next] =
        std::mismatch(whole.begin(), whole.end(), result.begin(), result.end());
      if (end != whole.end())
        return false;
      for (const fs::path &pattern : patterns)
        if (next == result.end() ||
            ::fnmatch(pattern.c_str(), (next++)->c_str(), 0) != 0)
          return false;
      return true;
    }

    /** While it lives, a file that reaches the size limit makes a write fail
     * with a reason instead of ending the program. */
    class FileSizeLimitAsError
    {
    public:
      FileSizeLimitAsError()
        : former(std::signal(SIGXFSZ, SIG_IGN))
      {
      }
      ~FileSizeLimitAsError()
      {
        std::signal(SIGXFSZ, former);
      }
      FileSizeLimitAsError(const FileSizeLimitAsError &)            = delete;
      FileSizeLimitAsError &operator=(const FileSizeLimitAsError &) = delete;

    private:
      void (*const former)(int);
    };

    /** Whether a run left its log, what continues it and, where it was killed
     * before it listed its record, a part of its results, and nothing else. */
    bool
    holds_no_results(const fs::path &directory)
    {
      const auto names     = listed_files(directory);
      const auto is_listed = [&](const std::string &name) {
        return std::count(names.begin(), names.end(), name) > 0;
      };
      const bool was_killed = !is_listed(record_file_name);
      for (const auto &entry : fs::recursive_directory_iterator(directory))
        {
          const fs::path &path = entry.path();
          const auto      name = path.lexically_relative(directory).string();
          const bool      is_left =
            (was_killed || name == log_file_name) && is_listed(name);
          if (!entry.is_directory() && name != manifest_name && !is_left &&
              !is_state_file(path.string()) &&
              path.filename().string().rfind(partial_file_prefix, 0) != 0)
            return false;
        }
      return true;
    }
  } // namespace



  std::unique_ptr<FileLock>
  prepare_output_directory(const std::string &directory, const bool overwrite)
  {
    const std::string name = "output directory '" + directory + "'";
    if (directory.empty())
      throw InputError("the entry 'Output directory' is empty: name a folder");

    std::error_code error;
    if (fs::exists(directory, error) && !fs::is_directory(directory, error))
      throw InputError(name + " is a file: choose another Output directory");
    if (fs::is_symlink(directory, error) && !fs::exists(directory, error))
      throw InputError(name + " is a symbolic link to '" +
                       fs::read_symlink(directory, error).string() +
                       "', which does not exist: make that folder or choose "
                       "another Output directory");
    fs::create_directories(directory, error);
    if (error)
      throw InputError("cannot create " + name + ": " + error.message());

    const fs::path manifest = fs::path(directory) / manifest_name;
    auto           lock = std::make_unique<FileLock>(manifest.string(), name);

    bool may_start = overwrite;
    try
      {
        for (const std::string &listed : listed_files(directory))
          require_inside(directory, listed);
        may_start = may_start || holds_no_results(directory);
      }
    catch (const fs::filesystem_error &e)
      {
        throw InputError("cannot read " + name + ": " + e.code().message());
      }
    if (!may_start)
      {
        if (lock->is_new())
          fs::remove(manifest, error);
        throw InputError(name + " is not empty: set Overwrite = true or choose "
                                "another Output directory");
      }

    const FileSizeLimitAsError no_signal;
    // The list is emptied last, for the next run if this one is killed.
    remove_files(directory, listed_files(directory));
    remove_scratch_directories(directory);
    try
      {
        lock->rewrite(manifest_head);
      }
    catch (const InputError &)
      {
        if (lock->is_new())
          fs::remove(manifest, error);
        throw;
      }
    return lock;
  }



  void
  refuse_to_remove_inputs(const std::string &directory,
                          const NamedInputs &inputs)
  {
    std::error_code       error;
    std::vector<fs::path> results;
    for (const std::string &name : listed_files(directory))
      if (const fs::path path = fs::path(directory) / name;
          fs::exists(path, error))
        results.push_back(fs::weakly_canonical(path, error));
    for (const auto &[what, path] : inputs)
      for (const fs::path &result : results)
        if (!path.empty() && is_read(path, result))
          throw InputError(
            what + " reads '" + path + "', but " + result.filename().string() +
            " is a result of an earlier run, which this run "
            "would remove from its output directory '" +
            directory + "' first: choose another Output directory");
  }



  OutputDirectory::OutputDirectory(const std::string &directory,
                                   const bool         overwrite,
                                   const bool         is_root)
    : directory(directory)
    , is_root(is_root)
  {
    if (is_root)
      lock = prepare_output_directory(directory, overwrite);
  }



  const std::string &
  OutputDirectory::path() const
  {
    return directory;
  }



  std::string
  OutputDirectory::file(const std::string &name)
  {
    if (!stays_inside(name))
      throw InputError("the result '" + name +
                       "' would leave the output "
                       "directory: name it without '..' and without '/' in "
                       "front");
    require_in_place();
    const fs::path path = fs::path(directory) / name;
    if (!is_root || names.count(name) > 0)
      return path.string();

    std::error_code error;
    if (fs::exists(path, error))
      throw InputError("'" + path.string() +
                       "' was not written by squeal: move it away or choose "
                       "another Output directory");
    fs::create_directories(path.parent_path(), error);
    if (error)
      throw InputError("cannot create folder '" + path.parent_path().string() +
                       "': " + error.message());

    // listed before it is written: a run that is killed leaves no orphan
    lock->append(name);
    names.insert(name);
    return path.string();
  }



  std::string
  OutputDirectory::state_file(const std::string &name,
                              const std::string &kind,
                              const std::string &entry)
  {
    if (!stays_inside(name))
      throw InputError(entry + " = '" + name +
                       "' leaves the output directory: "
                       "give a name without '..' and without '/' in front");
    require_in_place();
    const fs::path  path = fs::path(directory) / name;
    std::error_code error;
    if (is_root && fs::exists(path, error) && !is_state_file(path, kind))
      throw InputError("'" + path.string() + "' is no " + kind +
                       " that squeal has written: move it away or change " +
                       entry);
    if (is_root)
      {
        fs::create_directories(path.parent_path(), error);
        // of a run that was killed while it wrote
        fs::remove(partial_file(path.string()), error);
      }
    return path.string();
  }



  bool
  OutputDirectory::is_owned() const
  {
    return !lock || lock->is_held();
  }



  void
  OutputDirectory::require_in_place() const
  {
    if (lock && !lock->is_in_place())
      throw InputError("the output directory '" + directory +
                       "' was removed or replaced during the run, which gives "
                       "no results: start it again");
  }



  void
  OutputDirectory::discard()
  {
    // What lies under the name of another directory is another run's.
    if (is_root && lock->is_in_place())
      {
        names.erase(log_file_name);
        remove_files(directory, {names.begin(), names.end()});
      }
    names.clear();
  }



  const std::set<std::string> &
  OutputDirectory::files() const
  {
    return names;
  }
} // namespace squeal
