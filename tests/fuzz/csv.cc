// SPDX-License-Identifier: LGPL-2.1-or-later

// Tables of the core.
#include <squeal/results/table.h>

#include "fuzz.h"

using namespace squeal;

extern "C" int
LLVMFuzzerTestOneInput(const std::uint8_t *data, const std::size_t size)
{
  return fuzz::read_as("in.csv", data, size, [](const std::string &path) {
    const Table table = read_csv(path);
    for (const Table::Column &column : table.columns())
      if (column.type == Table::Type::real)
        for (std::size_t r = 0; r < table.n_rows(); ++r)
          if (!table.is_missing(r, column.name))
            fuzz::require(!std::isnan(table.real(r, column.name)),
                          "a number that is none in " + column.name);
  });
}
