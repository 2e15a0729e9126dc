// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_results_dataset_55_h
#define squeal_results_dataset_55_h

#include <squeal/results/measured_shapes.h>

#include "universal_lines.h"

#include <optional>
#include <string>

namespace squeal
{
  /** Datasets 55 of a file that do not say that they are motions, by their
   * titles. */
  struct OtherDatasets
  {
    std::string skipped; /**< hold something else, which is named */
    std::string unsaid;  /**< taken as motions, do not say what they hold */
  };

  /** The shape of a dataset 55, behind its number, to its end. None where it
   * holds no displacements, velocities or accelerations; @p other gets its
   * title. Throws InputError "file:line: ..." for a dataset that is damaged or
   * of no mode. */
  std::optional<MeasuredShape> read_dataset_55(UniversalLines &lines,
                                               OtherDatasets  &other);
} // namespace squeal

#endif
