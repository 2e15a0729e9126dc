// SPDX-License-Identifier: LGPL-2.1-or-later
#include "edge_of_band.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

namespace squeal
{
  namespace
  {
    using Complex = std::complex<double>;

    /** Overlap products from which pairs belong together. */
    constexpr double good_match = 0.8, poor_match = 0.3;

    constexpr unsigned int most_rounds = 60;

    bool
    is_coalesced(const ComplexPairs &pairs, const int i, const int j)
    {
      return squared_split(pairs, i, j) < 0. && !is_multiple(pairs, i, j);
    }

    /** |y_i^T x_j| of pairs of two points. */
    Eigen::MatrixXcd
    overlaps(const ComplexPairs &left, const ComplexPairs &right)
    {
      return left.left.transpose() * right.right;
    }

    struct Overlaps
    {
      Eigen::MatrixXcd ab, ba, aa, bb;

      /** 1 where pair i of a is pair j of b. */
      double
      single(const int i, const int j) const
      {
        return std::abs(ab(i, j) * ba(j, i) / (aa(i, i) * bb(j, j)));
      }

      /** The same for the invariant subspaces of two pairs each. */
      double
      twin(const int i, const int j, const int k, const int l) const
      {
        const auto det = [](const Eigen::MatrixXcd &G,
                            const int               p,
                            const int               q,
                            const int               r,
                            const int               s) {
          return G(p, r) * G(q, s) - G(p, s) * G(q, r);
        };
        return std::abs(det(ab, i, j, k, l) * det(ba, k, l, i, j) /
                        (det(aa, i, j, i, j) * det(bb, k, l, k, l)));
      }
    };

    bool
    is_like_one(const double overlap)
    {
      return overlap > good_match && overlap < 1. / good_match;
    }

    /** What a pair is among those with its vectors. */
    enum class Role
    {
      oscillates,
      upper, /**< of two real eigenvalues */
      lower
    };

    /** @p own: overlaps of the pairs with each other. A partner beyond the band
     * is the one that decays faster. */
    std::vector<Role>
    roles_of(const ComplexPairs &pairs, const Eigen::MatrixXcd &own)
    {
      const int         n = pairs.size();
      std::vector<Role> roles(n, Role::oscillates);
      for (int i = 0; i < n; ++i)
        if (is_real(pairs, i))
          {
            roles[i] = Role::upper;
            for (int j = 0; j < n; ++j)
              if (j != i && is_real(pairs, j) &&
                  pairs.sigma(j) > pairs.sigma(i) &&
                  is_like_one(
                    std::abs(own(i, j) * own(j, i) / (own(i, i) * own(j, j)))))
                roles[i] = Role::lower;
          }
      return roles;
    }

    /** The two real eigenvalues of one motion have like vectors: only their
     * order tells them apart. A pair that oscillates turns into the upper one.
     */
    bool
    may_be_one(const Role a, const Role b)
    {
      return (a == Role::lower) == (b == Role::lower);
    }

    /** An overdamped motion has the vectors of a pair that oscillates where two
     * dampers hold one shape: of those only lambda tells them apart. */
    bool
    is_other(const ComplexPairs &a, const int i, const ComplexPairs &b, int j)
    {
      const bool first = is_real(a, i), second = is_real(b, j);
      return first != second && (first ? a.sigma(i) : b.sigma(j)) < 0. &&
             std::abs(a.lambda[i] - b.lambda[j]) >
               0.5 * std::max(std::abs(a.lambda[i]), std::abs(b.lambda[j]));
    }

    /** The two pairs in the order that branches keep: by sigma where they have
     * coalesced, by frequency elsewhere. */
    std::pair<int, int>
    ordered(const ComplexPairs &pairs, const int i, const int j)
    {
      const bool by_sigma = is_coalesced(pairs, i, j);
      const auto key      = [&](const int k) {
        return by_sigma ? pairs.lambda[k].real() : pairs.lambda[k].imag();
      };
      return key(i) <= key(j) ? std::make_pair(i, j) : std::make_pair(j, i);
    }
  } // namespace



