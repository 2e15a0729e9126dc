// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_model_pressed_model_h
#define squeal_model_pressed_model_h

#include <squeal/contact/contact_terms.h>
#include <squeal/contact/friction_law.h>
#include <squeal/model/model.h>
#include <squeal/transient/full_transient.h>
#include <squeal/transient/steady_sliding.h>

#include <memory>
#include <vector>

namespace squeal
{
  class Timers;

  /**
   * A scene of bodies with its one contact pair cut open, in modes up to a
   * cut-off: what steady sliding and transients are computed with.
   *
   * The sliding direction is turned where the friction coefficient is negative
   * (the target turns backwards), so that friction() >= 0.
   */
  class PressedModel
  {
  public:
    /** Observed motions, each along z or of the source body's centre. */
    enum Observer
    {
      target_at_contact, /**< mean z of the target at the contact nodes, m */
      loaded_face,       /**< mean z of the face of the first load, m */
      far_face,          /**< mean z of the source's face away from the contact;
                              of its centre where it has none, m */
      centre_x,          /**< of the source body's centre, m */
      centre_y,
      centre_z,
      n_observers
    };

    /** References are kept. Motions of the contact itself have mass up to
     * @p interface_cut_off, Hz; 0: none. */
    PressedModel(const Parameters                &parameters,
                 const Discretization            &discretization,
                 const std::vector<BodyMatrices> &bodies,
                 const double                     cut_off,
                 Timers                          &timers,
                 const double                     interface_cut_off = 0.);

    const ContactGeometry     &geometry() const;
    const ReducedContactModel &model() const;
    /** The size of the friction coefficient of the parameters. */
    double friction() const;
    /** Another one >= 0 for the same direction of sliding. Throws InputError
     * where a table gives the coefficients. */
    void          set_friction(const double friction);
    FrictionLaw   friction_law() const;
    NodalFriction sliding_friction() const; /**< in steady sliding */
    double        speed() const;            /**< |V|, m/s */
    unsigned int  n_unknowns() const;

    /** Forces of @p load as modal forces. */
    ModalForce force(const LoadParameters &load) const;

    /** Velocities of the modes, of kinetic energy @p energy, J, after an
     * impulse spread at random over points of all bodies. It does not depend
     * on the signs of the modes nor on how those of one frequency share their
     * plane, as equal velocities of all modes would. */
    Eigen::VectorXd disturbance(const double energy) const;

    /**
     * Steady sliding under the full load. Where a support is `held` it is that
     * of the same scene with the support guided, whose position along z is
     * kept: then the model's load becomes what does that. To be called before
     * a transient.
     */
    SteadySliding steady(const double tolerance, Timers &timers);

    /** All unknowns of the same scene, about @p steady. */
    FullContactModel full_model(const SteadySliding &steady) const;

    /** Free unknowns of the discretisation from those of full_model(), column
     * by column. */
    Block expand(const Block &unknowns) const;

    /** The contact state that @p steady gives to linearised operators. */
    ContactState state_of(const SteadySliding &steady) const;

  private:
    Block observers(const std::vector<BodyMatrices> &bodies) const;
    /** Nodal forces at random at some points of every body. */
    Block struck_points() const;

    const Parameters                     &parameters;
    const SceneParameters                &scene;
    const Discretization                 &discretization;
    LinearizedSystem                      separated;
    std::shared_ptr<const Pencil>         pencil;
    std::shared_ptr<const ReductionBasis> basis;
    Block                                 load, observed; /**< nodal forces */
    Eigen::VectorXd struck; /**< velocities of a disturbance, of unit size */
    ReducedContactModel reduced;
    double              cut_off, interface_cut_off, mu;
    struct MovingScene;
    std::shared_ptr<MovingScene> moving; /**< of held supports */
  };

  /** The contact state of a scene's steady sliding. */
  ContactState preload_state(const Parameters                &parameters,
                             const Discretization            &discretization,
                             const std::vector<BodyMatrices> &bodies,
                             Timers                          &timers);

  /** Whether some support is `held`. */
  bool has_held_support(const SceneParameters &scene);
} // namespace squeal

#endif
