// SPDX-License-Identifier: LGPL-2.1-or-later

// Ends that nobody asked for: the terminal closes, nobody reads the output, a
// limit of the shell is reached, the screen cannot be written. Each leaves one
// line and no half results. Arguments: the program, the folder of parameter
// files, squeal-tribology.

#include "program.h"

#include <sys/resource.h>

#include <chrono>
#include <thread>

using namespace squeal::testing;
namespace fs = std::filesystem;

namespace
{
  std::string program, folder, tribology;

  std::vector<std::string>
  short_run(const std::string &directory)
  {
    return {program, "--set", "Output directory = " + directory, "good.prm"};
  }

  /** The same with so many animated shapes that it can be caught writing. */
  std::vector<std::string>
  long_run(const std::string &directory)
  {
    return {program,
            "--set",
            "Output directory = " + directory,
            "--set",
            "Output/Shapes = all",
            "--set",
            "Output/Animation frames = 360",
            "good.prm"};
  }

  void
  check_end(const Outcome     &outcome,
            const int          code,
            const std::string &part,
            const std::string &directory,
            const std::string &claim)
  {
    const std::string &e = outcome.errors;
    check(outcome.code == code,
          claim + ": exit code " + std::to_string(outcome.code) + ": " + e);
    check(e.find('\n') == e.size() - 1 && e.substr(0, 8) == "squeal: " &&
            e.find(part) != std::string::npos,
          claim + ": one line that says '" + part + "': " + e);
    for (const auto &[name, text] : files_below(directory))
      check(name == "run.log" || name == ".squeal_files",
            claim + ": nothing is left but the log, not '" + name + "'");
  }

