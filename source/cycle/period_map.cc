// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/cycle/period_map.h>

#include <algorithm>
#include <cmath>

namespace squeal
{
  namespace
  {
    TransientDrive
    constant_drive(const double friction, const double speed)
    {
      TransientDrive d;
      d.friction = [friction](double) { return friction; };
      d.speed    = [speed](double) { return speed; };
      d.load     = [](double) { return 1.; };
      return d;
    }

    /**
     * The unknowns of the closed nodes of a step: lambda = Q x, and the rows R
     * of the motion that they answer to. A slipping node has its normal force,
     * which friction follows, and the force across its slip; one that sticks
     * has all three.
     */
    struct ActiveContact
    {
      struct Unknown
      {
        unsigned int    node;
        Eigen::Vector3d force;    /**< by a unit of it */
        Eigen::Vector3d row;      /**< of the motion */
        double          give;     /**< added to the diagonal, m/N */
        bool            moves_on; /**< counts from the motion before */
      };
      std::vector<Unknown> unknowns;
      /** Of every node, what its forces at the start and at the end of the step
       * count by, over those of a straight line. */
      Eigen::VectorXd weight_before, weight_after;

      ActiveContact() = default;
      ActiveContact(const std::vector<ContactStatus> &status,
                    const Eigen::VectorXd            &forces,
                    const Eigen::VectorXd            &slip,
                    const Eigen::VectorXd            &friction)
      {
        weight_before = weight_after = Eigen::VectorXd::Ones(status.size());
        for (unsigned int j = 0; j < status.size(); ++j)
          switch (status[j])
            {
            case ContactStatus::open:
              break;
            case ContactStatus::stick:
              for (unsigned int c = 0; c < 3; ++c)
                unknowns.push_back({j,
                                    Eigen::Vector3d::Unit(c),
                                    Eigen::Vector3d::Unit(c),
                                    0.,
                                    c > 0});
              break;
            case ContactStatus::slip:
              add_slipping(
                j, forces[3 * j], slip.segment<2>(3 * j + 1), friction[j]);
              break;
            }
      }

      void
      add_slipping(const unsigned int     j,
                   const double           normal,
                   const Eigen::Vector2d &slip,
                   const double           mu)
      {
        const double          size = slip.norm();
        const Eigen::Vector2d d =
          size > 0. ? Eigen::Vector2d(slip / size) : Eigen::Vector2d(1., 0.);
        unknowns.push_back(
          {j, {1., mu * d[0], mu * d[1]}, Eigen::Vector3d::Unit(0), 0., false});
        if (mu > 0. && normal > 0.)
          unknowns.push_back({j,
                              {0., -d[1], d[0]},
                              {0., -d[1], d[0]},
                              size / (mu * normal),
                              true});
      }

      /** A node that closes or opens within the step. A disturbance of its
       * force jumps there, from nothing or to nothing, where a straight line
       * over the step has half of it: the weights are those of the part of the
       * step in which it is closed, found by following the gap, or the force,
       * of the step before. */
      void
      locate_changes(const Orbit           &orbit,
                     const unsigned int     i,
                     const Eigen::VectorXd &initial_gap)
      {
        const unsigned int n      = orbit.n_steps();
        const auto        &before = orbit.status[(i + n - 1) % n],
                   &now           = orbit.status[i];
        // The step before that of the first one is the last.
        const unsigned int last = i > 0 ? i - 1 : n - 1;
        const auto         part = [](const double value, const double change) {
          return change < 0. ? std::min(1., -value / change) : .5;
        };
        for (unsigned int j = 0; j < now.size(); ++j)
          {
            const bool was_open = before[j] == ContactStatus::open,
                       is_open  = now[j] == ContactStatus::open;
            if (was_open && !is_open)
              {
                const double gap = initial_gap[j] - orbit.motions[i][3 * j];
                weight_after[j] =
                  2. * (1. - part(std::max(gap, 0.),
                                  orbit.motions[last][3 * j] -
                                    orbit.motions[last + 1][3 * j]));
              }
            else if (!was_open && is_open)
              weight_before[j] =
                2. * part(orbit.states[i].forces[3 * j],
                          orbit.states[last + 1].forces[3 * j] -
                            orbit.states[last].forces[3 * j]);
          }
      }

      Eigen::Index
      size() const
      {
        return unknowns.size();
      }

      /** A Q, A with three columns a node. */
      Eigen::MatrixXd
      times_forces(const Eigen::MatrixXd &A) const
      {
        Eigen::MatrixXd result(A.rows(), size());
        for (Eigen::Index i = 0; i < size(); ++i)
          result.col(i) =
            A.middleCols<3>(3 * unknowns[i].node) * unknowns[i].force;
        return result;
      }

