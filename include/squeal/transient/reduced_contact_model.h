// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_transient_reduced_contact_model_h
#define squeal_transient_reduced_contact_model_h

#include <squeal/contact/contact_nodes.h>
#include <squeal/transient/reduction_basis.h>

#include <vector>

namespace squeal
{
  /**
   * The bodies without contact in their modes up to a cut-off, and the contact
   * nodes on the quasi-static flexibility of all higher modes: a massless
   * interface.
   *
   * Contact forces lambda (three a node: normal, along and across the sliding,
   * interleaved) act as -B^T lambda on the bodies. The relative motion of the
   * nodes, target minus source, is
   *   B u = Psi q + (residual motion by the load) - G lambda,
   *   q'' + D q' + diag(omega^2) q = phi^T f - Psi^T lambda,
   *   D = phi^T C phi,
   * with mass-normalised modes phi, Psi = B phi and
   *   G = B K^-1 B^T - Psi diag(omega^-2) Psi^T,
   * so that statics are exact for any basis (Craig and Chang's residual
   * flexibility; massless contact: Khenous, Laborde, Renard 2008). The inertia
   * and damping of the residual part are left out.
   */
  struct ReducedContactModel
  {
    Eigen::VectorXd omega_squared; /**< (rad/s)^2; 0 for rigid motions */
    Eigen::VectorXd damping;       /**< diagonal of D, 1/s: alpha + beta omega^2
                                      where the whole model has one damping, and
                                      that of the cut-off */
    /** D without its diagonal, 1/s: what damping of single bodies and dashpots
     * makes of one mode in another. Empty where there is nothing. */
    Eigen::MatrixXd damping_coupling;
    Eigen::MatrixXd participation; /**< Psi: 3 nodes x modes */
    Eigen::MatrixXd flexibility;   /**< G: 3 nodes x 3 nodes, m/N, symmetric */
    /** What the flexibility leaves out, see ResidualFlexibility; empty where
     * the model is that of steady sliding. */
    Eigen::MatrixXd residual_inertia, residual_damping;
    /** 3 nodes x modes; empty too where the damping leaves nothing of it. */
    Eigen::MatrixXd residual_coupling;
    Eigen::VectorXd load;        /**< phi^T f at full load */
    Eigen::VectorXd load_motion; /**< residual motion of the nodes, m */
    /** What of it is that of a held support and not of the load; empty without
     * one. */
    Eigen::VectorXd support_motion;
    /** f R f of the load on the residual flexibility R of the bodies, N m. */
    double          load_flexibility = 0.;
    Eigen::VectorXd initial_gap; /**< of every node, m */
    /** Observed motions: modes q + load share * load - contact lambda. */
    struct Observation
    {
      Eigen::MatrixXd modes;   /**< observers x modes */
      Eigen::VectorXd load;    /**< at full load */
      Eigen::MatrixXd contact; /**< observers x 3 nodes */

      Eigen::VectorXd evaluate(const Eigen::VectorXd &coordinates,
                               const double           load_share,
                               const Eigen::VectorXd &forces) const;
    };
    Observation observed;
    /** |V| of every node over the speed of the drive; 0 in pairs at rest. */
    Eigen::VectorXd speed_ratio;
    double          cut_off; /**< Hz: all modes below it are there */

    /** Turns the directions along and across the sliding back at the nodes
     * where @p of_nodes is true. */
    void turn_back(const std::vector<bool> &of_nodes);

    unsigned int
    n_modes() const
    {
      return omega_squared.size();
    }
    bool
    has_coupled_damping() const
    {
      return damping_coupling.size() > 0;
    }
    /** D v for rates @p v of the coordinates. */
    template <typename Vector>
    Vector
    damping_forces(const Vector &v) const
    {
      Vector result = damping.cwiseProduct(v);
      if (has_coupled_damping())
        result += damping_coupling * v;
      return result;
    }
    unsigned int
    n_nodes() const
    {
      return initial_gap.size();
    }
  };

  /** Whether nothing moves @p node in @p direction, of unit size (normal,
   * along and across the sliding), and that lies in the face: a support holds
   * it, as on a plane of symmetry. It takes friction that way only where its
   * target slides past it. @p flexibility: 3 nodes x 3 nodes, m/N; what is below
   * 1e-12 of that along the normal is rounding. */
  bool is_held_along_face(const Eigen::MatrixXd &flexibility,
                          const unsigned int     node,
                          const Eigen::Vector3d &direction);

