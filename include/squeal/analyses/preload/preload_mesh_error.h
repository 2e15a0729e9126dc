// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_analyses_preload_preload_mesh_error_h
#define squeal_analyses_preload_preload_mesh_error_h

#include <squeal/analyses/preload/preload_tables.h>
#include <squeal/model/model.h>

#include <optional>
#include <string>

namespace squeal
{
  class RunLog;

  /**
   * preload_mesh_error.csv: forces, stiffness and pressures of every pair under
   * the full load, the last of @p steps, beside those of the same mesh with one
   * degree less. The change bounds the error where elements converge; peaks at
   * an edge where the pressure is singular have no limit. Nothing where
   * `Discretization/Estimate error` is off, with elements of first degree, and
   * for imported matrices; where the lower degree has no steady sliding @p log
   * warns of it.
   */
  std::optional<Table> preload_mesh_error(const Parameters &p,
                                          const Model      &model,
                                          const LoadSteps  &steps,
                                          RunLog           &log,
                                          Timers           &timers);

  /** The largest changes in words; "mesh error not estimated" without. */
  std::string mesh_error_text(const std::optional<Table> &changes);
} // namespace squeal

#endif
