// SPDX-License-Identifier: LGPL-2.1-or-later
// The log file holds what the console shows, from the first line on, and long
// loops tell when they will end.
#include <squeal/base/exceptions.h>
#include <squeal/base/files.h>
#include <squeal/base/run_log.h>
#include <squeal/base/timers.h>

#include <filesystem>
#include <sstream>

#include "check.h"

using namespace squeal;
using namespace squeal::testing;

namespace
{
  bool
  contains(const std::string &text, const std::string &part)
  {
    return text.find(part) != std::string::npos;
  }

  std::size_t
  count(const std::string &text, const std::string &part)
  {
    std::size_t n = 0;
    for (std::size_t at = text.find(part); at != std::string::npos;
         at             = text.find(part, at + 1))
      ++n;
    return n;
  }

  void
  test_lines()
  {
    const std::string  path = "run_log_test.log";
    std::ostringstream console;
    RunLog             log(true, console);
    log.heading("Größe");
    log.key_values({{"µ", "0.5"}, {"density", "7800 kg/m³"}});
    log.warning("guide spring added");
    log.open(path);
    log.warning("guide spring added");
    log.info("after the file is known");
    Timers timers;
    log.summary({{"unstable pairs", "2"}}, timers);

    const std::string text = console.str();
    check(read_file(path) == text,
          "the file holds the lines of the console, also the early ones");
    check(contains(text, "Größe\n-----\n"),
          "a rule is as wide as the letters over it, not as their bytes");
    check(contains(text, "  µ        0.5\n  density  7800 kg/m³\n"),
          "names and values are aligned");
    check(count(text, "warning: guide spring added") == 1 &&
            log.warnings().size() == 1,
          "the same warning is said once");
    check(count(text, "guide spring added") == 2 &&
            contains(text, "1 warning:\n  - guide"),
          "and repeated at the end");
    check(contains(text, "peak memory"), "the summary tells the memory");
    std::filesystem::remove(path);
  }

  void
  test_long_lines()
  {
    const std::string  path = "run_log_test.log", word(90, 'x');
    std::ostringstream console;
    RunLog             log(true, console);
    log.open(path);
    std::string line = "    ";
    for (int i = 0; i < 40; ++i)
      line += (i == 0 ? "wort" : " größe");
    log.info(line);
    log.info(word);
    std::istringstream in(console.str());
    std::string        joined;
    std::size_t        n = 0;
    for (std::string part; std::getline(in, part); ++n)
      if (part != word)
        {
          check(display_width(part) <= 80 &&
                  (display_width(part) > 70 || in.peek() == 'x'),
                "a line is broken where 80 columns end: " + part);
          check(part.substr(0, n == 0 ? 4 : 6) ==
                  std::string(n == 0 ? 4 : 6, ' '),
                "what follows stands further in");
          joined += (joined.empty() ? "" : " ") + part.substr(n == 0 ? 4 : 6);
        }
    check("    " + joined == line, "no word is lost");
    check(contains(console.str(), word), "a long word is left whole");
    check(read_file(path) == line + '\n' + word + '\n',
          "the file has the lines as they are");
    std::filesystem::remove(path);
  }

  void
  test_wide_tables()
  {
    const std::string                     name(30, 'n'), value(24, '1');
    std::vector<std::vector<std::string>> rows = {
      {"name", "a", "b", "c", "d"}, {name, value, value, value, value}};
    std::ostringstream out;
    print_aligned(out, rows);
    std::istringstream in(out.str());
    for (std::string line; std::getline(in, line);)
      check(display_width(line) <= 80, "within 80 columns: " + line);
    check(count(out.str(), name) == 4 && count(out.str(), value) == 4,
          "columns that do not fit follow behind the first one once more");
  }