  int
  TrackedPoint::pair_of(const int wanted) const
  {
    for (std::size_t i = 0; i < branch.size(); ++i)
      if (branch[i] == wanted)
        return i;
    return -1;
  }

  bool
  is_real(const ComplexPairs &pairs, const int i)
  {
    return std::abs(pairs.lambda[i].imag()) <=
           1e-10 * std::abs(pairs.lambda[i]);
  }

  bool
  is_multiple(const ComplexPairs &pairs, const int i, const int j)
  {
    return std::abs(pairs.lambda[i] - pairs.lambda[j]) <
             1e-8 * std::abs(pairs.lambda[i]) &&
           pairs.condition[i] < coalescence_condition &&
           pairs.condition[j] < coalescence_condition;
  }

  double
  squared_split(const ComplexPairs &pairs, const int i, const int j)
  {
    const Complex d = pairs.lambda[i] - pairs.lambda[j];
    return -0.25 * (d * d).real();
  }



  PairMatches
  match_pairs(const ComplexPairs    &a,
              const ComplexPairs    &b,
              const TrackingOptions &options)
  {
    const int      n = a.size(), m = b.size();
    const Overlaps o{
      overlaps(a, b), overlaps(b, a), overlaps(a, a), overlaps(b, b)};
    const std::vector<Role> role_a = roles_of(a, o.aa),
                            role_b = roles_of(b, o.bb);
    PairMatches      result{std::vector<int>(n, -1), true};
    std::vector<int> from(m, -1);
    // Alone and without doubt.
    for (int i = 0; i < n; ++i)
      {
        int    best = -1;
        double most = 0., second = 0.;
        for (int j = 0; j < m; ++j)
          if (const double s =
                may_be_one(role_a[i], role_b[j]) && !is_other(a, i, b, j)
                  ? o.single(i, j)
                  : 0.;
              s > most)
            {
              second = most;
              most   = s;
              best   = j;
            }
          else
            second = std::max(second, s);
        if (best >= 0 && is_like_one(most) && second < poor_match &&
            from[best] < 0)
          {
            result.to[i] = best;
            from[best]   = i;
          }
      }
    // Two together where they coalesce at one end at least; with damping that
    // is not proportional they never quite do on the real axis.
    for (int i = 0; i < n; ++i)
      for (int j = i + 1; j < n; ++j)
        for (int k = 0; k < m; ++k)
          for (int l = k + 1; l < m; ++l)
            {
              if (result.to[i] >= 0 || result.to[j] >= 0 || from[k] >= 0 ||
                  from[l] >= 0)
                continue;
              if (!is_like_one(o.twin(i, j, k, l)))
                continue;
              // Any two vectors of a multiple eigenvalue are right.
              const bool at_end =
                (options.real &&
                 (is_coalesced(a, i, j) || is_coalesced(b, k, l))) ||
                (is_multiple(a, i, j) && is_multiple(b, k, l));
              if (!at_end)
                continue;
              const auto [p, q] = ordered(a, i, j);
              const auto [r, s] = ordered(b, k, l);
              result.to[p]      = r;
              result.to[q]      = s;
              from[r]           = p;
              from[s]           = q;
            }
    // The rest may leave or enter near the edges of the band only. What becomes
    // real at 0 Hz does not leave it.
    const double margin =
      0.03 * (options.highest_frequency - options.lowest_frequency);
    const double lower =
      options.lowest_frequency > 0. ? options.lowest_frequency + margin : 0.;
    const auto inside = [&](const ComplexPairs &pairs, const int i) {
      const double f = pairs.frequency(i);
      return !comes_and_goes(pairs, i, options) &&
             (is_real(pairs, i) ||
              (f > lower && f < options.highest_frequency - margin));
    };
    for (int i = 0; i < n; ++i)
      if (result.to[i] < 0 && inside(a, i))
        result.is_certain = false;
    for (int j = 0; j < m; ++j)
      if (from[j] < 0 && inside(b, j))
        result.is_certain = false;
    return result;
  }



