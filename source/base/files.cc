// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/base/files.h>
#include <squeal/base/input_file.h>
#include <squeal/base/scratch_directory.h>
#include <squeal/base/state_files.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <streambuf>
#include <vector>

#include <fcntl.h>
#include <fnmatch.h>
#include <unistd.h>

namespace squeal
{
  namespace fs = std::filesystem;

  namespace
  {
    const std::string manifest_name = manifest_file_name;
    const std::string manifest_head =
      "# squeal manifest 1: results of earlier runs, removed with Overwrite";

    /** Output buffer on a file descriptor that remembers why it failed: the
     * standard file stream loses the reason. */
    class DescriptorBuffer : public std::streambuf
    {
    public:
      explicit DescriptorBuffer(const int descriptor)
        : descriptor(descriptor)
      {
        setp(buffer.data(), buffer.data() + buffer.size());
      }

      int
      error() const
      {
        return error_number;
      }

    protected:
      int_type
      overflow(const int_type c) override
      {
        if (sync() != 0)
          return traits_type::eof();
        if (!traits_type::eq_int_type(c, traits_type::eof()))
          sputc(traits_type::to_char_type(c));
        return traits_type::not_eof(c);
      }

      int
      sync() override
      {
        const char *next = pbase();
        while (next < pptr() && error_number == 0)
          {
            const ssize_t n = ::write(descriptor, next, pptr() - next);
            if (n >= 0)
              next += n;
            else if (errno != EINTR)
              error_number = errno;
          }
        setp(buffer.data(), buffer.data() + buffer.size());
        return error_number == 0 ? 0 : -1;
      }

    private:
      int                         descriptor;
      int                         error_number = 0;
      std::array<char, (1 << 16)> buffer;
    };

    /** Writes through @p writer into @p path; errors name @p shown. */
    void
    write_directly(const std::string                         &path,
                   const std::string                         &shown,
                   const std::function<void(std::ostream &)> &writer)
    {
      const int descriptor =
        ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
      if (descriptor < 0)
        throw InputError("cannot write '" + shown +
                         "': " + std::strerror(errno));

      DescriptorBuffer buffer(descriptor);
      std::ostream     stream(&buffer);
      try
        {
          writer(stream);
        }
      catch (...)
        {
          ::close(descriptor);
          throw;
        }
      stream.flush();
      const int close_error = ::close(descriptor) == 0 ? 0 : errno;
      const int error = buffer.error() != 0 ? buffer.error() : close_error;
      if (error != 0)
        throw InputError("cannot write '" + shown +
                         "': " + std::strerror(error));
    }

    /** Where the bytes of @p path live: links are followed, so that a rename
     * replaces the file and not the link. */
    std::string
    resolved(const std::string &path)
    {
      std::error_code error;
      if (!fs::is_symlink(path, error))
        return path;
      const fs::path real = fs::weakly_canonical(path, error);
      return error ? path : real.string();
    }

    std::string
    partial_name(const fs::path &path)
    {
      return (path.parent_path() /
              (partial_file_prefix + path.filename().string()))
        .string();
    }

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
          fs::remove(partial_name(path), ignored);
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

    /** Whether a run left nothing but its log and what continues it. */
    bool
    holds_no_results(const fs::path &directory)
    {
      bool log_is_ours = false;
      for (const std::string &name : listed_files(directory))
        log_is_ours = log_is_ours || name == log_file_name;
      for (const auto &entry : fs::recursive_directory_iterator(directory))
        {
          const std::string name =
            entry.path().lexically_relative(directory).string();
          const bool is_unfinished =
            entry.path().filename().string().rfind(partial_file_prefix, 0) == 0;
          if (!entry.is_directory() && name != manifest_name &&
              !(name == log_file_name && log_is_ours) && !is_unfinished &&
              !is_state_file(entry.path().string()))
            return false;
        }
      return true;
    }
  } // namespace



  AtomicFile::AtomicFile(const std::string &path)
    : target(resolved(path))
    , temporary_name(partial_name(target))
  {
  }



  AtomicFile::~AtomicFile()
  {
    std::error_code ignored;
    if (!committed)
      fs::remove(temporary_name, ignored);
  }



  const std::string &
  AtomicFile::temporary() const
  {
    return temporary_name;
  }



  void
  AtomicFile::commit()
  {
    std::error_code error;
    fs::rename(temporary_name, target, error);
    if (error)
      throw InputError("cannot write '" + target + "': " + error.message());
    committed = true;
  }



  void
  write_atomically(const std::string                         &path,
                   const std::function<void(std::ostream &)> &writer)
  {
    std::error_code ignored;
    if (fs::is_directory(path, ignored))
      throw InputError("cannot write '" + path + "': Is a directory");
    // renaming onto a device would replace the device
    if (fs::exists(path, ignored) && !fs::is_regular_file(path, ignored))
      {
        write_directly(path, path, writer);
        return;
      }
    AtomicFile file(path);
    write_directly(file.temporary(), path, writer);
    file.commit();
  }



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
        fs::remove(partial_name(path), error);
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
