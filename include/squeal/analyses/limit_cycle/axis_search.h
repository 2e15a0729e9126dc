// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_analyses_limit_cycle_axis_search_h
#define squeal_analyses_limit_cycle_axis_search_h

#include <squeal/analyses/limit_cycle/branch_models.h>
#include <squeal/base/named_numbers.h>
#include <squeal/cycle/cycle_branch.h>
#include <squeal/results/table.h>

#include <complex>
#include <optional>
#include <string>
#include <vector>

namespace squeal
{
  class RunContext;

  /** What a search at one value of the axis has ended with. */
  struct AxisSearch
  {
    double       parameter = 0.;
    bool         slides    = true; /**< there is steady sliding */
    unsigned int n_growing = 0;    /**< pairs of the band that grow about it */
    std::complex<double> pair; /**< 1/s, that it has started from; 0: none */
    CycleStatus          found = CycleStatus::not_converged;
    /** Of the motion that the search has followed. */
    double rms_normal = 0., line = 0., repetition = 0.; /**< N, Hz */
    /** From 1 on, of the cycle that was found; 0: none was. */
    unsigned int branch        = 0;
    bool         starts_branch = false; /**< no branch had come to it */

    /** "periodic", "no growing pair", ... */
    std::string outcome() const;

    NamedNumbers      memory() const;
    static AxisSearch from_memory(const NamedNumbers &memory);
  };

  /** All branches over an axis, that of the scene's own value first where it is
   * there. */
  struct BranchDiagram
  {
    std::vector<CycleBranch> branches;
    std::vector<AxisSearch>  searches; /**< by their values */
  };

  /**
   * The cycle that the growing pairs of the scene lead to at @p coordinate: of
   * the pair that was asked for, with `Every growing pair` of all until one
   * leads to a cycle. Fills all of @p search but its parameter and what it says
   * of branches.
   * Empty where none is found.
   */
  std::optional<CycleResult> search_at(RunContext         &context,
                                       const BranchModels &models,
                                       const double        coordinate,
                                       AxisSearch         &search);

  Table search_table(const std::vector<AxisSearch> &searches);

  /** "9 searches along the axis: no growing pair: 3, periodic: 6"; empty
   * without any. */
  std::string searches_sentence(const std::vector<AxisSearch> &searches);
} // namespace squeal

#endif
