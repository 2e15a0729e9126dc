// SPDX-License-Identifier: LGPL-2.1-or-later

// What a run is started with is written down: its saved parameter file repeats
// it by itself, to the byte and from any folder; result checks that a setting
// has made void are left out and named; a quiet run prints its results alone.
// Arguments: the program, the folder of parameter files and what to test.

#include "brief_runs.h"

#include <squeal/base/run_log.h>
#include <squeal/run/settings.h>

#include <algorithm>
#include <cstdlib>

using namespace squeal;
using namespace squeal::testing;
namespace fs = std::filesystem;

namespace
{
  std::string program, shipped;

  const std::string friction =
                      "Scene/Contact pin_beam/Friction coefficient = 0.45",
                    beam_cells = "Scene/Body beam/Cells = 2, 16, 1",
                    pin_cells  = "Scene/Body pin/Cells = 2, 2, 4";

  /** Runs @p file in @p folder with settings. */
  Outcome
  run(const std::string              &folder,
      const std::string              &file,
      const std::vector<std::string> &settings,
      const std::vector<std::string> &options = {})
  {
    std::vector<std::string> words = {program};
    words.insert(words.end(), options.begin(), options.end());
    for (const std::string &setting : settings)
      words.insert(words.end(), {"--set", setting});
    words.push_back(fs::absolute(file).string());
    return run_program(words, [&]() {
      if (::chdir(folder.c_str()) != 0)
        ::_exit(126);
    });
  }

  bool
  has(const std::string &text, const std::string &part)
  {
    return text.find(part) != std::string::npos;
  }

  nlohmann::json
  record_of(const std::string &directory)
  {
    return nlohmann::json::parse(text_of(directory + "/run.json"));
  }

  /** Tables, histories and shapes. */
  std::map<std::string, std::string>
  results_of(const std::string &directory)
  {
    std::map<std::string, std::string> results;
    for (const auto &[name, text] : comparable_results(directory))
      for (const char *ending : {".csv", ".h5", ".vtu", ".pvd"})
        if (fs::path(name).extension() == ending)
          results[name] = text;
    return results;
  }

  /** Runs @p file with settings and by what it has saved, here and elsewhere. */
  void
  repeats(const std::string              &file,
          std::vector<std::string>        settings,
          const std::vector<std::string> &endings)
  {
    for (const char *folder : {"first", "here", "elsewhere"})
      fs::remove_all(folder);
    fs::create_directories("elsewhere");
    settings.push_back("Output directory = first");
    Outcome o = run(".", file, settings);
    check(o.code == 0, file + " with settings: " + o.errors);
    const auto expected = results_of("first");
    for (const std::string &ending : endings)
      check(std::any_of(expected.begin(),
                        expected.end(),
                        [&](const auto &result) {
                          return fs::path(result.first).extension() == ending;
                        }),
            file + " has left a file *" + ending);

    const std::string saved = "first/parameters_used.prm";
    o                       = run(".", saved, {"Output directory = here"});
    check(o.code == 0, "the saved file by itself: " + o.errors);
    check_same_results(expected, results_of("here"), "the saved file");
    o = run("elsewhere", saved, {"Output directory = again"});
    check(o.code == 0, "from another folder: " + o.errors);
    check_same_results(expected,
                       results_of("elsewhere/again"),
                       "the saved file from another folder");
    check(record_of("first").at("settings") == nlohmann::json(settings),
          "the record names every setting as it was typed");
    check(record_of("here").at("settings").size() == 1,
          "and that of the saved file its own");
  }

  void
  eigenvalues()
  {
    repeats(shipped + "/pin_on_beam/cea.prm",
            {friction, beam_cells, pin_cells, "Output/Shapes = all"},
            {".csv", ".vtu", ".pvd"});
  }

  void
  motions()
  {
    write_text("pin.prm",
               pin_on_beam(shipped,
                           "subsection Transient\n  set Animation frames = 3\n"
                           "end\n",
                           "0.006"));
    repeats("pin.prm",
            {friction,
             "Transient/History start = 0.004",
             "Transient/Disturbance = 2e-6"},
            {".csv", ".h5", ".vtu"});
  }



