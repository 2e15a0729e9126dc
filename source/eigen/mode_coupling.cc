// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mode_coupling.h"

#include <squeal/base/worst_of.h>
#include <squeal/eigen/mass_basis.h>

#include <algorithm>

namespace squeal
{
  double
  worst_coupling(const UndampedModes &modes,
                 const unsigned int   n,
                 const double         limit,
                 const RowSpace      &space)
  {
    if (n == 0)
      return 0.;
    // Some of them against all: what goes wrong goes wrong for many.
    std::vector<Eigen::Index> some;
    for (unsigned int k = 0; k < std::min(n, 32u); ++k)
      some.push_back(k * std::size_t(n) / std::min(n, 32u));
    const Eigen::VectorXd omega =
      modes.omega_squared.head(n).cwiseAbs().cwiseMax(1e-2 * limit).cwiseSqrt();
    const Block     X = modes.shapes(Eigen::all, some);
    Eigen::MatrixXd M =
      inner_products(space, X, modes.mass_products.leftCols(n));
    Eigen::MatrixXd K =
      inner_products(space, X, modes.stiffness_products.leftCols(n));
    for (std::size_t k = 0; k < some.size(); ++k)
      {
        M(k, some[k]) -= 1.;
        K(k, some[k]) -= modes.omega_squared[some[k]];
        K.row(k) /= omega[some[k]];
      }
    K = (K * omega.cwiseInverse().asDiagonal()).eval();
    return worst_of(M.cwiseAbs().maxCoeff<Eigen::PropagateNaN>(),
                    K.cwiseAbs().maxCoeff<Eigen::PropagateNaN>());
  }
} // namespace squeal
