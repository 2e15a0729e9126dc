// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_results_history_times_h
#define squeal_results_history_times_h

#include <squeal/results/hdf5_file.h>

#include <string>
#include <vector>

namespace squeal
{
  /**
   * Throws InputError where a time of a contact history, s, is no number or not
   * above the one before, or where the pairs have unlike times. @p pairs are their
   * names, none where there is one without a name. All times are looked at,
   * once: what is read later may be a part of them, and where that begins is
   * found by bisection, which tells nothing of the others.
   */
  void check_times(const Hdf5File &file, const std::vector<std::string> &pairs);
} // namespace squeal

#endif
