// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/base/number_text.h>
#include <squeal/eigen/standard_pairs.h>
#include <squeal/transient/steady_sliding.h>


#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numeric>

namespace squeal
{
  namespace
  {
    /** Stiffness that stands in for that of rigid motions while they are
     * solved for; what it holds goes back into the load. */
    constexpr double auxiliary_frequency = 3.; // Hz

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
      StaticContact(const ReducedContactModel &m, const double tolerance)
        : model(m)
        , held(Eigen::VectorXd::Zero(m.n_modes()))
        , compliance(m.n_modes())
      {
        for (unsigned int k = 0; k < model.n_modes(); ++k)
          {
            if (model.omega_squared[k] == 0.)
              held[k] = std::pow(2. * M_PI * auxiliary_frequency, 2);
            compliance[k] = 1. / (model.omega_squared[k] + held[k]);
          }
        const Eigen::MatrixXd &Psi = model.participation;
        const Eigen::MatrixXd  W =
          Psi * compliance.asDiagonal() * Psi.transpose() + model.flexibility;
        solver =
          std::make_unique<ContactSolver>(W,
                                          model.initial_gap,
                                          model.speed_ratio,
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
              // The first touch is sought without friction.
              step.nodal_friction = Eigen::VectorXd::Zero(friction.size());
              if (reached == 0. && !contact.solve(step, share, next))
                throw_none(true, 0.);
              step.nodal_friction = friction;
              if (contact.solve(step, share, next))
                {
                  now     = next;
                  reached = share;
                  continue;
                }
              increment *= 0.5;
              if (increment * n_steps < 1e-3 * last)
                throw ComputationError(
                  "the contact at rest has no solution at " +
                  rounded_text(100. * share, 4) + " % of the load");
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
              " % of the friction of the sliding pairs: it wedges or sprags");
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
    StaticContact contact(model, tolerance);
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
    StaticContact contact(model, tolerance);
    return press(contact, friction, n_steps, 1., first_step(model, 0.));
  }



  namespace
  {
    /** Rows of all nodal forces and motions, by what the nodes do. */
    struct ClosedRows
    {
      ClosedRows(const SteadySliding &steady, const NodalFriction &friction)
      {
        for (std::size_t j = 0; j < steady.status.size(); ++j)
          switch (steady.status[j])
            {
            case ContactStatus::open:
              break;
            case ContactStatus::stick:
              for (unsigned int c = 0; c < 3; ++c)
                kept.push_back(3 * j + c);
              break;
            case ContactStatus::slip:
              slipping.push_back(j);
              normal_of_slipping.push_back(kept.size());
              kept.push_back(3 * j);
              along.push_back(3 * j + 1);
              if (friction.coefficient[j] > 0.)
                across.push_back(3 * j + 2);
              break;
            }
      }

      std::vector<int> slipping; /**< nodes */
      /** Motions that stay: the normal one of slipping nodes, all three of
       * sticking ones. */
      std::vector<int> kept;
      std::vector<int> normal_of_slipping; /**< places among them */
      /** Of slipping nodes; across the sliding of those with friction. */
      std::vector<int> along, across;
    };

    /** w^T x, and where two pairs have coalesced, so that nothing but rounding
     * is left of it, the size of that. */
    std::complex<double>
    product_of(const Eigen::VectorXcd &w, const Eigen::VectorXcd &x)
    {
      const std::complex<double> product = (w.transpose() * x).value();
      const double rounding = std::numeric_limits<double>::epsilon() *
                              w.cwiseAbs().cwiseProduct(x.cwiseAbs()).sum();
      return std::abs(product) > rounding ? product : rounding;
    }

    /** Eigenvalues of x' = A x, x = (q, v, ...) with @p n positions. */
    LinearizedMotion
    motion_of(const Eigen::MatrixXd &A, const unsigned int n)
    {
      const StandardPairs pairs = standard_pairs(A);
      std::vector<int>    kept;
      for (Eigen::Index k = 0; k < A.rows(); ++k)
        if (pairs.values[k].imag() >= 0.)
          kept.push_back(k);
      std::sort(kept.begin(), kept.end(), [&](const int a, const int b) {
        return pairs.values[a].imag() < pairs.values[b].imag();
      });
      LinearizedMotion result;
      result.lambda = pairs.values(kept);
      result.left.resize(kept.size(), A.rows());
      result.right.resize(A.rows(), kept.size());
      result.condition = pairs.reciprocal_condition(kept)
                           .cwiseMax(std::numeric_limits<double>::epsilon())
                           .cwiseInverse();
      for (std::size_t i = 0; i < kept.size(); ++i)
        {
          const Eigen::VectorXcd w = pairs.left.col(kept[i]);
          const Eigen::VectorXcd x = pairs.right.col(kept[i]);
          // A motion at rest (a force that fades, lambda = 0) has no kinetic
          // energy to be scaled by.
          const double moving = x.segment(n, n).norm() / std::sqrt(2.);
          const double size   = moving > 0. ? moving : 1.;
          result.right.col(i) = x / size;
          result.left.row(i)  = size / product_of(w, x) * w.transpose();
        }
      return result;
    }
  } // namespace



  Eigen::VectorXcd
  LinearizedMotion::amplitudes(const SteadySliding   &steady,
                               const Eigen::VectorXd &q,
                               const Eigen::VectorXd &v,
                               const Eigen::VectorXd &forces) const
  {
    Eigen::VectorXd x(left.cols());
    x.head(2 * q.size()) << q - steady.coordinates, v;
    if (left.cols() > 2 * q.size())
      x.tail(left.cols() - 2 * q.size()) =
        (forces - steady.forces)(rows_across);
    return left * x;
  }



