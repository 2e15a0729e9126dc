// SPDX-License-Identifier: LGPL-2.1-or-later

// The participation of the contact is relative to the mass of the whole scene:
// lumped masses belong to it, and along a sweep it is that of each point.
// Argument: the program.

#include <squeal/results/table.h>

#include "program.h"
#include "worst.h"

#include <cmath>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  /** Relative, of pairs that are solved for in different ways. */
  constexpr double tolerance = 1e-5;

  std::string program;

  /** The small brake with @p mass, kg, on the clamped edge of its disc, where
   * it does not move. */
  std::string
  with_held_mass(const std::string &mass)
  {
    return small_brake +
           "subsection Scene\n  set Lumped masses = held\n"
           "  subsection Lumped mass held\n    set Body = disc\n"
           "    set Point = 0.05, 0, -0.005\n    set Mass = " +
           mass + "\n  end\nend\n";
  }

  Table
  pairs_of(const std::string &text)
  {
    std::filesystem::remove_all("out");
    write_text("brake.prm", text);
    const Outcome o = run_program({program, "brake.prm"});
    check(o.code == 0, "runs: " + o.errors);
    return read_csv("out/eigenvalues.csv");
  }

  void
  held_masses()
  {
    const Table one  = pairs_of(with_held_mass("1")),
                two  = pairs_of(with_held_mass("2")),
                four = pairs_of(with_held_mass("4"));
    check(one.n_rows() > 0 && two.n_rows() == one.n_rows() &&
            four.n_rows() == one.n_rows(),
          "the same pairs with every mass");
    Worst change;
    for (std::size_t r = 0; r < one.n_rows(); ++r)
      {
        check_close(two.real(r, "frequency_hz"),
                    one.real(r, "frequency_hz"),
                    1e-9,
                    "a mass that is held moves no frequency");
        const double p     = one.real(r, "contact_participation"),
                     first = two.real(r, "contact_participation") - p,
                     last  = four.real(r, "contact_participation") - p;
        check(first > 1e-3 * p, "a lumped mass counts");
        change.add(std::abs(last / first - 3.));
      }
    check_within(change, 1e-2, "and three times the mass three times");
  }

  /** At the lighter disc no pair is in the band. */
  void
  swept_density()
  {
    const std::string axis =
      "subsection Sweep\n  set Axes = rho\n  subsection Axis rho\n"
      "    set Entries = Scene/Body disc/Density\n    set Scale = list\n"
      "    set Values = 4000, 16000\n  end\nend\n";
    const Table swept = pairs_of(replaced_in(small_brake,
                                             "set Analysis         = cea",
                                             "set Analysis         = sweep") +
                                 axis);
    const Table heavy =
      pairs_of(small_brake + "subsection Scene\n  subsection Body disc\n    "
                             "set Density = 16000\n  end\nend\n");
    unsigned int n = 0;
    Worst        all; // modes that leave the contact alone have none
    for (std::size_t r = 0; r < heavy.n_rows(); ++r)
      all.add(heavy.real(r, "contact_participation"));
    const double largest = all.largest();
    check(largest > 0., "some mode moves the contact");
    for (std::size_t r = 0; r < heavy.n_rows(); ++r)
      for (std::size_t s = 0; s < swept.n_rows(); ++s)
        if (swept.real(s, "rho") == 16000. &&
            std::abs(swept.real(s, "frequency_hz") /
                       heavy.real(r, "frequency_hz") -
                     1.) < 1e-8)
          {
            ++n;
            check(std::abs(swept.real(s, "contact_participation") -
                           heavy.real(r, "contact_participation")) <=
                    tolerance * largest,
                  "participation at a point is that of its scene");
            check(swept.text(s, "partner_1") == heavy.text(r, "partner_1"),
                  "its undamped partner, too: " + swept.text(s, "partner_1") +
                    " and " + heavy.text(r, "partner_1"));
          }
    check(n == heavy.n_rows() && n > 0, "every pair is found again");
  }
} // namespace

int
main(int argc, char **argv)
{
  check(argc == 2, "one argument");
  program = argv[1];
  held_masses();
  swept_density();
}
