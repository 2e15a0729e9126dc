// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/transient/run_in.h>

#include <algorithm>
#include <limits>

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
    const unsigned int n = model.n_nodes();
    if (!(model.speed_ratio.minCoeff() > 0.))
      throw InputError("Preload/Run-in: = archard needs pairs that all slide: "
                       "in one at rest nothing wears");
    // Columns: the forces by every free motion, and what they do to it.
    std::vector<int> free;
    for (unsigned int k = 0; k < model.n_modes(); ++k)
      if (model.omega_squared[k] == 0.)
        free.push_back(k);
    Eigen::MatrixXd by_motion = Eigen::MatrixXd::Zero(3 * n, free.size());
    for (unsigned int j = 0; j < n; ++j)
      {
        by_motion.row(3 * j) = areas[j] / model.speed_ratio[j] *
                               model.participation.row(3 * j)(free);
        by_motion.row(3 * j + 1) = friction[j] * by_motion.row(3 * j);
      }
    const Eigen::MatrixXd pushed =
      model.participation(Eigen::all, free).transpose() * by_motion;
    const Eigen::VectorXd load = model.load(free);
    Eigen::VectorXd       w    = Eigen::VectorXd::Zero(free.size());
    if (!free.empty())
      {
        // Motions across the normals push nothing: no equation for those.
        Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> balance_of_all;
        balance_of_all.setThreshold(1e-8);
        w = balance_of_all.compute(pushed).solve(load);
      }
    const Eigen::VectorXd forces = by_motion * w;
    double                least  = std::numeric_limits<double>::infinity();
    for (unsigned int j = 0; j < n; ++j)
      least = std::min(least, forces[3 * j]);
    const double left = (pushed * w - load).squaredNorm();
    if (free.empty() || !(least > 0.) ||
        !(left <= balance * load.squaredNorm()))
      throw InputError("Preload/Run-in: wear goes on until nothing presses any "
                       "more unless a load on a body that is free along the "
                       "normal follows it");

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