  /** The same of @p model, which may move a node by its modes alone. */
  bool is_held_along_face(const ReducedContactModel &model,
                          const unsigned int         node,
                          const Eigen::Vector3d     &direction);

  /** Gives nodes that are held along the face, in one of its two directions,
   * some of the flexibility that they have along their normal: nothing moves
   * them, so that any serves, and without one @p flexibility, 3 nodes x 3 nodes,
   * m/N, could not be inverted. @p speed_ratio: 0 of nodes at rest. */
  void fill_where_held(Eigen::MatrixXd       &flexibility,
                       const Eigen::VectorXd &speed_ratio);

  /** What does the same for all other motions along the face that @p flexibility
   * has not: of nodes that are held obliquely to the sliding, or of many nodes
   * on a body that has fewer motions there. Forces in these do nothing, so that
   * it is 1e-6 of the least motion that there is, which leaves the sum of
   * friction to what moves. 3 nodes x 3 nodes, m/N, positive semidefinite and
   * zero for what moves; empty where there is none of them. */
  Eigen::MatrixXd fill_of_null_space(const Eigen::MatrixXd &flexibility);

  /** The same for what @p model does not move, beside @p flexibility, that of
   * the model as it is solved: its motions without a stiffness would drown the
   * others. */
  Eigen::MatrixXd fill_of_null_space(const ReducedContactModel &model,
                                     const Eigen::MatrixXd     &flexibility);

  /** The same beside what its held modes and the rest give way at rest. */
  Eigen::MatrixXd fill_of_null_space(const ReducedContactModel &model);

  /** Throws InputError where the damping of @p pencil is not viscous. */
  void check_time_domain_damping(const Pencil &pencil);

  /** What of the flexibility G is computed. */
  enum class Flexibility
  {
    complete,
    /** All that the contact states of steady sliding depend on, with a third of
     * the work. Where a target slides friction has the direction of the
     * sliding, whatever the faces move along themselves: what forces along the
     * faces move there is taken from the normals, which keeps G positive. */
    of_sliding,
    /** The same part by part, so that other moduli and loads ask for no other
     * solution; see StaticsByPart. */
    of_sliding_by_part
  };

  /**
   * Reduces the bodies of @p pencil (no contact in it) with the contact nodes
   * of all pairs, and the springs between their faces, under the nodal forces
   * @p load.
   *
   * @param pencil     symmetric, viscously damped
   * @param basis      the motions that carry mass
   * @param cut_off    Hz
   * @param observers  columns l of motions l^T u to be observed; one with NaN
   *                   is not known and gives NaN
   * Throws InputError where the damping is not viscous.
   */
  ReducedContactModel reduce_contact_model(
    const Pencil         &pencil,
    const ReductionBasis &basis,
    const double          cut_off,
    const ContactNodes   &nodes,
    const Block          &load,
    const Block          &observers   = {},
    const Flexibility     flexibility = Flexibility::complete);

  /** The damping ratio @p ratio min(1, (f/cut_off)^8) at frequency @p f, both in
   * Hz (theory.md, "Ringing at the cut-off"). */
  double cut_off_damping(const double ratio,
                         const double cut_off,
                         const double f);

  /** Adds that of @p ratio at the model's cut-off to all its modes. */
  void add_cut_off_damping(ReducedContactModel &model, const double ratio);

  /** What further nodal forces f do: their share in the modes, phi^T f, the
   * motion of the contact nodes and of the observers on the flexibility of the
   * others, and f itself. */
  struct ModalForce
  {
    Eigen::VectorXd modal, motion, nodal, observed;
    Eigen::VectorXd response = {}; /**< residual motion of all unknowns, m */
  };

  /** The columns of @p forces as modal forces of the same reduction. */
  std::vector<ModalForce> modal_forces(const Pencil         &pencil,
                                       const ReductionBasis &basis,
                                       const Functionals    &relative_motion,
                                       const Block          &forces,
                                       const Block          &observers);
} // namespace squeal

#endif
