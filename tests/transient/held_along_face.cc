// SPDX-License-Identifier: LGPL-2.1-or-later

// Contact nodes that supports hold along the face, as on a plane of symmetry:
// they take friction that way only where their target slides past them. Motions
// about steady sliding of a block that cannot move across the sliding, or does
// so in its modes alone, a bar between two planes of symmetry on a wall, under
// a force that is there at once (the wall force is twice that force for every
// other passage of the wave, and nothing between), blocks at rest that are held
// in some direction, a block that is held obliquely to the sliding, and nodes
// at rest that move along the face only together.
// Argument: squeal.

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

  /** Ascending, 1/s, above 0 and below @p highest. */
  std::vector<std::complex<double>>
  motions(const ReducedContactModel &m,
          const SteadySliding       &about,
          const double               highest)
  {
    std::vector<std::complex<double>> result;
    for (const auto &lambda : linearize(m, about, mu, speed).lambda)
      if (lambda.imag() > 0. && lambda.imag() < highest)
        result.push_back(lambda);
    return result;
  }

  void
  check_equal(const std::vector<std::complex<double>> &found,
              const std::vector<std::complex<double>> &expected,
              const double                             tolerance,
              const std::string                       &text)
  {
    check(!found.empty() && found.size() == expected.size(),
          "motions in time " + text);
    Worst off;
    for (std::size_t i = 0; i < found.size() && i < expected.size(); ++i)
      off.add(std::abs(found[i] - expected[i]) / std::abs(expected[i]));
    check_below(off.largest(), tolerance, text);
  }

  void
  a_block_held_across()
  {
    const auto about = [](const double across) {
      const ReducedContactModel m = block(across);
      return motions(m, steady_sliding(m, mu, 1., 1e-12), 1e9);
    };
    check_equal(
      about(0.), about(1e-15), 1e-9, "those of a block that is nearly held");
  }

  /** The block, whose modes move it across the sliding as well. */
  ReducedContactModel
  block_in_modes(const double across)
  {
    ReducedContactModel m = block(across);
    m.participation(2, 0) = .02;
    m.participation(2, 1) = .05;
    return m;
  }

  void
  a_block_that_modes_alone_move_across()
  {
    const ReducedContactModel rigid  = block_in_modes(0.),
                              nearly = block_in_modes(1e-13);
    SteadySliding about              = steady_sliding(rigid, mu, 1., 1e-12);
    check_equal(motions(rigid, about, 1e9),
                motions(nearly, about, 1e9),
                1e-6,
                "sliding, those of a block with little flexibility");
    // By the dashpot mu p_0/V = 300 N s/m that the turning friction is.
    check(motions(rigid, about, 1e9).front().real() < -.01,
          "friction that turns damps the motion across the sliding");
    about.status[0] = ContactStatus::stick;
    check_equal(motions(rigid, about, 1e5),
                motions(nearly, about, 1e5),
                1e-4,
                "sticking, those of a block with little flexibility");
  }

  /** Two nodes at rest under 80 and 20 N that a body moves along the face
   * together, by @p force, N, on a spring of 1e5 N/m; along their normals each
   * has a spring of its own of 1e4 N/m. The spring along is in the mode or,
   * without @p in_mode, in the flexibility. */
  ReducedContactModel
  nodes_that_move_together(const double force, const bool in_mode)
  {
    ReducedContactModel m = empty_model(2, 1);
    m.omega_squared[0]    = 1e5;
    m.cut_off             = 1e4;
    m.speed_ratio.setZero();
    Eigen::VectorXd along = Eigen::VectorXd::Zero(6);
    along[1] = along[4] = -1.;
    if (in_mode)
      {
        m.participation.col(0) = along;
        m.load[0]              = force;
      }
    else
      {
        m.flexibility = 1e-5 * along * along.transpose();
        m.load_motion = force * 1e-5 * along;
      }
    for (const auto &[node, pressing] : {std::make_pair(0, 80.), {1, 20.}})
      {
        m.flexibility(3 * node, 3 * node) += 1e-4;
        m.load_motion[3 * node] += pressing * 1e-4;
        m.flexibility(3 * node + 2, 3 * node + 2) += 1e-5;
      }
    return m;
  }

  void
  friction_of_nodes_that_move_together()
  {
    for (const double force : {30., 45., 60.})
      for (const bool in_mode : {true, false})
        {
          const std::string text = "of nodes that move together under " +
                                   number(force) +
                                   (in_mode ? " N, in a mode" : " N");
          const SteadySliding state =
            press_at_rest(nodes_that_move_together(force, in_mode), .5, 10)
              .back();
          check_close(std::abs(state.resultant()[1]),
                      std::min(force, .5 * 100.),
                      1e-5,
                      "friction " + text);
          check_close(state.resultant()[0], 100., 1e-9, "pressure " + text);
          check(state.n_with(ContactStatus::stick) == (force < 50. ? 1 : 0),
                "the heavy node sticks below friction's limit only, " + text);
        }
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

  /** A block on a floor, held in x on both sides, under @p load; @p supports
   * are further ones. */
  std::string
  block_on_floor(const std::string &direction,
                 const std::string &supports,
                 const std::string &contact,
                 const std::string &load)
  {
    const std::string end = R"(
  subsection Support end
    set Body = block
    set Face = y_min
    set Kind = components
    set Components = y
  end)";
    return R"(set Output directory = block
set Overwrite = true
set Analysis = preload
subsection Scene
  set Bodies = floor, block
  set Supports = below, left, right)" +
           supports + R"(
  set Loads = press
  set Contacts = wall)" +
           (supports.find("end") == std::string::npos ? "" : end) + R"(
  subsection Body floor
    set Size = 0.08, 0.08, 0.01
    set Position = 0, 0, -0.01
    set Cells = 1, 1, 1
  end
  subsection Body block
    set Size = 0.01, 0.04, 0.01
    set Cells = 1, 4, 1
    set Young modulus = 1e9
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
    set Body = block
    set Face = x_min
    set Kind = components
    set Components = x
  end
  subsection Support right
    set Body = block
    set Face = x_max
    set Kind = components
    set Components = x
  end
  subsection Contact wall
    set Source body = block
    set Source face = z_min
    set Target body = floor
    set Target face = z_max
    set Formulation = mortar
    set Contact state = preload
    set Friction direction = given
    set Sliding direction = )" +
           direction + "\n" + contact + R"(
  end
  subsection Load press
    set Body = block
    set Face = z_max
    set Force = )" +
           load + R"(
  end
