// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/worst_of.h>
#include <squeal/eigen/unstable_pair.h>
#include <squeal/sweep/stability.h>

#include "certain_sigma.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace squeal
{
  namespace
  {
    using Complex = std::complex<double>;

    /** Of the interval of a line at whose ends two pairs are to be near enough
     * to each other for steps to their coalescence. */
    constexpr unsigned int most_halvings = 6;
    /** After how many halvings of an interval, from which the steps lead to a
     * coalescence elsewhere, they start again. */
    constexpr unsigned int halvings_before_search[] =
      {0, 1, 2, 4, 7, 11, 16, 24};
    /** Searches from intervals one in the other that lead to the same place off
     * the real axis: those from shorter ones do as well. */
    constexpr unsigned int enough_alike = 4;

    /** Condition of the two of @p pairs next to those beside a coalescence, NaN
     * where the band has none next to one of them. */
    double
    condition_beside(const Coalescence &found, const ComplexPairs &pairs)
    {
      double condition = 0.;
      for (const Complex lambda : found.beside)
        {
          double nearest = 1e-2 * std::abs(lambda), own = std::nan("");
          for (unsigned int i = 0; i < pairs.size(); ++i)
            if (const double d = std::abs(pairs.lambda[i] - lambda);
                d < nearest)
              {
                nearest = d;
                own     = pairs.condition[i];
              }
          condition = worst_of(condition, own);
        }
      return condition;
    }

    /** Whether it is one of @p known, found from another interval. */
    bool
    is_known(const ExceptionalPoint              &e,
             const std::vector<ExceptionalPoint> &known,
             const double                         length)
    {
      return std::any_of(
        known.begin(), known.end(), [&](const ExceptionalPoint &k) {
          const Complex difference(k.sigma - e.sigma,
                                   2. * M_PI * (k.frequency - e.frequency));
          return std::abs(k.coordinate - e.coordinate) <= 1e-6 * length &&
                 std::abs(difference) <= 1e-6 * 2. * M_PI * e.frequency;
        });
    }

    /** Pairs whose squared split changes its sign between neighbouring points:
     * the first of the points, and the numbers of both pairs there. */
    std::vector<std::array<unsigned int, 3>>
    approaches(const std::vector<TrackedPoint> &line)
    {
      std::vector<std::array<unsigned int, 3>> result;
      for (unsigned int p = 0; p + 1 < line.size(); ++p)
        for (unsigned int i = 0; i < line[p].pairs.size(); ++i)
          for (unsigned int j = i + 1; j < line[p].pairs.size(); ++j)
            {
              const ComplexPairs &a = line[p].pairs, &b = line[p + 1].pairs;
              const int           k = line[p + 1].pair_of(line[p].branch[i]),
                        l           = line[p + 1].pair_of(line[p].branch[j]);
              if (k < 0 || l < 0 || is_multiple(a, i, j) ||
                  is_multiple(b, k, l))
                continue;
              // A rate that passes a frequency is no coalescence.
              if (is_real(a, i) != is_real(a, j) ||
                  is_real(b, k) != is_real(b, l))
                continue;
              const double before = squared_split(a, i, j),
                           after  = squared_split(b, k, l);
              if ((before < 0.) != (after < 0.))
                result.push_back({p, i, j});
            }
      return result;
    }

    /** Two points with the same two branches, and their squared splits. */
    struct Approach
    {
      TrackedPoint a, b;
      int          branch_1, branch_2;

      static double
      split(const TrackedPoint &point, const int b1, const int b2)
      {
        return squared_split(point.pairs, point.pair_of(b1), point.pair_of(b2));
      }

      /** Two overdamped or far apart pairs do not coalesce by a sign. */
      bool
      is_near(const TrackedPoint &point) const
      {
        return std::abs(split(point, branch_1, branch_2)) <
               0.01 * std::norm(point.pairs.lambda[point.pair_of(branch_1)]);
      }

      /** Half of the way, of which the half with the change of sign is kept;
       * false where either pair is lost. */
      bool
      halve(const BranchTracker::Solver &solver, const TrackingOptions &options)
      {
        TrackedPoint middle      = a;
        middle.coordinate        = 0.5 * (a.coordinate + b.coordinate);
        middle.pairs             = solver(middle.coordinate);
        const PairMatches from_a = match_pairs(a.pairs, middle.pairs, options),
                          from_b = match_pairs(b.pairs, middle.pairs, options);
        const auto pair_of       = [&](const int branch) {
          const int i = from_a.to[a.pair_of(branch)];
          return i < 0 ? from_b.to[b.pair_of(branch)] : i;
        };
        const int i = pair_of(branch_1), j = pair_of(branch_2);
        if (i < 0 || j < 0 || i == j)
          return false;
        middle.branch.assign(middle.pairs.size(), -1);
        middle.branch[i]     = branch_1;
        middle.branch[j]     = branch_2;
        const bool is_behind = (split(middle, branch_1, branch_2) < 0.) ==
                               (split(b, branch_1, branch_2) < 0.);
        (is_behind ? b : a) = middle;
        return true;
      }

      bool
      holds(const double x) const
      {
        const double rounding =
          1e-9 * (std::abs(a.coordinate) + std::abs(b.coordinate));
        return x >= a.coordinate - rounding && x <= b.coordinate + rounding;
      }

      /**
       * The coalescence to which the change of sign belongs. Steps from a wide
       * interval may lead to another one, such as the lock-out behind a
       * lock-in: the interval is halved until they stay in it. On the real axis
       * they must at last; off it, where the real part of a squared
       * half-difference changes its sign beside its root, what the shortest
       * intervals lead to counts.
       */
      std::optional<Coalescence>
      coalescence(const Continuation          &continuation,
                  const BranchTracker::Solver &solver,
                  const TrackingOptions       &options,
                  const Stretch               &whole)
      {
        std::optional<Coalescence> found;
        unsigned int               n_halvings = 0, n_alike = 0;
        for (const unsigned int n : halvings_before_search)
          {
            while (n_halvings < n && halve(solver, options))
              ++n_halvings;
            if (n_halvings < n || (n_alike == enough_alike && !options.real))
              break;
            const auto next =
              coalescence_of(continuation, a, b, branch_1, branch_2, whole);
            if (!next)
              continue;
            if (holds(next->coordinate.real()))
              return next;
            const bool is_alike =
              found && std::abs(next->coordinate - found->coordinate) <=
                         1e-6 * (whole.upper - whole.lower);
            n_alike = is_alike ? n_alike + 1 : 1;
            found   = next;
          }
        return options.real ? std::nullopt : found;
      }
    };
  } // namespace



  LineStability::LineStability(const BranchTracker::Solver       &s,
                               const TrackingOptions             &o,
                               const double                       t,
                               const std::function<bool(double)> &is_known)
    : solver(s)
    , options(o)
    , tolerance(t)
    , known(is_known)
  {
  }

  bool
  LineStability::knows(const double x) const
  {
    return !known || known(x);
  }

  double
  LineStability::At::sigma() const
  {
    return pair < 0 ? std::nan("") : certain_sigma(pairs, pair);
  }

  LineStability::At
  LineStability::continue_pair(const TrackedPoint &near,
                               const int           pair,
                               const double        x) const
  {
    At result;
    result.pairs            = solver(x);
    const PairMatches match = match_pairs(near.pairs, result.pairs, options);
    result.pair             = match.to[pair];
    if (result.pair >= 0)
      return result;
    // In doubt the nearest eigenvalue, of two the one with larger sigma.
    double distance = 1e300;
    for (unsigned int i = 0; i < result.pairs.size(); ++i)
      if (const double d =
            std::abs(result.pairs.lambda[i] - near.pairs.lambda[pair]);
          d < distance)
        {
          distance    = d;
          result.pair = i;
        }
    return result;
  }



  bool
  LineStability::may_peak_between(const TrackedPoint &a,
                                  const TrackedPoint &b) const
  {
    // A range without any known point has its peak somewhere all the same.
    return !knows(a.coordinate) || knows(0.5 * (a.coordinate + b.coordinate));
  }

  bool
  LineStability::locate_peak(const std::vector<TrackedPoint> &line,
                             const std::size_t                at,
                             UnstableRange                   &range) const
  {
    const TrackedPoint &top  = line[at];
    const int           pair = top.pair_of(range.branch);
    range.peak_sigma         = top.pairs.sigma(pair);
    range.peak_at            = top.coordinate;
    range.peak_frequency     = top.pairs.frequency(pair);
    bool   is_beyond         = is_unstable(top.pairs, pair);
    double low               = at > 0 && may_peak_between(top, line[at - 1])
                                 ? line[at - 1].coordinate
                                 : top.coordinate;
    double high = at + 1 < line.size() && may_peak_between(top, line[at + 1])
                    ? line[at + 1].coordinate
                    : top.coordinate;
    low         = std::max(low, range.lower);
    high        = std::min(high, range.upper);
    // Golden section.
    const double g = 0.5 * (3. - std::sqrt(5.));
    while (high - low > 100. * tolerance)
      {
        const bool   right = high - range.peak_at > range.peak_at - low;
        const double x     = right ? range.peak_at + g * (high - range.peak_at)
                                   : range.peak_at - g * (range.peak_at - low);
        const At     here  = continue_pair(top, pair, x);
        if (here.sigma() > range.peak_sigma)
          {
            (right ? low : high) = range.peak_at;
            range.peak_at        = x;
            range.peak_sigma     = here.sigma();
            range.peak_frequency = here.pairs.frequency(here.pair);
            is_beyond            = is_unstable(here.pairs, here.pair);
          }
        else
          (right ? high : low) = x;
      }
    return is_beyond;
  }



  std::vector<UnstableRange>
  LineStability::ranges(const std::vector<TrackedPoint> &line) const
  {
    int n_branches = 0;
    for (const auto &point : line)
      for (const int b : point.branch)
        n_branches = std::max(n_branches, b + 1);
    std::vector<UnstableRange> result;
    for (int branch = 0; branch < n_branches; ++branch)
      {
        const auto sigma = [&](const std::size_t p) {
          const int i = line[p].pair_of(branch);
          return i < 0 ? std::nan("") : certain_sigma(line[p].pairs, i);
        };
        for (std::size_t p = 0; p < line.size(); ++p)
          {
            if (!(sigma(p) > 0.))
              continue;
            UnstableRange range;
            range.branch     = branch;
            std::size_t last = p, top = p;
            bool        is_beyond = false;
            range.is_certain      = knows(line[p].coordinate);
            while (last + 1 < line.size() && sigma(last + 1) > 0.)
              ++last;
            for (std::size_t q = p; q <= last; ++q)
              {
                const bool is_certain = knows(line[q].coordinate);
                if (is_certain == range.is_certain ? sigma(q) > sigma(top)
                                                   : is_certain)
                  top = q;
                range.is_certain = range.is_certain || is_certain;
                const int i      = line[q].pair_of(branch);
                is_beyond        = is_beyond || is_unstable(line[q].pairs, i);
                range.sigma_error =
                  worst_of(range.sigma_error,
                           line[q].pairs.error_estimate[i] *
                             std::abs(line[q].pairs.lambda[i]));
              }
            range.lower          = line[p].coordinate;
            range.upper          = line[last].coordinate;
            range.at_lower_limit = p == 0;
            range.at_upper_limit = last + 1 == line.size();
            range.leaves_band_below =
              !range.at_lower_limit && std::isnan(sigma(p - 1));
            range.leaves_band_above =
              !range.at_upper_limit && std::isnan(sigma(last + 1));
            find_ends(line, p, last, range);
            is_beyond = locate_peak(line, top, range) || is_beyond;
            // A range in which sigma nowhere exceeds its error is none.
            if (is_beyond)
              result.push_back(range);
            p = last;
          }
      }
    std::sort(result.begin(), result.end(), [](const auto &a, const auto &b) {
      return a.lower < b.lower;
    });
    return result;
  }



  std::vector<ExceptionalPoint>
  LineStability::exceptional_points(const std::vector<TrackedPoint> &line,
                                    const Continuation &continuation) const
  {
    std::vector<ExceptionalPoint> result;
    const Stretch                 whole =
      line.empty() ? Stretch()
                                   : Stretch{line.front().coordinate, line.back().coordinate};
    const double length = whole.upper - whole.lower;
    for (const auto &[p, i, j] : approaches(line))
      {
        const int b1 = line[p].branch[i], b2 = line[p].branch[j];
        Approach  approach{line[p], line[p + 1], b1, b2};
        // On a coarse line the two are soon far apart on one side.
        bool is_near =
          approach.is_near(approach.a) && approach.is_near(approach.b);
        for (unsigned int step = 0; step < most_halvings && !is_near &&
                                    approach.halve(solver, options);
             ++step)
          is_near =
            approach.is_near(approach.a) && approach.is_near(approach.b);
        if (!is_near)
          continue;
        const auto found =
          approach.coalescence(continuation, solver, options, whole);
        if (!found)
          continue;
        ExceptionalPoint e;
        e.branch_1   = b1;
        e.branch_2   = b2;
        e.coordinate = found->coordinate;
        e.frequency  = found->lambda.imag() / (2. * M_PI);
        e.sigma      = found->lambda.real();
        e.is_lock_in = Approach::split(approach.b, b1, b2) <
                       Approach::split(approach.a, b1, b2);
        if (is_known(e, result, length))
          continue;
        e.condition = condition_beside(
          *found,
          solver(
            std::clamp(found->coordinate.real(), whole.lower, whole.upper)));
        result.push_back(e);
      }
    return result;
  }
} // namespace squeal
