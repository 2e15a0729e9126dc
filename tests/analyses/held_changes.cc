// SPDX-License-Identifier: LGPL-2.1-or-later

// A motion that is periodic only with changes of status that are those of
// another motion is no limit cycle: of two masses that rest on a contact each,
// the one at 1275 Hz, in which nodes stick that slip, is none, whatever the
// steps, and the vibration that they come to has its line at 2567.5 Hz with
// 102 N. Argument: the program.

#include <squeal/results/table.h>

#include "matrix_scene.h"
#include "program.h"
#include "worst.h"

#include <cmath>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  void
  write_model()
  {
    write_text("M.mtx", R"(%%MatrixMarket matrix coordinate real symmetric
6 6 6
1 1 1.0
2 2 1.0
3 3 1.0
4 4 0.2453118184917702
5 5 0.2453118184917702
6 6 0.2453118184917702
)");
    write_text("K.mtx", R"(%%MatrixMarket matrix coordinate real symmetric
6 6 11
1 1 67174189.53371754
3 1 -11843525.281307228
4 1 -13560745.028083328
2 2 100413263.75766967
5 2 -13560745.028083328
3 3 33299953.830262043
6 3 -13560745.028083328
4 4 70312338.04745463
6 4 -11843525.281307228
5 5 100413263.75766967
6 6 33299953.830262043
)");
    write_text("nodes.csv", R"(dof,node,component,x,y,z,body,load_press
1,1,1,0.1,0,0,pa,0
2,1,2,0.1,0,0,pa,0
3,1,3,0.1,0,0,pa,-62.54118979409419
4,2,1,0.2,0,0,pb,0
5,2,2,0.2,0,0,pb,0
6,2,3,0.2,0,0,pb,-125.38885181255888
)");
    write_text("contact.csv",
               R"(contact,pair,side,direction,node,component,weight,x,y,z,area
one,1,source,normal,1,3,1,0.1,0,0,0.0001
one,1,source,sliding,1,1,1,0.1,0,0,0.0001
one,1,source,transverse,1,2,-1,0.1,0,0,0.0001
two,2,source,normal,2,3,1,0.2,0,0,0.0001
two,2,source,sliding,2,1,1,0.2,0,0,0.0001
two,2,source,transverse,2,2,-1,0.2,0,0,0.0001
)");
  }

  std::string
  contact(const std::string &name,
          const std::string &body,
          const std::string &speed,
          const std::string &friction)
  {
    return "  subsection Contact " + name + "\n    set Source body = " + body +
           R"(
    set Formulation          = springs
    set Normal stiffness     = 39478417.60435743
    set Tangential stiffness = 78956835.20871486
    set Contact state        = preload
    set Transverse slip term = true
    set Sliding speed        = )" +
           speed + "\n    set Friction coefficient = " + friction + "\n  end\n";
  }

  std::string
  scene(const unsigned int n_steps)
  {
    return matrix_scene(
             "one, two",
             contact("one", "pa", "0.01461761197440714", "0.5680069876491787") +
               contact(
                 "two", "pb", "0.05492661521991414", "0.6392537753551364") +
               R"(  subsection Damping
    set Model        = whole model
    set Mass damping = 804.4089612913167
  end
)") + R"(subsection Eigenvalues
  set Lowest frequency  = 1
  set Highest frequency = 5000
end
subsection Transient
  set Cut-off = 40000
end
subsection Limit cycle
  set Pair frequency   = 1303.4
  set Run time         = 0.15
  set Steps per period = )" +
           std::to_string(n_steps) + "\nend\n";
  }

  /** No motion but that of the two masses is called a limit cycle. */
  void
  is_honest(const std::string &program, const unsigned int n_steps)
  {
    const std::string name = ", " + std::to_string(n_steps) + " steps";
    const Outcome     run  = run_text(program, scene(n_steps));
    check(run.code == 0, "runs" + name + run.errors);
    const Table       cycles = read_csv("out/limit_cycle.csv");
    const std::string status = cycles.text(0, "cycle_status");
    check(status == "periodic" || status == "not converged" ||
            status == "no period",
          "is told what it is: " + status + name);
    if (status == "periodic")
      {
        check_close(cycles.real(0, "dominant_line_hz"),
                    2567.5,
                    2e-3,
                    "the line of the motion" + name);
        check_close(
          cycles.real(0, "rms_normal_n"), 102., .02, "its force" + name);
      }
    else
      check(cycles.real(0, "residual") > 1e-3,
            "with what the motion found misses" + name);
  }
} // namespace

int
main(int argc, char *argv[])
{
  check(argc == 2, "one argument: the program");
  write_model();
  for (const unsigned int n_steps : {256, 1024})
    is_honest(argv[1], n_steps);
}
