// SPDX-License-Identifier: LGPL-2.1-or-later

// Where a motion far above the band grows so fast that it takes over in a
// period of the pair that a limit cycle is sought from, the contact of that
// motion has no solution, at once or after a while: the search has not
// converged, and the log says why, alone and in a campaign. Where the cut-off
// leaves no motion at all there is nothing to seek, and the run is refused.
// Argument: the program.

#include <squeal/results/table.h>

#include "program.h"

using namespace squeal;
using namespace squeal::testing;

namespace
{
  /** Two pads of a floating caliper on a plate, whose pair of 1908 Hz grows;
   * with this cut-off another motion does at 1.2 MHz, by e^60 in a period of
   * it. */
  const std::string cycle = R"(
set Analysis         = limit cycle
set Output directory = out
set Overwrite        = true
subsection Scene
  set Bodies   = disc, upper, lower, caliper
  set Ties     = piston
  set Springs  = left, right, one, other, back
  set Loads    = press, reaction
  set Contacts = above, below
  subsection Body disc
    set Size          = 0.06, 0.08, 0.01
    set Position      = 0, 0, -0.01
    set Cells         = 2, 4, 1
    set Young modulus = 110e9
    set Density       = 7200
  end
  subsection Body upper
    set Size          = 0.02, 0.03, 0.01
    set Position      = 0, 0, 0
    set Cells         = 1, 2, 1
    set Young modulus = 3e9
    set Density       = 2500
  end
  subsection Body lower
    set Size          = 0.02, 0.03, 0.01
    set Position      = 0, 0, -0.02
    set Cells         = 1, 2, 1
    set Young modulus = 3e9
    set Density       = 2500
  end
  subsection Body caliper
    set Shape    = rigid
    set Mass     = 0.3
    set Inertia  = 1e-4, 2e-4, 1.5e-4
    set Position = 0.002, 0.001, -0.03
  end
  subsection Tie piston
    set Source body = lower
    set Source face = z_min
    set Target body = caliper
  end
  subsection Spring left
    set Kind        = area
    set Body        = disc
    set Face        = y_min
    set Stiffnesses = 2e11, 3e11, 2e11
  end
  subsection Spring right
    set Kind        = area
    set Body        = disc
    set Face        = y_max
    set Stiffnesses = 2e11, 3e11, 2e11
  end
  subsection Spring one
    set Body        = caliper
    set First point = 0.02, 0.02, -0.03
    set Stiffnesses = 2e7, 1.2e7, 1e6
  end
  subsection Spring other
    set Body        = caliper
    set First point = -0.02, -0.015, -0.025
    set Stiffnesses = 2e7, 1.2e7, 1e6
  end
  subsection Spring back
    set Kind        = area
    set Body        = upper
    set Face        = z_max
    set Stiffnesses = 8e10, 5e10, 0
    set Direction   = 0, -0.8, 1
    set Stiffness   = 4e10
  end
  subsection Load press
    set Body  = upper
    set Face  = z_max
    set Force = 0, 0, -400
  end
  subsection Load reaction
    set Body  = caliper
    set Force = 0, 0, 400
  end
  subsection Contact above
    set Formulation          = mortar
    set Source body          = upper
    set Source face          = z_min
    set Target body          = disc
    set Target face          = z_max
    set Sliding speed        = 0.4
    set Friction coefficient = 0.5
    set Transverse slip term = true
  end
  subsection Contact below
    set Formulation          = mortar
    set Source body          = lower
    set Source face          = z_max
    set Target body          = disc
    set Target face          = z_min
    set Sliding speed        = 0.4
    set Friction coefficient = 0.5
    set Transverse slip term = true
  end
  subsection Damping
    set Model             = whole model
    set Mass damping      = 5
    set Stiffness damping = 5e-7
  end
end
subsection Discretization
  set Degree         = 1
  set Estimate error = false
end
subsection Eigenvalues
  set Lowest frequency  = 100
  set Highest frequency = 15000
end
subsection Output
  set Plots  = false
  set Report = false
end
subsection Transient
  set Cut-off = 50000
end
subsection Limit cycle
  set Run time = 0.002
)";

  const std::string campaign = R"(
  set Campaign = true