      /** R A, A with three rows a node. */
      Eigen::MatrixXd
      rows_of(const Eigen::MatrixXd &A) const
      {
        Eigen::MatrixXd result(size(), A.cols());
        for (Eigen::Index i = 0; i < size(); ++i)
          result.row(i) =
            unknowns[i].row.transpose() * A.middleRows<3>(3 * unknowns[i].node);
        return result;
      }
    };

    /** How a motion changes with its start, column by column. */
    struct Variation
    {
      Eigen::MatrixXd q, v, force;
      Eigen::MatrixXd u;        /**< three rows a node */
      ActiveContact   contact;  /**< of the last step */
      Eigen::MatrixXd unknowns; /**< of that */
    };

    /** What the steps of an orbit have in common. */
    struct Steps
    {
      const ReducedContactModel &model;
      const ModalStep            modes;
      const Eigen::MatrixXd      W;

      Steps(const ReducedContactModel &m, const double step)
        : model(m)
        , modes(m, step)
        , W(modes.delassus(m))
      {
      }

      /** What @p weight of each node beside 1 adds to the modes' forces, -Psi^T
       * Q diag(weight - 1) and the columns that it has. */
      Eigen::MatrixXd
      added(const ActiveContact   &c,
            const Eigen::VectorXd &weight,
            std::vector<int>      &columns) const
      {
        columns.clear();
        for (Eigen::Index i = 0; i < c.size(); ++i)
          if (weight[c.unknowns[i].node] != 1.)
            columns.push_back(i);
        Eigen::MatrixXd result(model.n_modes(), columns.size());
        for (std::size_t k = 0; k < columns.size(); ++k)
          {
            const auto &x = c.unknowns[columns[k]];
            result.col(k) =
              (1. - weight[x.node]) *
              (model.participation.middleRows<3>(3 * x.node).transpose() *
               x.force);
          }
        return result;
      }

      /** @p next: nodes that are closed in the step after. */
      void
      advance(const ActiveContact             &c,
              const std::vector<unsigned int> &next,
              Variation                       &x) const
      {
        std::vector<int> columns;
        if (const Eigen::MatrixXd more =
              added(x.contact, c.weight_before, columns);
            !columns.empty())
          x.force.noalias() += more * x.unknowns(columns, Eigen::all);
        Eigen::MatrixXd q = modes.q_q.asDiagonal() * x.q +
                            modes.q_v.asDiagonal() * x.v +
                            modes.q_f0.asDiagonal() * x.force;
        x.v = modes.v_q.asDiagonal() * x.q + modes.v_v.asDiagonal() * x.v +
              modes.v_f0.asDiagonal() * x.force;
        x.q = std::move(q);
        x.unknowns.resize(0, x.q.cols());
        if (c.size() > 0)
          {
            const Eigen::MatrixXd Psi  = c.rows_of(model.participation);
            const Eigen::MatrixXd more = added(c, c.weight_after, columns);
            Eigen::MatrixXd       A    = c.rows_of(c.times_forces(W));
            if (!columns.empty())
              {
                const Eigen::MatrixXd moved =
                  Psi * (modes.q_f1.asDiagonal() * more);
                for (std::size_t k = 0; k < columns.size(); ++k)
                  A.col(columns[k]) -= moved.col(k);
              }
            for (Eigen::Index i = 0; i < c.size(); ++i)
              A(i, i) += c.unknowns[i].give;
            Eigen::MatrixXd rhs = Psi * x.q;
            for (Eigen::Index i = 0; i < c.size(); ++i)
              if (c.unknowns[i].moves_on)
                rhs.row(i) -= c.unknowns[i].row.transpose() *
                              x.u.middleRows<3>(3 * c.unknowns[i].node);
            x.unknowns = A.partialPivLu().solve(rhs);
            x.force.noalias() =
              -(c.times_forces(model.participation.transpose()) * x.unknowns);
            Eigen::MatrixXd force = x.force;
            if (!columns.empty())
              force.noalias() += more * x.unknowns(columns, Eigen::all);
            x.q += modes.q_f1.asDiagonal() * force;
            x.v += modes.v_f1.asDiagonal() * force;
          }
        else
          x.force.setZero();
        move_nodes(c, next, x);
        x.contact = c;
      }

