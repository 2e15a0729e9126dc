// SPDX-License-Identifier: LGPL-2.1-or-later

// Contact nodes that supports hold along the face, as on a plane of symmetry:
// they take friction that way only where their target slides past them. Motions
// about steady sliding of a block that cannot move across the sliding, and a
// bar between two planes of symmetry on a wall, under a force that is there at
// once (the wall force is twice that force for every other passage of the wave,
// and nothing between). Argument: squeal.

#include "analyses/program.h"
#include "scenes.h"
#include "transient/hand_made.h"
#include "worst.h"

#include <squeal/results/table.h>
#include <squeal/transient/linearized_motion.h>
#include <squeal/transient/steady_sliding.h>

#include <algorithm>
#include <tuple>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  constexpr double mu = .3, speed = .1, stiffness = 4e6;

  /** A block of 1 kg on springs along and along its normal; what holds it
   * across
   * the sliding is rigid or, with @p across, m/N, gives way a little. */
  ReducedContactModel
  block(const double across)
  {
    ReducedContactModel m = empty_model(1, 2);
    m.omega_squared << stiffness, 2. * stiffness;
    m.participation(0, 0) = m.participation(1, 1) = -1.;
    m.flexibility.diagonal() << 1e-9, 1e-9, across;
    m.load[0] = -100.;
    m.cut_off = 1e4;
    return m;
  }

  /** Ascending, 1/s, above 0. */
  std::vector<std::complex<double>>
  motions(const double across)
  {
    const ReducedContactModel         m      = block(across);
    const SteadySliding               steady = steady_sliding(m, mu, 1., 1e-12);
    std::vector<std::complex<double>> result;
    for (const auto &lambda : linearize(m, steady, mu, speed).lambda)
      if (lambda.imag() > 0.)
        result.push_back(lambda);
    return result;
  }

  void
  a_block_held_across()
  {
    const auto held = motions(0.), nearly = motions(1e-15);
    check(!held.empty() && held.size() == nearly.size(), "motions in time");
    Worst off;
    for (std::size_t i = 0; i < held.size() && i < nearly.size(); ++i)
      off.add(std::abs(held[i] - nearly[i]) / std::abs(nearly[i]));
    check_below(off.largest(), 1e-9, "those of a block that is nearly held");
  }

  const std::string bar = R"(set Output directory = out
set Overwrite = true
set Analysis = transient
subsection Scene
  set Bodies = floor, bar
  set Supports = below, above, left, right
  set Loads = press
  set Contacts = wall
  subsection Body floor
    set Size = 0.02, 0.02, 0.01
    set Position = 0, 0, -0.01
    set Cells = 1, 1, 1
  end
  subsection Body bar
    set Size = 0.01, 0.01, 0.1
    set Cells = 1, 1, 40
    set Young modulus = 1e9
    set Poisson ratio = 0
    set Density = 1000
  end
  subsection Support below
    set Body = floor
    set Face = z_min
  end
  subsection Support above
    set Body = floor
    set Face = z_max
  end
  subsection Support left
    set Body = bar
    set Face = x_min
    set Kind = components
    set Components = x, y
  end
  subsection Support right
    set Body = bar
    set Face = x_max
    set Kind = components
    set Components = x, y
  end
  subsection Contact wall
    set Source body = bar
    set Source face = z_min
    set Target body = floor
    set Target face = z_max
    set Formulation = mortar
    set Contact state = preload
    set Friction coefficient = 0.3
    set Sliding speed = 0.02
  end
  subsection Load press
    set Body = bar
    set Face = z_max
    set Force = 0, 0, -100
  end
end
subsection Discretization
  set Degree = 1
  set Estimate error = false
end
subsection Eigenvalues
  set Highest frequency = 20000
end
subsection Transient
  set Start = ramp
  set Cut-off = 200000
  set Time step = 1e-6
  set Sample interval = 1e-6
  set End time = 5e-4
  set Disturbance = 0
end
subsection Output
  set Plots = false
end
)";

  /** Mean of the column @p name between @p first and @p last passages of the
   * wave, each 1e-4 s. */
  double
  mean_between(const Table       &forces,
               const std::string &name,
               const double       first,
               const double       last)
  {
    double       sum = 0.;
    unsigned int n   = 0;
    for (std::size_t i = 0; i < forces.n_rows(); ++i)
      if (const double passages = forces.real(i, "time_s") / 1e-4;
          passages > first && passages < last)
        {
          sum += forces.real(i, name);
          ++n;
        }
    return sum / n;
  }

  void
  a_bar_on_a_wall(const std::string &program)
  {
    write_text("bar.prm", bar);
    const Outcome o = run_program({program, "bar.prm"});
    check(o.code == 0, "the bar moves: " + o.errors);
    const Table forces = read_csv("out/forces.csv");
    for (const auto &[first, last, force] : {std::make_tuple(0.1, 0.9, 0.),
                                             std::make_tuple(1.1, 2.9, 200.),
                                             std::make_tuple(3.1, 4.9, 0.)})
      check_close(mean_between(forces, "normal_n", first, last),
                  force,
                  .01,
                  "wall force from passage " + number(first) + " on",
                  200.);
    Worst off;
    for (std::size_t i = 0; i < forces.n_rows(); ++i)
      off.add(std::abs(forces.real(i, "tangential_n") -
                       mu * forces.real(i, "normal_n")));
    check_below(off.largest(), 1e-5, "friction of what slides past the bar, N");
  }
} // namespace

int
main(int argc, char **argv)
{
  check(argc == 2, "argument: squeal");
  a_block_held_across();
  a_bar_on_a_wall(argv[1]);
}
