// SPDX-License-Identifier: LGPL-2.1-or-later

// Nothing slides in a pair whose sliding speed is 0, whatever its sliding
// direction: linearised analyses let its face stick where it has friction and
// leave it free along itself where it has none, about a state that is given and
// about one that loads have pressed to the limit of friction. Argument: the
// program.

#include <squeal/results/table.h>

#include "braced_pad.h"
#include "program.h"
#include "source_directory.h"
#include "worst.h"

using namespace squeal;
using namespace squeal::testing;

namespace
{
  using Settings = std::vector<std::string>;

  std::string program;

  Outcome
  run(const std::string &text, const Settings &settings)
  {
    std::filesystem::remove_all("out");
    write_text("run.prm", text);
    std::vector<std::string> words = {program};
    for (const std::string &setting : settings)
      words.insert(words.end(), {"--set", setting});
    words.push_back("run.prm");
    return run_program(words);
  }

  Table
  table_of(const std::string &text,
           const Settings    &settings,
           const std::string &name)
  {
    const Outcome o = run(text, settings);
    check(o.code == 0, "runs: " + o.errors);
    return read_csv("out/" + name);
  }

  Table
  pairs_of(const std::string &text, const Settings &settings)
  {
    return table_of(text, settings, "eigenvalues.csv");
  }

  Settings
  joined(Settings a, const Settings &b)
  {
    a.insert(a.end(), b.begin(), b.end());
    return a;
  }

  void
  check_same(const Table       &a,
             const Table       &b,
             const Settings    &columns,
             const double       rounding,
             const std::string &what)
  {
    check(a.n_rows() == b.n_rows() && a.n_rows() > 1, what + ": as many rows");
    for (const std::string &column : columns)
      {
        Worst size, off;
        for (std::size_t r = 0; r < a.n_rows(); ++r)
          {
            size.add(std::abs(b.real(r, column)));
            off.add(std::abs(a.real(r, column) - b.real(r, column)));
          }
        check(off.largest() <= 1e-9 * size.largest() + rounding,
              what + ": the same " + column);
      }
  }

  void
  same_pairs(const Table &a, const Table &b, const std::string &what)
  {
    check_same(a, b, {"frequency_hz", "sigma_per_s"}, 1e-7, what);
  }

  std::size_t
  n_unstable(const Table &pairs)
  {
    std::size_t n = 0;
    for (std::size_t r = 0; r < pairs.n_rows(); ++r)
      n += pairs.integer(r, "unstable");
    return n;
  }

  void
  refused(const std::string &text,
          const Settings    &settings,
          const std::string &part)
  {
    const Outcome o = run(text, settings);
    check(o.code == 2 && unbroken(o.errors).find(part) != std::string::npos,
          "refused by '" + part + "': " + o.errors);
  }

  const std::string belt = "Scene/Contact belt/",
                    rest = belt + "Sliding speed = 0";

  std::string
  mass_on_belt(const std::string &further = "")
  {
    return "include " SQUEAL_SOURCE_DIR "/prm/minimal/hoffmann.prm\n"
           "drop Result checks\nset Output directory = out\n"
           "subsection Output\n  set Plots = false\n  set Report = false\n"
           "end\n" +
           further;
  }

  std::string
  axis(const std::string &entry, const std::string &from, const std::string &to)
  {
    return mass_on_belt("set Analysis = sweep\nsubsection Sweep\n  set Axes = "
                        "s\n  subsection Axis s\n    set Entries = " +
                        belt + entry + "\n    set From = " + from +
                        "\n    set To = " + to +
                        "\n    set Number = 3\n  end\nend\n");
  }

  void
  mass_at_rest()
  {
    const std::string mass = mass_on_belt();
    check(n_unstable(pairs_of(mass, {})) == 1, "the mass on a belt flutters");
    const Table sticks  = pairs_of(mass, {belt + "Contact state = stick"}),
                free    = pairs_of(mass, {belt + "Friction coefficient = 0"});
    const Table resting = pairs_of(mass, {rest});
    check(n_unstable(resting) == 0, "at rest it does not");
    same_pairs(resting, sticks, "it sticks");
    same_pairs(pairs_of(mass,
                        {rest,
                         belt + "Friction law = exponential",
                         belt + "Static friction coefficient = 1.2",
                         belt + "Decay speed = 0.1"}),
               sticks,
               "also by a law that falls with the slip rate");
    same_pairs(pairs_of(mass, {rest, belt + "Friction coefficient = 0"}),
               free,
               "without friction it is free along the belt");
    refused(mass,
            {rest, belt + "Friction slope = -0.2"},
            "Friction slope' must be 0 at 'Sliding speed = 0'");
    refused(axis("Sliding speed", "0", "1"),
            {rest, belt + "Friction coefficient = 0.5"},
            "Scene/Contact belt/Contact state: with 'full' the pair sticks at "
            "rest");
    refused(axis("Friction coefficient", "0.1", "1"),
            {rest},
            "neither mass nor damping nor stiffness changes");
  }

  const std::string stop = "Scene/Contact a/";

  void
  pad_in_its_abutment()
  {
    const auto sticks = [](const Settings &by, const std::string &what) {
      same_pairs(
        pairs_of(braced_pad, by),
        pairs_of(braced_pad, joined(by, {stop + "Contact state = stick"})),
        what);
    };
    sticks({}, "an abutment sticks");
    sticks({stop + "Formulation = springs",
            stop + "Grid = 3, 3",
            stop + "Normal stiffness = 1e7"},
           "and one of springs");
    const Settings free = {stop + "Friction coefficient = 0"};
    same_pairs(pairs_of(braced_pad, free),
               pairs_of(braced_pad, joined(free, {stop + "Sliding speed = 1"})),
               "one without friction is free along its face");
    const Settings    response = {"Analysis = frequency response",
                                  "Scene/Damping/Model = whole model",
                                  "Scene/Damping/Mass damping = 30"};
    const std::string values   = "frequency_response.csv";
    check_same(table_of(braced_pad, response, values),
               table_of(braced_pad,
                        joined(response, {stop + "Contact state = stick"}),
                        values),
               {"real", "imag"},
               0.,
               "a frequency response has the same");
  }

  /** The stop alone presses the pad, up to the limit of friction; the slab
   * carries it without. */
  void
  pressed_to_the_limit()
  {
    const std::string loaded  = braced_pad + R"(
subsection Scene
  set Loads = press
  subsection Load press
    set Body  = pad
    set Face  = z_max
    set Force = 150, 60, -60
  end
end
)";
    const Settings    at_rest = {"Scene/Contact c/Sliding speed = 0",
                                 "Scene/Contact c/Friction coefficient = 0",
                                 "Scene/Contact c/Contact state = preload"},
                   pressed =
                     joined(at_rest, {stop + "Contact state = preload"});
    const Table way =
      table_of(loaded, joined(pressed, {"Analysis = preload"}), "preload.csv");
    const std::size_t last = way.n_rows() - 1;
    check(way.real(last, "a_n_slip") > 0. && way.real(last, "a_n_open") == 0.,
          "nodes of the abutment have slipped on the way, and none opens");
    const Table pairs = pairs_of(loaded, pressed);
    check(n_unstable(pairs) == 0, "nothing grows at rest");
    same_pairs(
      pairs,
      pairs_of(loaded, joined(at_rest, {stop + "Contact state = stick"})),
      "nodes at the limit of friction stick");
  }
} // namespace

int
main(int argc, char **argv)
{
  check(argc == 2, "the program is given");
  program = argv[1];
  mass_at_rest();
  pad_in_its_abutment();
  pressed_to_the_limit();
}
