// SPDX-License-Identifier: LGPL-2.1-or-later

// Which Floquet multiplier is the trivial one is told by the direction of the
// motion, not by what is nearest to 1: on two masses of which one opens and one
// sticks another one, 0.9863 at any number of steps, is nearer with few steps.
// Argument: the program.

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
1 1 0.2235058377942003
2 2 0.2235058377942003
3 3 0.2235058377942003
4 4 0.089630571200579254
5 5 0.089630571200579254
6 6 0.089630571200579254
)");
    write_text("K.mtx", R"(%%MatrixMarket matrix coordinate real symmetric
6 6 15
1 1 16187004.675187435
2 1 -7667445.3110678187
2 2 24288014.137079194
3 1 6181969.5838102596
3 2 -10260366.928959901
3 3 19841649.082043443
4 1 -540173.28352390311
4 4 16730481.249058502
5 2 -540173.28352390311
5 4 2903872.8506720648
5 5 5975588.8969286643
6 3 -540173.28352390311
6 4 -912639.31545341923
6 5 5463327.0023103636
6 6 13802991.184535896
)");
    write_text("nodes.csv", R"(dof,node,component,x,y,z,body,load_press
1,1,1,0,0,0,b,0
2,1,2,0,0,0,b,0
3,1,3,0,0,0,b,-105.1045090589723
4,2,1,0,0.01,0,b,0
5,2,2,0,0.01,0,b,0
6,2,3,0,0.01,0,b,-26.580569098796783
)");
    write_text("contact.csv",
               R"(contact,pair,side,direction,node,component,weight,x,y,z,area
belt,1,source,normal,1,3,1,0,0,0,0.0001
belt,1,source,sliding,1,2,1,0,0,0,0.0001
belt,1,source,transverse,1,1,1,0,0,0,0.0001
belt,2,source,normal,2,3,1,0,0.01,0,0.0001
belt,2,source,sliding,2,2,1,0,0.01,0,0.0001
belt,2,source,transverse,2,1,1,0,0.01,0,0.0001
)");
  }

  struct Cycle
  {
    double      multiplier, multiplier_error, frequency, frequency_error;
    std::string stability;
  };

  Cycle
  cycle_of(const std::string &program, const unsigned int n_steps)
  {
    write_text("cycle.prm",
               matrix_scene("belt", R"(  subsection Contact belt
    set Source body = b
    set Formulation = springs
    set Normal stiffness = 38691693.147044979
    set Tangential stiffness = 48452637.636312775
    set Contact state = preload
    set Transverse slip term = true
    set Sliding speed = 0.0089131031934616429
    set Friction coefficient = 1.1392899985829956
    set Normal force = 100
  end
  subsection Damping
    set Model = whole model
    set Mass damping = 73.135853105855261
    set Stiffness damping = 1.6662496864839665e-06
  end
)") + R"(subsection Eigenvalues
  set Lowest frequency  = 1
  set Highest frequency = 6000
end
subsection Transient
  set Cut-off = 20000
end
subsection Limit cycle
  set Run time = 0.1
  set Steps per period = )" +
                 std::to_string(n_steps) + "\nend\n");
    const Outcome o = run_program({program, "cycle.prm"});
    check(o.code == 0, "the limit cycle is found: " + o.errors);
    const Table t = read_csv("out/limit_cycle.csv");
    return {t.real(0, "largest_multiplier"),
            t.real(0, "largest_multiplier_error"),
            t.real(0, "frequency_hz"),
            t.real(0, "frequency_error_hz"),
            t.text(0, "stability")};
  }
} // namespace

int
main(int, char **arguments)
{
  const std::string program = arguments[1];
  write_model();
  const Cycle rough = cycle_of(program, 256), fine = cycle_of(program, 2048);
  check(fine.stability == "stable", "the cycle is stable: " + fine.stability);
  check(rough.stability != "unstable",
        "few steps do not call it unstable: " + rough.stability);
  Worst apart;
  apart.add(std::abs(rough.multiplier - fine.multiplier));
  check(apart.largest() < 1e-4, "few steps have the same largest multiplier");
  check(rough.multiplier_error > .02 && fine.multiplier_error < .005,
        "their error is what the trivial one is off by");
  Worst beyond;
  beyond.add(std::abs(rough.frequency - fine.frequency) -
             (rough.frequency_error + fine.frequency_error));
  check(beyond.largest() < 0., "both frequencies are within their errors");
}
