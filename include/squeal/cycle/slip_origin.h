// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_cycle_slip_origin_h
#define squeal_cycle_slip_origin_h

#include <squeal/cycle/cycle_friction.h>
#include <squeal/cycle/orbit.h>

#include <optional>

namespace squeal
{
  /** A force beside its straight line over a step, as a line of the same
   * impulse and moment, N. */
  struct BesideLine
  {
    Eigen::Vector3d at_start, at_end;
  };

  /**
   * Where nodes change their status within a step: told from the step itself
   * and from the two before, whose forces, gaps and slip rates go on as they
   * did. Times are known to second order, which makes a period of steps and its
   * derivative smooth to second order.
   *
   * A node that comes to rest has slipped on until then, and one that closes
   * has moved freely: slip that friction resists is counted from there.
   */
  class ChangesInStep
  {
  public:
    /** At the start of a step of length @p step, s. References are kept. */
    ChangesInStep(const ReducedContactModel &model,
                  const CycleFriction       &friction,
                  const double               step,
                  const Eigen::VectorXd     &force,
                  const Eigen::VectorXd     &motion,
                  const ContactPast         &past);

    /** What a node moves over its target before slip counts, m, if it is
     * closed at the end of the step, and the share of the step until then. */
    struct Origin
    {
      double          share = 0.;
      Eigen::Vector2d slip  = Eigen::Vector2d::Zero();
    };
    Origin origin(const unsigned int node) const;

    /** The share of the step after which @p node has the status @p now; none
     * where it had it before or where that is not known. */
    std::optional<double> share(const unsigned int  node,
                                const ContactStatus now) const;

    /** Whether the limit of a node in the step is that of sticking: it has
     * stuck, and nothing lets go. */
    bool is_held_at_rest(const unsigned int node) const;

    /** The share of the step after which the force of a node that has stuck
     * falls to the limit of slip; none where it goes on sticking or where both
     * limits are the same. */
    std::optional<double> release(const unsigned int node) const;

    /** What release() moves by with the forces of the node, at the start of the
     * step and one step before, 1/N. */
    std::pair<Eigen::Vector3d, Eigen::Vector3d> release_by_forces(
      const unsigned int node) const;

    /** What the force jumps by at its release() at @p share, N. */
    Eigen::Vector3d jump(const unsigned int node, const double share) const;

    /** The force of a node that changes its status at @p share and is @p end, N,
     * at the end of the step: it goes on as before until then and is bent
     * there; at a release it jumps. */
    BesideLine beside_line(const unsigned int     node,
                           const double           share,
                           const Eigen::Vector3d &end) const;
    /** Triangles, nothing at both ends of the step, up to @p before and from @p
     * after at @p share. */
    static BesideLine beside_line(const double           share,
                                  const Eigen::Vector3d &before,
                                  const Eigen::Vector3d &after);

    /** Slip rate of a closing node over the rate of its gap, where it closes:
     * what its origin moves by with its motion along the normal. Zero for
     * nodes that do not close. */
    Eigen::Vector2d slip_over_gap(const unsigned int node) const;

  private:
    Eigen::Vector2d last_slip(const unsigned int node) const;
    Eigen::Vector2d slip_before(const unsigned int node) const;
    double          gap(const unsigned int node) const;
    double          gap_change(const unsigned int node) const;
    Origin          stop(const unsigned int node) const;
    /** Rates are per step. */
    struct Closing
    {
      double          share = 1., gap_rate = 0.;
      Eigen::Vector2d slip, slip_rate;
    };
    Closing closing(const unsigned int node) const;
    /** Of forces, what is left of Coulomb's limit of nodes that stick. */
    double reserve(const unsigned int node, const Eigen::Vector3d &f) const;
    /** The same one step before less that at the start. */
    double          fall_of_reserve(const unsigned int node) const;
    Eigen::Vector3d force_of(const unsigned int node) const;

    const ReducedContactModel &model;
    const CycleFriction       &friction;
    const double               way; /**< of the target in a step, m */
    const Eigen::VectorXd     &force, &motion;
    const ContactPast         &past;
  };
} // namespace squeal

#endif
