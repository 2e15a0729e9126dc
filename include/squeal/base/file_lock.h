// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_base_file_lock_h
#define squeal_base_file_lock_h

#include <string>

namespace squeal
{
  /**
   * The one owner of a file while it lives (flock). The kernel gives the lock
   * back when the process ends, however it ends: a file that a dead process has
   * left never stands in the way. Children that start another program do not
   * inherit it. Over NFS the lock is the server's and holds between machines;
   * a file system without locks gives none, see is_held().
   */
  class FileLock
  {
  public:
    /** Makes the file @p path if it is missing. Throws InputError, "<what> is
     * in use by process 12 on host", where another one owns it, and one with
     * the system's reason where the file cannot be opened. */
    FileLock(const std::string &path, const std::string &what);
    ~FileLock();
    FileLock(const FileLock &)            = delete;
    FileLock &operator=(const FileLock &) = delete;

    /** False where the file system has no locks. */
    bool is_held() const;

    /** Whether the file was not there before. */
    bool is_new() const;

    /** Replaces what is in the file by @p head and a line that names the owner.
     * Throws InputError. */
    void rewrite(const std::string &head) const;

    /** Writes @p line at the end of the file that is locked, whatever lies under
     * its name by now. Throws InputError. */
    void append(const std::string &line) const;

    /** False once the file was removed or another one was put under its name:
     * that one is not locked, and may be another process's own. */
    bool is_in_place() const;

  private:
    const std::string path;
    int               descriptor = -1;
    bool              held       = true;
    bool              made       = false;
  };
} // namespace squeal

#endif
