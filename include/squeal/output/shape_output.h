// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_output_shape_output_h
#define squeal_output_shape_output_h

#include <squeal/model/mode_solution.h>
#include <squeal/output/cea_quantities.h>
#include <squeal/run/run_context.h>

namespace squeal
{
  /** Writes every mode of the band for ParaView; returns the name of the first
   * file. */
  std::string write_mode_shapes(RunContext         &context,
                                const Model        &model,
                                const ModeSolution &solution);

  /** Writes the complex pairs (all, or the unstable ones) for ParaView and a
   * picture of every unstable one; returns the name of the file to open: that
   * of the most unstable pair, or the first. */
  std::string write_pair_shapes(RunContext           &context,
                                const Model          &model,
                                const ComplexPairs   &pairs,
                                const PairQuantities &quantities,
                                HtmlReport           &report);
} // namespace squeal

#endif
