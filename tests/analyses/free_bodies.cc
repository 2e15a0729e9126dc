// SPDX-License-Identifier: LGPL-2.1-or-later

// Bodies and mechanisms that nothing holds are said by name: a warning with
// the modes, and a refusal of complex eigenvalues where lambda = 0 is
// defective. What soft springs hold far below the band is none of them. Sweeps
// above 0 Hz have every pair, state their errors, and take no
// rounding for growth. Argument: the program.

#include <squeal/results/table.h>

#include "program.h"
#include "worst.h"

#include <cmath>
#include <sstream>

using namespace squeal;
using namespace squeal::testing;
namespace fs = std::filesystem;

namespace
{
  std::string program;

  Outcome
  run(const std::string &text, const std::vector<std::string> &settings)
  {
    write_text("free.prm", text);
    std::vector<std::string> words = {program, "--set", "Overwrite = true"};
    for (const std::string &setting : settings)
      words.insert(words.end(), {"--set", setting});
    words.push_back("free.prm");
    return run_program(words);
  }

  bool
  says(const std::string &text, const std::string &part)
  {
    return unbroken(text).find(part) != std::string::npos;
  }

  /** A pad held by nothing, a disc held at its inner edge. */
  std::string
  free_pad()
  {
    std::string text = replaced_in(small_brake, "edge, top\n", "edge\n");
    const auto  from = text.find("  subsection Support top");
    const auto  to   = text.find("  subsection Contact");
    return text.erase(from, to - from);
  }

  /** Two masses on a guide, a spring between them: they drift together. A
   * third is held along x only. */
  const std::string mechanism = R"(set Analysis         = modes
set Output directory = out
subsection Scene
  set Bodies   = left, right, fixed
  set Supports = guide_left, guide_right, upright
  set Springs  = link, hold
  subsection Body left
    set Shape = rigid
  end
  subsection Body right
    set Shape = rigid
  end
  subsection Body fixed
    set Shape = rigid
  end
  subsection Support guide_left
    set Body       = left
    set Kind       = components
    set Components = y, z, rx, ry, rz
  end
  subsection Support guide_right
    set Body       = right
    set Kind       = components
    set Components = y, z, rx, ry, rz
  end
  subsection Support upright
    set Body       = fixed
    set Kind       = components
    set Components = rx, ry, rz
  end
  subsection Spring link
    set Body       = left
    set Other body = right
    set Direction  = 1, 0, 0
    set Stiffness  = 100
  end
  subsection Spring hold
    set Body      = fixed
    set Direction = 1, 0, 0
    set Stiffness = 100
  end
end
subsection Eigenvalues
  set Highest frequency = 20
end
)";

  /** A thin free ring at three speeds about the axis, in rad/s. */
  const std::string ring = R"(set Analysis         = sweep
set Output directory = ring
subsection Scene
  set Bodies = ring
  subsection Body ring
    set Shape          = annulus
    set Inner radius   = 0.099
    set Outer radius   = 0.101
    set Height         = 0.006
    set Cells          = 48, 1, 1
    set Young modulus  = 210e9
    set Density        = 7800
    set Rotation speed = 100
  end
end
subsection Discretization
  set Degree         = 3
  set Estimate error = false
end
subsection Eigenvalues
  set Lowest frequency  = 60
  set Highest frequency = 450
end
subsection Sweep
  set Axes               = speed
  set Direct checks      = 2
  set Exceptional points = false
  subsection Axis speed
    set Entries = Scene/Body ring/Rotation speed
    set Scale   = list
    set Values  = 10, 50, 200
  end
end
subsection Output
  set Plots  = false
  set Report = false
