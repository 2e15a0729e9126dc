// SPDX-License-Identifier: LGPL-2.1-or-later

// Friction that depends on the slip rate: the stick-slip oscillator on a belt,
// the growth rate of an oscillator against its eigenvalue, also where slip
// along deforms the contact across the sliding, the shortest step that the lag
// of falling friction holds a node in.

#include "transient/hand_made.h"
#include "transient/pressed_brake.h"
#include "worst.h"

#include <squeal/transient/implicit_transient.h>
#include <squeal/transient/lag_limit.h>
#include <squeal/transient/reduced_transient.h>
#include <squeal/transient/time_step_error.h>

#include <deal.II/base/mpi.h>

#include <cmath>
#include <cstdio>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  using Complex = std::complex<double>;

  // The oscillator m = k = N = 1 on a belt.
  constexpr double belt = .1, kinetic = .3, at_rest = .5;

  /** The oscillator as a scene of a lumped body, with springs along z and x
   * too. */
  SceneParameters
  oscillator_scene()
  {
    SceneParameters s;
    BodyParameters  mass;
    mass.name  = "mass";
    mass.shape = BodyParameters::Shape::rigid;
    mass.mass  = 1.;
    s.bodies   = {mass};
    SupportParameters guide;
    guide.name       = "guide";
    guide.body       = "mass";
    guide.kind       = SupportParameters::Kind::components;
    guide.components = {"rx", "ry", "rz"};
    s.supports       = {guide};
    for (unsigned int c = 0; c < 3; ++c)
      {
        SpringParameters spring;
        spring.name         = "spring";
        spring.body         = "mass";
        spring.stiffness    = c == 1 ? 1. : 2.;
        spring.direction    = {{0., 0., 0.}};
        spring.direction[c] = 1.;
        s.springs.push_back(spring);
      }
    ContactParameters contact = falling(kinetic, at_rest, 0.);
    contact.name              = "belt";
    contact.source_body       = "mass";
    contact.target_body       = "ground";
    contact.grid              = {{1, 1}};
    contact.normal_stiffness  = 3.;
    s.contacts                = {contact};
    return s;
  }

  /** All unknowns of the scene, pressed by 1 N. */
  FullContactModel
  full_oscillator()
  {
    const SceneParameters  s = oscillator_scene();
    const Discretization   d(s, Model::parameters(0), 1, MPI_COMM_SELF);
    const LinearizedSystem separated = separated_system(d, assemble_bodies(d));
    const auto pencil = std::make_shared<const Pencil>(separated.system, s);
    FullContactModel full;
    full.pencil = pencil;
    full.basis  = std::make_shared<const ReductionBasis>(reduction_basis(
      *pencil,
      undamped_modes(*pencil,
                     ShiftedInverse(*pencil, std::pow(2. * M_PI * 1., 2))),
      relative_motion(separated.contacts)));
    full.relative_motion =
      std::make_shared<const Functionals>(relative_motion(separated.contacts));
    // The normal row is minus the motion along z.
    full.load =
      full.relative_motion->apply_transposed(Block(Block::Identity(3, 1)));
    full.observers     = Block::Zero(full.load.size(), 1);
    full.initial_gap   = Eigen::VectorXd::Zero(1);
    full.speed_ratio   = Eigen::VectorXd::Ones(1);
    full.motion_offset = Eigen::VectorXd::Zero(3);
    return full;
  }

  struct StickSlip
  {
    double period = 0., stick = 0., amplitude = 0.;
  };

  /** Runs until the mass has slipped off twice, starting with the belt: each
   * period begins where it slips off and is like the one before. */
  StickSlip
  stick_slip(TransientIntegrator   &run,
             const Eigen::VectorXd &coordinates,
             const Eigen::VectorXd &velocity)
  {
    run.start(coordinates, velocity, Eigen::Vector3d(1., 0., 0.));
    constexpr unsigned int n_periods = 1;
    double                 first = -1., last = -1., stuck = 0., caught = -1.;
    Worst                  lowest;
    Worst                  highest;
    unsigned int           n      = 0;
    ContactStatus          before = ContactStatus::stick;
    while (n <= n_periods)
      {
        run.advance();
        const ContactStatus now = run.status()[0];
        const double        y   = -run.motion()[1];
        if (now != before && now == ContactStatus::slip)
          {
            if (n == 0)
              first = run.time();
            else if (caught > 0.)
              stuck += run.time() - caught;
            last = run.time();
            ++n;
          }
        else if (now != before)
          caught = run.time();
        if (n > 0)
          {
            lowest.add(y);
            highest.add(y);
          }
        before = now;
      }
    return {(last - first) / n_periods,
            stuck / n_periods,
            .5 * (highest.largest() - lowest.smallest())};
  }

  /** T = 2/w (pi - atan(w D/V)) + 2 D/V with D = (mu_s - mu_k) N/k, sticking
   * for 2 D/V, amplitude sqrt(D^2 + V^2/w^2). */
  void
  belt_oscillator()
  {
    const double D = at_rest - kinetic, stick = 2. * D / belt,
                 period    = 2. * (M_PI - std::atan(D / belt)) + stick,
                 amplitude = std::hypot(D, belt);
    check_below(std::abs(period - 8.06889), 5e-6, "the published period");
    for (const std::string name : {"reduced", "implicit"})
      {
        double before = 0.;
        for (const double dt : {2e-2, 2e-3, 2e-4})
          {
            StickSlip  s;
            const auto drive = drive_by(falling(kinetic, at_rest, 0.), belt);
            if (name == "reduced")
              {
                const ReducedContactModel m = foot_on_belt(dt);
                ReducedTransient          run(m, dt, drive, 1.);
                // The slower mode moves the whole mass alike.
                s = stick_slip(
                  run,
                  Eigen::Vector4d(-m.flexibility(0, 0), 0., 0., 0.),
                  Eigen::Vector4d(0., 0., -belt / m.participation(1, 2), 0.));
              }
            else
              {
                const FullContactModel full = full_oscillator();
                ImplicitTransient      run(full, dt, drive, 1.);
                Block                  along = Block::Zero(3, 1);
                along(1, 0)                  = belt;
                const Block y = -full.relative_motion->apply_transposed(along);
                s             = stick_slip(run,
                               Eigen::VectorXd::Zero(3),
                               full.basis->mass_shapes.transpose() * y);
              }
            const double error = std::max(std::abs(s.period / period - 1.),
                                          std::abs(s.stick / stick - 1.));
            std::printf("%s, dt %g: period %.6f (%.6f), sticks %.6f (%.6f), "
                        "amplitude %.6f (%.6f)\n",
                        name.c_str(),
                        dt,
                        s.period,
                        period,
                        s.stick,
                        stick,
                        s.amplitude,
                        amplitude);
            check_below(std::abs(s.amplitude / amplitude - 1.),
                        2. * dt,
                        name + ": amplitude");
            if (before > 0.)
              check_below(error, before / 5., name + ": first order");
            before = error;
          }
        check_below(before, 1e-4, name + ": period and stick duration");
      }
  }



  /** sigma = -(c + N mu'(V))/(2 m), omega^2 + sigma^2 = k/m. */
  void
  growing_oscillator()
  {
    ContactParameters contact = falling(.3, .5, .2);
    const FrictionLaw law(contact);
    const double      N = .1, c = .01, slope = law.slope(belt);
    const double      sigma = -.5 * (c + N * slope),
                 omega      = std::sqrt(1. - sigma * sigma);
    double before = 0., before_2 = 0.;
    for (const double dt : {.05, .025, .0125, .00625})
      {
        ReducedContactModel m    = oscillator(dt);
        m.load[0]                = -N;
        m.damping[1]             = c;
        const NodalFriction    f = law.in_sliding(m.speed_ratio, belt);
        const SteadySliding    s = steady_sliding(m, f.coefficient, 1., 1e-13);
        const LinearizedMotion l = linearize(m, s, f, belt);
        Eigen::Index           k;
        (l.lambda.array() - Complex(sigma, omega)).abs().minCoeff(&k);
        if (before == 0.)
          check_below(std::abs(s.forces[1] / (N * law.coefficient(belt)) - 1.),
                      1e-10,
                      "steady sliding takes mu(V)");
        // The contact's own compliance of dt^2/m stays in the model.
        check_below(std::abs(l.lambda[k] - Complex(sigma, omega)),
                    1e-3 * dt * dt + 1e-12,
                    "linearised: sigma = -(c + N mu'(V))/(2m)");
        ReducedTransient run(m, dt, drive_by(contact, belt), N, 1e-12);
        run.start(s.coordinates, Eigen::Vector3d(0., 1e-6, 0.), s.forces);
        const auto amplitude = [&]() {
          return std::abs(l.amplitudes(
            s, run.coordinates(), run.velocities(), run.forces())[k]);
        };
        double start = 0., begin = 0.;
        while (run.time() < 30. * M_PI)
          {
            run.advance();
            if (start == 0. && run.time() > 2. * M_PI)
              {
                start = amplitude();
                begin = run.time();
              }
          }
        const double rate =
                       std::log(amplitude() / start) / (run.time() - begin),
                     error = std::abs(rate / sigma - 1.);
        std::printf("oscillator, dt %g: rate %.8f, sigma %.8f, error %.2e\n",
                    dt,
                    rate,
                    sigma,
                    error);
        const double stated = reduced_step_error(m, l, dt)[k].real();
        check_below(std::abs(rate - l.lambda[k].real() - stated) / error /
                      sigma,
                    .2,
                    "what the lag of friction adds is stated");
        if (before > 0.)
          check_below(error, .6 * before, "falls with the step");
        before_2 = before;
        before   = error;
      }
    // First order: the limit of the last two steps.
    check_below(std::abs(2. * before - before_2), .2 * before, "first order");
    check_below(before, 2e-3, "growth rate");

    // The same oscillator in the eigenvalue analysis.
    SceneParameters scene = oscillator_scene();
    auto           &pair  = scene.contacts[0];
    pair.decay_speed      = .2;
    pair.sliding_speed    = belt;
    pair.normal_force     = N;
    Model              model(scene, 1, 1.);
    const ComplexPairs pairs = model.solve(band(0., .8));
    Worst              found;
    for (unsigned int i = 0; i < pairs.size(); ++i)
      found.add(pairs.sigma(i));
    check_below(std::abs(found.largest() + .5 * N * slope),
                1e-12,
                "eigenvalue analysis: -N mu'(V)/(2m)");
  }



  /** A flexible node whose forces along the sliding move it across: the mass
   * has what its dashpots give, p mu' along and mu p / |V| across, and no
   * motion of the flexibility alone grows. */
  void
  coupled_flexibility()
  {
    constexpr double mu = .3, slope = -6., p = .1, c = .8, share = .9;
    for (const double flexibility : {1e-4, 1e-5, 1e-6})
      {
        ReducedContactModel m = oscillator(1.);
        m.flexibility         = flexibility * Eigen::Matrix3d::Identity();
        m.flexibility(1, 2) = m.flexibility(2, 1) = share * flexibility;
        m.omega_squared[2]                        = 4.;
        m.damping[1]                              = c;
        m.load[0]                                 = -p;
        NodalFriction friction = NodalFriction::uniform(mu, 1);
        friction.slope[0]      = slope;
        const SteadySliding s =
          steady_sliding(m, friction.coefficient, 1., 1e-13);
        const LinearizedMotion l = linearize(m, s, friction, belt);
        const auto pair = [](const double damping, const double stiffness) {
          return Complex(-.5 * damping,
                         std::sqrt(stiffness - .25 * damping * damping));
        };
        for (const Complex expected :
             {pair(c + slope * p, 1.), pair(mu * p / belt, 4.)})
          check_below(smallest((l.lambda.array() - expected).abs()),
                      10. * flexibility,
                      "a motion of the mass on " + std::to_string(flexibility) +
                        " m/N");
        Worst growth;
        for (const Complex lambda : l.lambda)
          growth.add(lambda.real());
        check_within(growth, 1e-8, "nothing grows");
      }
  }



  /** Steps in which the node of @p m sticks, of the second half of a motion
   * that begins near steady sliding. */
  unsigned int
  steps_in_stick(const ReducedContactModel &m,
                 const ContactParameters   &law,
                 const SteadySliding       &steady,
                 const double               dt)
  {
    constexpr unsigned int n_steps = 4000;
    ReducedTransient       run(m, dt, drive_by(law, belt), 1.);
    run.start(
      steady.coordinates, Eigen::Vector3d(0., 1e-3 * belt, 0.), steady.forces);
    unsigned int n = 0;
    for (unsigned int i = 0; i < n_steps; ++i)
      {
        run.advance();
        if (2 * i >= n_steps && run.status()[0] == ContactStatus::stick)
          ++n;
      }
    return n;
  }

  /** The lag holds a node in longer steps than the flexibility times the fall
   * of its friction, and no shorter ones: an oscillator that is damped enough
   * to come to rest sticks and slips in those. */
  void
  shortest_step()
  {
    constexpr double        flexibility = 1e-2;
    const ContactParameters law         = falling(kinetic, kinetic + .1, .2);
    const double            fall        = -FrictionLaw(law).slope(belt);
    check(FrictionLaw(law).steepest_fall(belt) == -FrictionLaw(law).slope(0.),
          "steepest at rest");
    ReducedContactModel m = oscillator(1e-3);
    m.flexibility         = flexibility * Eigen::MatrixXd::Identity(3, 3);
    m.damping[1]          = 1.;
    const SteadySliding steady =
      steady_sliding(m, FrictionLaw(law).coefficient(belt));
    const Eigen::VectorXd fall_of_node = Eigen::VectorXd::Constant(1, fall);
    const LagLimit        limit = lag_limit(m, steady, fall_of_node, 1e-3);
    check_close(limit.shortest,
                flexibility * fall,
                1e-9,
                "flexibility times normal force times fall");
    check(limit.n_above == 1, "the node needs longer steps than 1 ms");
    check(lag_limit(m, steady, fall_of_node, 1e-2).n_above == 0,
          "and no longer ones than 10 ms");
    const unsigned int shorter =
                         steps_in_stick(m, law, steady, .7 * limit.shortest),
                       longer =
                         steps_in_stick(m, law, steady, 1.4 * limit.shortest);
    std::printf(
      "steps in stick: %u below the limit, %u above\n", shorter, longer);
    check(shorter > 100, "the node jumps to and fro in shorter steps");
    check(longer == 0, "the node slides on in longer ones");

    // Nodes that give way together need the step of the stiffest sum.
    ReducedContactModel two = empty_model(2, 0);
    two.flexibility(1, 1) = two.flexibility(4, 4) = flexibility;
    two.flexibility(1, 4) = two.flexibility(4, 1) = .5 * flexibility;
    SteadySliding of_two;
    of_two.forces = Eigen::VectorXd::Ones(6);
    of_two.status.assign(2, ContactStatus::slip);
    check_close(
      lag_limit(two, of_two, Eigen::VectorXd::Constant(2, fall), 1.).shortest,
      1.5 * flexibility * fall,
      1e-9,
      "two nodes: the largest eigenvalue");
  }
} // namespace

int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const std::string                        which = argc > 1 ? argv[1] : "";
  if (which == "belt")
    belt_oscillator();
  else if (which == "oscillator")
    growing_oscillator();
  else if (which == "coupled_flexibility")
    coupled_flexibility();
  else if (which == "shortest_step")
    shortest_step();
  else
    check(false,
          "an argument: belt, oscillator, coupled_flexibility or "
          "shortest_step");
}
