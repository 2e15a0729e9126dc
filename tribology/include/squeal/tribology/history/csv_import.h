// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_history_csv_import_h
#define squeal_tribology_history_csv_import_h

#include <squeal/results/contact_history.h>

#include <cstdint>
#include <string>

namespace squeal::tribology
{
  /**
   * Turns two tables (doc/history_format.md) into a history file, sample by
   * sample: memory does not grow with their length. Returns the number of
   * samples. Throws InputError "file:line: ..." for a column that is missing, a
   * value that is no number, nodes out of order, an incomplete sample or times
   * that do not increase; no history file is left behind then.
   */
  std::uint64_t import_csv_history(const std::string &nodes,
                                   const std::string &samples,
                                   const std::string &history);
} // namespace squeal::tribology

#endif