end
subsection Sweep
  set Axes = mu
  subsection Axis mu
    set Entries = Scene/Contact above/Friction coefficient, Scene/Contact below/Friction coefficient
    set Scale   = list
    set Values  = 0, 0.5
  end
end
)";

  /** A pad pressed on a plate, both on springs, whose modes all lie above the
   * cut-off. */
  const std::string without_motions = R"(
set Analysis         = limit cycle
set Output directory = out
set Overwrite        = true
subsection Scene
  set Bodies   = pad, disc
  set Springs  = back, bed
  set Loads    = press
  set Contacts = belt
  subsection Body pad
    set Size          = 0.02, 0.03, 0.01
    set Young modulus = 3e9
    set Density       = 2500
    set Cells = 1,1,1
  end
  subsection Spring back
    set Kind        = area
    set Body        = pad
    set Face        = z_max
    set Stiffnesses = 8e10, 5e10, 6e10
  end
  subsection Body disc
    set Size     = 0.04, 0.06, 0.01
    set Position = 0, 0, -0.01
    set Cells    = 2, 2, 1
  end
  subsection Spring bed
    set Kind        = area
    set Body        = disc
    set Face        = z_min
    set Stiffnesses = 2e11, 3e11, 2e11
  end
  subsection Load press
    set Body  = pad
    set Face  = z_max
    set Force = 0, 0, -400
  end
  subsection Contact belt
    set Formulation          = mortar
    set Source body          = pad
    set Source face          = z_min
    set Target body          = disc
    set Target face          = z_max
    set Sliding speed        = 0.4
    set Friction coefficient = 0.5
    set Friction direction   = fixed y
  end
end
subsection Discretization
  set Degree         = 1
  set Estimate error = false
end
subsection Eigenvalues
  set Lowest frequency  = 0.5
  set Highest frequency = 1
end
subsection Transient
  set Cut-off = 2
end
)";

  Outcome
  run(const std::string &program, const std::string &text)
  {
    std::filesystem::remove_all("out");
    write_text("run.prm", text);
    const Outcome o = run_program({program, "run.prm"});
    check(o.code == 0, "the search ends: " + o.errors);
    return o;
  }

  /** With less friction it takes over in the run that leads to the cycle. */
  std::string
  that_breaks_off_later()
  {
    std::string text = cycle;
    for (const auto &[old, other] :
         {std::make_pair("coefficient = 0.5", "coefficient = 0.36"),
          std::make_pair("Run time = 0.002", "Run time = 0.02")})
      for (std::size_t at = text.find(old); at != std::string::npos;
           at             = text.find(old, at + 1))
        text.replace(at, std::string(old).size(), other);
    return text;
  }

  void
  says_why(const Outcome &o)
  {
    check(unbroken(o.output + o.errors).find("has broken off: the contact") !=
            std::string::npos,
          "the log says why: " + o.output + o.errors);
  }

  void
  refuses_without_motions(const std::string &program)
  {
    write_text("low.prm", without_motions);
    const Outcome o = run_program({program, "low.prm"});
    check(o.code == 2 && o.errors.find("no mode of the bodies lies below") !=
                           std::string::npos,
          "a limit cycle without motions is refused: " + o.errors);
  }
} // namespace

int
main(int argc, char **argv)
{
  check(argc == 2, "the program is given");
  for (const std::string &scene : {cycle, that_breaks_off_later()})
    {
      says_why(run(argv[1], scene + "end\n"));
      check(read_csv("out/limit_cycle.csv").text(0, "cycle_status") ==
              "not converged",
            "the search has not converged");
    }
  says_why(run(argv[1], cycle + campaign));
  const Table points = read_csv("out/campaign.csv");
  check(points.n_rows() == 2 && points.text(0, "outcome") == "steady sliding" &&
          points.text(1, "outcome") == "no limit cycle found",
        "a campaign goes on: " + points.text(0, "outcome") + ", " +
          points.text(1, "outcome"));
  refuses_without_motions(argv[1]);
}
