// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/number_text.h>
#include <squeal/sweep/sweep_grid.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>

namespace squeal
{
  namespace
  {
    using Scale = SweepAxisParameters::Scale;

    double
    component(const std::vector<double> &values, const std::size_t i)
    {
      return values[values.size() == 1 ? 0 : i];
    }

    /** Of a value between @p from and @p to: zero where it differs from it by
     * rounding, so that zero is found among the values of an axis. */
    double
    without_rounding(const double value, const double from, const double to)
    {
      return from * to < 0. && std::abs(value) <
                                 1e-14 * std::max(std::abs(from), std::abs(to))
               ? 0.
               : value;
    }

    /** Van der Corput's sequence in @p base. */
    double
    radical_inverse(std::size_t i, const unsigned int base)
    {
      double result = 0., digit = 1. / base;
      for (; i > 0; i /= base, digit /= base)
        result += digit * (i % base);
      return result;
    }
  } // namespace



  double
  entry_value(const SweepAxisParameters &axis,
              const std::size_t          entry,
              const double               share)
  {
    const double from = component(axis.from, entry);
    const double to   = component(axis.to, entry);
    return axis.scale == Scale::logarithmic
             ? from * std::pow(to / from, share)
             : without_rounding((1. - share) * from + share * to, from, to);
  }



  double
  listed_value(const SweepAxisParameters &axis,
               const std::size_t          entry,
               const double               value)
  {
    const auto       &x = axis.values;
    const double     *y = axis.entry_values.data() + entry * x.size();
    const std::size_t k =
      std::lower_bound(x.begin(), x.end(), value) - x.begin();
    if (k == x.size())
      return y[k - 1];
    // What was written is met to the last digit.
    if (k == 0 || x[k] == value)
      return y[k];
    const double share = (value - x[k - 1]) / (x[k] - x[k - 1]);
    return (1. - share) * y[k - 1] + share * y[k];
  }



  SweepGrid::SweepGrid(const Parameters &parameters)
    : axes(parameters.sweep.axes)
  {
    for (const auto &axis : axes)
      {
        std::vector<double> coordinates;
        if (axis.scale == Scale::list)
          coordinates = axis.values;
        else
          {
            const bool   log = axis.scale == Scale::logarithmic;
            const double a   = log ? std::log10(axis.from[0]) : axis.from[0];
            const double b   = log ? std::log10(axis.to[0]) : axis.to[0];
            for (unsigned int i = 0; i < axis.number; ++i)
              coordinates.push_back(
                axis.number == 1 ? a
                : i + 1 == axis.number
                  ? b
                  : without_rounding(
                      a + (b - a) * i / (axis.number - 1), a, b));
          }
        grid.push_back(coordinates);
      }
    std::vector<std::string> all = entries();
    for (const auto &path : parameters.sweep.sensitivities)
      if (std::find(all.begin(), all.end(), path) == all.end())
        {
          others.push_back(path);
          other_values.push_back(get_number(parameters, path));
        }
    all.insert(all.end(), others.begin(), others.end());
    setter = std::make_unique<NumberSetter>(parameters, all);
  }

  SweepGrid::~SweepGrid() = default;

  unsigned int
  SweepGrid::n_axes() const
  {
    return axes.size();
  }

  const SweepAxisParameters &
  SweepGrid::axis(const unsigned int a) const
  {
    return axes[a];
  }

  bool
  SweepGrid::is_logarithmic(const unsigned int a) const
  {
    return axes[a].scale == Scale::logarithmic;
  }

  const std::vector<double> &
  SweepGrid::coordinates(const unsigned int a) const
  {
    return grid[a];
  }

  double
  SweepGrid::lower(const unsigned int a) const
  {
    return std::min(grid[a].front(), grid[a].back());
  }

  double
  SweepGrid::upper(const unsigned int a) const
  {
    return std::max(grid[a].front(), grid[a].back());
  }



  std::size_t
  SweepGrid::n_points() const
  {
    std::size_t n = 1;
    for (const auto &coordinates : grid)
      n *= coordinates.size();
    return n;
  }

  SweepPoint
  SweepGrid::point(std::size_t i) const
  {
    SweepPoint result(axes.size());
    for (std::size_t a = 0; a < axes.size(); ++a)
      {
        result[a] = grid[a][i % grid[a].size()];
        i /= grid[a].size();
      }
    return result;
  }



  double
  SweepGrid::share(const unsigned int a, const double coordinate) const
  {
    const double length = grid[a].back() - grid[a].front();
    return length == 0. ? 0. : (coordinate - grid[a].front()) / length;
  }

  double
  SweepGrid::value(const unsigned int a, const double coordinate) const
  {
    return is_logarithmic(a) ? std::pow(10., coordinate) : coordinate;
  }

