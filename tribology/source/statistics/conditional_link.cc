// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/tribology/statistics/association.h>
#include <squeal/tribology/statistics/conditional_link.h>

#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>

#include <algorithm>
#include <cmath>

namespace squeal::tribology
{
  namespace
  {
    constexpr std::size_t most_cells = 300;

    /** Cells in squares of @p edge, only squares of which at least half is
     * among @p cells. */
    std::vector<std::vector<std::size_t>>
    merged(const GridMap                  &grid,
           const std::vector<std::size_t> &cells,
           const std::size_t               edge)
    {
      std::map<std::array<std::size_t, 2>, std::vector<std::size_t>> squares;
      for (const std::size_t cell : cells)
        squares[{cell / grid.n_x / edge, cell % grid.n_x / edge}].push_back(
          cell);
      std::vector<std::vector<std::size_t>> blocks;
      for (const auto &[place, members] : squares)
        {
          const std::size_t wide = std::min(edge, grid.n_x - place[1] * edge),
                            high = std::min(edge, grid.n_y - place[0] * edge);
          if (2 * members.size() >= wide * high)
            blocks.push_back(members);
        }
      return blocks;
    }



    /** Whether @p part of @p whole is more than rounding. */
    bool
    is_left(const Eigen::VectorXd &part, const Eigen::VectorXd &whole)
    {
      return part.squaredNorm() > 1e-20 * whole.squaredNorm();
    }



    bool
    is_constant(const Eigen::VectorXd &map)
    {
      return map.size() > 0 &&
             !is_left((map.array() - map.mean()).matrix(), map);
    }



    /** Number of the nearest place on a lattice of steps. */
    std::size_t
    on_lattice(const double distance, const double step)
    {
      return static_cast<std::size_t>(std::lround(distance / step));
    }



    /** How much more the slope varies because index and residuals scatter more
     * at the same cells; at least 1. */
    double
    common_scatter(const Eigen::VectorXd &x, const Eigen::VectorXd &residual)
    {
      const double product =
        (x.array() * residual.array()).square().sum() * x.size();
      return std::max(1., product / (x.squaredNorm() * residual.squaredNorm()));
    }



    /** Probability of a value above @p t. */
    double
    tail(const boost::math::students_t &student, const double t)
    {
      return std::isinf(t) ? double(t < 0.) : cdf(complement(student, t));
    }



    /** What one member of the family says. */
    struct Slope
    {
      double          t = 0., dof = 0., scatter = 1.;
      double          likeness    = 1.; /**< of cells, that the member missed */
      double          of_one_line = 0.; /**< of the products of cells */
      Eigen::VectorXd x, y;             /**< whitened */
    };

    Slope
    slope(const SpatialCovariance      &covariance,
          const SpatialCovariance::Fit &fit,
          const CellLags               &lags,
          const double                  white,
          const Eigen::VectorXd        &index,
          const Eigen::VectorXd        &feature)
    {
      const Eigen::ArrayXd  whiten = fit.variance.array().rsqrt();
      const auto           &axes   = covariance.axes(fit.form);
      const Eigen::VectorXd x      = ((axes * index).array() * whiten).matrix();
      const Eigen::VectorXd y  = ((axes * feature).array() * whiten).matrix();
      const double          xx = x.squaredNorm(), b = x.dot(y) / xx;
      const Eigen::VectorXd residual = y - b * x;
      const double          sum      = fit.resolved.sum();
      const double          of_slope =
        (x.array().square() * fit.resolved.array()).sum() / xx;
      const Eigen::VectorXd x_of_cells = covariance.on_cells(fit.form, x),
                            r_of_cells =
                              covariance.on_cells(fit.form, residual);
      const double independent = sum * sum / fit.resolved.squaredNorm();
      const Eigen::VectorXd products =
        x_of_cells.cwiseProduct(b * x_of_cells + r_of_cells);
      Slope result;
      result.x           = x;
      result.y           = y;
      result.scatter     = common_scatter(x_of_cells, r_of_cells);
      result.of_one_line = lags.largest_share_of_line(products);
      // what the member describes leaves as many independent cells as it has
      result.likeness = std::max(
        1., independent * lags.variance(x_of_cells, r_of_cells) / white);
      result.dof = (independent - 1.) / result.likeness;
      result.t =
        b * std::sqrt(xx * (sum - of_slope) /
                      (residual.squaredNorm() * of_slope * result.likeness));
      return result;
    }
  } // namespace



