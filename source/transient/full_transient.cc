// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/transient/full_transient.h>

#include <limits>

namespace squeal
{
  Block
  static_motions(const FullContactModel &model,
                 const Eigen::MatrixXd  &q,
                 const Block            &forces)
  {
    const ResidualResponse residual_response(*model.pencil, *model.basis);
    Block u = model.basis->shapes * q + residual_response(forces);
    // The response is one beside a shift of zero: once more for what is left.
    const Block rest = forces - model.pencil->multiply_undamped_stiffness(u);
    u += residual_response(rest);
    return u;
  }

  Eigen::VectorXd
  static_motion(const FullContactModel &model,
                const Eigen::VectorXd  &q,
                const double            share,
                const Eigen::VectorXd  &lambda)
  {
    return static_motions(
      model,
      q,
      share * model.load -
        model.relative_motion->apply_transposed(Eigen::MatrixXd(lambda)));
  }



  FullTransient::FullTransient(FullContactModel m,
                               const double     time_step,
                               TransientDrive   d)
    : model(std::move(m))
    , dt(time_step)
    , drive(std::move(d))
    , friction(drive, model.speed_ratio)
    , B(model.relative_motion)
    , way(Eigen::VectorXd::Zero(model.turning ? 1 : 0))
    , carried(Eigen::VectorXd::Zero(3 * model.n_nodes()))
  {
    if (model.pencil->space()->n_ranks() > 1)
      throw InputError("Transient/Integrator: implicit and explicit run on one "
                       "rank");
    check_time_domain_damping(*model.pencil);
    has_damping_matrix = !model.pencil->is_rayleigh_damped(alpha, beta);
    if (has_damping_matrix)
      alpha = beta = 0.;
  }



  Eigen::VectorXd
  FullTransient::external_force(const double time) const
  {
    Eigen::VectorXd f = drive.load(time) * model.load;
    for (const auto &force : drive.forces)
      if (const double factor = force.factor(time); factor != 0.)
        f += factor * force.force.nodal;
    return f;
  }

  Eigen::VectorXd
  FullTransient::inertial_force(const double time) const
  {
    return model.inertia
             ? model.inertia->forces(u - u_start, v, drive.speed(time))
             : Eigen::VectorXd();
  }

  Eigen::VectorXd
  FullTransient::relative(const Eigen::VectorXd &x) const
  {
    return B->apply(Block(x));
  }

  Eigen::VectorXd
  FullTransient::applied(const double           time,
                         const Eigen::VectorXd &contact_forces) const
  {
    Block f = external_force(time);
    B->add_transposed(Eigen::MatrixXd(-contact_forces), f);
    return f;
  }

  Eigen::VectorXd
  FullTransient::mass_times(const Eigen::VectorXd &x) const
  {
    return model.pencil->multiply_mass(x);
  }

  Eigen::VectorXd
  FullTransient::stiffness_times(const Eigen::VectorXd &x) const
  {
    return model.pencil->multiply_undamped_stiffness(x);
  }

  Eigen::VectorXd
  FullTransient::damping_matrix_times(const Eigen::VectorXd &x) const
  {
    return has_damping_matrix
             ? Eigen::VectorXd(model.pencil->multiply_damping(x))
             : Eigen::VectorXd();
  }



  ContactStep
  FullTransient::contact_step(const double end) const
  {
    ContactStep step;
    step.duration = dt;
    step.speed    = drive.speed(end - 0.5 * dt);
    friction.set(end, step);
    return step;
  }

  Eigen::VectorXd
  FullTransient::extrapolated_forces() const
  {
    return 3. * (lambda - lambda_1) + lambda_2;
  }



  void
  FullTransient::finish_step(const ContactStep     &step,
                             const Eigen::VectorXd &next,
                             const Eigen::VectorXd &contact_forces)
  {
    u            = next;
    lambda_2     = lambda_1;
    lambda_1     = lambda;
    lambda       = contact_forces;
    nodes_motion = relative(u) + model.motion_offset;
    friction.keep(step, solver->motion(), solver->status());
    ++n_steps;
  }



  void
  FullTransient::set_turn()
  {
    B = way[0] == 0. ? model.relative_motion
                     : model.turning->relative_motion(way[0]);
    solver->set_operator(symmetric_delassus());
  }

  void
  FullTransient::turn(const ContactStep &step)
  {
    if (!model.turning)
      return;
    way[0] += step.duration * step.speed;
    set_turn();
    carried = relative(u) + model.motion_offset - nodes_motion;
  }



