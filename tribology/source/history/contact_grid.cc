// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/tribology/history/contact_grid.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

namespace squeal::tribology
{
  namespace
  {
    /** The different values of a coordinate, up to @p tolerance. */
    std::vector<double>
    levels(std::vector<double> values, const double tolerance)
    {
      std::sort(values.begin(), values.end());
      std::vector<double> result;
      for (const double value : values)
        if (result.empty() || value - result.back() > tolerance)
          result.push_back(value);
      return result;
    }



    std::size_t
    level_of(const std::vector<double> &levels, const double value)
    {
      std::size_t nearest = 0;
      for (std::size_t i = 1; i < levels.size(); ++i)
        if (std::abs(levels[i] - value) < std::abs(levels[nearest] - value))
          nearest = i;
      return nearest;
    }



    /** From midway to the level before to midway to the one behind. At the
     * border to the level itself, the node of a mesh, or as far beyond it where
     * levels are middles of cells. */
    std::array<double, 2>
    around(const std::vector<double> &levels,
           const std::size_t          i,
           const bool                 are_middles)
    {
      const std::size_t last  = levels.size() - 1;
      const double      below = .5 * (levels[i] - levels[i == 0 ? 0 : i - 1]),
                   above = .5 * (levels[i == last ? last : i + 1] - levels[i]);
      const double outer = are_middles ? 1. : 0.;
      return {{levels[i] - (i == 0 ? outer * above : below),
               levels[i] + (i == last ? outer * below : above)}};
    }

    double
    extent(const std::vector<double> &levels, const bool are_middles)
    {
      return around(levels, levels.size() - 1, are_middles)[1] -
             around(levels, 0, are_middles)[0];
    }

    /** Whether the areas add up to the face that reaches half a cell beyond the
     * outermost points, and not to the one that ends there: points are middles
     * of cells (of elements, of a pressure film), not nodes of a mesh. */
    bool
    are_middles_of_cells(const std::vector<double> &xs,
                         const std::vector<double> &ys,
                         const std::vector<double> &areas)
    {
      const double sum    = std::accumulate(areas.begin(), areas.end(), 0.),
                   ends   = extent(xs, false) * extent(ys, false),
                   beyond = extent(xs, true) * extent(ys, true);
      return std::abs(std::log(sum / beyond)) < std::abs(std::log(sum / ends));
    }

    using Quad = std::array<unsigned int, 4>;

    /** The cells between points on a grid of @p n in a row. */
    std::vector<Quad>
    quads_between(const std::vector<std::size_t> &points, const unsigned int n)
    {
      std::vector<Quad> quads;
      for (unsigned int first = 0; first + n < points.size(); ++first)
        if (first % n + 1 < n)
          {
            Quad         quad;
            unsigned int c = 0;
            for (const unsigned int k :
                 {first, first + 1, first + 1 + n, first + n})
              quad[c++] = static_cast<unsigned int>(points[k]);
            quads.push_back(quad);
          }
      return quads;
    }

    /** Below this length of the mean of unit vectors the target slides all
     * round: half a ring has 0.64. */
    constexpr double least_direction = 0.5;

    using Place = std::array<double, 2>;

    /** Of @p x from the straight line between @p a and @p b. */
    double
    distance_to(const Place &a, const Place &b, const Place &x)
    {
      const double dx = b[0] - a[0], dy = b[1] - a[1],
                   square = dx * dx + dy * dy,
                   along  = (x[0] - a[0]) * dx + (x[1] - a[1]) * dy,
                   share =
                     square > 0. ? std::clamp(along / square, 0., 1.) : 0.;
      return std::hypot(x[0] - a[0] - share * dx, x[1] - a[1] - share * dy);
    }

