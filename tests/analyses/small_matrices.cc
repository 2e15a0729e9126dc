// SPDX-License-Identifier: LGPL-2.1-or-later

// Imported matrices with eigenvalues in closed form. Three masses, one of which
// a negative stiffness pushes away: that is no free motion, and its growth rate
// is sqrt(-k/m). A chain of masses with an unknown without mass between any
// two. Argument: the program.

#include <squeal/results/table.h>

#include "program.h"
#include "worst.h"

#include <cmath>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  using Entries = std::map<std::pair<unsigned int, unsigned int>, double>;

  /** The lower half of a symmetric matrix; rows and columns from 0. */
  void
  write_matrix(const std::string &file,
               const unsigned int n,
               const Entries     &entries)
  {
    std::ostringstream text;
    text.precision(17);
    text << "%%MatrixMarket matrix coordinate real symmetric\n"
         << n << " " << n << " " << entries.size() << "\n";
    for (const auto &[place, value] : entries)
      text << place.first + 1 << " " << place.second + 1 << " " << value
           << "\n";
    write_text(file, text.str());
  }

  /** Eigenvalues of mass.mtx and stiffness.mtx below @p highest. */
  Table
  solved(const std::string &program, const std::string &highest)
  {
    write_text("matrices.prm",
               "set Analysis = cea\nset Output directory = out\n"
               "set Overwrite = true\n"
               "subsection Output\n set Plots = false\n"
               " set Report = false\nend\n"
               "subsection Scene\n set Kind = matrices\n"
               " set Matrix parts = m, k\n"
               " subsection Matrix part m\n  set File = mass.mtx\n"
               "  set Role = mass\n end\n"
               " subsection Matrix part k\n  set File = stiffness.mtx\n"
               "  set Role = stiffness\n end\nend\n"
               "subsection Eigenvalues\n set Highest frequency = " +
                 highest + "\nend\n");
    const Outcome o = run_program({program, "matrices.prm"});
    check(o.code == 0, "the matrices are solved: " + o.errors);
    return read_csv("out/eigenvalues.csv");
  }

  void
  negative_stiffness(const std::string &program)
  {
    write_matrix("mass.mtx", 3, {{{0, 0}, 2.}, {{1, 1}, 2.}, {{2, 2}, 2.}});
    write_matrix(
      "stiffness.mtx", 3, {{{0, 0}, -8e6}, {{1, 1}, 2e7}, {{2, 2}, 5e7}});
    const Table table = solved(program, "1000");
    Worst       sigma;
    for (std::size_t r = 0; r < table.n_rows(); ++r)
      sigma.add(table.real(r, "sigma_per_s"));
    check_close(sigma.largest(), 2000., 1e-8, "it diverges with sqrt(-k/m)");
    check_close(sigma.smallest(), -2000., 1e-8, "and comes back as fast");
  }

  /** Between two masses there are two springs and an unknown without mass,
   * which leaves half of the stiffness of one. */
  void
  without_mass(const std::string &program, const std::string &highest)
  {
    constexpr unsigned int n_masses = 30, n = 2 * n_masses + 1;
    constexpr double       mass = 1., spring = 1e7;
    Entries                m, k;
    for (unsigned int i = 0; i < n; ++i)
      {
        k[{i, i}] = 2. * spring;
        if (i > 0)
          k[{i, i - 1}] = -spring;
        if (i % 2 == 1)
          m[{i, i}] = mass;
      }
    write_matrix("mass.mtx", n, m);
    write_matrix("stiffness.mtx", n, k);
    const Table table     = solved(program, highest);
    const auto  frequency = [&](const unsigned int i) {
      return std::sqrt(.5 * spring / mass) *
             std::sin((i + 1) * M_PI / (2. * (n_masses + 1))) / M_PI;
    };
    Worst        off;
    unsigned int expected = 0;
    while (expected < n_masses && frequency(expected) < std::stod(highest))
      ++expected;
    check(table.n_rows() == expected,
          std::to_string(expected) + " pairs below " + highest + " Hz");
    for (unsigned int i = 0; i < expected; ++i)
      off.add(std::abs(table.real(i, "frequency_hz") / frequency(i) - 1.));
    check_within(off, 1e-9, "the chain of half the stiffness");
  }
} // namespace

int
main(int argc, char *argv[])
{
  check(argc == 2, "the program");
  negative_stiffness(argv[1]);
  for (const std::string highest : {"200", "500", "1000"})
    without_mass(argv[1], highest);
}
