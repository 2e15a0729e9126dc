// SPDX-License-Identifier: LGPL-2.1-or-later
// A result file is complete or not there, and an output directory never loses
// what squeal has not written.
#include <squeal/base/exceptions.h>
#include <squeal/base/files.h>
#include <squeal/base/output_directory.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <memory>
#include <ostream>
#include <stdexcept>

#include <sys/resource.h>

#include "check.h"

using namespace squeal;
using namespace squeal::testing;
namespace fs = std::filesystem;

namespace
{
  const fs::path work = "files_test";

  void
  put(const fs::path &path, const std::string &text)
  {
    std::ofstream(path) << text;
  }

  std::size_t
  n_entries(const fs::path &directory)
  {
    return std::distance(fs::directory_iterator(directory),
                         fs::directory_iterator());
  }

  /** Lets files grow to @p bytes only: what a full disk does to a write that
   * has begun. */
  void
  limit_file_size(const rlim_t bytes)
  {
    std::signal(SIGXFSZ, SIG_IGN);
    rlimit limit{};
    getrlimit(RLIMIT_FSIZE, &limit);
    limit.rlim_cur = bytes;
    setrlimit(RLIMIT_FSIZE, &limit);
  }

  void
  write_big(const std::string &path)
  {
    write_atomically(path, [](std::ostream &out) {
      for (int i = 0; i < 100000; ++i)
        out << "0123456789\n";
    });
  }

  void
  test_atomic_write()
  {
    const std::string path = (work / "a.txt").string();
    write_big(path);
    check(fs::file_size(path) == 1100000 && n_entries(work) == 1,
          "a file larger than the buffer is written whole, no other is left");

    write_atomically(path, [](std::ostream &out) { out << "new"; });
    check(read_file(path) == "new", "an older file is replaced");

    check_throws<std::runtime_error>(
      [&] {
        write_atomically(path, [](std::ostream &out) {
          out << "half";
          throw std::runtime_error("stop");
        });
      },
      "stop",
      "what the writer throws is passed on");
    check(read_file(path) == "new" && n_entries(work) == 1,
          "a writer that throws leaves the older file and no other");

    limit_file_size(70000);
    check_throws<InputError>([&] { write_big(path); },
                             "a.txt': File too large",
                             "a write that fails half way names the reason");
    limit_file_size(RLIM_INFINITY);
    check(read_file(path) == "new" && n_entries(work) == 1,
          "a write that fails half way leaves the older file and no other");

    check_throws<InputError>([&] { write_big("/dev/full"); },
                             "'/dev/full': No space left on device",
                             "a full device is reported");
    check(fs::is_character_file("/dev/full"), "and is still a device");
    check_throws<InputError>([&] { write_big(path + "/b.txt"); },
                             "Not a directory",
                             "a path below a file is reported");
    check_throws<InputError>([&] { write_big(work.string()); },
                             "Is a directory",
                             "a path that is a directory is reported");

    fs::create_symlink("a.txt", work / "link.txt");
    write_atomically((work / "link.txt").string(),
                     [](std::ostream &out) { out << "through"; });
    check(fs::is_symlink(work / "link.txt") && read_file(path) == "through",
          "a link stays a link and its file is replaced");
  }

  void
  test_reading()
  {
    check_throws<InputError>([] { read_file((work / "none").string()); },
                             "none': No such file",
                             "a missing file is named");
    check_throws<InputError>([] { read_file(work.string()); },
                             "Is a directory",
                             "a directory is no file");
  }

  void
  test_preparation()
  {
    const std::string directory = (work / "out/deep").string();
    prepare_output_directory(directory, false);
    check(fs::is_directory(directory), "a missing directory is created");
    prepare_output_directory(directory, false);

    put(work / "file", "");
    check_throws<InputError>(
      [] { prepare_output_directory((work / "file").string(), true); },
      "is a file: choose another Output directory",
      "a file in its place is refused");
    check_throws<InputError>(
      [] { prepare_output_directory((work / "file/x").string(), true); },
      "Not a directory",
      "a directory below a file is refused");
    check_throws<InputError>([] { prepare_output_directory("", true); },
                             "Output directory",
                             "an empty name is refused");

    put(fs::path(directory) / "notes.txt", "mine");
    check_throws<InputError>(
      [&] { prepare_output_directory(directory, false); },
      "is not empty: set Overwrite = true",
      "a directory with a foreign file is refused");
    prepare_output_directory(directory, true);
    check(read_file(directory + "/notes.txt") == "mine",
          "a foreign file outlives Overwrite");
  }

