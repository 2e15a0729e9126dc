// SPDX-License-Identifier: LGPL-2.1-or-later

// Where two pairs of a mass with two degrees of freedom coalesce, at a complex
// friction coefficient because one of its motions is damped: coordinate,
// frequency and growth rate of the closed form. Without the inclined spring its
// motions cross and do not coalesce. Argument: the program.

#include <squeal/results/table.h>

#include "program.h"

#include <cmath>
#include <complex>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  using Complex = std::complex<double>;

  // Along y and z, inclined between them, and of the contact, N/m; N s/m.
  constexpr double along = 1e5, across = 2e4, inclined = 4e4, contact = 5e4,
                   dashpot = 10.;

  const std::string scene = R"(set Analysis = sweep
set Output directory = out
set Overwrite = true
subsection Scene
  set Bodies   = mass
  set Supports = plane
  set Springs  = along, across, inclined
  set Contacts = belt
  subsection Body mass
    set Shape = rigid
    set Mass  = 1
  end
  subsection Support plane
    set Body       = mass
    set Kind       = components
    set Components = x, rx, ry, rz
  end
  subsection Spring along
    set Body      = mass
    set Direction = 0, 1, 0
    set Stiffness = 1e5
  end
  subsection Spring across
    set Body      = mass
    set Direction = 0, 0, 1
    set Stiffness = 2e4
    set Dashpot   = 10
  end
  subsection Spring inclined
    set Body      = mass
    set Direction = 0, 1, 1
    set Stiffness = 4e4
  end
  subsection Contact belt
    set Source body      = mass
    set Target body      = ground
    set Grid             = 1, 1
    set Normal stiffness = 5e4
  end
end
subsection Eigenvalues
  set Highest frequency = 100
end
subsection Sweep
  set Axes = mu
  set Exceptional points = true
  subsection Axis mu
    set Entries = Scene/Contact belt/Friction coefficient
    set From    = -1
    set To      = 1
    set Number  = 21
  end
end
subsection Output
  set Plots  = false
  set Report = false
end
)";

  struct Point
  {
    Complex mu, lambda;
  };

  /** a b = p with a double root: (a b)' = 0, where a and b are lambda^2 + c
   * lambda + k of the two motions, and p is the product of the couplings, in
   * one of which friction is. Newton from between the two. */
  Point
  closed_form()
  {
    const double k_1 = along + inclined / 2.,
                 k_2 = across + contact + inclined / 2.;
    Complex lambda(-dashpot / 4., std::sqrt(0.5 * (k_1 + k_2)));
    Complex p;
    for (int step = 0; step < 50; ++step)
      {
        const Complex a = lambda * lambda + k_1, da = 2. * lambda,
                      b  = lambda * lambda + dashpot * lambda + k_2,
                      db = 2. * lambda + dashpot;
        p                = a * b;
        lambda -= (da * b + a * db) / (2. * b + 2. * da * db + 2. * a);
      }
    const double coupling = inclined / 2.;
    // Of either sign, by which way the belt runs.
    return {(p / coupling - coupling) / contact, lambda};
  }

  void
  coalesce(const std::string &program)
  {
    write_text("mass.prm", scene);
    const Outcome o = run_program({program, "mass.prm"});
    check(o.code == 0, "the sweep runs: " + o.errors);
    const Table points = read_csv("out/exceptional_points.csv");
    check(points.n_rows() == 1, "one point, not its conjugate too");
    const Point truth = closed_form();
    check(std::abs(truth.mu.imag()) > 0.02, "it lies off the real axis");
    check_close(std::abs(points.real(0, "coordinate_real")),
                std::abs(truth.mu.real()),
                1e-6,
                "real part of the coordinate");
    check_close(std::abs(points.real(0, "coordinate_imaginary")),
                std::abs(truth.mu.imag()),
                1e-6,
                "imaginary part of the coordinate");
    check_close(points.real(0, "frequency_hz"),
                truth.lambda.imag() / (2. * M_PI),
                1e-6,
                "frequency of the coalesced pair");
    check_close(points.real(0, "sigma_per_s"),
                truth.lambda.real(),
                1e-6,
                "growth rate of the coalesced pair");
  }

  /** The stiffness of one motion is swept through that of the other one, no
   * spring being inclined. */
  void
  cross(const std::string &program)
  {
    std::string text =
      replaced_in(scene, "set Direction = 0, 1, 1", "set Direction = 0, 1, 0");
    text = replaced_in(text, "Axes = mu", "Axes = k");
    text = replaced_in(text, "subsection Axis mu", "subsection Axis k");
    text = replaced_in(text,
                       "Scene/Contact belt/Friction coefficient",
                       "Scene/Spring along/Stiffness");
    text = replaced_in(text, "set From    = -1", "set From = 1e4");
    text = replaced_in(text, "set To      = 1\n", "set To = 5e4\n");
    text = replaced_in(text, "set Dashpot   = 10", "set Dashpot = 60");
    write_text("crossing.prm", text);
    const Outcome o = run_program({program, "crossing.prm"});
    check(o.code == 0, "the sweep of a stiffness runs: " + o.errors);
    check(read_csv("out/exceptional_points.csv").n_rows() == 0,
          "motions that are not coupled do not coalesce");
  }
} // namespace

int
main(int argc, char **argv)
{
  check(argc == 2, "argument: the program");
  coalesce(argv[1]);
  cross(argv[1]);
}