  void
  test_quiet()
  {
    const std::string  path = "run_log_test.log";
    std::ostringstream console;
    RunLog             log(true, console, true, true);
    log.open(path);
    log.heading("Modes");
    log.info("a detail");
    log.warning("a warning");
    log.result("results: out");
    Timers timers;
    log.summary({{"unstable pairs", "2"}}, timers);
    double now = 0.;
    {
      Progress progress(log, "Sweep", 100, [&now] { return now; });
      for (int i = 0; i < 100; ++i, now += 0.5)
        progress.advance();
    }
    const std::string text = console.str(), file = read_file(path);
    check(contains(text, "warning: a warning\nresults: out\n") &&
            contains(text, "unstable pairs  2\n") &&
            !contains(text, "detail") && !contains(text, "Modes") &&
            !contains(text, "Sweep") && !contains(text, "total"),
          "a quiet console shows results and warnings alone: " + text);
    for (const char *part : {"a detail", "Modes\n-----", "total", "100 %"})
      check(contains(file, part), std::string("the file has ") + part);
    std::filesystem::remove(path);
  }

  void
  test_other_rank()
  {
    std::ostringstream console;
    RunLog             log(false, console);
    log.info("silent");
    log.warning("silent");
    log.open("run_log_never.log");
    Progress(log, "loop", 10).advance(10);
    check(console.str().empty() && log.warnings().empty() &&
            !std::filesystem::exists("run_log_never.log"),
          "ranks other than the root are silent");
  }

  void
  test_unwritable()
  {
    std::ostringstream console;
    RunLog             log(true, console);
    log.info("line");
    check_throws<InputError>([&] { log.open("/dev/null/run.log"); },
                             "Not a directory",
                             "a log file that cannot be opened is named");
    check_throws<InputError>(
      [&] { log.open("/dev/full"); }, "/dev/full", "a full device is named");
  }

  void
  test_progress()
  {
    double     now   = 0.;
    const auto clock = [&now] { return now; };
    {
      std::ostringstream console;
      RunLog             log(true, console);
      {
        Progress progress(log, "Sweep", 10, clock);
        for (int i = 0; i < 10; ++i, now += 0.4)
          progress.advance();
      }
      check(console.str().empty(), "a loop of 4 s shows nothing");
    }
    {
      std::ostringstream console;
      RunLog             log(true, console);
      {
        Progress progress(log, "Sweep", 100, clock);
        for (int i = 0; i < 100; ++i)
          {
            now += 0.5;
            progress.advance();
          }
      }
      const std::string text = console.str();
      check(contains(text, "Sweep: 10 of 100 (10 %), 5.0 s, about 45 s left\n"),
            "the first line after 5 s extrapolates the time left");
      check(count(text, "\n") == 6 &&
              contains(text, "Sweep: 100 of 100 (100 %), done in 50 s\n"),
            "then a line every 10 s and one at the end, which says 100 %");
    }
    {
      std::ostringstream console;
      RunLog             log(true, console);
      {
        Progress progress(log, "time steps", 1000, clock);
        now += 60.;
        for (int i = 0; i < 1000; ++i, now += 0.1)
          progress.advance();
      }
      const std::string text = console.str();
      check(contains(text, "time steps: 1 of 1000 (0 %), 1 min 00 s\n"),
            "after a set-up of 60 s the first report estimates nothing");
      check(contains(text, "1 min 10 s, about 1 min 30 s left\n"),
            "10 s later the estimate does not count the set-up");
    }
    {
      std::ostringstream console;
      RunLog             log(true, console, true);
      {
        Progress progress(log, "Sweep", 100, clock);
        for (int i = 0; i < 100; ++i)
          {
            now += 0.5;
            progress.advance();
            if (i == 50)
              log.info("in between");
          }
      }
      const std::string text = console.str();
      check(count(text, "\n") == 2 && contains(text, "\rin between\n") &&
              count(text, " left") > 80,
            "on a terminal one line is rewritten, other lines stand apart");
      log.open("run_log_tty.log");
      check(count(read_file("run_log_tty.log"), " left") == 5,
            "and the file still gets a line every 10 s");
      std::filesystem::remove("run_log_tty.log");
    }
  }

  void
  test_durations()
  {
    check(format_duration(0.4217) == "0.42 s" &&
            format_duration(9.96) == "10 s" &&
            format_duration(59.6) == "1 min 00 s" &&
            format_duration(103.) == "1 min 43 s" &&
            format_duration(7500.) == "2 h 05 min",
          "durations are rounded to what a reader wants");
  }
} // namespace

int
main()
{
  test_lines();
  test_long_lines();
  test_wide_tables();
  test_quiet();
  test_other_rank();
  test_unwritable();
  test_progress();
  test_durations();
}
