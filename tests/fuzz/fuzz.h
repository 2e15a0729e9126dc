// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tests_fuzz_fuzz_h
#define squeal_tests_fuzz_fuzz_h

#include <squeal/base/exceptions.h>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

/**
 * What the fuzz targets have in common. A target writes each input to a file
 * in memory, reads it, and ends the program when a reader accepts what nobody
 * may compute with. An InputError of one line is a right answer to any input;
 * any other exception is a fault.
 */
namespace squeal
{
  namespace fuzz
  {
    /** Ends the program; the input is kept by the fuzzer. */
    [[noreturn]] inline void
    fault(const std::string &what)
    {
      std::fprintf(stderr, "FAULT: %s\n", what.c_str());
      std::abort();
    }



    inline void
    require(const bool ok, const std::string &what)
    {
      if (!ok)
        fault(what);
    }



    inline void
    require_finite(const double value, const std::string &what)
    {
      require(std::isfinite(value), what + " is not finite");
    }



    inline void
    require_finite(const std::vector<double> &values, const std::string &what)
    {
      for (const double value : values)
        require_finite(value, what);
    }



    /** A name in memory that belongs to this process. */
    inline std::string
    file_in_memory(const std::string &name)
    {
      static const std::string folder = [] {
        const char *const base =
          ::access("/dev/shm", W_OK) == 0 ? "/dev/shm" : "/tmp";
        const std::string own =
          std::string(base) + "/squeal_fuzz_" + std::to_string(::getpid());
        ::mkdir(own.c_str(), 0700);
        return own;
      }();
      return folder + "/" + name;
    }



    inline void
    write_input(const std::string  &path,
                const std::uint8_t *data,
                const std::size_t   size)
    {
      const int file =
        ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
      const bool ok =
        file >= 0 && ::write(file, data, size) == static_cast<ssize_t>(size);
      ::close(file);
      if (!ok)
        fault("cannot write " + path);
    }



    /** Runs @p action; an InputError is fine as long as it is one line. */
    template <typename Action>
    int
    expect_answer(const Action &action)
    {
      try
        {
          action();
        }
      catch (const InputError &e)
        {
          const std::string text = e.what();
          require(!text.empty() && text.find('\n') == std::string::npos,
                  "the message is not one line: " + text);
        }
      return 0;
    }



    /** Writes the input to @p name, then runs @p action on the file. */
    template <typename Action>
    int
    read_as(const std::string  &name,
            const std::uint8_t *data,
            const std::size_t   size,
            const Action       &action)
    {
      const std::string path = file_in_memory(name);
      write_input(path, data, size);
      return expect_answer([&] { action(path); });
    }
  } // namespace fuzz
} // namespace squeal

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data,
                                      std::size_t         size);

#endif
