// SPDX-License-Identifier: LGPL-2.1-or-later
// Nested sections are counted once and CPU time includes all threads.
#include <squeal/base/timers.h>

#include <chrono>
#include <sstream>
#include <thread>
#include <vector>

#include "check.h"

using namespace squeal;
using namespace squeal::testing;

namespace
{
  void
  sleep(const double seconds)
  {
    std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
  }

  /** Keeps this thread busy for so many CPU seconds of its own. */
  void
  burn(const double seconds)
  {
    timespec   time{};
    const auto used = [&time] {
      clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
      return time.tv_sec + 1e-9 * time.tv_nsec;
    };
    const double start = used();
    while (used() - start < seconds)
      {
      }
  }

  void
  test_nesting()
  {
    Timers timers;
    {
      Timers::Section outer(timers, "Solve: outer");
      sleep(0.04);
      for (int i = 0; i < 2; ++i)
        {
          Timers::Section inner(timers, "Solve: inner");
          sleep(0.03);
        }
      {
        Timers::Section again(timers, "Solve: outer");
        sleep(0.02);
      }
    }
    const auto entries = timers.entries();
    check(entries.size() == 2 && entries[0].name == "Solve: outer" &&
            entries[0].count == 2 && entries[1].count == 2 &&
            entries[1].depth == 1,
          "sections stand in the order of first entry with their counts");
    check(entries[1].own_wall >= 0.06 && entries[0].own_wall >= 0.06,
          "each section has the time spent in itself");
    check(entries[0].wall >= entries[0].own_wall + entries[1].own_wall - 1e-9,
          "the outer section holds the inner one");
    const double sum = entries[0].own_wall + entries[1].own_wall;
    check(sum <= timers.total_wall() && entries[0].wall <= timers.total_wall(),
          "own times never add up to more than the run");
    check_close(entries[0].wall,
                sum,
                1e-6,
                "a section that re-enters itself is not counted twice");
  }

  void
  test_open_sections()
  {
    Timers          timers;
    Timers::Section open(timers, "Solve: open");
    sleep(0.02);
    check(timers.entries()[0].own_wall >= 0.02,
          "a section that is still open is in the list");
    check(timers.entries()[0].count == 1, "and asking twice changes nothing");
    std::ostringstream out;
    timers.print(out);
    check(out.str().find("Solve: open") != std::string::npos &&
            out.str().find("not timed") != std::string::npos &&
            out.str().find("total") != std::string::npos,
          "the table shows sections, rest and total");
  }

  void
  test_threads()
  {
    Timers timers;
    {
      Timers::Section section(timers, "Solve: threads");
      std::thread     one([] { burn(0.1); }), two([] { burn(0.1); });
      one.join();
      two.join();
    }
    check(timers.entries()[0].own_cpu >= 0.199,
          "CPU time adds up over threads");
  }

  void
  test_memory()
  {
    const double      before = peak_memory_mb();
    std::vector<char> block(200000000, 1);
    const double      after = peak_memory_mb();
    check(before > 0.5 && after > before + 150. && after < before + 300.,
          "peak memory follows a block of 200 MB (block ends in " +
            std::to_string(block.back()) + ")");
  }
} // namespace

int
main()
{
  test_nesting();
  test_open_sections();
  test_threads();
  test_memory();
}
