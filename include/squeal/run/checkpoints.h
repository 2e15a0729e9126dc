// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_run_checkpoints_h
#define squeal_run_checkpoints_h

#include <squeal/base/named_numbers.h>
#include <squeal/run/fingerprint.h>

#include <optional>
#include <string>
#include <vector>

namespace squeal
{
  /**
   * The checkpoints of one run: the last one, `checkpoint.h5`, and the one
   * before it, `checkpoint_before.h5`. Each has its name only when it is whole,
   * and carries a checksum and the fingerprint of its run. A file that is
   * damaged or of another run is never used, overwritten or deleted: it is
   * given another name (see set_aside()).
   */
  class Checkpoints
  {
  public:
    /** What is there for a run to go on from. */
    struct Found
    {
      std::string                 file;  /**< empty: none */
      std::optional<NamedNumbers> state; /**< of that file */
      /** One line for each file that was put aside, with the reason. */
      std::vector<std::string> notes;
    };

    /** @p path of the last one; that of the one before follows from it. @p way
     * to start anew, in words, for texts of errors. */
    Checkpoints(const std::string &path,
                const Fingerprint &fingerprint,
                const std::string &way = "set Transient/Resume = false");

    /** The newest whole one of this run. Throws InputError, and leaves the
     * files as they are, where there are damaged ones and no whole one of this
     * run.
     * Without @p resume nothing is looked at and all files are put aside. */
    Found find(const bool resume = true) const;

    /** The group @p group of the state in the newest whole one of @p path, of
     * whatever run; empty where there is none. What this returns is good to
     * compute with where that is right for any run. All ranks get what the root
     * (@p is_root) reads. Collective. */
    static NamedNumbers group_of_newest(const std::string &path,
                                        const std::string &group,
                                        const bool         is_root);

    /** Makes @p state the last one. Throws InputError. */
    void write(const NamedNumbers &state) const;

    /** Removes both; for a run that has found() and has ended. */
    void remove() const;

    /** The name of the last one. */
    const std::string &path() const;

    /** The name of the one before the last one @p path. */
    static std::string name_before(const std::string &path);

  private:
    const std::string last, before;
    const Fingerprint fingerprint;
    const std::string way_to_start_anew;
  };
} // namespace squeal

#endif
