// SPDX-License-Identifier: LGPL-2.1-or-later

// Axes with several entries, each with its own From and To: a campaign gives
// what single runs at the same values give, and a first entry that falls turns
// no range and no lock-in round. Arguments: the program, the folder of
// parameter files.

#include <squeal/results/table.h>

#include "program.h"

using namespace squeal;
using namespace squeal::testing;

namespace
{
  std::string program, folder;

  void
  run(const std::string &text)
  {
    write_text("axes.prm", text);
    const Outcome o = run_program({program, "axes.prm"});
    check(o.code == 0, "runs: " + o.errors);
  }

  const std::string beam = R"(
set Analysis         = transient
set Overwrite        = true
subsection Transient
  set Compare with CEA = false
  set Disturbance      = 1e-6
  set Cut-off          = 60e3
  set Time step        = 2e-6
  set Sample interval  = 4e-6
  set End time         = 0.002
end
subsection Output
  set Plots = false
end
)";

  std::string
  coarse(const std::string &directory, const std::string &more)
  {
    return "include " + folder + "/pin_on_beam/scene.prm\n" + beam +
           "set Output directory = " + directory +
           "\nsubsection Scene\n  subsection Body beam\n    set Cells = 2, 8, "
           "1\n  end\n  subsection Body pin\n    set Cells = 2, 2, 2\n  end\n" +
           "end\n" + more;
  }

  /** The last point of an axis that goes up in one entry and down in another,
   * beside the run at these values. */
  void
  campaign()
  {
    std::filesystem::remove("many_runs.json");
    run(coarse("many", R"(
subsection Sweep
  set Axes = stiffness
  subsection Axis stiffness
    set Entries = Scene/Body pin/Young modulus, Scene/Body beam/Young modulus
    set Scale   = logarithmic
    set From    = 2e9, 210e9
    set To      = 4e9, 70e9
    set Number  = 2
  end
end
)"));
    run(coarse("single", R"(
subsection Scene
  subsection Body pin
    set Young modulus = 4e9
  end
  subsection Body beam
    set Young modulus = 70e9
  end
end
)"));
    const Table many = read_csv("many/campaign.csv"),
                one  = read_csv("single/transient.csv");
    check(many.n_rows() == 2, "two points");
    check_close(many.real(1, "stiffness"), 4e9, 1e-12, "the first entry");
    for (const auto &[of_many, of_one] :
         {std::make_pair("sigma_linear_per_s", "sigma_linear_per_s"),
          std::make_pair("frequency_linear_hz", "frequency_linear_hz"),
          std::make_pair("max_normal_n", "max_normal_n"),
          std::make_pair("rms_normal_n", "rms_normal_n")})
      check_close(many.real(1, of_many),
                  one.real(0, of_one),
                  1e-6,
                  std::string(of_many) + " of the second point");
  }



  /** A sweep of the two degrees of freedom of minimal/hoffmann.prm. */
  std::string
  sweep_text(const std::string &directory,
             const std::string &from,
             const std::string &to,
             const std::string &scale)
  {
    std::string scene = text_of(folder + "/minimal/hoffmann.prm");
    scene             = scene.substr(0, scene.find("subsection Result checks"));
    scene             = replaced_in(scene, "set Analysis         = cea", "");
    scene =
      replaced_in(scene, "set Output directory = output/minimal/hoffmann", "");
    return scene +
           "\nset Analysis = sweep\nset Output directory = " + directory +
           R"(
subsection Output
  set Plots = false
end
subsection Eigenvalues
  set Lowest frequency = 0.01
end
subsection Sweep
  set Axes = k
  subsection Axis k
    set Entries = Scene/Spring horizontal/Stiffness, Scene/Contact belt/Friction coefficient
    set Number  = 15
    set Scale   = )" +
           scale + "\n    set From = " + from + "\n    set To = " + to +
           "\n  end\nend\n";
  }

  void
  sweep(const std::string &directory,
        const std::string &from,
        const std::string &to,
        const std::string &scale)
  {
    run(sweep_text(directory, from, to, scale));
  }

  void
  falling()
  {
    for (const std::string scale : {"linear", "logarithmic"})
      {
        sweep("up", "0.2, 1.2", "0.9, 0.4", scale);
        sweep("down", "0.9, 0.4", "0.2, 1.2", scale);
        const Table up   = read_csv("up/unstable_ranges.csv"),
                    down = read_csv("down/unstable_ranges.csv");
        check(up.n_rows() > 0 && up.n_rows() == down.n_rows(), "a range each");
        for (const char *column : {"lower",
                                   "upper",
                                   "at_lower_limit",
                                   "at_upper_limit",
                                   "peak_at",
                                   "peak_sigma_per_s"})
          check_close(down.real(0, column),
                      up.real(0, column),
                      1e-8,
                      scale + ", falling and rising, " + column);
        check(up.real(0, "lower") < up.real(0, "upper"), "lower below upper");
        const Table a = read_csv("up/exceptional_points.csv"),
                    b = read_csv("down/exceptional_points.csv");
        check(a.n_rows() == 1 && b.n_rows() == 1 &&
                a.text(0, "kind") == "lock-out" &&
                b.text(0, "kind") == "lock-out",
              scale + ": the pairs part as the first entry ascends");
      }
  }



  /** An axis that is called like a column of the tables it stands in. */
  void
  names_of_columns()
  {
    const auto refused = [](const std::string &text, const std::string &name) {
      std::string named = replaced_in(text, "Axes = k", "Axes = " + name);
      named             = replaced_in(named, "Axis k\n", "Axis " + name + "\n");
      write_text("named.prm", named);
      const Outcome o = run_program({program, "named.prm"});
      check(o.code == 2 &&
              o.errors.find("two columns of a table would be called '" + name +
                            "'") != std::string::npos &&
              o.errors.find('\n') == o.errors.size() - 1,
            "an axis called " + name + ": " + o.errors);
    };
    for (const char *name : {"sigma_per_s", "branch"})
      refused(sweep_text("named", "0.2, 1.2", "0.9, 0.4", "linear"), name);
    for (const char *name : {"top", "stable"})
      refused(coarse("named_runs", R"(
subsection Sweep
  set Axes = k
  subsection Axis k
    set Entries = Scene/Body pin/Young modulus
    set Scale   = list
    set Values  = 2e9, 4e9
  end
end
)"),
              name);
  }
} // namespace



int
main(int argc, char **argv)
{
  check(argc == 3, "arguments: program, folder");
  program = argv[1];
  folder  = argv[2];
  campaign();
  falling();
  names_of_columns();
}
