// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_discretization_centrifugal_stress_h
#define squeal_discretization_centrifugal_stress_h

#include <squeal/base/sparse_matrix.h>
#include <squeal/discretization/discretization.h>

#include <memory>

namespace squeal
{
  /**
   * What the stress sigma of the centrifugal forces rho Omega^2 r adds to the
   * stiffness of a meshed body that turns about z, in the free unknowns, for
   * density 1 and 1 rad/s: S = int sigma_kl dw_i/dx_k du_i/dx_l, m^3.
   *
   * The stress is that of the body alone with its supports, as if linear; it
   * does not depend on the size of the moduli. With it the turning of a body
   * as a whole has no stiffness: the virial of the stress is that of the
   * centrifugal forces. Of a body that nothing holds its place is left open,
   * which the stress does not depend on.
   *
   * Throws ComputationError where the static problem can not be solved.
   */
  std::shared_ptr<const SparseMatrix> centrifugal_stress_stiffness(
    const Discretization &discretization,
    const unsigned int    body);
} // namespace squeal

#endif
