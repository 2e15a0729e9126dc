// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/cycle/located_transient.h>

namespace squeal
{
  LocatedTransient::LocatedTransient(const ReducedContactModel &m,
                                     const double               time_step,
                                     TransientDrive             drive,
                                     const CycleFriction       &law,
                                     const double               nodal_force,
                                     const double               tolerance)
    : ReducedTransient(m, time_step, std::move(drive), nodal_force, tolerance)
    , model(m)
    , friction(law)
    , dt(time_step)
  {
  }

  void
  LocatedTransient::set_past(ContactPast p)
  {
    past = std::move(p);
  }

  void
  LocatedTransient::hold(const StepCorrections &corrections)
  {
    held = &corrections;
  }

  void
  LocatedTransient::set_neighbour(const Orbit &orbit)
  {
    neighbour = &orbit;
  }

  const StepCorrections &
  LocatedTransient::corrections() const
  {
    return used;
  }



  void
  LocatedTransient::prepare_step(ContactStep &step)
  {
    force_at_start  = forces();
    motion_at_start = motion();
    const ChangesInStep changes(
      model, friction, dt, force_at_start, motion_at_start, past);
    step.nodal_friction = friction.kinetic;
    for (unsigned int j = 0; j < model.n_nodes(); ++j)
      if (changes.is_held_at_rest(j))
        step.nodal_friction[j] = friction.limit_at_rest(j);
    Eigen::VectorXd slip(2 * model.n_nodes());
    if (held)
      slip = held->slip[used.slip.size()];
    else
      for (unsigned int j = 0; j < model.n_nodes(); ++j)
        slip.segment<2>(2 * j) = changes.origin(j).slip;
    for (unsigned int j = 0; j < model.n_nodes(); ++j)
      step.previous_motion.segment<2>(3 * j + 1) += slip.segment<2>(2 * j);
    used.slip.push_back(std::move(slip));
    used.position.push_back(held ? held->position[used.position.size()]
                                 : by_jumps(changes));
    if (used.position.back().size() > 0)
      step.free_motion.noalias() += model.participation * used.position.back();
  }



  Eigen::VectorXd
  LocatedTransient::guess_of_forces() const
  {
    if (!neighbour)
      return ReducedTransient::guess_of_forces();
    // Where the nodes close and open along a motion like this one is known, and
    // what the forces differ by changes little from step to step.
    const std::size_t i = used.velocity.size();
    return neighbour->states[i + 1].forces +
           (forces() - neighbour->states[i].forces);
  }

  Eigen::VectorXd
  LocatedTransient::by_jumps(const ChangesInStep &changes) const
  {
    const ModalStep &m = step_of_modes();
    Eigen::VectorXd  result;
    for (unsigned int j = 0; j < model.n_nodes(); ++j)
      if (const auto share = changes.release(j))
        {
          const Eigen::Vector3d jump = changes.jump(j, *share);
          const BesideLine      x    = ChangesInStep::beside_line(
            *share, -*share * jump, (1. - *share) * jump);
          const auto Psi = model.participation.middleRows<3>(3 * j);
          if (result.size() == 0)
            result = Eigen::VectorXd::Zero(model.n_modes());
          result -= m.q_f0 * Eigen::VectorXd(Psi.transpose() * x.at_start) +
                    m.q_f1 * Eigen::VectorXd(Psi.transpose() * x.at_end);
        }
    return result;
  }



  Eigen::VectorXd
  LocatedTransient::beside_lines() const
  {
    const ChangesInStep changes(
      model, friction, dt, force_at_start, motion_at_start, past);
    Eigen::VectorXd start = Eigen::VectorXd::Zero(forces().size()), end = start;
    for (unsigned int j = 0; j < model.n_nodes(); ++j)
      if (const auto share = changes.share(j, status()[j]))
        {
          const BesideLine x =
            changes.beside_line(j, *share, forces().segment<3>(3 * j));
          start.segment<3>(3 * j) = x.at_start;
          end.segment<3>(3 * j)   = x.at_end;
        }
    const auto modal = [this](const Eigen::VectorXd &f) {
      return Eigen::VectorXd(model.participation.transpose() * f);
    };
    return -(step_of_modes().v_f0 * modal(start)) -
           step_of_modes().v_f1 * modal(end);
  }



  void
  LocatedTransient::finish_step(Eigen::VectorXd &coordinates,
                                Eigen::VectorXd &velocity)
  {
    if (used.position.back().size() > 0)
      coordinates += used.position.back();
    used.velocity.push_back(held ? held->velocity[used.velocity.size()]
                                 : beside_lines());
    velocity += used.velocity.back();
    past.motion_change_before = std::move(past.motion_change);
    past.motion_change        = motion() - motion_at_start;
    past.force_change         = forces() - force_at_start;
    past.status_before        = std::move(past.status);
    past.status               = status();
  }
} // namespace squeal
