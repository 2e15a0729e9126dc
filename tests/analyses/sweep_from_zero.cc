// SPDX-License-Identifier: LGPL-2.1-or-later

// A mass on a belt, swept over a slope of friction that is zero in the file:
// the growth rates of its two motions have a known sum. A friction table that
// is flat at the sliding speed of the file is swept beyond that speed. A
// dashpot that is zero at most values of a list is there at the others. A beam
// with an overdamped end is swept from 0 Hz.
// Argument: the program.

#include <squeal/results/table.h>

#include "program.h"
#include "source_directory.h"
#include "worst.h"

#include <cmath>
#include <functional>
#include <map>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  const std::string contact      = "Scene/Contact belt/";
  constexpr double  normal_force = 2.;

  /** Sum of sigma at every value of the axis, the pairs being those of one mass
   * that moves in two directions. */
  std::map<double, double>
  sums_of_sigma(const std::string &program,
                const std::string &text,
                const std::string &name)
  {
    write_text(name + ".prm",
               "include " SQUEAL_SOURCE_DIR "/prm/minimal/hoffmann.prm\n"
               "drop Result checks\n"
               "set Analysis = sweep\nset Output directory = " +
                 name + "\nset Overwrite = true\n" +
                 "subsection Output\n  set Plots = false\n  set Report = "
                 "false\nend\n" +
                 text);
    const Outcome o = run_program({program, name + ".prm"});
    check(o.code == 0, name + " ends: " + o.errors);
    const Table              table = read_csv(name + "/eigenvalues.csv");
    std::map<double, double> result;
    for (std::size_t r = 0; r < table.n_rows(); ++r)
      result[table.real(r, "s")] += table.real(r, "sigma_per_s");
    return result;
  }

  std::string
  scene(const std::string &belt)
  {
    return "subsection Scene\n  subsection Contact belt\n    set Normal force "
           "= 2\n    set Sliding speed = 0.5\n" +
           belt + "  end\nend\n";
  }

  std::string
  axis(const std::string &entry, const std::string &from, const std::string &to)
  {
    return "subsection Sweep\n  set Axes = s\n  subsection Axis s\n    set "
           "Entries = " +
           contact + entry + "\n    set From = " + from +
           "\n    set To = " + to + "\n    set Number = 5\n  end\nend\n";
  }

  /** A list of 0 to 100 of a stiffness and a dashpot along one direction; the
   * latter is 0 but at 15 to 22. */
  std::string
  listed_dashpot()
  {
    std::string values, stiffness, dashpot;
    for (int i = 0; i <= 100; ++i)
      {
        const std::string comma = i > 0 ? ", " : "";
        values += comma + std::to_string(i);
        stiffness += comma + std::to_string(0.5 + 0.001 * i);
        dashpot += i >= 15 && i <= 22 ? ", 0.3" : ", 0";
      }
    return "subsection Sweep\n  set Axes = s\n  subsection Axis s\n    set "
           "Entries = Scene/Spring horizontal/Stiffness, "
           "Scene/Spring horizontal/Dashpot\n    set Scale = list\n"
           "    set Values = " +
           values + "\n    set Entry values = " + stiffness + dashpot +
           "\n  end\nend\n";
  }

  /** -N slope / (2 m) of the mass of 1 kg: half the trace of the damping. */
  void
  check_sums(const std::map<double, double>      &sums,
             const std::function<double(double)> &slope,
             const std::string                   &name,
             const double                         factor = normal_force,
             const std::size_t                    n      = 5)
  {
    check(sums.size() == n, name + ": all points");
    Worst error;
    for (const auto &[value, sum] : sums)
      error.add(std::abs(sum + .5 * factor * slope(value)));
    check_within(error, 1e-9, name + ": sum of the growth rates");
  }

  /** A clamped beam whose end a dashpot holds back: at the larger values its
   * first bending does not oscillate, and decays in two real eigenvalues. */
  const std::string overdamped_beam = R"(
    set Overwrite = true
    subsection Output
      set Plots  = false
      set Report = false
    end
    subsection Discretization
      set Degree         = 2
      set Estimate error = false
    end
    subsection Eigenvalues
      set Lowest frequency  = 0
      set Highest frequency = 6000
    end
    subsection Scene
      set Bodies   = beam
      set Supports = clamp
      set Springs  = damper
      subsection Body beam
        set Shape         = block
        set Size          = .2, .02, .02
        set Position      = 0, 0, 0
        set Cells         = 8, 1, 1
        set Young modulus = 2e11
        set Density       = 7800
      end
      subsection Support clamp
        set Body = beam
        set Face = x_min
      end
      subsection Spring damper
        set Kind      = area
        set Body      = beam
        set Face      = x_max
        set Direction = 0, 0, 1
        set Stiffness = 1e6
        set Dashpot   = 1e8
      end
    end
    )";

  /** The pairs of a sweep over the dashpot are those of single analyses. */
  void
  overdamped(const std::string &program)
  {
    write_text("beam.prm",
               overdamped_beam +
                 "set Analysis = sweep\nset Output directory = beam\n"
                 "subsection Sweep\n  set Axes = s\n  subsection Axis s\n"
                 "    set Entries = Scene/Spring damper/Dashpot\n"
                 "    set Scale = logarithmic\n    set From = 1e5\n"
                 "    set To = 1e8\n    set Number = 3\n  end\nend\n");
    const Outcome o = run_program({program, "beam.prm"});
    check(o.code == 0, "a sweep of an overdamped motion ends: " + o.errors);
    check(text_of("beam/run.log").find("in doubt") == std::string::npos,
          "its branches are told apart");
    const std::string text = text_of("beam/eigenvalues.csv");
    check(text.find(",-0,") == std::string::npos, "no frequency is -0");
    write_text("beam_alone.prm",
               overdamped_beam +
                 "set Analysis = cea\nset Output directory = beam_alone\n");
    const Outcome alone = run_program({program, "beam_alone.prm"});
    check(alone.code == 0, "one analysis ends: " + alone.errors);
    const Table sweep  = read_csv("beam/eigenvalues.csv"),
                single = read_csv("beam_alone/eigenvalues.csv");
    Worst        sigma, frequency;
    unsigned int n_real = 0, r = 0;
    while (r < sweep.n_rows() && sweep.real(r, "s") < 9e7)
      ++r;
    check(sweep.n_rows() == r + single.n_rows(), "as many pairs");
    for (unsigned int i = 0; i < single.n_rows(); ++i, ++r)
      {
        n_real += single.real(i, "frequency_hz") == 0.;
        sigma.add(std::abs(sweep.real(r, "sigma_per_s") -
                           single.real(i, "sigma_per_s")));
        frequency.add(std::abs(sweep.real(r, "frequency_hz") -
                               single.real(i, "frequency_hz")));
      }
    check(n_real > 0, "one does not oscillate");
    check_within(sigma, .5, "their growth rates");
    check_within(frequency, 6e-3, "their frequencies");
  }
} // namespace

int
main(int argc, char **argv)
{
  check(argc == 2, "one argument");
  check_sums(
    sums_of_sigma(
      argv[1], scene("") + axis("Friction slope", "-0.2", "0.2"), "slope"),
    [](const double s) { return s; },
    "slope of friction from zero");
  // Flat to 0.6 m/s, from there on falling by 0.15 in 1.05 m/s.
  check_sums(
    sums_of_sigma(argv[1],
                  scene("    set Friction law = table\n"
                        "    set Friction speeds = 0, 0.6, 1.65\n"
                        "    set Friction coefficients = 0.4, 0.4, 0.25\n") +
                    axis("Sliding speed", "0.5", "0.98"),
                  "plateau"),
    [](const double v) { return v > 0.6 ? -.15 / 1.05 : 0.; },
    "a table that is flat at the speed of the file");
  check_sums(
    sums_of_sigma(argv[1], listed_dashpot(), "listed"),
    [](const double s) { return s >= 15. && s <= 22. ? 0.3 : 0.; },
    "a dashpot at some values of a list",
    1.,
    101);
  overdamped(argv[1]);
}
