// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/blas_kernels.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <vector>

#include <cblas.h>
#include <sys/mman.h>
#include <unistd.h>

namespace squeal
{
  namespace blas_kernels
  {
    namespace
    {
      constexpr const char *variable = "OPENBLAS_CORETYPE";

      /** What OpenBLAS maps a thread on x86-64, in bytes: BUFFER_SIZE of its
       * sources, less on other processors. */
      constexpr std::size_t work_size = std::size_t(1) << 27;

      /** Kernels from narrow to wide; those of one row are as wide. */
      struct Width
      {
        /** What a processor needs to run the first name. */
        std::vector<std::string> flags;
        std::vector<std::string> names;
      };

      const std::vector<Width> &
      widths()
      {
        static const std::vector<Width> list = {
          {{},
           {"Prescott",
            "Core2",
            "Penryn",
            "Dunnington",
            "Atom",
            "Nano",
            "Nehalem",
            "Opteron",
            "Opteron_SSE3",
            "Barcelona",
            "Bobcat"}},
          {{"avx"},
           {"Sandybridge",
            "Bulldozer",
            "Piledriver",
            "Steamroller",
            "SteamrollerCore",
            "Excavator"}},
          {{"avx2", "fma"}, {"Haswell", "Zen"}},
          {{"avx512f", "avx512dq", "avx512cd", "avx512bw", "avx512vl"},
           {"SkylakeX", "Cooperlake", "SapphireRapids"}}};
        return list;
      }

      std::string
      lower_case(std::string text)
      {
        std::transform(text.begin(), text.end(), text.begin(), ::tolower);
        return text;
      }

      /** The row of a name, -1 for an unknown one. */
      int
      width_of(const std::string &name)
      {
        for (std::size_t i = 0; i < widths().size(); ++i)
          for (const std::string &known : widths()[i].names)
            if (lower_case(known) == lower_case(name))
              return static_cast<int>(i);
        return -1;
      }

      /** Whether the work memory of @p n threads can be had, all at once. */
      bool
      has_room_for(const int n)
      {
        std::vector<void *> parts;
        bool                has_room = true;
        for (int i = 0; i < n && has_room; ++i)
          {
            void *const part = ::mmap(nullptr,
                                      work_size,
                                      PROT_READ | PROT_WRITE,
                                      MAP_PRIVATE | MAP_ANONYMOUS,
                                      -1,
                                      0);
            has_room         = part != MAP_FAILED;
            if (has_room)
              parts.push_back(part);
          }
        for (void *const part : parts)
          ::munmap(part, work_size);
        return has_room;
      }
    } // namespace



    std::string
    in_use()
    {
      return openblas_get_corename();
    }



    std::set<std::string>
    processor_flags()
    {
      std::ifstream in("/proc/cpuinfo");
      for (std::string line; std::getline(in, line);)
        if (line.rfind("flags", 0) == 0)
          {
            std::istringstream words(line.substr(line.find(':') + 1));
            return {std::istream_iterator<std::string>(words),
                    std::istream_iterator<std::string>()};
          }
      return {};
    }



    std::string
    widest(const std::set<std::string> &flags)
    {
      std::string result;
      for (const Width &width : widths())
        if (!width.flags.empty() && std::all_of(width.flags.begin(),
                                                width.flags.end(),
                                                [&](const std::string &flag) {
                                                  return flags.count(flag) > 0;
                                                }))
          result = width.names.front();
      return result;
    }



    bool
    are_narrower(const std::string &name, const std::string &other)
    {
      const int own = width_of(name);
      return own >= 0 && own < width_of(other);
    }



    void
    start_again_with_widest(char **argv)
    {
      if (std::getenv(variable))
        return;
      const std::string best = widest(processor_flags());
      if (!are_narrower(in_use(), best))
        return;
      std::error_code error;
      const auto self = std::filesystem::read_symlink("/proc/self/exe", error);
      // Set even where the start fails, so that it is tried once.
      setenv(variable, best.c_str(), 1);
      if (!error)
        ::execv(self.c_str(), argv);
    }



    const char *
    NoWorkMemory::what() const noexcept
    {
      return "the memory ran out at the start: OpenBLAS works in 128 MB of "
             "address space a thread; raise the limit (ulimit -v) or set a "
             "smaller SQUEAL_THREADS";
    }



    void
    start_threads(const int n_threads)
    {
      // Threads that are there have asked for theirs as the library was loaded.
      const int n_new = std::max(0, n_threads - openblas_get_num_threads());
      if (!has_room_for(1 + n_new))
        throw NoWorkMemory();
      openblas_set_num_threads(n_threads);
      // The buffer of this thread, by the smallest product that takes one.
      const double a[4] = {1., 0., 0., 1.};
      double       c[4] = {0., 0., 0., 0.};
      cblas_dsyrk(
        CblasColMajor, CblasLower, CblasNoTrans, 2, 2, 1., a, 2, 0., c, 2);
    }
  } // namespace blas_kernels
} // namespace squeal
