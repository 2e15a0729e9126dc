// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/transient/reduced_transient.h>

#include <cmath>
#include <iterator>
#include <limits>
#include <sstream>

namespace squeal
{
  namespace
  {
    /** Integral of the product of the slopes of two cubics over a step, from
     * values and slopes at both ends. */
    double
    slope_product(const double q0,
                  const double v0,
                  const double q1,
                  const double v1,
                  const double h)
    {
      const double d = (q1 - q0) / h;
      return h *
             (36. * d * d - 6. * d * (v0 + v1) + 4. * (v0 * v0 + v1 * v1) -
              2. * v0 * v1) /
             30.;
    }

    /** The same of all coordinates with the symmetric matrix @p D between
     * them, @p d being their mean slopes. */
    double
    slope_product(const Eigen::MatrixXd &D,
                  const Eigen::VectorXd &d,
                  const Eigen::VectorXd &v0,
                  const Eigen::VectorXd &v1,
                  const double           h)
    {
      const Eigen::VectorXd D_d = D * d, D_v0 = D * v0, D_v1 = D * v1;
      return h *
             (36. * d.dot(D_d) - 6. * (v0 + v1).dot(D_d) +
              4. * (v0.dot(D_v0) + v1.dot(D_v1)) - 2. * v0.dot(D_v1)) /
             30.;
    }
  } // namespace



  namespace
  {
    constexpr std::pair<const char *, double EnergyLedger::*> energy_names[] = {
      {"kinetic", &EnergyLedger::kinetic},
      {"elastic", &EnergyLedger::elastic},
      {"damping", &EnergyLedger::damping},
      {"friction", &EnergyLedger::friction},
      {"driving", &EnergyLedger::driving},
      {"load", &EnergyLedger::load},
      {"numerical", &EnergyLedger::numerical},
      {"start", &EnergyLedger::start}};
    static_assert(sizeof(EnergyLedger) ==
                    std::size(energy_names) * sizeof(double),
                  "every member has a name");
  } // namespace

  NamedNumbers
  EnergyLedger::memory() const
  {
    NamedNumbers result;
    for (const auto &[name, member] : energy_names)
      result.set(name, this->*member);
    return result;
  }

  void
  EnergyLedger::restore(const NamedNumbers &memory)
  {
    for (const auto &[name, member] : energy_names)
      this->*member = memory.number(name);
  }



  double
  EnergyLedger::imbalance() const
  {
    const double work = std::abs(driving) + std::abs(load) + start;
    return std::abs(kinetic + elastic - start + damping + friction + numerical -
                    driving - load) /
           std::max(work, 1e-300);
  }



  ReducedTransient::ReducedTransient(const ReducedContactModel  &m,
                                     const double                time_step,
                                     TransientDrive              d,
                                     const double                nodal_force,
                                     const double                tolerance,
                                     const ContactSolver::Method method)
    : model(m)
    , dt(time_step)
    , drive(std::move(d))
    , modes(m, time_step)
    , solver(modes.delassus(m),
             m.initial_gap,
             m.speed_ratio,
             nodal_force,
             tolerance,
             ContactSolver::Precision::single,
             method)
    , friction(drive, m.speed_ratio)
  {
    if (const double largest = largest_stable_step(model, dt); largest < dt)
      {
        std::ostringstream text;
        text << "Transient/Time step: " << dt
             << " s is above the largest stable step of the reduced model, "
             << largest
             << " s; fewer motions, by 'Cut-off' or 'Interface cut-off', allow "
                "longer ones";
        throw InputError(text.str());
      }
  }



  Eigen::VectorXd
  ReducedTransient::external_forces(const double time) const
  {
    Eigen::VectorXd f = drive.load(time) * model.load;
    for (const auto &force : drive.forces)
      if (const double factor = force.factor(time); factor != 0.)
        f += factor * force.force.modal;
    return f;
  }

  Eigen::VectorXd
  ReducedTransient::external_motion(const double time) const
  {
    Eigen::VectorXd motion = drive.load(time) * model.load_motion;
    for (const auto &force : drive.forces)
      if (const double factor = force.factor(time); factor != 0.)
        motion += factor * force.force.motion;
    return motion;
  }



