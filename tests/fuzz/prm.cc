// SPDX-License-Identifier: LGPL-2.1-or-later

// Text of parameter files: lines, sections, includes. With WHOLE also what the
// entries mean.
#include <squeal/parameters/parameters.h>
#include <squeal/parameters/prm_tree.h>

#include "fuzz.h"

using namespace squeal;

extern "C" int
LLVMFuzzerTestOneInput(const std::uint8_t *data, const std::size_t size)
{
  return fuzz::read_as("in.prm", data, size, [](const std::string &path) {
#ifdef WHOLE
    const Parameters parameters = read_parameters(path);
    parameters.check();
    for (const auto &[name, value] : parameters.used)
      fuzz::require(value != "nan" && value != "-nan" && value != "inf" &&
                      value != "-inf",
                    name + " = " + value);
#else
    const prm::PrmTree tree = prm::read_prm_file(path);
    for (const prm::RawEntry &entry : tree.entries)
      {
        fuzz::require(!entry.path.empty(), "an entry has no name");
        fuzz::require(tree.find(entry.path) == &entry,
                      "an entry is there twice: " + entry.path);
        fuzz::require(entry.value.find('\n') == std::string::npos,
                      "a value of two lines");
      }
#endif
  });
}
