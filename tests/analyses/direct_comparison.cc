// SPDX-License-Identifier: LGPL-2.1-or-later

// Certified pairs outlive a direct solver that they are to be compared with and
// that does not converge: so much stiffness damping leaves its eigenvalues in a
// heap at -1/beta. Argument: the program.

#include <squeal/results/table.h>

#include "program.h"

#include <filesystem>

using namespace squeal;
using namespace squeal::testing;

int
main(int, char **arguments)
{
  write_text("heap.prm", R"(
set Analysis         = cea
set Output directory = heap
set Overwrite        = true
subsection Scene
  set Name     = beam
  set Bodies   = beam
  set Supports = foot
  subsection Body beam
    set Shape = block
    set Size  = 0.1, 0.01, 0.01
    set Cells = 2, 1, 1
  end
  subsection Support foot
    set Body = beam
    set Face = x_min
  end
  subsection Damping
    set Model             = whole model
    set Stiffness damping = 1e-3
  end
end
subsection Eigenvalues
  set Lowest frequency    = 0
  set Highest frequency   = 3000
  set Compare with direct = true
end
subsection Output
  set Plots = false
end
subsection Discretization
  set Estimate error = false
end
)");
  const Outcome o = run_program({arguments[1], "heap.prm"});
  check(o.code == 0, "the run ends well: " + o.errors);
  check(unbroken(o.output).find("certified pairs are not compared: the direct "
                                "solver did not converge") != std::string::npos,
        "it warns of what is not compared");
  check(read_csv("heap/eigenvalues.csv").n_rows() > 0 &&
          !std::filesystem::exists("heap/direct_check.csv"),
        "the certified pairs are written");
}