  void
  ReducedTransient::start(const Eigen::VectorXd &positions,
                          const Eigen::VectorXd &velocity,
                          const Eigen::VectorXd &forces)
  {
    n_steps  = 0;
    q        = positions;
    v        = velocity;
    lambda   = forces;
    lambda_1 = lambda_2 = forces;
    load_now            = external_forces(0.);
    motion_now          = external_motion(0.);
    total_force         = load_now - model.participation.transpose() * lambda;
    u = model.participation * q + motion_now - model.flexibility * lambda;
    friction.start(model.participation * v);
    energies       = {};
    energies.start = stored_energy();
    losses         = Eigen::VectorXd::Zero(model.n_nodes());
  }



  ContactReport
  ReducedTransient::advance()
  {
    const double          t      = dt * (n_steps + 1);
    const Eigen::VectorXd load   = external_forces(t);
    const Eigen::VectorXd motion = external_motion(t);
    const Eigen::VectorXd q_free = modes.q_q * q + modes.q_v * v +
                                   modes.q_f0 * total_force + modes.q_f1 * load;
    ContactStep step;
    step.free_motion = motion;
    step.free_motion.noalias() += model.participation * q_free;
    step.previous_motion = u;
    step.duration        = dt;
    step.speed           = drive.speed(t - 0.5 * dt);
    friction.set(t, step);
    prepare_step(step);

    Eigen::VectorXd       guess  = guess_of_forces();
    const ContactReport   report = solver.solve(step, guess);
    const Eigen::VectorXd force =
      load - model.participation.transpose() * guess;
    const Eigen::VectorXd q_before = q, v_before = v, u_before = u;
    v = modes.v_q * q_before + modes.v_v * v_before + modes.v_f0 * total_force +
        modes.v_f1 * force;
    q           = q_free + modes.q_f1 * Eigen::VectorXd(force - load);
    lambda_2    = lambda_1;
    lambda_1    = lambda;
    lambda      = guess;
    total_force = force;
    u           = solver.motion();
    friction.keep(step, u, solver.status());
    ++n_steps;
    finish_step(q, v);
    // The ledger sees external forces and motions of both ends.
    const Eigen::VectorXd load_before = load_now, motion_before = motion_now;
    load_now   = load;
    motion_now = motion;
    energies.load +=
      0.5 * (load + load_before).dot(q - q_before) +
      0.5 * (lambda + lambda_1).dot(motion - motion_before) +
      energy_of_loads(t, motion, lambda) -
      energy_of_loads(dt * (n_steps - 1), motion_before, lambda_1);
    update_ledger(q_before, v_before, lambda_1, u_before);
    return report;
  }



  void
  ReducedTransient::prepare_step(ContactStep &)
  {
  }

  void
  ReducedTransient::finish_step(Eigen::VectorXd &, Eigen::VectorXd &)
  {
  }

  Eigen::VectorXd
  ReducedTransient::guess_of_forces() const
  {
    return 3. * (lambda - lambda_1) + lambda_2;
  }



  double
  ReducedTransient::stored_energy() const
  {
    return 0.5 * v.squaredNorm() +
           0.5 * model.omega_squared.dot(q.cwiseAbs2()) +
           0.5 * lambda.dot(model.flexibility * lambda) +
           energy_of_loads(time(), motion_now, lambda);
  }

  double
  ReducedTransient::energy_of_loads(const double           time,
                                    const Eigen::VectorXd &motion,
                                    const Eigen::VectorXd &contact_forces) const
  {
    // 1/2 (f - B^T lambda) R (f - B^T lambda), the last term being that of G.
    if (drive.flexibility.size() == 0)
      return 0.;
    Eigen::VectorXd share(1 + drive.forces.size());
    share[0] = drive.load(time);
    for (std::size_t i = 0; i < drive.forces.size(); ++i)
      share[1 + i] = drive.forces[i].factor(time);
    double energy =
      0.5 * share.dot(drive.flexibility * share) - contact_forces.dot(motion);
    if (model.support_motion.size() > 0)
      energy += share[0] * contact_forces.dot(model.support_motion);
    return energy;
  }



