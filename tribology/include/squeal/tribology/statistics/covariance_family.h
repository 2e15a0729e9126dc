// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_statistics_covariance_family_h
#define squeal_tribology_statistics_covariance_family_h

#include <Eigen/Core>

#include <array>
#include <vector>

namespace squeal::tribology
{
  /** A place of a cell, in mean edges of cells. */
  using CellPlace = std::array<double, 2>;

  /**
   * One correlation of a lattice of them: normal, exponential or Matern 3/2;
   * fourteen lengths of 0.7 to 21 cells, the geometric mean of both axes; eight
   * ratios of the longer to the shorter axis up to 25; the longer one in two
   * directions (ratio 1.6), four (2.5) or twelve. Beside them the unit matrix.
   */
  struct CovarianceMember
  {
    int kind  = -1; /**< -1: cells are independent */
    int ratio = 0, direction = 0, length = 0;

    bool
    is_white() const
    {
      return kind < 0;
    }

    bool operator<(const CovarianceMember &other) const;
  };

  /** Correlations of all places with each other. */
  Eigen::MatrixXd correlations(const std::vector<CellPlace> &places,
                               const CovarianceMember       &member);

  /** Members all over the lattice, from which a search starts. */
  std::vector<CovarianceMember> first_members();

  /** What lies next to a member: another kind, the next length, the next ratio
   * in nearly the same direction, the next direction. */
  std::vector<CovarianceMember> neighbours(const CovarianceMember &member);
} // namespace squeal::tribology

#endif
