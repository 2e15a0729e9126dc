// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/base/timers.h>
#include <squeal/discretization/face_quadrature.h>
#include <squeal/discretization/load_vector.h>
#include <squeal/eigen/mass_basis.h>
#include <squeal/model/pressed_model.h>
#include <squeal/transient/run_in.h>

#include <cmath>
#include <random>

namespace squeal
{
  namespace
  {
    /** Angles at which a turning target is integrated, on the way over the
     * narrowest cell. */
    constexpr unsigned int knots_per_cell = 250;

    /** The same contact with sliding and transverse direction reversed. */
    void
    reverse(ContactGeometry &g)
    {
      const auto negative = [](const Functionals &all) {
        std::vector<Functionals::Row> rows = all.rows();
        for (auto &row : rows)
          for (auto &[column, weight] : row)
            weight = -weight;
        return std::make_shared<const Functionals>(all.space_pointer(),
                                                   std::move(rows));
      };
      g.tangential = negative(*g.tangential);
      g.transverse = negative(*g.transverse);
      for (auto &frame : g.frames)
        {
          frame.sliding *= -1.;
          frame.transverse *= -1.;
        }
    }

    /** Point springs give way: their compliance adds to that of the bodies. */
    void
    add_springs(const ContactParameters &contact, ReducedContactModel &model)
    {
      if (contact.formulation != ContactParameters::Formulation::springs)
        return;
      const double normal     = contact.normal_stiffness,
                   tangential = contact.tangential_stiffness >= 0.
                                  ? contact.tangential_stiffness
                                  : normal;
      if (!(tangential > 0.))
        throw InputError("Scene/Contact " + contact.name +
                         "/Tangential stiffness: must not be 0, nodes that "
                         "stick could not carry friction");
      for (unsigned int j = 0; j < model.n_nodes(); ++j)
        {
          model.flexibility(3 * j, 3 * j) += 1. / normal;
          for (unsigned int c = 1; c < 3; ++c)
            model.flexibility(3 * j + c, 3 * j + c) += 1. / tangential;
        }
    }

    /** Points of a body that a disturbance strikes. */
    constexpr unsigned int n_struck = 24;

    void
    add_row(const RowSpace             &space,
            const Functionals::Row     &row,
            const double                factor,
            Eigen::Ref<Eigen::VectorXd> column)
    {
      const auto first = space.first_owned(), n = space.n_owned();
      for (const auto &[r, weight] : row)
        if (r >= first && r < first + n)
          column[r - first] += factor * weight;
    }
  } // namespace



  bool
  has_held_support(const SceneParameters &scene)
  {
    for (const auto &support : scene.supports)
      if (support.kind == SupportParameters::Kind::held)
        return true;
    return false;
  }



  /** The same scene with its held supports guided. */
  struct PressedModel::MovingScene
  {
    Parameters                      scene;
    std::unique_ptr<Discretization> space;
    std::unique_ptr<PressedModel>   pressed;
  };



  PressedModel::PressedModel(const Parameters                &p,
                             const Discretization            &d,
                             const std::vector<BodyMatrices> &bodies,
                             const double                     highest,
                             Timers                          &timers,
                             const double                     interface)
    : parameters(p)
    , scene(p.scene)
    , discretization(d)
    , cut_off(highest)
    , interface_cut_off(interface)
    , mu(std::abs(p.scene.contacts[0].friction_coefficient))
  {
    {
      Timers::Section section(timers, "Assemble: open contact");
      separated = separated_system(d, bodies);
      pencil    = std::make_shared<const Pencil>(separated.system, scene);
      if (scene.contacts[0].friction_coefficient < 0.)
        reverse(separated.contacts[0]);
    }
    {
      Timers::Section section(timers, "Solve: modes of the bodies");
      UndampedModes   modes =
        undamped_modes(*pencil, std::pow(2. * M_PI * cut_off, 2));
      modes.release_start();
      basis = std::make_shared<const ReductionBasis>(reduction_basis(
        *pencil, modes, separated.contacts[0], interface_cut_off));
    }
    Timers::Section      section(timers, "Solve: contact flexibility");
    const PointEvaluator evaluator(d);
    Block                nodal = Block::Zero(d.space()->n_owned(), 1);
    for (const auto &l : scene.loads)
      nodal += load_vector(d, evaluator, l);
    load     = separated.restrict_forces(nodal);
    observed = separated.restrict_forces(observers(bodies));
    struck =
      inner_products(*pencil->space(), basis->shapes, struck_points()).col(0);
    struck.normalize();
    reduced = reduce_contact_model(
      *pencil, *basis, cut_off, separated.contacts[0], load, observed);
    add_cut_off_damping(reduced, p.transient.cut_off_damping);
    add_springs(scene.contacts[0], reduced);
  }



