// SPDX-License-Identifier: LGPL-2.1-or-later

// Two masses between three equal springs, one of them a body with a lumped mass
// on it: the tables of the modes, the pairs and a sweep over the lumped mass
// have the shares of the closed form. Argument: the program.

#include <squeal/results/table.h>

#include "program.h"
#include "worst.h"

#include <cmath>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  constexpr double stiffness = 1e5, body_mass = 0.1;

  std::string
  carriage(const std::string &name, const double mass)
  {
    return "  subsection Body " + name + "\n    set Shape = rigid\n" +
           "    set Mass = " + std::to_string(mass) + "\n  end\n" +
           "  subsection Support s" + name + "\n    set Body = " + name +
           "\n    set Kind = components\n" +
           "    set Components = x, y, rx, ry, rz\n  end\n";
  }

  std::string
  spring(const std::string &name,
         const std::string &body,
         const std::string &other_body)
  {
    return "  subsection Spring " + name + "\n    set Body = " + body +
           "\n    set Other body = " + other_body +
           "\n    set Stiffness = " + std::to_string(stiffness) + "\n  end\n";
  }

  /** Bodies a (1 kg) and b, on which 0.9 kg are lumped. */
  std::string
  two_carriages()
  {
    return R"(set Overwrite = true
subsection Output
  set Plots  = false
  set Report = false
end
subsection Eigenvalues
  set Highest frequency = 300
end
subsection Sweep
  set Axes = m
  subsection Axis m
    set Entries = Scene/Lumped mass lm/Mass
    set From = 0.4
    set To = 1.4
    set Number = 5
  end
end
subsection Scene
  set Bodies = a, b
  set Supports = sa, sb
  set Springs = s1, s2, s3
  set Lumped masses = lm
  subsection Lumped mass lm
    set Body = b
    set Mass = 0.9
  end
)" + carriage("a", 1.) +
           carriage("b", body_mass) + spring("s1", "a", "ground") +
           spring("s2", "a", "b") + spring("s3", "b", "ground") + "end\n";
  }

  /** Of body a in the mode of squared circular frequency @p kappa, of which the
   * first row of (K - kappa M) x = 0 gives the shape. */
  double
  share_of_a(const double lumped, const double frequency)
  {
    const double kappa = std::pow(2. * M_PI * frequency, 2);
    const double b     = 2. - kappa / stiffness;
    return 1. / (1. + (body_mass + lumped) * b * b);
  }

  Table
  run_table(const std::string &program,
            const std::string &analysis,
            const std::string &table)
  {
    const Outcome o = run_program({program,
                                   "--set",
                                   "Analysis = " + analysis,
                                   "--set",
                                   "Output directory = " + analysis,
                                   "carriages.prm"});
    check(o.code == 0, analysis + " ends: " + o.errors);
    return read_csv(analysis + "/" + table);
  }

  void
  check_shares(const Table &table, const std::string &what)
  {
    Worst error, sum;
    for (std::size_t r = 0; r < table.n_rows(); ++r)
      {
        const double m = table.has_column("m") ? table.real(r, "m") : 0.9;
        const double a = table.real(r, "ke_share_a");
        error.add(std::abs(a - share_of_a(m, table.real(r, "frequency_hz"))));
        sum.add(std::abs(a + table.real(r, "ke_share_b") - 1.));
      }
    check_within(error, 1e-9, what + ": shares of the closed form");
    check_within(sum, 1e-14, what + ": of sum 1");
  }
} // namespace

int
main(int argc, char **argv)
{
  check(argc == 2, "one argument");
  write_text("carriages.prm", two_carriages());
  const Table pairs = run_table(argv[1], "cea", "eigenvalues.csv");
  const Table modes = read_csv("cea/modes.csv");
  const Table swept = run_table(argv[1], "sweep", "eigenvalues.csv");
  check(modes.n_rows() == 2 && pairs.n_rows() == 2 && swept.n_rows() == 10,
        "two modes, at five masses");
  check_shares(modes, "modes");
  check_shares(pairs, "pairs");
  check_shares(swept, "sweep");
  check_close(pairs.real(0, "ke_share_a"),
              0.5,
              1e-9,
              "equal masses hold half of the energy each");
}
