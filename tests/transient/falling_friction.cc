// SPDX-License-Identifier: LGPL-2.1-or-later

// Friction that falls with the slip rate: the stick-slip oscillator on a belt,
// the growth rate of an oscillator and of a brake against their eigenvalues, a
// constant law and restarts bit by bit.

#include "transient/hand_made.h"
#include "transient/pressed_brake.h"

#include <squeal/transient/growth.h>
#include <squeal/transient/implicit_transient.h>
#include <squeal/transient/reduced_transient.h>

#include <deal.II/base/mpi.h>

#include <cmath>
#include <cstdio>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  using Complex = std::complex<double>;

  ContactParameters
  falling(const double kinetic, const double at_rest, const double decay_speed)
  {
    ContactParameters c;
    c.friction_law                = ContactParameters::FrictionLaw::exponential;
    c.friction_coefficient        = kinetic;
    c.static_friction_coefficient = at_rest;
    c.decay_speed                 = decay_speed;
    return c;
  }

  TransientDrive
  drive_by(const ContactParameters &contact, const double belt_speed)
  {
    TransientDrive d = steady_drive(0., belt_speed);
    d.law            = std::make_shared<const FrictionLaw>(contact);
    return d;
  }

  // The oscillator m = k = N = 1 on a belt.
  constexpr double belt = .1, kinetic = .3, at_rest = .5;

  /** The mass of 1 kg on a spring of 1 N/m along y, 0.1 kg of it a foot on the
   * belt behind a stiff spring, 0.0225 kg/dt^2, whose motion is damped
   * critically: where the force of a foot jumps, one without damping would ring
   * for ever. Modes: along z and x, the two along y. */
  ReducedContactModel
  foot_on_belt(const double dt)
  {
    const double        foot = .1, stiffness = .0225 / (dt * dt);
    ReducedContactModel m = empty_model(1, 4);
    m.flexibility         = dt * dt / foot * Eigen::MatrixXd::Identity(3, 3);
    Eigen::Matrix2d K, M = Eigen::Vector2d(1. - foot, foot).asDiagonal();
    K << 1. + stiffness, -stiffness, -stiffness, stiffness;
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::Matrix2d> modes(K, M);
    m.omega_squared << 0., 0., modes.eigenvalues();
    m.damping[3]          = 2. * std::sqrt(m.omega_squared[3]);
    m.participation(0, 0) = m.participation(2, 1) = -1.;
    m.participation.block(1, 2, 1, 2) = -modes.eigenvectors().row(1);
    m.load[0]                         = -1.;
    return m;
  }

  /** A mass of 1 kg on a spring of 1 N/m along y, pressed on the belt. */
  ReducedContactModel
  oscillator(const double dt)
  {
    ReducedContactModel m = rigid_block(1., dt);
    m.omega_squared[1]    = 1.;
    m.load[0]             = -1.;
    return m;
  }

  /** The same as a scene of a lumped body, with springs along z and x too. */
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
      separated.contacts[0]));
    full.relative_motion = std::make_shared<const Functionals>(
      relative_motion(separated.contacts[0]));
    // The normal row is minus the motion along z.
    full.load = full.relative_motion->apply_transposed(
      Eigen::MatrixXd(Eigen::Vector3d(1., 0., 0.)));
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

  /** Runs over some periods, starting with the belt. */
  StickSlip
  stick_slip(TransientIntegrator   &run,
             const Eigen::VectorXd &coordinates,
             const Eigen::VectorXd &velocity)
  {
    run.start(coordinates, velocity, Eigen::Vector3d(1., 0., 0.));
    constexpr unsigned int n_periods = 3;
    double                 first = -1., last = -1., stuck = 0., caught = -1.;
    double                 lowest = 1e300, highest = -1e300;
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
            lowest  = std::min(lowest, y);
            highest = std::max(highest, y);
          }
        before = now;
      }
    return {
      (last - first) / n_periods, stuck / n_periods, .5 * (highest - lowest)};
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
        for (const double dt : {1e-2, 1e-3, 1e-4})
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
                Block                  y(full.load.size(), 1);
                y = -full.relative_motion->apply_transposed(
                  Eigen::MatrixXd(Eigen::Vector3d(0., belt, 0.)));
                s = stick_slip(run,
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
    double             found = 0.;
    for (unsigned int i = 0; i < pairs.size(); ++i)
      found = std::max(found, pairs.sigma(i));
    check_below(std::abs(found + .5 * N * slope),
                1e-12,
                "eigenvalue analysis: -N mu'(V)/(2m)");
  }



  /** The brake with the coefficient .5 at its speed, or a law that falls there
   * by @p slope, s/m. */
  SceneParameters
  falling_brake(const double slope)
  {
    SceneParameters scene         = pressed_brake(.5);
    scene.bodies[1].young_modulus = 1.6e10;
    auto &pair                    = scene.contacts[0];
    if (slope == 0.)
      return scene;
    const double excess       = -slope * speed;
    pair.friction_law         = ContactParameters::FrictionLaw::exponential;
    pair.decay_speed          = speed;
    pair.friction_coefficient = .5 - excess;
    pair.static_friction_coefficient = .5 - excess + excess * std::exp(1.);
    return scene;
  }

  /** Of the fastest pair near 5 kHz: of the whole model, of the linearised
   * motion, and in time for each step; 1/s. */
  struct Growth
  {
    double              whole, linear;
    std::vector<double> in_time;
  };

  Growth
  brake_growth(const double slope, const std::vector<double> &steps)
  {
    const Reduced       r(falling_brake(slope), 24e3);
    const auto         &pair = r.scene.contacts[0];
    const NodalFriction f =
      FrictionLaw(pair).in_sliding(r.model.speed_ratio, speed);
    check_below(std::abs(f.slope[0] - slope), 1e-12, "slope of the law");
    const SteadySliding    s      = steady_sliding(r.model, f.coefficient);
    const LinearizedMotion linear = linearize(r.model, s, f, speed);
    const Eigen::VectorXcd all    = whole_model(r, s);
    Eigen::Index           k, whole;
    all.real().maxCoeff(&whole);
    (linear.lambda.array() - all[whole]).abs().minCoeff(&k);
    Growth g{all[whole].real(), linear.lambda[k].real(), {}};
    for (const double dt : steps)
      {
        ReducedTransient run(
          r.model, dt, drive_by(pair, speed), load / r.model.n_nodes());
        run.start(s.coordinates,
                  Eigen::VectorXd::Constant(r.model.n_modes(), 1e-9),
                  s.forces);
        std::vector<double>  times;
        std::vector<Complex> amplitudes;
        bool                 same_status = true;
        while (run.time() < 6. / g.linear)
          {
            run.advance();
            same_status = same_status && run.status() == s.status;
            if (run.time() >= times.size() * 2e-5)
              {
                times.push_back(run.time());
                amplitudes.push_back(linear.amplitudes(
                  s, run.coordinates(), run.velocities(), run.forces())[k]);
              }
          }
        check(same_status, "the contact state stays");
        check_below(run.ledger().imbalance(), 1e-3, "the ledger closes");
        const auto window = fit_window(amplitudes, 0, amplitudes.size(), false);
        g.in_time.push_back(
          fit_growth(times, amplitudes, window.first, window.second).rate);
        std::printf("brake, slope %g, dt %g: %.4f 1/s, linearised %.4f, whole "
                    "model %.4f\n",
                    slope,
                    dt,
                    g.in_time.back(),
                    g.linear,
                    g.whole);
      }
    return g;
  }

  /** What the slope adds to the growth of a brake. */
  void
  growing_brake()
  {
    const std::vector<double> steps = {4e-6, 2e-6};
    const Growth              flat  = brake_growth(0., steps),
                 falling            = brake_growth(-.02, steps);
    const double added              = falling.linear - flat.linear;
    check(added > 3., "a falling law adds to the growth rate");
    std::printf("added: linearised %.4f, whole %.4f, in time %.4f, %.4f 1/s\n",
                added,
                falling.whole - flat.whole,
                falling.in_time[0] - flat.in_time[0],
                falling.in_time[1] - flat.in_time[1]);
    check_below(std::abs((falling.whole - flat.whole) / added - 1.),
                .05,
                "by as much in the whole model");
    for (unsigned int i = 0; i < steps.size(); ++i)
      {
        check_below(
          std::abs((falling.in_time[i] - flat.in_time[i]) / added - 1.),
          .05,
          "by as much in time");
        check_below(std::abs(falling.in_time[i] / falling.linear - 1.),
                    .02,
                    "growth rate in time");
      }
  }



  bool
  same_bits(const TransientIntegrator &a, const TransientIntegrator &b)
  {
    return a.forces() == b.forces() && a.motion() == b.motion() &&
           a.coordinates() == b.coordinates() && a.status() == b.status();
  }

  /** A constant law by either way, and a restart in the middle. */
  void
  bits()
  {
    const Reduced     r(falling_brake(-.02), 24e3);
    ContactParameters constant;
    constant.friction_coefficient = .5;
    const SteadySliding s         = steady_sliding(r.model, .5);
    const auto          start     = [&](TransientIntegrator &run) {
      // Against the load, so that nodes stick, slip and open.
      Eigen::VectorXd v = -r.model.load;
      v *= 2e-2 / v.cwiseAbs().maxCoeff();
      run.start(s.coordinates, v, s.forces);
    };
    const double     dt = 2e-6, force = load / r.model.n_nodes();
    ReducedTransient by_number(r.model, dt, steady_drive(.5, speed), force),
      by_law(r.model, dt, drive_by(constant, speed), force);
    start(by_number);
    start(by_law);
    for (unsigned int i = 0; i < 800; ++i)
      {
        by_number.advance();
        by_law.advance();
      }
    check(same_bits(by_number, by_law), "a constant law: the same bits");
    check(by_number.memory() == by_law.memory(), "and the same memory");

    const TransientDrive falls = drive_by(r.scene.contacts[0], speed);
    for (const bool is_reduced : {true, false})
      {
        const auto make = [&]() -> std::unique_ptr<TransientIntegrator> {
          if (is_reduced)
            return std::make_unique<ReducedTransient>(
              r.model, dt, falls, force);
          return std::make_unique<ImplicitTransient>(
            full_model(r), dt, falls, force);
        };
        const std::string name  = is_reduced ? "reduced" : "implicit";
        const auto        whole = make(), second = make();
        start(*whole);
        start(*second);
        unsigned int n_stick = 0, n_open = 0;
        const auto   advance = [&](TransientIntegrator &run) {
          for (unsigned int i = 0; i < (is_reduced ? 400 : 60); ++i)
            {
              run.advance();
              for (const auto status : run.status())
                {
                  n_stick += status == ContactStatus::stick;
                  n_open += status == ContactStatus::open;
                }
            }
        };
        advance(*whole);
        second->restore(whole->memory());
        advance(*whole);
        advance(*second);
        check(n_open > 0, name + ": nodes open");
        std::printf(
          "%s: %u sticking, %u open\n", name.c_str(), n_stick, n_open);
        check(same_bits(*whole, *second),
              name + ": the same bits after a restart with a falling law");
      }
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
  else if (which == "brake")
    growing_brake();
  else if (which == "bits")
    bits();
  else
    check(false, "an argument: belt, oscillator, brake or bits");
}
