// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_statistics_conditional_link_h
#define squeal_tribology_statistics_conditional_link_h

#include <squeal/tribology/statistics/cell_lags.h>
#include <squeal/tribology/statistics/shared_causes.h>
#include <squeal/tribology/statistics/spatial.h>
#include <squeal/tribology/statistics/spatial_covariance.h>

#include <array>
#include <map>
#include <memory>
#include <vector>

namespace squeal::tribology
{
  /** Why nothing can be said about a link. */
  enum class Silence
  {
    few_cells,        /**< beside what is taken out */
    index_constant,   /**< the same in all cells */
    feature_constant, /**< likewise */
    index_explained,  /**< a combination of what is taken out */
    feature_explained /**< likewise */
  };

  /** Link of two maps beside what both follow anyway. */
  struct ConditionalLink
  {
    double      r           = 0.; /**< partial correlation */
    double      n_effective = 0.; /**< independent cells behind it */
    double      between     = 0.; /**< variance of z between covariances */
    double      p           = 1.; /**< two-sided */
    std::size_t n_cells     = 0;  /**< cells, or merged blocks of them */
    std::size_t n_taken     = 0;  /**< degrees of freedom of shared causes */

    /** Whether the cells allow a statement at all. */
    bool    is_known = false;
    Silence silence  = Silence::few_cells; /**< where it is not */

    /** Index and feature along the principal axes of the likeliest covariance,
     * over their standard deviations: as good as independent pairs. */
    std::array<Eigen::VectorXd, 2> pairs;
    double likeness = 1.; /**< that they still have, a factor of variances */
    /** Of the sum of products that r comes from, what one row or one column of
     * cells carries: nearly all of it where both maps step there. */
    double of_one_line = 0.;
  };

  /** Interval of the partial correlation at @p level: Fisher's z with the
   * independent cells; (-1, 1) where nothing is known. */
  std::array<double, 2> conditional_interval(const ConditionalLink &link,
                                             double                 level);

  /**
   * The same from @p n bootstraps of the pairs along the principal axes, which
   * unlike cells or blocks of cells are independent: z plus and minus Student's
   * quantile, with the independent cells, times the standard deviation of the
   * resampled z and of z between covariances, and never narrower than
   * conditional_interval(). (-1, 1) for fewer than 20 resamplings.
   */
  std::array<double, 2> bootstrap_interval(const ConditionalLink &link,
                                           unsigned int           n,
                                           double                 level,
                                           std::mt19937_64       &generator);

  /**
   * Tests on the cells that two maps share: the feature is regressed on the
   * shared causes and on the index, with the covariance of the feature's own
   * residuals (generalised least squares, SpatialCovariance). The p-value is
   * that of Student's t, averaged over the members of the family by their
   * posterior weights; its degrees of freedom are Satterthwaite's, of the
   * variances that the map holds above the resolution. Where index and
   * residuals scatter more at the same cells, the variance of the slope grows
   * by as much (White 1980). Where both are still alike over the same lags,
   * which the member of the family did not describe, it grows by what that
   * likeness costs in independent cells (CellLags), and the degrees of freedom
   * fall by it. r is the partial correlation, t / sqrt(t^2 + dof);
   * the independent cells are those with which Fisher's z scatters as it does
   * within the members and between them.
   *
   * Maps of more than 300 cells are merged to blocks of 2 x 2, again until
   * they are fewer; shared causes likewise. Distances are those on the pad.
   */
  class ConditionalTest
  {
  public:
    /** @p cells are those where both maps are known; @p causes has a row for
     * each cell of the grid. */
    ConditionalTest(const GridMap                  &grid,
                    const std::vector<std::size_t> &cells,
                    const Eigen::MatrixXd          &causes);

    ConditionalLink measure(const GridMap &index, const GridMap &feature);

    /** Fewest cells beyond the shared causes that allow a statement. */
    static constexpr Eigen::Index fewest = 8;

  private:
    Eigen::VectorXd values(const GridMap &map) const;

    /** Fits of maps that were asked for before: one feature against many
     * indices. */
    const std::vector<SpatialCovariance::Fit> &fits(
      const Eigen::VectorXd &feature);

    /** Cells of each block. */
    std::vector<std::vector<std::size_t>> blocks;
    std::size_t                           n_taken = 0;
    std::unique_ptr<SpatialCovariance>    covariance;
    std::unique_ptr<CellLags>             lags;
    double white = 1.; /**< variance over lags of white maps, times n_free */
    Eigen::VectorXd                     fitted_map;
    std::vector<SpatialCovariance::Fit> fitted;
  };

  /** The tests of one pad: one for each set of cells that two maps share. */
  class ConditionalTests
  {
  public:
    explicit ConditionalTests(const SharedCauses &causes);

    ConditionalLink measure(const GridMap &index, const GridMap &feature);

    /** What is taken out of both maps. */
    const SharedCauses &
    shared_causes() const
    {
      return causes;
    }

  private:
    const SharedCauses                                                  &causes;
    std::map<std::vector<std::size_t>, std::unique_ptr<ConditionalTest>> tests;
  };
} // namespace squeal::tribology

#endif