  Block
  PressedModel::observers(const std::vector<BodyMatrices> &bodies) const
  {
    const auto        &contact = scene.contacts[0];
    const auto        &g       = separated.contacts[0];
    const RowSpace    &space   = *discretization.space();
    const unsigned int source  = body_index(scene, contact.source_body);
    Block              l       = Block::Zero(space.n_owned(), n_observers);
    double             area    = 0.;
    for (const double a : g.areas)
      area += a;
    for (std::size_t j = 0; j < g.points.size(); ++j)
      add_row(space,
              g.target_rows[j][2],
              g.areas[j] / area,
              l.col(target_at_contact));
    const PointEvaluator evaluator(discretization);
    LoadParameters       unit = scene.loads[0];
    unit.force                = {{0., 0., 1.}};
    l.col(loaded_face)        = load_vector(discretization, evaluator, unit);
    const auto centre =
      evaluator.displacements(source, {bodies[source].centre}, 1e-4);
    for (unsigned int c = 0; c < 3; ++c)
      add_row(space, centre.rows[0][c], 1., l.col(centre_x + c));
    // The far face may be inside, tied to another body: the contact nodes
    // mirrored at the centre's height.
    std::vector<dealii::Point<3>> mirrored = g.points;
    for (auto &point : mirrored)
      point[2] = 2. * bodies[source].centre[2] - point[2];
    const auto far = evaluator.displacements(source, mirrored, 1e-4);
    for (std::size_t j = 0; j < mirrored.size(); ++j)
      add_row(space,
              far.found[j] ? far.rows[j][2] : centre.rows[0][2],
              g.areas[j] / area,
              l.col(far_face));
    return l;
  }



  const ContactGeometry &
  PressedModel::geometry() const
  {
    return separated.contacts[0];
  }

  const ReducedContactModel &
  PressedModel::model() const
  {
    return reduced;
  }

  double
  PressedModel::friction() const
  {
    return mu;
  }

  void
  PressedModel::set_friction(const double friction)
  {
    Assert(friction >= 0., dealii::ExcInternalError());
    const auto &contact = scene.contacts[0];
    if (contact.friction_law == ContactParameters::FrictionLaw::table &&
        friction != mu)
      throw InputError("Scene/Contact " + contact.name +
                       "/Friction coefficient: has no effect with 'Friction "
                       "law = table'");
    mu = friction;
  }

  FrictionLaw
  PressedModel::friction_law() const
  {
    ContactParameters contact    = scene.contacts[0];
    contact.friction_coefficient = mu;
    return FrictionLaw(contact);
  }

  NodalFriction
  PressedModel::sliding_friction() const
  {
    return friction_law().in_sliding(reduced.speed_ratio, speed());
  }

  double
  PressedModel::speed() const
  {
    return scene.contacts[0].sliding_speed;
  }

  unsigned int
  PressedModel::n_unknowns() const
  {
    return separated.system.space->n_global();
  }



  Block
  PressedModel::struck_points() const
  {
    const PointEvaluator evaluator(discretization);
    const auto          &mesh = discretization.coarse_mesh();
    Block                f = Block::Zero(discretization.space()->n_owned(), 1);
    std::mt19937         generator(1);
    for (unsigned int b = 0; b < scene.bodies.size(); ++b)
      {
        std::vector<unsigned int> corners;
        for (const auto &cell : mesh.cells)
          if (cell.material_id == b)
            corners.insert(
              corners.end(), cell.vertices.begin(), cell.vertices.end());
        std::vector<dealii::Point<3>> points;
        for (unsigned int i = 0; i < n_struck && !corners.empty(); ++i)
          points.push_back(
            mesh.vertices[corners[generator() % corners.size()]]);
        if (corners.empty()) // a rigid body
          points.emplace_back(scene.bodies[b].position[0],
                              scene.bodies[b].position[1],
                              scene.bodies[b].position[2]);
        const auto found = evaluator.displacements(b, points);
        for (std::size_t i = 0; i < points.size(); ++i)
          for (unsigned int c = 0; c < 3; ++c)
            if (found.found[i])
              add_row(*discretization.space(),
                      found.rows[i][c],
                      generator() / 4294967296. - 0.5,
                      f.col(0));
      }
    return separated.restrict_forces(f);
  }

