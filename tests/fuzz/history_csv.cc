// SPDX-License-Identifier: LGPL-2.1-or-later

// Measured histories as two tables; a line "====" parts nodes and samples.
#include <squeal/results/contact_history.h>
#include <squeal/tribology/history/csv_import.h>

#include "fuzz.h"

using namespace squeal;

extern "C" int
LLVMFuzzerTestOneInput(const std::uint8_t *data, const std::size_t size)
{
  const std::string text(reinterpret_cast<const char *>(data), size);
  const std::string mark  = "====\n";
  const std::size_t place = text.find(mark);
  const std::size_t end   = place == std::string::npos ? size : place;
  const std::size_t start = std::min(size, end + mark.size());
  const std::string nodes = fuzz::file_in_memory("nodes.csv");
  const std::string table = fuzz::file_in_memory("samples.csv");
  const std::string made  = fuzz::file_in_memory("made.h5");
  fuzz::write_input(nodes, data, end);
  fuzz::write_input(table, data + start, size - start);
  return fuzz::expect_answer([&] {
    const std::uint64_t n = tribology::import_csv_history(nodes, table, made);
    const HistoryReader reader(made);
    HistorySamples      samples;
    reader.read(0, n, samples);
    fuzz::require_finite(samples.time, "a time");
    fuzz::require_finite(samples.pressure, "a pressure");
    fuzz::require_finite(samples.traction, "a traction");
  });
}
