// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_base_output_directory_h
#define squeal_base_output_directory_h

#include <squeal/base/file_lock.h>

#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace squeal
{
  /** Names in an output directory that are no results: the list of the files
   * written, the log, and the record that a run writes when it ends. */
  constexpr const char *manifest_file_name = ".squeal_files";
  constexpr const char *log_file_name      = "run.log";
  constexpr const char *record_file_name   = "run.json";

  /**
   * Makes @p directory ready for a new run: creates it if missing, makes this
   * process its one owner, and with @p overwrite removes the files that earlier
   * runs listed in its manifest `.squeal_files`, never any other file. Throws
   * InputError if another process owns it, if the directory holds results or
   * foreign files and @p overwrite is false, if a file is in its place, or if it
   * cannot be written; then nothing has been removed. What a run leaves that
   * ended before its first result (a log, nothing else) does not count as
   * results, nor do files that a later run continues from. The manifest carries
   * the lock.
   */
  std::unique_ptr<FileLock> prepare_output_directory(
    const std::string &directory,
    bool               overwrite);

  /** Input files or folders of a run: what the user is told of each, "the entry
   * 'Scene/Body pad/Mesh file'", and its path. */
  using NamedInputs = std::vector<std::pair<std::string, std::string>>;

  /**
   * Throws InputError if one of the @p inputs, or a file in a folder of them, is
   * a result that the manifest of @p directory lists: preparing the directory
   * would remove it before the run reads it. Changes nothing.
   */
  void refuse_to_remove_inputs(const std::string &directory,
                               const NamedInputs &inputs);

  /**
   * The directory of one run. Every result asks it for its path, so that the
   * manifest knows what a later run may remove. On ranks other than the root
   * it only composes paths: nothing is created or listed.
   */
  class OutputDirectory
  {
  public:
    /** Prepares the directory (see prepare_output_directory()). */
    OutputDirectory(const std::string &directory,
                    bool               overwrite,
                    bool               is_root = true);

    /** The directory as given. */
    const std::string &path() const;

    /**
     * Path of the result @p name, which may contain folders
     * ("plots/spectrum.png"): they are created, and the name is added to the
     * manifest. Throws InputError if a file of that name is there that squeal
     * has not written, if the name leaves the directory, or as
     * require_in_place().
     */
    std::string file(const std::string &name);

    /**
     * Path of a file of a @p kind (see state_files.h) that outlives the run. It is no
     * result: the manifest does not list it. Throws InputError, naming the
     * parameter @p entry, if the name leaves the directory or if a file of that
     * name is there that squeal has not written as one of this kind.
     */
    std::string state_file(const std::string &name,
                           const std::string &kind,
                           const std::string &entry);

    /** False where the file system has no locks and a second process would not
     * be noticed. */
    bool is_owned() const;

    /** Throws InputError if the directory was removed or another one was put in
     * its place since it was prepared: nobody owns that one, or another run
     * does. file() and state_file() ask it as well. */
    void require_in_place() const;

    /** Removes what this run has written but for its log: for a run that
     * fails. In a directory that is no longer its own it removes nothing. */
    void discard();

    /** Names given out so far, sorted. */
    const std::set<std::string> &files() const;

  private:
    std::string               directory;
    bool                      is_root;
    std::unique_ptr<FileLock> lock; /**< on the root */
    std::set<std::string>     names;
  };
} // namespace squeal

#endif
