// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/base/timers.h>
#include <squeal/eigen/mass_basis.h>
#include <squeal/model/load_checks.h>
#include <squeal/model/pressed_model.h>
#include <squeal/transient/run_in.h>

#include <algorithm>
#include <cmath>

namespace squeal
{
  namespace
  {
    /** Angles at which a turning target is integrated, on the way over the
     * narrowest cell. */
    constexpr unsigned int knots_per_cell = 250;

    template <typename Scene>
    OpenScene
    timed(Timers &timers, const Scene &scene)
    {
      Timers::Section section(timers, "Assemble: open contact");
      return scene();
    }
  } // namespace



  /** The same scene with its held supports guided. */
  struct PressedModel::MovingScene
  {
    MovingScene(const PressedModel &held, Timers &timers)
      : scene(guided(held.parameters))
      , bodies(std::make_shared<const Bodies>(held))
      , pressed(scene,
                bodies->space,
                bodies->matrices,
                held.cut_off,
                timers,
                held.interface_cut_off,
                held.flexibility)
    {
    }

    /** The same bodies with the sliding of @p p. */
    MovingScene(const MovingScene &other, const Parameters &p, Timers &timers)
      : scene(guided(p))
      , bodies(other.bodies)
      , pressed(other.pressed.with_sliding(scene, timers))
    {
    }

    static Parameters
    guided(Parameters p)
    {
      for (auto &support : p.scene.supports)
        if (support.kind == SupportParameters::Kind::held)
          support.kind = SupportParameters::Kind::guided;
      return p;
    }

    /** What all scenes share whose sliding alone is another. */
    struct Bodies
    {
      explicit Bodies(const PressedModel &held)
        : scene(guided(held.parameters))
        , space(scene.scene,
                scene.discretization,
                held.discretization->degree(),
                MPI_COMM_WORLD)
        , matrices(assemble_bodies(space))
      {
      }
      const Parameters                scene;
      const Discretization            space;
      const std::vector<BodyMatrices> matrices;
    };

    const Parameters                    scene;
    const std::shared_ptr<const Bodies> bodies;
    const PressedModel                  pressed;
  };



  namespace
  {
    /** What steady sliding asks of a model whose state is that of another one:
     * the frequencies of its motions. */
    ReducedContactModel
    frequencies_alone(const ReductionBasis &basis, const ContactNodes &nodes)
    {
      ReducedContactModel model;
      model.omega_squared = basis.omega_squared;
      model.load_motion   = Eigen::VectorXd::Zero(3 * nodes.n_nodes());
      model.initial_gap   = Eigen::VectorXd::Zero(nodes.n_nodes());
      model.speed_ratio   = nodes.speed_ratio();
      return model;
    }
  } // namespace



  PressedModel::PressedModel(const Parameters                &p,
                             const Discretization            &d,
                             const std::vector<BodyMatrices> &bodies,
                             const double                     highest,
                             Timers                          &timers,
                             const double                     interface,
                             const Flexibility                what,
                             const SavedModes                *earlier)
    : PressedModel(
        p,
        timed(timers, [&]() { return open_scene(p.scene, d, bodies); }),
        highest,
        timers,
        interface,
        what,
        earlier)
  {
  }

  PressedModel::PressedModel(const Parameters &p,
                             OpenScene         open,
                             const double      highest,
                             Timers           &timers,
                             const double      interface,
                             const Flexibility what,
                             const SavedModes *earlier)
    : parameters(p)
    , scene(p.scene)
    , discretization(open.discretization)
    , separated(std::move(open.separated))
    , contact_nodes(std::move(open.nodes))
    , load(std::move(open.load))
    , observed(std::move(open.observed))
    , force_of(std::move(open.force_of))
    , cut_off(highest)
    , interface_cut_off(interface)
    , flexibility(what)
  {
    if (discretization && !p.transient.hammer.body.empty() &&
        (p.analysis == Parameters::Analysis::transient ||
         p.analysis == Parameters::Analysis::work_precision))
      {
        const LoadParameters blow = load_of(p.transient.hammer);
        require_motion(
          *separated.system.space, force_of(blow), blow, "Transient/Hammer");
      }
    pencil = std::make_shared<const Pencil>(separated.system, scene);
    {
      Timers::Section section(timers, "Solve: modes of the bodies");
      const double    limit = std::pow(2. * M_PI * cut_off, 2);
      // Of statics there are few modes: another factor in their middle takes
      // more time than it saves.
      UndampedModes modes =
        flexibility == Flexibility::complete
          ? undamped_modes(*pencil, limit)
          : undamped_modes(*pencil, ShiftedInverse(*pencil, limit));
      modes.release_start();
      ReductionBasis motions = reduction_basis(
        *pencil, modes, contact_nodes.relative_motion(), interface_cut_off);
      // On one rank the same run has the same bits.
      if (earlier && pencil->space()->n_ranks() > 1 &&
          turn_into(motions, *earlier, *pencil))
        earlier_modes = std::make_shared<const SavedModes>(*earlier);
      basis = std::make_shared<const ReductionBasis>(std::move(motions));
    }
    if (is_state_of_moving())
      reduced = frequencies_alone(*basis, contact_nodes);
    else if (flexibility == Flexibility::of_sliding_by_part)
      {
        Timers::Section section(timers, "Solve: contact flexibility");
        const Block     loads = loads_of(scene);
        by_part               = std::make_shared<const StaticsByPart>(
          separated.system, scene, *basis, cut_off, contact_nodes, loads);
        reduced = by_part->at(scene, loads, contact_nodes).value();
      }
    else
      {
        Timers::Section section(timers, "Solve: contact flexibility");
        struck =
          inner_products(*pencil->space(), basis->shapes, open.struck).col(0);
        struck.normalize();
        reduced = reduce_contact_model(
          *pencil, *basis, cut_off, contact_nodes, load, observed, flexibility);
        add_cut_off_damping(reduced, p.transient.cut_off_damping);
      }
    if (has_held_support(scene))
      moving = std::make_shared<const MovingScene>(*this, timers);
  }



