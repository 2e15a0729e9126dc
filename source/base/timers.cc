// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/run_log.h>
#include <squeal/base/timers.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <ostream>

namespace squeal
{
  double
  wall_seconds()
  {
    using Clock = std::chrono::steady_clock;
    return std::chrono::duration<double>(Clock::now().time_since_epoch())
      .count();
  }



  double
  cpu_seconds()
  {
    timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * time.tv_nsec;
  }



  double
  peak_memory_mb()
  {
    std::ifstream status("/proc/self/status");
    for (std::string word; status >> word;)
      if (word == "VmHWM:")
        {
          double kibibytes = 0.;
          status >> kibibytes;
          return kibibytes * 1024e-6;
        }
    return 0.;
  }



  Timers::Section::Section(Timers &timers, const std::string &name)
    : timers(timers)
  {
    auto entry = std::find_if(timers.closed.begin(),
                              timers.closed.end(),
                              [&](const Entry &e) { return e.name == name; });
    if (entry == timers.closed.end())
      {
        Entry fresh;
        fresh.name  = name;
        fresh.depth = timers.open.size();
        entry       = timers.closed.insert(entry, fresh);
      }
    const std::size_t index = entry - timers.closed.begin();
    timers.open.push_back({index, wall_seconds(), cpu_seconds(), 0., 0.});
  }



  Timers::Section::~Section()
  {
    close(timers.open, timers.closed);
  }



  Timers::Timers()
    : start_wall(wall_seconds())
    , start_cpu(cpu_seconds())
  {
  }



  void
  Timers::close(std::vector<Open> &open, std::vector<Entry> &entries)
  {
    const Open   section = open.back();
    const double wall    = wall_seconds() - section.start_wall;
    const double cpu     = cpu_seconds() - section.start_cpu;
    open.pop_back();

    Entry &entry = entries[section.entry];
    ++entry.count;
    entry.own_wall += wall - section.inner_wall;
    entry.own_cpu += cpu - section.inner_cpu;
    // a section inside itself is counted by the outer one
    if (std::none_of(open.begin(), open.end(), [&](const Open &around) {
          return around.entry == section.entry;
        }))
      entry.wall += wall;
    if (!open.empty())
      {
        open.back().inner_wall += wall;
        open.back().inner_cpu += cpu;
      }
  }



  std::vector<Timers::Entry>
  Timers::entries() const
  {
    std::vector<Entry> result     = closed;
    std::vector<Open>  still_open = open;
    while (!still_open.empty())
      close(still_open, result);
    return result;
  }



  double
  Timers::total_wall() const
  {
    return wall_seconds() - start_wall;
  }



  double
  Timers::total_cpu() const
  {
    return cpu_seconds() - start_cpu;
  }



  void
  Timers::print(std::ostream &out) const
  {
    const auto fixed = [](const double value, const int decimals) {
      char text[64];
      std::snprintf(text, sizeof(text), "%.*f", decimals, value);
      return std::string(text);
    };
    const std::vector<Entry> sections = entries();
    const double             wall     = total_wall();
    const double             cpu      = total_cpu();
    const auto               share    = [&](const double own) {
      return fixed(wall > 0. ? 100. * own / wall : 0., 1);
    };

    std::vector<std::vector<std::string>> rows = {
      {"section", "calls", "wall s", "own s", "own CPU s", "%"}};
    double rest_wall = wall, rest_cpu = cpu;
    for (const Entry &e : sections)
      {
        rows.push_back({std::string(2 * e.depth, ' ') + e.name,
                        std::to_string(e.count),
                        fixed(e.wall, 2),
                        fixed(e.own_wall, 2),
                        fixed(e.own_cpu, 2),
                        share(e.own_wall)});
        rest_wall -= e.own_wall;
        rest_cpu -= e.own_cpu;
      }
    rest_wall = std::max(0., rest_wall);
    rest_cpu  = std::max(0., rest_cpu);
    rows.push_back({"not timed",
                    "",
                    "",
                    fixed(rest_wall, 2),
                    fixed(rest_cpu, 2),
                    share(rest_wall)});
    rows.push_back(
      {"total", "", fixed(wall, 2), fixed(wall, 2), fixed(cpu, 2), "100.0"});
    print_aligned(out, rows);
  }
} // namespace squeal
