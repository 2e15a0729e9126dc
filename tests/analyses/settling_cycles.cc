// SPDX-License-Identifier: LGPL-2.1-or-later

// Two sliding masses whose limit cycle is stable, but is settled to so slowly
// that a run of the default length does not tell it: no verdict follows from
// that, and the run time is named that tells, after which the cycle is found.
// The same in a campaign. With more friction disturbances of the motion grow:
// it is known to have no period. Argument: the program.

#include <squeal/results/table.h>

#include "matrix_scene.h"
#include "program.h"

using namespace squeal;
using namespace squeal::testing;

namespace
{
  /** The masses are coupled weakly; friction drives the first at 1443 Hz, and
   * disturbances of its limit cycle at 1395 Hz decay by 12 1/s. */
  void
  write_masses()
  {
    write_text("M.mtx",
               "%%MatrixMarket matrix coordinate real symmetric\n6 6 6\n"
               "1 1 1\n2 2 1\n3 3 1\n4 4 1\n5 5 1\n6 6 1\n");
    write_text("K.mtx",
               "%%MatrixMarket matrix coordinate real symmetric\n6 6 11\n"
               "1 1 1.74e8\n2 2 8.2e7\n3 2 -4e7\n3 3 2.8666666666666664e7\n"
               "4 1 -2e6\n4 4 5.12e8\n5 2 -2e6\n5 5 2.02e8\n"
               "6 3 -2e6\n6 5 -1e8\n6 6 6.8666666666666657e7\n");
    write_text("contact.csv",
               "pair,contact,side,direction,node,component,weight,x,y,z,area\n"
               "1,one,source,normal,1,3,1,0,0,0,1e-4\n"
               "1,one,source,sliding,1,2,1,0,0,0,1e-4\n"
               "1,one,source,transverse,1,1,1,0,0,0,1e-4\n"
               "2,two,source,normal,2,3,1,0.1,0,0,1e-4\n"
               "2,two,source,sliding,2,2,1,0.1,0,0,1e-4\n"
               "2,two,source,transverse,2,1,1,0.1,0,0,1e-4\n");
    write_text("nodes.csv",
               "dof,node,component,x,y,z,body,load_press\n"
               "1,1,1,0,0,0,first,0\n2,1,2,0,0,0,first,0\n"
               "3,1,3,0,0,0,first,-100\n4,2,1,0.1,0,0,second,0\n"
               "5,2,2,0.1,0,0,second,0\n6,2,3,0.1,0,0,second,-150\n");
  }

  const std::string scene = matrix_scene("one, two", R"(  subsection Contact one
    set Source body          = first
    set Formulation          = springs
    set Normal stiffness     = 5.333333333333333e7
    set Tangential stiffness = 2e9
    set Contact state        = preload
    set Friction coefficient = 0.8
    set Transverse slip term = true
    set Sliding speed        = 0.1
  end
  subsection Contact two
    set Source body          = second
    set Formulation          = springs
    set Normal stiffness     = 13.33333333333333e7
    set Tangential stiffness = 2e9
    set Contact state        = preload
    set Friction coefficient = 0.3
    set Transverse slip term = true
    set Sliding speed        = 0.3
  end
  subsection Damping
    set Model             = whole model
    set Mass damping      = 20
    set Stiffness damping = 1e-7
  end
)") + R"(subsection Eigenvalues
  set Highest frequency = 5000
end
subsection Transient
  set Cut-off = 40000
end
)";

  const std::string campaign = R"(
subsection Limit cycle
  set Campaign = true
end
subsection Sweep
  set Axes = mu
  subsection Axis mu
    set Entries = Scene/Contact one/Friction coefficient
    set Scale   = list
    set Values  = 0.8
  end
end
)";

  const std::string longer = R"(
subsection Limit cycle
  set Every growing pair = false
  set Run time           = 0.8
end
)";

  /** The scene with @p friction in both contacts. */
  std::string
  with_friction(const std::string &friction)
  {
    std::string       text = scene;
    const std::string name = "Friction coefficient = ";
    for (std::size_t at = text.find(name); at != std::string::npos;
         at             = text.find(name, at + 1))
      text.replace(at + name.size(), 3, friction);
    return text;
  }

  Outcome
  run(const std::string &program, const std::string &text)
  {
    write_text("masses.prm", text);
    const Outcome o = run_program({program, "masses.prm"});
    check(o.code == 0, "it finishes: " + o.errors);
    return o;
  }

  /** Whether @p word, which is not broken, stands in what @p o prints. */
  bool
  says(const Outcome &o, const std::string &word)
  {
    return (o.output + o.errors).find(word) != std::string::npos;
  }
} // namespace

int
main(int, char **argv)
{
  const std::string program = argv[1];
  write_masses();
  const Outcome     soon = run(program, scene);
  const std::string status =
    read_csv("out/limit_cycle.csv").text(0, "cycle_status");
  check(status != "aperiodic" && status != "periodic",
        "a run that may still settle has no verdict: " + status);
  check(says(soon, "settling"), "which is said");
  run(program, scene + campaign);
  check(read_csv("out/campaign.csv").text(0, "outcome") ==
          "no limit cycle found",
        "nor has the point of a campaign");
  run(program,
      scene + "subsection Limit cycle\n set Run time = 0.25\n"
              " set Steps per period = 200\nend\n");
  const Table found = read_csv("out/limit_cycle.csv");
  check(found.text(0, "cycle_status") == "periodic" &&
          found.text(0, "stability") == "stable",
        "a longer run settles to a stable cycle");
  check_close(found.real(0, "frequency_hz"), 1395.26, 1e-3, "frequency");
  check_close(found.real(0, "rms_normal_n"), 55.18, 5e-3, "rms");
  // Such a motion may come near to itself at the end of one run by chance.
  unsigned int n_aperiodic = 0;
  for (const char *friction : {"1.6", "1.7", "2.3"})
    {
      run(program, with_friction(friction) + longer);
      n_aperiodic +=
        read_csv("out/limit_cycle.csv").text(0, "cycle_status") == "aperiodic";
    }
  check(n_aperiodic > 0,
        "a motion that lasts and whose disturbances grow is aperiodic");
}
