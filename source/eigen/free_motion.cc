// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/number_text.h>
#include <squeal/eigen/free_motion.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <vector>

namespace squeal
{
  namespace
  {
    /** What rounding leaves of omega^2, relative to the shift by which the
     * modes were found. */
    constexpr double rounding_of_shift = 1e-15;

    /** A mode whose residual is so much of what it is compared with is all
     * rounding: of a stiffness that is large beside the limit, which leaves
     * more than a share of the limit. */
    constexpr double all_rounding = 0.5;

    /** |x|^T |K_0| |x| of the columns of @p X. */
    Eigen::VectorXd
    sizes_of_stiffness(const Pencil &pencil, const Block &X)
    {
      const Block     size = X.cwiseAbs();
      Eigen::MatrixXd sums = Eigen::MatrixXd::Zero(1, X.cols());
      for (const auto &part : pencil.parts())
        if (const double k = std::abs(part.coefficients.stiffness.real());
            part.symmetric && k != 0.)
          sums += k * size.cwiseProduct(part.matrix->multiply_absolute(size))
                        .colwise()
                        .sum();
      pencil.space()->sum(sums);
      return sums.transpose();
    }
  } // namespace



  std::string
  FreeMotions::text(const std::string &of_bodies) const
  {
    const Eigen::Index n = shapes.cols();
    return std::to_string(n) +
           (n == 1 ? " motion at 0 Hz is" : " motions at 0 Hz are") +
           " held by nothing" + of_bodies + " (or move below " +
           rounded_text(frequency_of_rounding, 2) +
           " Hz, which rounding does not tell from 0)";
  }



  FreeMotions
  find_free_motions(const Pencil        &pencil,
                    const UndampedModes &modes,
                    const double         limit,
                    const double         rounding)
  {
    std::vector<int> candidates;
    for (Eigen::Index i = 0; i < modes.omega_squared.size(); ++i)
      if (is_free_motion(modes.omega_squared[i], limit) ||
          modes.residual[i] > all_rounding)
        candidates.push_back(i);
    const Block X = modes.shapes(Eigen::all, candidates);
    if (candidates.empty())
      return {X};
    // A free motion and a held one that the limit does not tell apart may have
    // been combined; their stiffness parts them.
    const Eigen::MatrixXd K =
      pencil.space()->dot(X, pencil.multiply_undamped_stiffness(X));
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(
      0.5 * (K + K.transpose()));
    const Block           Y     = X * solver.eigenvectors();
    const Eigen::VectorXd sizes = sizes_of_stiffness(pencil, Y);
    std::vector<int>      free;
    double                most = 0.;
    for (Eigen::Index i = 0; i < sizes.size(); ++i)
      if (const double hidden = rounding * sizes[i] + rounding_of_shift * limit;
          solver.eigenvalues()[i] <= hidden)
        {
          free.push_back(i);
          // A candidate of the limit lies below its share.
          most = std::max(
            most,
            std::min(hidden, std::max(solver.eigenvalues()[i], 1e-9 * limit)));
        }
    return {Y(Eigen::all, free), std::sqrt(most) / (2. * M_PI)};
  }
} // namespace squeal
