// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_analyses_operating_matrix_operating_chart_h
#define squeal_analyses_operating_matrix_operating_chart_h

#include <squeal/results/plotter.h>
#include <squeal/results/table.h>

namespace squeal
{
  /** The matrix of operating_matrix.csv: a panel for each direction and speed,
   * in it pressure to the right and temperature upwards, the growth rate of the
   * loudest pair as colour (white: none is unstable), its frequency in kHz
   * above its growth rate in 1/s. */
  Drawing operating_chart(const Table &loudest);
} // namespace squeal

#endif
