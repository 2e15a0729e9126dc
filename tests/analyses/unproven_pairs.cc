// SPDX-License-Identifier: LGPL-2.1-or-later

// The direct solver has the pairs nearest to its shift: what it says is of
// these, and their errors are not estimated. Bodies without a mesh have no
// error by one. Arguments: the program and the folder of parameter files.

#include <squeal/results/table.h>

#include "program.h"

using namespace squeal;
using namespace squeal::testing;

namespace
{
  bool
  says(const std::string &text, const std::string &what)
  {
    return text.find(what) != std::string::npos;
  }

  void
  some_pairs(const std::string &program)
  {
    write_text("direct.prm",
               replaced_in(small_brake, "Report = false", "Report = true") +
                 "set Overwrite = true\n"
                 "subsection Eigenvalues\n set Solver = direct\n"
                 " set Number of pairs = 3\nend\n");
    const Outcome o = run_program({program, "direct.prm"});
    check(o.code == 0, "the direct solver runs: " + o.errors);
    const Table pairs = read_csv("out/eigenvalues.csv");
    check(pairs.n_rows() > 0 && pairs.n_rows() <= 3, "a few pairs");
    for (std::size_t i = 0; i < pairs.n_rows(); ++i)
      check(pairs.is_missing(i, "error_estimate_rel"),
            "an error that is not estimated is not 0");
    const std::string report = unbroken(text_of("out/report.html"));
    check(says(report, "others of the band may be") &&
            says(report, "reduction error not estimated") &&
            says(report, "pairs found") &&
            !says(report, "no unstable pair in the band"),
          "the verdict is of the pairs found");
  }

  void
  no_mesh(const std::string &program, const std::string &folder)
  {
    const Outcome o = run_program({program,
                                   "--set",
                                   "Output directory = rigid",
                                   folder + "/minimal/hoffmann.prm"});
    check(o.code == 0, "rigid bodies run: " + o.errors);
    check(!says(unbroken(o.output), "mesh errors of growth rates"),
          "no mesh, no errors by one");
  }
} // namespace

int
main(int argc, char **argv)
{
  check(argc == 3, "the program and the folder of parameter files");
  some_pairs(argv[1]);
  no_mesh(argv[1], argv[2]);
}