end
)";

  /** Of the inextensional ring with the tension of its turning, seen from the
   * fixed frame: sqrt(omega_m^2 + c^2) +- c, c = m Omega (m^2 - 1) / (m^2 + 1),
   * in Hz. */
  double
  closed_form(const int m, const double speed, const int direction)
  {
    const double still = std::sqrt(210e9 / 7800. / 12.) * .002 / .01 * m *
                         (m * m - 1.) / std::sqrt(m * m + 1.),
                 c = m * speed * (m * m - 1.) / (m * m + 1.);
    return (std::sqrt(still * still + c * c) + direction * c) / (2. * M_PI);
  }

  /** What a sweep states is no less than a tenth of what its direct checks
   * find, rounding aside, and these are within the tolerance. */
  void
  check_stated_errors(const std::string &directory, const Outcome &outcome)
  {
    const Table table = read_csv(directory + "/direct_check.csv");
    check(table.n_rows() > 0, "pairs are checked");
    for (std::size_t row = 0; row < table.n_rows(); ++row)
      {
        const double error    = table.real(row, "error_rel"),
                     estimate = table.real(row, "error_estimate_rel");
        check(error < 1e-6 && (error < 1e-8 || error < 10. * estimate),
              "the error of a pair is what is stated");
        // The direct solver leaves some 1e-10.
        check(error < 1e-9 || estimate > 0., "no error of 0 is stated");
      }
    check(!says(outcome.output + outcome.errors, "direct_check.csv holds"),
          "no warning of false errors");
  }

  void
  sweep_of_turning_free_ring()
  {
    const Outcome o = run(ring, {});
    check(o.code == 0, "sweep of a free ring: " + o.errors);
    const Table table = read_csv("ring/eigenvalues.csv");
    for (const double speed : {10., 50., 200.})
      for (const int m : {2, 3})
        for (const int direction : {-1, 1})
          {
            const double expected = closed_form(m, speed, direction);
            bool         is_there = false;
            for (std::size_t row = 0; row < table.n_rows(); ++row)
              is_there =
                is_there ||
                (std::abs(table.real(row, "speed") - speed) < 1e-6 * speed &&
                 std::abs(table.real(row, "frequency_hz") - expected) <
                   1e-3 * expected);
            std::ostringstream text;
            text << "at " << speed << " rad/s there is " << expected << " Hz";
            check(is_there, text.str());
          }
    for (std::size_t row = 0; row < table.n_rows(); ++row)
      check(table.integer(row, "unstable") == 0,
            "rounding of an undamped pair is no growth");
    check(read_csv("ring/unstable_ranges.csv").n_rows() == 0,
          "and makes no unstable range");
    check_stated_errors("ring", o);
  }

  /** A rigid disc and two rigid pads on springs; the disc may turn. The numbers
   * of unknowns are few, so that free motions are a large share of each basis.
   */
  std::string
  rigid_brake()
  {
    std::string text   = R"(set Analysis         = sweep
set Output directory = rigid
subsection Scene
  set Bodies   = disc, above, below
  set Contacts = upper, lower
  set Springs  = d1, d2, a1, a2, a3, b1, b2, b3
  subsection Body disc
    set Shape   = rigid
    set Mass    = 5
    set Inertia = 0.03, 0.031, 0.06
  end
  subsection Body above
    set Shape    = rigid
    set Mass     = 0.3
    set Inertia  = 1e-4, 3e-5, 1.2e-4
    set Position = 0.11, 0, 0.012
  end
  subsection Body below
    set Shape    = rigid
    set Mass     = 0.31
    set Inertia  = 1.1e-4, 3.1e-5, 1.3e-4
    set Position = 0.11, 0, -0.012
  end
)";
    const auto  spring = [&text](const std::string &name,
                                const std::string &body,
                                const std::string &point,
                                const std::string &stiffnesses) {
      text += "  subsection Spring " + name + "\n    set Body = " + body +
              "\n    set First point = " + point +
              "\n    set Last point = " + point +
              "\n    set Stiffnesses = " + stiffnesses + "\n  end\n";
    };
    spring("d1", "disc", "0, 0, 0.02", "8e7, 9e7, 2e8");
    spring("d2", "disc", "0, 0, -0.03", "7e7, 6e7, 1e8");
    const auto pad = [&](const std::string &name,
                         const std::string &body,
                         const std::string &z) {
      spring(name + "1", body, "0.11, 0.04, " + z, "5e6, 6e7, 3e7");
      spring(name + "2", body, "0.12, -0.03, " + z, "4e6, 2e7, 2.5e7");
      spring(name + "3", body, "0.10, -0.01, " + z, "6e6, 3e6, 2e7");
    };
    pad("a", "above", "0.018");
    pad("b", "below", "-0.018");
    const auto contact = [&text](const std::string &name,
                                 const std::string &body,
                                 const std::string &z) {
      text += "  subsection Contact " + name +
              "\n    set Source body = " + body +
              "\n    set Target body = disc\n    set Contact point = 0, "
              "0.005, " +
              z +
              "\n    set Grid = 1, 1\n    set Normal stiffness = 4e7\n"
              "    set Friction coefficient = 0.3\n  end\n";
    };
    contact("upper", "above", "-0.006");
    contact("lower", "below", "0.006");
    return text + R"(end