  void
  ReducedTransient::update_ledger(const Eigen::VectorXd &q_before,
                                  const Eigen::VectorXd &v_before,
                                  const Eigen::VectorXd &forces_before,
                                  const Eigen::VectorXd &motion_before)
  {
    for (Eigen::Index k = 0; k < q.size(); ++k)
      energies.damping +=
        model.damping[k] *
        slope_product(q_before[k], v_before[k], q[k], v[k], dt);
    if (model.has_coupled_damping())
      energies.damping += slope_product(
        model.damping_coupling, (q - q_before) / dt, v_before, v, dt);
    const double speed = drive.speed(time() - 0.5 * dt);
    for (unsigned int j = 0; j < model.n_nodes(); ++j)
      {
        const Eigen::Vector3d mean =
          0.5 * (lambda + forces_before).segment<3>(3 * j);
        const Eigen::Vector3d change = (u - motion_before).segment<3>(3 * j);
        const double          way    = dt * speed * model.speed_ratio[j];
        const double lost = mean[1] * (way + change[1]) + mean[2] * change[2];
        energies.driving += mean[1] * way;
        energies.friction += lost;
        losses[j] += lost;
        energies.numerical += mean[0] * change[0];
      }
  }



  double
  ReducedTransient::time() const
  {
    return dt * n_steps;
  }

  Eigen::VectorXd
  ReducedTransient::coordinates() const
  {
    return q;
  }

  Eigen::VectorXd
  ReducedTransient::velocities() const
  {
    return v;
  }

  const Eigen::VectorXd &
  ReducedTransient::forces() const
  {
    return lambda;
  }

  const Eigen::VectorXd &
  ReducedTransient::motion() const
  {
    return u;
  }

  const std::vector<ContactStatus> &
  ReducedTransient::status() const
  {
    return solver.status();
  }

  EnergyLedger
  ReducedTransient::ledger() const
  {
    EnergyLedger result = energies;
    result.kinetic      = 0.5 * v.squaredNorm();
    result.elastic      = stored_energy() - result.kinetic;
    return result;
  }

  const Eigen::VectorXd &
  ReducedTransient::friction_losses() const
  {
    return losses;
  }

  Eigen::VectorXd
  ReducedTransient::observed_motion() const
  {
    Eigen::VectorXd motion =
      model.observed.evaluate(q, drive.load(time()), lambda);
    for (const auto &force : drive.forces)
      if (const double factor = force.factor(time()); factor != 0.)
        motion += factor * force.force.observed;
    return motion;
  }

  Eigen::VectorXd
  ReducedTransient::observed_accelerations() const
  {
    return model.observed.modes * (total_force - model.damping_forces(v) -
                                   model.omega_squared.cwiseProduct(q));
  }

  unsigned int
  ReducedTransient::n_inversions() const
  {
    return solver.n_inversions();
  }

  std::vector<std::pair<std::string, Eigen::VectorXd *>>
  ReducedTransient::state()
  {
    return {{"coordinates", &q},
            {"velocities", &v},
            {"motion", &u},
            {"total_force", &total_force},
            {"forces", &lambda},
            {"forces_before", &lambda_1},
            {"forces_before_that", &lambda_2},
            {"load", &load_now},
            {"motion_of_load", &motion_now},
            {"friction", &friction.state()},
            {"friction_losses", &losses}};
  }

  NamedNumbers
  ReducedTransient::memory() const
  {
    NamedNumbers result;
    result.set("n_steps", static_cast<double>(n_steps));
    result.set("energies", energies.memory());
    for (const auto &[name, x] : const_cast<ReducedTransient *>(this)->state())
      result.set(name, Eigen::MatrixXd(*x));
    result.set("solver", solver.memory());
    return result;
  }

  void
  ReducedTransient::restore(const NamedNumbers &memory)
  {
    n_steps = memory.count("n_steps", std::numeric_limits<unsigned int>::max());
    energies.restore(memory.group("energies"));
    // Sizes are those of the start, which has been set before.
    for (const auto &[name, x] : state())
      *x = memory.vector(name, x->size());
    solver.restore(memory.group("solver"));
  }
} // namespace squeal
