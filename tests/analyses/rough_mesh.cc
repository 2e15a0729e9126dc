// SPDX-License-Identifier: LGPL-2.1-or-later

// A pad on a plate whose growth rate does not near its limit from one side:
// 748, 594, 822 and 867 1/s with the degrees 1, 2, 3 and 6. With quadratic
// elements, which have the frequency 2 % off, a warning says that the error of
// the growth rate may be too small; with cubic ones it covers half of the true
// one, and nothing is said. Argument: the program.

#include <squeal/results/table.h>

#include "program.h"
#include "worst.h"

#include <cmath>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  const std::string scene = R"(set Analysis         = cea
set Output directory = out
subsection Scene
  set Bodies   = plate, pad
  set Supports = side, top
  set Contacts = face
  subsection Body plate
    set Shape         = block
    set Size          = 0.08260923742139165, 0.10220292531623015, 0.015
    set Position      = 0, 0, -0.015
    set Cells         = 4, 4, 1
    set Young modulus = 7e10
    set Poisson ratio = 0.3
    set Density       = 2700
  end
  subsection Body pad
    set Shape         = block
    set Size          = 0.0277955, 0.021808, 0.0117477
    set Position      = 0.0100895, 0.00964153, 0
    set Cells         = 2, 3, 2
    set Young modulus = 1145908465.7821183
    set Poisson ratio = 0.4
    set Density       = 2500
  end
  subsection Support side
    set Body = plate
    set Face = x_min
  end
  subsection Support top
    set Body = pad
    set Face = z_max
  end
  subsection Contact face
    set Source body          = pad
    set Source face          = z_min
    set Target body          = plate
    set Target face          = z_max
    set Formulation          = mortar
    set Friction coefficient = 0.7
  end
end
subsection Eigenvalues
  set Lowest frequency  = 0
  set Highest frequency = 9000
end
subsection Output
  set Shapes = none
  set Plots  = false
  set Report = false
end
)";

  /** 1/s, of degree 6 on the same cells; degree 4 on cells of half the size has
   * 867.12 1/s. */
  constexpr double limit = 867.25;

  struct Pair
  {
    double sigma = NAN, error = NAN;
    bool   is_warned_of = false;
  };

  Pair
  growing_pair(const std::string &program, const unsigned int degree)
  {
    const std::string setting =
      "Discretization/Degree = " + std::to_string(degree);
    const Outcome run = run_text(program, scene, {setting});
    check(run.code == 0, setting + " runs " + run.errors);
    const Table pairs = read_csv("out/eigenvalues.csv");
    Pair        result;
    for (std::size_t i = 0; i < pairs.n_rows(); ++i)
      if (pairs.real(i, "sigma_per_s") > 100.)
        {
          check(std::isnan(result.sigma), setting + ": one pair grows");
          result.sigma = pairs.real(i, "sigma_per_s");
          result.error = pairs.real(i, "sigma_error_mesh_per_s");
        }
    result.is_warned_of =
      unbroken(run.output).find("so rough a mesh") != std::string::npos;
    return result;
  }
} // namespace

int
main(int argc, char *argv[])
{
  check(argc == 2, "one argument: the program");
  const Pair quadratic = growing_pair(argv[1], 2),
             cubic     = growing_pair(argv[1], 3);
  check(std::abs(quadratic.sigma - limit) > 200. &&
          std::abs(quadratic.error) < 100.,
        "quadratic elements miss more than they say");
  check(quadratic.is_warned_of, "and are warned of");
  check(std::abs(cubic.error) > .5 * std::abs(limit - cubic.sigma),
        "the error of cubic ones covers half of the true one");
  check(!cubic.is_warned_of, "without a warning");
}