  /** Waits until @p ready holds, at most a minute. */
  void
  wait_until(const std::function<bool()> &ready)
  {
    for (unsigned int i = 0; i < 6000 && !ready(); ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    check(ready(), "the run has come as far as it is stopped at");
  }



  void
  signals_while_it_writes()
  {
    for (const auto &[number, name] : {std::pair{SIGHUP, "SIGHUP"},
                                       {SIGQUIT, "SIGQUIT"},
                                       {SIGXCPU, "SIGXCPU"},
                                       {SIGPIPE, "SIGPIPE"}})
      {
        const int     signal_number = number;
        const Outcome outcome =
          run_program(long_run("out"), {}, [&](const pid_t id) {
            wait_until([]() {
              return fs::is_directory("out/shapes") &&
                     files_below("out/shapes").size() > 3;
            });
            ::kill(id, signal_number);
          });
        check_end(outcome, 128 + number, name, "out", name);
        check(!fs::exists("out/shapes"), "and no empty folder");
      }
  }



  void
  nobody_reads()
  {
    const Outcome outcome = run_program(short_run("out"), []() {
      int ends[2];
      if (::pipe(ends) == 0)
        {
          ::close(ends[0]);
          ::dup2(ends[1], STDOUT_FILENO);
        }
    });
    check_end(
      outcome, 128 + SIGPIPE, "SIGPIPE", "out", "a pipe without a reader");
  }



  /** The results stay, as they are whole, but the exit code tells it. */
  void
  screens_that_cannot_be_written()
  {
    const auto refused = [](const std::vector<std::string> &words,
                            const bool                      is_closed,
                            const std::string              &claim) {
      const Outcome      outcome = run_program(words, [is_closed]() {
        ::close(STDOUT_FILENO);
        if (!is_closed)
          ::dup2(::open("/dev/full", O_WRONLY), STDOUT_FILENO);
      });
      const std::string &e       = outcome.errors;
      check(outcome.code == 2,
            claim + ": exit code " + std::to_string(outcome.code) + ": " + e);
      check(e.find('\n') == e.size() - 1 &&
              e.find(is_closed
                       ? "Bad file descriptor"
                       : "No space left on device") != std::string::npos,
            claim + ": one line with the reason: " + e);
      return e;
    };
    for (const bool is_closed : {false, true})
      {
        fs::remove_all("out");
        const std::string line =
          refused(short_run("out"), is_closed, "the screen of a run");
        check(line.find("run.log") != std::string::npos &&
                text_of("out/run.log").find("results: out") !=
                  std::string::npos &&
                fs::exists("out/eigenvalues.csv"),
              "the results are there and run.log has what was to be seen");
        refused({program, "--validate", "good.prm"}, is_closed, "--validate");
        for (const std::string &name : {program, tribology})
          for (const char *action : {"--help", "--version", "--print-defaults"})
            refused({name, action}, is_closed, action);
      }
    fs::remove_all("out");
  }



  /** OpenBLAS tries without end to get its memory, in its other threads, too,
   * and MPI may give up before it. */
  void
  address_spaces()
  {
    unsigned int n_whole = 0, n_refused = 0;
    for (const bool has_threads : {false, true})
      for (rlim_t megabytes = 600; megabytes <= 1100; megabytes += 100)
        {
          const auto with_limit = [=]() {
            if (has_threads)
              unsetenv("OPENBLAS_NUM_THREADS");
            const rlim_t        bytes = megabytes << 20;
            const struct rlimit limit = {bytes, bytes};
            ::setrlimit(RLIMIT_AS, &limit);
            ::alarm(20);
          };
          const std::string claim =
            "with " + std::to_string(megabytes) + " MB of address space";
          fs::remove_all("out");
          const Outcome run = run_program(short_run("out"), with_limit);
          check(run.code != 128 + SIGALRM, "a run ends " + claim);
          n_whole += run.code == 0 && fs::exists("out/eigenvalues.csv");
          n_refused += run.code == 3 && run.errors.find("the memory ran out") !=
                                          std::string::npos;
          check(run_program({tribology, "--version"}, with_limit).code !=
                  128 + SIGALRM,
                "squeal-tribology ends " + claim);
        }
    check(n_whole > 0 && n_refused > 0,
          "some runs have room enough and some end by the memory");
    fs::remove_all("out");
  }



  void
  file_size_limits()
  {
    const auto with_limit = [](const rlim_t bytes) {
      fs::remove_all("out");
      return run_program(short_run("out"), [bytes]() {
        // What it prints goes to a pipe, which has no limit of size.
        int ends[2];
        if (::pipe(ends) == 0)
          ::dup2(ends[1], STDOUT_FILENO);
        if (bytes < 200)
          ::dup2(STDOUT_FILENO, STDERR_FILENO);
        const struct rlimit limit = {bytes, bytes};
        ::setrlimit(RLIMIT_FSIZE, &limit);
      });
    };
    for (const rlim_t bytes : {200, 4096})
      check_end(with_limit(bytes),
                128 + SIGXFSZ,
                "SIGXFSZ",
                "out",
                "files of at most " + std::to_string(bytes) + " bytes");
    // Not even the list of the results fits.
    const Outcome none = with_limit(16);
    check(none.code == 2, "exit code 2 where no file can be written at all");
    check(files_below("out").empty(), "and no file is left");
  }



  void
  nohup()
  {
    const Outcome outcome = run_program(
      long_run("out"),
      []() { std::signal(SIGHUP, SIG_IGN); },
      [](const pid_t id) {
        wait_until([]() { return fs::exists("out/parameters_used.prm"); });
        ::kill(id, SIGHUP);
      });
    check(outcome.code == 0 && fs::exists("out/eigenvalues.csv"),
          "a run under nohup goes on: " + outcome.errors);
  }



  void
  checkpoint()
  {
    const Outcome outcome = run_program(
      coarse_transient({program}, folder, "closed", {"Transient/End time = 1"}),
      {},
      [](const pid_t id) {
        wait_until([]() {
          return text_of("closed/run.log").find("pairs in the band") !=
                 std::string::npos;
        });
        std::this_thread::sleep_for(std::chrono::milliseconds(1500));
        ::kill(id, SIGHUP);
      });
    check(outcome.code == 128 + SIGHUP &&
            outcome.errors.find("SIGHUP") != std::string::npos,
          "a transient whose terminal closes ends: " + outcome.errors);
    check(fs::exists("closed/checkpoint.h5") &&
            !fs::exists("closed/transient.json"),
          "it leaves a checkpoint and no results");
  }

  /** What HDF5 cannot write it would write again as MPI ends, and crash. */
  void
  checkpoint_that_does_not_fit()
  {
    const Outcome outcome =
      run_program(coarse_transient({program},
                                   folder,
                                   "full",
                                   {"Transient/End time = 1",
                                    "Transient/Checkpoint interval = 0.01"}),
                  []() {
                    std::signal(SIGXFSZ, SIG_IGN);
                    const struct rlimit limit = {20000, 20000};
                    ::setrlimit(RLIMIT_FSIZE, &limit);
                  });
    check(
      outcome.code == 2 &&
        outcome.errors.find("checkpoint.h5'") != std::string::npos,
      "a checkpoint that does not fit on the disk ends a run by one line: " +
        std::to_string(outcome.code) + ", " + outcome.errors);
  }
} // namespace



int
main(int argc, char **argv)
{
  check(argc == 4,
        "arguments: the program, the folder of parameter files, "
        "squeal-tribology");
  program   = argv[1];
  folder    = argv[2];
  tribology = argv[3];
  std::vector<fs::path> old;
  for (const auto &entry : fs::directory_iterator("."))
    old.push_back(entry.path());
  for (const auto &path : old)
    fs::remove_all(path);
  write_text("good.prm", small_brake);
  signals_while_it_writes();
  nobody_reads();
  screens_that_cannot_be_written();
  address_spaces();
  file_size_limits();
  fs::remove_all("out");
  nohup();
  checkpoint();
  checkpoint_that_does_not_fit();
}
