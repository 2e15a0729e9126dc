// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/transient/contact_solver.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace squeal
{
  namespace
  {
    constexpr unsigned int maximum_iterations = 40;
    constexpr unsigned int maximum_rounds     = 60;
    constexpr unsigned int sweeps_per_round   = 20;
    /** A kept factor that contracts less than this is renewed. */
    constexpr double worth_keeping = 0.2;
  } // namespace



  /** The forces that the law gives one node for forces and motion tried. */
  struct ContactSolver::Projection
  {
    ContactStatus   status;
    double          normal; /**< lambda_n - rho g, N */
    Eigen::Vector2d tried;  /**< lambda_t + rho slip, N */
    Eigen::Vector3d forces; /**< allowed */
  };



  ContactSolver::ContactSolver(Eigen::MatrixXd delassus,
                               Eigen::VectorXd initial_gap,
                               Eigen::VectorXd speed_ratio,
                               const double    force,
                               const double    t)
    : W(std::move(delassus))
    , gap(std::move(initial_gap))
    , ratio(std::move(speed_ratio))
    , mean_force(force)
    , tolerance(t)
    , rho_normal(gap.size())
    , rho_tangential(gap.size())
    , violation(Eigen::VectorXd::Zero(W.rows()))
    , states(gap.size(), ContactStatus::open)
  {
    for (Eigen::Index j = 0; j < gap.size(); ++j)
      {
        rho_normal[j] = 1. / W(3 * j, 3 * j);
        rho_tangential[j] =
          1. / std::max(W(3 * j + 1, 3 * j + 1), W(3 * j + 2, 3 * j + 2));
      }
  }



  ContactSolver::Projection
  ContactSolver::project(const ContactStep     &step,
                         const Eigen::VectorXd &lambda,
                         const unsigned int     j) const
  {
    Projection p;
    p.normal = lambda[3 * j] - rho_normal[j] * (gap[j] - u[3 * j]);
    p.forces.setZero();
    p.tried.setZero();
    if (p.normal <= 0.)
      {
        p.status = ContactStatus::open;
        return p;
      }
    Eigen::Vector2d slip =
      u.segment<2>(3 * j + 1) - step.previous_motion.segment<2>(3 * j + 1);
    slip[0] += step.duration * step.speed * ratio[j];
    p.tried           = lambda.segment<2>(3 * j + 1) + rho_tangential[j] * slip;
    const double size = p.tried.norm(), limit = step.friction * p.normal;
    p.forces[0] = p.normal;
    p.status    = size > limit ? ContactStatus::slip : ContactStatus::stick;
    if (size > limit)
      p.forces.tail<2>() = limit / size * p.tried;
    else
      p.forces.tail<2>() = p.tried;
    return p;
  }



  double
  ContactSolver::evaluate(const ContactStep     &step,
                          const Eigen::VectorXd &lambda)
  {
    u = step.free_motion;
    u.noalias() -= W * lambda;
    double worst = 0.;
    for (Eigen::Index j = 0; j < gap.size(); ++j)
      {
        const Projection p          = project(step, lambda, j);
        states[j]                   = p.status;
        violation.segment<3>(3 * j) = lambda.segment<3>(3 * j) - p.forces;
        worst =
          std::max(worst, violation.segment<3>(3 * j).cwiseAbs().maxCoeff());
      }
    return worst / mean_force;
  }



  void
  ContactSolver::factorize(const ContactStep     &step,
                           const Eigen::VectorXd &lambda)
  {
    closed.clear();
    for (Eigen::Index j = 0; j < gap.size(); ++j)
      if (states[j] != ContactStatus::open)
        for (int c = 0; c < 3; ++c)
          closed.push_back(3 * j + c);
    factored_states         = states;
    const Eigen::Index    n = closed.size();
    Eigen::MatrixXd       J(n, n);
    const Eigen::MatrixXd closed_W = W(closed, closed);
    for (Eigen::Index i = 0; i < n; i += 3)
      {
        const int        j     = closed[i] / 3;
        const double     rho_n = rho_normal[j], rho_t = rho_tangential[j];
        const Projection p = project(step, lambda, j);
        J.row(i)           = rho_n * closed_W.row(i);
        if (p.status == ContactStatus::stick)
          {
            J.middleRows(i + 1, 2) = rho_t * closed_W.middleRows(i + 1, 2);
            continue;
          }
        // d(lambda_t - mu p_n x/|x|) with p_n = lambda_n - rho_n g and
        // x = lambda_t + rho_t s.
        const double          size = p.tried.norm();
        const Eigen::Vector2d d    = p.tried / size;
        const Eigen::Matrix2d across =
          step.friction * p.normal / size *
          (Eigen::Matrix2d::Identity() - d * d.transpose());
        J.middleRows(i + 1, 2) = step.friction * rho_n * d * closed_W.row(i) +
                                 rho_t * across * closed_W.middleRows(i + 1, 2);
        J.block<2, 1>(i + 1, i) -= step.friction * d;
        J.block<2, 2>(i + 1, i + 1) += Eigen::Matrix2d::Identity() - across;
      }
    factor.compute(J);
  }



  bool
  ContactSolver::release_open(Eigen::VectorXd &lambda) const
  {
    bool changed = false;
    for (Eigen::Index j = 0; j < gap.size(); ++j)
      if (states[j] == ContactStatus::open &&
          !lambda.segment<3>(3 * j).isZero(0.))
        {
          lambda.segment<3>(3 * j).setZero();
          changed = true;
        }
    return changed;
  }



  bool
  ContactSolver::newton(const ContactStep &step,
                        Eigen::VectorXd   &lambda,
                        ContactReport     &report)
  {
    double residual = evaluate(step, lambda);
    bool   is_fresh = false;
    double best     = residual;
    for (unsigned int i = 0, n_idle = 0; i < maximum_iterations; ++i)
      {
        report.residual = residual;
        if (residual <= tolerance)
          return true;
        if (!(residual < std::numeric_limits<double>::max()) || n_idle > 12)
          return false;
        if (!is_fresh && (factored_states != states || closed.empty()))
          {
            factorize(step, lambda);
            is_fresh = true;
          }
        if (release_open(lambda))
          evaluate(step, lambda);
        if (!closed.empty())
          {
            const Eigen::VectorXd change =
              factor.solve(Eigen::VectorXd(violation(closed)));
            for (std::size_t k = 0; k < closed.size(); ++k)
              lambda[closed[k]] -= change[k];
          }
        ++report.iterations;
        const double next = evaluate(step, lambda);
        is_fresh = factored_states == states && next < worth_keeping * residual;
        if (!is_fresh)
          closed.clear();
        n_idle   = next < 0.9 * best ? 0 : n_idle + 1;
        best     = std::min(best, next);
        residual = next;
      }
    return false;
  }



  void
  ContactSolver::sweep(const ContactStep &step, Eigen::VectorXd &lambda)
  {
    for (Eigen::Index j = 0; j < gap.size(); ++j)
      {
        // The normal force first: friction needs the new one.
        for (unsigned int pass = 0; pass < 2; ++pass)
          {
            const Eigen::Vector3d forces = project(step, lambda, j).forces;
            const Eigen::Vector3d change = forces - lambda.segment<3>(3 * j);
            lambda.segment<3>(3 * j)     = forces;
            u.noalias() -= W.middleCols<3>(3 * j) * change;
          }
      }
  }



  ContactReport
  ContactSolver::solve(const ContactStep &step, Eigen::VectorXd &lambda)
  {
    ContactReport         report;
    const Eigen::VectorXd start = lambda;
    if (newton(step, lambda, report))
      return report;
    lambda = start.allFinite() ? start : Eigen::VectorXd::Zero(lambda.size());
    for (unsigned int round = 0; round < maximum_rounds; ++round)
      {
        evaluate(step, lambda);
        for (unsigned int i = 0; i < sweeps_per_round; ++i)
          sweep(step, lambda);
        report.sweeps += sweeps_per_round;
        const Eigen::VectorXd swept = lambda;
        closed.clear();
        if (newton(step, lambda, report))
          return report;
        lambda = swept;
      }
    throw ComputationError(
      "the contact problem has no solution that iterations reach (residual " +
      std::to_string(report.residual) +
      "): friction wedges or sprags, or the step is too long");
  }



  const std::vector<ContactStatus> &
  ContactSolver::status() const
  {
    return states;
  }

  const Eigen::VectorXd &
  ContactSolver::motion() const
  {
    return u;
  }
} // namespace squeal
