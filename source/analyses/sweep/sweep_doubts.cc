// SPDX-License-Identifier: LGPL-2.1-or-later

// What the lines of a sweep leave in doubt, in warnings.

#include <squeal/analyses/sweep/sweep_solution.h>
#include <squeal/model/drive_warnings.h>

#include <algorithm>
#include <cmath>
#include <complex>

namespace squeal
{
  namespace
  {
    /** Names lines whose branches more points did not make certain. */
    void
    warn_of_doubtful_branches(const SweepModel    &model,
                              const SweepSolution &solution,
                              RunContext          &context)
    {
      const unsigned int most = tracking_options(model).most_inserted;
      for (const SweepLine &line : solution.lines)
        if (std::count_if(line.points.begin(),
                          line.points.end(),
                          [](const TrackedPoint &p) { return !p.asked; }) >=
            most)
          context.log.warning(
            "the branches along the first axis are in doubt from " +
            text_of(model.grid(), line.start) + " on, with " +
            std::to_string(most) +
            " more points, too: where their shapes do not tell them apart they "
            "are matched by frequency; more points or a narrower band of "
            "Eigenvalues help");
    }

    /** Counts ranges that no point of the grid bears out. */
    void
    warn_of_doubtful_ranges(const SweepModel    &model,
                            const SweepSolution &solution,
                            RunContext          &context)
    {
      std::size_t n = 0;
      for (const SweepLine &line : solution.lines)
        n +=
          std::count_if(line.ranges.begin(),
                        line.ranges.end(),
                        [](const UnstableRange &r) { return !r.is_certain; });
      if (n > 0)
        context.log.warning(
          (n == 1 ? "1 unstable range lies"
                  : std::to_string(n) + " unstable ranges lie") +
          std::string(" between neighbouring points of ") +
          model.grid().axis(0).name +
          " whose contact states differ, where that of the nearest point is "
          "held: more points tell whether anything squeals there");
    }

    /** Whether two branches of the line have one frequency at the first point
     * and two at the second one; what is exact but for rounding without damping
     * that parts them. */
    bool
    parts_between(const TrackedPoint &inside,
                  const TrackedPoint &outside,
                  const int           branch,
                  const int           other)
    {
      const int i = inside.pair_of(branch), j = inside.pair_of(other),
                k = outside.pair_of(branch), l = outside.pair_of(other);
      if (i < 0 || j < 0 || k < 0 || l < 0 || i == j)
        return false;
      const std::complex<double> split =
        inside.pairs.lambda[i] - inside.pairs.lambda[j];
      return std::abs(split.imag()) < 1e-6 * std::abs(split.real()) &&
             !is_multiple(inside.pairs, i, j) &&
             squared_split(outside.pairs, k, l) > 0.;
    }

    /** Whether an exceptional point of @p branch belongs to the edge of a range
     * between two neighbouring points, of which @p inside is in the range; also
     * where no two branches part. */
    bool
    has_its_point(const SweepLine    &line,
                  const TrackedPoint &inside,
                  const TrackedPoint &outside,
                  const int           branch)
    {
      const double slack = std::abs(outside.coordinate - inside.coordinate);
      const double low   = std::min(inside.coordinate, outside.coordinate),
                   high  = std::max(inside.coordinate, outside.coordinate);
      for (const int other : inside.branch)
        if (parts_between(inside, outside, branch, other) &&
            std::none_of(line.exceptional.begin(),
                         line.exceptional.end(),
                         [&](const ExceptionalPoint &e) {
                           const double x = e.coordinate.real();
                           return x > low - slack && x < high + slack &&
                                  (e.branch_1 == branch ||
                                   e.branch_2 == branch) &&
                                  (e.branch_1 == other || e.branch_2 == other);
                         }))
          return false;
      return true;
    }

    /** Counts edges at which two pairs part that have no exceptional point. */
    void
    warn_of_missing_points(const SweepModel    &model,
                           const SweepSolution &solution,
                           RunContext          &context)
    {
      if (!context.parameters.sweep.exceptional_points ||
          model.has_contact_states())
        return;
      std::size_t n = 0;
      for (const SweepLine &line : solution.lines)
        for (const UnstableRange &range : line.ranges)
          for (std::size_t p = 0; p + 1 < line.points.size(); ++p)
            {
              const TrackedPoint &a = line.points[p], &b = line.points[p + 1];
              const auto          lies_between = [&](const double x) {
                return x > a.coordinate && x <= b.coordinate;
              };
              if ((range.has_lower_edge() && lies_between(range.lower) &&
                   !has_its_point(line, b, a, range.branch)) ||
                  (range.has_upper_edge() && lies_between(range.upper) &&
                   !has_its_point(line, a, b, range.branch)))
                ++n;
            }
      if (n > 0)
        context.log.warning(
          "of " + std::to_string(n) + (n == 1 ? " edge" : " edges") +
          " of unstable ranges at which two pairs part, exceptional_points.csv "
          "does not have the point: its error by the mesh is that of another "
          "one; more points of " +
          model.grid().axis(0).name + " help");
    }

    /** Names sliding speeds of the grid at which the slope of a table jumps. */
    void
    warn_of_kinks_of_grid(const SweepModel &model, RunContext &context)
    {
      for (std::size_t i = 0; i < model.grid().n_points(); ++i)
        warn_of_kinks(model.grid().scene(model.grid().point(i)), context.log);
    }
  } // namespace



  void
  warn_of_doubts(const SweepModel    &model,
                 const SweepSolution &solution,
                 RunContext          &context)
  {
    warn_of_doubtful_branches(model, solution, context);
    warn_of_doubtful_ranges(model, solution, context);
    warn_of_missing_points(model, solution, context);
    warn_of_kinks_of_grid(model, context);
  }
} // namespace squeal