  std::array<double, 2>
  conditional_interval(const ConditionalLink &link, const double level)
  {
    if (!link.is_known)
      return {{-1., 1.}};
    return correlation_interval(link.r, link.n_effective, level);
  }



  std::array<double, 2>
  bootstrap_interval(const ConditionalLink &link,
                     const unsigned int     n,
                     const double           level,
                     std::mt19937_64       &generator)
  {
    if (!link.is_known || n < CorrelationParameters::least_bootstraps ||
        !(link.n_effective > 3.))
      return {{-1., 1.}};
    const auto &[x, y]            = link.pairs;
    const Eigen::ArrayXd products = x.array() * y.array(),
                         xx = x.array().square(), yy = y.array().square();
    std::uniform_int_distribution<Eigen::Index> pick(0, x.size() - 1);
    double                                      sum = 0., squares = 0., m = 0.;
    for (unsigned int k = 0; k < n; ++k)
      {
        double a = 0., b = 0., c = 0.;
        for (Eigen::Index i = 0; i < x.size(); ++i)
          {
            const Eigen::Index j = pick(generator);
            a += products(j);
            b += xx(j);
            c += yy(j);
          }
        const double z = std::atanh(a / std::sqrt(b * c));
        if (!std::isfinite(z))
          continue;
        m += 1.;
        sum += z;
        squares += z * z;
      }
    if (m < CorrelationParameters::least_bootstraps)
      return {{link.r, link.r}};
    // n resampled pairs scatter by 1/n, n new ones by Fisher's 1/(n - 3); of
    // few pairs that carry most of the index the resampled ones know too little
    const double deviation =
      std::sqrt(std::max(0., squares - sum * sum / m) / (m - 1.) *
                  link.likeness * link.n_effective / (link.n_effective - 3.) +
                link.between);
    const double half = std::max(
      deviation * quantile(boost::math::students_t(link.n_effective - 2.),
                           1. - level / 2.),
      quantile(boost::math::normal(), 1. - level / 2.) /
        std::sqrt(link.n_effective - 3.));
    return {{std::tanh(std::atanh(link.r) - half),
             std::tanh(std::atanh(link.r) + half)}};
  }



  ConditionalTest::ConditionalTest(const GridMap                  &grid,
                                   const std::vector<std::size_t> &cells,
                                   const Eigen::MatrixXd          &causes)
  {
    std::size_t edge = 1;
    for (blocks = merged(grid, cells, edge); blocks.size() > most_cells;
         edge *= 2)
      blocks = merged(grid, cells, 2 * edge);
    const Eigen::Index         n = blocks.size();
    std::vector<CellPlace>     places;
    std::vector<CellColumnRow> squares;
    // distances are those on the pad, over the mean edge of a block
    const auto [wide, high] = grid.spacing();
    const double    length  = edge * std::sqrt(wide * high);
    const auto      origin  = grid.place(0);
    Eigen::MatrixXd means   = Eigen::MatrixXd::Zero(n, causes.cols());
    for (Eigen::Index i = 0; i < n; ++i)
      {
        CellPlace    place{{0., 0.}};
        const double weight = 1. / blocks[i].size();
        for (const std::size_t cell : blocks[i])
          {
            const auto at = grid.place(cell);
            place[0] += weight * at[0] / length;
            place[1] += weight * at[1] / length;
            means.row(i) += weight * causes.row(cell);
          }
        places.push_back(place);
        // the block's own corner, whether or not that cell is known
        const std::size_t first = blocks[i].front();
        const auto        corner =
          grid.place(first % grid.n_x / edge * edge +
                     first / grid.n_x / edge * edge * grid.n_x);
        squares.push_back({{on_lattice(corner[0] - origin[0], edge * wide),
                            on_lattice(corner[1] - origin[1], edge * high)}});
      }
    if (n <= fewest)
      return;
    covariance = std::make_unique<SpatialCovariance>(places, means);
    n_taken    = n - covariance->n_free();
    lags       = std::make_unique<CellLags>(squares);
    white      = lags->variance_in(covariance->basis()) * covariance->n_free();
  }



