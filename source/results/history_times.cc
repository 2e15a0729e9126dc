// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/base/number_text.h>
#include <squeal/results/history_times.h>

#include <cmath>

namespace squeal
{
  void
  check_times(const Hdf5File &file, const std::vector<std::string> &pairs)
  {
    const auto refuse = [&file](const std::string &what) {
      throw InputError("'" + file.path() + "' " + what);
    };
    std::vector<std::string> groups;
    for (const std::string &pair : pairs)
      groups.push_back("pairs/" + pair + "/");
    if (groups.empty())
      groups.emplace_back();
    std::vector<double> of_first;
    for (std::size_t k = 0; k < groups.size(); ++k)
      {
        const std::string   name  = groups[k] + "samples/time";
        std::vector<double> times = file.read(name);
        for (std::size_t i = 0; i < times.size(); ++i)
          if (!std::isfinite(times[i]))
            refuse("holds a value that is not a number in '" + name + "'");
          else if (i > 0 && !(times[i] > times[i - 1]))
            refuse("has times that do not increase, at " +
                   shortest_text(times[i]) + " s");
        if (k == 0)
          of_first = std::move(times);
        else if (times != of_first)
          refuse("has other times in the contact pair '" + pairs[k] +
                 "' than in the first");
      }
  }
} // namespace squeal
