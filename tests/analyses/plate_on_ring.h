// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tests_analyses_plate_on_ring_h
#define squeal_tests_analyses_plate_on_ring_h

#include "program.h"

#include <cmath>
#include <iomanip>

/** A plate on a ring of springs whose friction lets it rock. */
namespace squeal::testing
{
  constexpr double ring_pi = 3.14159265358979323846;
  /** Radius of the ring and height of the centre of mass above it, m. */
  constexpr double ring_radius = .1, ring_height = .03;

  inline const std::string ring_scene = R"(set Overwrite = true
subsection Scene
  set Name                 = ring
  set Kind                 = matrices
  set Matrix parts         = mass, stiffness
  set Node table file      = nodes.csv
  set Contact pattern file = contact.csv
  set Contacts             = face
  set Loads                = press
  subsection Matrix part mass
    set File = mass.mtx
    set Role = mass
  end
  subsection Matrix part stiffness
    set File = stiffness.mtx
    set Role = stiffness
  end
  subsection Load press
    set Ramp time = 0
  end
  subsection Contact face
    set Source body          = plate
    set Formulation          = springs
    set Contact state        = full
    set Friction coefficient = 0.4
    set Transverse slip term = true
    set Sliding speed        = 5
    set Normal force         = 1000
  end
  subsection Damping
    set Model        = whole model
    set Mass damping = 100
  end
end
subsection Eigenvalues
  set Lowest frequency  = 1
  set Highest frequency = 5000
end
subsection Transient
  set Cut-off         = 20000
  set Time step       = 5e-6
  set Disturbance     = 1e-6
  set Sample interval = 2e-5
  set End time        = 0.2
  set History start   = 0.19
end
subsection Limit cycle
  set Run time = 0.1
end
subsection Output
  set Plots  = false
  set Report = false
end
)";

  inline void
  write_diagonal(const std::string &file, const std::array<double, 6> &values)
  {
    std::ostringstream text;
    text << std::setprecision(17)
         << "%%MatrixMarket matrix coordinate real symmetric\n6 6 6\n";
    for (unsigned int i = 0; i < 6; ++i)
      text << i + 1 << ' ' << i + 1 << ' ' << values[i] << '\n';
    write_text(file, text.str());
  }

  /** Of @p n springs, a plate of 2 kg with 1 kHz on them, and @p sweep. A rock
   * presses with @p n_waves round the ring, and is stiffer about y than about x
   * by twice the share @p unequal. */
  inline void
  write_ring(const unsigned int n,
             const std::string &sweep,
             const unsigned int n_waves = 1,
             const double       unequal = 0.)
  {
    const double square = std::pow(2. * ring_pi * 1000., 2);
    write_diagonal("mass.mtx", {{2., 2., 2., .01, .01, .02}});
    write_diagonal("stiffness.mtx",
                   {{8. * square,
                     8. * square,
                     .6 * square,
                     .002 * square * (1. - unequal),
                     .002 * square * (1. + unequal),
                     .08 * square}});
    std::ostringstream nodes, contact;
    nodes << "dof,node,component,x,y,z,body,load_press\n";
    for (unsigned int i = 0; i < 6; ++i)
      nodes << i + 1 << ",1," << i + 1 << ",0,0," << ring_height << ",plate,"
            << (i == 2 ? -1000 : 0) << '\n';
    write_text("nodes.csv", nodes.str());
    contact << std::setprecision(17)
            << "contact,pair,side,direction,node,component,weight,x,y,z,area\n";
    for (unsigned int j = 0; j < n; ++j)
      {
        const double angle = 2. * ring_pi * (j + .5) / n, c = std::cos(angle),
                     s = std::sin(angle), cosine = std::cos(n_waves * angle),
                     sine = std::sin(n_waves * angle), h = ring_height,
                     r = ring_radius;
        const std::pair<const char *, std::array<double, 6>> rows[] = {
          {"normal", {{0., 0., 1., r * sine, -r * cosine, 0.}}},
          {"sliding",
           {{-s, c, 0., n_waves * h * cosine, n_waves * h * sine, r}}},
          {"transverse", {{c, s, 0., h * sine, -h * cosine, 0.}}}};
        for (const auto &[direction, weights] : rows)
          for (unsigned int i = 0; i < 6; ++i)
            if (weights[i] != 0.)
              contact << "face," << j + 1 << ",source," << direction << ",1,"
                      << i + 1 << ',' << weights[i] << ',' << r * c << ','
                      << r * s << ",0,1e-3\n";
      }
    write_text("contact.csv", contact.str());
    write_text("ring.prm",
               ring_scene + "subsection Scene\n  subsection Contact face\n" +
                 "    set Normal stiffness = " +
                 std::to_string(2. * square / n) + "\n  end\nend\n" + sweep);
  }

  /** What it has printed. */
  inline std::string
  run_ring(const std::string &program, const std::vector<std::string> &settings)
  {
    std::vector<std::string> words = {program};
    for (const std::string &setting : settings)
      words.insert(words.end(), {"--set", setting});
    words.push_back("ring.prm");
    const Outcome o = run_program(words);
    check(o.code == 0, settings.front() + " runs: " + o.errors);
    return unbroken(o.output);
  }

} // namespace squeal::testing

#endif
