// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_model_doublets_h
#define squeal_model_doublets_h

#include <squeal/results/chart.h>
#include <squeal/results/table.h>

namespace squeal
{
  /** The two modes (n, m+) and (n, m-) of every doublet of the disc in a table
   * of modes, and what pad and support split them by: positive where the mode
   * with the antinode at the pad is the higher one. */
  Table doublet_table(const Table &modes);

  /** Split over the number of nodal diameters, a line for each number of nodal
   * circles. */
  Chart doublet_chart(const Table &doublets);
} // namespace squeal

#endif
