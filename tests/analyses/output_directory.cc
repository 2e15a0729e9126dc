// SPDX-License-Identifier: LGPL-2.1-or-later

// What may happen to the results of a run: they are there already, cannot be
// written, the disk is full, the run is stopped. Argument: the program.

#include "program.h"

#include <sys/mount.h>
#include <sys/resource.h>

#include <chrono>
#include <sched.h>
#include <thread>

using namespace squeal::testing;
namespace fs = std::filesystem;

namespace
{
  std::string program;

  /** small_brake with animated shapes into @p directory. */
  std::vector<std::string>
  run_with_shapes(const std::string &directory, const std::string &frames)
  {
    return {program,
            "--set",
            "Output directory = " + directory,
            "--set",
            "Output/Shapes = all",
            "--set",
            "Output/Animation frames = " + frames,
            "good.prm"};
  }

  void
  check_line(const Outcome                  &outcome,
             const int                       code,
             const std::vector<std::string> &parts,
             const std::string              &claim)
  {
    const std::string &e = outcome.errors;
    check(outcome.code == code,
          claim + ": exit code " + std::to_string(outcome.code) + " (" + e +
            ")");
    check(e.find('\n') == e.size() - 1 && e.substr(0, 8) == "squeal: ",
          claim + ": one line: " + e);
    for (const std::string &part : parts)
      check(e.find(part) != std::string::npos,
            claim + ": the line says '" + part + "': " + e);
  }

  void
  check_only_log(const std::string &directory, const std::string &claim)
  {
    for (const auto &[name, text] : files_below(directory))
      check(name == "run.log" || name == ".squeal_files",
            claim + ": nothing is left but the log, not '" + name + "'");
  }

