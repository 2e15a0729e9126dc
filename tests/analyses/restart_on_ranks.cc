// SPDX-License-Identifier: LGPL-2.1-or-later

// A transient on two ranks that is stopped and run again goes on with the
// forces of one that is not: modes of the bodies, which repeat on one rank
// alone, are turned into those that the motion is saved in. The block and its
// slab are square, so that modes share frequencies. Arguments: mpirun, the
// program.

#include <squeal/results/table.h>

#include "program.h"
#include "worst.h"

#include <chrono>
#include <thread>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  const std::string scene = R"(set Analysis = transient
subsection Scene
  set Bodies   = slab, shoe
  set Supports = base, back, sides
  set Loads    = press
  set Contacts = face
  subsection Body slab
    set Shape         = block
    set Size          = 0.06, 0.06, 0.01
    set Position      = 0, 0, -0.01
    set Cells         = 4, 4, 1
    set Young modulus = 1.1e11
    set Density       = 7200
  end
  subsection Body shoe
    set Shape         = block
    set Size          = 0.02, 0.02, 0.03
    set Cells         = 2, 2, 2
    set Young modulus = 9e9
    set Density       = 2500
  end
  subsection Support base
    set Body = slab
    set Face = z_min
  end
  subsection Support back
    set Body = shoe
    set Face = z_max
    set Kind = guided
  end
  subsection Support sides
    set Body       = shoe
    set Face       = z_max
    set Kind       = components
    set Components = x, y
  end
  subsection Load press
    set Body  = shoe
    set Face  = z_max
    set Force = 0, 0, -60
  end
  subsection Contact face
    set Formulation          = mortar
    set Source body          = shoe
    set Source face          = z_min
    set Target body          = slab
    set Target face          = z_max
    set Friction coefficient = 0.3
    set Transverse slip term = true
    set Sliding speed        = 0.3
    set Normal force         = 60
  end
  subsection Damping
    set Model             = whole model
    set Mass damping      = 10
    set Stiffness damping = 2e-7
  end
end
subsection Transient
  set Cut-off             = 60e3
  set Time step           = 1e-6
  set Sample interval     = 4e-6
  set End time            = 0.04
  set Disturbance         = 1e-8
  set Checkpoint interval = 0.05
end
subsection Output
  set Plots  = false
  set Report = false
end
)";

  std::vector<std::string>
  command(char *argv[], const std::string &directory)
  {
    return {argv[1],
            "-np",
            "2",
            argv[2],
            "--set",
            "Output directory = " + directory,
            "scene.prm"};
  }

  /** Stops a run as soon as it has a checkpoint; whether that was in time. */
  bool
  is_stopped(char *argv[])
  {
    std::filesystem::remove_all("stopped");
    const Outcome outcome =
      run_program(command(argv, "stopped"), {}, [](const pid_t id) {
        for (unsigned int i = 0;
             i < 6000 && !std::filesystem::exists("stopped/checkpoint.h5");
             ++i)
          std::this_thread::sleep_for(std::chrono::milliseconds(5));
        ::kill(id, SIGTERM);
      });
    return outcome.code != 0 &&
           std::filesystem::exists("stopped/checkpoint.h5");
  }
} // namespace

int
main(int argc, char *argv[])
{
  check(argc == 3, "two arguments: mpirun and program");
  write_text("scene.prm", scene);
  std::filesystem::remove_all("whole");
  const Outcome whole = run_program(command(argv, "whole"));
  check(whole.code == 0, "runs to its end: " + whole.errors);
  bool was_stopped = false;
  for (unsigned int i = 0; i < 5 && !was_stopped; ++i)
    was_stopped = is_stopped(argv);
  check(was_stopped, "stopped in the middle with a checkpoint");
  const Outcome last = run_program(command(argv, "stopped"));
  check(last.code == 0, "ends in the second run: " + last.errors);
  const std::string said = unbroken(last.output);
  check(said.find("continues from") != std::string::npos,
        "which goes on: " + said);
  const std::vector<double> forces =
                              read_csv("whole/forces.csv").reals("normal_n"),
                            again =
                              read_csv("stopped/forces.csv").reals("normal_n");
  check(forces.size() == again.size() && forces.size() > 9000,
        "the same samples");
  Worst off;
  for (std::size_t i = 0; i < forces.size(); ++i)
    off.add(std::abs(forces[i] - again[i]));
  check(off.largest() < 1e-5, "no force jumps at the place of the checkpoint");
}
