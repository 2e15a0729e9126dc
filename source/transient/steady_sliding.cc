// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/base/number_text.h>
#include <squeal/contact/friction_law.h>
#include <squeal/transient/steady_sliding.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace squeal
{
  namespace
  {
    /** Stiffness of the contact over the auxiliary one of a motion that nothing
     * else holds. Each round leaves the inverse of this number of what the
     * latter holds; a much larger one drowns the contact in rounding. */
    constexpr double contact_over_auxiliary = 1e3;

    /** Auxiliary stiffness of the modes without one, over their mass, 1/s^2; 0
     * of others. The contact resists a motion v along its normals with at least
     * (v^T v)^2 / (v^T W v), W the flexibility of all that is held. */
    Eigen::VectorXd
    auxiliary_stiffness(const ReducedContactModel &model)
    {
      const auto            normals = Eigen::seqN(0, model.n_nodes(), 3);
      const Eigen::MatrixXd Psi     = model.participation(normals, Eigen::all);
      const Eigen::MatrixXd F       = model.flexibility(normals, normals);
      Eigen::VectorXd       compliance(model.n_modes());
      for (unsigned int k = 0; k < model.n_modes(); ++k)
        compliance[k] =
          model.omega_squared[k] == 0. ? 0. : 1. / model.omega_squared[k];
      Eigen::VectorXd result = Eigen::VectorXd::Zero(model.n_modes());
      for (unsigned int k = 0; k < model.n_modes(); ++k)
        {
          const auto   v = Psi.col(k);
          const double gives_way =
            v.dot(F * v) + (Psi.transpose() * v).cwiseAbs2().dot(compliance);
          if (model.omega_squared[k] == 0. && gives_way > 0.)
            result[k] = std::pow(v.squaredNorm(), 2) /
                        (contact_over_auxiliary * gives_way);
        }
      // A rigid contact takes any stiffness, a motion along the faces a small
      // one.
      const double most = result.size() > 0 ? result.maxCoeff() : 0.;
      for (unsigned int k = 0; k < model.n_modes(); ++k)
        if (model.omega_squared[k] == 0.)
          result[k] = most > 0. ? std::max(result[k], 1e-4 * most) : 1.;
      return result;
    }

    [[noreturn]] void
    throw_none(const bool without_friction, const double reached)
    {
      if (without_friction)
        throw ComputationError("there is no steady sliding: nothing presses "
                               "the bodies of the contact together");
      throw ComputationError(
        "there is no steady sliding beyond mu = " + rounded_text(reached, 6) +
        ": the friction wedges or sprags");
    }
  } // namespace



  unsigned int
  SteadySliding::n_closed() const
  {
    return std::count_if(status.begin(), status.end(), [](const auto s) {
      return s != ContactStatus::open;
    });
  }

  Eigen::Vector3d
  SteadySliding::resultant() const
  {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (Eigen::Index i = 0; i < forces.size(); i += 3)
      sum += forces.segment<3>(i);
    return sum;
  }



  unsigned int
  SteadySliding::n_with(const ContactStatus asked) const
  {
    return std::count(status.begin(), status.end(), asked);
  }



  namespace
  {
    /** Static contact problems of one model. Motions that nothing holds get an
     * auxiliary stiffness whose force goes back into the load. */
    class StaticContact
    {
    public:
      /** @p speed_ratio: that of the model, or zero where all is at rest. */
      StaticContact(const ReducedContactModel &m,
                    const Eigen::VectorXd     &speed_ratio,
                    const double               tolerance)
        : model(m)
        , held(auxiliary_stiffness(m))
        , compliance((m.omega_squared + held).cwiseInverse())
      {
        const Eigen::MatrixXd &Psi = model.participation;
        Eigen::MatrixXd        W =
          Psi * compliance.asDiagonal() * Psi.transpose() + model.flexibility;
        if (const Eigen::MatrixXd fill = fill_of_null_space(model, W);
            fill.size() > 0)
          W += fill;
        solver =
          std::make_unique<ContactSolver>(W,
                                          model.initial_gap,
                                          speed_ratio,
                                          mean_force(W),
                                          tolerance,
                                          ContactSolver::Precision::full);
      }

      /** Nothing touches. */
      SteadySliding
      untouched() const
      {
        SteadySliding state;
        state.forces      = Eigen::VectorXd::Zero(model.participation.rows());
        state.motion      = state.forces;
        state.coordinates = Eigen::VectorXd::Zero(model.n_modes());
        state.status.assign(model.n_nodes(), ContactStatus::open);
        return state;
      }

      /** False where there is no solution near the forces of @p state. */
      bool
      solve(ContactStep step, const double share, SteadySliding &state)
      {
        const Eigen::MatrixXd &Psi = model.participation;
        const Eigen::VectorXd  f   = share * model.load;
        for (unsigned int i = 0; i < 100; ++i)
          {
            const Eigen::VectorXd q_free =
              compliance.cwiseProduct(f + held.cwiseProduct(state.coordinates));
            step.free_motion = Psi * q_free + share * model.load_motion;
            if (!solver->newton(step, state.forces, state.report))
              return false;
            const Eigen::VectorXd contact = Psi.transpose() * state.forces;
            const Eigen::VectorXd q = q_free - compliance.cwiseProduct(contact);
            const double          change =
              held.cwiseProduct(q - state.coordinates).norm();
            state.coordinates = q;
            // Of the forces, which may balance each other in every mode.
            const double size =
              f.norm() +
              (Psi.cwiseAbs().transpose() * state.forces.cwiseAbs()).norm();
            if (change <= 1e-11 * size)
              {
                state.motion = solver->motion();
                state.status = solver->status();
                return true;
              }
            if (!(change < 1e6 * size))
              return false;
          }
        return false;
      }

    private:
      /** The size of nodal forces, N: the even ones that would take back what
       * the full load moves the nodes together. */
      double
      mean_force(const Eigen::MatrixXd &W) const
      {
        const Eigen::VectorXd load_motion =
          model.participation * compliance.cwiseProduct(model.load) +
          model.load_motion;
        double approach = 0., flexibility = 0.;
        for (unsigned int j = 0; j < model.n_nodes(); ++j)
          {
            approach += std::max(0., load_motion[3 * j]);
            for (unsigned int i = 0; i < model.n_nodes(); ++i)
              flexibility += W(3 * j, 3 * i);
          }
        return std::max(approach / flexibility, 1e-12);
      }

      const ReducedContactModel     &model;
      Eigen::VectorXd                held, compliance;
      std::unique_ptr<ContactSolver> solver;
    };
  } // namespace



  SteadySliding
  steady_sliding(const ReducedContactModel &model,
                 const double               friction,
                 const double               load_factor,
                 const double               tolerance)
  {
    return steady_sliding(
      model,
      NodalFriction::uniform(friction, model.n_nodes()).coefficient,
      load_factor,
      tolerance);
  }



  namespace
  {
    /** Equal shares of the loads, and then of the friction of sliding pairs, in
     * which pairs at rest get to their state. */
    constexpr unsigned int order_steps = 10;

    /** A step in which nothing has moved yet. */
    ContactStep
    first_step(const ReducedContactModel &model, const double speed)
    {
      ContactStep step;
      step.previous_motion = Eigen::VectorXd::Zero(model.participation.rows());
      step.duration        = 0.;
      step.friction        = 0.;
      step.speed           = speed;
      return step;
    }

    /** A step of the load in which friction comes on in shares, from the
     * solution without it, where it has none from the forces before: the
     * equations that hold in the end are the same. False where that has none
     * either. */
    bool
    solve_by_shares(StaticContact         &contact,
                    const Eigen::VectorXd &friction,
                    ContactStep            step,
                    const double           load_share,
                    SteadySliding         &state)
    {
      constexpr double least_share = 1e-3;
      SteadySliding    now         = state;
      step.nodal_friction          = Eigen::VectorXd::Zero(friction.size());
      if (!contact.solve(step, load_share, now))
        return false;
      double reached = 0., increment = .1;
      while (reached < 1.)
        {
          const double  share = std::min(reached + increment, 1.);
          SteadySliding next  = now;
          step.nodal_friction = share * friction;
          if (contact.solve(step, load_share, next))
            {
              now     = next;
              reached = share;
            }
          else if ((increment *= .5) < least_share)
            return false;
        }
      state = now;
      return true;
    }

    /** Everything at rest: states at the ends of @p n_steps equal parts of the
     * load up to the share @p last. */
    std::vector<SteadySliding>
    press(StaticContact         &contact,
          const Eigen::VectorXd &friction,
          const unsigned int     n_steps,
          const double           last,
          ContactStep            step)
    {
      std::vector<SteadySliding> states;
      SteadySliding              now = contact.untouched();
      bool by_shares = false; // where the smallest part of a load does not do
      for (unsigned int k = 1; k <= n_steps; ++k)
        {
          // What sticks depends on the way there, so that the load is halved
          // only where it has to be.
          const double end = last * k / n_steps;
          double reached = last * (k - 1) / n_steps, increment = end - reached;
          while (reached < end)
            {
              const double  share  = std::min(reached + increment, end);
              SteadySliding next   = now;
              step.previous_motion = now.motion;
              // The first touch is sought without friction, which may be all
              // that holds a body along the face.
              step.nodal_friction = Eigen::VectorXd::Zero(friction.size());
              const bool touches =
                reached > 0. || contact.solve(step, share, next);
              if (!touches)
                next = now;
              step.nodal_friction = friction;
              if (by_shares
                    ? solve_by_shares(contact, friction, step, share, now)
                    : contact.solve(step, share, next))
                {
                  if (!by_shares)
                    now = next;
                  reached = share;
                  continue;
                }
              increment *= 0.5;
              if (increment * n_steps >= 1e-3 * last)
                continue;
              if (!touches)
                throw ComputationError(
                  "the contact at rest has no solution: nothing presses the "
                  "bodies together, or more pulls at one along the face than "
                  "its friction holds");
              if (by_shares)
                throw ComputationError(
                  "the contact at rest has no solution at " +
                  rounded_text(100. * share, 4) + " % of the load");
              by_shares = true;
              increment = end - reached;
            }
          states.push_back(now);
        }
      return states;
    }

    /** All nodes slide: friction comes in steps, from the solution without it,
     * which is unique; all nodes by the same share. */
    SteadySliding
    slide_everywhere(StaticContact             &contact,
                     const ReducedContactModel &model,
                     const Eigen::VectorXd     &friction,
                     const double               load_factor)
    {
      // The target slides so far that the slip has its direction.
      ContactStep step      = first_step(model, 1.);
      step.duration         = 1e6;
      SteadySliding result  = contact.untouched();
      const double  largest = friction.maxCoeff();
      double        reached = 0., increment = largest;
      for (bool first = true; first || reached < largest; first = false)
        {
          step.friction = first ? 0. : std::min(reached + increment, largest);
          step.nodal_friction =
            step.friction * (largest > 0. ? friction / largest : friction);
          SteadySliding next   = result;
          const bool    solved = contact.solve(step, load_factor, next);
          if (!solved && (first || increment < 1e-3 * largest))
            throw_none(first, reached);
          if (!solved)
            {
              increment *= 0.5;
              continue;
            }
          result  = next;
          reached = step.friction;
        }
      return result;
    }

    /** Some nodes are at rest: the loads come on without friction in the
     * sliding pairs, which then grows to its full size in equal steps. */
    SteadySliding
    slide_after_pressing(StaticContact             &contact,
                         const ReducedContactModel &model,
                         const Eigen::VectorXd     &friction,
                         const double               load_factor)
    {
      const Eigen::ArrayXd slides =
        (model.speed_ratio.array() > 0.).cast<double>();
      const auto friction_at = [&](const double share) {
        return Eigen::VectorXd(friction.array() *
                               (1. - slides + share * slides));
      };
      // The targets slide so far that the slip has its direction.
      ContactStep step = first_step(model, 1.);
      step.duration    = 1e6;
      SteadySliding now =
        press(contact, friction_at(0.), order_steps, load_factor, step).back();
      double reached = 0., increment = 1. / order_steps;
      while (reached < 1.)
        {
          const double  share  = std::min(reached + increment, 1.);
          SteadySliding next   = now;
          step.previous_motion = now.motion;
          step.nodal_friction  = friction_at(share);
          if (contact.solve(step, load_factor, next))
            {
              now     = next;
              reached = share;
              continue;
            }
          increment *= 0.5;
          if (increment < 1e-3 / order_steps)
            throw ComputationError(
              "there is no steady sliding beyond " +
              rounded_text(100. * reached, 4) +
              " % of the friction of the sliding pairs: it wedges or sprags, "
              "or it pulls a body off the pair at rest that alone holds it");
        }
      return now;
    }

    /** Nothing moves in pairs at rest: what has friction sticks there. */
    void
    set_resting_status(const ReducedContactModel &model,
                       const Eigen::VectorXd     &friction,
                       SteadySliding             &state)
    {
      for (unsigned int j = 0; j < model.n_nodes(); ++j)
        if (model.speed_ratio[j] == 0. &&
            state.status[j] != ContactStatus::open)
          state.status[j] =
            friction[j] > 0. ? ContactStatus::stick : ContactStatus::slip;
    }
  } // namespace



  SteadySliding
  steady_sliding(const ReducedContactModel &model,
                 const Eigen::VectorXd     &friction,
                 const double               load_factor,
                 const double               tolerance)
  {
    StaticContact contact(model, model.speed_ratio, tolerance);
    const bool    has_resting = (model.speed_ratio.array() == 0.).any();
    SteadySliding result =
      has_resting ? slide_after_pressing(contact, model, friction, load_factor)
                  : slide_everywhere(contact, model, friction, load_factor);
    if (result.n_closed() == 0)
      throw_none(true, 0.);
    // Without friction what is left along the face is rounding.
    for (Eigen::Index j = 0; j < friction.size(); ++j)
      if (friction[j] == 0.)
        result.forces.segment<2>(3 * j + 1).setZero();
    set_resting_status(model, friction, result);
    return result;
  }



  std::vector<SteadySliding>
  press_at_rest(const ReducedContactModel &model,
                const double               friction,
                const unsigned int         n_steps,
                const double               tolerance)
  {
    return press_at_rest(
      model,
      NodalFriction::uniform(friction, model.n_nodes()).coefficient,
      n_steps,
      tolerance);
  }

  std::vector<SteadySliding>
  press_at_rest(const ReducedContactModel &model,
                const Eigen::VectorXd     &friction,
                const unsigned int         n_steps,
                const double               tolerance)
  {
    StaticContact contact(
      model, Eigen::VectorXd::Zero(model.n_nodes()), tolerance);
    return press(contact, friction, n_steps, 1., first_step(model, 0.));
  }
} // namespace squeal
