// SPDX-License-Identifier: LGPL-2.1-or-later

// The complex eigenvalue analysis and the sweep call the pairs of one scene
// alike, those about 5 kHz too, where the disc is all but pinned by the pad.
// Argument: the program.

#include <squeal/results/table.h>

#include "program.h"
#include "source_directory.h"

#include <cmath>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  Table
  run(const std::string              &program,
      const std::string              &file,
      const std::string              &directory,
      const std::vector<std::string> &settings)
  {
    std::vector<std::string> all = {
      program, SQUEAL_SOURCE_DIR "/prm/tribobrake/" + file};
    std::vector<std::string> common = {"Scene/Body disc/Cells = 16, 3, 1",
                                       "Scene/Body pad/Cells = 2, 2, 2",
                                       "Scene/Body support/Cells = 2, 2, 6",
                                       "Discretization/Degree = 2",
                                       "Discretization/Estimate error = false",
                                       "Eigenvalues/Lowest frequency = 2000",
                                       "Eigenvalues/Highest frequency = 6000",
                                       "Output/Plots = false",
                                       "Output/Report = false",
                                       "Overwrite = true",
                                       "Output directory = " + directory};
    common.insert(common.end(), settings.begin(), settings.end());
    for (const auto &setting : common)
      {
        all.push_back("--set");
        all.push_back(setting);
      }
    const Outcome o = run_program(all);
    // 4: the expected figures of the fine mesh are not met.
    check(o.code == 0 || o.code == 4, file + " ends: " + o.errors);
    check(o.output.find("(n,m) is a disc that bends with n nodal circles") <
            o.output.find("(0,"),
          file + ": names are explained above the first one");
    return read_csv(directory + "/eigenvalues.csv");
  }
} // namespace



int
main(int argc, char **argv)
{
  check(argc == 2, "one argument");
  const Table  swept  = run(argv[1],
                          "stability_map.prm",
                          "sweep",
                          {"Sweep/Axis e_pad/Number = 2",
                             "Sweep/Axis e_pad/From = 10^10.4",
                             "Sweep/Axis e_pad/To = 10^10.5",
                             "Sweep/Axis mu/Values = 0.2, 0.5"});
  unsigned int n_5000 = 0;
  for (const std::string e_pad : {"10.4", "10.5"})
    for (const std::string mu : {"0.2", "0.5"})
      {
        const Table pairs =
          run(argv[1],
              "cea.prm",
              "cea",
              {"Output/Shapes = none",
               "Scene/Body pad/Young modulus = 10^" + e_pad,
               "Scene/Contact pad_disc/Friction coefficient = " + mu});
        unsigned int n_compared = 0;
        for (std::size_t i = 0; i < pairs.n_rows(); ++i)
          for (std::size_t j = 0; j < swept.n_rows(); ++j)
            {
              const double f = pairs.real(i, "frequency_hz");
              if (std::abs(std::log10(swept.real(j, "e_pad")) -
                           std::stod(e_pad)) > 1e-6 ||
                  std::abs(swept.real(j, "mu") - std::stod(mu)) > 1e-9 ||
                  std::abs(swept.real(j, "frequency_hz") - f) > 1e-6 * f ||
                  std::abs(swept.real(j, "sigma_per_s") -
                           pairs.real(i, "sigma_per_s")) > 1.)
                continue;
              ++n_compared;
              n_5000 += std::abs(f - 5000.) < 100.;
              check(pairs.text(i, "name") == swept.text(j, "name"),
                    pairs.text(i, "name") + " and " + swept.text(j, "name") +
                      " at " + std::to_string(f) + " Hz");
            }
        check(n_compared >= pairs.n_rows(), "every pair is in the sweep");
      }
  check(n_5000 >= 8, "two pairs about 5 kHz at each of four points");
}
