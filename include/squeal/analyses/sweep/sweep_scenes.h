// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_analyses_sweep_sweep_scenes_h
#define squeal_analyses_sweep_sweep_scenes_h

#include <squeal/parameters/parameters.h>
#include <squeal/results/table.h>

#include <string>
#include <vector>

namespace squeal
{
  /** One scene of a sweep: the axes that are left enter its matrices by
   * factors only. */
  struct SweepScene
  {
    Parameters parameters; /**< without the axes below */
    /** Axes that change the matrices themselves, and their values here. */
    std::vector<Table::Column> columns;
    std::vector<double>        values;
    /** "pad_height_0.01": distinguishes files; empty where there is one scene
     * only. */
    std::string name;

    /** "pad_height = 0.01"; empty where there is one scene only. */
    std::string title() const;
    /** Puts the values into the first columns of a table. */
    void enter(Table &table) const;
  };

  /**
   * Takes axes with geometry, Poisson's ratios and the like out of a sweep:
   * one scene, with a mesh and matrices of its own, for each combination of
   * their values, along the axes neighbour after neighbour. Throws InputError
   * where no axis is left.
   */
  std::vector<SweepScene> sweep_scenes(const Parameters &parameters);
} // namespace squeal

#endif