subsection Eigenvalues
  set Lowest frequency = 50
end
subsection Sweep
  set Axes          = mu
  set Direct checks = 2
  subsection Axis mu
    set Entries = Scene/Contact upper/Friction coefficient, Scene/Contact lower/Friction coefficient
    set From    = 0
    set To      = 0.7
    set Number  = 5
  end
end
subsection Output
  set Plots  = false
  set Report = false
end
)";
  }

  /** Wherever the band ends, the errors are stated right; with all unknowns in
   * the basis both the sweep and the direct solver are exact. */
  void
  sweep_of_rigid_brake_that_may_turn()
  {
    for (const std::string highest : {"800", "1000", "5000"})
      {
        const Outcome o =
          run(rigid_brake(), {"Eigenvalues/Highest frequency = " + highest});
        check(o.code == 0, "sweep of rigid bodies: " + o.errors);
        check_stated_errors("rigid", o);
      }
    const Table table = read_csv("rigid/direct_check.csv");
    Worst       errors;
    for (std::size_t row = 0; row < table.n_rows(); ++row)
      errors.add(table.real(row, "error_rel"));
    check_within(errors, 1e-11, "all unknowns are in the basis");
  }

  void
  sweep_of_free_pad()
  {
    const Outcome o =
      run(free_pad() +
            "subsection Sweep\n  set Axes = mu\n  set Direct checks = 2\n"
            "  subsection Axis mu\n    set Entries = Scene/Contact pad_disc/"
            "Friction coefficient\n    set Scale = list\n    set Values = "
            "0.2, 0.4\n  end\nend\n",
          {"Analysis = sweep",
           "Output directory = pad",
           "Eigenvalues/Lowest frequency = 500"});
    check(o.code == 0, "sweep of a brake with a free pad: " + o.errors);
    check_stated_errors("pad", o);
  }
  /** 1 kg on springs of some N/m rubs on a belt: K = [[2, 1 - 4 mu / 3],
   * [1, 2]] N/m for mu = 1 (Hoffmann et al. 2002). */
  const std::string soft_flutter = R"(set Analysis         = cea
set Output directory = soft
subsection Scene
  set Bodies   = mass
  set Supports = plane
  set Springs  = horizontal, inclined
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
  subsection Spring horizontal
    set Body      = mass
    set Direction = 0, 1, 0
    set Stiffness = 0.5
  end
  subsection Spring inclined
    set Body      = mass
    set Direction = 0, -1.5, 1
    set Stiffness = 2.166666666666667
  end
  subsection Contact belt
    set Source body          = mass
    set Target body          = ground
    set Grid                 = 1, 1
    set Normal stiffness     = 1.333333333333333
    set Friction coefficient = 1
  end
end
subsection Eigenvalues
  set Highest frequency = 20000
