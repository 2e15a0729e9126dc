// SPDX-License-Identifier: LGPL-2.1-or-later

// Where pairs lock in, by the program: exceptional points do not hang on the
// points of the sweep, and the error by the mesh that an edge is stated with
// covers what elements of the next degree move it by. Arguments: the program,
// the folder of parameter files.

#include <squeal/results/table.h>

#include "program.h"
#include "worst.h"

#include <cmath>
#include <filesystem>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  std::string program, folder;

  /** A sweep over the pad's stiffness, 10^10.3 to 10^10.95 Pa, at mu = 0.2. */
  void
  sweep(const std::string &directory,
        const unsigned int degree,
        const unsigned int number)
  {
    write_text(directory + ".prm",
               "include " + folder +
                 "/tribobrake/calibrated.prm\n"
                 "set Analysis = sweep\nset Overwrite = true\n"
                 "set Output directory = " +
                 directory + "\nsubsection Discretization\n set Degree = " +
                 std::to_string(degree) +
                 "\nend\nsubsection Eigenvalues\n"
                 " set Lowest frequency = 3300\n"
                 " set Highest frequency = 5300\nend\n"
                 "subsection Output\n set Plots = false\n"
                 " set Report = false\nend\n"
                 "subsection Scene\n subsection Contact pad_disc\n"
                 "  set Friction coefficient = 0.2\n end\nend\n"
                 "subsection Sweep\n set Axes = e_pad\n"
                 " subsection Axis e_pad\n"
                 "  set Entries = Scene/Body pad/Young modulus\n"
                 "  set Scale = logarithmic\n  set From = 10^10.3\n"
                 "  set To = 10^10.95\n  set Number = " +
                 std::to_string(number) + "\n end\nend\n");
    const Outcome o = run_program({program, directory + ".prm"});
    check(o.code == 0, directory + " ends well: " + o.errors);
  }

  void
  exceptional_points_agree(const std::string &one, const std::string &other)
  {
    const Table a = read_csv(one + "/exceptional_points.csv"),
                b = read_csv(other + "/exceptional_points.csv");
    check(a.n_rows() >= 4, "pairs lock in and out");
    Worst coordinate, frequency, sigma;
    for (std::size_t i = 0; i < a.n_rows(); ++i)
      {
        std::size_t  nearest = 0;
        const double x       = a.real(i, "coordinate_real");
        for (std::size_t j = 0; j < b.n_rows(); ++j)
          if (std::abs(b.real(j, "coordinate_real") - x) <
              std::abs(b.real(nearest, "coordinate_real") - x))
            nearest = j;
        coordinate.add(std::abs(b.real(nearest, "coordinate_real") - x));
        frequency.add(std::abs(
          b.real(nearest, "frequency_hz") / a.real(i, "frequency_hz") - 1.));
        sigma.add(
          std::abs(b.real(nearest, "sigma_per_s") - a.real(i, "sigma_per_s")));
      }
    check(coordinate.largest() < 1e-4, "at the same stiffness");
    check(frequency.largest() < 1e-5, "with the same frequency");
    check(sigma.largest() < 0.1, "and the same damping");
  }

  /** Of each range of @p coarse the partner in @p fine, by its frequency. */
  void
  errors_cover(const std::string &coarse, const std::string &fine)
  {
    const Table a = read_csv(coarse + "/unstable_ranges.csv"),
                b = read_csv(fine + "/unstable_ranges.csv");
    check(a.n_rows() == 2 && b.n_rows() == 2, "two ranges");
    Worst stated_over_change;
    for (std::size_t i = 0; i < 2; ++i)
      {
        std::size_t nearest = 0;
        const auto  apart   = [&](const std::size_t j) {
          return std::abs(b.real(j, "frequency_at_peak_hz") -
                          a.real(i, "frequency_at_peak_hz"));
        };
        if (apart(1) < apart(0))
          nearest = 1;
        Worst change;
        for (const char *edge : {"lower_coordinate", "upper_coordinate"})
          change.add(std::abs(a.real(i, edge) - b.real(nearest, edge)));
        stated_over_change.add(a.real(i, "edge_error_discretisation") /
                               change.largest());
      }
    check(stated_over_change.smallest() > 1. &&
            stated_over_change.largest() < 5.,
          "the stated error over the change: " +
            std::to_string(stated_over_change.smallest()) + " to " +
            std::to_string(stated_over_change.largest()));
  }
} // namespace

int
main(int argc, char *argv[])
{
  check(argc > 2, "arguments: the program and the folder of parameter files");
  program = argv[1];
  folder  = argv[2];
  for (const char *directory : {"second", "second_coarse", "third"})
    std::filesystem::remove_all(directory);
  sweep("second", 2, 27);
  // A basis is certified in the whole box, whatever the points in it.
  std::filesystem::create_directory("second_coarse");
  std::filesystem::copy_file("second/basis.h5", "second_coarse/basis.h5");
  sweep("second_coarse", 2, 14);
  check(text_of("second_coarse/run.log").find("basis of an earlier run") !=
          std::string::npos,
        "fewer points take the same basis");
  exceptional_points_agree("second", "second_coarse");
  // and neither do the edges hang on them
  sweep("third", 3, 14);
  errors_cover("second", "third");
  return 0;
}
