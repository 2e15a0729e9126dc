// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/cycle/located_transient.h>
#include <squeal/cycle/slip_origin.h>

namespace squeal
{
  LocatedTransient::LocatedTransient(const ReducedContactModel &m,
                                     const double               time_step,
                                     TransientDrive             drive,
                                     const Eigen::VectorXd     &mu,
                                     const double               v,
                                     const double               nodal_force,
                                     const double               tolerance)
    : ReducedTransient(m, time_step, std::move(drive), nodal_force, tolerance)
    , model(m)
    , friction(mu)
    , speed(v)
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
      model, friction, speed, dt, force_at_start, motion_at_start, past);
    Eigen::VectorXd slip(2 * model.n_nodes());
    if (held)
      slip = held->slip[used.slip.size()];
    else
      for (unsigned int j = 0; j < model.n_nodes(); ++j)
        slip.segment<2>(2 * j) = changes.origin(j).slip;
    for (unsigned int j = 0; j < model.n_nodes(); ++j)
      step.previous_motion.segment<2>(3 * j + 1) += slip.segment<2>(2 * j);
    used.slip.push_back(std::move(slip));
  }



  Eigen::VectorXd
  LocatedTransient::bends() const
  {
    const ChangesInStep changes(
      model, friction, speed, dt, force_at_start, motion_at_start, past);
    // A triangle over the straight line with its tip where the force bends, as
    // the straight line of the same impulse and moment.
    Eigen::VectorXd before = Eigen::VectorXd::Zero(forces().size()),
                    after  = before;
    for (unsigned int j = 0; j < model.n_nodes(); ++j)
      if (const auto share = changes.share(j, status()[j]))
        {
          const Eigen::Vector3d tip =
            *share *
            (force_at_start + past.force_change - forces()).segment<3>(3 * j);
          before.segment<3>(3 * j) = (1. - *share) * tip;
          after.segment<3>(3 * j)  = *share * tip;
        }
    return -step_of_modes().v_f0.cwiseProduct(model.participation.transpose() *
                                              before) -
           step_of_modes().v_f1.cwiseProduct(model.participation.transpose() *
                                             after);
  }

  void
  LocatedTransient::finish_step(Eigen::VectorXd &velocity)
  {
    used.velocity.push_back(held ? held->velocity[used.velocity.size()]
                                 : bends());
    velocity += used.velocity.back();
    past.motion_change_before = std::move(past.motion_change);
    past.motion_change        = motion() - motion_at_start;
    past.force_change         = forces() - force_at_start;
    past.status_before        = std::move(past.status);
    past.status               = status();
  }
} // namespace squeal