  unsigned int
  PressedModel::observer(const unsigned int pair, const Observer what)
  {
    return pair * n_observers + what;
  }

  const ContactNodes &
  PressedModel::nodes() const
  {
    return contact_nodes;
  }

  const ReducedContactModel &
  PressedModel::model() const
  {
    return reduced;
  }

  PressedModel
  PressedModel::with_friction(const std::vector<double> &of_pairs) const
  {
    PressedModel result = *this;
    result.contact_nodes.set_coefficients(of_pairs);
    return result;
  }

  PressedModel::PressedModel(const PressedModel &other, const Parameters &p)
    : parameters(p)
    , scene(p.scene)
    , discretization(other.discretization)
    , separated(other.separated)
    , contact_nodes(p.scene.contacts, other.separated.contacts)
    , pencil(other.pencil)
    , basis(other.basis)
    , earlier_modes(other.earlier_modes)
    , load(other.load)
    , observed(other.observed)
    , force_of(other.force_of)
    , struck(other.struck)
    , reduced(other.reduced)
    , cut_off(other.cut_off)
    , interface_cut_off(other.interface_cut_off)
    , flexibility(other.flexibility)
    , by_part(other.by_part)
  {
    reduced.turn_back(contact_nodes.turned_back_from(other.contact_nodes));
    reduced.speed_ratio = contact_nodes.speed_ratio();
  }

  PressedModel
  PressedModel::with_sliding(const Parameters &p, Timers &timers) const
  {
    PressedModel result(*this, p);
    if (moving)
      result.moving = std::make_shared<const MovingScene>(*moving, p, timers);
    return result;
  }

  std::optional<PressedModel>
  PressedModel::with_moduli(const Parameters &p) const
  {
    if (!by_part)
      return std::nullopt;
    PressedModel result(*this, p);
    const Block  loads = loads_of(p.scene);
    auto         model = by_part->at(p.scene, loads, result.contact_nodes);
    if (!model)
      return std::nullopt;
    result.reduced = std::move(*model);
    result.load    = loads.rowwise().sum();
    // Those of other moduli are not there: nothing of it can move.
    result.pencil.reset();
    result.basis.reset();
    return result;
  }

  Block
  PressedModel::loads_of(const SceneParameters &of) const
  {
    Block loads(load.rows(), of.loads.size());
    for (std::size_t i = 0; i < of.loads.size(); ++i)
      loads.col(i) = force_of(of.loads[i]).col(0);
    return loads;
  }

  NodalFriction
  PressedModel::sliding_friction() const
  {
    return contact_nodes.in_sliding();
  }

  double
  PressedModel::speed() const
  {
    return contact_nodes.speed();
  }

  unsigned int
  PressedModel::n_unknowns() const
  {
    return separated.system.space->n_global();
  }



  SavedModes
  PressedModel::modes_to_save() const
  {
    return earlier_modes ? *earlier_modes
                         : saved_modes(*basis, *pencil->space());
  }

  Eigen::VectorXd
  PressedModel::disturbance(const double energy) const
  {
    return std::sqrt(2. * energy) * struck;
  }

  ModalForce
  PressedModel::force(const LoadParameters &load) const
  {
    return forces(force_of(load)).at(0);
  }

  std::vector<ModalForce>
  PressedModel::forces(const Block &f) const
  {
    return modal_forces(
      *pencil, *basis, contact_nodes.relative_motion(), f, observed);
  }



