// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_base_files_h
#define squeal_base_files_h

#include <functional>
#include <iosfwd>
#include <string>

namespace squeal
{
  /** What the names of unfinished files begin with. */
  constexpr const char *partial_file_prefix = ".part.";

  /** The name under which the file @p path is written until it is complete, in
   * the same folder. */
  std::string partial_file(const std::string &path);

  /**
   * A file that appears under its name only when it is complete.
   *
   * The content goes to temporary(), a hidden name in the same folder that
   * keeps the extension; commit() renames it to the target. Without a commit
   * the destructor removes what was written and the target stays as it was.
   * For writers that want a file name (MPI-IO, HDF5, a subprocess); text is
   * simpler with write_atomically().
   */
  class AtomicFile
  {
  public:
    explicit AtomicFile(const std::string &path);
    ~AtomicFile();
    AtomicFile(const AtomicFile &)            = delete;
    AtomicFile &operator=(const AtomicFile &) = delete;

    /** Name to write to. */
    const std::string &temporary() const;

    /** Moves the file to its name. Throws InputError if that fails. */
    void commit();

  private:
    std::string target;
    std::string temporary_name;
    bool        committed = false;
  };

  /**
   * Calls @p writer with a stream and gives the file its name @p path only
   * after every byte has reached the file system. Throws InputError (one line,
   * with path and the system's reason) when the file cannot be opened, written
   * or renamed; then, and when @p writer throws, nothing new is left behind and
   * an older file of that name is untouched. A @p path that exists and is no
   * regular file (/dev/stdout) is written to directly.
   */
  void write_atomically(const std::string                         &path,
                        const std::function<void(std::ostream &)> &writer);

  /**
   * The whole content of @p path. Throws InputError naming the path when it is
   * missing, a directory or unreadable.
   */
  std::string read_file(const std::string &path);
} // namespace squeal

#endif
