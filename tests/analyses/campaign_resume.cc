// SPDX-License-Identifier: LGPL-2.1-or-later

// A campaign keeps the rows of its finished runs and goes on with the others.
// Arguments: the program and the folder of parameter files.

#include <squeal/base/exceptions.h>
#include <squeal/run/finished_runs.h>

#include "program.h"

#include <set>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  Fingerprint
  some_run(const std::string &density)
  {
    Fingerprint fingerprint;
    fingerprint.add("program", "1.0");
    fingerprint.add("Scene/Body pad/Density", density);
    return fingerprint;
  }

  void
  rows_are_kept()
  {
    std::filesystem::remove("kept_runs.json");
    const std::vector<Cell> row = {Cell("held"), Cell(0.1), Cell(12), Cell()};
    FinishedRuns("kept_runs.json", "").add(some_run("2500"), "row", row);
    const FinishedRuns finished("kept_runs.json", text_of("kept_runs.json"));
    std::vector<Cell>  found;
    check(finished.find(some_run("2500"), "row", 4, found) &&
            found.size() == 4 &&
            std::get<std::string>(found[0].value) == "held" &&
            std::get<double>(found[1].value) == 0.1 &&
            std::get<long long>(found[2].value) == 12 && found[3].is_missing(),
          "text, numbers and missing values come back as they were");
    check(!finished.find(some_run("2500"), "row", 5, found),
          "not if columns have changed");
    check(!finished.find(some_run("2500"), "phases", 4, found) &&
            !finished.find(some_run("2501"), "row", 4, found),
          "nor under another name or of another run");
    check(finished.nearest_difference(some_run("2501")) ==
            "Scene/Body pad/Density is 2501, it was 2500",
          "which says what differs");
    for (const char *text :
         {"{\"format\": ", "{\"first\": {\"row\": 3}}", "[]", "3"})
      check_throws<InputError>([&]() { FinishedRuns("kept_runs.json", text); },
                               "kept_runs.json",
                               std::string("refuses ") + text);
  }



  /** Names of the columns. */
  std::string
  first_line(const std::string &file)
  {
    std::istringstream text(text_of(file));
    std::string        line;
    while (std::getline(text, line) && !line.empty() && line[0] == '#')
      ;
    return line;
  }

  /** Lines of the campaign's table without its head. */
  std::vector<std::string>
  rows_of(const std::string &file)
  {
    std::istringstream       text(text_of(file));
    std::vector<std::string> rows;
    for (std::string line; std::getline(text, line);)
      if (!line.empty() && line[0] != '#')
        rows.push_back(line);
    check(!rows.empty(), "a head in " + file);
    rows.erase(rows.begin());
    return rows;
  }



  /** Rows of a campaign over friction; @p more is added to `Transient`. */
  std::vector<std::string>
  run(const std::string &program,
      const std::string &folder,
      const std::string &frictions,
      std::string       &output,
      const std::string &more = "")
  {
    write_text("campaign.prm",
               "include " + folder + R"(/pin_on_beam/scene.prm
set Analysis         = transient
set Output directory = campaign
set Overwrite        = true
subsection Scene
  subsection Body beam
    set Cells = 2, 16, 1
  end
  subsection Body pin
    set Cells = 2, 2, 4
  end
end
subsection Transient
  set Disturbance     = 1e-6
  set Cut-off         = 80e3
  set Time step       = 1e-6
  set Sample interval = 1e-6
  set End time        = 0.002
)" + more + R"(
end
subsection Sweep
  set Axes = mu
  subsection Axis mu
    set Entries = Scene/Contact pin_beam/Friction coefficient
    set Scale   = list
    set Values  = )" +
                 frictions + R"(
  end
end
subsection Output
  set Plots  = false
  set Report = false
end
)");
    const Outcome outcome = run_program({program, "campaign.prm"});
    check(outcome.code == 0, "mu = " + frictions + " runs: " + outcome.errors);
    output = unbroken(outcome.output) + outcome.errors;
    return rows_of("campaign/campaign.csv");
  }



  void
  runs_are_not_run_again(const std::string &program, const std::string &folder)
  {
    std::filesystem::remove_all("campaign");
    std::string output;
    const auto  first = run(program, folder, "0.1, 0.3", output);
    check(first.size() == 2, "a row for each point");
    const auto second = run(program, folder, "0.1, 0.2, 0.3", output);
    check(second.size() == 3, "and for a further one");
    // A row holds the steps per second, which no second run would have again.
    check(second[0] == first[0] && second[2] == first[1],
          "finished runs are kept to the last digit");
    check(output.find("2 of 3 runs are taken from campaign/runs.json") !=
            std::string::npos,
          "which is said");
    check(run(program, folder, "0.1, 0.2, 0.3", output) == second,
          "all of them the third time");

    run(program,
        folder,
        "0.1",
        output,
        "end\nsubsection Scene\n  subsection Body pin\n"
        "    set Density = 1300\n  end\n");
    check(output.find("are others and are kept there: of the one most alike, "
                      "Scene/Body pin/Density is 1300, it was 1200") !=
            std::string::npos,
          "runs with another density are not taken, and that is said");
    check(run(program, folder, "0.1, 0.2, 0.3", output) == second,
          "and the others are still there");
  }



  /** Each run solves for the pin's shape under the blow, and two go side by
   * side. */
  void
  blows_are_struck_side_by_side(const std::string &program,
                                const std::string &folder)
  {
    std::filesystem::remove_all("campaign");
    std::string output;
    const auto  rows = run(program, folder, "0.1, 0.15, 0.2, 0.3", output, R"(
  set Threads = 2
  subsection Hammer
    set Body     = pin
    set Face     = y_min
    set Force    = 0, 20, 0
    set Time     = 0.001
    set Duration = 1e-4
  end)");
    check(rows.size() == 4, "a row for each run with a blow");
    check(first_line("campaign/phases.csv") ==
            "mu,top,integrator,time_s,normal_amplitude_n,"
            "tangential_amplitude_n,phase_deg",
          "phases say which run they are of, and their units");
    std::set<std::string> frictions;
    for (const std::string &row : rows_of("campaign/phases.csv"))
      frictions.insert(row.substr(0, row.find(',')));
    check(frictions == std::set<std::string>{"0.1", "0.15", "0.2", "0.3"},
          "there are phases of every run");
  }
} // namespace



int
main(int argc, char *argv[])
{
  check(argc == 3, "two arguments: program and folder");
  rows_are_kept();
  runs_are_not_run_again(argv[1], argv[2]);
  blows_are_struck_side_by_side(argv[1], argv[2]);
}
