// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_results_compare_h
#define squeal_results_compare_h

#include <squeal/results/signature.h>
#include <squeal/results/table.h>

#include <iosfwd>
#include <string>
#include <utility>
#include <vector>

namespace squeal
{
  /** One eigenpair of a run as the comparison sees it. */
  struct ComparedPair
  {
    enum class Growth
    {
      stable,
      open, /**< is_growth_open() */
      unstable
    };

    long long   index     = 0;
    double      frequency = 0.; /**< Hz */
    double      sigma     = 0.; /**< 1/s */
    std::string name;
    Growth      growth = Growth::stable;
    Signature   signature; /**< may be empty; of both runs in one order */
  };

  /**
   * Pairs of run A and run B that are the same mode, (position in @p a,
   * position in @p b): by the modal assurance criterion if all signatures are
   * there and of one length, else by name and nearest eigenvalue. Pairs that do
   * not fit (MAC below 0.3; another name and more than 10 % apart) are left
   * alone.
   */
  std::vector<std::pair<std::size_t, std::size_t>> match_pairs(
    const std::vector<ComparedPair> &a,
    const std::vector<ComparedPair> &b);

  /** What changed from run A to run B. */
  struct RunComparison
  {
    Table                    table; /**< matched pairs, then those alone */
    std::vector<std::string> new_instabilities;
    std::vector<std::string> vanished_instabilities;
    /** Pairs of which the mesh leaves open whether they grow in B, or in A
     * where B has none: neither new nor vanished. */
    std::vector<std::string> open_growth;
    bool                     by_shape = false; /**< matched by MAC */
    /** Why the signatures of both runs are not used, else empty. */
    std::string why_not_by_shape;
  };

  /**
   * Reads the results of two runs from their output directories
   * (eigenvalues.csv, or modes.csv if one of them has none), matches the pairs
   * of equal `point`, by their shapes whatever the order of the bodies, and
   * prints the table of frequency and sigma changes, the
   * parameters that differ, and new and vanished instabilities. A pair counts
   * as unstable if sigma exceeds its own error estimate and the mesh does not
   * leave that open. An instability is new where the pair is unstable in B and
   * not in A, or open there; it has vanished where the pair is unstable in A
   * and stable or missing in B. What would take more than 40 lines is summed up
   * in as many: how many pairs are equal, those that
   * differ most, the first of every list; with @p all everything is printed.
   * Throws InputError for what is missing or cannot be read.
   */
  RunComparison compare_runs(const std::string &directory_a,
                             const std::string &directory_b,
                             std::ostream      &out,
                             bool               all = false);
} // namespace squeal

#endif
