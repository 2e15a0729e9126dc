// SPDX-License-Identifier: LGPL-2.1-or-later

// Limit cycles of two pads of 1 kg on two sides of a disc, from matrices that
// are written here; a spring between them makes them move against each other.
// Arguments: the program and the part.

#include "program.h"
#include "scenes.h"

#include <squeal/results/table.h>

#include <cmath>
#include <sstream>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  /** Of the springs: 1 kHz for 1 kg. */
  const double     stiffness = std::pow(2. * M_PI * 1000., 2);
  constexpr double press     = 100.; // N

  void
  write_matrix(const std::string                      &file,
               const std::vector<std::vector<double>> &A)
  {
    std::ostringstream entries;
    unsigned int       n = 0;
    entries.precision(17);
    for (std::size_t j = 0; j < A.size(); ++j)
      for (std::size_t i = j; i < A.size(); ++i)
        if (A[i][j] != 0.)
          {
            entries << i + 1 << " " << j + 1 << " " << A[i][j] << "\n";
            ++n;
          }
    write_text(file,
               "%%MatrixMarket matrix coordinate real symmetric\n6 6 " +
                 std::to_string(n) + "\n" + entries.str());
  }

  /** The second pad is the mirror image of the first one. */
  void
  write_matrices()
  {
    std::vector<std::vector<double>> M(6, std::vector<double>(6)), K = M;
    for (const int pad : {0, 1})
      {
        const int x = 3 * pad, y = x + 1, z = x + 2;
        for (const int i : {x, y, z})
          M[i][i] = 1.;
        K[x][x] = (.5 + .5) * stiffness;
        K[y][y] = 2. * stiffness;
        K[z][z] = .5 * stiffness;
        K[x][z] = K[z][x] = (pad == 0 ? -.3 : .3) * stiffness;
      }
    K[0][3] = K[3][0] = -.5 * stiffness;
    write_matrix("M.mtx", M);
    write_matrix("K.mtx", K);
    write_text("nodes.csv",
               "dof,node,component,x,y,z,body,load_press\n"
               "1,1,1,0.1,0,0,up,0\n2,1,2,0.1,0,0,up,0\n"
               "3,1,3,0.1,0,0,up,-100\n4,2,1,0.2,0,0,lo,0\n"
               "5,2,2,0.2,0,0,lo,0\n6,2,3,0.2,0,0,lo,100\n");
    write_text("contact.csv",
               "contact,pair,side,direction,node,component,weight,x,y,z,area\n"
               "upper,1,source,normal,1,3,1,0.1,0,0,1e-4\n"
               "upper,1,source,sliding,1,1,1,0.1,0,0,1e-4\n"
               "upper,1,source,transverse,1,2,-1,0.1,0,0,1e-4\n"
               "lower,2,source,normal,2,3,-1,0.2,0,0,1e-4\n"
               "lower,2,source,sliding,2,1,1,0.2,0,0,1e-4\n"
               "lower,2,source,transverse,2,2,1,0.2,0,0,1e-4\n");
  }

  std::string
  scene(const unsigned int n_steps, const std::string &more)
  {
    std::ostringstream text;
    text.precision(17);
    text << "set Analysis = limit cycle\nset Output directory = out\n"
            "set Overwrite = true\nsubsection Scene\n  set Name = pads\n"
            "  set Kind = matrices\n  set Matrix parts = mass, stiffness\n"
            "  set Node table file = nodes.csv\n"
            "  set Contact pattern file = contact.csv\n"
            "  set Contacts = upper, lower\n  set Loads = press\n"
            "  subsection Matrix part mass\n    set File = M.mtx\n"
            "    set Role = mass\n  end\n"
            "  subsection Matrix part stiffness\n    set File = K.mtx\n"
            "    set Role = stiffness\n  end\n"
            "  subsection Load press\n    set Ramp time = 0\n  end\n";
    for (const std::string name : {"upper", "lower"})
      text << "  subsection Contact " << name
           << "\n    set Source body = " << (name == "upper" ? "up" : "lo")
           << "\n    set Formulation = springs\n    set Normal stiffness = "
           << stiffness
           << "\n    set Contact state = full\n"
              "    set Friction coefficient = 0.5\n"
              "    set Transverse slip term = true\n    set Sliding speed = "
           << 3. * press / std::sqrt(stiffness)
           << "\n    set Normal force = 1\n"
              "    set Tangential stiffness = -1\n  end\n";
    text
      << "  subsection Damping\n    set Model = whole model\n"
         "    set Mass damping = "
      << .05 * std::sqrt(stiffness)
      << "\n    set Stiffness damping = 0\n  end\nend\n"
         "subsection Eigenvalues\n  set Lowest frequency = 1\n"
         "  set Highest frequency = 3000\nend\n"
         "subsection Transient\n  set Cut-off = 20000\n"
         "  set Time step = 2e-6\nend\n"
         "subsection Output\n  set Plots = false\n  set Report = false\nend\n"
         "subsection Limit cycle\n  set Run time = 0.1\n"
         "  set Steps per period = "
      << n_steps << "\n"
      << more;
    return text.str();
  }

  std::string
  axis(const std::string &entries,
       const std::string &from,
       const std::string &to)
  {
    return "subsection Sweep\n  set Axes = a\n  subsection Axis a\n"
           "    set Entries = " +
           entries + "\n    set From = " + from + "\n    set To = " + to +
           "\n    set Number = 2\n  end\nend\n";
  }

  Outcome
  run(const std::string &program, const std::string &text)
  {
    write_text("pads.prm", text);
    return run_program({program, "pads.prm"});
  }



  /** Each pad has the line of the motion and lifts off; their sum has twice the
   * frequency, half the rms and never vanishes. */
  void
  antiphase(const std::string &program)
  {
    const Outcome o = run(program, scene(256, "end\n"));
    check(o.code == 0, "it runs: " + o.errors);
    const Table t      = read_csv("out/limit_cycle.csv"),
                period = read_csv("out/limit_cycle_period.csv");
    const auto number  = [&](const std::string &name) {
      return t.real(0, name);
    };
    // By an integration of its own that locates the events, 1170.34 Hz, 68.34
    // N.
    check_close(number("frequency_hz"), 1170.34, 1e-4, "frequency of a pad");
    check_close(number("dominant_line_hz"),
                number("frequency_hz"),
                1e-9,
                "the largest line of a pad is that of its motion");
    check_close(number("rms_normal_n"), 68.34, 1e-3, "rms of a pad");
    check_below(std::abs(number("min_normal_n")), 1e-3, "a pad lifts off");
    for (const std::string name :
         {"dominant_line_hz", "rms_normal_n", "max_normal_n"})
      {
        check_close(number("upper_" + name),
                    number(name),
                    1e-5,
                    "the upper pad: " + name);
        check_close(number("lower_" + name),
                    number(name),
                    1e-5,
                    "the lower pad: " + name);
      }
    double mean = 0., square = 0., least = 1e300, apart = 0.;
    for (std::size_t i = 0; i < period.n_rows(); ++i)
      {
        const double sum = period.real(i, "normal_n");
        mean += sum / period.n_rows();
        square += sum * sum / period.n_rows();
        if (!(sum > least))
          least = sum;
        apart += std::abs(sum - period.real(i, "upper_normal_n") -
                          period.real(i, "lower_normal_n"));
      }
    check_below(apart, 1e-6, "the sum over a period is that of both pads");
    check_below(std::sqrt(square - mean * mean),
                .6 * number("rms_normal_n"),
                "the sum moves less");
    check_below(50., least, "and is never without force");
  }



  /** Another range of the second entry of an axis is another branch. */
  void
  branch_file(const std::string &program)
  {
    const std::string entries = "Scene/Contact upper/Friction coefficient, "
                                "Scene/Contact lower/Friction coefficient";
    const auto branch = [&](const std::string &from, const std::string &to) {
      const Outcome o =
        run(program, scene(64, "end\n") + axis(entries, from, to));
      check(o.code == 0, "a branch runs: " + o.errors);
      return text_of("out/branch.csv");
    };
    std::filesystem::remove_all("out");
    const std::string fresh = branch("0.45, 0.4", "0.55, 0.6");
    std::filesystem::remove_all("out");
    const std::string other = branch("0.45, 0.48", "0.55, 0.52");
    check(other != fresh, "the other range has another branch");
    check(branch("0.45, 0.4", "0.55, 0.6") == fresh,
          "points of another range are not taken over");
  }



  void
  refuses(const std::string &program,
          const std::string &entry,
          const std::string &from,
          const std::string &to,
          const std::string &reason,
          const std::string &search = "end\n")
  {
    std::filesystem::remove_all("out");
    const Outcome o = run(program, scene(64, search) + axis(entry, from, to));
    const std::string text = unbroken(o.errors);
    check(o.code != 0 && text.find(reason) != std::string::npos,
          "a branch over " + entry + " is refused by '" + reason +
            "': " + text);
    check(!std::filesystem::exists("out/branch.csv") &&
            !std::filesystem::exists("out/campaign.csv"),
          "nothing is printed");
  }

  void
  axes(const std::string &program)
  {
    const std::string upper = "Scene/Contact upper/";
    refuses(program, upper + "Friction slope", "-1", "1", "must be 0");
    refuses(program,
            upper + "Static friction coefficient",
            "0",
            "1",
            "would be ignored");
    refuses(program, upper + "Decay speed", "0", "1", "would be ignored");
    refuses(program, upper + "Normal force", "0.5", "200", "has no effect");
    refuses(program,
            upper + "Normal force",
            "0.5",
            "200",
            "has no effect",
            "  set Campaign = true\nend\n");
    refuses(program,
            "Scene/Load press/Ramp time",
            "0",
            "1",
            "neither the model nor its steady sliding");
    const Outcome o =
      run(program,
          scene(64, "end\n") +
            axis("Scene/Contact upper/Sliding speed", "0.02", "0.06"));
    check(o.code == 0 && std::filesystem::exists("out/branch.csv"),
          "one that acts is followed: " + o.errors);
  }
} // namespace

int
main(int argc, char *argv[])
{
  check(argc > 2, "arguments: the program and the part");
  write_matrices();
  const std::string part = argv[2];
  if (part == "antiphase")
    antiphase(argv[1]);
  else if (part == "branch_file")
    branch_file(argv[1]);
  else if (part == "axes")
    axes(argv[1]);
  else
    check(false, "a part: antiphase, branch_file or axes");
}