    /** The sides of the convex hull (Andrew's monotone chain). */
    std::vector<std::array<std::size_t, 2>>
    hull_of(const std::vector<Place> &places)
    {
      std::vector<std::size_t> order(places.size());
      std::iota(order.begin(), order.end(), 0);
      std::sort(order.begin(), order.end(), [&](const auto i, const auto j) {
        return places[i] < places[j];
      });
      const auto turns_left = [&](const auto i, const auto j, const auto k) {
        const Place &a = places[i], &b = places[j], &c = places[k];
        return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]) >
               0.;
      };
      std::vector<std::array<std::size_t, 2>> sides;
      for (const bool is_upper : {false, true})
        {
          std::vector<std::size_t> chain;
          for (const std::size_t k : order)
            {
              while (chain.size() > 1 &&
                     !turns_left(chain[chain.size() - 2], chain.back(), k))
                chain.pop_back();
              chain.push_back(k);
            }
          for (std::size_t i = 0; i + 1 < chain.size(); ++i)
            sides.push_back({{chain[i], chain[i + 1]}});
          if (!is_upper)
            std::reverse(order.begin(), order.end());
        }
      return sides;
    }
  } // namespace



  ContactGrid::ContactGrid(const std::vector<std::array<double, 3>> &points,
                           const std::vector<double>                &areas,
                           const std::array<double, 2>              &sliding)
    : areas(areas)
  {
    const double length = std::hypot(sliding[0], sliding[1]);
    if (length > least_direction)
      slides = {{sliding[0] / length, sliding[1] / length}};
    else
      slides = {{0., 0.}};
    build(points);
    set_outline();
  }



  ContactGrid::ContactGrid(const HistoryLayout &layout)
    : ContactGrid(layout.points, layout.areas, layout.sliding)
  {
    if (!layout.quads.empty())
      {
        pieces = layout.quads;
        border.clear();
      }
    set_outline();
  }



  void
  ContactGrid::build(const std::vector<std::array<double, 3>> &points)
  {
    std::vector<double> all_x, all_y;
    double              smallest = 1e300;
    for (std::size_t i = 0; i < points.size(); ++i)
      {
        places.push_back({{points[i][0], points[i][1]}});
        all_x.push_back(points[i][0]);
        all_y.push_back(points[i][1]);
        smallest = std::min(smallest, std::sqrt(areas[i]));
      }
    xs = levels(all_x, .1 * smallest);
    ys = levels(all_y, .1 * smallest);
    bool grid =
      xs.size() * ys.size() == points.size() && xs.size() > 1 && ys.size() > 1;
    ordered.assign(points.size(), points.size());
    if (grid)
      for (std::size_t i = 0; i < points.size(); ++i)
        ordered[level_of(xs, all_x[i]) + xs.size() * level_of(ys, all_y[i])] =
          i;
    grid = grid && std::find(ordered.begin(), ordered.end(), points.size()) ==
                     ordered.end();
    if (grid)
      pieces = quads_between(ordered, xs.size());
    else
      ordered.clear();

    const bool middles = grid && are_middles_of_cells(xs, ys, areas);
    for (std::size_t i = 0; i < points.size(); ++i)
      {
        const double h = .5 * std::sqrt(areas[i]);
        if (grid)
          {
            const auto x = around(xs, level_of(xs, all_x[i]), middles);
            const auto y = around(ys, level_of(ys, all_y[i]), middles);
            cells.push_back({x[0], x[1], y[0], y[1]});
          }
        else
          cells.push_back(
            {all_x[i] - h, all_x[i] + h, all_y[i] - h, all_y[i] + h});
      }
    whole = cells[0];
    for (const Patch &c : cells)
      whole = {std::min(whole.x_min, c.x_min),
               std::max(whole.x_max, c.x_max),
               std::min(whole.y_min, c.y_min),
               std::max(whole.y_max, c.y_max)};
    if (middles)
      set_border();
  }



  void
  ContactGrid::set_border()
  {
    const auto between =
      [](std::vector<double> levels, const double lower, const double upper) {
        levels.insert(levels.begin(), lower);
        levels.push_back(upper);
        return levels;
      };
    const std::vector<double> all_x = between(xs, whole.x_min, whole.x_max),
                              all_y = between(ys, whole.y_min, whole.y_max);
    std::vector<std::size_t> points;
    for (std::size_t j = 0; j < all_y.size(); ++j)
      for (std::size_t i = 0; i < all_x.size(); ++i)
        {
          const std::size_t inner_i = std::clamp<std::size_t>(i, 1, xs.size()),
                            inner_j = std::clamp<std::size_t>(j, 1, ys.size());
          const std::size_t nearest =
            ordered[inner_i - 1 + xs.size() * (inner_j - 1)];
          if (i == inner_i && j == inner_j)
            points.push_back(nearest);
          else
            {
              points.push_back(places.size() + border.size());
              border.push_back({{{all_x[i], all_y[j]}}, nearest});
            }
        }
    bordered_pieces = quads_between(points, all_x.size());
  }



  void
  ContactGrid::set_outline()
  {
    outline.clear();
    if (is_grid())
      return;
    // Sides that one piece alone has.
    std::map<std::array<std::size_t, 2>, unsigned int> sides;
    for (const auto &quad : pieces)
      for (unsigned int c = 0; c < 4; ++c)
        {
          const std::size_t a = quad[c], b = quad[(c + 1) % 4];
          if (a != b)
            ++sides[{{std::min(a, b), std::max(a, b)}}];
        }
    for (const auto &[side, count] : sides)
      if (count == 1)
        outline.push_back(side);
    if (outline.empty())
      outline = hull_of(places);
  }



  const std::vector<std::array<unsigned int, 4>> &
  ContactGrid::quads() const
  {
    return pieces;
  }



  DrawnFace
  ContactGrid::drawn_face() const
  {
    DrawnFace drawn;
    for (const auto &[x, y] : places)
      drawn.points.push_back({{x, y, 0.}});
    drawn.areas  = areas;
    drawn.places = places;
    for (const auto &[place, nearest] : border)
      {
        drawn.points.push_back({{place[0], place[1], 0.}});
        drawn.areas.push_back(0.);
        drawn.places.push_back(place);
      }
    drawn.quads   = border.empty() ? pieces : bordered_pieces;
    drawn.sliding = {slides[0], slides[1]};
    return drawn;
  }



  std::vector<double>
  ContactGrid::drawn_values(std::vector<double> values) const
  {
    for (const auto &[place, nearest] : border)
      values.push_back(values[nearest]);
    return values;
  }



  const Patch &
  ContactGrid::face() const
  {
    return whole;
  }



  const Patch &
  ContactGrid::cell(const std::size_t node) const
  {
    return cells[node];
  }



  double
  ContactGrid::area(const std::size_t node) const
  {
    return areas[node];
  }



  const std::array<double, 2> &
  ContactGrid::place(const std::size_t node) const
  {
    return places[node];
  }



  bool
  ContactGrid::is_grid() const
  {
    return !ordered.empty();
  }



  std::size_t
  ContactGrid::n_x() const
  {
    return xs.size();
  }



  std::size_t
  ContactGrid::n_y() const
  {
    return ys.size();
  }



  const std::vector<std::size_t> &
  ContactGrid::order() const
  {
    return ordered;
  }



  double
  ContactGrid::edge_distance(const std::size_t node) const
  {
    const auto [x, y] = places[node];
    if (is_grid())
      return std::min(std::min(x - whole.x_min, whole.x_max - x),
                      std::min(y - whole.y_min, whole.y_max - y));
    double nearest = std::numeric_limits<double>::max();
    for (const auto &[a, b] : outline)
      nearest =
        std::min(nearest, distance_to(places[a], places[b], places[node]));
    return nearest;
  }



  const std::array<double, 2> &
  ContactGrid::sliding() const
  {
    return slides;
  }



  double
  ContactGrid::share_of_way(const std::size_t node) const
  {
    const auto way = [this](const double x, const double y) {
      return slides[0] * x + slides[1] * y;
    };
    double first = std::numeric_limits<double>::max(), last = -first;
    for (const Patch &c : cells)
      for (const double x : {c.x_min, c.x_max})
        for (const double y : {c.y_min, c.y_max})
          {
            first = std::min(first, way(x, y));
            last  = std::max(last, way(x, y));
          }
    return (way(places[node][0], places[node][1]) - first) / (last - first);
  }



  Eigen::MatrixXd
  ContactGrid::averaging(const double length) const
  {
    const std::size_t n = n_nodes();
    if (length <= 0.)
      return Eigen::MatrixXd::Identity(n, n);
    const double    deviation = length / 4.;
    Eigen::MatrixXd weights(n, n);
    for (std::size_t i = 0; i < n; ++i)
      {
        for (std::size_t j = 0; j < n; ++j)
          {
            const double dx = places[i][0] - places[j][0];
            const double dy = places[i][1] - places[j][1];
            weights(i, j)   = areas[j] * std::exp(-.5 * (dx * dx + dy * dy) /
                                                (deviation * deviation));
          }
        weights.row(i) /= weights.row(i).sum();
      }
    return weights;
  }
} // namespace squeal::tribology
