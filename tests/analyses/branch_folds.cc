// SPDX-License-Identifier: LGPL-2.1-or-later

// Branches of limit cycles of two masses that each rest on a contact point: two
// folds closer together than the steps along the branch are found, and a branch
// that leaves its range ends on the range's end; searches along the axis find
// the second branch. A campaign says where small disturbances end in another
// cycle than large ones. Argument: the program.

#include <squeal/results/table.h>

#include "matrix_scene.h"
#include "program.h"
#include "worst.h"

#include <algorithm>
#include <cmath>
#include <limits>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  /** Three unknowns a point: two masses on springs that couple them, and below
   * each its point of contact, almost without mass. */
  void
  write_model()
  {
    write_text("M.mtx", R"(%%MatrixMarket matrix coordinate real symmetric
12 12 12
1 1 0.10000000000000001
2 2 0.10000000000000001
3 3 0.10000000000000001
4 4 0.14000000000000001
5 5 0.14000000000000001
6 6 0.14000000000000001
7 7 1.0000000000000001e-05
8 8 1.0000000000000001e-05
9 9 1.0000000000000001e-05
10 10 1.0000000000000001e-05
11 11 1.0000000000000001e-05
12 12 1.0000000000000001e-05
)");
    write_text("K.mtx", R"(%%MatrixMarket matrix coordinate real symmetric
12 12 26
1 1 6500000
2 1 200000
2 2 7300000
3 1 100000
3 2 -1100000
3 3 5000000
4 1 -500000
4 4 7100000
5 2 -400000
5 4 100000
5 5 8900000
6 3 -600000
6 5 -100000
6 6 6200000
7 1 -3000000
7 7 3000000
8 2 -2500000
8 8 2500000
9 3 -2200000
9 9 2200000
10 4 -3000000
10 10 3000000
11 5 -3500000
11 11 3500000
12 6 -2000000
12 12 2000000
)");
    write_text("nodes.csv", R"(dof,node,component,x,y,z,body,load_press
1,1,1,0,0,0.01,pad,0
2,1,2,0,0,0.01,pad,0
3,1,3,0,0,0.01,pad,-60
4,2,1,0.02,0.03,0.01,pad,0
5,2,2,0.02,0.03,0.01,pad,0
6,2,3,0.02,0.03,0.01,pad,-90
7,3,1,0,0,0,pad,0
8,3,2,0,0,0,pad,0
9,3,3,0,0,0,pad,0
10,4,1,0.02,0.03,0,pad,0
11,4,2,0.02,0.03,0,pad,0
12,4,3,0.02,0.03,0,pad,0
)");
    write_text("contact.csv",
               R"(contact,pair,side,direction,node,component,weight,x,y,z,area
c,1,source,normal,3,3,1,0,0,0,1e-4
c,1,source,sliding,3,2,1,0,0,0,1e-4
c,1,source,transverse,3,1,1,0,0,0,1e-4
c,2,source,normal,4,3,1,0.02,0.03,0,1e-4
c,2,source,sliding,4,2,1,0.02,0.03,0,1e-4
c,2,source,transverse,4,1,1,0.02,0.03,0,1e-4
)");
    write_text("model.prm", matrix_scene("c", R"(  subsection Contact c
    set Source body = pad
    set Formulation = mortar
    set Contact state = preload
    set Friction coefficient = 0.5
    set Transverse slip term = true
    set Sliding speed = 0.2
    set Normal force = 100
  end
  subsection Damping
    set Model = whole model
    set Mass damping = 20
    set Stiffness damping = 1e-7
  end
)") + R"(subsection Eigenvalues
  set Highest frequency = 3000
end
subsection Transient
  set Cut-off   = 20e3
  set Time step = 2e-6
end
subsection Limit cycle
  set Run time         = 0.3
  set Steps per period = 512
end
)");
  }

  Outcome
  run(const std::string &program,
      const std::string &axis,
      const std::string &more = "")
  {
    write_text("branch.prm",
               "include model.prm\nsubsection Sweep\n  set Axes = a\n"
               "  subsection Axis a\n    " +
                 axis + "\n  end\nend\n" + more);
    const Outcome o = run_program({program, "branch.prm"});
    check(o.code == 0, "the branch runs: " + o.errors);
    return o;
  }

  void
  hidden_folds(const std::string &program)
  {
    const Outcome o =
      run(program,
          "set Entries = Scene/Contact c/Friction coefficient\n    set From = "
          "0.01\n    set To = 0.52\n    set Number = 80");
    check(unbroken(o.output).find(" 2 folds") != std::string::npos &&
            unbroken(o.output).find("multiplier passes 1") == std::string::npos,
          "both folds are found");
    const Table         t = read_csv("out/branch.csv");
    std::vector<double> at;
    for (std::size_t i = 0; i < t.n_rows(); ++i)
      if (t.real(i, "is_fold") > 0.)
        at.push_back(t.real(i, "parameter"));
    // Long motions from small and from large starts differ at 0.2347.
    check(at.size() == 2 && at[0] > .2347 && at[1] < .2347 && at[1] > .23 &&
            at[0] < .24,
          "the branch goes back between them");
  }

  void
  end_of_range(const std::string &program)
  {
    run(program,
        "set Entries = Scene/Matrix part stiffness/Factor\n    set From = "
        "0.7\n    set To = 1.5\n    set Number = 12");
    const Table t = read_csv("out/branch.csv");
    Worst       off;
    off.add(std::abs(t.real(0, "parameter") - .7));
    off.add(std::abs(t.real(t.n_rows() - 1, "parameter") - 1.5));
    check(t.n_rows() > 5 && off.largest() < 1e-12,
          "a branch over the stiffness ends on both ends of its range");
  }

  /** Least distance of a column of branch @p number to @p value. */
  double
  nearest_to(const Table       &t,
             const long         number,
             const std::string &column,
             const double       value)
  {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < t.n_rows(); ++i)
      if (const double off = std::abs(t.real(i, column) - value);
          t.integer(i, "branch") == number && off < least)
        least = off;
    return least;
  }

  /** Two pairs grow, from frictions of 0.232 and 0.464 on, and each has a
   * branch that begins there; the second one is found by a search from a small
   * start alone. */
  void
  branches_of_both_pairs(const std::string &program)
  {
    const std::string axis =
      "set Entries = Scene/Contact c/Friction coefficient\n    set From = "
      "0.01\n    set To = 0.81\n    set Number = ";
    // A copy of this process has read tables, which would be inputs of its run.
    programs_start_anew = true;
    const Outcome o =
      run(program,
          axis + "60",
          "subsection Limit cycle\n  set Start amplitude = 0.3\n  set Searches "
          "along axis = 5\nend\n");
    check(unbroken(o.output).find("2 branches of limit cycles from a = ") !=
            std::string::npos,
          "there are two branches: " + o.output);
    const Table searches = read_csv("out/branch_searches.csv"),
                points   = read_csv("out/branch.csv");
    check(searches.n_rows() == 5 &&
            searches.text(1, "outcome") == "no growing pair" &&
            searches.text(2, "outcome") == "periodic" &&
            searches.integer(2, "branch") == 1 &&
            searches.integer(2, "starts_branch") == 0 &&
            searches.integer(4, "branch") == 2 &&
            searches.integer(3, "n_growing") == 2,
          "a search finds what lies on no branch");
    check(searches.integer(3, "starts_branch") +
              searches.integer(4, "starts_branch") ==
            1,
          "one of them starts the second branch");
    Worst onset;
    onset.add(nearest_to(points, 1, "parameter", .2320));
    onset.add(nearest_to(points, 2, "parameter", .4643));
    check(onset.largest() < 2e-4, "both begin where a pair begins to grow");
    Worst ends;
    ends.add(nearest_to(points, 1, "rms_normal_n", 1046.));
    ends.add(nearest_to(points, 2, "rms_normal_n", 50.1));
    check(ends.largest() < 1., "both end on the end of the axis");
    const std::string branches = text_of("out/branch.csv"),
                      found    = text_of("out/branch_searches.csv");
    const Outcome again        = run_program({program, "branch.prm"});
    check(again.code == 0 &&
            unbroken(again.output).find("continues from out/branch.h5") !=
              std::string::npos &&
            text_of("out/branch.csv") == branches &&
            text_of("out/branch_searches.csv") == found,
          "what the file has kept gives the same bytes");
  }

  /** With a larger friction the runs from the growing pairs, which begin where
   * half of the nodes open, end in one cycle, and steady sliding in another, as
   * long transients from small disturbances do. */
  void
  growth_to_another_cycle(const std::string &program)
  {
    write_text(
      "small.prm",
      "include model.prm\nsubsection Scene\n  subsection Contact c\n"
      "    set Friction coefficient = 0.7\n  end\nend\n"
      "subsection Limit cycle\n  set Campaign = true\n"
      "  set Starts = 1\nend\nsubsection Sweep\n  set Axes = a\n"
      "  subsection Axis a\n    set Entries = Scene/Contact c/Sliding "
      "speed\n    set Scale = list\n    set Values = 0.2\n  end\nend\n");
    const Outcome o = run_program({program, "small.prm"});
    check(o.code == 0, "the campaign runs: " + o.errors);
    const Table points = read_csv("out/campaign.csv"),
                starts = read_csv("out/starts.csv");
    check(points.text(0, "outcome") == "stable limit cycle" &&
            points.text(0, "growth_ends_in_cycle") == "no" &&
            unbroken(o.output).find("small disturbances of steady sliding grow "
                                    "to another motion") != std::string::npos,
          "small disturbances do not end in the cycle");
    check_close(
      points.real(0, "rms_normal_n"), 948., .01, "the cycle of large starts");
    check_close(
      starts.real(0, "rms_normal_n"), 30., .02, "the motion of small ones");
  }

  /** A single cycle says so as well, and one from a small start that it is what
   * the brake comes to by itself. */
  void
  growth_beside_one_cycle(const std::string &program)
  {
    const auto single = [&](const std::string &more) {
      write_text("single.prm",
                 "include model.prm\nsubsection Scene\n  subsection Contact c\n"
                 "    set Friction coefficient = 0.7\n  end\nend\n"
                 "subsection Limit cycle\n" +
                   more + "end\n");
      const Outcome o = run_program({program, "single.prm"});
      check(o.code == 0, "the limit cycle is found: " + o.errors);
      return unbroken(o.output + o.errors);
    };
    const auto says = [](const std::string &text, const std::string &what) {
      check(text.find(what) != std::string::npos, what + " in " + text);
    };
    says(single(""), "not followed: 'Limit cycle/Starts = 1'");
    says(single("  set Starts = 1\n"),
         "the brake does not come to this cycle by itself");
    check(read_csv("out/starts.csv").text(0, "ends_in_cycle") == "no",
          "the motion has a row");
    says(single("  set Starts = 1\n  set Start amplitude = 0.3\n"),
         "grow to this cycle");
    check_close(read_csv("out/limit_cycle.csv").real(0, "rms_normal_n"),
                30.,
                .02,
                "the cycle of small starts");
  }
} // namespace

int
main(int, char **arguments)
{
  write_model();
  hidden_folds(arguments[1]);
  end_of_range(arguments[1]);
  growth_to_another_cycle(arguments[1]);
  growth_beside_one_cycle(arguments[1]);
  branches_of_both_pairs(arguments[1]);
}
