// SPDX-License-Identifier: LGPL-2.1-or-later

// What a sweep says of what it does not know: contact states between its
// points, by which an edge, a probability and derivatives are in doubt, and
// samples that have no pair in the band, speeds at which the slope of friction
// jumps. Argument: the program.

#include <squeal/results/table.h>

#include "program.h"
#include "source_directory.h"

#include <string>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  /** A coarse brake with 5 x 5 springs, fewer of which are closed with more
   * friction: it is stable with mu = 0.40 and unstable with mu = 0.42. */
  const std::string pressed = "include " SQUEAL_SOURCE_DIR
                              R"(/prm/tribobrake/scene.prm
set Analysis         = sweep
set Output directory = pressed
set Overwrite        = true
subsection Scene
  set Loads = press
  subsection Body disc
    set Cells         = 24, 4, 1
    set Young modulus = 217e9
  end
  subsection Body pad
    set Cells         = 2, 2, 2
    set Young modulus = 70.8e9
  end
  subsection Body support
    set Cells = 1, 1, 8
  end
  subsection Load press
    set Body  = support
    set Face  = z_max
    set Force = 0, 0, -100
  end
  subsection Contact pad_disc
    set Grid             = 5, 5
    set Contact state    = preload
    set Normal force     = 100
    set Normal stiffness = 1.25e9
  end
end
subsection Discretization
  set Degree         = 2
  set Estimate error = false
end
subsection Eigenvalues
  set Lowest frequency  = 4400
  set Highest frequency = 5600
end
subsection Output
  set Plots  = false
  set Shapes = none
end
subsection Sweep
  set Axes               = mu
  set Exceptional points = false
  set Scatter samples    = 200
  set Sensitivities      = Scene/Contact pad_disc/Friction coefficient
  subsection Axis mu
    set Entries = Scene/Contact pad_disc/Friction coefficient
    set From    = 0.2
    set To      = 0.6
    set Number  = 3
  end
end
)";

  Outcome
  run(const std::string &program, const std::string &text)
  {
    write_text("run.prm", text);
    const Outcome o = run_program({program, "run.prm"});
    check(o.code == 0, "the run ends: " + o.errors);
    return o;
  }

  /** The three points have three states: nothing is known between them. */
  void
  states_between_points(const std::string &program)
  {
    const Outcome     o    = run(program, pressed);
    const std::string text = unbroken(o.output);
    const Table       all  = read_csv("pressed/scatter.csv");
    check(all.real(0, "undecided") == 1. &&
            all.real(0, "undecided_contact") == 1.,
          "every sample is undecided");
    // Those beyond the true edge, which is between 0.40 and 0.42.
    const double truth = (0.6 - 0.41) / 0.4;
    check(all.real(0, "lower_95") < truth && all.real(0, "upper_95") > truth,
          "the interval holds the true probability");
    check(text.find("200 of 200 samples lie between points") !=
            std::string::npos,
          "a warning counts them");

    const Table ranges = read_csv("pressed/unstable_ranges.csv");
    check(ranges.n_rows() == 1 && ranges.integer(0, "at_upper_limit") == 1,
          "one range, to the most friction");
    check_close(ranges.real(0, "lower_error_contact"),
                0.1,
                1e-3,
                "its edge is known to half a step");
    check(std::abs(ranges.real(0, "lower") - 0.41) <
            ranges.real(0, "lower_error_contact") + 0.01,
          "which holds the true edge");
    check(ranges.is_missing(0, "upper_error_contact"), "an end has no error");
    check(text.find("(contact state between points)") != std::string::npos,
          "the error of edges is that of the contact");
  }

  /** The band of 0.2 to 0.235 Hz holds no pair of hoffmann.prm with little
   * friction. */
  void
  samples_without_a_pair(const std::string &program)
  {
    const Outcome o =
      run(program, "include " SQUEAL_SOURCE_DIR R"(/prm/minimal/hoffmann.prm
drop Result checks
set Analysis         = sweep
set Output directory = empty_band
set Overwrite        = true
subsection Eigenvalues
  set Lowest frequency  = 0.2
  set Highest frequency = 0.235
end
subsection Output
  set Plots = false
end
subsection Sweep
  set Axes               = mu
  set Exceptional points = false
  set Scatter samples    = 2000
  subsection Axis mu
    set Entries = Scene/Contact belt/Friction coefficient
    set From    = 0.2
    set To      = 1.5
    set Number  = 14
  end
end
)");
    const Table drivers = read_csv("empty_band/scatter_drivers.csv");
    check(drivers.real(0, "index_sigma") > 0.8,
          "friction decides the sigma of the pairs there are: " +
            drivers.text(0, "index_sigma"));
    check(unbroken(o.output).find("2000 samples have no pair in the band") !=
            std::string::npos,
          "a warning counts the samples without one");
  }

  /** A mass on a belt whose friction has a table with a point at 0.7 m/s, which
   * is one of the sweep and not of the scene itself. */
  void
  points_of_a_table(const std::string &program)
  {
    const std::string mass_on_belt = R"(set Analysis = sweep
set Output directory = kink
set Overwrite = true
subsection Scene
  set Bodies = mass
  set Supports = plane
  set Springs = along, across
  set Contacts = belt
  subsection Body mass
    set Shape = rigid
  end
  subsection Support plane
    set Body = mass
    set Kind = components
    set Components = x, rx, ry, rz
  end
  subsection Spring along
    set Body = mass
    set Direction = 0,1,0
    set Stiffness = 1e4
  end
  subsection Spring across
    set Body = mass
    set Direction = 0,0,1
    set Stiffness = 1e4
  end
  subsection Contact belt
    set Source body = mass
    set Target body = ground
    set Grid = 1, 1
    set Normal stiffness = 5e4
    set Friction law = table
    set Friction speeds = 0, 0.3, 0.7, 2
    set Friction coefficients = 0.5, 0.45, 0.3, 0.4
    set Sliding speed = 0.5
  end
end
subsection Eigenvalues
  set Highest frequency = 100
end
subsection Output
  set Plots  = false
  set Report = false
end
subsection Sweep
  set Axes = v
  subsection Axis v
    set Entries = Scene/Contact belt/Sliding speed
    set Scale   = list
    set Values  = 0.4, 0.5, 0.7
  end
end
)";
    const std::string there        = "0.7000 m/s, is a point of its table";
    check(
      unbroken(run(program, mass_on_belt).output).find(there) !=
        std::string::npos,
      "a warning names the speed of the sweep that is a point of the table");
    check(unbroken(
            run(program, replaced_in(mass_on_belt, "0.5, 0.7\n", "0.5, 0.69\n"))
              .output)
              .find("is a point of its table") == std::string::npos,
          "and speeds beside it have none");
  }
} // namespace

int
main(int argc, char **argv)
{
  check(argc == 2, "one argument");
  states_between_points(argv[1]);
  samples_without_a_pair(argv[1]);
  points_of_a_table(argv[1]);
}
