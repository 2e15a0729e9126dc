// SPDX-License-Identifier: LGPL-2.1-or-later

// Blocks on a rigid floor by all three integrators: a bar thrown at a wall
// (Doyen, Ern, Piperno 2011), a block pressed on a floor that is set to speed
// at once (shear-impedance bound) and its steady sliding.

#include "scenes.h"

#include <squeal/discretization/load_vector.h>
#include <squeal/transient/explicit_transient.h>
#include <squeal/transient/implicit_transient.h>
#include <squeal/transient/reduced_transient.h>

#include <deal.II/base/mpi.h>

#include <chrono>
#include <cmath>
#include <cstdio>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  /** Trilinear elements with lumped mass, the contact cut open. */
  struct FloorModel
  {
    FloorModel(const SceneParameters &s, const double cut_off)
      : scene(s)
      , discretization(scene, parameters(), 1, MPI_COMM_SELF)
      , separated(
          separated_system(discretization, assemble_bodies(discretization)))
      , pencil(std::make_shared<const Pencil>(separated.system, scene))
      , basis(std::make_shared<const ReductionBasis>(reduction_basis(
          *pencil,
          undamped_modes(
            *pencil,
            ShiftedInverse(*pencil, std::pow(2. * M_PI * cut_off, 2))),
          separated.contacts[0])))
    {
      load = Block::Zero(pencil->space()->n_owned(), 1);
      for (const auto &l : scene.loads)
        load += separated.restrict_forces(
          load_vector(discretization, PointEvaluator(discretization), l));
      reduced = reduce_contact_model(
        *pencil, *basis, cut_off, separated.contacts[0], load);
    }

    static DiscretizationParameters
    parameters()
    {
      DiscretizationParameters p;
      p.mass = DiscretizationParameters::Mass::lumped;
      return p;
    }

    FullContactModel
    full() const
    {
      FullContactModel m;
      m.pencil          = pencil;
      m.basis           = basis;
      m.relative_motion = std::make_shared<const Functionals>(
        relative_motion(separated.contacts[0]));
      m.load          = load.col(0);
      m.observers     = Block::Zero(load.rows(), 1);
      m.initial_gap   = reduced.initial_gap;
      m.speed_ratio   = reduced.speed_ratio;
      m.motion_offset = Eigen::VectorXd::Zero(3 * reduced.n_nodes());
      return m;
    }

    std::unique_ptr<TransientIntegrator>
    integrator(const std::string    &name,
               const double          dt,
               const TransientDrive &drive,
               const double          nodal_force) const
    {
      if (name == "implicit")
        return std::make_unique<ImplicitTransient>(
          full(), dt, drive, nodal_force);
      if (name == "explicit")
        return std::make_unique<ExplicitTransient>(
          full(), dt, drive, nodal_force);
      return std::make_unique<ReducedTransient>(
        reduced, dt, drive, nodal_force);
    }

    SceneParameters                       scene;
    Discretization                        discretization;
    LinearizedSystem                      separated;
    std::shared_ptr<const Pencil>         pencil;
    std::shared_ptr<const ReductionBasis> basis;
    Block                                 load;
    ReducedContactModel                   reduced;
  };

  SceneParameters
  block_on_ground(const BodyParameters &body, const double mu)
  {
    SceneParameters s;
    s.bodies = {body};
    ContactParameters c;
    c.name                 = "floor";
    c.source_body          = body.name;
    c.source_face          = "z_min";
    c.target_body          = "ground";
    c.formulation          = ContactParameters::Formulation::mortar;
    c.friction_coefficient = mu;
    s.contacts             = {c};
    s.damping.model        = DampingParameters::Model::none;
    return s;
  }

  TransientDrive
  floor_drive(const double mu, const double speed, const double ramp)
  {
    TransientDrive d;
    d.friction = [mu](double) { return mu; };
    d.speed    = [speed](double) { return speed; };
    d.load     = [ramp](const double t) {
      return ramp > 0. ? std::min(1., t / ramp) : 1.;
    };
    return d;
  }

  Eigen::Vector3d
  resultant(const Eigen::VectorXd &lambda)
  {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (Eigen::Index i = 0; i < lambda.size(); i += 3)
      sum += lambda.segment<3>(i);
    return sum;
  }



  struct Impact
  {
    double first = 0., last = 0.; /**< s, of contact */
    double mean_force = 0.;       /**< N, well inside */
    double roughness  = 0.;       /**< rms change from step to step over it */
    double energy     = 0.;       /**< after over before */
    double speed      = 0.;       /**< of the mass centre, m/s */
    double imbalance  = 0.;
  };

  Impact
  bar_on_wall(const std::string &name,
              const unsigned int cells,
              const double       dt)
  {
    BodyParameters bar =
      make_block("bar", {{0., 0., 0.}}, {{1., 1., 10.}}, {{1, 1, cells}});
    bar.young_modulus = 900.;
    bar.density       = 1.;
    bar.poisson_ratio = 0.;
    SceneParameters s = block_on_ground(bar, 0.);
    for (const std::string face : {"x_min", "x_max", "y_min", "y_max"})
      {
        SupportParameters side = make_clamp("bar", face);
        side.kind              = SupportParameters::Kind::components;
        side.components        = {"x", "y"};
        s.supports.push_back(side);
      }
    FloorModel m(s, 60.);
    m.reduced.initial_gap.setConstant(5.);
    const auto run = m.integrator(name, dt, floor_drive(0., 1., 0.), 300. / 4.);
    // Every point falls with 10 m/s.
    const Eigen::VectorXd down =
      interpolate(m.discretization, [](const dealii::Point<3> &) {
        return dealii::Tensor<1, 3>({0., 0., -10.});
      });
    const Eigen::VectorXd momentum = m.pencil->multiply_mass(Block(down));
    const Eigen::VectorXd v        = m.basis->mass_shapes.transpose() * down;
    run->start(Eigen::VectorXd::Zero(v.size()),
               v,
               Eigen::VectorXd::Zero(3 * m.reduced.n_nodes()));
    Impact       result;
    const double before = run->ledger().start;
    double       last = 0., sum = 0., changes = 0.;
    unsigned int n = 0;
    while (run->time() < 1.6)
      {
        run->advance();
        const double f = run->forces()[0] + run->forces()[3] +
                         run->forces()[6] + run->forces()[9];
        if (f > 3.)
          {
            if (result.first == 0.)
              result.first = run->time();
            result.last = run->time();
          }
        if (run->time() > .6 && run->time() < 1.05)
          {
            ++n;
            sum += f;
            changes += (f - last) * (f - last);
          }
        last = f;
      }
    result.mean_force    = sum / n;
    result.roughness     = std::sqrt(changes / n) / 300.;
    const EnergyLedger e = run->ledger();
    result.energy        = (e.kinetic + e.elastic) / before;
    result.imbalance     = e.imbalance();
    // Mean velocity over that thrown down with, from the modal velocities.
    const Eigen::VectorXd share = m.basis->shapes.transpose() * momentum;
    result.speed = -10. * share.dot(run->velocities()) / share.dot(v);
    std::printf("%s, %u cells, dt %g: contact %.4f to %.4f s, force %.3f N, "
                "roughness %.1e, energy %.6f, speed %.5f m/s, imbalance %.1e\n",
                name.c_str(),
                cells,
                dt,
                result.first,
                result.last,
                result.mean_force,
                result.roughness,
                result.energy,
                result.speed,
                result.imbalance);
    return result;
  }

  void
  bar()
  {
    double loss[2] = {0., 0.};
    for (const std::string name : {"reduced", "implicit", "explicit"})
      for (const unsigned int cells : {50u, 100u})
        {
          const Impact i = bar_on_wall(name, cells, 1e-3);
          check_below(std::abs(i.first - .5), .01, name + ": first touch");
          check_below(std::abs(i.last - .5 - 2. / 3.), .03, name + ": leaves");
          check_below(std::abs(i.mean_force / 300. - 1.),
                      .01,
                      name + ": force rho c v A");
          check_below(i.imbalance, 1e-3, name + ": the ledger closes");
          check_below(std::abs(i.speed / 10. - 1.), .03, name + ": rebound");
          check(i.energy < 1. + 1e-4, name + ": no energy from nothing");
          if (name != "reduced")
            {
              loss[cells == 100] = 1. - i.energy;
              if (cells == 100)
                check_below(loss[1] / loss[0],
                            .6,
                            name + ": loses energy of the order of a cell");
            }
        }
    // The massless interface: second order in the step.
    const double coarse =
      std::abs(bar_on_wall("reduced", 50, 2e-3).energy - 1.);
    const double fine =
      std::abs(bar_on_wall("reduced", 50, 2.5e-4).energy - 1.);
    check_below(fine, 1e-4, "reduced: energy is kept");
    check_below(fine, coarse / 8., "reduced: the better the smaller the step");
  }



  /** Steel-free cube of 10 mm in 10^3 cells, pressed with 100 N; its top
   * cannot move sideways. */
  FloorModel
  cube(const double mu)
  {
    BodyParameters body =
      make_block("cube", {{0., 0., 0.}}, {{.01, .01, .01}}, {{10, 10, 10}});
    body.young_modulus    = 16e9;
    body.density          = 2500.;
    body.poisson_ratio    = .3;
    SceneParameters   s   = block_on_ground(body, mu);
    SupportParameters top = make_clamp("cube", "z_max");
    top.kind              = SupportParameters::Kind::components;
    top.components        = {"x", "y"};
    s.supports            = {top};
    LoadParameters press;
    press.name  = "press";
    press.body  = "cube";
    press.face  = "z_max";
    press.force = {{0., 0., -100.}};
    s.loads     = {press};
    if (mu < .4)
      {
        // So that it comes to rest.
        s.damping.model             = DampingParameters::Model::whole_model;
        s.damping.mass_damping      = 2e5;
        s.damping.stiffness_damping = 1e-7;
      }
    return FloorModel(s, 400e3);
  }

  /** Before waves come back no more than sqrt(rho G) A V acts along. */
  void
  impedance()
  {
    const double     mu = .5, speed = .12, bound = 47.07;
    const FloorModel m = cube(mu);
    for (const std::string name : {"implicit", "explicit", "reduced"})
      {
        const double dt = name == "explicit" ? 1e-7 : 1e-6;
        const auto   run =
          m.integrator(name, dt, floor_drive(mu, speed, 5e-6), 100. / 121.);
        const unsigned int n = m.basis->omega_squared.size();
        run->start(Eigen::VectorXd::Zero(n),
                   Eigen::VectorXd::Zero(n),
                   Eigen::VectorXd::Zero(3 * m.reduced.n_nodes()));
        double       largest = 0., roughness = 0., last = 0.;
        unsigned int n_steps = 0;
        const auto   begin   = std::chrono::steady_clock::now();
        while (run->time() < 12.7e-6)
          {
            run->advance();
            ++n_steps;
            const double f = resultant(run->forces()).tail<2>().norm();
            largest        = std::max(largest, f);
            if (run->time() > 6e-6)
              roughness = std::max(roughness, std::abs(f - last));
            last = f;
          }
        std::printf("%s, dt %g: at most %.3f N along (bound %.2f), largest "
                    "change %.3f N, %.0f steps/s, ledger %.1e\n",
                    name.c_str(),
                    dt,
                    largest,
                    bound,
                    roughness,
                    n_steps / std::chrono::duration<double>(
                                std::chrono::steady_clock::now() - begin)
                                .count(),
                    run->ledger().imbalance());
        check_below(largest, 1.005 * bound, name + ": shear-impedance bound");
        check(largest > .5 * bound, name + ": and it is nearly reached");
      }
  }

  /** Steady sliding of the same cube at mu = 0.3. */
  void
  steady()
  {
    const double     mu = .3, speed = .12;
    const FloorModel m = cube(mu);
    for (const std::string name : {"implicit", "reduced"})
      {
        const auto run =
          m.integrator(name, 1e-6, floor_drive(mu, speed, 5e-6), 100. / 121.);
        const unsigned int n = m.basis->omega_squared.size();
        run->start(Eigen::VectorXd::Zero(n),
                   Eigen::VectorXd::Zero(n),
                   Eigen::VectorXd::Zero(3 * m.reduced.n_nodes()));
        unsigned int n_steps = 0;
        const auto   begin   = std::chrono::steady_clock::now();
        for (; run->time() < 5e-4; ++n_steps)
          run->advance();
        unsigned int closed = 0;
        for (const auto s : run->status())
          closed += s != ContactStatus::open;
        const Eigen::Vector3d f = resultant(run->forces());
        std::printf("%s: %u of %u nodes closed, Ft/Fn = %.6f, Fn = %.4f N, "
                    "%.0f steps/s\n",
                    name.c_str(),
                    closed,
                    m.reduced.n_nodes(),
                    f[1] / f[0],
                    f[0],
                    n_steps / std::chrono::duration<double>(
                                std::chrono::steady_clock::now() - begin)
                                .count());
        check(closed >= 81 && closed <= 97, name + ": 81 to 97 nodes closed");
        check_below(
          std::abs(f[1] / f[0] - mu), 2e-5, name + ": all of it slides");
        check_below(std::abs(f[0] - 100.), .1, name + ": carries the load");
      }
  }
} // namespace

int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const std::string                        which = argc > 1 ? argv[1] : "";
  if (which == "bar")
    bar();
  else if (which == "impedance")
    impedance();
  else if (which == "steady")
    steady();
  else
    check(false, "an argument: bar, impedance or steady");
}
