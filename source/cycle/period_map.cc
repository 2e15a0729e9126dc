// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/cycle/located_transient.h>
#include <squeal/cycle/period_derivative.h>
#include <squeal/cycle/period_map.h>

#include <algorithm>

namespace squeal
{
  namespace
  {
    /** Residual of the contact in plain runs, which are exact to the first
     * order of their steps: that of transients. */
    constexpr double plain_tolerance = 1e-8;

    /** Of nodes that do not know a law of their own: mu of LocatedTransient. */
    TransientDrive
    constant_drive(const double speed)
    {
      TransientDrive d;
      d.friction = [](double) { return 0.; };
      d.speed    = [speed](double) { return speed; };
      d.load     = [](double) { return 1.; };
      return d;
    }

    CycleFriction
    uniform(const double mu, const double speed, const unsigned int n_nodes)
    {
      CycleFriction result;
      result.kinetic = Eigen::VectorXd::Constant(n_nodes, mu);
      result.speed   = speed;
      return result;
    }
  } // namespace



  PeriodMap::PeriodMap(const ReducedContactModel &m,
                       const double               mu,
                       const double               speed,
                       const double               force,
                       const double               t)
    : PeriodMap(m, uniform(mu, speed, m.n_nodes()), force, t)
  {
  }

  PeriodMap::PeriodMap(const ReducedContactModel   &m,
                       CycleFriction                law,
                       const double                 force,
                       const double                 t,
                       std::vector<unsigned int>    nodes_of_pairs,
                       std::vector<PressureMoments> moments_of_pairs)
    : model(m)
    , drive(constant_drive(law.speed))
    , friction(std::move(law))
    , nodal_force(force)
    , tolerance(t)
    , pairs(std::move(nodes_of_pairs))
    , moments(std::move(moments_of_pairs))
  {
    if (pairs.empty())
      pairs = {model.n_nodes()};
  }



  Orbit
  PeriodMap::run(const MotionState     &start,
                 const double           time,
                 const unsigned int     n_steps,
                 const ContactPast     &past,
                 const StepCorrections *held,
                 const Orbit           *neighbour) const
  {
    return run_by(
      drive, start, time, n_steps, past, held, neighbour, tolerance);
  }

  Orbit
  PeriodMap::run_plainly(const MotionState           &start,
                         const double                 time,
                         const unsigned int           n_steps,
                         const ContactPast           &past,
                         const TransientDrive::Force *force) const
  {
    TransientDrive forced = drive;
    if (force)
      forced.forces.push_back(*force);
    const StepCorrections none{
      std::vector<Eigen::VectorXd>(n_steps,
                                   Eigen::VectorXd::Zero(2 * model.n_nodes())),
      std::vector<Eigen::VectorXd>(n_steps),
      std::vector<Eigen::VectorXd>(n_steps,
                                   Eigen::VectorXd::Zero(model.n_modes()))};
    return run_by(forced,
                  start,
                  time,
                  n_steps,
                  past,
                  &none,
                  nullptr,
                  std::max(tolerance, plain_tolerance));
  }

  Orbit
  PeriodMap::run_by(const TransientDrive  &driven_by,
                    const MotionState     &start,
                    const double           time,
                    const unsigned int     n_steps,
                    const ContactPast     &past,
                    const StepCorrections *held,
                    const Orbit           *neighbour,
                    const double           contact_tolerance) const
  {
    Orbit orbit;
    orbit.step = time / n_steps;
    orbit.past = past;
    LocatedTransient motion(
      model, orbit.step, driven_by, friction, nodal_force, contact_tolerance);
    motion.start(start.coordinates, start.velocities, start.forces);
    motion.set_past(past);
    if (held)
      motion.hold(*held);
    if (neighbour && neighbour->n_steps() == n_steps)
      motion.set_neighbour(*neighbour);
    orbit.states.push_back(start);
    orbit.motions.push_back(motion.motion());
    for (unsigned int i = 0; i < n_steps; ++i)
      {
        orbit.n_iterations += motion.advance().iterations;
        orbit.states.push_back(
          {motion.coordinates(), motion.velocities(), motion.forces()});
        orbit.motions.push_back(motion.motion());
        orbit.status.push_back(motion.status());
      }
    orbit.corrections = motion.corrections();
    orbit.ledger      = motion.ledger();
    return orbit;
  }



  std::vector<int>
  PeriodMap::closed_rows(const Orbit &orbit) const
  {
    std::vector<int> rows;
    for (unsigned int j = 0; j < model.n_nodes(); ++j)
      if (orbit.states.front().forces.segment<3>(3 * j).squaredNorm() > 0. ||
          orbit.status.back()[j] != ContactStatus::open)
        for (unsigned int c = 0; c < 3; ++c)
          rows.push_back(3 * j + c);
    return rows;
  }



  Eigen::MatrixXd
  PeriodMap::derivative(const Orbit            &orbit,
                        const std::vector<int> &rows,
                        const StatusChanges     changes) const
  {
    return period_derivative(model, friction, orbit, rows, changes);
  }



  Eigen::VectorXd
  PeriodMap::acceleration(const MotionState &state) const
  {
    return model.load - model.participation.transpose() * state.forces -
           model.damping_forces(state.velocities) -
           model.omega_squared.cwiseProduct(state.coordinates);
  }
} // namespace squeal
