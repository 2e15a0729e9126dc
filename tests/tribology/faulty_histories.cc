// SPDX-License-Identifier: LGPL-2.1-or-later

// What is wrong with a history is said in the words of what is wrong: nodes at
// one place, changes of status that no sample reaches, damage beyond the
// numbers, pairs that share a name or not their times, times that begin again
// or are no numbers outside the window. Argument: the program.
#include "../analyses/program.h"

#include <squeal/results/contact_history.h>

#include <cmath>
#include <functional>
#include <limits>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  std::string program;

  bool
  has(const std::string &text, const std::string &part)
  {
    return text.find(part) != std::string::npos;
  }

  Outcome
  run_damage(const std::string &file, const std::string &fatigue)
  {
    write_text("test.prm",
               "set Analysis = damage\nset Output directory = damage\n"
               "set Overwrite = true\nsubsection History\n  set File = " +
                 file + "\nend\nsubsection Fatigue\n" + fatigue +
                 "end\nsubsection Subsurface\n  set Compute = false\nend\n"
                 "subsection Output\n  set Plots = false\nend\n");
    return run_program({program, "test.prm"});
  }

  /** Nodes at one place, and changes of status that no sample reaches. */
  void
  doubled_nodes_and_late_changes()
  {
    for (const bool is_wrong : {false, true})
      {
        HistoryLayout layout;
        layout.sliding = {{0., 1.}};
        for (const double y : {0., 1e-3})
          for (const double x : {0., 1e-3})
            layout.points.push_back({{x, y, 0.}});
        if (is_wrong)
          layout.points.push_back(layout.points[2]);
        const std::size_t n = layout.n_nodes();
        layout.areas.assign(n, .25e-6);
        if (is_wrong)
          layout.areas[2] = layout.areas[4] = .125e-6;
        layout.has_gap = layout.has_slip_rate = layout.has_resultants = false;
        layout.has_status                                             = true;
        HistorySamples s;
        s.time = {0., 1e-3, 2e-3};
        s.pressure.assign(3 * n, 1e6);
        s.traction.assign(6 * n, 1e5);
        s.status.assign(3 * n, std::uint8_t(ContactStatus::slip));
        HistoryWriter writer("doubled.h5", layout);
        writer.append(s);
        writer.append(
          {StatusChange{is_wrong ? 10. : 1e-3, 0, ContactStatus::slip}});
        writer.finish();
        const Outcome outcome = run_damage("doubled.h5", "");
        check(outcome.code == 0, "the run ends well: " + outcome.errors);
        const std::string record = text_of("damage/run.json");
        check(has(record,
                  "1 nodes lie where another one lies, such as 2 and "
                  "4") == is_wrong,
              "nodes at one place are said");
        check(has(record,
                  "1 of 1 times in 'status_changes/time' are not "
                  "between") == is_wrong,
              "so are changes of status that no sample reaches");
      }
  }



  /** Names of pairs are those of groups and files, and all have one time. */
  void
  unlike_pairs()
  {
    const auto write = [](const std::string &second, const double factor) {
      HistoryLayout layout;
      for (const double y : {0., 1e-3})
        for (const double x : {0., 1e-3})
          layout.points.push_back({{x, y, 0.}});
      layout.areas.assign(4, .25e-6);
      layout.has_gap = layout.has_slip_rate = layout.has_resultants = false;
      layout.has_status                                             = false;
      std::vector<HistoryLayout> pairs(2, layout);
      pairs[0].pair = "a";
      pairs[1].pair = second;
      HistoryWriter  writer("pairs.h5", pairs);
      HistorySamples s;
      s.pressure.assign(12, 1e6);
      s.traction.assign(24, 1e5);
      for (const std::size_t pair : {0, 1})
        {
          const double step = pair == 0 ? 1e-3 : factor * 1e-3;
          s.time            = {0., step, 2. * step};
          writer.append(s, pair);
        }
      writer.finish();
    };
    write("b", 1.);
    check(run_damage("pairs.h5", "").code == 0, "two pairs of one time pass");
    write("b", 2.);
    const Outcome times = run_damage("pairs.h5", "");
    check(times.code == 2 &&
            has(times.errors,
                "other times in the contact pair 'b' than in the first"),
          "pairs of other times are refused: " + times.errors);
    for (const std::string name : {"c/d", ".."})
      {
        write(name, 1.);
        const Outcome outcome = run_damage("pairs.h5", "");
        check(outcome.code == 2 && has(outcome.errors, "contact pair '" + name),
              "the name '" + name + "' is refused: " + outcome.errors);
      }
  }



  /** Times that begin again or are no numbers, where the window, or the first
   * and the last time, do not show them. */
  void
  broken_times()
  {
    HistoryLayout layout;
    for (const double y : {0., 1e-3})
      for (const double x : {0., 1e-3})
        layout.points.push_back({{x, y, 0.}});
    layout.areas.assign(4, .25e-6);
    layout.has_gap = layout.has_slip_rate = layout.has_resultants = false;
    layout.has_status                                             = false;
    constexpr std::size_t n                                       = 20;
    const auto            run =
      [&](const std::function<void(std::vector<double> &)> &break_times) {
        HistorySamples s;
        for (std::size_t i = 0; i < n; ++i)
          s.time.push_back(1e-3 * double(i));
        s.pressure.assign(4 * n, 1e6);
        s.traction.assign(8 * n, 1e5);
        break_times(s.time);
        HistoryWriter writer("times.h5", layout);
        writer.append(s);
        writer.finish();
        return run_damage("times.h5\n  set Start time = 12e-3", "");
      };
    const Outcome whole = run([](std::vector<double> &) {});
    check(whole.code == 0, "whole times pass: " + whole.errors);
    const auto refuses =
      [&](const std::string                                &claim,
          const std::string                                &part,
          const std::function<void(std::vector<double> &)> &break_times) {
        const Outcome outcome = run(break_times);
        check(outcome.code == 2 && has(outcome.errors, "times.h5' " + part),
              claim + ": " + outcome.errors);
      };
    const std::string       no_number = "holds a value that is not a number";
    static constexpr double infinite  = std::numeric_limits<double>::infinity();
    refuses("a second recording whose times begin again",
            "has times that do not increase, at 0 s",
            [](std::vector<double> &t) {
              for (std::size_t i = 3; i < n; ++i)
                t[i] = 1e-3 * double(i - 3);
            });
    refuses("times that are infinite from some sample on",
            no_number,
            [](std::vector<double> &t) {
              std::fill(t.end() - 4, t.end(), infinite);
            });
    refuses("a last time that is no number",
            no_number,
            [](std::vector<double> &t) { t.back() = std::nan(""); });
    refuses("a first time of minus infinity",
            no_number,
            [](std::vector<double> &t) { t.front() = -infinite; });
  }



  /** The damage at an exponent of 100 under stresses far above the one of
   * reference. */
  void
  beyond_numbers()
  {
    HistoryLayout layout;
    for (const double y : {0., 1e-3})
      for (const double x : {0., 1e-3})
        layout.points.push_back({{x, y, 0.}});
    layout.areas.assign(4, .25e-6);
    layout.has_gap = layout.has_slip_rate = layout.has_resultants = false;
    layout.has_status                                             = false;
    HistorySamples s;
    s.time = {0., 1., 2.};
    s.pressure.assign(12, 0.);
    std::fill_n(s.pressure.begin() + 4, 4, 1e12);
    s.traction.assign(24, 0.);
    HistoryWriter writer("huge.h5", layout);
    writer.append(s);
    writer.finish();
    for (const std::string rule : {"none", "goodman"})
      {
        const Outcome outcome = run_damage(
          "huge.h5",
          "  set Exponents = 100\n  set Reference stress = 1\n"
          "  set Mean stress = " +
            rule + "\n" +
            (rule == "none" ? "" : "  set Ultimate strength = 1e7\n"));
        check(outcome.code == 2 &&
                has(outcome.errors, "'Fatigue/Exponents' 100 at node 0 is") ==
                  (rule == "none") &&
                has(outcome.errors, "a mean stress of the history exceeds") ==
                  (rule == "goodman"),
              rule +
                ": what makes the damage infinite is said: " + outcome.errors);
      }
  }
} // namespace



int
main(int argc, char **argv)
{
  check(argc == 2, "one argument");
  program = argv[1];
  doubled_nodes_and_late_changes();
  beyond_numbers();
  unlike_pairs();
  broken_times();
}
