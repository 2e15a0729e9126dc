// SPDX-License-Identifier: LGPL-2.1-or-later

// A square plate under a pad is no body of revolution: the eigenvalue analysis
// says so, `Analysis = angles` finds the same pairs every quarter of a turn and
// others in between, from the angle of the plate itself on. The axes of its
// material turn with it, and so do a weight and the springs between the two.
// Argument: the program.

#include "program.h"
#include "worst.h"

#include <squeal/results/table.h>

#include <complex>

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

  /** The loudest pair at the first angle. */
  std::complex<double>
  loudest(const std::string       &program,
          std::vector<std::string> settings,
          const std::string       &more = "")
  {
    std::string said;
    settings.push_back("Angles/Number = 1");
    const Table table = run(program, settings, "angles.csv", said, more);
    return {table.real(0, "sigma_per_s"),
            2. * M_PI * table.real(0, "frequency_hz")};
  }

  /** That a pair of a turned rotor is that of one described where it has
   * turned to, which is none of one that is described otherwise. */
  void
  check_turned(const std::complex<double> turned,
               const std::complex<double> described,
               const std::complex<double> other,
               const std::string         &claim)
  {
    const double same = std::abs(turned / described - 1.),
                 far  = std::abs(other / described - 1.);
    std::cout << claim << ": from the same scene " << same
              << ", from another one " << far << '\n';
    check(same < 1e-8, claim + ": as described there");
    check(far > 1e-5, claim + ": which is another scene");
  }



  void
  axes_of_the_material(const std::string &program)
  {
    const auto with = [](const std::vector<std::string> &changes) {
      std::vector<std::string> result = {
        "Scene/Body plate/Material model = orthotropic",
        "Scene/Body plate/Young modulus = 2.1e11",
        "Scene/Body plate/Young moduli = 2e11, 2e10, 5e10",
        "Scene/Body plate/Shear moduli = 1e10, 2e10, 3e10"};
      result.insert(result.end(), changes.begin(), changes.end());
      return result;
    };
    const std::string angle = "Scene/Body plate/Angle = 45";
    check_turned(loudest(program, with({"Angles/From = 45"})),
                 loudest(program,
                         with({angle,
                               "Scene/Body plate/Material axis 1 = 1, 1, 0",
                               "Scene/Body plate/Material axis 2 = -1, 1, 0"})),
                 loudest(program, with({angle})),
                 "axes of a material");
  }



  /** A cylinder beside the axis on springs that differ in x and y. */
  void
  weight_on_springs(const std::string &program)
  {
    const std::string weight = R"(
subsection Scene
  subsection Body weight
    set Shape           = cylinder
    set Outer radius    = 0.005
    set Height          = 0.01
    set Cells           = 4, 1, 1
    set Rotation centre = 0, 0, 0
  end
  subsection Spring foot
    set Kind       = area
    set Body       = weight
    set Face       = bottom
    set Other body = plate
  end
  subsection Spring row
    set Body       = plate
    set Other body = weight
    set Number     = 2
    set Stiffness  = 1e5
  end
end
)";
    const auto        with   = [](const std::vector<std::string> &changes) {
      std::vector<std::string> result = {
        "Scene/Bodies = plate, pad, weight",
        "Scene/Springs = bed, foot, row",
        "Scene/Contact pair/Friction coefficient = 0",
        "Eigenvalues/Lowest frequency = 100"};
      result.insert(result.end(), changes.begin(), changes.end());
      return result;
    };
    const std::string foot  = "Scene/Spring foot/Stiffnesses = ",
                      row   = "Scene/Spring row/",
                      place = "Scene/Body weight/Position = ";
    const auto at_90        = [&](const std::string &stiffnesses) {
      return loudest(program,
                     with({"Scene/Body plate/Angle = 90",
                           place + "-0.01, -0.03, 0",
                           row + "First point = -0.01, -0.032, 0",
                           row + "Last point = -0.01, -0.028, 0",
                           row + "Direction = 0, 1, 1",
                           foot + stiffnesses}),
                     weight);
    };
    check_turned(loudest(program,
                         with({"Angles/Turning bodies = plate, weight",
                               "Angles/From = 90",
                               place + "-0.03, 0.01, 0",
                               row + "First point = -0.032, 0.01, 0",
                               row + "Last point = -0.028, 0.01, 0",
                               row + "Direction = 1, 0, 1",
                               foot + "2e9, 4e9, 8e9"}),
                         weight),
                 at_90("4e9, 2e9, 8e9"),
                 at_90("2e9, 4e9, 8e9"),
                 "a weight on springs");
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

  axes_of_the_material(argv[1]);
  weight_on_springs(argv[1]);

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
