// SPDX-License-Identifier: LGPL-2.1-or-later

// Maps on nodes that stand closer near the rim or near one edge: what two maps
// have in common follows distances on the pad, not numbers of cells.
#include <squeal/base/number_text.h>
#include <squeal/tribology/statistics/link_test.h>

#include <Eigen/Cholesky>

#include <cmath>
#include <random>

#include "check.h"
#include "worst.h"

using namespace squeal;
using namespace squeal::testing;
using namespace squeal::tribology;

namespace
{
  /** Places from -0.5 to 0.5 with distances in the ratio of @p steps. */
  std::vector<double>
  graded(const std::vector<double> &steps)
  {
    double              sum = 0.;
    std::vector<double> at  = {0.};
    for (const double step : steps)
      at.push_back(sum += step);
    for (double &x : at)
      x = x / sum - .5;
    return at;
  }

  const std::vector<double> at_rim =
    {1., 1., 1.6, 2.6, 4.5, 6., 4.5, 2.6, 1.6, 1., 1.};

  /** Each step 1.3 times as long as the one before. */
  std::vector<double>
  at_one_edge()
  {
    std::vector<double> steps;
    for (unsigned int i = 0; i < 11; ++i)
      steps.push_back(std::pow(1.3, i));
    return steps;
  }

  GridMap
  grid_of(const std::vector<double> &xs, const std::vector<double> &ys)
  {
    return {xs.size(),
            ys.size(),
            std::vector<double>(xs.size() * ys.size(), 0.),
            xs,
            ys};
  }

  /** Independent maps with the covariance exp(-d^2 / (2 length^2)) at a
   * distance d and white noise of a tenth of the deviation. */
  class Maps
  {
  public:
    Maps(const GridMap &grid, const double length)
      : grid(grid)
    {
      const std::size_t n = grid.size();
      Eigen::MatrixXd   c(n, n);
      for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j)
          {
            const auto   a = grid.place(i), b = grid.place(j);
            const double d = std::hypot(a[0] - b[0], a[1] - b[1]) / length;
            c(i, j)        = std::exp(-.5 * d * d) + (i == j ? .01 : 0.);
          }
      factor = c.llt().matrixL();
    }

    GridMap
    draw(std::mt19937_64 &generator) const
    {
      std::normal_distribution<double> normal;
      Eigen::VectorXd                  white(grid.size());
      for (double &v : white)
        v = normal(generator);
      const Eigen::VectorXd map    = factor * white;
      GridMap               result = grid;
      result.values.assign(map.begin(), map.end());
      return result;
    }

  private:
    const GridMap  &grid;
    Eigen::MatrixXd factor;
  };

  void
  false_positives(const std::string &name, const GridMap &grid)
  {
    const CorrelationParameters p;
    const SharedCauses          causes =
      shared_causes(grid, p.shared_causes, LeadingEdge::lowest_y);
    ConditionalTests       tests(causes);
    constexpr unsigned int n_features = 40, n_indices = 10;
    for (const double length : {.1, .2})
      {
        const Maps      maps(grid, length);
        std::mt19937_64 generator(5);
        unsigned int    n_alarms = 0, n_found = 0;
        for (unsigned int f = 0; f < n_features; ++f)
          {
            const GridMap y = maps.draw(generator);
            for (unsigned int i = 0; i < n_indices; ++i)
              n_alarms += tests.measure(maps.draw(generator), y).p <= .05;
            GridMap linked = maps.draw(generator);
            for (std::size_t cell = 0; cell < grid.size(); ++cell)
              linked.values[cell] =
                .8 * y.values[cell] + .6 * linked.values[cell];
            n_found += tests.measure(linked, y).p <= .05;
          }
        const std::string claim =
          name + ", length " + rounded_text(length, 2) + ": ";
        const double alarms = double(n_alarms) / (n_features * n_indices),
                     found  = double(n_found) / n_features;
        check(alarms <= .08,
              claim +
                "false positives at most 8 %: " + rounded_text(alarms, 3));
        check(found >= .8,
              claim + "a link of 0.8 is found in at least 80 %: " +
                rounded_text(found, 3));
      }
  }

  /** Places of even grids are numbers of cells times a length, and neither the
   * causes nor a test hears of the length. */
  void
  even_grids()
  {
    std::vector<double> even;
    for (unsigned int i = 0; i < 11; ++i)
      even.push_back(.13 + 2e-3 * i);
    const GridMap               plain{11, 11, {}};
    const CorrelationParameters p;
    const SharedCauses          a =
      shared_causes(plain, p.shared_causes, LeadingEdge::highest_x);
    const SharedCauses b = shared_causes(
      grid_of(even, even), p.shared_causes, LeadingEdge::highest_x);
    Worst difference;
    difference.add(largest_abs(a.values - b.values));
    ConditionalTests one(a), other(b);
    std::mt19937_64  generator(3);
    for (const double length : {0., 1.5, 3.})
      {
        GridMap x          = random_map(11, 11, length, generator),
                y          = random_map(11, 11, length, generator);
        const double p_one = one.measure(x, y).p,
                     n_one = effective_sample_size(x, y);
        x.xs = x.ys = y.xs = y.ys = even;
        difference.add(std::abs(other.measure(x, y).p - p_one));
        difference.add(std::abs(effective_sample_size(x, y) / n_one - 1.));
      }
    check_within(difference, 1e-6, "even grids do not know their unit");
  }

  /** Decays over 15 % of the pad are those on the pad. */
  void
  decays()
  {
    const std::vector<double> even = graded(std::vector<double>(11, 1.));
    const GridMap             grid = grid_of(even, graded(at_one_edge()));
    const Eigen::MatrixXd     causes =
      shared_causes(grid, {SharedCause::edges}, LeadingEdge::lowest_y).values;
    Worst off;
    for (std::size_t cell = 0; cell < grid.size(); ++cell)
      off.add(std::abs(causes(cell, 4) - std::exp(-(grid.place(cell)[1] + .5) /
                                                  (.15 * 12. / 11.))));
    check_within(off, 1e-12, "the decay from the leading edge on");
  }
} // namespace

int
main()
{
  decays();
  even_grids();
  const std::vector<double> rim = graded(at_rim), one = graded(at_one_edge()),
                            even = graded(std::vector<double>(11, 1.));
  false_positives("closer at the rim", grid_of(rim, rim));
  false_positives("closer at one edge", grid_of(even, one));
}
