// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/tribology/statistics/covariance_family.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace squeal::tribology
{
  namespace
  {
    enum class Kind
    {
      normal,
      exponential,
      matern
    };

    constexpr Kind kinds[] = {Kind::normal, Kind::exponential, Kind::matern};
    constexpr int  n_kinds = 3, exponential = 1;

    constexpr int    n_lengths = 14;
    constexpr double shortest = .7, length_step = 1.3;

    /** Longer over shorter axis, and how many directions of half a turn the
     * longer one takes. */
    constexpr double ratios[]       = {1., 1.6, 2.5, 4., 6.3, 10., 16., 25.};
    constexpr int    n_directions[] = {1, 2, 4, 12, 12, 12, 12, 12};
    constexpr int    n_ratios       = 8;

    /** Correlation at a distance over the length. */
    double
    correlation(const Kind kind, const double d)
    {
      switch (kind)
        {
        case Kind::normal:
          return std::exp(-d * d);
        case Kind::exponential:
          return std::exp(-d);
        case Kind::matern:
          return (1. + std::sqrt(3.) * d) * std::exp(-std::sqrt(3.) * d);
        }
      return 0.;
    }



    /** Part of half a turn between the longer axes. */
    double
    turn_between(const CovarianceMember &a, const CovarianceMember &b)
    {
      const double turn = std::abs(double(a.direction) / n_directions[a.ratio] -
                                   double(b.direction) / n_directions[b.ratio]);
      return std::min(turn, 1. - turn);
    }



    /** Whether another ratio or direction lies next to a member. */
    bool
    is_next(const CovarianceMember &a, const CovarianceMember &b)
    {
      const int step = std::abs(a.ratio - b.ratio);
      // a circle has no direction; the ratio of 1.6 knows two only
      if (a.ratio == 0 || b.ratio == 0)
        return step == 1 || step == 2;
      return step <= 1 && turn_between(a, b) <= .13;
    }
  } // namespace



  bool
  CovarianceMember::operator<(const CovarianceMember &other) const
  {
    return std::tie(kind, ratio, direction, length) <
           std::tie(other.kind, other.ratio, other.direction, other.length);
  }



  Eigen::MatrixXd
  correlations(const std::vector<CellPlace> &places,
               const CovarianceMember       &member)
  {
    const Eigen::Index n = places.size();
    if (member.is_white())
      return Eigen::MatrixXd::Identity(n, n);
    const double length = shortest * std::pow(length_step, member.length),
                 root   = std::sqrt(ratios[member.ratio]),
                 angle  = M_PI * member.direction / n_directions[member.ratio],
                 c = std::cos(angle), s = std::sin(angle);
    Eigen::MatrixXd r(n, n);
    for (Eigen::Index i = 0; i < n; ++i)
      for (Eigen::Index j = 0; j <= i; ++j)
        {
          const double x = places[i][0] - places[j][0],
                       y = places[i][1] - places[j][1];
          r(i, j)        = r(j, i) =
            correlation(kinds[member.kind],
                        std::hypot((c * x + s * y) / (root * length),
                                   (c * y - s * x) * root / length));
        }
    return r;
  }



  std::vector<CovarianceMember>
  first_members()
  {
    std::vector<CovarianceMember> members = {{}};
    for (int length = 1; length < n_lengths; length += 3)
      {
        for (int kind = 0; kind < n_kinds; ++kind)
          members.push_back({kind, 0, 0, length});
        for (int ratio = 2; ratio < n_ratios; ratio += 2)
          for (int direction = 0; direction<n_directions[ratio];
                                            direction += n_directions[ratio]> 4
                                    ? 2
                                    : 1)
            members.push_back({exponential, ratio, direction, length});
      }
    return members;
  }



  std::vector<CovarianceMember>
  neighbours(const CovarianceMember &member)
  {
    std::vector<CovarianceMember> members;
    if (member.is_white())
      return members;
    CovarianceMember other = member;
    for (other.kind = 0; other.kind < n_kinds; ++other.kind)
      if (other.kind != member.kind)
        members.push_back(other);
    other = member;
    for (const int length : {member.length - 1, member.length + 1})
      if (length >= 0 && length < n_lengths)
        {
          other.length = length;
          members.push_back(other);
        }
    other = member;
    for (other.ratio = 0; other.ratio < n_ratios; ++other.ratio)
      for (other.direction = 0; other.direction < n_directions[other.ratio];
           ++other.direction)
        if ((member < other || other < member) && is_next(member, other))
          members.push_back(other);
    return members;
  }
} // namespace squeal::tribology
