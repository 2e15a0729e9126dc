// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_discretization_carried_damping_h
#define squeal_discretization_carried_damping_h

#include <squeal/base/sparse_matrix.h>
#include <squeal/discretization/discretization.h>

#include <memory>

namespace squeal
{
  /**
   * What a body that turns about z adds to the stiffness of its material
   * damping, for 1 rad/s. The particles see the rate of strain
   * u' + Omega T u with T = d/dtheta - e_z x, so that beta K u' of the fixed
   * frame goes with the circulatory part beta Omega A,
   *
   *   A = (K T - T^T K) / 2,  T = M^-1 H,
   *
   * with the lumped mass M and H = int phi_a T phi_b made skew. A is skew, as
   * K T is where K is the same at all angles.
   *
   * @param stiffness K of the body in the free unknowns
   * @return A, in the unit of K; append_to() throws InputError on more than
   * one rank
   */
  std::shared_ptr<const LinearOperator> carried_stiffness(
    const Discretization                      &discretization,
    const unsigned int                         body,
    const std::shared_ptr<const SparseMatrix> &stiffness);
} // namespace squeal

#endif
