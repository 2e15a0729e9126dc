// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_model_pressed_model_h
#define squeal_model_pressed_model_h

#include <squeal/contact/contact_nodes.h>
#include <squeal/contact/contact_terms.h>
#include <squeal/model/model.h>
#include <squeal/model/open_scene.h>
#include <squeal/transient/full_transient.h>
#include <squeal/transient/saved_modes.h>
#include <squeal/transient/statics_by_part.h>
#include <squeal/transient/steady_sliding.h>

#include <memory>
#include <optional>
#include <vector>

namespace squeal
{
  class Timers;
  struct SteadyModel;

  /**
   * A scene of bodies with its contact pairs cut open, in modes up to a
   * cut-off: what steady sliding and transients are computed with.
   *
   * The sliding direction of a pair is turned where its friction coefficient is
   * negative (the target turns backwards). Nothing of it changes once it is
   * there: other friction, and what steady sliding does to the gaps and the
   * loads, make a model of their own, which shares what has not changed.
   */
  class PressedModel
  {
  public:
    /** What coordinates of @p other, a model of the same unknowns, are in the
     * modes of this one: phi^T M phi_other. Throws InputError where the
     * unknowns or the contact nodes are others. Collective. */
    Eigen::MatrixXd coordinates_of(const PressedModel &other) const;

    /** Observed motions of every pair. */
    enum Observer
    {
      target_at_contact, /**< of the target at the contact nodes along their
                              normals, mean, m */
      loaded_face,       /**< of the face of the load that presses the pair on,
                              along the mean normal, mean, m */
      far_face,          /**< of the source's face away from the contact along
                              the normals, mean, of its centre at points that
                              have none, m; NaN where no point has one */
      centre_x,          /**< of the source body's centre of gravity, m: of the
                              material there, of the body on the mean where
                              there is none */
      centre_y,
      centre_z,
      n_observers
    };
    /** Where an observer of pair number @p pair stands among all of them. */
    static unsigned int observer(const unsigned int pair, const Observer what);

    /** References are kept. Motions of the contact itself have mass up to
     * @p interface_cut_off, Hz; 0: none. With the flexibility of sliding alone
     * the model is good for steady sliding, not for motions; where a support
     * is held it is good for the state alone. On several ranks the modes are
     * those of @p earlier, where they can be. */
    PressedModel(const Parameters                &parameters,
                 const Discretization            &discretization,
                 const std::vector<BodyMatrices> &bodies,
                 const double                     cut_off,
                 Timers                          &timers,
                 const double                     interface_cut_off = 0.,
                 const Flexibility flexibility = Flexibility::complete,
                 const SavedModes *earlier     = nullptr);

    /** Of an open scene, whatever it comes from. @p parameters are kept. */
    PressedModel(const Parameters &parameters,
                 OpenScene         open,
                 const double      cut_off,
                 Timers           &timers,
                 const double      interface_cut_off = 0.,
                 const Flexibility flexibility       = Flexibility::complete,
                 const SavedModes *earlier           = nullptr);

    const ContactNodes        &nodes() const;
    const ReducedContactModel &model() const;
    /** The same with other coefficients of friction >= 0 of the pairs for the
     * same directions of sliding; as ContactNodes::set_coefficients(). */
    PressedModel with_friction(const std::vector<double> &of_pairs) const;
    /** The same bodies under the same loads, which slide at the speeds, in the
     * directions and with the friction of @p parameters; they are kept. */
    PressedModel with_sliding(const Parameters &parameters,
                              Timers           &timers) const;
    /** The same scene with the moduli, the sliding and the sizes of the loads
     * of @p parameters, which are kept, for the states of steady sliding alone.
     * Of pressed_for_many_states() only; empty where these differ in more than
     * StaticsByPart takes. Collective. */
    std::optional<PressedModel> with_moduli(const Parameters &parameters) const;
    NodalFriction sliding_friction() const; /**< in steady sliding */
    /** The largest sliding speed of a pair, m/s, that the speeds of nodes are
     * measured by. */
    double       speed() const;
    unsigned int n_unknowns() const;

    /** What a motion in coordinates of the modes is saved with: those of the
     * earlier run that it goes on from, where it does. Collective. */
    SavedModes modes_to_save() const;

    /** Forces of @p load as modal forces. */
    ModalForce force(const LoadParameters &load) const;
    /** The columns of @p forces, N, on the unknowns of the open scene (those of
     * a Model whose contacts are open) as modal forces. Collective. */
    std::vector<ModalForce> forces(const Block &forces) const;

    /** f_i R f_j of the load of the model and of @p further ones, in this order,
     * on the residual flexibility of the bodies, N m. */
    Eigen::MatrixXd flexibility_of(
      const std::vector<ModalForce> &further) const;

