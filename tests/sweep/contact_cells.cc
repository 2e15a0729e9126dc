// SPDX-License-Identifier: LGPL-2.1-or-later

// Contact states that are held between the points of a grid: where the state is
// known, how far off an edge may be, and peaks that are no effect of the state
// of a neighbour, of a pair whose sigma is given in closed form.

#include <squeal/sweep/contact_cells.h>
#include <squeal/sweep/stability.h>

#include "check.h"
#include "source_directory.h"

#include <cmath>
#include <memory>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  SweepPoint
  at(const double x, const double y)
  {
    SweepPoint point(2);
    point << x, y;
    return point;
  }

  /** Log10 of the pad's stiffness from 10 to 11 (or back) in steps of 0.25 and
   * friction of 0.1 and 0.5, with the state @p of of every point. */
  template <typename State>
  std::unique_ptr<SweepGrid>
  grid_with(const bool descends, const State &of)
  {
    const std::string pad  = "Sweep/Axis e_pad/";
    auto              grid = std::make_unique<SweepGrid>(
      read_parameters(SQUEAL_SOURCE_DIR "/prm/tribobrake/stability_map.prm",
                      {pad + "From = " + (descends ? "1e11" : "1e10"),
                                    pad + "To = " + (descends ? "1e10" : "1e11"),
                                    pad + "Number = 5",
                                    "Sweep/Axis mu/Values = 0.1, 0.5"}));
    std::vector<unsigned int> states;
    for (std::size_t i = 0; i < grid->n_points(); ++i)
      states.push_back(of(grid->point(i)));
    grid->set_states(states);
    return grid;
  }

  void
  cells()
  {
    for (const bool descends : {false, true})
      {
        // The state changes between 10.25 and 10.5, with much friction between
        // 10.5 and 10.75, too.
        const auto states = [](const SweepPoint &point) {
          return point[0] < 10.4                     ? 0
                 : point[0] < 10.6 && point[1] > 0.3 ? 1
                                                     : 2;
        };
        const auto       owner = grid_with(descends, states);
        const SweepGrid &grid  = *owner;
        check(has_known_contact(grid, at(10.1, 0.3)) &&
                has_known_contact(grid, at(10.8, 0.2)),
              "all corners of the cell have one state");
        check(!has_known_contact(grid, at(10.3, 0.1)) &&
                !has_known_contact(grid, at(10.6, 0.3)),
              "corners differ along the first axis, or along both");
        check(has_known_contact(grid, at(10.6, 0.1)) &&
                !has_known_contact(grid, at(10.6, 0.5)),
              "on a line of the grid its own points count alone");
        const SweepPoint point = grid.point(2);
        check(has_known_contact(grid, point) &&
                error_by_held_contact(grid, point) == 0.,
              "a point of the grid has its own state");
        check(has_known_contact(grid, at(9., 0.1)),
              "beyond an end that of the end holds");
        check_close(error_by_held_contact(grid, at(10.375, 0.1)),
                    0.125,
                    1e-12,
                    "half a step where the state changes");
        check_close(error_by_held_contact(grid, at(10.3, 0.1)),
                    0.2,
                    1e-12,
                    "to the farther point elsewhere");
        check(error_by_held_contact(grid, at(10.1, 0.1)) == 0.,
              "none between points of one state");
      }
    const auto plain = grid_with(false, [](const SweepPoint &) { return 0; });
    check(has_known_contact(*plain, at(10.3, 0.3)), "one state is known");
  }



  template <typename Sigma>
  ComplexPairs
  pair_of(const Sigma &sigma, const double x)
  {
    ComplexPairs pairs;
    pairs.lambda         = Eigen::VectorXcd::Constant(1, {sigma(x), 100.});
    pairs.right          = Eigen::MatrixXcd::Ones(1, 1);
    pairs.left           = Eigen::MatrixXcd::Ones(1, 1);
    pairs.pair_partner   = {-1};
    pairs.error_estimate = pairs.noise_floor = Eigen::VectorXd::Zero(1);
    pairs.condition                          = Eigen::VectorXd::Ones(1);
    return pairs;
  }

  /** The range of one pair on the line of the @p coordinates, whose states
   * differ between 0 and 1. */
  template <typename Sigma>
  UnstableRange
  range_of(const Sigma &sigma, const std::vector<double> &coordinates)
  {
    TrackingOptions options;
    options.highest_frequency = 100.;
    const auto solver = [&](const double x) { return pair_of(sigma, x); };
    std::vector<TrackedPoint> line;
    for (const double x : coordinates)
      line.push_back({x, x == std::floor(x), solver(x), {0}});
    const auto ranges =
      LineStability(solver, options, 1e-7, [](const double x) {
        return x <= 0. || x >= 1.;
      }).ranges(line);
    check(ranges.size() == 1, "one range");
    return ranges.at(0);
  }

  void
  peaks()
  {
    // Held from the middle on, sigma falls from there: at 0.5 it would be 4.
    const auto falls = [](const double x) {
      return x < 0.5 ? 1. : 5. - 2. * x;
    };
    const UnstableRange at_point = range_of(falls, {0., 0.5, 1., 2.});
    check_close(at_point.peak_sigma, 3., 1e-12, "the peak of the points");
    check(at_point.peak_at == 1. && at_point.is_certain, "is at one of them");
    // The peak that is to be found stands between points of one state.
    const auto bends = [](const double x) {
      return x < 0.5 ? 9. * x : 3. - 4. * (x - 1.3) * (x - 1.3);
    };
    const UnstableRange between = range_of(bends, {0., 0.499, 1., 2.});
    check_close(between.peak_sigma, 3., 1e-8, "a peak between equal states");
    check_close(between.peak_at, 1.3, 1e-4, "is found there");
    // What only the held state makes unstable.
    const auto passes = [](const double x) {
      return x > 0.4 && x < 0.5 ? 1. : -1.;
    };
    const UnstableRange held = range_of(passes, {0., 0.45, 1., 2.});
    check(!held.is_certain && held.peak_sigma == 1.,
          "a range without a point that bears it out is not certain");
  }
} // namespace



int
main()
{
  cells();
  peaks();
}
