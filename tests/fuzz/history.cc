// SPDX-License-Identifier: LGPL-2.1-or-later

// Contact histories in HDF5. With SQUEAL_FUZZ_SEEDS=folder it writes a small
// one there to start from.
#include <squeal/results/contact_history.h>

#include "fuzz.h"

using namespace squeal;

extern "C" int
LLVMFuzzerInitialize(int *, char ***)
{
  const char *const folder = std::getenv("SQUEAL_FUZZ_SEEDS");
  if (folder == nullptr)
    return 0;
  HistoryLayout layout;
  layout.name           = "seed";
  layout.points         = {{{0., 0., 0.}}, {{1., 0., 0.}}};
  layout.areas          = {1., 2.};
  layout.has_resultants = false;
  HistorySamples samples;
  samples.time         = {0., 1., 2.};
  samples.pressure     = {1., 2., 3., 4., 5., 6.};
  samples.traction     = std::vector<double>(12, 0.5);
  samples.slip_rate    = std::vector<double>(12, 0.1);
  samples.gap          = std::vector<double>(6, 0.);
  samples.status       = std::vector<double>(6, 2.);
  layout.has_slip_rate = layout.has_gap = layout.has_status = true;
  HistoryWriter writer(std::string(folder) + "/seed.h5", layout);
  writer.append(samples);
  writer.finish();
  return 0;
}

extern "C" int
LLVMFuzzerTestOneInput(const std::uint8_t *data, const std::size_t size)
{
  return fuzz::read_as("in.h5", data, size, [](const std::string &path) {
    const HistoryReader reader(path);
    const std::size_t   n_nodes = reader.layout().n_nodes();
    const auto          n = std::min<std::uint64_t>(reader.n_samples(), 64);
    HistorySamples      samples;
    reader.read(0, n, samples);
    fuzz::require(samples.time.size() == n &&
                    samples.pressure.size() == n * n_nodes &&
                    samples.traction.size() == 2 * n * n_nodes,
                  "arrays of different sizes");
    fuzz::require_finite(samples.time, "a time");
    fuzz::require_finite(samples.pressure, "a pressure");
    fuzz::require_finite(samples.traction, "a traction");
    fuzz::require_finite(samples.slip_rate, "a slip rate");
    fuzz::require_finite(samples.gap, "a gap");
    for (const auto &point : reader.layout().points)
      for (const double x : point)
        fuzz::require_finite(x, "a coordinate");
    fuzz::require_finite(reader.layout().areas, "an area");
    fuzz::require_finite(reader.time_range()[0], "the first time");
    fuzz::require_finite(reader.time_range()[1], "the last time");
    for (const StatusChange &change : reader.status_changes())
      {
        fuzz::require_finite(change.time, "the time of a change");
        fuzz::require(change.node < n_nodes, "a change of an unknown node");
      }
  });
}