      /** Motions along the surface of the nodes that are closed next: others
       * have no memory of them. */
      void
      move_nodes(const ActiveContact             &c,
                 const std::vector<unsigned int> &next,
                 Variation                       &x) const
      {
        if (next.empty())
          return;
        std::vector<int> rows;
        for (const unsigned int j : next)
          for (const unsigned int t : {1u, 2u})
            rows.push_back(3 * j + t);
        Eigen::MatrixXd moved = model.participation(rows, Eigen::all) * x.q;
        if (c.size() > 0)
          moved.noalias() -=
            c.times_forces(model.flexibility(rows, Eigen::all)) * x.unknowns;
        for (std::size_t i = 0; i < rows.size(); ++i)
          x.u.row(rows[i]) = moved.row(i);
      }
    };

    std::vector<unsigned int>
    closed_nodes(const std::vector<ContactStatus> &status)
    {
      std::vector<unsigned int> result;
      for (unsigned int j = 0; j < status.size(); ++j)
        if (status[j] != ContactStatus::open)
          result.push_back(j);
      return result;
    }
  } // namespace



  PeriodMap::PeriodMap(const ReducedContactModel &m,
                       const double               mu,
                       const double               v,
                       const double               force,
                       const double               t)
    : model(m)
    , drive(constant_drive(mu, v))
    , friction(Eigen::VectorXd::Constant(m.n_nodes(), mu))
    , speed(v)
    , nodal_force(force)
    , tolerance(t)
  {
  }

  PeriodMap::PeriodMap(const ReducedContactModel          &m,
                       std::shared_ptr<const FrictionLaws> laws,
                       const double                        v,
                       const double                        force,
                       const double                        t)
    : PeriodMap(m, 0., v, force, t)
  {
    if (!laws->is_constant())
      throw InputError("periodic motions need one coefficient of friction at "
                       "all slip rates");
    friction   = laws->at_rest(m.n_nodes());
    drive.laws = std::move(laws);
  }



  Orbit
  PeriodMap::run(const MotionState &start,
                 const double       time,
                 const unsigned int n_steps) const
  {
    Orbit orbit;
    orbit.step = time / n_steps;
    ReducedTransient motion(model, orbit.step, drive, nodal_force, tolerance);
    motion.start(start.coordinates, start.velocities, start.forces);
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
    orbit.ledger = motion.ledger();
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
                        const Changes           changes) const
  {
    const Eigen::Index n = model.n_modes(), n_rows = rows.size(),
                       size = 2 * n + n_rows, n_contact = 3 * model.n_nodes();
    Variation x;
    for (auto *block : {&x.q, &x.v, &x.force})
      *block = Eigen::MatrixXd::Zero(n, size);
    x.u = Eigen::MatrixXd::Zero(n_contact, size);
    x.q.leftCols(n).setIdentity();
    x.v.middleCols(n, n).setIdentity();
    x.force.rightCols(n_rows) =
      -model.participation(rows, Eigen::all).transpose();
    x.u.leftCols(n)       = model.participation;
    x.u.rightCols(n_rows) = -model.flexibility(Eigen::all, rows);
    for (const int row : rows)
      x.contact.unknowns.push_back({static_cast<unsigned int>(row / 3),
                                    Eigen::Vector3d::Unit(row % 3),
                                    Eigen::Vector3d::Unit(row % 3),
                                    0.,
                                    false});
    x.unknowns = Eigen::MatrixXd::Zero(n_rows, size);
    x.unknowns.rightCols(n_rows).setIdentity();
    const Steps steps(model, orbit.step);
    for (unsigned int i = 0; i < orbit.n_steps(); ++i)
      {
        Eigen::VectorXd slip = orbit.motions[i + 1] - orbit.motions[i];
        for (unsigned int j = 0; j < model.n_nodes(); ++j)
          slip[3 * j + 1] += orbit.step * speed * model.speed_ratio[j];
        ActiveContact contact(
          orbit.status[i], orbit.states[i + 1].forces, slip, friction);
        if (changes == Changes::located)
          contact.locate_changes(orbit, i, model.initial_gap);
        steps.advance(contact,
                      i + 1 == orbit.n_steps()
                        ? std::vector<unsigned int>()
                        : closed_nodes(orbit.status[i + 1]),
                      x);
      }
    Eigen::MatrixXd lambda = Eigen::MatrixXd::Zero(n_contact, size);
    for (Eigen::Index i = 0; i < x.contact.size(); ++i)
      lambda.middleRows<3>(3 * x.contact.unknowns[i].node) +=
        x.contact.unknowns[i].force * x.unknowns.row(i);
    Eigen::MatrixXd result(size, size);
    result << x.q, x.v, lambda(rows, Eigen::all);
    return result;
  }



  Eigen::VectorXd
  PeriodMap::acceleration(const MotionState &state) const
  {
    return model.load - model.participation.transpose() * state.forces -
           model.damping.cwiseProduct(state.velocities) -
           model.omega_squared.cwiseProduct(state.coordinates);
  }
} // namespace squeal