end
subsection Discretization
  set Degree = 1
  set Estimate error = false
end
subsection Transient
  set Cut-off = 20000
end
subsection Output
  set Plots = false
end
)";
  }

  /** Writes @p scene, solves it and returns its preload.csv. */
  Table
  preload(const std::string &program,
          const std::string &scene,
          const std::string &text)
  {
    write_text("block.prm", scene);
    const Outcome o = run_program({program, "block.prm"});
    check(o.code == 0, text + ": " + o.errors);
    return read_csv("block/preload.csv");
  }

  void
  blocks_at_rest(const std::string &program)
  {
    const std::string rest =
      "    set Friction coefficient = 0.5\n    set Sliding speed = 0";
    for (const std::string direction : {"1, 0, 0", "0, 1, 0", "1, 1, 0"})
      {
        const std::string text = "at rest, direction " + direction;
        const Table       found =
          preload(program,
                  block_on_floor(direction, ", above", rest, "0, 30, -100"),
                  text);
        const auto last = found.n_rows() - 1;
        check_close(found.real(last, "normal_n"), 100., 1e-6, text, 100.);
      }
  }

  void
  a_block_held_obliquely(const std::string &program)
  {
    const double coefficient = .03;
    const Table  found       = preload(program,
                                block_on_floor("1, 1, 0",
                                               ", above, end",
                                               "    set Friction coefficient = "
                                                      "0.03\n    set Sliding speed "
                                                      "= 0.02",
                                               "0, 0, -100"),
                                "sliding obliquely");
    const auto   last        = found.n_rows() - 1;
    check_close(
      found.real(last, "normal_n"), 100., 1e-6, "sliding obliquely", 100.);
    check_close(found.real(last, "tangential_n"),
                100. * coefficient,
                1e-6,
                "friction of oblique sliding",
                1.);
  }
} // namespace

int
main(int argc, char **argv)
{
  check(argc == 2, "argument: squeal");
  a_block_held_across();
  a_block_that_modes_alone_move_across();
  friction_of_nodes_that_move_together();
  blocks_at_rest(argv[1]);
  a_block_held_obliquely(argv[1]);
  a_bar_on_a_wall(argv[1]);
}