  namespace
  {
    /** What remains when steps can not be smaller: by frequency. */
    void
    match_rest(const ComplexPairs &a, const ComplexPairs &b, PairMatches &m)
    {
      std::vector<bool> taken(b.size(), false);
      for (const int j : m.to)
        if (j >= 0)
          taken[j] = true;
      for (unsigned int i = 0; i < a.size(); ++i)
        if (m.to[i] < 0)
          {
            int    best     = -1;
            double distance = 0.02 * std::abs(a.lambda[i]);
            for (unsigned int j = 0; j < b.size(); ++j)
              if (const double d = std::abs(a.lambda[i] - b.lambda[j]);
                  !taken[j] && d < distance)
                {
                  best     = j;
                  distance = d;
                }
            m.to[i] = best;
            if (best >= 0)
              taken[best] = true;
          }
    }

    void
    label(std::vector<TrackedPoint>      &points,
          const std::vector<PairMatches> &matches)
    {
      int n_branches = 0;
      for (auto &point : points)
        point.branch.assign(point.pairs.size(), -1);
      for (std::size_t p = 0; p < points.size(); ++p)
        {
          if (p > 0)
            for (std::size_t i = 0; i < matches[p - 1].to.size(); ++i)
              if (const int j = matches[p - 1].to[i]; j >= 0)
                points[p].branch[j] = points[p - 1].branch[i];
          for (int &b : points[p].branch)
            if (b < 0)
              b = n_branches++;
        }
    }

    /** Where the parabola through three values has its minimum. */
    double
    parabola_minimum(const double x[3], const double y[3], double &lowest)
    {
      const double s1 = (y[1] - y[0]) / (x[1] - x[0]);
      const double s2 = (y[2] - y[1]) / (x[2] - x[1]);
      const double c  = (s2 - s1) / (x[2] - x[0]);
      if (!(c > 0.))
        {
          lowest = y[1];
          return x[1];
        }
      const double at = 0.5 * (x[0] + x[1]) - 0.5 * s1 / c;
      lowest          = y[0] + s1 * (at - x[0]) + c * (at - x[0]) * (at - x[1]);
      return at;
    }

    /** Coordinates at which two frequencies seem to touch between the points:
     * to be looked at. */
    void
    add_touches(const std::vector<TrackedPoint> &points,
                const double                     tolerance,
                std::set<double>                &wanted)
    {
      for (std::size_t p = 1; p + 1 < points.size(); ++p)
        for (unsigned int i = 0; i < points[p].pairs.size(); ++i)
          for (unsigned int j = i + 1; j < points[p].pairs.size(); ++j)
            {
              double x[3], y[3];
              bool   there = true;
              for (int k = 0; k < 3; ++k)
                {
                  const auto &q = points[p + k - 1];
                  const int   a = q.pair_of(points[p].branch[i]);
                  const int   b = q.pair_of(points[p].branch[j]);
                  there         = there && a >= 0 && b >= 0;
                  x[k]          = q.coordinate;
                  if (there)
                    y[k] = squared_split(q.pairs, a, b);
                }
              if (!there || is_multiple(points[p].pairs, i, j) || y[0] < 0. ||
                  y[1] < 0. || y[2] < 0. || y[1] > y[0] || y[1] > y[2])
                continue;
              double       lowest;
              const double at = parabola_minimum(x, y, lowest);
              if (lowest > 0.7 * y[1] || at <= x[0] || at >= x[2])
                continue;
              double nearest = 1e300;
              for (int k = 0; k < 3; ++k)
                nearest = std::min(nearest, std::abs(at - x[k]));
              if (nearest > tolerance)
                wanted.insert(at);
            }
    }
  } // namespace



  std::vector<int>
  loop_permutation(const TrackedPoint    &first,
                   const TrackedPoint    &last,
                   const TrackingOptions &options)
  {
    const PairMatches match = match_pairs(last.pairs, first.pairs, options);
    int               n     = 0;
    for (const int b : last.branch)
      n = std::max(n, b + 1);
    std::vector<int> result(n, -1);
    for (std::size_t i = 0; i < last.branch.size(); ++i)
      if (match.to[i] >= 0)
        result[last.branch[i]] = first.branch[match.to[i]];
    return result;
  }