    /** Velocities of the modes, of kinetic energy @p energy, J, after an
     * impulse spread at random over points of all bodies. It does not depend
     * on the signs of the modes nor on how those of one frequency share their
     * plane, as equal velocities of all modes would. */
    Eigen::VectorXd disturbance(const double energy) const;

    /**
     * Steady sliding under the full load, with the model that moves about it;
     * where no pair slides, the contact at rest, pressed on in the steps of the
     * parameters. The model's gaps are those after the run-in. Where a support
     * is `held` the state is that of the same scene with the support guided,
     * whose position along z is kept: then the model's load is what does that.
     * Throws ComputationError where there is none, InputError where a held
     * support leaves a free motion.
     */
    SteadyModel steady(const double tolerance, Timers &timers) const;

    /** All unknowns of the same scene, about @p steady. */
    FullContactModel full_model(const SteadySliding &steady) const;

    /** Free unknowns of the discretisation from those of full_model(), column
     * by column. */
    Block expand(const Block &unknowns) const;

    /** The contact states that @p steady gives to linearised operators, one
     * list a pair. */
    std::vector<ContactStates> states_of(const SteadySliding &steady) const;

  private:
    PressedModel(const PressedModel &other, const Parameters &parameters);
    /** A column for every load of @p scene, N. */
    Block loads_of(const SceneParameters &scene) const;
    /** Whether all that is asked of this scene, whose support is held, is the
     * state, which is that of the guided scene. */
    bool                          is_state_of_moving() const;
    SteadySliding                 steady_of_this(const double tolerance) const;
    const Parameters             &parameters;
    const SceneParameters        &scene;
    const Discretization         *discretization; /**< or null */
    LinearizedSystem              separated;
    ContactNodes                  contact_nodes;
    std::shared_ptr<const Pencil> pencil;
    std::shared_ptr<const ReductionBasis> basis;
    std::shared_ptr<const SavedModes>
          earlier_modes;  /**< of the basis, or null */
    Block load, observed; /**< nodal forces */
    std::function<Block(const LoadParameters &)> force_of;
    Eigen::VectorXd struck; /**< velocities of a disturbance, of unit size */
    ReducedContactModel                  reduced;
    double                               cut_off, interface_cut_off;
    Flexibility                          flexibility;
    std::shared_ptr<const StaticsByPart> by_part; /**< or null */
    struct MovingScene;
    std::shared_ptr<const MovingScene> moving; /**< of held supports */
  };

  /** A scene in steady sliding: the model with the gaps and loads of that
   * state, and the state. */
  struct SteadyModel
  {
    PressedModel  pressed;
    SteadySliding sliding;
  };

  /** The contact states of a scene's steady sliding, one list a pair; empty
   * for pairs whose state is that of the parameters. */
  std::vector<ContactStates> preload_states(const PressedModel &pressed,
                                            const Parameters   &parameters,
                                            Timers             &timers);

  std::vector<ContactStates> preload_states(
    const Parameters                &parameters,
    const Discretization            &discretization,
    const std::vector<BodyMatrices> &bodies,
    Timers                          &timers);

  std::vector<ContactStates> preload_states(const Parameters    &parameters,
                                            const ImportedModel &model,
                                            Timers              &timers);

  /** The pressed model of a model whose contacts are open, in the modes of
   * @p earlier where these are given and on several ranks. References are
   * kept. */
  PressedModel pressed_model(const Parameters &parameters,
                             const Model      &model,
                             const double      cut_off,
                             Timers           &timers,
                             const double      interface_cut_off = 0.,
                             const SavedModes *earlier           = nullptr);

  /** The same for the states of steady sliding alone. */
  PressedModel pressed_for_states(const Parameters &parameters,
                                  const Model      &model,
                                  Timers           &timers);

  /** The same, from which PressedModel::with_moduli() makes those of other
   * moduli and loads. */
  PressedModel pressed_for_many_states(const Parameters &parameters,
                                       const Model      &model,
                                       Timers           &timers);

  /** The parameters without damping, which steady sliding does not feel: it may
   * be of a kind that motions in time cannot have. */
  Parameters without_damping(Parameters parameters);

  /** Cut-off in Hz that is enough where statics alone are asked for: they are
   * exact for any, and modes above take time. */
  double cut_off_of_statics(const Parameters &parameters);

  /** Whether some support is `held`. */
  bool has_held_support(const SceneParameters &scene);

  /** Whether some pair is in the state of steady sliding. */
  bool has_preload_state(const SceneParameters &scene);
} // namespace squeal

#endif
