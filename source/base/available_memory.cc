// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/available_memory.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <string>

#include <malloc.h>
#include <sys/resource.h>

namespace squeal
{
  namespace
  {
    constexpr double unlimited = std::numeric_limits<double>::infinity();

    /** The number behind @p key (or the first one) in a file of the kernel;
     * infinite where there is none ("max"). */
    double
    kernel_number(const char *file, const std::string &key = "")
    {
      std::ifstream in(file);
      double        value = 0.;
      if (key.empty())
        return in >> value ? value : unlimited;
      for (std::string word; in >> word;)
        if (word == key)
          return in >> value ? value : unlimited;
      return unlimited;
    }



    double
    left_by_ulimit()
    {
      struct rlimit limit;
      if (::getrlimit(RLIMIT_AS, &limit) != 0 ||
          limit.rlim_cur == RLIM_INFINITY)
        return unlimited;
      // What the heap has freed is taken from it again.
      return static_cast<double>(limit.rlim_cur) -
             1024. * kernel_number("/proc/self/status", "VmSize:") +
             static_cast<double>(::mallinfo2().fordblks);
    }



    double
    left_by_control_group()
    {
      const double most = kernel_number("/sys/fs/cgroup/memory.max");
      return most == unlimited
               ? unlimited
               : most - kernel_number("/sys/fs/cgroup/memory.current");
    }
  } // namespace



  double
  available_memory()
  {
    return std::min({1024. * kernel_number("/proc/meminfo", "MemAvailable:"),
                     left_by_control_group(),
                     left_by_ulimit()});
  }
} // namespace squeal
