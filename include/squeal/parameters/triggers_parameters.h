// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_parameters_triggers_parameters_h
#define squeal_parameters_triggers_parameters_h

#include <string>
#include <vector>

namespace squeal
{
  /** Blows beside a stable steady sliding, of "Analysis = triggers", section
   * "Triggers". */
  struct TriggersParameters
  {
    std::vector<std::string> points;   /**< of `Measurement`; empty: all */
    std::vector<double>      impulses; /**< N s, the ladder */
    double                   duration  = 2e-4;   /**< s, of the half sine */
    double                   tolerance = 1e-2;   /**< of the threshold */
    double                   window    = 2e-3;   /**< s */
    double                   hold      = 1.2e-2; /**< s, see declaration */
    double                   longest   = 0.3;    /**< s, of a motion */
    double                   edge_time = 0.1; /**< s, of the one on the edge */
    unsigned int             halvings  = 8;   /**< at each restart of it */
  };
} // namespace squeal

#endif
