// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_output_open_signs_h
#define squeal_output_open_signs_h

#include <squeal/results/table.h>

#include <string>

namespace squeal
{
  /** Pairs of which the mesh does not tell whether they grow or decay: their
   * growth rate is no larger than its estimated error by the mesh. */
  struct OpenSigns
  {
    unsigned int n_growing = 0, n_decaying = 0;
    /** A clause with those that may grow fastest, or nothing: names,
     * frequencies, growth rates with that error. */
    std::string text;

    bool
    any() const
    {
      return n_growing + n_decaying > 0;
    }
  };

  /**
   * Of a table of pairs with the columns frequency_hz, sigma_per_s (1/s), name
   * and sigma_error_mesh_per_s. Rows without that error do not count, nor do
   * pairs whose error is rounding beside their frequency, as without damping
   * and friction.
   */
  OpenSigns open_signs(const Table &pairs);
} // namespace squeal

#endif
