// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/cycle/active_contact.h>
#include <squeal/cycle/period_derivative.h>
#include <squeal/transient/modal_step.h>

namespace squeal
{
  namespace
  {
    /** How a motion changes with its start, column by column. */
    struct Variation
    {
      Eigen::MatrixXd q, v, force;
      Eigen::MatrixXd u, u_before;    /**< three rows a node, a step before */
      ActiveContact   contact;        /**< of the last step */
      Eigen::MatrixXd unknowns;       /**< of that */
      ActiveContact   contact_before; /**< of the step before that */
      Eigen::MatrixXd unknowns_before;
    };

    /** What the steps of an orbit have in common. */
    class Steps
    {
    public:
      Steps(const ReducedContactModel &m, const double step)
        : model(m)
        , modes(m, step)
        , W(modes.delassus(m))
      {
      }

      /** @p kept: nodes whose motion later steps need. */
      void
      advance(const ActiveContact             &c,
              const ChangesInStep             &changes,
              const std::vector<unsigned int> &kept,
              Variation                       &x) const
      {
        Eigen::MatrixXd at_start, at_end;
        move_jumps(changes, x, at_start, at_end);
        std::vector<int> columns;
        if (const Eigen::MatrixXd more =
              added(x.contact, c.weight_before, columns);
            !columns.empty())
          x.force.noalias() += more * x.unknowns(columns, Eigen::all);
        Eigen::MatrixXd q =
          modes.q_q * x.q + modes.q_v * x.v + modes.q_f0 * x.force;
        x.v = modes.v_q * x.q + modes.v_v * x.v + modes.v_f0 * x.force;
        x.q = std::move(q);
        if (at_start.size() > 0)
          {
            x.q += modes.q_f0 * at_start + modes.q_f1 * at_end;
            x.v += modes.v_f0 * at_start + modes.v_f1 * at_end;
          }
        x.contact_before  = x.contact;
        x.unknowns_before = std::move(x.unknowns);
        x.unknowns.resize(0, x.q.cols());
        if (c.size() > 0)
          {
            const Eigen::MatrixXd more = added(c, c.weight_after, columns);
            x.unknowns                 = solve(c, more, columns, x);
            x.force.noalias() =
              -(c.times_forces(model.participation.transpose()) * x.unknowns);
            Eigen::MatrixXd force = x.force;
            if (!columns.empty())
              force.noalias() += more * x.unknowns(columns, Eigen::all);
            x.q += modes.q_f1 * force;
            x.v += modes.v_f1 * force;
          }
        else
          x.force.setZero();
        move_nodes(c, kept, x);
        x.contact = c;
      }

    private:
      /** What the jumps of forces in the step add to those of the modes, as
       * lines: a node that lets go later is held on to for longer. Empty where
       * nothing jumps. */
      void
      move_jumps(const ChangesInStep &changes,
                 const Variation     &x,
                 Eigen::MatrixXd     &at_start,
                 Eigen::MatrixXd     &at_end) const
      {
        for (unsigned int j = 0; j < model.n_nodes(); ++j)
          if (const auto share = changes.release(j))
            {
              const auto [now, before] = changes.release_by_forces(j);
              const auto moved_by      = [&](const Eigen::Vector3d &row,
                                        const ActiveContact   &contact,
                                        const Eigen::MatrixXd &unknowns) {
                return Eigen::RowVectorXd(
                  contact.row_of_forces(j, row).transpose() * unknowns);
              };
              const Eigen::RowVectorXd later =
                moved_by(now, x.contact, x.unknowns) +
                moved_by(before, x.contact_before, x.unknowns_before);
              const Eigen::VectorXd force =
                model.participation.middleRows<3>(3 * j).transpose() *
                changes.jump(j, *share);
              if (at_start.size() == 0)
                at_start = at_end =
                  Eigen::MatrixXd::Zero(x.q.rows(), x.q.cols());
              at_start += (4. - 6. * *share) * force * later;
              at_end += (6. * *share - 2.) * force * later;
            }
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

      /** The unknowns at the end of the step; @p x: what moves without them. */
      Eigen::MatrixXd
      solve(const ActiveContact    &c,
            const Eigen::MatrixXd  &more,
            const std::vector<int> &columns,
            const Variation        &x) const
      {
        const Eigen::MatrixXd Psi = c.rows_of(model.participation);
        Eigen::MatrixXd       A   = c.rows_of(c.times_forces(W));
        if (!columns.empty())
          {
            const Eigen::MatrixXd moved = Psi * (modes.q_f1 * more);
            for (std::size_t k = 0; k < columns.size(); ++k)
              A.col(columns[k]) -= moved.col(k);
          }
        // Nothing moves a node where it is held, and any flexibility serves.
        for (Eigen::Index i = 0; i < c.size(); ++i)
          {
            const auto        &unknown = c.unknowns[i];
            const unsigned int normal  = 3 * unknown.node;
            A(i, i) += is_held_along_face(W, unknown.node, unknown.row)
                         ? W(normal, normal)
                         : unknown.give;
          }
        Eigen::MatrixXd       rhs = Psi * x.q;
        const Eigen::MatrixXd from =
          c.origins.empty() ? Eigen::MatrixXd() : slip_origins(c, x);
        const Eigen::MatrixXd &origin = c.origins.empty() ? x.u : from;
        for (Eigen::Index i = 0; i < c.size(); ++i)
          if (c.unknowns[i].moves_on)
            rhs.row(i) -= c.unknowns[i].row.transpose() *
                          origin.middleRows<3>(3 * c.unknowns[i].node);
        return A.partialPivLu().solve(rhs);
      }

      /** What the slip of the nodes is counted from. */
      static Eigen::MatrixXd
      slip_origins(const ActiveContact &c, const Variation &x)
      {
        Eigen::MatrixXd result = x.u;
        for (const auto &o : c.origins)
          {
            const Eigen::MatrixXd there =
              x.u.middleRows<3>(3 * o.node) +
              o.share * (x.u - x.u_before).middleRows<3>(3 * o.node);
            result.middleRows<3>(3 * o.node) = there;
            result.middleRows<2>(3 * o.node + 1) +=
              o.slip_over_gap * there.row(0);
          }
        return result;
      }

      void
      move_nodes(const ActiveContact             &c,
                 const std::vector<unsigned int> &kept,
                 Variation                       &x) const
      {
        std::vector<int> rows;
        for (const unsigned int j : kept)
          for (const unsigned int t : {0u, 1u, 2u})
            rows.push_back(3 * j + t);
        std::swap(x.u, x.u_before);
        if (rows.empty())
          return;
        Eigen::MatrixXd moved = model.participation(rows, Eigen::all) * x.q;
        if (c.size() > 0)
          moved.noalias() -=
            c.times_forces(model.flexibility(rows, Eigen::all)) * x.unknowns;
        for (std::size_t i = 0; i < rows.size(); ++i)
          x.u.row(rows[i]) = moved.row(i);
      }

      const ReducedContactModel &model;
      const ModalStep            modes;
      const Eigen::MatrixXd      W;
    };