  namespace
  {
    /** Where branches that swap their order between two points cross, if that
     * has not been looked at yet: it may be a lock-in or a veering. */
    void
    add_crossings(const TrackedPoint &a,
                  const TrackedPoint &b,
                  const PairMatches  &match,
                  const double        tolerance,
                  std::set<double>   &wanted)
    {
      for (unsigned int i = 0; i < a.pairs.size(); ++i)
        for (unsigned int j = i + 1; j < a.pairs.size(); ++j)
          {
            const int k = match.to[i], l = match.to[j];
            if (k < 0 || l < 0)
              continue;
            const double before =
              a.pairs.lambda[j].imag() - a.pairs.lambda[i].imag();
            const double after =
              b.pairs.lambda[l].imag() - b.pairs.lambda[k].imag();
            if (before * after >= 0. || is_coalesced(a.pairs, i, j) ||
                is_coalesced(b.pairs, k, l))
              continue;
            const double at = a.coordinate + before / (before - after) *
                                               (b.coordinate - a.coordinate);
            if (at - a.coordinate > tolerance && b.coordinate - at > tolerance)
              wanted.insert(at);
          }
    }

    /** Enters in @p wanted where the step from point @p p is to be divided.
     * What is in doubt where it may not be is matched by frequency. */
    void
    divide(const std::vector<TrackedPoint> &points,
           std::vector<PairMatches>        &matches,
           const std::size_t                p,
           const bool                       may_divide,
           const TrackingOptions           &options,
           std::set<double>                &wanted)
    {
      const TrackedPoint &a = points[p], &b = points[p + 1];
      if (matches[p].is_certain && ends_at_edges(points, matches, p, options))
        {
          if (may_divide)
            add_crossings(a, b, matches[p], options.touch_tolerance, wanted);
        }
      else if (may_divide &&
               b.coordinate - a.coordinate > options.smallest_step)
        wanted.insert(0.5 * (a.coordinate + b.coordinate));
      else
        match_rest(a.pairs, b.pairs, matches[p]);
    }
  } // namespace

  BranchTracker::BranchTracker(const Solver &s, const TrackingOptions &o)
    : solver(s)
    , options(o)
  {
  }

  unsigned int
  BranchTracker::n_inserted() const
  {
    return inserted;
  }

  std::vector<TrackedPoint>
  BranchTracker::track(const std::vector<double> &coordinates)
  {
    std::map<double, TrackedPoint> solved;
    const auto                     add = [&](const double x, const bool asked) {
      auto &point = solved[x];
      if (point.pairs.lambda.size() == 0)
        {
          point.coordinate = x;
          point.pairs      = solver(x);
          if (!asked)
            ++inserted;
        }
      point.asked = point.asked || asked;
    };
    for (const double x : coordinates)
      add(x, true);

    std::map<std::pair<double, double>, PairMatches> known;
    std::vector<TrackedPoint>                        points;
    for (unsigned int round = 0;; ++round)
      {
        std::set<double>         wanted;
        std::vector<PairMatches> matches;
        points.clear();
        for (const auto &[x, point] : solved)
          {
            if (!points.empty())
              {
                const TrackedPoint &before = points.back();
                const auto          key = std::make_pair(before.coordinate, x);
                auto                found = known.find(key);
                if (found == known.end())
                  found =
                    known
                      .emplace(key,
                               match_pairs(before.pairs, point.pairs, options))
                      .first;
                matches.push_back(found->second);
              }
            points.push_back(point);
          }
        const bool may_divide =
          round < most_rounds && inserted < options.most_inserted;
        for (std::size_t p = 0; p < matches.size(); ++p)
          divide(points, matches, p, may_divide, options, wanted);
        label(points, matches);
        if (wanted.empty() && may_divide)
          add_touches(points, options.touch_tolerance, wanted);
        if (wanted.empty())
          return points;
        for (const double x : wanted)
          add(x, false);
      }
  }
} // namespace squeal
