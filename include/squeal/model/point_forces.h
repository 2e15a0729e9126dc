// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_model_point_forces_h
#define squeal_model_point_forces_h

#include <squeal/discretization/eigenvalue_error.h>
#include <squeal/model/model.h>

#include <Eigen/Sparse>

#include <functional>
#include <vector>

namespace squeal
{
  /** Which rows of the contact stiffness K act on a vector. */
  enum class FrictionForces
  {
    none,      /**< of undamped modes */
    sliding,   /**< K x: the friction follows the normal force */
    transposed /**< K^T y: the normal force follows the motion along the sliding
                */
  };

  /** The forces of springs and spring contacts on the bodies while they move in
   * the columns of @p full (rows of the discretisation), as estimates of the
   * discretisation error need them. Dashpots and slip rates are left out. */
  std::vector<PointForces> spring_forces(const Model         &model,
                                         const Block         &full,
                                         const FrictionForces friction);

  /**
   * What mortar contacts and ties pass on, as tractions at the quadrature
   * points of the source face. Where nodes are tied or stick it is the mean of
   * the stresses of both sides, weighted as between two cells of one body;
   * where they slip this is so of the normal part, and friction follows it;
   * where they are open it is zero. Of stresses that a side does not have
   * there: the forces K_b u - M_b u W_b that body b leaves over at the nodes,
   * over their areas.
   *
   * @param inertia W_b of a body, 1/s^2, for the columns of @p full
   */
  std::vector<PointForces> mortar_forces(
    const Model &model,
    const Block &full,
    const std::function<Eigen::SparseMatrix<double>(const unsigned int body)>
                        &inertia,
    const FrictionForces friction);

  /** All forces on the undamped modes @p full, without friction: those of
   * springs and of mortar contacts and ties. */
  std::vector<PointForces> undamped_forces(
    const Model           &model,
    const Block           &full,
    const Eigen::VectorXd &omega_squared);
} // namespace squeal

#endif
