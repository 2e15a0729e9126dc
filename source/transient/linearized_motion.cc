// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/eigen/standard_pairs.h>
#include <squeal/transient/linearized_motion.h>

#include "contact_factor.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace squeal
{
  namespace
  {
    /** A node whose friction rises with the slip rate: a dashpot along the
     * sliding, and in a pair at rest, where friction rises from zero, against
     * slip of any direction. */
    bool
    is_damped(const NodalFriction &friction, const int j)
    {
      return friction.slope[j] > 0.;
    }

    /** Rows of all nodal forces and motions, by what the nodes do. */
    struct ClosedRows
    {
      ClosedRows(const SteadySliding       &steady,
                 const NodalFriction       &friction,
                 const ReducedContactModel &model)
      {
        for (std::size_t j = 0; j < steady.status.size(); ++j)
          switch (steady.status[j])
            {
            case ContactStatus::open:
              break;
            case ContactStatus::stick:
              for (unsigned int c = 0; c < 3; ++c)
                add(model, j, c, kept, kept);
              break;
            case ContactStatus::slip:
              slipping.push_back(j);
              normal_of_slipping.push_back(kept.size());
              kept.push_back(3 * j);
              along.push_back(3 * j + 1);
              if (is_damped(friction, j))
                add(model, j, 1, viscous, viscous_in_modes);
              if (friction.coefficient[j] > 0. || is_damped(friction, j))
                add(model, j, 2, viscous, viscous_in_modes);
              break;
            }
      }

      /** To @p flexible where forces move the node in direction @p c on the
       * flexibility, to @p rigid where the modes alone do, and to neither where
       * it is held. */
      static void
      add(const ReducedContactModel &model,
          const unsigned int         j,
          const unsigned int         c,
          std::vector<int>          &flexible,
          std::vector<int>          &rigid)
      {
        const Eigen::Vector3d direction = Eigen::Vector3d::Unit(c);
        if (!is_held_along_face(model.flexibility, j, direction))
          flexible.push_back(3 * j + c);
        else if (!is_held_along_face(model, j, direction))
          rigid.push_back(3 * j + c);
      }

      std::vector<int> slipping; /**< nodes */
      /** Motions that stay: the normal one of slipping nodes, all three of
       * sticking ones, as far as nothing else holds them. */
      std::vector<int> kept;
      std::vector<int> normal_of_slipping; /**< places among them */
      std::vector<int> along;              /**< of slipping nodes */
      /** Directions in which a slipping node that is free to move there is a
       * dashpot, on the flexibility and in the modes alone: across the sliding
       * of those with friction, along it of those whose friction rises. */
      std::vector<int> viscous, viscous_in_modes;
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
      {
        const Eigen::VectorXd more = forces - steady.forces;
        for (std::size_t i = 0; i < rows_viscous.size(); ++i)
          x[2 * q.size() + i] =
            more[rows_viscous[i]] -
            limit_by_normal[i] * more[rows_viscous[i] / 3 * 3];
      }
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



  namespace
  {
    /** Blocks of the flexibility and of the participation at closed nodes, and
     * what the laws of the slipping ones say there. */
    struct ClosedContact
    {
      ClosedContact(const ReducedContactModel &m,
                    const SteadySliding       &steady,
                    const NodalFriction       &friction,
                    const double               speed)
        : model(m)
        , rows(steady, friction, m)
        , G(m.flexibility)
        , mu(rows.slipping.size())
        , by_slip(rows.slipping.size())
        , inverse_rate(rows.viscous.size())
        , dashpots(rows.viscous_in_modes.size())
      {
        if (const Eigen::MatrixXd fill = fill_of_null_space(m); fill.size() > 0)
          G += fill;
        for (Eigen::Index i = 0; i < mu.size(); ++i)
          {
            const int j = rows.slipping[i];
            mu[i]       = friction.coefficient[j];
            by_slip[i] = std::min(0., friction.slope[j]) * steady.forces[3 * j];
          }
        factor =
          ContactFactor(with_friction(rows.kept), rounding_of_flexibility(m));
        const double least = 1e-6 * steady.resultant()[0] / steady.n_closed();
        const auto   inverse_rate_of = [&](const int row) {
          const int    j     = row / 3;
          const double force = std::max(steady.forces[3 * j], least);
          const bool   rises = row % 3 == 1 || friction.coefficient[j] == 0.;
          return rises ? 1. / (friction.slope[j] * force)
                         : speed * model.speed_ratio[j] /
                           (friction.coefficient[j] * force);
        };
        for (Eigen::Index k = 0; k < inverse_rate.size(); ++k)
          inverse_rate[k] = inverse_rate_of(rows.viscous[k]);
        for (Eigen::Index k = 0; k < dashpots.size(); ++k)
          dashpots[k] = 1. / inverse_rate_of(rows.viscous_in_modes[k]);
      }

      Eigen::MatrixXd
      participation(const std::vector<int> &row) const
      {
        return model.participation(row, Eigen::all);
      }

      Eigen::MatrixXd
      flexibility(const std::vector<int> &row,
                  const std::vector<int> &column) const
      {
        return G(row, column);
      }

      /** Forces along the sliding follow the normal ones. */
      Eigen::MatrixXd
      with_friction(const std::vector<int> &row) const
      {
        Eigen::MatrixXd result = flexibility(row, rows.kept);
        result(Eigen::all, rows.normal_of_slipping) +=
          flexibility(row, rows.along) * mu.asDiagonal();
        return result;
      }

      /** What forces at the kept rows, with their friction, act on. */
      Eigen::MatrixXd
      pulled() const
      {
        Eigen::MatrixXd result = participation(rows.kept);
        result(rows.normal_of_slipping, Eigen::all) +=
          mu.asDiagonal() * participation(rows.along);
        return result;
      }

      const ReducedContactModel &model;
      const ClosedRows           rows;
      /** The flexibility, and some where nothing moves along the face, m/N. */
      Eigen::MatrixXd G;
      /** mu and, where it falls, p_0 dmu/dv of the slipping nodes; of the rows
       * `viscous`, |V|/(mu p_0) across the sliding and 1/(p_0 dmu/dv) along it
       * and at rest; N s/m, the inverse of that of `viscous_in_modes`. */
      Eigen::VectorXd mu, by_slip, inverse_rate, dashpots;
      /** Of the flexibility with friction of the kept rows. */
      ContactFactor factor;
    };

    /** Normal and sticking forces that keep the kept motions at rest:
     * lambda_n = by_q q + by_s lambda_s + by_slip (slip rate), from
     * (G_nn + G_nt mu) lambda_n + G_ns lambda_s + G_nt p_0 mu' slip rate
     * = Psi_n q, those that the flexibility feels. */
    struct KeptForces
    {
      explicit KeptForces(const ClosedContact &c)
      {
        by_q    = c.factor.solve(c.participation(c.rows.kept));
        by_s    = -c.factor.solve(c.flexibility(c.rows.kept, c.rows.viscous));
        by_slip = -c.factor.solve(Eigen::MatrixXd(
          c.flexibility(c.rows.kept, c.rows.along) * c.by_slip.asDiagonal()));
      }

      Eigen::MatrixXd by_q, by_s, by_slip;
    };

    /** @p E, m/N, what dashpots give way by their forces. Where that is rounding,
     * each gets a spring so stiff that it follows a millionth of the time of
     * the cut-off behind: without one its force would be no state. */
    Eigen::MatrixXd
    with_springs_of_dashpots(const ClosedContact &c, Eigen::MatrixXd E)
    {
      const double share = 1e-6 / (2. * M_PI * c.model.cut_off);
      if (!ContactFactor(E, rounding_of_flexibility(c.model)).is_regular())
        E.diagonal() += share * c.inverse_rate;
      return E;
    }

    /** A of x' = A x with the states q, v and, with friction, lambda_s = rate
     * d/dt u_s, where u_s = Psi_s q - H lambda_n - G_ss lambda_s, and so along
     * the sliding. */
    Eigen::MatrixXd
    state_matrix(const ClosedContact &c)
    {
      const ClosedRows     &rows = c.rows;
      const Eigen::Index    n    = c.model.n_modes();
      const KeptForces      normal(c);
      const Eigen::MatrixXd Psi_t = c.participation(rows.along),
                            Psi_s = c.participation(rows.viscous);
      const Eigen::MatrixXd drag  = -c.pulled().transpose();
      const Eigen::MatrixXd v_by_slip =
        drag * normal.by_slip - Psi_t.transpose() * c.by_slip.asDiagonal();
      const Eigen::MatrixXd H = c.with_friction(rows.viscous),
                            F = c.with_friction(rows.along);
      const Eigen::MatrixXd E = with_springs_of_dashpots(
        c, c.flexibility(rows.viscous, rows.viscous) + H * normal.by_s);
      Eigen::MatrixXd slip_by_v = Psi_t - F * normal.by_q;

      const Eigen::Index n_s  = rows.viscous.size();
      const Eigen::Index size = 2 * n + n_s;
      Eigen::MatrixXd    A    = Eigen::MatrixXd::Zero(size, size);
      A.block(0, n, n, n).setIdentity();
      A.block(n, 0, n, n) = drag * normal.by_q;
      A.block(n, 0, n, n).diagonal() -= c.model.omega_squared;
      if (n_s > 0)
        {
          Eigen::MatrixXd s_by_state(n_s, n + n_s);
          s_by_state << Psi_s - H * normal.by_q,
            Eigen::MatrixXd((-c.inverse_rate).asDiagonal());
          A.bottomRightCorner(n_s, n + n_s) =
            E.partialPivLu().solve(s_by_state);
          // The slip rate along the sliding has a part by d/dt lambda_s.
          const Eigen::MatrixXd s_rate =
            (F * normal.by_s + c.flexibility(rows.along, rows.viscous)) *
            A.bottomRightCorner(n_s, n + n_s);
          slip_by_v -= s_rate.leftCols(n);
          A.block(n, 2 * n, n, n_s) = drag * normal.by_s - Psi_s.transpose() -
                                      v_by_slip * s_rate.rightCols(n_s);
        }
      A.block(n, n, n, n) = v_by_slip * slip_by_v;
      A.block(n, n, n, n).diagonal() -= c.model.damping;
      if (c.model.has_coupled_damping())
        A.block(n, n, n, n) -= c.model.damping_coupling;
      if (c.dashpots.size() > 0)
        {
          const Eigen::MatrixXd Psi_d = c.participation(rows.viscous_in_modes);
          A.block(n, n, n, n) -=
            Psi_d.transpose() * c.dashpots.asDiagonal() * Psi_d;
        }
      return A;
    }

    /** The motions that are left where the modes, and not the flexibility, keep
     * something: x = states y, y' = equations A states y. */
    struct KeptByModes
    {
      KeptByModes(const ClosedContact &c, const Eigen::Index size)
      {
        // C q = 0 by forces R m, which friction turns: they take what C sees.
        const Eigen::Index    n = c.model.n_modes();
        const Eigen::MatrixXd C = c.factor.left_null_space().transpose() *
                                  c.participation(c.rows.kept),
                              R =
                                c.pulled().transpose() * c.factor.null_space();
        const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> factor(C.transpose());
        const Eigen::MatrixXd whole = factor.householderQ();
        const Eigen::MatrixXd Q     = whole.rightCols(n - factor.rank());
        const Eigen::MatrixXd forces =
          Q.transpose() * R *
          Eigen::MatrixXd(C * R).completeOrthogonalDecomposition().solve(C);
        const Eigen::Index rest = size - 2 * n;
        states      = Eigen::MatrixXd::Zero(size, 2 * Q.cols() + rest);
        equations   = Eigen::MatrixXd::Zero(2 * Q.cols() + rest, size);
        n_positions = Q.cols();
        states.block(0, 0, n, n_positions)           = Q;
        states.block(n, n_positions, n, n_positions) = Q;
        equations.block(0, 0, n_positions, n)        = Q.transpose();
        equations.block(n_positions, n, n_positions, n) =
          Q.transpose() - forces;
        states.bottomRightCorner(rest, rest).setIdentity();
        equations.bottomRightCorner(rest, rest).setIdentity();
      }

      Eigen::MatrixXd states, equations;
      unsigned int    n_positions;
    };

    /** What a relative change of the slopes dmu/dv that are negative adds to A,
     * over it. */
    Eigen::MatrixXd
    change_by_slope(const ReducedContactModel &model,
                    const SteadySliding       &steady,
                    const NodalFriction       &friction,
                    const double               speed)
    {
      // Across the sliding A is not linear in them.
      constexpr double increment = 1e-3;
      const auto       matrix    = [&](const double factor) {
        NodalFriction other = friction;
        other.slope =
          (other.slope.array() < 0.).select(factor * other.slope, other.slope);
        return state_matrix(ClosedContact(model, steady, other, speed));
      };
      return (matrix(1. + increment) - matrix(1. - increment)) /
             (2. * increment);
    }

    /** What a relative change of the dashpots adds to every eigenvalue of @p A,
     * over it: those on the flexibility divide the rates of their forces, those
     * in the modes damp these. */
    Eigen::VectorXcd
    change_by_viscosity(const ClosedContact    &c,
                        const Eigen::MatrixXd  &A,
                        const LinearizedMotion &linear)
    {
      const Eigen::Index     n = c.model.n_modes(), n_s = c.rows.viscous.size();
      const Eigen::MatrixXd  Psi = c.participation(c.rows.viscous_in_modes);
      const auto             v = Eigen::seqN(n, n), s = Eigen::seqN(2 * n, n_s);
      const Eigen::MatrixXcd at_v = Psi * linear.right(v, Eigen::all);
      const Eigen::MatrixXcd by_v =
        (linear.left(Eigen::all, v) * Psi.transpose()) *
        c.dashpots.asDiagonal();
      return -(by_v.cwiseProduct(at_v.transpose()).rowwise().sum() +
               (linear.left(Eigen::all, s) * A(s, s))
                 .cwiseProduct(linear.right(s, Eigen::all).transpose())
                 .rowwise()
                 .sum());
    }
  } // namespace



  LinearizedMotion
  linearize(const ReducedContactModel &model,
            const SteadySliding       &steady,
            const NodalFriction       &friction,
            const double               speed)
  {
    const ClosedContact   closed(model, steady, friction, speed);
    const Eigen::MatrixXd A = state_matrix(closed);
    LinearizedMotion      result;
    if (closed.factor.is_regular())
      result = motion_of(A, model.n_modes());
    else
      {
        const KeptByModes kept(closed, A.rows());
        result = motion_of(kept.equations * A * kept.states, kept.n_positions);
        result.left  = (result.left * kept.equations).eval();
        result.right = (kept.states * result.right).eval();
      }
    const Eigen::Index n_s = closed.rows.viscous.size();
    result.by_viscosity    = change_by_viscosity(closed, A, result);
    result.rows_viscous    = closed.rows.viscous;
    result.limit_by_normal = Eigen::VectorXd::Zero(n_s);
    for (Eigen::Index i = 0; i < n_s; ++i)
      if (const int row = result.rows_viscous[i]; row % 3 == 1)
        result.limit_by_normal[i] = friction.coefficient[row / 3];
    result.by_slope = Eigen::VectorXcd::Zero(result.lambda.size());
    if ((friction.slope.array() < 0.).any())
      result.by_slope =
        (result.left * change_by_slope(model, steady, friction, speed))
          .cwiseProduct(result.right.transpose())
          .rowwise()
          .sum();
    return result;
  }



  Eigen::VectorXcd
  reduction_error(const ReducedContactModel &model,
                  const SteadySliding       &steady,
                  const NodalFriction       &friction,
                  const double               speed,
                  const LinearizedMotion    &linear)
  {
    // Of the matrices, in which the state matrix is not linear.
    constexpr double      increment = 1e-5;
    const Eigen::MatrixXd A =
      state_matrix(ClosedContact(model, steady, friction, speed));
    ReducedContactModel other = model;
    // Of every eigenvalue for a change of the flexibility or participation.
    const auto derivative = [&](Eigen::MatrixXd ReducedContactModel::*matrix,
                                const Eigen::MatrixXd                &change) {
      Eigen::VectorXcd result = Eigen::VectorXcd::Zero(linear.lambda.size());
      if (change.size() == 0 || change.isZero(0.))
        return result;
      const double share = increment * (model.*matrix).norm() / change.norm();
      other.*matrix      = model.*matrix + share * change;
      const Eigen::MatrixXd changed =
        state_matrix(ClosedContact(other, steady, friction, speed)) - A;
      result = (linear.left * changed)
                 .cwiseProduct(linear.right.transpose())
                 .rowwise()
                 .sum() /
               share;
      other.*matrix = model.*matrix;
      return result;
    };
    constexpr auto G               = &ReducedContactModel::flexibility,
                   Psi             = &ReducedContactModel::participation;
    const Eigen::VectorXcd by_rate = derivative(G, model.residual_damping) +
                                     derivative(Psi, model.residual_coupling),
                           by_accel = derivative(G, model.residual_inertia);
    return -linear.lambda.cwiseProduct(by_rate +
                                       linear.lambda.cwiseProduct(by_accel));
  }
} // namespace squeal