  Eigen::VectorXd
  PressedModel::disturbance(const double energy) const
  {
    return std::sqrt(2. * energy) * struck;
  }

  ModalForce
  PressedModel::force(const LoadParameters &load) const
  {
    return modal_forces(
             *pencil,
             *basis,
             separated.contacts[0],
             separated.restrict_forces(load_vector(
               discretization, PointEvaluator(discretization), load)))
      .front();
  }



  SteadySliding
  PressedModel::steady(const double tolerance, Timers &timers)
  {
    if (!has_held_support(scene))
      {
        Timers::Section section(timers, "Solve: steady sliding");
        if (parameters.preload.run_in == PreloadParameters::RunIn::archard)
          reduced.initial_gap =
            worn_gap(reduced, geometry().areas, sliding_friction().coefficient);
        return steady_sliding(
          reduced, sliding_friction().coefficient, 1., tolerance);
      }
    if (!moving)
      {
        moving        = std::make_shared<MovingScene>();
        moving->scene = parameters;
        for (auto &support : moving->scene.scene.supports)
          if (support.kind == SupportParameters::Kind::held)
            support.kind = SupportParameters::Kind::guided;
        moving->space =
          std::make_unique<Discretization>(moving->scene.scene,
                                           moving->scene.discretization,
                                           discretization.degree(),
                                           MPI_COMM_WORLD);
        moving->pressed =
          std::make_unique<PressedModel>(moving->scene,
                                         *moving->space,
                                         assemble_bodies(*moving->space),
                                         cut_off,
                                         timers,
                                         interface_cut_off);
      }
    moving->pressed->set_friction(mu);
    SteadySliding steady = moving->pressed->steady(tolerance, timers);
    reduced.initial_gap  = moving->pressed->model().initial_gap;
    if ((reduced.omega_squared.array() == 0.).any())
      throw InputError("Scene/Supports: with a held support a motion is left "
                       "that nothing holds; hold it by Scene/Springs");
    // The held support adds a constant to the motion of the nodes: what is left
    // when loads and contact forces have done theirs.
    steady.coordinates =
      (reduced.load - reduced.participation.transpose() * steady.forces)
        .cwiseQuotient(reduced.omega_squared);
    reduced.load_motion =
      steady.motion - (reduced.participation * steady.coordinates -
                       reduced.flexibility * steady.forces);
    return steady;
  }



  FullContactModel
  PressedModel::full_model(const SteadySliding &steady) const
  {
    FullContactModel full;
    full.pencil          = pencil;
    full.basis           = basis;
    full.relative_motion = std::make_shared<const Functionals>(
      relative_motion(separated.contacts[0]));
    full.load          = load.col(0);
    full.observers     = observed;
    full.initial_gap   = reduced.initial_gap;
    full.speed_ratio   = reduced.speed_ratio;
    full.motion_offset = Eigen::VectorXd::Zero(steady.motion.size());
    if (parameters.transient.disc_frame ==
        TransientParameters::DiscFrame::corotating)
      full.turning = std::make_shared<TurningContact>(discretization,
                                                      scene.contacts[0],
                                                      separated.contacts[0],
                                                      separated.reduce,
                                                      knots_per_cell);
    if (has_held_support(scene))
      full.motion_offset =
        steady.motion - full.relative_motion->apply(Block(static_motion(
                          full, steady.coordinates, 1., steady.forces)));
    return full;
  }



  Block
  PressedModel::expand(const Block &unknowns) const
  {
    return separated.expand(unknowns);
  }



  ContactState
  PressedModel::state_of(const SteadySliding &steady) const
  {
    ContactState state;
    state.status           = steady.status;
    const double reference = scene.contacts[0].normal_force;
    for (unsigned int j = 0; j < reduced.n_nodes(); ++j)
      state.force_share.push_back(std::max(0., steady.forces[3 * j]) /
                                  (reference > 0. ? reference : 1.));
    return state;
  }



  ContactState
  preload_state(const Parameters                &parameters,
                const Discretization            &discretization,
                const std::vector<BodyMatrices> &bodies,
                Timers                          &timers)
  {
    // Statics do not depend on the cut-off.
    PressedModel pressed(parameters,
                         discretization,
                         bodies,
                         parameters.eigen.highest_frequency,
                         timers);
    return pressed.state_of(
      pressed.steady(parameters.preload.tolerance, timers));
  }
} // namespace squeal
