// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/base/worst_of.h>
#include <squeal/transient/contact_solver.h>
#include <squeal/transient/reduced_contact_model.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace squeal
{
  namespace
  {
    constexpr unsigned int maximum_iterations = 60;
    constexpr unsigned int maximum_rounds     = 60;
    constexpr unsigned int sweeps_per_round   = 20;
    constexpr unsigned int maximum_sweeps     = 20000;
    /** An operator that contracts less than this is renewed. */
    constexpr double worth_keeping = 0.4;
    /** Diagonal entries of an operator that differ by more, relatively, are
     * those of another problem. */
    constexpr double largest_change = 0.2;
    /** Of a node beside all others at rest, along its face over along its
     * normal: that of an elastic body is about one. */
    constexpr double largest_ratio_of_stiffness = 10.;
    /** Of the largest free motion, by which motions are off. */
    constexpr double rounding = 4. * std::numeric_limits<double>::epsilon();
  } // namespace



  /** The forces that the law gives one node for forces and motion tried. */
  struct ContactSolver::Projection
  {
    ContactStatus status;
    double        friction; /**< mu */
    /** Of what is tried, by how much more of it the force becomes more: the
     * rest becomes slip. */
    double          share = 0.;
    double          normal; /**< lambda_n - rho g, N */
    Eigen::Vector2d tried;  /**< lambda_t + rho slip, N */
    Eigen::Vector3d forces; /**< allowed */
  };



  ContactSolver::ContactSolver(Eigen::MatrixXd delassus,
                               Eigen::VectorXd initial_gap,
                               Eigen::VectorXd speed_ratio,
                               const double    force,
                               const double    t,
                               const Precision precision,
                               const Method    m)
    : now(std::move(delassus), speed_ratio)
    , gap(std::move(initial_gap))
    , ratio(std::move(speed_ratio))
    , mean_force(force)
    , tolerance(t)
    , violation(Eigen::VectorXd::Zero(now.W.rows()))
    , states(gap.size(), ContactStatus::open)
    , rows(gap.size())
    , is_single(precision == Precision::single)
    , starts_single(is_single)
    , method(m)
  {
    // In statics soft supports make W large: the law is scaled by the stiffness
    // of each node beside all others at rest, or statuses change sluggishly.
    if (is_single || method == Method::gauss_seidel)
      return;
    const Eigen::Index    n = now.W.rows();
    const Eigen::MatrixXd K =
      now.W.partialPivLu().solve(Eigen::MatrixXd::Identity(n, n));
    for (Eigen::Index j = 0; j < now.rho_normal.size(); ++j)
      {
        now.rho_normal[j] = std::max(now.rho_normal[j], K(3 * j, 3 * j));
        // What fills motions that are none is as stiff as can be.
        const double along_face =
          std::min(std::max(K(3 * j + 1, 3 * j + 1), K(3 * j + 2, 3 * j + 2)),
                   largest_ratio_of_stiffness * now.rho_normal[j]);
        now.rho_tangential[j] = std::max(now.rho_tangential[j], along_face);
      }
  }

  ContactSolver::Operator::Operator(Eigen::MatrixXd        delassus,
                                    const Eigen::VectorXd &speed_ratio)
    : W(std::move(delassus))
    , rho_normal(W.rows() / 3)
    , rho_tangential(W.rows() / 3)
  {
    fill_where_held(W, speed_ratio);
    for (Eigen::Index j = 0; j < rho_normal.size(); ++j)
      {
        rho_normal[j] = 1. / W(3 * j, 3 * j);
        rho_tangential[j] =
          1. / std::max(W(3 * j + 1, 3 * j + 1), W(3 * j + 2, 3 * j + 2));
      }
  }

  const ContactSolver::Operator &
  ContactSolver::kept_operator() const
  {
    return kept.W.size() > 0 ? kept : now;
  }

  void
  ContactSolver::set_operator(const Eigen::MatrixXd &delassus)
  {
    if (has_inverse && kept.W.size() == 0)
      kept = std::move(now);
    now = Operator(delassus, ratio);
    if (!has_inverse)
      return;
    const Eigen::ArrayXd change =
      now.W.diagonal().array() / kept.W.diagonal().array() - 1.;
    if (worst_of(change.abs()) <= largest_change)
      return;
    has_inverse = false;
    is_single   = starts_single;
    kept        = {};
    base.clear();
    updated.clear();
    changed.clear();
  }



  ContactSolver::Projection
  ContactSolver::project(const ContactStep     &step,
                         const Eigen::VectorXd &lambda,
                         const unsigned int     j) const
  {
    Projection p;
    p.friction = step.friction_at(j);
    p.normal   = lambda[3 * j] - now.rho_normal[j] * (gap[j] - u[3 * j]);
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
    p.tried = lambda.segment<2>(3 * j + 1) + now.rho_tangential[j] * slip;
    const double size  = p.tried.norm();
    bool         slips = size > p.friction * p.normal;
    if (!step.rising.empty() && step.rising[j].follows())
      {
        const double rho = now.rho_tangential[j];
        const auto   next =
          step.rising[j].slip(size, p.normal, rho, step.duration);
        slips      = next.has_value();
        p.friction = next ? next->friction : p.friction;
        p.share =
          next ? next->slope * p.normal / (next->slope * p.normal + rho) : 0.;
      }
    p.forces[0] = p.normal;
    p.status    = slips ? ContactStatus::slip : ContactStatus::stick;
    if (slips)
      p.forces.tail<2>() = p.friction * p.normal / size * p.tried;
    else
      p.forces.tail<2>() = p.tried;
    return p;
  }



  NodeRows
  ContactSolver::rows_of(const Projection &p) const
  {
    NodeRows result;
    result.status   = p.status;
    result.friction = p.friction;
    if (p.status == ContactStatus::slip)
      {
        const double size = p.tried.norm();
        result.direction  = p.tried / size;
        result.turning    = p.friction * p.normal / size;
        result.along      = p.share;
        result.friction *= 1. - p.share;
      }
    return result;
  }



  double
  ContactSolver::check_law(const ContactStep     &step,
                           const Eigen::VectorXd &lambda)
  {
    double worst = 0.;
    for (Eigen::Index j = 0; j < gap.size(); ++j)
      {
        const Projection p          = project(step, lambda, j);
        states[j]                   = p.status;
        rows[j]                     = rows_of(p);
        violation.segment<3>(3 * j) = lambda.segment<3>(3 * j) - p.forces;
        worst =
          worst_of(worst, worst_of(violation.segment<3>(3 * j).cwiseAbs()));
      }
    return worst / mean_force;
  }



  double
  ContactSolver::evaluate(const ContactStep     &step,
                          const Eigen::VectorXd &lambda)
  {
    u = step.free_motion;
    u.noalias() -= now.W * lambda;
    return check_law(step, lambda);
  }



  bool
  ContactSolver::newton(const ContactStep &step,
                        Eigen::VectorXd   &lambda,
                        ContactReport     &report)
  {
    if (starts_single)
      return iterate(step, lambda, report);
    // Whether the iterations cycle depends on what the law is scaled by.
    const Eigen::VectorXd start = lambda;
    double                scale = 1.;
    bool                  found = iterate(step, lambda, report);
    for (const double next : {0.1, 0.01, 0.001})
      if (!found)
        {
          scale_law(next / scale);
          scale  = next;
          lambda = start;
          found  = iterate(step, lambda, report);
        }
    if (scale != 1.)
      scale_law(1. / scale);
    return found;
  }



  void
  ContactSolver::scale_law(const double factor)
  {
    now.rho_normal *= factor;
    now.rho_tangential *= factor;
    has_inverse = false;
    base.clear();
    updated.clear();
    changed.clear();
  }



  bool
  ContactSolver::iterate(const ContactStep &step,
                         Eigen::VectorXd   &lambda,
                         ContactReport     &report)
  {
    double residual = evaluate(step, lambda);
    // Motions that are large beside the gaps leave no more digits.
    const double reachable =
      std::max(tolerance,
               rounding * worst_of(step.free_motion.cwiseAbs()) *
                 worst_of(now.rho_normal) / mean_force);
    double       best   = residual;
    unsigned int n_slow = 0;
    bool         is_new = false;
    for (unsigned int i = 0, n_idle = 0; i < maximum_iterations; ++i)
      {
        report.residual = residual;
        if (residual <= tolerance || (residual <= reachable && n_idle > 2))
          return true;
        if (!(residual < std::numeric_limits<double>::max()) || n_idle > 12)
          return false;
        // Too slow twice with statuses that stay: single precision and the
        // small changes left out add up. Where a new inverse is no better its
        // digits are too few, from now on.
        if (n_slow > 1)
          {
            // Nor is there a better one than a new one in double precision.
            if (is_new && !is_single && residual <= reachable)
              return true;
            if (is_new)
              is_single = false;
            invert();
            is_new = true;
            n_slow = 0;
            n_idle = 0;
          }
        else
          adapt(n_slow > 0);
        const Eigen::VectorXd change =
          is_single ? single.apply(violation) : full.apply(violation);
        lambda -= change;
        u.noalias() += now.W * change;
        ++report.iterations;
        const std::vector<ContactStatus> before = states;
        const double                     next   = check_law(step, lambda);
        n_slow   = states == before && !(next < worth_keeping * residual)
                     ? n_slow + 1
                     : 0;
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
            u.noalias() -= now.W.middleCols<3>(3 * j) * change;
          }
      }
  }



  void
  ContactSolver::throw_no_solution(const ContactReport &report)
  {
    std::ostringstream text;
    text << "the contact problem has no solution that iterations reach "
            "(residual "
         << report.residual
         << "): friction wedges or sprags, or the step is too long";
    throw ComputationError(text.str());
  }



  ContactReport
  ContactSolver::sweep_to_the_end(const ContactStep &step,
                                  Eigen::VectorXd   &lambda)
  {
    ContactReport report;
    for (report.residual = evaluate(step, lambda);
         !(report.residual <= tolerance);
         report.residual = check_law(step, lambda))
      {
        if (++report.sweeps > maximum_sweeps)
          throw_no_solution(report);
        sweep(step, lambda);
      }
    return report;
  }



  ContactReport
  ContactSolver::solve(const ContactStep &step, Eigen::VectorXd &lambda)
  {
    if (method == Method::gauss_seidel)
      return sweep_to_the_end(step, lambda);
    ContactReport         report;
    const Eigen::VectorXd start = lambda;
    if (newton(step, lambda, report))
      return report;
    if (!starts_single) // sweeps are for dynamics
      throw_no_solution(report);
    lambda = start.allFinite() ? start : Eigen::VectorXd::Zero(lambda.size());
    for (unsigned int round = 0; round < maximum_rounds; ++round)
      {
        evaluate(step, lambda);
        for (unsigned int i = 0; i < sweeps_per_round; ++i)
          sweep(step, lambda);
        report.sweeps += sweeps_per_round;
        const Eigen::VectorXd swept = lambda;
        if (newton(step, lambda, report))
          return report;
        lambda = swept;
      }
    throw_no_solution(report);
  }



  unsigned int
  ContactSolver::n_inversions() const
  {
    return n_inverted;
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
