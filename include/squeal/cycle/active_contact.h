// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_cycle_active_contact_h
#define squeal_cycle_active_contact_h

#include <squeal/cycle/slip_origin.h>

namespace squeal
{
  /**
   * The unknowns of the closed nodes of a linearised step: lambda = Q x, and
   * the rows R of the motion that they answer to. A slipping node has its
   * normal force, which friction follows, and the force across its slip; one
   * that sticks has all three.
   */
  class ActiveContact
  {
  public:
    struct Unknown
    {
      unsigned int    node;
      Eigen::Vector3d force;    /**< by a unit of it */
      Eigen::Vector3d row;      /**< of the motion */
      double          give;     /**< added to the diagonal, m/N */
      bool            moves_on; /**< counts from the motion before */
    };
    /** What the slip of a node is counted from moves with the motions before
     * the step. */
    struct Origin
    {
      unsigned int    node;
      double          share;         /**< of the last change of motion */
      Eigen::Vector2d slip_over_gap; /**< see ChangesInStep */
    };

    ActiveContact() = default;
    /** Forces of the nodes of @p rows, three a node, one by one. */
    explicit ActiveContact(const std::vector<int> &rows,
                           const unsigned int      n_nodes);
    /** @p status, @p forces: at the end of the step. @p slip: over it, from
     * where it counts. */
    ActiveContact(const std::vector<ContactStatus> &status,
                  const Eigen::VectorXd            &forces,
                  const Eigen::VectorXd            &slip,
                  const Eigen::VectorXd            &friction);

    /** Where a node changes its status, what a disturbance does to the forces
     * jumps, to its own and by the @p flexibility to those of others: a
     * straight line over the step would have half of it before and half
     * behind. */
    void locate(const ChangesInStep              &changes,
                const std::vector<ContactStatus> &status,
                const Eigen::MatrixXd            &flexibility);

    Eigen::Index
    size() const
    {
      return unknowns.size();
    }
    /** A Q, A with three columns a node. */
    Eigen::MatrixXd times_forces(const Eigen::MatrixXd &A) const;
    /** R A, A with three rows a node. */
    Eigen::MatrixXd rows_of(const Eigen::MatrixXd &A) const;
    /** Of @p row, three numbers of a node, times Q. */
    Eigen::VectorXd row_of_forces(const unsigned int     node,
                                  const Eigen::Vector3d &row) const;
    /** Q x, three rows a node. */
    Eigen::MatrixXd forces(const Eigen::MatrixXd &x) const;

    std::vector<Unknown> unknowns;
    std::vector<Origin>  origins; /**< of nodes that have one of their own */
    /** Of every node, what its forces at the start and at the end of the step
     * count by, over those of a straight line. */
    Eigen::VectorXd weight_before, weight_after;

  private:
    void add_slipping(const unsigned int     node,
                      const double           normal,
                      const Eigen::Vector2d &slip,
                      const double           mu);
  };
} // namespace squeal

#endif
