// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_statistics_spatial_covariance_h
#define squeal_tribology_statistics_spatial_covariance_h

#include <squeal/tribology/statistics/covariance_family.h>

#include <Eigen/Core>

#include <map>
#include <vector>

namespace squeal::tribology
{
  /**
   * How alike neighbouring cells of a map are, after covariates have been taken
   * out of it: a family of covariances (CovarianceMember) with an uncorrelated
   * part, each brought to its principal axes in the space that the covariates
   * leave.
   *
   * A search for the members that matter starts all over the family and goes on
   * from the likeliest to their neighbours, up to 300 members for a map; their
   * axes are kept for other maps.
   *
   * A fit is the residual likelihood (REML) of a member. What is smaller
   * than the resolution, a standard deviation of 3 % of the residual map, is
   * treated as unknown: the likelihood is that of the map plus white noise of
   * that size, in expectation, so that nothing is drawn. Smooth maps are then
   * judged by what a measurement can hold, not by their last digits.
   */
  class SpatialCovariance
  {
  public:
    /** Variance below which differences count for nothing, over the mean
     * variance of the residual map. */
    static constexpr double resolution = 1e-3;

    /** @p covariates has a row for each place; a constant is not added. Columns
     * that depend on others are left out. */
    SpatialCovariance(const std::vector<CellPlace> &places,
                      const Eigen::MatrixXd        &covariates);

    /** Dimension of what the covariates leave. */
    Eigen::Index n_free() const;

    /** Orthonormal columns over the cells: what the covariates leave. */
    const Eigen::MatrixXd &
    basis() const
    {
      return kept;
    }

    /** Coefficients of a map in the space that the covariates leave. */
    Eigen::VectorXd residual(const Eigen::VectorXd &map) const;

    /** One member of the family, fitted. */
    struct Fit
    {
      std::size_t     form   = 0;  /**< which principal axes */
      double          weight = 0.; /**< posterior; all add up to 1 */
      Eigen::VectorXd variance;    /**< along the axes, with the resolution */
      Eigen::VectorXd resolved;    /**< part of it that is the map's own */
    };

    /** The members that matter for a map, the likeliest first: 64 at most,
     * with 1e-4 of the best or more. None for a map of which the covariates
     * leave nothing. Forms of earlier fits may no longer be there. */
    std::vector<Fit> fit(const Eigen::VectorXd &map);

    /** Principal axes of a member, as rows over the residual() space. */
    const Eigen::MatrixXd &axes(std::size_t form) const;

    /** Takes coefficients along axes back to the cells: for sums over cells. */
    Eigen::VectorXd on_cells(std::size_t            form,
                             const Eigen::VectorXd &along_axes) const;

  private:
    struct Form
    {
      Eigen::MatrixXd axes;
      Eigen::VectorXd spectrum; /**< mean 1 */
    };

    class Search;

    std::size_t form_of(const CovarianceMember &member);

    std::vector<CellPlace>                  places;
    Eigen::MatrixXd                         kept;
    std::vector<Form>                       forms;
    std::map<CovarianceMember, std::size_t> known; /**< place in forms */
  };
} // namespace squeal::tribology

#endif