  std::vector<double>
  SweepGrid::values(const SweepPoint &point) const
  {
    std::vector<double> result;
    for (std::size_t a = 0; a < axes.size(); ++a)
      for (std::size_t i = 0; i < axes[a].entries.size(); ++i)
        if (!axes[a].entry_values.empty())
          result.push_back(listed_value(axes[a], i, point[a]));
        else if (i == 0 || axes[a].scale == Scale::list)
          result.push_back(value(a, point[a]));
        else
          // Not the member, which counts entries through all axes.
          result.push_back(squeal::entry_value(axes[a], i, share(a, point[a])));
    return result;
  }

  std::vector<std::string>
  SweepGrid::entries() const
  {
    std::vector<std::string> result;
    for (const auto &axis : axes)
      result.insert(result.end(), axis.entries.begin(), axis.entries.end());
    return result;
  }

  const SceneParameters &
  SweepGrid::scene(const SweepPoint &point) const
  {
    std::vector<double> all = values(point);
    all.insert(all.end(), other_values.begin(), other_values.end());
    return scene(all, point);
  }

  const SceneParameters &
  SweepGrid::scene(const std::vector<double> &all,
                   const SweepPoint          &point) const
  {
    const SceneParameters &plain = setter->scene(all);
    if (state_of.empty())
      return plain;
    scene_with_state = plain;
    for (auto &contact : scene_with_state.contacts)
      contact.state_number = state_number(point);
    return scene_with_state;
  }

  const std::vector<std::string> &
  SweepGrid::other_entries() const
  {
    return others;
  }

  double
  SweepGrid::entry_value(const SweepPoint  &point,
                         const unsigned int entry) const
  {
    std::vector<double> all = values(point);
    all.insert(all.end(), other_values.begin(), other_values.end());
    return all.at(entry);
  }

  const SceneParameters &
  SweepGrid::scene(const SweepPoint  &point,
                   const unsigned int entry,
                   const double       factor) const
  {
    std::vector<double> all = values(point);
    all.insert(all.end(), other_values.begin(), other_values.end());
    all.at(entry) *= factor;
    return scene(all, point);
  }



  void
  SweepGrid::set_states(std::vector<unsigned int> state_of_point)
  {
    AssertDimension(state_of_point.size(), n_points());
    state_of = std::move(state_of_point);
  }

  const std::vector<unsigned int> &
  SweepGrid::states() const
  {
    return state_of;
  }

  unsigned int
  SweepGrid::n_states() const
  {
    return state_of.empty()
             ? 1
             : *std::max_element(state_of.begin(), state_of.end()) + 1;
  }

  unsigned int
  SweepGrid::state_number(const SweepPoint &point) const
  {
    if (state_of.empty())
      return 0;
    std::size_t number = 0, stride = 1;
    for (unsigned int a = 0; a < n_axes(); ++a)
      {
        const auto nearest = std::min_element(
          grid[a].begin(), grid[a].end(), [&](const double x, const double y) {
            return std::abs(x - point[a]) < std::abs(y - point[a]);
          });
        number += stride * (nearest - grid[a].begin());
        stride *= grid[a].size();
      }
    return state_of[number];
  }

  std::vector<SweepPoint>
  SweepGrid::state_representatives() const
  {
    std::vector<std::vector<std::size_t>> members(n_states());
    for (std::size_t i = 0; i < state_of.size(); ++i)
      members[state_of[i]].push_back(i);
    std::vector<SweepPoint> result;
    for (const auto &own : members)
      if (!own.empty())
        result.push_back(point(own[own.size() / 2]));
    return result;
  }



  std::vector<SweepPoint>
  SweepGrid::spread(const std::size_t n) const
  {
    static constexpr unsigned int primes[] = {2, 3, 5, 7, 11, 13, 17, 19, 23};
    std::vector<SweepPoint>       result;
    SweepPoint                    low(axes.size()), high(axes.size());
    for (std::size_t a = 0; a < axes.size(); ++a)
      {
        low[a]  = lower(a);
        high[a] = upper(a);
      }
    if (axes.size() <= 6)
      for (unsigned int corner = 0; corner < (1u << axes.size()); ++corner)
        {
          SweepPoint p = low;
          for (std::size_t a = 0; a < axes.size(); ++a)
            if (corner & (1u << a))
              p[a] = high[a];
          result.push_back(p);
        }
    result.push_back(0.5 * (low + high));
    for (std::size_t i = 1; result.size() < n; ++i)
      {
        SweepPoint p = low;
        for (std::size_t a = 0; a < axes.size(); ++a)
          p[a] += (high[a] - low[a]) * radical_inverse(i, primes[a % 9]);
        result.push_back(p);
      }
    return result;
  }



  std::string
  text_of(const SweepGrid &grid, const SweepPoint &point)
  {
    std::string text;
    for (unsigned int a = 0; a < grid.n_axes(); ++a)
      text += (a > 0 ? ", " : "") + grid.axis(a).name + " = " +
              rounded_text(grid.value(a, point[a]), 5);
    return text;
  }
} // namespace squeal
