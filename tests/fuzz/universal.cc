// SPDX-License-Identifier: LGPL-2.1-or-later

// Measured shapes: universal files with datasets 55, or tables.
#include <squeal/results/measured_shapes.h>

#include "fuzz.h"

using namespace squeal;

extern "C" int
LLVMFuzzerTestOneInput(const std::uint8_t *data, const std::size_t size)
{
  return fuzz::read_as("in.uff", data, size, [](const std::string &path) {
    const auto require_finite = [](const std::complex<double> &value) {
      fuzz::require_finite(value.real(), "a displacement");
      fuzz::require_finite(value.imag(), "a displacement");
    };
    for (const MeasuredShape &shape : read_measured_shapes(path))
      {
        fuzz::require_finite(shape.frequency, "a frequency");
        for (const auto &node : shape.nodes)
          for (const auto &value : node.second)
            require_finite(value);
        for (const auto &point : shape.points)
          require_finite(point.second);
      }
  });
}
