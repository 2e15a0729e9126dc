// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_statistics_spatial_h
#define squeal_tribology_statistics_spatial_h

#include <array>
#include <cstddef>
#include <memory>
#include <random>
#include <vector>

namespace squeal::tribology
{
  /** Values on a rectangular grid of cells, x fastest; NaN: nothing is known of
   * that cell. */
  struct GridMap
  {
    std::size_t         n_x = 0, n_y = 0;
    std::vector<double> values;
    /** Places of the columns along x and of the rows along y, ascending, in m;
     * none: the cells are squares with an edge of 1. */
    std::vector<double> xs = {}, ys = {};

    std::size_t
    size() const
    {
      return values.size();
    }

    /** x and y of a cell, in the unit of the columns and rows. */
    std::array<double, 2> place(std::size_t cell) const;

    /** Mean distances of neighbouring columns and of neighbouring rows, in the
     * same unit; where there is but one, the distance is that of the others. */
    std::array<double, 2> spacing() const;
  };

  /** Cells where both maps are known. */
  std::vector<std::size_t> common_cells(const GridMap &x, const GridMap &y);

  /** The values of two maps where both are known. */
  std::array<std::vector<double>, 2> common_values(const GridMap &x,
                                                   const GridMap &y);

  /**
   * Number of independent pairs that carry as much information on the
   * correlation of two maps as their cells do, whose neighbours are alike:
   * 1 + 1/var(r) with var(r) = tr(B S_x B S_y) / (tr(B S_x) tr(B S_y)), B the
   * centring matrix and S the covariances by classes of distance (on the pad,
   * each as wide as a mean cell), estimated from the maps (Clifford,
   * Richardson, Hemon 1989; Dutilleul 1993). At most the number of cells.
   */
  double effective_sample_size(const GridMap &x, const GridMap &y);

  /**
   * Maps that are as rough as a given one and otherwise random: the map is
   * mirrored at its edges, so that it has no seam, its Fourier phases are drawn
   * anew, and the original part is cut out. The map must be complete.
   */
  class PhaseSurrogates
  {
  public:
    explicit PhaseSurrogates(const GridMap &map);
    ~PhaseSurrogates();
    PhaseSurrogates(const PhaseSurrogates &)            = delete;
    PhaseSurrogates &operator=(const PhaseSurrogates &) = delete;

    GridMap draw(std::mt19937_64 &generator) const;

  private:
    struct Spectrum;

    std::size_t               n_x, n_y;
    double                    mean;
    std::unique_ptr<Spectrum> spectrum;
  };

  /**
   * Two-sided p-value of the correlation of two maps among surrogates of @p x,
   * which must be complete. At most @p n are drawn: fewer where a hundred of
   * them correlate at least as well as the maps (Besag and Clifford 1991), so
   * that many cost time only where a small p-value needs them.
   */
  double surrogate_p_value(const GridMap   &x,
                           const GridMap   &y,
                           unsigned int     n,
                           std::mt19937_64 &generator);

  /**
   * A Gaussian map whose covariance at a distance of (dx, dy) cells is
   * exp(-(dx / lengths[0])^2 - (dy / lengths[1])^2): white noise under normal
   * kernels of standard deviation length / 2; 0 is white noise.
   */
  GridMap random_map(std::size_t                  n_x,
                     std::size_t                  n_y,
                     const std::array<double, 2> &lengths,
                     std::mt19937_64             &generator);

  /** The same with one length for both directions. */
  GridMap random_map(std::size_t      n_x,
                     std::size_t      n_y,
                     double           length,
                     std::mt19937_64 &generator);
} // namespace squeal::tribology

#endif
