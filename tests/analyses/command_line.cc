// SPDX-License-Identifier: LGPL-2.1-or-later

// No word of a command is passed over: what has no meaning beside the others, a
// number of threads that is none and a file of the other program are refused in
// one line. Arguments: squeal, squeal-tribology.

#include "program.h"

using namespace squeal::testing;

namespace
{
  std::string name_of_squeal, name_of_tribology;

  void
  refuses_words(const std::vector<std::string> &words,
                const std::vector<std::string> &parts,
                const std::string              &claim,
                const std::function<void()>    &before = {})
  {
    const Outcome      outcome = run_program(words, before);
    const std::string &e       = outcome.errors;
    check(outcome.code == 2,
          claim + ": exit code " + std::to_string(outcome.code) + ": " + e);
    check(e.substr(0, 8) == "squeal: " && e.find('\n') == e.size() - 1,
          claim + ": one line: " + e);
    for (const std::string &part : parts)
      check(e.find(part) != std::string::npos,
            claim + ": the line says '" + part + "': " + e);
    check(outcome.output.empty(), claim + ": and nothing else is printed");
  }

  void
  words_without_a_meaning()
  {
    for (const std::string &program : {name_of_squeal, name_of_tribology})
      {
        for (const char *action : {"--help",
                                   "--version",
                                   "--print-defaults",
                                   "--print-documentation"})
          refuses_words({program, action, "x.prm"},
                        {"'x.prm'", action},
                        "a file that is not read");
        refuses_words({program, "--help", "--version"},
                      {"--help", "--version"},
                      "two actions");
        refuses_words({program, "--version", "--set", "A = 1"},
                      {"'--set'"},
                      "a setting of nothing");
        refuses_words({program, "--all", "good.prm"},
                      {"'--all'", "--compare"},
                      "--all of a run");
        refuses_words({program, "--quiet", "--validate", "good.prm"},
                      {"'--quiet'"},
                      "--quiet of what is no run");
        check(run_program({program, "--help", "-h"}).code == 0,
              "the same action by both of its names");
      }
    refuses_words({name_of_squeal, "--compare", "a", "b", "--set", "A = 1"},
                  {"'--set'"},
                  "a setting of a comparison");
  }



  void
  numbers_of_threads()
  {
    for (const char *number : {"abc", "-3", "0", "2x", "1.5", " 2", "100000"})
      for (const std::string &program : {name_of_squeal, name_of_tribology})
        refuses_words({program, "--validate", "good.prm"},
                      {"SQUEAL_THREADS", number, "from 1 to"},
                      "threads that are no number of them",
                      [number]() { setenv("SQUEAL_THREADS", number, 1); });
    for (const char *number : {"", "1", "2"})
      check(run_program(
              {name_of_squeal, "--validate", "good.prm"},
              [number]() {
                setenv("SQUEAL_THREADS", number, 1);
              }).code == 0,
            "threads that there may be");
  }



  void
  files_of_the_other_program()
  {
    write_text("damage.prm",
               "\nset Analysis = damage\nsubsection History\nend\n");
    refuses_words({name_of_squeal, "damage.prm"},
                  {"damage.prm:2: ", "'Analysis = damage'", "squeal-tribology"},
                  "a file of squeal-tribology");
    refuses_words({name_of_tribology, "good.prm"},
                  {"good.prm:1: ", "'Analysis = cea'", "is for squeal;"},
                  "a file of squeal");
  }
} // namespace



int
main(int argc, char **argv)
{
  check(argc == 3, "arguments: squeal, squeal-tribology");
  name_of_squeal    = argv[1];
  name_of_tribology = argv[2];
  write_text("good.prm", small_brake);
  words_without_a_meaning();
  numbers_of_threads();
  files_of_the_other_program();
}
