// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/transient/implicit_transient.h>

namespace squeal
{
  namespace
  {
    /** A gap that no step closes, m. */
    constexpr double far_away = 1.;
  } // namespace



  ImplicitTransient::ImplicitTransient(FullContactModel            m,
                                       const double                time_step,
                                       TransientDrive              d,
                                       const double                nodal_force,
                                       const double                tolerance,
                                       const ContactSolver::Method method)
    : FullTransient(std::move(m), time_step, std::move(d))
    , stiffness_factor(0.5 * dt * beta + 0.25 * dt * dt)
  {
    if (has_damping_matrix)
      inverse = std::make_unique<ShiftedInverse>(
        model.pencil->combined(
          1. / stiffness_factor, 0.5 * dt / stiffness_factor, 1.),
        0.);
    else
      inverse = std::make_unique<ShiftedInverse>(
        *model.pencil, -(1. + 0.5 * dt * alpha) / stiffness_factor);
    const Eigen::Index n = B->n_rows();
    if (model.turning)
      compliance = std::make_unique<ContactCompliance>(
        *inverse, model.turning->unknowns(), model.load.size());
    else
      responses = inverse->solve(B->apply_transposed(
                    Eigen::MatrixXd(Eigen::MatrixXd::Identity(n, n)))) /
                  stiffness_factor;
    set_contact(nodal_force, tolerance, method);
  }

  Eigen::MatrixXd
  ImplicitTransient::delassus()
  {
    if (compliance)
      return dt * dt / stiffness_factor * compliance->product(*B);
    return dt * dt * B->apply(responses);
  }



  void
  ImplicitTransient::initialize()
  {
    K_u = stiffness_times(u);
    M_v = mass_times(v);
    // Forces of open nodes are zero to the tolerance of a solution only.
    touching.setZero(model.n_nodes());
    for (unsigned int j = 0; j < model.n_nodes(); ++j)
      touching[j] = lambda[3 * j] > 1e-6 * lambda.cwiseAbs().maxCoeff();
    inertial = inertial_force(0.);
    set_stored_energy();
  }

  std::vector<std::pair<std::string, Eigen::VectorXd *>>
  ImplicitTransient::further_state()
  {
    return {{"elastic_forces", &K_u},
            {"momentum", &M_v},
            {"touching", &touching},
            {"inertial_forces", &inertial}};
  }

  void
  ImplicitTransient::set_stored_energy()
  {
    energies.kinetic = 0.5 * v.dot(M_v);
    energies.elastic = 0.5 * u.dot(K_u);
  }



  Eigen::VectorXd
  ImplicitTransient::free_motion(const Eigen::VectorXd &right_hand_side) const
  {
    const Eigen::VectorXd rate = relative(v);
    Eigen::VectorXd       motion;
    // Nodes without contact in this step go on with their velocity: half of
    // the time of a step is the product with the responses.
    if (compliance)
      motion = 2. * dt / stiffness_factor *
                 relative(inverse->solve(Block(right_hand_side))) -
               dt * rate + carried;
    else
      motion = dt * rate + carried;
    for (unsigned int j = 0; j < model.n_nodes(); ++j)
      {
        const double gap = model.initial_gap[j] - nodes_motion[3 * j] -
                           0.5 * (dt * rate[3 * j] + carried[3 * j]);
        const bool may_touch = touching[j] > 0. || gap <= 0.;
        if (may_touch && !compliance)
          motion.segment<3>(3 * j) +=
            2. * dt *
            (responses.middleCols<3>(3 * j).transpose() * right_hand_side -
             rate.segment<3>(3 * j));
        motion[3 * j] =
          model.initial_gap[j] + (may_touch ? motion[3 * j] : -far_away);
      }
    return motion;
  }



  ContactReport
  ImplicitTransient::advance()
  {
    const double          t = time();
    const Eigen::VectorXd f =
      0.5 * (external_force(t) + external_force(t + dt));
    Block           rhs = M_v + 0.5 * dt * (f - K_u);
    Eigen::VectorXd of_turning; // in the middle of the step, extrapolated
    if (model.inertia)
      {
        const Eigen::VectorXd now = inertial_force(t);
        of_turning                = 1.5 * now - 0.5 * inertial;
        inertial                  = now;
        rhs += 0.5 * dt * of_turning;
      }
    ContactStep step = contact_step(t + dt);
    turn(step);
    step.free_motion     = free_motion(rhs);
    step.previous_motion = Eigen::VectorXd::Zero(step.free_motion.size());

    Eigen::VectorXd     next   = extrapolated_forces();
    const ContactReport report = solver->solve(step, next);
    B->add_transposed(Eigen::MatrixXd(-0.5 * dt * next), rhs);
    const Eigen::VectorXd v_h  = inverse->solve(rhs) / stiffness_factor;
    const Eigen::VectorXd K_vh = stiffness_times(v_h);
    a                          = (2. / dt) * (v_h - v);
    v                          = 2. * v_h - v;
    const Eigen::VectorXd M_v1 = mass_times(v);

    energies.damping +=
      dt * (0.5 * alpha * v_h.dot(M_v + M_v1) + beta * v_h.dot(K_vh));
    if (has_damping_matrix)
      energies.damping += dt * v_h.dot(damping_matrix_times(v_h));
    energies.load += dt * v_h.dot(f);
    if (model.inertia)
      energies.driving += dt * v_h.dot(of_turning);
    enter_contact_work(step, next, dt * relative(v_h));
    K_u += dt * K_vh;
    M_v = M_v1;
    for (unsigned int j = 0; j < model.n_nodes(); ++j)
      touching[j] = solver->status()[j] != ContactStatus::open;
    finish_step(step, u + dt * v_h, next);
    set_stored_energy();
    return report;
  }
} // namespace squeal