  void
  test_output_directory()
  {
    const std::string directory = (work / "run").string();
    const auto        fill      = [&](OutputDirectory &output) {
      for (const std::string name : {"modes.csv", "plots/deep/a.png"})
        put(output.file(name), "result");
    };
    {
      OutputDirectory output(directory, false);
      put(output.file("run.log"), "log");
    }
    {
      OutputDirectory output(directory, false);
      check(!fs::exists(directory + "/run.log"),
            "a run that left only its log does not stand in the way");
      fill(output);
      check(output.files().count("plots/deep/a.png") == 1,
            "the directory knows the names it gave");
    }
    {
      OutputDirectory output(directory, false);
      check(!fs::exists(directory + "/modes.csv"),
            "nor does one that was killed before it had listed its record");
      fill(output);
      put(output.file(record_file_name), "ended");
    }
    check_throws<InputError>([&] { OutputDirectory(directory, false); },
                             "is not empty",
                             "results are not overwritten by themselves");
    fs::remove(directory + "/run.json");
    check_throws<InputError>([&] { OutputDirectory(directory, false); },
                             "is not empty",
                             "nor where only the record was removed");

    put(directory + "/plots/mine.png", "mine");
    put(directory + "/.part.modes.csv", "killed");
    {
      OutputDirectory output(directory, true);
      check(!fs::exists(directory + "/modes.csv") &&
              !fs::exists(directory + "/plots/deep") &&
              !fs::exists(directory + "/.part.modes.csv"),
            "Overwrite removes results, empty folders and what a killed run "
            "left");
      check(fs::exists(directory + "/plots/mine.png"),
            "and nothing that is not a result");
      put(directory + "/eigenvalues.csv", "foreign");
      check_throws<InputError>([&] { output.file("eigenvalues.csv"); },
                               "was not written by squeal",
                               "a foreign file of a result's name is refused");
    }

    put(work / "precious", "");
    put(directory + "/.squeal_files",
        "../precious\n" + fs::absolute(work / "precious").string() + "\n");
    OutputDirectory again(directory, true);
    check(fs::exists(work / "precious"),
          "a manifest cannot name files outside its directory");

    OutputDirectory elsewhere((work / "other_rank").string(), false, false);
    check(elsewhere.file("a/b.csv") == (work / "other_rank/a/b.csv").string() &&
            !fs::exists(work / "other_rank"),
          "ranks other than the root create nothing");
  }

  /** A folder of results that was moved away, with a link in its place. */
  void
  test_linked_folder()
  {
    const fs::path directory = work / "linked", archive = work / "archive";
    {
      OutputDirectory output(directory.string(), false);
      put(output.file("plots/a.png"), "result");
      put(output.file(record_file_name), "ended");
    }
    fs::rename(directory / "plots", archive);
    fs::create_directory_symlink("../archive", directory / "plots");
    check_throws<InputError>(
      [&] { OutputDirectory(directory.string(), true); },
      "'files_test/linked/plots' of earlier results is a symbolic link",
      "results behind a link out of the directory are not removed");
    check(fs::exists(archive / "a.png") && fs::exists(directory / "run.json"),
          "and nothing else is");

    fs::create_directory_symlink("linked", work / "alias");
    fs::remove(directory / "plots");
    OutputDirectory((work / "alias").string(), true);
    check(!fs::exists(directory / "run.json"),
          "a link to the whole directory is that directory");
  }

  /** Two runs under one name, the directory removed between them. */
  void
  test_removed_directory()
  {
    const std::string directory = (work / "removed").string();
    const std::string claim     = "was removed or replaced during the run";
    auto first = std::make_unique<OutputDirectory>(directory, false);
    put(first->file("modes.csv"), "first");
    fs::remove_all(directory);
    check_throws<InputError>([&] { first->file("run.json"); },
                             claim,
                             "a run notices that its directory was removed");
    check_throws<InputError>(
      [&] { first->state_file("a/rows.bin", "checkpoint", "Entry"); },
      claim,
      "before a state file");
    check(!fs::exists(directory), "and makes no new one without a lock");

    OutputDirectory second(directory, false);
    put(second.file("modes.csv"), "second");
    check_throws<InputError>([&] { first->file("modes.csv"); },
                             claim,
                             "of a name that it was given, too");
    check_throws<InputError>([&] { first->require_in_place(); },
                             claim,
                             "a run notices that its directory was replaced");
    first->discard();
    first.reset();
    check(read_file(directory + "/modes.csv") == "second",
          "the run that fails removes nothing of the other one");

    // As a process without the check would: it lists what it writes.
    std::ofstream(directory + "/.squeal_files", std::ios::app) << "own.csv\n";
    put(directory + "/own.csv", "first");
    second.discard();
    check(!fs::exists(directory + "/modes.csv") &&
            read_file(directory + "/own.csv") == "first",
          "a run that fails removes what it has written, not all that is "
          "listed");
  }

  void
  test_inputs_in_output_directory()
  {
    const std::string directory = (work / "own").string();
    {
      OutputDirectory output(directory, false);
      put(output.file("matrices/mass.mtx"), "mass");
      put(directory + "/pad.msh", "of the user");
    }
    const std::string entry = "the entry 'Matrix part mass/File'";
    for (const std::string &input :
         {directory + "/matrices/mass.mtx",
          directory + "/../own/matrices/mass.mtx",
          fs::absolute(directory).string() + "/matrices/m*.mtx",
          fs::absolute(directory).string() + "/mat*/mass.mtx",
          directory + "/../o?n/mat*/m*.mtx",
          directory + "/matrices",
          directory + "/matrices/",
          directory + "/mat*/",
          directory})
      check_throws<InputError>(
        [&] {
          refuse_to_remove_inputs(directory, {{entry, input}});
        },
        entry + " reads '" + input +
          "', but mass.mtx is a result of an earlier",
        "a result that the run reads: " + input);
    refuse_to_remove_inputs(directory,
                            {{entry, ""},
                             {entry, directory + "/pad.msh"},
                             {entry, directory + "/matrices/k*.mtx"},
                             {entry, directory + "/pad*/mass.mtx"},
                             {entry, directory + "/matrices/mass"},
                             {entry, directory + "_again"}});
    fs::remove(directory + "/matrices/mass.mtx");
    refuse_to_remove_inputs(directory,
                            {{entry, directory + "/matrices/mass.mtx"}});
    refuse_to_remove_inputs((work / "nowhere").string(), {{entry, directory}});
    check(!fs::exists(work / "nowhere"), "asking creates nothing");
  }
} // namespace

int
main()
{
  fs::remove_all(work);
  fs::create_directories(work);
  test_atomic_write();
  test_reading();
  test_preparation();
  test_output_directory();
  test_linked_folder();
  test_removed_directory();
  test_inputs_in_output_directory();
  fs::remove_all(work);
}
