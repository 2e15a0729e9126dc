// SPDX-License-Identifier: LGPL-2.1-or-later

// Terms that hold the forces of the contact: about a contact that loads press
// they do not hang on 'Normal force', a sweep has those of every point, and
// the work of friction counts them (closed form of a mass on a belt).
// Argument: the program.

#include <squeal/results/table.h>

#include "program.h"
#include "worst.h"

#include <cmath>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  std::string program;

  /** The small brake pressed by a pressure, with damping across the sliding. */
  std::string
  pressed_brake()
  {
    write_text("small.prm", small_brake);
    return R"(include small.prm
set Overwrite = true
subsection Scene
  set Loads = press
  subsection Load press
    set Body     = pad
    set Face     = z_max
    set Pressure = 1e6
  end
  subsection Contact pad_disc
    set Grid                      = 3, 3
    set Normal stiffness per area = 1e12
    set Contact state             = preload
    set Sliding speed             = 0.05
    set Transverse slip term      = true
  end
end
subsection Discretization
  set Estimate error = false
end
subsection Eigenvalues
  set Highest frequency = 20000
end
)";
  }

  Table
  pairs_of(const std::string &text, const std::vector<std::string> &changes)
  {
    std::filesystem::remove_all("out");
    write_text("brake.prm", text);
    std::vector<std::string> command = {program};
    for (const std::string &change : changes)
      {
        command.push_back("--set");
        command.push_back(change);
      }
    command.push_back("brake.prm");
    const Outcome o = run_program(command);
    check(o.code == 0, "runs: " + o.errors);
    return read_csv("out/eigenvalues.csv");
  }

  Table
  with_normal_force(const std::string &force)
  {
    return pairs_of(pressed_brake(),
                    {"Scene/Contact pad_disc/Normal force = " + force});
  }

  void
  no_reference()
  {
    const Table one = with_normal_force("1"), none = with_normal_force("0"),
                many = with_normal_force("1500");
    check(one.n_rows() > 3, "pairs in the band");
    Worst damped;
    for (std::size_t r = 0; r < one.n_rows(); ++r)
      {
        damped.add(-one.real(r, "sigma_per_s"));
        for (const Table *other : {&none, &many})
          {
            check_close(other->real(r, "frequency_hz"),
                        one.real(r, "frequency_hz"),
                        1e-9,
                        "frequency whatever 'Normal force' is");
            check_close(other->real(r, "sigma_per_s"),
                        one.real(r, "sigma_per_s"),
                        1e-6,
                        "growth rate whatever 'Normal force' is",
                        1e-3);
          }
      }
    check(damped.largest() > 10., "the term damps some pair");
  }

  void
  every_point()
  {
    const std::string axis =
      "subsection Sweep\n  set Axes = mu\n  set Sigma tolerance = 0.01\n"
      "  subsection Axis mu\n"
      "    set Entries = Scene/Contact pad_disc/Friction coefficient\n"
      "    set Scale = list\n    set Values = 0.05, 0.3, 0.4\n  end\nend\n";
    const Table swept =
      pairs_of(pressed_brake() + "set Analysis = sweep\n" + axis, {});
    for (const double mu : {0.05, 0.3, 0.4})
      {
        const Table alone =
          pairs_of(pressed_brake(),
                   {"Scene/Contact pad_disc/Friction coefficient = " +
                    std::to_string(mu)});
        unsigned int n = 0, n_all = 0;
        for (std::size_t r = 0; r < alone.n_rows(); ++r)
          n_all += alone.real(r, "frequency_hz") > 0.;
        for (std::size_t r = 0; r < alone.n_rows(); ++r)
          for (std::size_t s = 0; s < swept.n_rows(); ++s)
            if (swept.real(s, "mu") == mu &&
                std::abs(swept.real(s, "frequency_hz") /
                           alone.real(r, "frequency_hz") -
                         1.) < 1e-6 &&
                std::abs(swept.real(s, "sigma_per_s") -
                         alone.real(r, "sigma_per_s")) < 0.02)
              ++n;
        check(n == n_all && n > 3,
              "the sweep has the pairs of mu = " + std::to_string(mu) + ": " +
                std::to_string(n) + " of " + std::to_string(n_all));
      }
  }

  /** 1 kg on a spring of 1e4 N/m along a belt, N mu' = -10 N s/m: sigma = 5
   * 1/s, and friction feeds -2 pi c omega / (m omega^2 + sigma^2) of the
   * kinetic energy a cycle. Across, nothing is damped and nothing works. */
  void
  work_of_a_slope()
  {
    const Table pairs = pairs_of(R"(set Analysis = cea
set Output directory = out
set Overwrite = true
subsection Scene
  set Bodies = mass
  set Supports = plane
  set Springs = along, across
  set Contacts = belt
  subsection Body mass
    set Shape = rigid
    set Mass = 1
  end
  subsection Support plane
    set Body = mass
    set Kind = components
    set Components = x, rx, ry, rz
  end
  subsection Spring along
    set Body = mass
    set Direction = 0,1,0
    set Stiffness = 1e4
  end
  subsection Spring across
    set Body = mass
    set Direction = 0,0,1
    set Stiffness = 1e4
  end
  subsection Contact belt
    set Source body = mass
    set Target body = ground
    set Grid = 1, 1
    set Normal stiffness = 5e4
    set Friction coefficient = 0.3
    set Friction slope = -0.1
    set Normal force = 100
    set Sliding speed = 1
  end
end
subsection Eigenvalues
  set Highest frequency = 100
end
subsection Output
  set Plots  = false
  set Report = false
end
)",
                                 {});
    check(pairs.n_rows() == 2, "along and across the belt");
    const double omega = 2. * M_PI * pairs.real(0, "frequency_hz"),
                 sigma = pairs.real(0, "sigma_per_s");
    check_close(sigma, 5., 1e-6, "growth rate along the belt");
    check_close(pairs.real(0, "energy_per_cycle"),
                2. * M_PI * 10. * omega / (omega * omega + sigma * sigma),
                1e-3,
                "work of a falling coefficient");
    check(std::abs(pairs.real(1, "energy_per_cycle")) < 1e-9,
          "friction does not work on a pair that neither grows nor decays: " +
            std::to_string(pairs.real(1, "energy_per_cycle")));
  }
} // namespace

int
main(int argc, char **argv)
{
  check(argc == 2, "one argument");
  program = argv[1];
  work_of_a_slope();
  no_reference();
  every_point();
}
