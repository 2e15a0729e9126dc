// SPDX-License-Identifier: LGPL-2.1-or-later

// Runs that are killed at random times, by SIGTERM and by SIGKILL, and started
// again until they end, leave the bytes of runs that nobody disturbed: a
// transient, a campaign and a sweep in turn. Arguments: the program, the folder
// of parameter files, the number of kills; the seed (optional).

#include "brief_runs.h"

#include <random>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  namespace fs = std::filesystem;

  double
  seconds()
  {
    return std::chrono::duration<double>(
             std::chrono::steady_clock::now().time_since_epoch())
      .count();
  }

  /** One kind of run, with its undisturbed results. */
  struct Case
  {
    std::string                        name, prm;
    std::map<std::string, std::string> whole;
    double                             duration = 0.; // s
  };

  Case
  undisturbed(const std::string &name,
              const std::string &text,
              const std::string &program)
  {
    Case result{name, name + ".prm", {}, 0.};
    write_text(result.prm, text);
    const std::string directory = name + "_whole";
    fs::remove_all(directory);
    fs::create_directory(directory);
    const double  start = seconds();
    const Outcome o     = run_in(directory, program, result.prm);
    result.duration     = seconds() - start;
    check(o.code == 0, name + " runs undisturbed: " + o.errors);
    result.whole = comparable_results(directory + "/out");
    return result;
  }



  /** Another run takes the basis that an undisturbed sweep has saved. */
  void
  check_saved_basis(const Case &c, const std::string &program)
  {
    const std::string directory = c.name + "_whole";
    const Outcome     o         = run_in(directory, program, c.prm);
    check(o.code == 0, c.name + " runs again: " + o.errors);
    check(unbroken(o.output).find("basis of an earlier run") !=
            std::string::npos,
          c.name + " takes the saved basis");
    check_same_results(c.whole,
                       comparable_results(directory + "/out"),
                       c.name + " with the basis of an earlier run");
  }



  /** Counts of what has been tried. */
  struct Tally
  {
    unsigned int n_kills = 0, n_chains = 0, n_continued = 0;
  };

  /** Kills a run some times and lets it end. */
  void
  disturb(const Case        &c,
          const std::string &program,
          const unsigned int most,
          std::mt19937      &random,
          Tally             &tally)
  {
    const std::string directory = c.name + "_killed";
    fs::remove_all(directory);
    fs::create_directory(directory);
    std::uniform_real_distribution<double> moment(0., c.duration);
    const unsigned int n = std::uniform_int_distribution<>(1, 5)(random);
    std::string        story;
    Outcome            last{128, "", ""};
    for (unsigned int i = 0; i < std::min(n, most) && last.code != 0; ++i)
      {
        const int    signal = random() % 2 ? SIGTERM : SIGKILL;
        const double wait   = moment(random);
        last = run_in(directory, program, c.prm, [&](const pid_t id) {
          std::this_thread::sleep_for(std::chrono::duration<double>(wait));
          ::kill(id, signal);
        });
        story += (signal == SIGTERM ? " TERM " : " KILL ") +
                 std::to_string(wait).substr(0, 5) + " s";
        check(last.code == 0 || last.code == 128 + signal,
              c.name + story + " ends by the signal or well: " +
                std::to_string(last.code) + " " + last.errors);
        tally.n_kills += last.code != 0;
      }
    if (last.code != 0)
      last = run_in(directory, program, c.prm);
    check(last.code == 0,
          c.name + " is killed and ends:" + story + " " + last.errors);
    const std::string said = unbroken(last.output);
    tally.n_continued +=
      said.find("continues from") != std::string::npos ||
      said.find("runs are taken from") != std::string::npos ||
      said.find("basis of an earlier run") != std::string::npos;
    ++tally.n_chains;
    check_same_results(
      c.whole, comparable_results(directory + "/out"), c.name + story);
  }
} // namespace



int
main(int argc, char *argv[])
{
  check(argc == 4 || argc == 5, "arguments: program, folder, kills, seed");
  const std::string  program = fs::absolute(argv[1]).string(), folder = argv[2];
  const unsigned int n_kills = std::stoi(argv[3]);
  std::mt19937       random(argc == 5 ? std::stoi(argv[4]) : 1);
  std::vector<Case>  cases;
  cases.push_back(
    undisturbed("transient", pin_on_beam(folder, "", "0.015"), program));
  cases.push_back(undisturbed("campaign", pin_campaign(folder), program));
  cases.push_back(undisturbed("sweep", brake_sweep(folder), program));
  check_saved_basis(cases.back(), program);
  Tally tally;
  for (unsigned int k = 0; tally.n_kills < n_kills; ++k)
    disturb(
      cases[k % cases.size()], program, n_kills - tally.n_kills, random, tally);
  std::cout << tally.n_kills << " kills, " << tally.n_chains
            << " runs ended with the undisturbed bytes, " << tally.n_continued
            << " of them took something over" << std::endl;
  // Of few runs that are killed at random none may have saved anything.
  if (n_kills >= 50)
    check(tally.n_continued > 0, "some runs took over what was saved");
}
