// SPDX-License-Identifier: LGPL-2.1-or-later

// A square plate under a pad is no body of revolution: the eigenvalue analysis
// says so, `Analysis = angles` finds the same pairs every quarter of a turn and
// others in between, from the angle of the plate itself on. Argument: the
// program.

#include "program.h"
#include "worst.h"

#include <squeal/results/table.h>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  const std::string plate = R"(set Analysis         = angles
set Output directory = out
set Overwrite        = true
subsection Scene
  set Bodies   = plate, pad
  set Springs  = bed
  set Supports = top
  set Contacts = pair
  subsection Body plate
    set Shape         = block
    set Size          = 0.1, 0.1, 0.01
    set Position      = 0, 0, -0.01
    set Cells         = 6, 6, 1
    set Young modulus = 2e11
    set Density       = 7800
  end
  subsection Body pad
    set Shape         = block
    set Size          = 0.01, 0.01, 0.01
    set Position      = 0.03, 0, 0
    set Cells         = 1, 1, 1
    set Young modulus = 1e10
    set Density       = 2500
  end
  subsection Spring bed
    set Kind        = area
    set Body        = plate
    set Face        = z_min
    set Stiffnesses = 1e10, 1e10, 1e10
  end
  subsection Support top
    set Body       = pad
    set Face       = z_max
    set Kind       = components
    set Components = x, y
  end
  subsection Contact pair
    set Source body          = pad
    set Source face          = z_min
    set Target body          = plate
    set Target face          = z_max
    set Friction direction   = slip
    set Grid                 = 5, 5
    set Normal stiffness     = 1e7
    set Friction coefficient = 0.5
  end
  subsection Damping
    set Model             = whole model
    set Stiffness damping = 1e-7
  end
end
subsection Discretization
  set Degree = 2
end
subsection Eigenvalues
  set Lowest frequency  = 500
  set Highest frequency = 12000
end
subsection Angles
  set Turning bodies = plate
  set From           = 0
  set To             = 180
  set Number         = 4
end
)";

  Table
  run(const std::string              &program,
      const std::vector<std::string> &settings,
      const std::string              &table,
      std::string                    &errors,
      const std::string              &more = "")
  {
    write_text("angles.prm", plate + more);
    std::vector<std::string> words = {program};
    for (const std::string &setting : settings)
      words.insert(words.end(), {"--set", setting});
    words.push_back("angles.prm");
    const Outcome outcome = run_program(words);
    check(outcome.code == 0, "the run ends well: " + outcome.errors);
    errors = outcome.errors + unbroken(outcome.output);
    return read_csv("out/" + table);
  }
} // namespace



int
main(int argc, char **argv)
{
  check(argc == 2, "one argument: the program");
  std::string said;
  const Table angles = run(argv[1], {}, "angles.csv", said);
  check(angles.n_rows() == 4, "four angles");
  const auto change = [&](const std::size_t i, const std::size_t k) {
    return std::hypot(angles.real(i, "sigma_per_s") -
                        angles.real(k, "sigma_per_s"),
                      2. * M_PI *
                        (angles.real(i, "frequency_hz") -
                         angles.real(k, "frequency_hz"))) /
           (2. * M_PI * angles.real(k, "frequency_hz"));
  };
  Worst same;
  same.add(change(2, 0));
  same.add(change(3, 1));
  std::cout << "a quarter of a turn changes the loudest pair by "
            << same.largest() << ", an eighth by " << change(1, 0) << '\n';
  check(same.largest() < 1e-8, "the same pair a quarter of a turn later");
  check(change(1, 0) > 1e-6, "another one in between");

  const Table own = run(argv[1],
                        {"Scene/Body plate/Angle = 45", "Angles/Number = 2"},
                        "angles.csv",
                        said);
  for (const std::string column : {"frequency_hz", "sigma_per_s"})
    check_close(own.real(0, column),
                angles.real(1, column),
                1e-8,
                column + " of a plate that stands at this angle itself",
                1.);

  run(argv[1], {"Analysis = cea"}, "eigenvalues.csv", said);
  check(said.find("body plate is no body of revolution") != std::string::npos &&
          said.find("every 90.000 deg") != std::string::npos,
        "a plate that stands still is warned of, with its period");

  const std::string pressed = R"(
subsection Scene
  set Loads = press
  subsection Load press
    set Body     = pad
    set Face     = z_max
    set Pressure = 1e6
  end
end
)";
  for (const auto &[analysis, table] :
       {std::make_pair("preload", "preload.csv"),
        std::make_pair("transient", "transient.csv")})
    {
      run(argv[1],
          {std::string("Analysis = ") + analysis,
           "Transient/End time = 1e-4",
           "Transient/Time step = 1e-6"},
          table,
          said,
          pressed);
      check(said.find("body plate is no body of revolution") !=
              std::string::npos,
            std::string("and in ") + analysis);
    }
}
