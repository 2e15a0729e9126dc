// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_contact_contact_terms_h
#define squeal_contact_contact_terms_h

#include <squeal/contact/contact_geometry.h>
#include <squeal/contact/friction_law.h>
#include <squeal/contact/mortar.h>
#include <squeal/discretization/affine_system.h>

namespace squeal
{
  /**
   * The status of the whole face of a pair whose contact state is `full` or
   * `stick`. Nothing slides in a pair at rest (a sliding speed of 0), whatever
   * its sliding direction: with `full` its face sticks where the law has
   * friction at rest, and is free along itself (it slips without friction)
   * where it has none.
   */
  ContactStatus status_of_face(const ContactParameters &contact);

  /**
   * Lets the coefficients of @p system throw InputError for scenes of a sweep
   * in which a pair has another status_of_face() than in @p scene: the terms
   * are those of one status.
   */
  void refuse_other_status(const SceneParameters &scene, AffineSystem &system);

  /**
   * Adds the contact of pair @p number, linearised about steady sliding, by
   * point springs: normal springs k_n at closed points; at slipping ones the
   * friction mu k_n B_t^T B_n (rows of K: y_d: +mu k_n (z_d - z_p), y_p:
   * -mu k_n (z_d - z_p)) and, on request, the damping mu N_i / |V| of the slip
   * across the sliding direction and N_i dmu/dV along it; at sticking ones
   * springs k_t in both tangential directions. Each of several states has terms
   * of its own, whose coefficients vanish where another one holds.
   */
  void add_spring_contact(const SceneParameters &scene,
                          const unsigned int     number,
                          const ContactGeometry &geometry,
                          const ContactStates   &states,
                          AffineSystem          &system);

  /**
   * The coefficients of the points in steady sliding. What the terms below do
   * with a law that depends on the slip rate: its value and slope at the
   * sliding speed of each point, whose shares are those of the scene the terms
   * are built of.
   */
  NodalShares friction_shares(const ContactParameters &contact,
                              const ContactGeometry   &geometry);

  /**
   * The slip-rate terms of the friction law alone (transverse slip and slope),
   * with the normal forces of @p state.
   */
  void add_slip_rate_terms(const SceneParameters &scene,
                           const unsigned int     number,
                           const ContactGeometry &geometry,
                           const ContactState    &state,
                           AffineSystem          &system);

  /**
   * The whole linearised problem of a scene: bodies, springs and every contact
   * pair in the formulation and state of its parameters; mortar ties and
   * mortar contacts have their dependent unknowns eliminated, so the row space
   * of the result may be smaller than that of the discretisation.
   */
  struct LinearizedSystem
  {
    AffineSystem                 system;
    std::vector<ContactGeometry> contacts;
    std::vector<ContactState>    states; /**< the first of each pair */
    /** Unknowns of the discretisation from those of the system (the identity
     * where nothing was eliminated). */
    std::function<Block(const Block &)> expand;
    /** Forces on the unknowns of the discretisation as forces on those of the
     * system: the transposed map. */
    std::function<Block(const Block &)> restrict_forces;
    /** Functionals of the unknowns of the discretisation as functionals of
     * those of the system; empty where they are the same. */
    std::function<std::shared_ptr<const Functionals>(const Functionals &)>
      reduce;
  };
  /** The mortar couplings of all contacts of the scene in their order, empty
   * for those by point springs. Throws InputError as make_mortar_coupling(). */
  std::vector<MortarCoupling> contact_couplings(
    const Discretization &discretization);

  /** The contact states are those of the scene's parameters (the whole face
   * slips or sticks under an even pressure) unless @p states are given, one
   * list a pair, empty for those of the parameters. Throws InputError for
   * several states of a mortar pair: each of them has unknowns of its own.
   * @p couplings: contact_couplings() of the discretisation, or null to have
   * them made. */
  LinearizedSystem linearized_system(
    const Discretization              &discretization,
    const std::vector<BodyMatrices>   &bodies,
    const std::vector<ContactStates>  &states    = {},
    const std::vector<MortarCoupling> *couplings = nullptr);

  /**
   * The scene with its contacts cut open: bodies, springs and ties, and the
   * places where the contact pairs would touch (mortar pairs: the nodes of the
   * source face, with D_j as areas), as functionals of the unknowns of the
   * system. Every point is open.
   */
  LinearizedSystem separated_system(const Discretization &discretization,
                                    const std::vector<BodyMatrices> &bodies);
} // namespace squeal

#endif
