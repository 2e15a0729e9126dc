// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_discretization_assembly_h
#define squeal_discretization_assembly_h

#include <squeal/base/sparse_matrix.h>
#include <squeal/discretization/discretization.h>

#include <memory>
#include <vector>

namespace squeal
{
  /** The matrices of one meshed or rigid body in the free unknowns. */
  struct BodyMatrices
  {
    std::shared_ptr<const SparseMatrix> stiffness; /**< E = 1 Pa if isotropic;
                                                      null for rigid bodies */
    std::shared_ptr<const SparseMatrix> mass;      /**< density 1 kg/m^3, or the
                                                      whole mass if rigid */
    std::shared_ptr<const SparseMatrix> gyroscopic;  /**< density 1, 1 rad/s;
                                                        null unless turning */
    std::shared_ptr<const SparseMatrix> convective;  /**< as gyroscopic */
    double                              volume = 0.; /**< m^3; 0 if rigid */
    dealii::Point<3>                    centre;      /**< of gravity, m */
  };

  /** Inertia of a meshed body in axes that turn with it about z, in the free
   * unknowns, for density 1 and 1 rad/s: at the speed Omega the forces
   * rho (-2 Omega G u' + Omega^2 N u) act on it. */
  struct TurningAxes
  {
    std::shared_ptr<const SparseMatrix> coriolis;    /**< G, skew, m^3 */
    std::shared_ptr<const SparseMatrix> centrifugal; /**< N, m^3 */
  };
  TurningAxes turning_axes(const Discretization &discretization,
                           const unsigned int    body);

  /** Assembles every body of the scene. */
  std::vector<BodyMatrices> assemble_bodies(
    const Discretization &discretization);
} // namespace squeal

#endif
