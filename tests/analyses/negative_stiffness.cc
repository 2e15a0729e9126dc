// SPDX-License-Identifier: LGPL-2.1-or-later

// Three masses of imported matrices, one of which a negative stiffness pushes
// away: that is no free motion, and its growth rate is sqrt(-k/m).
// Argument: the program.

#include <squeal/results/table.h>

#include "program.h"
#include "worst.h"

#include <cmath>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  void
  write_diagonal(const std::string              &file,
                 const std::vector<std::string> &values)
  {
    std::string text    = "%%MatrixMarket matrix coordinate real symmetric\n";
    const std::string n = std::to_string(values.size());
    text += n + " " + n + " " + n + "\n";
    for (std::size_t i = 0; i < values.size(); ++i)
      text += std::to_string(i + 1) + " " + std::to_string(i + 1) + " " +
              values[i] + "\n";
    write_text(file, text);
  }
} // namespace

int
main(int argc, char *argv[])
{
  check(argc == 2, "the program");
  write_diagonal("mass.mtx", {"2", "2", "2"});
  write_diagonal("stiffness.mtx", {"-8e6", "2e7", "5e7"});
  write_text("buckled.prm",
             "set Analysis = cea\nset Output directory = buckled\n"
             "set Overwrite = true\n"
             "subsection Output\n set Plots = false\n set Report = false\nend\n"
             "subsection Scene\n set Kind = matrices\n"
             " set Matrix parts = m, k\n"
             " subsection Matrix part m\n  set File = mass.mtx\n"
             "  set Role = mass\n end\n"
             " subsection Matrix part k\n  set File = stiffness.mtx\n"
             "  set Role = stiffness\n end\nend\n"
             "subsection Eigenvalues\n set Highest frequency = 1000\nend\n");
  const Outcome o = run_program({argv[1], "buckled.prm"});
  check(o.code == 0, "a negative stiffness is solved: " + o.errors);
  const Table table = read_csv("buckled/eigenvalues.csv");
  Worst       sigma;
  for (std::size_t r = 0; r < table.n_rows(); ++r)
    sigma.add(table.real(r, "sigma_per_s"));
  check_close(sigma.largest(), 2000., 1e-8, "it diverges with sqrt(-k/m)");
  check_close(sigma.smallest(), -2000., 1e-8, "and comes back as fast");
}