  LinearizedMotion
  linearize(const ReducedContactModel &model,
            const SteadySliding       &steady,
            const double               friction,
            const double               speed)
  {
    return linearize(
      model, steady, NodalFriction::uniform(friction, model.n_nodes()), speed);
  }



  LinearizedMotion
  linearize(const ReducedContactModel &model,
            const SteadySliding       &steady,
            const NodalFriction       &friction,
            const double               speed)
  {
    const ClosedRows      rows(steady, friction);
    const Eigen::Index    m = rows.slipping.size(), n = model.n_modes();
    const Eigen::MatrixXd Psi_n = model.participation(rows.kept, Eigen::all),
                          Psi_t = model.participation(rows.along, Eigen::all),
                          Psi_s = model.participation(rows.across, Eigen::all);
    const auto flexibility      = [&](const std::vector<int> &row,
                                 const std::vector<int> &column) {
      return Eigen::MatrixXd(model.flexibility(row, column));
    };
    // mu, p_0 dmu/dv and |V|/(mu p_0) of the slipping nodes.
    const double    least = 1e-6 * steady.resultant()[0] / steady.n_closed();
    Eigen::VectorXd mu(m), by_slip(m), inverse_rate(rows.across.size());
    for (Eigen::Index i = 0, k = 0; i < m; ++i)
      {
        const int j = rows.slipping[i];
        mu[i]       = friction.coefficient[j];
        by_slip[i]  = friction.slope[j] * steady.forces[3 * j];
        if (mu[i] > 0.)
          inverse_rate[k++] = speed * model.speed_ratio[j] /
                              (mu[i] * std::max(steady.forces[3 * j], least));
      }
    // Forces along the sliding follow the normal ones.
    const auto with_friction = [&](const std::vector<int> &row) {
      Eigen::MatrixXd result = flexibility(row, rows.kept);
      result(Eigen::all, rows.normal_of_slipping) +=
        flexibility(row, rows.along) * mu.asDiagonal();
      return result;
    };
    // (G_nn + G_nt mu) lambda_n + G_ns lambda_s + G_nt p_0 mu' slip rate
    // = Psi_n q.
    const Eigen::PartialPivLU<Eigen::MatrixXd> factor(with_friction(rows.kept));
    const Eigen::MatrixXd                      n_by_q = factor.solve(Psi_n);
    const Eigen::MatrixXd                      n_by_s =
      -factor.solve(flexibility(rows.kept, rows.across));
    const Eigen::MatrixXd n_by_slip = -factor.solve(Eigen::MatrixXd(
      flexibility(rows.kept, rows.along) * by_slip.asDiagonal()));
    Eigen::MatrixXd       pulled    = Psi_n;
    pulled(rows.normal_of_slipping, Eigen::all) += mu.asDiagonal() * Psi_t;
    const Eigen::MatrixXd drag = -pulled.transpose();
    const Eigen::MatrixXd v_by_slip =
      drag * n_by_slip - Psi_t.transpose() * by_slip.asDiagonal();
    // u_s = Psi_s q - H lambda_n - G_ss lambda_s, and so along the sliding.
    const Eigen::MatrixXd H = with_friction(rows.across),
                          F = with_friction(rows.along);
    const Eigen::MatrixXd E =
      flexibility(rows.across, rows.across) + H * n_by_s;
    Eigen::MatrixXd slip_by_v = Psi_t - F * n_by_q;

    // States q, v and, with friction, lambda_s = rate d/dt u_s.
    const Eigen::Index n_s  = rows.across.size();
    const Eigen::Index size = 2 * n + n_s;
    Eigen::MatrixXd    A    = Eigen::MatrixXd::Zero(size, size);
    A.block(0, n, n, n).setIdentity();
    A.block(n, 0, n, n) = drag * n_by_q;
    A.block(n, 0, n, n).diagonal() -= model.omega_squared;
    Eigen::MatrixXd s_rate(m, n + n_s), s_by_state(n_s, n + n_s);
    if (n_s > 0)
      {
        s_by_state << Psi_s - H * n_by_q,
          Eigen::MatrixXd((-inverse_rate).asDiagonal());
        // The slip rate along the sliding has a part by d/dt lambda_s.
        s_rate = (F * n_by_s + flexibility(rows.along, rows.across)) *
                 E.partialPivLu().solve(s_by_state);
        slip_by_v -= s_rate.leftCols(n);
        A.block(n, 2 * n, n, n_s) =
          drag * n_by_s - Psi_s.transpose() - v_by_slip * s_rate.rightCols(n_s);
      }
    A.block(n, n, n, n) = v_by_slip * slip_by_v;
    A.block(n, n, n, n).diagonal() -= model.damping;
    if (n_s > 0)
      {
        // What the slope adds to u_s changes with the rate of the slip.
        const Eigen::MatrixXd s_by_slip =
          H * n_by_slip +
          flexibility(rows.across, rows.along) * by_slip.asDiagonal();
        Eigen::MatrixXd rate    = Eigen::MatrixXd::Zero(n_s, size);
        rate.rightCols(n + n_s) = s_by_state;
        rate -= s_by_slip * slip_by_v * A.middleRows(n, n);
        A.bottomRows(n_s) =
          Eigen::MatrixXd(E - s_by_slip * s_rate.rightCols(n_s))
            .partialPivLu()
            .solve(rate);
      }
    LinearizedMotion result = motion_of(A, n);
    result.across           = A.bottomRightCorner(n_s, n_s);
    result.rows_across      = rows.across;
    return result;
  }
} // namespace squeal
