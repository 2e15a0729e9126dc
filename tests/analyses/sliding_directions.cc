// SPDX-License-Identifier: LGPL-2.1-or-later

// A block on a floor that slides the other way: its leading edge is on the
// other side, in the transient as in the damage map of its history; while the
// sliding turns round the leading edge turns with it; a campaign does not go
// over friction of both signs. And what a trigger is told of: nothing after the
// end of a run, and nothing that an unstable run owes to it. Arguments: the
// programs of both parts and the folder of parameter files.

#include <squeal/results/table.h>

#include "brief_runs.h"

#include <cmath>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  std::string program, tribology, folder;

  const std::string scene = R"(set Analysis         = transient
set Output directory = out
set Overwrite        = true
subsection Scene
  set Bodies   = floor, block
  set Supports = floor_bottom, top, top_sides
  set Loads    = press
  set Contacts = block_floor
  subsection Body floor
    set Shape         = block
    set Size          = 0.03, 0.03, 0.01
    set Position      = 0, 0, -0.01
    set Cells         = 3, 3, 1
    set Young modulus = 16e9
    set Density       = 2500
  end
  subsection Body block
    set Shape         = block
    set Size          = 0.01, 0.02, 0.01
    set Cells         = 2, 4, 2
    set Young modulus = 2e9
    set Density       = 2500
  end
  subsection Support floor_bottom
    set Body = floor
    set Face = z_min
  end
  subsection Support top
    set Body = block
    set Face = z_max
    set Kind = guided
  end
  subsection Support top_sides
    set Body       = block
    set Face       = z_max
    set Kind       = components
    set Components = x, y
  end
  subsection Load press
    set Body  = block
    set Face  = z_max
    set Force = 0, 0, -100
  end
  subsection Contact block_floor
    set Source body          = block
    set Source face          = z_min
    set Target body          = floor
    set Target face          = z_max
    set Formulation          = mortar
    set Contact state        = preload
    set Friction direction   = given
    set Sliding direction    = 0, 1, 0
    set Sliding speed        = 0.12
    set Friction coefficient = 0.3
    set Normal force         = 100
  end
  subsection Damping
    set Model             = whole model
    set Mass damping      = 2000
    set Stiffness damping = 1e-7
  end
end
subsection Discretization
  set Degree         = 1
  set Estimate error = false
end
subsection Eigenvalues
  set Lowest frequency  = 500
  set Highest frequency = 20000
end
subsection Transient
  set Integrator      = implicit
  set Cut-off         = 30e3
  set Disturbance     = 1e-8
  set Time step       = 1e-6
  set End time        = 4e-3
  set Sample interval = 1e-5
  set History start   = 0
end
subsection Output
  set Plots = false
