// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/base/number_text.h>
#include <squeal/tribology/history/contact_grid.h>
#include <squeal/tribology/history/face_areas.h>

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace squeal::tribology
{
  namespace
  {
    /** Factors by which the areas may be off. Of faces without a grid the span
     * is not well known, and of rings, pins and parts between slots, which may
     * stand on a grid as well, it is far more than the face: lengths in mm make
     * it 1e6 times as large. */
    constexpr double of_grid = 1.5, of_hull = 3., of_holes = 1e5;

    /** A hull is a line where its area is less than this times the square of
     * its length. */
    constexpr double narrow = 1e-6;

    /** m; faces of brakes are shorter, and those in mm longer. */
    constexpr double longest_face = 2.;

    /** What the areas of nodes may add up to, m^2. */
    struct Range
    {
      double least, most;
    };



    /** Of the curved face over a flat one of that @p perimeter: its walls. */
    double
    walls(const HistoryLayout &layout, const double perimeter)
    {
      const auto [low, high] = std::minmax_element(
        layout.points.begin(),
        layout.points.end(),
        [](const auto &a, const auto &b) { return a[2] < b[2]; });
      return perimeter * ((*high)[2] - (*low)[2]);
    }



    Range
    range_of_grid(const ContactGrid &grid, const HistoryLayout &layout)
    {
      const std::size_t n_x = grid.n_x(), n_y = grid.n_y();
      const auto        at = [&](const std::size_t i,
                          const std::size_t j) -> const auto &
      {
        return grid.place(grid.order()[i + n_x * j]);
      };
      const double x        = at(n_x - 1, 0)[0] - at(0, 0)[0],
                   y        = at(0, n_y - 1)[1] - at(0, 0)[1],
                   beyond_x = .5 * (at(1, 0)[0] - at(0, 0)[0] +
                                    at(n_x - 1, 0)[0] - at(n_x - 2, 0)[0]),
                   beyond_y = .5 * (at(0, 1)[1] - at(0, 0)[1] +
                                    at(0, n_y - 1)[1] - at(0, n_y - 2)[1]);
      return {x * y / of_holes,
              of_grid * ((x + beyond_x) * (y + beyond_y) +
                         walls(layout, 2. * (x + y + beyond_x + beyond_y)))};
    }



    /** Largest distance of a node from the one next to it. */
    double
    distance_of_neighbours(const ContactGrid &grid)
    {
      double largest = 0.;
      for (std::size_t i = 0; i < grid.n_nodes(); ++i)
        {
          double nearest = std::numeric_limits<double>::max();
          for (std::size_t j = 0; j < grid.n_nodes(); ++j)
            if (j != i)
              nearest =
                std::min(nearest,
                         std::hypot(grid.place(i)[0] - grid.place(j)[0],
                                    grid.place(i)[1] - grid.place(j)[1]));
          largest = std::max(largest, nearest);
        }
      return largest;
    }



    Range
    range_of_hull(const ContactGrid &grid, const HistoryLayout &layout)
    {
      std::vector<cv::Point2f> places, hull;
      for (std::size_t k = 0; k < grid.n_nodes(); ++k)
        places.emplace_back(grid.place(k)[0] - grid.place(0)[0],
                            grid.place(k)[1] - grid.place(0)[1]);
      cv::convexHull(places, hull);
      const double area      = cv::contourArea(hull),
                   perimeter = cv::arcLength(hull, true);
      if (!(area > narrow * perimeter * perimeter))
        return {0., std::numeric_limits<double>::infinity()};
      // with a rim as wide (Steiner's formula)
      const double rim   = .5 * distance_of_neighbours(grid),
                   whole = area + perimeter * rim + M_PI * rim * rim;
      return {area / of_holes, of_hull * (whole + walls(layout, perimeter))};
    }
  } // namespace



  void
  require_areas_of_face(const HistoryLayout &layout, const std::string &path)
  {
    const ContactGrid grid(layout);
    const Range       range = grid.is_grid() ? range_of_grid(grid, layout)
                                             : range_of_hull(grid, layout);
    const double      sum =
      std::accumulate(layout.areas.begin(), layout.areas.end(), 0.);
    if (sum >= range.least && sum <= range.most)
      return;
    throw InputError(
      path + (layout.pair.empty() ? "" : ", pair '" + layout.pair + "'") +
      ": the areas of the contact nodes add up to " + rounded_text(sum, 3) +
      " m^2, their coordinates span " +
      (sum < range.least ? "at least " + rounded_text(range.least, 3)
                         : "at most " + rounded_text(range.most, 3)) +
      " m^2: coordinates are in m, areas in m^2");
  }



  std::string
  doubt_of_length(const HistoryLayout &layout, const std::string &path)
  {
    double longest = 0.;
    for (const int i : {0, 1})
      {
        const auto [low, high] = std::minmax_element(
          layout.points.begin(),
          layout.points.end(),
          [i](const auto &a, const auto &b) { return a[i] < b[i]; });
        if (low != high)
          longest = std::max(longest, (*high)[i] - (*low)[i]);
      }
    if (!(longest > longest_face))
      return "";
    return path + (layout.pair.empty() ? "" : ", pair '" + layout.pair + "'") +
           ": the face is " + rounded_text(longest, 3) +
           " m long: if its coordinates are in mm, and its areas in mm^2, give "
           "them in m and m^2; all places, depths and forces are wrong "
           "otherwise";
  }
} // namespace squeal::tribology
