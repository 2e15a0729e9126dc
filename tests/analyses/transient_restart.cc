// SPDX-License-Identifier: LGPL-2.1-or-later

// A transient that is stopped in the middle and continued gives the same bits
// as one that is not. Arguments: the program, the folder of parameter files.

#include "program.h"

#include <squeal/results/contact_history.h>

#include <chrono>
#include <thread>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  std::vector<std::string>
  command(const std::string &program,
          const std::string &folder,
          const std::string &directory)
  {
    return coarse_transient({program},
                            folder,
                            directory,
                            {"Transient/Disturbance = 1e-10",
                             "Transient/End time = 0.06",
                             "Transient/History start = 0.03"});
  }

  void
  check_same_history(const std::string &a, const std::string &b)
  {
    const HistoryReader x(a), y(b);
    check(x.n_samples() == y.n_samples() && x.n_samples() > 1000,
          "the same number of samples in both histories");
    HistorySamples s, t;
    x.read(0, x.n_samples(), s);
    y.read(0, y.n_samples(), t);
    check(s.time == t.time && s.pressure == t.pressure &&
            s.traction == t.traction && s.slip_rate == t.slip_rate &&
            s.gap == t.gap && s.status == t.status && s.probes == t.probes &&
            s.energies == t.energies,
          "every bit of the samples");
    const auto c = x.status_changes(), d = y.status_changes();
    check(c.size() == d.size() && c.size() > 100,
          "the same changes of status, and some");
    for (std::size_t i = 0; i < c.size(); ++i)
      check(c[i].time == d[i].time && c[i].node == d[i].node &&
              c[i].status == d[i].status,
            "the same change");
  }
} // namespace

int
main(int argc, char *argv[])
{
  check(argc == 3, "two arguments: program and folder");
  namespace fs = std::filesystem;
  for (const char *name : {"whole", "stopped"})
    fs::remove_all(name);
  const Outcome whole = run_program(command(argv[1], argv[2], "whole"));
  check(whole.code == 0, "runs to its end: " + whole.errors);

  // Stopped twice; the second time it has continued.
  unsigned int n_stops = 0;
  for (const unsigned int milliseconds : {500u, 900u})
    {
      const Outcome outcome = run_program(
        command(argv[1], argv[2], "stopped"), {}, [&](const pid_t id) {
          // Time steps follow what the log says last.
          for (unsigned int i = 0; i < 600; ++i)
            {
              const std::string log = text_of("stopped/run.log");
              if (log.find("pairs in the band") != std::string::npos)
                break;
              std::this_thread::sleep_for(std::chrono::milliseconds(100));
            }
          std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
          ::kill(id, SIGTERM);
        });
      if (outcome.code == 128 + SIGTERM && fs::exists("stopped/checkpoint.h5"))
        ++n_stops;
    }
  check(n_stops > 0, "stopped in the middle with a checkpoint");
  const Outcome last = run_program(command(argv[1], argv[2], "stopped"));
  check(last.code == 0, "continues to its end: " + last.errors);
  check(unbroken(last.output).find("continues from") != std::string::npos,
        "from the checkpoint");
  for (const char *name :
       {"forces.csv", "energy.csv", "probes.csv", "contact_history.h5"})
    check(text_of(std::string("whole/") + name) ==
            text_of(std::string("stopped/") + name),
          std::string("every bit of ") + name);
  check_same_history("whole/contact_history.h5", "stopped/contact_history.h5");
  check(!fs::exists("stopped/checkpoint.h5"),
        "a finished run leaves no checkpoint");
}
