// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_statistics_spatial_covariance_h
#define squeal_tribology_statistics_spatial_covariance_h

#include <Eigen/Core>

#include <array>
#include <vector>

namespace squeal::tribology
{
  /** A place of a cell, in cells. */
  using CellPlace = std::array<double, 2>;

  /**
   * How alike neighbouring cells of a map are, after covariates have been taken
   * out of it: a family of covariances (normal, exponential, Matern 3/2;
   * fourteen correlation lengths; five ratios of the lengths along and across;
   * none) with an uncorrelated part, each brought to its principal axes in
   * the space that the covariates leave.
   *
   * A fit is the residual likelihood (REML) of every member. What is smaller
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

    /** The members that matter for a map (1e-4 of the best), none for a map
     * of which the covariates leave nothing. */
    std::vector<Fit> fit(const Eigen::VectorXd &map) const;

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

    void add(const Eigen::MatrixXd &correlation);

    Eigen::MatrixXd   kept; /**< orthonormal columns over the cells */
    std::vector<Form> forms;
  };
} // namespace squeal::tribology

#endif
