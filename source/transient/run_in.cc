// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/transient/run_in.h>

namespace squeal
{
  namespace
  {
    /** What the forces may leave of the loads on the free motions. */
    constexpr double balance = 1e-6;
  } // namespace



  Eigen::VectorXd
  worn_gap(const ReducedContactModel &model,
           const std::vector<double> &areas,
           const Eigen::VectorXd     &friction)
  {
    const unsigned int n      = model.n_nodes();
    Eigen::VectorXd    forces = Eigen::VectorXd::Zero(3 * n);
    for (unsigned int j = 0; j < n; ++j)
      {
        forces[3 * j]     = areas[j] / model.speed_ratio[j];
        forces[3 * j + 1] = friction[j] * forces[3 * j];
      }
    // Their size by the balance of the motions that nothing holds.
    const Eigen::VectorXd pushed  = model.participation.transpose() * forces;
    double                product = 0., square = 0., load_square = 0.;
    for (unsigned int k = 0; k < model.n_modes(); ++k)
      if (model.omega_squared[k] == 0.)
        {
          product += pushed[k] * model.load[k];
          square += pushed[k] * pushed[k];
          load_square += model.load[k] * model.load[k];
        }
    if (!(product > 0.) ||
        load_square - product * product / square > balance * load_square)
      throw InputError("Preload/Run-in: wear goes on until nothing presses any "
                       "more unless a load on a body that is free along the "
                       "normal follows it");
    forces *= product / square;

    Eigen::VectorXd motion = model.load_motion - model.flexibility * forces;
    for (unsigned int k = 0; k < model.n_modes(); ++k)
      if (model.omega_squared[k] > 0.)
        motion += model.participation.col(k) *
                  ((model.load[k] - model.participation.col(k).dot(forces)) /
                   model.omega_squared[k]);
    Eigen::VectorXd gap(n);
    for (unsigned int j = 0; j < n; ++j)
      gap[j] = motion[3 * j];
    return gap;
  }
} // namespace squeal
