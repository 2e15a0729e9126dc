// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_results_frequency_unit_h
#define squeal_results_frequency_unit_h

#include <string>

namespace squeal
{
  /** What charts show frequencies in: kHz for brakes, Hz for lumped scenes. */
  struct FrequencyUnit
  {
    /** @param highest frequency of the chart, Hz; 0 if it shows none. */
    explicit FrequencyUnit(const double highest)
      : factor(highest > 0. && highest < 1000. ? 1. : 1e-3)
      , name(factor == 1. ? "Hz" : "kHz")
      , label("frequency in " + name)
    {
    }

    double      factor; /**< from Hz */
    std::string name;   /**< "Hz" or "kHz" */
    std::string label;  /**< of an axis */
  };
} // namespace squeal

#endif
