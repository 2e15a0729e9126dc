// SPDX-License-Identifier: LGPL-2.1-or-later

// The laboratory brake on a coarse mesh: the upper half, whose middle plane does
// not move along itself, has exactly the pairs of the whole brake that bend the
// disc; and a sweep whose entries follow laws of their own puts the pads where
// they are put by hand, and tells which member of each doublet squeals.
// Arguments: squeal, the folder of parameter files.

#include "program.h"
#include "worst.h"

#include <squeal/results/table.h>

#include <cmath>
#include <set>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  std::string program, prm;

  void
  run(const std::string              &file,
      const std::string              &directory,
      const std::vector<std::string> &settings)
  {
    std::vector<std::string> words = {program};
    for (const std::string &setting :
         {"Output directory = " + directory,
          std::string("Output/Plots = false"),
          std::string("Output/Report = false"),
          std::string("Output/Shapes = none"),
          std::string("Discretization/Estimate error = false"),
          std::string("Scene/Body beam/Cells = 1, 12, 1"),
          std::string("Scene/Body pad/Cells = 1, 1, 1"),
          std::string("Scene/Body second_pad/Cells = 1, 1, 1"),
          std::string("Eigenvalues/Highest frequency = 7000")})
      words.insert(words.end(), {"--set", setting});
    for (const std::string &setting : settings)
      words.insert(words.end(), {"--set", setting});
    words.push_back(prm + "/laboratory_brake/" + file);
    const Outcome o = run_program(words);
    check(o.code == 0, directory + " runs: " + o.errors);
  }

  /** The distance of a pair to the nearest one of another table, over 2 pi f. */
  double
  distance(const Table &pairs, const std::size_t i, const Table &others)
  {
    double nearest = 1e300;
    for (std::size_t k = 0; k < others.n_rows(); ++k)
      nearest = std::min(
        nearest,
        std::hypot(pairs.real(i, "sigma_per_s") -
                     others.real(k, "sigma_per_s"),
                   2. * M_PI *
                     (pairs.real(i, "frequency_hz") -
                      others.real(k, "frequency_hz"))));
    return nearest / (2. * M_PI * pairs.real(i, "frequency_hz"));
  }

  void
  halves()
  {
    run("both_sides.prm",
        "whole",
        {"Scene/Body disc/Cells = 24, 2, 2",
         "Scene/Body lower_beam/Cells = 1, 12, 1",
         "Scene/Body lower_pad/Cells = 1, 1, 1",
         "Scene/Body lower_second_pad/Cells = 1, 1, 1"});
    run("two_pads.prm",
        "half",
        {"Analysis = cea",
         "Eigenvalues/Lowest frequency = 3000",
         "Scene/Body disc/Cells = 24, 2, 1"});
    const Table half  = read_csv("half/eigenvalues.csv"),
                whole = read_csv("whole/eigenvalues.csv");
    check(half.n_rows() > 5 && whole.n_rows() > half.n_rows(),
          "half has some of the pairs of the whole");
    Worst worst;
    for (std::size_t i = 0; i < half.n_rows(); ++i)
      worst.add(distance(half, i, whole));
    check(worst.largest() < 1e-7,
          "pairs of the half are in the whole: " +
            std::to_string(worst.largest() / 1e-9) + "e-9");
  }

  void
  distances()
  {
    const std::vector<std::string> few = {"Scene/Body disc/Cells = 24, 2, 1",
                                          "Sweep/Axis e_pad/From = 10^8.5",
                                          "Sweep/Axis e_pad/To = 10^9",
                                          "Sweep/Axis e_pad/Number = 3"};
    run("distance.prm", "swept", few);
    std::vector<std::string> by_hand = few;
    by_hand.insert(by_hand.end(),
                   {"Sweep/Axes = e_pad",
                    "Scene/Body pad/Position = 0.1639420, 0.0367016, 0",
                    "Scene/Body second_pad/Position = 0.1639420, "
                    "-0.0367016, 0",
                    "Scene/Body beam/Position = 0.1639420, 0, 0.010"});
    run("distance.prm", "by_hand", by_hand);
    const Table      all = read_csv("swept/eigenvalues.csv"),
                     one = read_csv("by_hand/eigenvalues.csv");
    std::set<double> seen;
    Worst            worst;
    std::size_t      n = 0;
    for (std::size_t i = 0; i < all.n_rows(); ++i)
      {
        seen.insert(all.real(i, "distance"));
        if (all.real(i, "distance") != 0.074)
          continue;
        worst.add(distance(all, i, one));
        ++n;
      }
    check(seen.size() == 8, "all distances");
    check(n == one.n_rows() && n > 0 && worst.largest() < 1e-6,
          "pairs as with the pads put there by hand");

    const Table           doublets = read_csv("swept/doublets.csv");
    std::set<std::string> named;
    for (std::size_t i = 0; i < doublets.n_rows(); ++i)
      {
        const std::string squeals = doublets.text(i, "squeals");
        named.insert(doublets.text(i, "doublet"));
        const bool plus  = doublets.real(i, "sigma_plus_per_s") > 0.,
                   minus = doublets.real(i, "sigma_minus_per_s") > 0.;
        check((squeals == "none") == (!plus && !minus),
              "none where neither grows, row " + std::to_string(i));
        if (squeals == "+" && minus)
          check(doublets.real(i, "sigma_plus_per_s") >=
                  doublets.real(i, "sigma_minus_per_s"),
                "the louder member, row " + std::to_string(i));
      }
    check(named.count("(0,4)") == 1 && named.count("(0,5)") == 1,
          "the doublets of the band");
  }
} // namespace



int
main(int argc, char **argv)
{
  check(argc == 3, "arguments: squeal, prm");
  program = argv[1];
  prm     = argv[2];
  halves();
  distances();
}