  void
  FullTransient::enter_contact_work(const ContactStep     &step,
                                    const Eigen::VectorXd &contact_forces,
                                    const Eigen::VectorXd &motion_of_nodes)
  {
    for (unsigned int j = 0; j < model.n_nodes(); ++j)
      {
        const Eigen::Vector3d force  = contact_forces.segment<3>(3 * j);
        const Eigen::Vector3d turned = carried.segment<3>(3 * j),
                              change =
                                motion_of_nodes.segment<3>(3 * j) + turned;
        const double sliding =
          step.duration * step.speed * model.speed_ratio[j];
        const double lost =
          force[1] * (sliding + change[1]) + force[2] * change[2];
        energies.driving += force[1] * sliding + force.dot(turned);
        energies.friction += lost;
        losses[j] += lost;
        energies.numerical += force[0] * change[0];
      }
  }



  Eigen::MatrixXd
  FullTransient::symmetric_delassus()
  {
    const Eigen::MatrixXd W         = delassus();
    Eigen::MatrixXd       symmetric = 0.5 * (W + W.transpose());
    if (const Eigen::MatrixXd fill = fill_of_null_space(symmetric);
        fill.size() > 0)
      symmetric += fill;
    return symmetric;
  }

  void
  FullTransient::set_contact(const double                nodal_force,
                             const double                tolerance,
                             const ContactSolver::Method method)
  {
    solver = std::make_unique<ContactSolver>(symmetric_delassus(),
                                             model.initial_gap,
                                             model.speed_ratio,
                                             nodal_force,
                                             tolerance,
                                             ContactSolver::Precision::single,
                                             method);
  }

  void
  FullTransient::start(const Eigen::VectorXd &q,
                       const Eigen::VectorXd &velocity,
                       const Eigen::VectorXd &forces)
  {
    n_steps = 0;
    if (model.turning)
      {
        way.setZero();
        set_turn();
      }
    u = u_start = static_motion(model, q, drive.load(0.), forces);
    v           = model.basis->shapes * velocity;
    a           = Eigen::VectorXd::Zero(u.size());
    lambda = lambda_1 = lambda_2 = forces;
    nodes_motion                 = relative(u) + model.motion_offset;
    energies                     = {};
    losses                       = Eigen::VectorXd::Zero(model.n_nodes());
    friction.start(relative(v));
    initialize();
    energies.start = energies.kinetic + energies.elastic;
  }



  double
  FullTransient::time() const
  {
    return dt * n_steps;
  }

  Eigen::VectorXd
  FullTransient::coordinates() const
  {
    return model.basis->mass_shapes.transpose() * u;
  }

  Eigen::VectorXd
  FullTransient::velocities() const
  {
    return model.basis->mass_shapes.transpose() * v;
  }

  Eigen::VectorXd
  FullTransient::observed_motion() const
  {
    return model.observers.transpose() * u;
  }

  Eigen::VectorXd
  FullTransient::observed_accelerations() const
  {
    return model.observers.transpose() * a;
  }

  EnergyLedger
  FullTransient::ledger() const
  {
    return energies;
  }

  const Eigen::VectorXd &
  FullTransient::friction_losses() const
  {
    return losses;
  }

  unsigned int
  FullTransient::n_inversions() const
  {
    return solver->n_inversions();
  }

  const Eigen::VectorXd &
  FullTransient::forces() const
  {
    return lambda;
  }

  const Eigen::VectorXd &
  FullTransient::motion() const
  {
    return nodes_motion;
  }

  const Eigen::VectorXd *
  FullTransient::unknowns() const
  {
    return &u;
  }

  const std::vector<ContactStatus> &
  FullTransient::status() const
  {
    return solver->status();
  }



  std::vector<std::pair<std::string, Eigen::VectorXd *>>
  FullTransient::state()
  {
    std::vector<std::pair<std::string, Eigen::VectorXd *>> result = {
      {"displacements", &u},
      {"velocities", &v},
      {"accelerations", &a},
      {"forces", &lambda},
      {"forces_before", &lambda_1},
      {"forces_before_that", &lambda_2},
      {"motion", &nodes_motion},
      {"way", &way},
      {"friction", &friction.state()},
      {"friction_losses", &losses}};
    for (const auto &further : further_state())
      result.push_back(further);
    return result;
  }

  NamedNumbers
  FullTransient::memory() const
  {
    NamedNumbers result;
    result.set("n_steps", static_cast<double>(n_steps));
    result.set("energies", energies.memory());
    for (const auto &[name, x] : const_cast<FullTransient *>(this)->state())
      result.set(name, Eigen::MatrixXd(*x));
    result.set("solver", solver->memory());
    return result;
  }

  void
  FullTransient::restore(const NamedNumbers &memory)
  {
    n_steps = memory.count("n_steps", std::numeric_limits<unsigned int>::max());
    energies.restore(memory.group("energies"));
    // Sizes are those of the start, which has been set before.
    for (const auto &[name, x] : state())
      *x = memory.vector(name, x->size());
    if (model.turning)
      set_turn();
    solver->restore(memory.group("solver"));
  }
} // namespace squeal
