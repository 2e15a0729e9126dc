// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_contact_contact_nodes_h
#define squeal_contact_contact_nodes_h

#include <squeal/contact/contact_geometry.h>
#include <squeal/contact/friction_law.h>

#include <Eigen/Dense>

#include <string>
#include <vector>

namespace squeal
{
  /** One pair among the contact nodes of a scene. */
  struct ContactPair
  {
    /** Of the scene, but with a friction coefficient >= 0. */
    ContactParameters parameters;
    /** With sliding and transverse direction reversed where the friction
     * coefficient of the scene is negative: the target turns backwards. */
    ContactGeometry geometry;
    unsigned int    first = 0; /**< of its nodes among all */

    const std::string &name() const;
    unsigned int       n_nodes() const;
    /** Whether the target slides; of a pair at rest (a sliding speed of 0,
     * such as an abutment) nodes stick until they are pushed. */
    bool slides() const;
    /** Its part of one number, or @p per_node numbers, of every node. */
    Eigen::VectorXd            part(const Eigen::VectorXd &all,
                                    const unsigned int     per_node = 3) const;
    std::vector<ContactStatus> part(
      const std::vector<ContactStatus> &all) const;
  };

  /**
   * The contact nodes of all pairs of a scene in one list, pair after pair, in
   * the order of the scene: one contact problem couples them. Forces and
   * motions have three numbers a node: normal, along and across the sliding of
   * its pair.
   */
  class ContactNodes
  {
  public:
    ContactNodes() = default;
    ContactNodes(const std::vector<ContactParameters> &contacts,
                 std::vector<ContactGeometry>          geometries);

    const std::vector<ContactPair> &pairs() const;
    unsigned int                    n_nodes() const;
    /** Number of the pair that @p node belongs to. */
    unsigned int pair_of(const unsigned int node) const;

    /** The largest sliding speed of a pair, m/s, that the others are measured
     * by; 0: everything is at rest. */
    double speed() const;
    /** |V| of every node over speed(): 0 in pairs at rest. Where all are, |V|
     * over its mean over the points of the pair. */
    Eigen::VectorXd     speed_ratio() const;
    std::vector<double> areas() const; /**< m^2, of every node */
    /** What springs between the faces give way, m/N, three a node. */
    Eigen::VectorXd compliance() const;
    /** B: three rows a node. */
    Functionals relative_motion() const;
    /** Whether a node slides against the direction that it has in @p other,
     * whose pairs have the same faces: then its rows of B along and across the
     * sliding have the other sign. */
    std::vector<bool> turned_back_from(const ContactNodes &other) const;

    /** @name Friction, by pairs */
    //@{
    FrictionLaws  laws() const;
    NodalFriction in_sliding() const; /**< at the sliding speeds */
    /** The sizes of the coefficients. */
    std::vector<double> coefficients() const;
    /** Other ones >= 0 for the same directions of sliding. Throws InputError
     * where a table gives the coefficients of a pair that is to change. */
    void set_coefficients(const std::vector<double> &coefficients);
    //@}

  private:
    std::vector<ContactPair> all;
  };

  /** The sizes of the friction coefficients of all pairs. */
  std::vector<double> friction_sizes(
    const std::vector<ContactParameters> &contacts);
} // namespace squeal

#endif