  void
  checks_of_a_file()
  {
    const std::string file     = shipped + "/pin_on_beam/cea.prm";
    const std::string brief    = "Output/Plots = false",
                      shapes   = "Output/Shapes = none",
                      expected = "Result checks/Check number/Expected = 77";
    const auto names           = [](const std::string &list) {
      const auto               json = record_of("checked").at(list);
      std::vector<std::string> result;
      for (const auto &item : json)
        result.push_back(item.is_string() ? item : item.at("name"));
      return result;
    };
    const auto ends = [&](const std::vector<std::string> &settings,
                          const int                       code,
                          const std::string              &claim) {
      std::vector<std::string> all = {
        "Output directory = checked", brief, shapes};
      all.insert(all.end(), settings.begin(), settings.end());
      const Outcome o = run(".", file, all);
      check(o.code == code, claim + ": " + o.errors);
      return o;
    };
    using Names = std::vector<std::string>;

    ends({}, 0, "settings of what is written");
    check(names("result_checks") == Names{"number", "frequency", "growth"} &&
            names("void_checks").empty(),
          "they leave every check");

    Outcome o = ends({beam_cells, pin_cells, friction}, 0, "another scene");
    check(names("result_checks").empty() &&
            names("void_checks") == Names{"number", "frequency", "growth"},
          "its checks are void");
    const std::string line = "not checked, as --set '" + beam_cells +
                             "' changes what they expect: number, frequency, "
                             "growth";
    check(has(text_of("checked/run.log"), line), "the log says so in one line");
    check(has(o.output, "not checked, as --set"), "the terminal, too");
    const std::string report = text_of("checked/report.html");
    check(has(report, "Not checked, as --set") &&
            has(report, "<li>growth</li>"),
          "and the report");
    for (const std::string &setting : {beam_cells, pin_cells, friction})
      check(has(report, "--set '" + setting + "'"),
            "the report repeats " + setting);

    ends({beam_cells, pin_cells, friction, expected},
         4,
         "a check that a setting speaks of is kept");
    check(names("result_checks") == Names{"number"} &&
            names("void_checks") == Names{"frequency", "growth"},
          "it alone");
    ends({expected}, 4, "a changed check of the scene itself");
    check(names("result_checks").size() == 3, "is one of three");
    ends({beam_cells,
          pin_cells,
          friction,
          "Result checks/Checks = number, frequency, growth"},
         4,
         "a list of checks that is asked for is kept");
  }



  void
  on_the_terminal()
  {
    const std::string        file     = shipped + "/pin_on_beam/cea.prm";
    std::vector<std::string> settings = {"Output directory = shown",
                                         "Output/Shapes = none",
                                         beam_cells,
                                         pin_cells};
    const Outcome            loud     = run(".", file, settings);
    check(loud.code == 0, loud.errors);
    std::istringstream lines(loud.output);
    for (std::string line; std::getline(lines, line);)
      check(display_width(line) <= 80 || line.find(' ') == std::string::npos,
            "no more than 80 columns: " + line);
    const std::string log = text_of("shown/run.log");

    const Outcome quiet = run(".", file, settings, {"--quiet"});
    check(quiet.code == 0, quiet.errors);
    check(has(quiet.output, "unstable pairs") &&
            has(quiet.output, "results: shown") &&
            !has(quiet.output, "Solve:") && !has(quiet.output, "default"),
          "a quiet run prints its figures: " + quiet.output);
    check(std::count(quiet.output.begin(), quiet.output.end(), '\n') < 25,
          "in few lines");
    const auto n_lines = [](const std::string &text) {
      return std::count(text.begin(), text.end(), '\n');
    };
    check(std::abs(n_lines(text_of("shown/run.log")) - n_lines(log)) < 3,
          "and its log has everything");

    const Outcome version = run_program({program, "--version"});
    for (const char *part : {"squeal 0.", "deal.II 9.", "Trilinos ", "MUMPS "})
      check(version.code == 0 && has(version.output, part),
            std::string("the version tells ") + part);
  }



  void
  commands()
  {
    unsetenv("SQUEAL_LAUNCHER");
    check(command_of_run("prm/a.prm", {"A/B = it's", "C = 1"}, 2) ==
            "./squeal run prm/a.prm -np 2 \\\n  --set 'A/B = it'\\''s' \\\n"
            "  --set 'C = 1'",
          "a shell reads every setting as it was");
    check(command_of_run("my file.prm", {}, 1) == "./squeal run 'my file.prm'",
          "and the name of the file");
    setenv("SQUEAL_LAUNCHER", "squeal", 1);
    check(command_of_run("a.prm", {}, 1) == "squeal run a.prm",
          "an installed launcher has no folder in front");
    unsetenv("SQUEAL_LAUNCHER");
  }



  void
  last_of_two_settings()
  {
    ResultCheckParameters parameters;
    parameters.name       = "number";
    const VoidChecks made = find_void_checks(
      {parameters}, {"Scene/A = 2", "Overwrite = true", "Scene / A = 3"});
    check(made.names == std::vector<std::string>{"number"} &&
            made.cause == "Scene / A = 3",
          "void by the one of two settings that counts: " + made.cause);
  }
} // namespace



int
main(int argc, char **argv)
{
  check(argc == 4, "the program, the parameter files and what to test");
  program                = fs::absolute(argv[1]).string();
  shipped                = fs::absolute(argv[2]).string();
  const std::string what = argv[3];
  if (what == "repeats")
    {
      eigenvalues();
      motions();
    }
  else
    {
      commands();
      last_of_two_settings();
      checks_of_a_file();
      on_the_terminal();
    }
}
