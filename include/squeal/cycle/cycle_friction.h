// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_cycle_cycle_friction_h
#define squeal_cycle_cycle_friction_h

#include <squeal/contact/friction_law.h>

#include <Eigen/Dense>

namespace squeal
{
  /** Coulomb's law at the nodes of a reduced model whose targets slide on. */
  struct CycleFriction
  {
    Eigen::VectorXd kinetic; /**< mu >= 0 of every node that slips */
    Eigen::VectorXd at_rest; /**< of those that stick, >= kinetic; empty: the
                                same */
    double speed = 0.;       /**< that the nodes' are measured by, m/s */

    /** Throws InputError where a coefficient depends on the slip rate. */
    static CycleFriction of_laws(const FrictionLaws &laws,
                                 const unsigned int  n_nodes,
                                 const double        speed);

    double
    limit_at_rest(const unsigned int node) const
    {
      return at_rest.size() > 0 ? at_rest[node] : kinetic[node];
    }
    /** Whether the force of a node jumps where it begins to slip. */
    bool
    jumps(const unsigned int node) const
    {
      return limit_at_rest(node) > kinetic[node];
    }
    bool
    jumps() const
    {
      return at_rest.size() > 0 && (at_rest.array() > kinetic.array()).any();
    }
  };
} // namespace squeal

#endif