    Variation
    start_of(const ReducedContactModel &model,
             const double               step,
             const std::vector<int>    &rows)
    {
      const Eigen::Index n = model.n_modes(), n_rows = rows.size(),
                         size = 2 * n + n_rows;
      Variation x;
      for (auto *block : {&x.q, &x.v, &x.force})
        *block = Eigen::MatrixXd::Zero(n, size);
      x.u = Eigen::MatrixXd::Zero(3 * model.n_nodes(), size);
      x.q.leftCols(n).setIdentity();
      x.v.middleCols(n, n).setIdentity();
      x.force.rightCols(n_rows) =
        -model.participation(rows, Eigen::all).transpose();
      x.u.leftCols(n)       = model.participation;
      x.u.rightCols(n_rows) = -model.flexibility(Eigen::all, rows);
      // The rates of the forces there are not known.
      x.u_before                  = x.u;
      x.u_before.middleCols(n, n) = -step * model.participation;
      x.contact                   = ActiveContact(rows, model.n_nodes());
      x.unknowns                  = Eigen::MatrixXd::Zero(n_rows, size);
      x.unknowns.rightCols(n_rows).setIdentity();
      x.contact_before  = x.contact;
      x.unknowns_before = x.unknowns;
      return x;
    }

    /** Nodes closed after the steps @p i and the next, whose motions after the
     * step before count. */
    std::vector<unsigned int>
    nodes_that_count(const Orbit &orbit, const unsigned int i)
    {
      std::vector<unsigned int> result;
      const unsigned int        end = std::min(i + 2, orbit.n_steps());
      for (unsigned int j = 0; i < end && j < orbit.status[i].size(); ++j)
        for (unsigned int k = i; k < end; ++k)
          if (orbit.status[k][j] != ContactStatus::open)
            {
              result.push_back(j);
              break;
            }
      return result;
    }

    /** Of step @p i; a node that slips in no other step than that in which it
     * closes sticks from there: so small a slip is what the place of the
     * closing is off. */
    std::vector<ContactStatus>
    settled_status(const Orbit       &orbit,
                   const unsigned int i,
                   const ContactPast &past)
    {
      std::vector<ContactStatus> result = orbit.status[i];
      const auto                &next = orbit.status[(i + 1) % orbit.n_steps()];
      for (std::size_t j = 0; past.is_known() && j < result.size(); ++j)
        if (past.status[j] == ContactStatus::open &&
            result[j] == ContactStatus::slip && next[j] == ContactStatus::stick)
          result[j] = ContactStatus::stick;
      return result;
    }
  } // namespace



  Eigen::MatrixXd
  period_derivative(const ReducedContactModel &model,
                    const CycleFriction       &friction,
                    const Orbit               &orbit,
                    const std::vector<int>    &rows,
                    const StatusChanges        kind)
  {
    Variation   x = start_of(model, orbit.step, rows);
    const Steps steps(model, orbit.step);
    for (unsigned int i = 0; i < orbit.n_steps(); ++i)
      {
        const ContactPast   past = orbit.past_of(i);
        const ChangesInStep changes(model,
                                    friction,
                                    orbit.step,
                                    orbit.states[i].forces,
                                    orbit.motions[i],
                                    past);
        Eigen::VectorXd     slip = orbit.motions[i + 1] - orbit.motions[i];
        for (unsigned int j = 0; j < model.n_nodes(); ++j)
          {
            slip[3 * j + 1] +=
              orbit.step * friction.speed * model.speed_ratio[j];
            slip.segment<2>(3 * j + 1) -=
              orbit.corrections.slip[i].segment<2>(2 * j);
          }
        const std::vector<ContactStatus> status =
          kind == StatusChanges::located ? settled_status(orbit, i, past)
                                         : orbit.status[i];
        ActiveContact contact(
          status, orbit.states[i + 1].forces, slip, friction.kinetic);
        if (kind == StatusChanges::located)
          contact.locate(changes, status, model.flexibility);
        steps.advance(contact, changes, nodes_that_count(orbit, i + 1), x);
      }
    Eigen::MatrixXd result(2 * model.n_modes() + rows.size(), x.q.cols());
    result << x.q, x.v, x.contact.forces(x.unknowns)(rows, Eigen::all);
    return result;
  }
} // namespace squeal
