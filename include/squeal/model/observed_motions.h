// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_model_observed_motions_h
#define squeal_model_observed_motions_h

#include <squeal/contact/contact_nodes.h>
#include <squeal/discretization/assembly.h>

namespace squeal
{
  /** Adds @p factor times a functional of the displacements to @p column. */
  void add_functional(const RowSpace             &space,
                      const Functionals::Row     &row,
                      const double                factor,
                      Eigen::Ref<Eigen::VectorXd> column);

  /** What @p force presses with against the outward @p normal of a target, in N:
   * its component, 0 where that pulls or is no more than what rounded
   * coordinates make of a force along the face. */
  double pressing_part(const dealii::Tensor<1, 3> &force,
                       const dealii::Tensor<1, 3> &normal);

  /** The columns l of the motions l^T u that PressedModel::Observer names, one
   * pair after the other: free unknowns of the discretisation x observers. NaN
   * in a column of a motion that the scene does not have. Collective. */
  Block observed_motions(const Discretization            &discretization,
                         const ContactNodes              &nodes,
                         const std::vector<BodyMatrices> &bodies);
} // namespace squeal

#endif
