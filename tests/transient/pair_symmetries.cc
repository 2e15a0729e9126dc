// SPDX-License-Identifier: LGPL-2.1-or-later

// Several pairs in any direction: steady sliding and the motion in time of a
// scene are the same when it is turned about any axis, mirrored with its
// sliding, pressed on from below instead of from above, when pairs are
// renumbered, and when lengths are in other units. Coarse scenes of a plate and
// one or two pads on springs.

#include "contact/placed_scene.h"

#include <squeal/analyses/transient/transient_run.h>
#include <squeal/base/timers.h>

#include <deal.II/base/mpi.h>

#include <functional>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  /** Statics are exact whatever the modes; with many of them what the modes are
   * off shows. */
  constexpr double cut_off = 60e3, statics = 1e3; // Hz

  /** A scene with its placing. */
  struct Placed
  {
    Options         options;
    Placing         placing;
    SceneParameters scene;

    explicit Placed(const Options &o, const Placing &p = {})
      : options(o)
      , placing(p)
      , scene(scene_of(o, p))
    {
      scene.damping.stiffness_damping = 1e-7;
    }
  };

  Parameters
  parameters_of(const Placed                         &placed,
                const TransientParameters::Integrator integrator =
                  TransientParameters::Integrator::reduced)
  {
    Parameters p;
    p.scene                   = placed.scene;
    p.discretization.degree   = 1;
    p.discretization.mass     = DiscretizationParameters::Mass::lumped;
    p.eigen.highest_frequency = 20e3;
    p.transient.cut_off       = cut_off;
    p.transient.integrator    = integrator;
    // Below the largest stable one of the massless contact.
    p.transient.time_step =
      integrator == TransientParameters::Integrator::reduced ? 1e-7 : 4e-7;
    p.transient.sample_interval = 1e-5;
    p.transient.end_time        = 1.2e-4;
    p.transient.tolerance       = 1e-11;
    p.transient.disturbance     = 0.;
    p.transient.hammer.body     = p.scene.loads[0].body;
    p.transient.hammer.face     = p.scene.loads[0].face;
    p.transient.hammer.time     = 0.;
    p.transient.hammer.duration = 1e-4;
    const double z              = p.scene.loads[0].face == "z_max" ? 1. : -1.;
    // Across and along the sliding, and away from the face.
    p.transient.hammer.force =
      placed.placing.direction({{.02, .01 * placed.options.sense, .02 * z}});
    return p;
  }

  /** A pad's forces of one node, N, by its place. */
  struct NodeForce
  {
    dealii::Point<3> place; /**< in the axes before the scene was placed */
    Eigen::Vector3d  force; /**< normal, along, across */
  };

  using PairForces = std::map<std::string, std::vector<NodeForce>>;

  PairForces
  forces_of(const Placed          &placed,
            const ContactNodes    &nodes,
            const Eigen::VectorXd &forces)
  {
    PairForces result;
    for (const ContactPair &pair : nodes.pairs())
      for (unsigned int k = 0; k < pair.n_nodes(); ++k)
        {
          const auto           &x    = pair.geometry.points[k];
          const Eigen::Vector3d back = placed.placing.R.transpose() *
                                       Eigen::Vector3d(x[0], x[1], x[2]) /
                                       placed.placing.factor;
          result[pair.name()].push_back(
            {dealii::Point<3>(back[0], back[1], back[2]),
             pair.part(forces).segment<3>(3 * k)});
        }
    return result;
  }

  /** Largest difference over the mean nodal normal force. @p move takes a place
   * of @p a to that of @p b; @p mirrors: it is a reflection, which turns the
   * direction across the sliding. */
  double
  difference(
    const PairForces                                                &a,
    const PairForces                                                &b,
    const std::function<dealii::Point<3>(const dealii::Point<3> &)> &move = {},
    const bool                         mirrors = false,
    std::map<std::string, std::string> names   = {})
  {
    Worst        worst;
    double       mean = 0.;
    unsigned int n    = 0;
    for (const auto &[name, nodes] : a)
      {
        const auto  other = names.count(name) ? names.at(name) : name;
        const auto &there = b.at(other);
        check(there.size() == nodes.size(), "as many nodes of " + name);
        for (const NodeForce &node : nodes)
          {
            const auto       x     = move ? move(node.place) : node.place;
            const NodeForce *match = nullptr;
            for (const NodeForce &candidate : there)
              if (candidate.place.distance(x) < 1e-7)
                match = &candidate;
            check(match != nullptr, "a node of " + name + " has its image");
            Eigen::Vector3d expected = node.force;
            if (mirrors)
              expected[2] = -expected[2];
            worst.add((expected - match->force).norm());
            mean += node.force[0];
            ++n;
          }
      }
    return worst.largest() / (mean / n);
  }

  /** What is compared: a solution of a placed scene. */
  using Solution = std::function<PairForces(const Placed &)>;

  PairForces
  steady_forces(const Placed &placed)
  {
    const Parameters     p = parameters_of(placed);
    const Discretization d(
      p.scene, p.discretization, p.discretization.degree, MPI_COMM_SELF);
    Timers            timers;
    const auto        bodies = assemble_bodies(d);
    const SteadyModel about =
      PressedModel(p, d, bodies, statics, timers).steady(1e-12, timers);
    const SteadySliding &s = about.sliding;
    check(s.n_closed() > s.status.size() / 2, "most nodes touch");
    return forces_of(placed, about.pressed.nodes(), s.forces);
  }

  PairForces
  forces_in_time(const Placed                         &placed,
                 const TransientParameters::Integrator integrator)
  {
    const Parameters     p = parameters_of(placed, integrator);
    const Discretization d(
      p.scene, p.discretization, p.discretization.degree, MPI_COMM_SELF);
    Timers            timers;
    const auto        bodies = assemble_bodies(d);
    const SteadyModel about =
      PressedModel(p, d, bodies, cut_off, timers).steady(1e-12, timers);
    const PressedModel  &pressed = about.pressed;
    const SteadySliding &s       = about.sliding;
    const auto           motion  = make_integrator(pressed, s, p);
    motion->start(
      s.coordinates, Eigen::VectorXd::Zero(s.coordinates.size()), s.forces);
    Worst      moved;
    const auto n = std::lround(p.transient.end_time / p.transient.time_step);
    for (long i = 0; i < n; ++i)
      {
        motion->advance();
        moved.add((motion->forces() - s.forces).norm() / s.forces.norm());
        check(motion->status() == s.status, "no change of status so far");
      }
    check(moved.largest() > 1e-3,
          "the blow moves the forces by " + number(moved.largest()));
    check_below(motion->ledger().imbalance(), 1e-3, "the ledger closes");
    return forces_of(placed, pressed.nodes(), motion->forces());
  }



  dealii::Point<3>
  mirrored_in_y(const dealii::Point<3> &x)
  {
    return {x[0], -x[1], x[2]};
  }

  /** The middle of the plate is at z = -5 mm. */
  dealii::Point<3>
  mirrored_in_z(const dealii::Point<3> &x)
  {
    return {x[0], x[1], -.01 - x[2]};
  }

  void
  one_pad(Options            o,
          const std::string &name,
          const Solution    &solve,
          const double       tolerance)
  {
    const PairForces straight = solve(Placed(o));
    const auto       same     = [&](const double d, const std::string &claim) {
      check_below(d, tolerance, name + ", " + claim);
    };
    same(difference(straight, solve(Placed(o, turned(.7, {1., 2., 3.})))),
         "turned about an oblique axis");
    same(
      difference(straight, solve(Placed(o, turned(M_PI / 2., {1., 0., 0.})))),
      "the target looks along -y");
    same(difference(straight, solve(Placed(o, turned(M_PI, {1., 0., 0.})))),
         "turned upside down");
    Options mirrored = o;
    mirrored.y       = -o.y;
    mirrored.sense   = -o.sense;
    same(difference(straight, solve(Placed(mirrored)), mirrored_in_y, true),
         "mirrored in y");
    Options below = o;
    below.above   = false;
    below.below   = true;
    same(difference(straight,
                    solve(Placed(below)),
                    mirrored_in_z,
                    true,
                    {{"upper on plate", "lower on plate"}}),
         "pad below");
    Options backwards = o;
    backwards.sense   = -1.;
    backwards.mu      = -o.mu;
    // The hammer of the mirrored sense strikes the other way: steady only.
    if (tolerance < 1e-8)
      same(difference(straight, solve(Placed(backwards))),
           "-mu against the other direction");
  }

  void
  two_pads(Options            o,
           const std::string &name,
           const Solution    &solve,
           const double       tolerance)
  {
    o.below                   = true;
    const PairForces straight = solve(Placed(o));
    const auto       same     = [&](const double d, const std::string &claim) {
      check_below(d, tolerance, name + ", two pads, " + claim);
    };
    Options renumbered     = o;
    renumbered.is_reversed = true;
    same(difference(straight, solve(Placed(renumbered))), "renumbered");
    same(difference(straight, solve(Placed(o, turned(2., {-1., .5, 1.})))),
         "turned");
    Placing millimetres;
    millimetres.factor = 1e3;
    same(difference(straight, solve(Placed(o, millimetres))),
         "lengths in millimetres");
  }

  void
  all_of(const Options     &o,
         const std::string &name,
         const Solution    &solve,
         const double       tolerance)
  {
    one_pad(o, name, solve, tolerance);
    two_pads(o, name, solve, tolerance);
  }

  Options
  pressed_pads(const Formulation formulation)
  {
    Options o;
    o.formulation = formulation;
    o.direction   = Direction::slip;
    o.mu          = .4;
    o.load        = 10.;
    return o;
  }

  void
  steady()
  {
    Options quadrature = pressed_pads(Formulation::springs);
    quadrature.layout  = Layout::quadrature;
    for (const auto &[options, name] :
         std::vector<std::pair<Options, std::string>>{
           {pressed_pads(Formulation::mortar), "mortar"},
           {pressed_pads(Formulation::node_to_surface), "node to surface"},
           {pressed_pads(Formulation::springs), "springs on a grid"},
           {quadrature, "springs at quadrature points"}})
      all_of(options, name, steady_forces, 1e-9);
  }

  void
  in_time(const std::string &name)
  {
    using Integrator      = TransientParameters::Integrator;
    const auto integrator = name == "implicit"   ? Integrator::implicit
                            : name == "explicit" ? Integrator::explicit_
                                                 : Integrator::reduced;
    all_of(
      pressed_pads(Formulation::mortar),
      name,
      [&](const Placed &placed) { return forces_in_time(placed, integrator); },
      1e-6);
  }
} // namespace



int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const std::string                        which = argc > 1 ? argv[1] : "";
  if (which == "steady")
    steady();
  else if (which == "reduced" || which == "implicit" || which == "explicit")
    in_time(which);
  else
    check(false, "an argument: steady, reduced, implicit or explicit");
}