  Eigen::MatrixXd
  PressedModel::flexibility_of(const std::vector<ModalForce> &further) const
  {
    const RowSpace &space = *pencil->space();
    Eigen::MatrixXd result(1 + further.size(), 1 + further.size());
    result(0, 0) = reduced.load_flexibility;
    for (std::size_t i = 0; i < further.size(); ++i)
      {
        const Block response = further[i].response;
        result(0, 1 + i)     = result(1 + i, 0) =
          inner_products(space, load, response).sum();
        for (std::size_t j = 0; j < further.size(); ++j)
          result(1 + j, 1 + i) =
            inner_products(space, Block(further[j].nodal), response).sum();
      }
    return result;
  }



  Eigen::MatrixXd
  PressedModel::coordinates_of(const PressedModel &other) const
  {
    if (basis->shapes.rows() != other.basis->shapes.rows() ||
        reduced.n_nodes() != other.reduced.n_nodes())
      throw InputError("two models have other unknowns or contact nodes: their "
                       "motions cannot be compared");
    return inner_products(
      *pencil->space(), basis->mass_shapes, other.basis->shapes);
  }



  SteadySliding
  PressedModel::steady_of_this(const double tolerance) const
  {
    if (speed() == 0.)
      return press_at_rest(
               reduced,
               contact_nodes.laws().at_rest(contact_nodes.n_nodes()),
               parameters.preload.load_steps,
               tolerance)
        .back();
    return steady_sliding(
      reduced, sliding_friction().coefficient, 1., tolerance);
  }



  bool
  PressedModel::is_state_of_moving() const
  {
    return flexibility == Flexibility::of_sliding && has_held_support(scene);
  }

  SteadyModel
  PressedModel::steady(const double tolerance, Timers &timers) const
  {
    SteadyModel result{*this, {}};
    auto       &model = result.pressed.reduced;
    if (!moving)
      {
        Timers::Section section(timers, "Solve: steady sliding");
        if (parameters.preload.run_in == PreloadParameters::RunIn::archard)
          model.initial_gap = worn_gap(
            model, contact_nodes.areas(), sliding_friction().coefficient);
        result.sliding = result.pressed.steady_of_this(tolerance);
        return result;
      }
    const SteadyModel guided =
      moving->pressed.with_friction(contact_nodes.coefficients())
        .steady(tolerance, timers);
    result.sliding    = guided.sliding;
    model.initial_gap = guided.pressed.model().initial_gap;
    if ((model.omega_squared.array() == 0.).any())
      throw InputError("Scene/Supports: with a held support a motion is left "
                       "that nothing holds; hold it by Scene/Springs");
    if (is_state_of_moving())
      return result;
    // The held support adds a constant to the motion of the nodes: what is left
    // when loads and contact forces have done theirs.
    SteadySliding &steady = result.sliding;
    steady.coordinates =
      (model.load - model.participation.transpose() * steady.forces)
        .cwiseQuotient(model.omega_squared);
    model.support_motion = -model.load_motion;
    model.load_motion =
      steady.motion - (model.participation * steady.coordinates -
                       model.flexibility * steady.forces);
    model.support_motion += model.load_motion;
    return result;
  }



  FullContactModel
  PressedModel::full_model(const SteadySliding &steady) const
  {
    Assert(flexibility == Flexibility::complete, dealii::ExcInternalError());
    FullContactModel full;
    full.pencil = pencil;
    full.basis  = basis;
    full.relative_motion =
      std::make_shared<const Functionals>(contact_nodes.relative_motion());
    full.load          = load.col(0);
    full.observers     = observed;
    full.initial_gap   = reduced.initial_gap;
    full.speed_ratio   = reduced.speed_ratio;
    full.motion_offset = Eigen::VectorXd::Zero(steady.motion.size());
    if (parameters.transient.disc_frame ==
        TransientParameters::DiscFrame::corotating)
      {
        full.turning = std::make_shared<TurningContacts>(
          *discretization, contact_nodes, separated.reduce, knots_per_cell);
        full.inertia =
          std::make_shared<const TurningInertia>(*discretization,
                                                 full.turning->rates(),
                                                 separated.expand,
                                                 separated.restrict_forces);
      }
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



  std::vector<ContactStates>
  PressedModel::states_of(const SteadySliding &steady) const
  {
    std::vector<ContactStates> result;
    for (const ContactPair &pair : contact_nodes.pairs())
      {
        ContactState state;
        state.status = pair.part(steady.status);
        // Nothing slides there: nodes at the limit of friction, which slipped
        // on the way, stick to where they are.
        if (!pair.slides() && FrictionLaw(pair.parameters).at_rest() > 0.)
          std::replace(state.status.begin(),
                       state.status.end(),
                       ContactStatus::slip,
                       ContactStatus::stick);
        state.in_newtons             = true;
        const Eigen::VectorXd forces = pair.part(steady.forces);
        for (unsigned int j = 0; j < pair.n_nodes(); ++j)
          state.force_share.push_back(std::max(0., forces[3 * j]));
        result.push_back({state});
      }
    return result;
  }
} // namespace squeal