  /** Waits until @p ready holds, at most half a minute. */
  void
  wait_until(const std::function<bool()> &ready)
  {
    for (unsigned int i = 0; i < 3000 && !ready(); ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    check(ready(), "the run has come as far as it is stopped at");
  }



  void
  links_without_a_target()
  {
    fs::remove("dangling");
    fs::create_symlink("nowhere", "dangling");
    check_line(run_program(
                 {program, "--set", "Output directory = dangling", "good.prm"}),
               2,
               {"'dangling'", "symbolic link to 'nowhere'", "does not exist"},
               "a link that leads nowhere");
    check(!fs::exists("nowhere"), "and nothing is made");
  }



  void
  existing_results()
  {
    check(run_program({program, "good.prm"}).code == 0, "a first run");
    const auto before = files_below("out");
    check(before.count("eigenvalues.csv") == 1, "it writes results");
    check_line(run_program({program, "good.prm"}),
               2,
               {"'out' is not empty", "Overwrite = true"},
               "results that are there");
    check(files_below("out") == before, "they are left as they were");

    // A mistake that is seen before the run starts leaves them, too.
    check_line(run_program({program,
                            "--set",
                            "Overwrite = true",
                            "--set",
                            "Scene/Body pad/Position = 0.3, 0, 0",
                            "good.prm"}),
               2,
               {"do not meet"},
               "a scene that cannot stand");
    check(files_below("out") == before, "and Overwrite leaves the results");
    check(
      run_program({program, "--set", "Overwrite = true", "good.prm"}).code == 0,
      "Overwrite replaces results");

    // Files of the user are never touched.
    fs::create_directory("mine");
    write_text("mine/eigenvalues.csv", "mine");
    check_line(run_program({program,
                            "--set",
                            "Overwrite = true",
                            "--set",
                            "Output directory = mine",
                            "good.prm"}),
               2,
               {"mine/eigenvalues.csv", "not written by squeal"},
               "a file of the user under the name of a result");
    check(text_of("mine/eigenvalues.csv") == "mine", "which stays");
    fs::remove("mine/eigenvalues.csv");
    check_only_log("mine", "and the run");
  }



  /** What a run includes or reads is not removed with the results that it
   * replaces. */
  void
  inputs_among_results()
  {
    const auto                     before = files_below("out");
    const std::vector<std::string> again  = {
       program, "--set", "Overwrite = true"};
    write_text("again.prm",
               "include out/parameters_used.prm\nset Analysis = modes\n");
    auto command = again;
    command.push_back("again.prm");
    check_line(run_program(command),
               2,
               {"the run reads '", "parameters_used.prm", "would remove"},
               "a run that includes a result of its output directory");
    command = again;
    command.insert(command.end(),
                   {"--set",
                    "Measurement/Frequencies file = out/eigenvalues.csv",
                    "good.prm"});
    check_line(run_program(command),
               2,
               {"'Measurement/Frequencies file' reads '", "eigenvalues.csv"},
               "a run whose entry names such a result");
    check(files_below("out") == before, "and both leave the results");
  }

  void
  unwritable_places()
  {
    write_text("a_file", "");
    check_line(
      run_program({program, "--set", "Output directory = a_file", "good.prm"}),
      2,
      {"'a_file' is a file"},
      "a file in place of the directory");
    check_line(run_program(
                 {program, "--set", "Output directory = a_file/x", "good.prm"}),
               2,
               {"a_file/x"},
               "a directory below a file");

    // Files may not grow any more from the first shape on.
    const Outcome full = run_program(
      run_with_shapes("limited", "360"),
      []() { std::signal(SIGXFSZ, SIG_IGN); },
      [](const pid_t id) {
        wait_until([]() { return fs::is_directory("limited/shapes"); });
        const struct rlimit limit = {100, 100};
        ::prlimit(id, RLIMIT_FSIZE, &limit, nullptr);
      });
    check_line(full, 2, {"'limited/", "File too large"}, "a file that is cut");
    check_only_log("limited", "a file that is cut");

    // A file system without room, where we are allowed to make one.
    fs::create_directory("small_disk");
    bool       mounted = false;
    const auto mount   = []() {
      if (::unshare(CLONE_NEWNS) != 0 ||
          ::mount("", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) != 0 ||
          ::mount("none", "small_disk", "tmpfs", 0, "size=48k") != 0)
        ::_exit(77);
    };
    const Outcome small =
      run_program(run_with_shapes("small_disk", "16"), mount);
    mounted = small.code != 77;
    if (mounted)
      check_line(
        small, 2, {"small_disk/", "No space left on device"}, "a full disk");
    else
      std::cout << "left out: a full disk (not allowed to mount one)"
                << std::endl;
  }



  /** The directory goes while the run computes; another run may have taken
   * its name. */
  void
  removed_directories()
  {
    const std::vector<std::string> command = run_with_shapes("removed", "64");
    const auto                     remove_when_started = [](const pid_t) {
      wait_until([]() { return fs::exists("removed/parameters_used.prm"); });
      fs::rename("removed", "removed_before");
    };
    check_line(run_program(command, {}, remove_when_started),
               2,
               {"'removed' was removed or replaced during the run"},
               "a run whose directory is removed");
    check(!fs::exists("removed"), "and it makes no new one");

    fs::remove_all("removed_before");
    const auto replace_when_started = [&](const pid_t id) {
      remove_when_started(id);
      fs::create_directory("removed");
      write_text("removed/.squeal_files", "eigenvalues.csv\n");
      write_text("removed/eigenvalues.csv", "of another run");
    };
    check_line(run_program(command, {}, replace_when_started),
               2,
               {"'removed' was removed or replaced during the run"},
               "a run whose directory is replaced");
    check(text_of("removed/eigenvalues.csv") == "of another run" &&
            files_below("removed").size() == 2,
          "it leaves the results of the other run");
  }



  void
  stopped_runs()
  {
    // while it computes
    const auto long_run =
      std::vector<std::string>{program,
                               "--set",
                               "Output directory = stopped",
                               "--set",
                               "Discretization/Degree = 4",
                               "--set",
                               "Scene/Body disc/Cells = 48, 6, 1",
                               "--set",
                               "Eigenvalues/Highest frequency = 20000",
                               "good.prm"};
    Outcome stopped = run_program(long_run, {}, [](const pid_t id) {
      wait_until([]() { return fs::exists("stopped/parameters_used.prm"); });
      std::this_thread::sleep_for(std::chrono::milliseconds(300));
      ::kill(id, SIGTERM);
    });
    check_line(
      stopped, 128 + SIGTERM, {"SIGTERM", "'stopped'"}, "stopped at work");
    check_only_log("stopped", "stopped at work");

    // while it writes
    for (const int signal_number : {SIGTERM, SIGINT})
      {
        stopped = run_program(
          run_with_shapes("stopped", "360"), {}, [&](const pid_t id) {
            wait_until([]() {
              return fs::is_directory("stopped/shapes") &&
                     files_below("stopped/shapes").size() > 3;
            });
            ::kill(id, signal_number);
          });
        check_line(stopped,
                   128 + signal_number,
                   {signal_number == SIGTERM ? "SIGTERM" : "SIGINT"},
                   "stopped while it writes");
        check_only_log("stopped", "stopped while it writes");
        check(!fs::exists("stopped/shapes"), "and no empty folder");
      }
    check(
      run_program({program, "--set", "Output directory = stopped", "good.prm"})
          .code == 0,
      "a stopped run can be started again without Overwrite");
  }
} // namespace



int
main(int argc, char **argv)
{
  check(argc == 2, "argument: the program");
  program = argv[1];
  for (const char *folder : {"out",
                             "mine",
                             "limited",
                             "small_disk",
                             "stopped",
                             "removed",
                             "removed_before"})
    fs::remove_all(folder);
  write_text("good.prm", small_brake);
  links_without_a_target();
  existing_results();
  inputs_among_results();
  unwritable_places();
  removed_directories();
  stopped_runs();
}
