// SPDX-License-Identifier: LGPL-2.1-or-later

// A campaign keeps the rows of its finished runs and goes on with the others.
// Arguments: the program and the folder of parameter files.

#include <squeal/driver/finished_runs.h>

#include "program.h"

#include <set>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  void
  rows_are_kept()
  {
    std::filesystem::remove("kept_runs.json");
    const std::vector<Cell> row = {Cell("held"), Cell(0.1), Cell(12), Cell()};
    {
      FinishedRuns finished("kept_runs.json", "1.0", true);
      finished.add("first", row);
    }
    FinishedRuns      finished("kept_runs.json", "2.0", true);
    std::vector<Cell> found;
    check(finished.find("first", 4, found) && found.size() == 4 &&
            std::get<std::string>(found[0].value) == "held" &&
            std::get<double>(found[1].value) == 0.1 &&
            std::get<long long>(found[2].value) == 12 &&
            !std::holds_alternative<double>(found[3].value),
          "text, numbers and missing values come back as they were");
    check(!finished.find("first", 5, found), "not if columns have changed");
    check(!finished.find("second", 4, found), "nor under another key");
    check(finished.program_of("first") == "1.0",
          "a row knows the version of its program");
    finished.add("first", row);
    check(FinishedRuns("kept_runs.json", "3.0", true).program_of("first") ==
            "2.0",
          "which is that of the last one to write it");
    check(!FinishedRuns("kept_runs.json", "3.0", false).find("first", 4, found),
          "without Resume nothing is kept");
    write_text("kept_runs.json", "{\"first\": [\"held\", 0.1, 12, null]}");
    const FinishedRuns old("kept_runs.json", "3.0", true);
    check(old.find("first", 4, found) && old.program_of("first") == "unknown",
          "rows without a version are read");
    for (const char *text : {"{\"first\": ", "{\"first\": {\"row\": 3}}"})
      {
        write_text("kept_runs.json", text);
        bool refused = false;
        try
          {
            FinishedRuns bad("kept_runs.json", "3.0", true);
          }
        catch (const std::exception &e)
          {
            refused =
              std::string(e.what()).find("kept_runs.json") != std::string::npos;
          }
        check(refused, std::string("refuses ") + text);
      }
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
  set Plots = false
end
)");
    const Outcome outcome = run_program({program, "campaign.prm"});
    check(outcome.code == 0, "mu = " + frictions + " runs: " + outcome.errors);
    output = outcome.output + outcome.errors;
    return rows_of("campaign/campaign.csv");
  }



  void
  runs_are_not_run_again(const std::string &program, const std::string &folder)
  {
    std::filesystem::remove("campaign_runs.json");
    std::string output;
    const auto  first = run(program, folder, "0.1, 0.3", output);
    check(first.size() == 2, "a row for each point");
    const auto second = run(program, folder, "0.1, 0.2, 0.3", output);
    check(second.size() == 3, "and for a further one");
    // A row holds the steps per second, which no second run would have again.
    check(second[0] == first[0] && second[2] == first[1],
          "finished runs are kept to the last digit");
    check(output.find("rows were kept from") == std::string::npos,
          "rows of this program need no warning");

    std::string       text = text_of("campaign_runs.json");
    const std::string mark = "\"program\": \"";
    for (std::size_t at = text.find(mark); at != std::string::npos;
         at             = text.find(mark, at + 1))
      text.insert(at + mark.size(), "an earlier ");
    write_text("campaign_runs.json", text);
    check(run(program, folder, "0.1, 0.2, 0.3", output) == second,
          "rows of another version count");
    check(output.find("3 of the rows were kept from squeal an earlier") !=
            std::string::npos,
          "with a warning");
  }



  /** Each run solves for the pin's shape under the blow, and two go side by
   * side. */
  void
  blows_are_struck_side_by_side(const std::string &program,
                                const std::string &folder)
  {
    std::filesystem::remove("campaign_runs.json");
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