end
)";

  /** Motions at some tenths of a Hz below bands of 20 kHz: omega^2 is 1e-11 and
   * 1e-10 of the limit's. @p held_mechanism drifts in one way. */
  void
  what_soft_springs_hold(const std::string &held_mechanism)
  {
    Outcome o = run(soft_flutter, {});
    check(o.code == 0 && !says(o.output, "held by nothing"),
          "a mass on soft springs is held below a wide band: " + o.errors);
    const Table table = read_csv("soft/eigenvalues.csv");
    bool        grows = false;
    for (std::size_t row = 0; row < table.n_rows(); ++row)
      grows =
        grows || std::abs(table.real(row, "sigma_per_s") - 0.2020718) < 1e-5;
    check(grows, "and its flutter is found");
    o = run(soft_flutter, {"Eigenvalues/Lowest frequency = 0.1"});
    check(o.code == 0 && !says(o.output, "held by nothing"),
          "nor is it said above 0 Hz: " + o.errors);
    o =
      run(soft_flutter + "subsection Sweep\n  set Axes = mu\n  subsection Axis "
                         "mu\n    set Entries = Scene/Contact belt/Friction "
                         "coefficient\n    set Scale = list\n    set Values "
                         "= 0.5, 1\n  end\nend\n",
          {"Analysis = sweep"});
    check(!says(o.errors, "held by nothing"),
          "and a sweep from 0 Hz is not refused for it: " + o.errors);

    o = run(held_mechanism,
            {"Scene/Spring hold/Stiffness = 1",
             "Eigenvalues/Highest frequency = 20000"});
    check(o.code == 0 && says(o.output,
                              "1 motion at 0 Hz is held by nothing, of the "
                              "bodies left, right ("),
          "beside a mass on a soft spring the mechanism alone: " + o.errors);
  }
} // namespace



int
main(int argc, char **argv)
{
  check(argc == 2, "argument: the program");
  program = argv[1];
  for (const char *directory : {"out", "ring", "pad", "rigid", "soft"})
    fs::remove_all(directory);

  // Normal springs hold z, rx and ry of the pad: x, y and rz are free.
  Outcome o = run(free_pad(), {"Analysis = modes"});
  check(o.code == 0 &&
          says(o.output,
               "3 motions at 0 Hz are held by nothing, of the bodies pad ("),
        "modes: the pad is named");
  o = run(free_pad(), {});
  check(o.code == 2 && says(o.errors, "of the bodies pad") &&
          says(o.errors, "Eigenvalues/Lowest frequency"),
        "complex eigenvalues from 0 Hz are refused: " + o.errors);
  o = run(free_pad() + "subsection Sweep\n  set Axes = rho\n  subsection Axis "
                       "rho\n    set Entries = Scene/Body disc/Density\n    "
                       "set Scale = list\n    set Values = 4000, 8000\n  end\n"
                       "end\n",
          {"Analysis = sweep"});
  check(o.code == 2 && says(o.errors, "3 motions at 0 Hz are held by nothing"),
        "and so is a sweep from 0 Hz: " + o.errors);
  o = run(free_pad(), {"Eigenvalues/Lowest frequency = 100"});
  check(o.code == 0 && says(o.output, "of the bodies pad"),
        "from 100 Hz on they are computed");
  o = run(small_brake, {});
  check(o.code == 0 && !says(o.output, "held by nothing"),
        "nothing is said of bodies that are held");

  o = run(mechanism, {});
  check(o.code == 0 &&
          says(o.output,
               "3 motions at 0 Hz are held by nothing, of the bodies "
               "left, right, fixed"),
        "a mechanism and two motions of a lone mass");
  const std::string held = replaced_in(
    mechanism, "Components = rx, ry, rz", "Components = y, z, rx, ry, rz");
  o = run(held, {});
  check(o.code == 0 && says(o.output,
                            "1 motion at 0 Hz is held by nothing, of the "
                            "bodies left, right ("),
        "the mechanism alone");
  what_soft_springs_hold(held);

  sweep_of_turning_free_ring();
  sweep_of_free_pad();
  sweep_of_rigid_brake_that_may_turn();
}
