// SPDX-License-Identifier: LGPL-2.1-or-later

// The laboratory brake. The upper half, whose middle plane does not move along
// itself, has exactly the pairs of the whole brake that bend the disc (its
// motions along and across the plane do not mix, as it is its own mirror
// image). And where its pads are pressed and dragged, of (0,7) the member
// squeals that has its antinode at the pads: + with one pad, - with two half a
// wavelength apart. Arguments: squeal, the folder of parameter files.

#include "program.h"
#include "worst.h"

#include <squeal/results/table.h>

#include <cmath>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  std::string program, prm;

  Table
  pairs_of(const std::string              &file,
           const std::string              &directory,
           const std::vector<std::string> &settings)
  {
    std::vector<std::string> words = {program};
    for (const std::string &setting : {"Output directory = " + directory,
                                       std::string("Output/Plots = false"),
                                       std::string("Output/Report = false"),
                                       std::string("Output/Shapes = none")})
      words.insert(words.end(), {"--set", setting});
    for (const std::string &setting : settings)
      words.insert(words.end(), {"--set", setting});
    words.push_back(prm + "/laboratory_brake/" + file);
    const Outcome o = run_program(words);
    check(o.code == 0, directory + " runs: " + o.errors);
    return read_csv(directory + "/eigenvalues.csv");
  }

  /** The distance of a pair to the nearest one of another table, over 2 pi f.
   */
  double
  distance(const Table &pairs, const std::size_t i, const Table &others)
  {
    Worst from;
    for (std::size_t k = 0; k < others.n_rows(); ++k)
      from.add(std::hypot(
        pairs.real(i, "sigma_per_s") - others.real(k, "sigma_per_s"),
        2. * M_PI *
          (pairs.real(i, "frequency_hz") - others.real(k, "frequency_hz"))));
    return from.smallest() / (2. * M_PI * pairs.real(i, "frequency_hz"));
  }

  void
  halves()
  {
    std::vector<std::string> coarse = {"Eigenvalues/Lowest frequency = 3000",
                                       "Eigenvalues/Highest frequency = 7000"};
    const auto               add    = [&](const std::string &side) {
      coarse.push_back("Scene/Body " + side + "beam/Cells = 1, 12, 1");
      for (const std::string &pad : {side + "pad", side + "second_pad"})
        coarse.insert(
          coarse.end(),
          {"Scene/Body " + pad + "/Cells = 1, 1, 1",
           "Scene/Contact " + pad + "_on_disc/Grid = 5, 5",
           "Scene/Contact " + pad + "_on_disc/Contact state = full"});
    };
    add("");
    std::vector<std::string> settings = coarse;
    settings.push_back("Scene/Body disc/Cells = 24, 2, 1");
    const Table half = pairs_of("two_pads.prm", "half", settings);
    add("lower_");
    settings = coarse;
    settings.push_back("Scene/Body disc/Cells = 24, 2, 2");
    const Table whole = pairs_of("both_sides.prm", "whole", settings);
    check(half.n_rows() > 5 && whole.n_rows() > half.n_rows(),
          "the half has some of the pairs of the whole");
    Worst worst;
    for (std::size_t i = 0; i < half.n_rows(); ++i)
      worst.add(distance(half, i, whole));
    // Both are certified to 1e-8 or better.
    check(worst.largest() < 1e-7,
          "pairs of the half are in the whole: " +
            std::to_string(worst.largest() / 1e-9) + "e-9");
  }

  /** The member at rest is stable, unmixed and the lower one of the two. */
  void
  higher_member(const std::string &file, const std::string &at_rest)
  {
    const Table pairs = pairs_of(file, file + ".results", {});
    double      rest = 0., squeal = 0.;
    std::size_t n_unstable = 0;
    for (std::size_t i = 0; i < pairs.n_rows(); ++i)
      {
        const double f     = pairs.real(i, "frequency_hz"),
                     sigma = pairs.real(i, "sigma_per_s"),
                     share = pairs.real(i, "ke_share_disc");
        if (sigma > 0.)
          {
            ++n_unstable;
            squeal = f;
            check(share > 0.5 && pairs.text(i, "name").find("(0,7") == 0,
                  file + ": what squeals is (0,7) foremost");
          }
        else if (pairs.text(i, "name") == at_rest)
          {
            rest = f;
            check(share > 0.98, file + ": the other one is the disc alone");
          }
      }
    check(n_unstable == 1, file + ": one pair squeals");
    check(rest > 0. && squeal > rest,
          file + ": the member with its node at the pads is the lower one");
  }
} // namespace



int
main(int argc, char **argv)
{
  check(argc == 3, "arguments: squeal, prm");
  program = argv[1];
  prm     = argv[2];
  halves();
  higher_member("pressed.prm", "(0,7-)");
  higher_member("two_pads.prm", "(0,7+)");
}
