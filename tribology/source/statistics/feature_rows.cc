// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/base/number_text.h>
#include <squeal/tribology/statistics/feature_rows.h>

#include <algorithm>

namespace squeal::tribology
{
  namespace
  {
    using RowPlaces = std::vector<std::array<double, 2>>;

    /** Parts of an edge that are rounding. */
    constexpr double sliver = 1e-6;

    /** Places of the same column, which may be rounded: of the whole length. */
    constexpr double same_place = 1e-4;

    bool
    lies_in(const Patch &c, const std::array<double, 2> &at)
    {
      const double x = sliver * (c.x_max - c.x_min),
                   y = sliver * (c.y_max - c.y_min);
      return at[0] >= c.x_min - x && at[0] <= c.x_max + x &&
             at[1] >= c.y_min - y && at[1] <= c.y_max + y;
    }



    void
    require_on_face(const ContactGrid                             &grid,
                    const RowPlaces                               &places,
                    const std::function<std::string(std::size_t)> &where)
    {
      for (std::size_t row = 0; row < places.size(); ++row)
        if (!lies_in(grid.face(), places[row]))
          throw InputError(where(row) + "(" + shortest_text(places[row][0]) +
                           ", " + shortest_text(places[row][1]) +
                           ") m lies in no cell of the damage table");
    }



    /** Each row with the nodes in whose cells it lies. */
    std::vector<FeatureRows::Share>
    as_points(const ContactGrid &grid, const RowPlaces &places)
    {
      std::vector<FeatureRows::Share> shares;
      for (std::size_t row = 0; row < places.size(); ++row)
        for (std::size_t k = 0; k < grid.n_nodes(); ++k)
          if (lies_in(grid.cell(k), places[row]))
            shares.push_back({row, k, 1.});
      return shares;
    }



    /** Whether every row stands at a node. */
    bool
    are_nodes(const ContactGrid &grid, const RowPlaces &places)
    {
      constexpr double near = 1e-3; // tables may be rounded
      return std::all_of(places.begin(), places.end(), [&grid](const auto &at) {
        for (std::size_t k = 0; k < grid.n_nodes(); ++k)
          {
            const Patch &c     = grid.cell(k);
            const auto  &place = grid.place(k);
            if (std::abs(at[0] - place[0]) <= near * (c.x_max - c.x_min) &&
                std::abs(at[1] - place[1]) <= near * (c.y_max - c.y_min))
              return true;
          }
        return false;
      });
    }



    /** Step of the even lattice on which the rows stand along an axis, some
     * places of which may be empty; NaN where they stand on none. */
    double
    even_step(const RowPlaces &places, const int axis)
    {
      std::vector<double> at, gaps;
      for (const auto &place : places)
        at.push_back(place[axis]);
      std::sort(at.begin(), at.end());
      const double same = same_place * (at.back() - at.front());
      for (std::size_t i = 1; i < at.size(); ++i)
        if (at[i] - at[i - 1] > same)
          gaps.push_back(at[i] - at[i - 1]);
      if (gaps.empty())
        return NAN;
      std::vector<double> sorted = gaps;
      std::sort(sorted.begin(), sorted.end());
      const double middle = sorted[sorted.size() / 2];
      double       steps  = 0.;
      for (const double gap : gaps)
        {
          const double whole = std::round(gap / middle);
          if (!(whole >= 1. && std::abs(gap / middle - whole) <= .02))
            return NAN;
          steps += whole;
        }
      return (at.back() - at.front()) / steps;
    }



    /** Steps of the lattice of the rows along x and y, see even_step(). Rows in
     * one column or one row in the middle of the face are as long across it as
     * the face is: images in cells of 1 x n or n x 1, or in one cell. */
    std::array<double, 2>
    lattice_steps(const ContactGrid &grid, const RowPlaces &places)
    {
      const Patch                &face  = grid.face();
      const std::array<double, 2> lows  = {{face.x_min, face.y_min}},
                                  highs = {{face.x_max, face.y_max}};
      std::array<double, 2> steps       = {
              {even_step(places, 0), even_step(places, 1)}};
      for (const int axis : {0, 1})
        {
          const double length = highs[axis] - lows[axis],
                       middle = .5 * (lows[axis] + highs[axis]);
          if ((places.size() == 1 || std::isfinite(steps[1 - axis])) &&
              std::all_of(places.begin(), places.end(), [&](const auto &at) {
                return std::abs(at[axis] - middle) <= same_place * length;
              }))
            steps[axis] = length;
        }
      return steps;
    }



    /** The part of the edge from @p low to @p high that one of length @p step
     * about @p centre covers. */
    double
    covered_part(const double low,
                 const double high,
                 const double centre,
                 const double step)
    {
      const double length =
        std::min(high, centre + .5 * step) - std::max(low, centre - .5 * step);
      return length > sliver * step ? length / (high - low) : 0.;
    }



    /** Each row as a rectangle of @p steps, with all nodes whose cells it
     * covers in part. */
    std::vector<FeatureRows::Share>
    as_rectangles(const ContactGrid           &grid,
                  const RowPlaces             &places,
                  const std::array<double, 2> &steps)
    {
      std::vector<FeatureRows::Share> shares;
      for (std::size_t row = 0; row < places.size(); ++row)
        for (std::size_t k = 0; k < grid.n_nodes(); ++k)
          {
            const Patch &c = grid.cell(k);
            const double part =
              covered_part(c.x_min, c.x_max, places[row][0], steps[0]) *
              covered_part(c.y_min, c.y_max, places[row][1], steps[1]);
            if (part > 0.)
              shares.push_back({row, k, part});
          }
      return shares;
    }
  } // namespace



  FeatureRows
  share_rows(const ContactGrid                             &grid,
             const RowPlaces                               &places,
             const std::function<std::string(std::size_t)> &where)
  {
    require_on_face(grid, places, where);
    FeatureRows result;
    if (places.empty())
      return result;
    const std::array<double, 2> steps = lattice_steps(grid, places);
    if (std::isfinite(steps[0]) && std::isfinite(steps[1]) &&
        (places.size() == 1 || !are_nodes(grid, places)))
      {
        const Patch &face = grid.face();
        result.coarseness =
          std::max(steps[0] * (grid.n_x() - 1.) / (face.x_max - face.x_min),
                   steps[1] * (grid.n_y() - 1.) / (face.y_max - face.y_min));
      }
    result.shares = result.coarseness <= FeatureRows::coarse
                      ? as_rectangles(grid, places, steps)
                      : as_points(grid, places);
    return result;
  }
} // namespace squeal::tribology
