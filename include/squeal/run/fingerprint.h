// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_run_fingerprint_h
#define squeal_run_fingerprint_h

#include <squeal/parameters/parameters.h>

#include <string>
#include <utility>
#include <vector>

namespace squeal
{
  /**
   * Everything that a saved result depends on, by name: what decides whether a
   * later run may take it over. Checkpoints of transients, finished runs of
   * campaigns and bases of sweeps are kept with it.
   */
  class Fingerprint
  {
  public:
    /** What is saved. */
    enum class Purpose
    {
      motion, /**< of a transient or of one run of a campaign */
      basis   /**< of a sweep */
    };

    Fingerprint() = default;

    /**
     * All entries of @p parameters but those of left_out(), the content of every
     * file among them and of every other input file that this process has read,
     * the program down to its build, the kernels of OpenBLAS and the number of
     * ranks. What follows from
     * none of these is for the caller to add().
     */
    Fingerprint(const Parameters &parameters, const Purpose purpose);

    void add(const std::string &name, const std::string &value);

    /** One line for each, "name = value". */
    std::string text() const;

    /** How that of a run whose text() is @p other differs, in one line with the
     * name of the first that does: "Scene/Body pad/Density is 2500, it was
     * 2600"; empty where nothing differs. */
    std::string difference(const std::string &other) const;

    /** In how many lines they differ. */
    std::size_t n_differences(const std::string &other) const;

  private:
    std::vector<std::pair<std::string, std::string>> lines;
  };

  /** Entries that a saved result does not depend on. */
  struct LeftOut
  {
    std::string entry; /**< path of an entry, of any member of a family
                          ("<name>"), or of a section with '/' at its end */
    bool        of_motion, of_basis;
    std::string reason;
  };

  /** The one list of what may differ when a later run takes over what an
   * earlier one has saved; doc/resume.md shows it to users. Every entry that it
   * does not name counts. */
  const std::vector<LeftOut> &left_out();
} // namespace squeal

#endif