end
)";

  Outcome
  run(const std::string              &which,
      const std::string              &text,
      const std::vector<std::string> &settings)
  {
    write_text("run.prm", text);
    std::vector<std::string> words = {which};
    for (const std::string &setting : settings)
      words.insert(words.end(), {"--set", setting});
    words.push_back("run.prm");
    return run_program(words);
  }

  Outcome
  passes(const std::string              &which,
         const std::string              &text,
         const std::vector<std::string> &settings)
  {
    Outcome o = run(which, text, settings);
    check(o.code == 0, "runs: " + o.errors);
    return o;
  }

  void
  refused(const std::vector<std::string> &settings,
          const std::string              &more,
          const std::string              &part,
          const std::string              &claim)
  {
    const Outcome o = run(program, scene + more, settings);
    check(o.code != 0, claim);
    check(unbroken(o.errors).find(part) != std::string::npos,
          claim + ": '" + part + "' in " + o.errors);
  }

  /** Where the map says that the damage is largest, in a direction. Returns
   * how much more pressure is at the leading edge. */
  double
  check_damage(const std::string &direction)
  {
    std::filesystem::remove_all("out");
    passes(program,
           scene,
           {"Scene/Contact block_floor/Sliding direction = " + direction});
    const double factor =
      read_csv("out/transient.csv").real(0, "leading_edge_factor");
    std::filesystem::rename("out/contact_history.h5", "history.h5");
    const std::string damage = "set Analysis = damage\nset Output directory = "
                               "damage\nset Overwrite = true\nsubsection "
                               "History\n  set File = history.h5\nend\n"
                               "subsection Output\n  set Plots = false\nend\n"
                               "subsection Subsurface\n  set Compute = false\n"
                               "end\n";
    const auto        first_screen_has = [](const std::string &part) {
      return text_of("damage/report.html").find(part) != std::string::npos;
    };
    passes(tribology, damage, {});
    check(first_screen_has("most damage near the leading edge"),
          "sliding along " + direction + ": most damage at the leading edge");
    passes(tribology, damage, {"Fatigue/Mean stress = swt"});
    check(first_screen_has("compressive") && !first_screen_has("do not vary"),
          "damage that compression hides is not 'forces do not vary'");
    return factor;
  }

  void
  check_reversal(const double forwards, const double backwards)
  {
    check(std::abs(backwards / forwards - 1.) < 1e-3,
          "the leading edge of the reversed sliding is the other one: " +
            std::to_string(forwards) + ", " + std::to_string(backwards));
    const Outcome o =
      passes(program, scene, {"Transient/Final speed ratio = -1"});
    const double turned =
      read_csv("out/transient.csv").real(0, "leading_edge_factor");
    check(turned > 1.2, "it turns with the sliding: " + std::to_string(turned));
    const std::string said = unbroken(o.output);
    const auto        at   = said.find("least macroscopic friction ");
    check(at == std::string::npos || std::stod(said.substr(at + 27)) > .29,
          "friction of a reversed sliding is compared by its size: " + said);
  }

  void
  check_refusals()
  {
    refused({},
            "subsection Sweep\n  set Axes = mu\n  subsection Axis mu\n    set "
            "Entries = Scene/Contact block_floor/Friction coefficient\n    set "
            "Scale = list\n    set Values = -0.3, 0.3\n  end\nend\n",
            "a campaign needs one of at least 0",
            "a campaign over friction of both signs is refused");
    refused({"Transient/Friction impulse = 0.001",
             "Transient/Friction impulse time = 0.5"},
            "",
            "Friction impulse time",
            "a trigger after the end of the run is refused");
    refused({"Transient/Hammer/Body = block",
             "Transient/Hammer/Face = z_max",
             "Transient/Hammer/Force = 0, 0, -1",
             "Transient/Hammer/Time = 0.02"},
            "",
            "Transient/Hammer",
            "a blow after the end of the run is refused");
  }

  /** The pin grows by itself, whatever strikes it. */
  void
  check_unstable_trigger()
  {
    passes(program,
           pin_on_beam(folder,
                       "subsection Sweep\n  set Axes = mu\n  subsection Axis "
                       "mu\n    set Entries = Scene/Contact pin_beam/Friction "
                       "coefficient\n    set Scale = list\n    set Values = "
                       "0.5\n  end\nend\n"),
           {"Transient/Friction impulse = 0.001"});
    const Table t = read_csv("out/campaign.csv");
    check(t.text(0, "outcome") == "squeal by itself",
          "an unstable run squeals by itself: " + t.text(0, "outcome"));
  }
  /** An abutment that the pin sticks to is no zone of stick-slip. */
  void
  check_sticking_nodes()
  {
    passes(program,
           pin_on_beam(folder,
                       R"(drop Scene/Support back_sides
subsection Scene
  set Bodies   = beam, pin, stop
  set Springs  = hold
  set Supports = left_end, right_end, back, wall
  set Contacts = pin_beam, abutment
  subsection Body stop
    set Shape         = block
    set Size          = 0.010, 0.010, 0.010
    set Position      = 0, 0.010, 0.005
    set Cells         = 2, 2, 2
    set Young modulus = 70e9
    set Density       = 2700
  end
  subsection Support wall
    set Body = stop
    set Face = y_max
  end
  subsection Spring hold
    set Kind        = area
    set Body        = pin
    set Face        = z_max
    set Stiffnesses = 1e8, 1e8, 0
  end
  subsection Contact abutment
    set Formulation          = mortar
    set Contact state        = preload
    set Source body          = stop
    set Source face          = y_min
    set Target body          = pin
    set Target face          = y_max
    set Friction coefficient = 0.8
    set Friction direction   = given
    set Sliding direction    = 0, 0, 1
    set Sliding speed        = 0
  end
end
)",
                       "0.002"),
           {});
    const Table  zones   = read_csv("out/zones.csv");
    unsigned int n_stick = 0;
    for (std::size_t i = 0; i < zones.n_rows(); ++i)
      {
        const bool sticks = zones.real(i, "stick_share") > 0. &&
                            zones.real(i, "slip_share") == 0. &&
                            zones.real(i, "open_share") == 0.;
        n_stick += sticks;
        check(sticks == (zones.text(i, "zone") == "stick"),
              "what always sticks is a zone of its own: " +
                zones.text(i, "zone"));
      }
    check(n_stick > 0 && read_csv("out/transient.csv").real(0, "n_sticking") ==
                           double(n_stick),
          "some nodes of the abutment always stick, and are counted");
  }
} // namespace

int
main(int argc, char **argv)
{
  check(argc == 4,
        "usage: test_analyses_sliding_directions PROGRAM TRIBOLOGY "
        "FOLDER");
  program               = argv[1];
  tribology             = argv[2];
  folder                = argv[3];
  const double forwards = check_damage("0, 1, 0");
  check(forwards > 1.2, "pressure is largest at the leading edge");
  check_reversal(forwards, check_damage("0, -1, 0"));
  for (const char *direction : {"1, 0, 0", "-1, 0, 0"})
    check_damage(direction);
  check_refusals();
  check_unstable_trigger();
  check_sticking_nodes();
}
