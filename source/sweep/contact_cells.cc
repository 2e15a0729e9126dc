// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/sweep/contact_cells.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace squeal
{
  namespace
  {
    /** The numbers of the coordinates of axis @p a that are next to @p x below
     * and above; one number where @p x is one of them or beyond an end. */
    std::set<std::size_t>
    neighbours_of(const SweepGrid &grid, const unsigned int a, const double x)
    {
      // Axes ascend or descend.
      const std::vector<double> &all   = grid.coordinates(a);
      std::size_t                below = all.size(), above = all.size();
      for (std::size_t i = 0; i < all.size(); ++i)
        {
          if (all[i] <= x && (below == all.size() || all[i] > all[below]))
            below = i;
          if (all[i] >= x && (above == all.size() || all[i] < all[above]))
            above = i;
        }
      std::set<std::size_t> result{below, above};
      result.erase(all.size());
      return result;
    }
  } // namespace



  bool
  has_known_contact(const SweepGrid &grid, const SweepPoint &point)
  {
    if (grid.n_states() < 2)
      return true;
    std::vector<std::size_t> corners{0};
    std::size_t              stride = 1;
    for (unsigned int a = 0; a < grid.n_axes(); ++a)
      {
        std::vector<std::size_t> next;
        for (const std::size_t i : neighbours_of(grid, a, point[a]))
          for (const std::size_t corner : corners)
            next.push_back(corner + stride * i);
        corners = next;
        stride *= grid.coordinates(a).size();
      }
    const std::vector<unsigned int> &state = grid.states();
    return std::all_of(
      corners.begin(), corners.end(), [&](const std::size_t i) {
        return state[i] == state[corners[0]];
      });
  }



  double
  error_by_held_contact(const SweepGrid &grid, const SweepPoint &point)
  {
    if (has_known_contact(grid, point))
      return 0.;
    double error = 0.;
    for (const std::size_t i : neighbours_of(grid, 0, point[0]))
      error = std::max(error, std::abs(grid.coordinates(0)[i] - point[0]));
    return error;
  }
} // namespace squeal