  Eigen::VectorXd
  ConditionalTest::values(const GridMap &map) const
  {
    Eigen::VectorXd result = Eigen::VectorXd::Zero(blocks.size());
    for (std::size_t i = 0; i < blocks.size(); ++i)
      for (const std::size_t cell : blocks[i])
        result(i) += map.values[cell] / blocks[i].size();
    // only ratios matter: squares of tiny or huge indices stay in range
    const double largest =
      result.size() > 0 ? result.cwiseAbs().maxCoeff() : 0.;
    return largest > 0. ? Eigen::VectorXd(result / largest) : result;
  }



  const std::vector<SpatialCovariance::Fit> &
  ConditionalTest::fits(const Eigen::VectorXd &feature)
  {
    if (fitted_map.size() != feature.size() || fitted_map != feature)
      {
        fitted_map = feature;
        fitted     = covariance->fit(feature);
      }
    return fitted;
  }



  ConditionalLink
  ConditionalTest::measure(const GridMap &index, const GridMap &feature)
  {
    ConditionalLink link;
    link.n_cells      = blocks.size();
    link.n_taken      = n_taken;
    const auto silent = [&link](const Silence silence) {
      link.silence = silence;
      return link;
    };
    const Eigen::VectorXd x = values(index), y = values(feature);
    // one cell alone is always constant
    if (!covariance)
      return silent(Silence::few_cells);
    if (is_constant(x))
      return silent(Silence::index_constant);
    if (is_constant(y))
      return silent(Silence::feature_constant);
    if (covariance->n_free() < fewest)
      return silent(Silence::few_cells);
    const Eigen::VectorXd dx = covariance->residual(x),
                          dy = covariance->residual(y);
    if (!is_left(dx, x))
      return silent(Silence::index_explained);
    if (!is_left(dy, y))
      return silent(Silence::feature_explained);
    double weight = 0., upper = 0., lower = 0., sum = 0., squares = 0.,
           within = 0., heaviest = 0.;
    for (const SpatialCovariance::Fit &fit : fits(y))
      {
        const Slope s = slope(*covariance, fit, *lags, white, dx, dy);
        if (!(s.dof > 1.) || std::isnan(s.t))
          continue;
        const boost::math::students_t student(s.dof);
        weight += fit.weight;
        const double t = s.t / std::sqrt(s.scatter);
        // each tail by itself: the difference to 1 would lose small ones
        lower += fit.weight * tail(student, t);
        upper += fit.weight * tail(student, -t);
        const double z = std::asinh(s.t / std::sqrt(s.dof));
        sum += fit.weight * z;
        squares += fit.weight * z * z;
        within += fit.weight * s.scatter / (s.dof - 1.);
        if (fit.weight > heaviest)
          {
            heaviest         = fit.weight;
            link.pairs       = {{s.x, s.y}};
            link.likeness    = s.likeness;
            link.of_one_line = s.of_one_line;
          }
      }
    // most of the posterior must be able to speak
    if (!(weight > .5))
      return link;
    link.is_known = true;
    link.p        = std::min(1., 2. * std::min(lower, upper) / weight);
    link.r        = std::tanh(sum / weight);
    // z scatters within each member, and from one to another
    const double between =
      std::isfinite(squares)
        ? std::max(0., squares / weight - std::pow(sum / weight, 2))
        : 0.;
    link.between     = between;
    link.n_effective = 3. + 1. / (within / weight + between);
    return link;
  }



  ConditionalTests::ConditionalTests(const SharedCauses &causes)
    : causes(causes)
  {
  }



  ConditionalLink
  ConditionalTests::measure(const GridMap &index, const GridMap &feature)
  {
    std::vector<std::size_t> cells;
    for (const std::size_t cell : common_cells(index, feature))
      if (causes.values.row(cell).allFinite())
        cells.push_back(cell);
    auto &test = tests[cells];
    if (!test)
      test = std::make_unique<ConditionalTest>(index, cells, causes.values);
    return test->measure(index, feature);
  }
} // namespace squeal::tribology
