// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/analyses/transient/force_statistics.h>
#include <squeal/base/unknown_choice.h>
#include <squeal/base/worst_of.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace squeal
{
  namespace
  {
    constexpr double no_quotient = std::numeric_limits<double>::quiet_NaN();

    /** Mean squares of the vibration along two axes across each other that
     * differ by less than this share of the mean of both are those of one that
     * goes round: its rms is the same along every axis but for as much. */
    constexpr double going_round = 1e-2;

    /** A smaller part of a combination is rounding. */
    constexpr double least_part = 1e-6;
  } // namespace



  // Differences of means, as those of mean squares would drown small
  // vibrations.
  void
  join(const SignalPiece &other, SignalPiece &piece)
  {
    if (other.n == 0.)
      return;
    const double n = piece.n, m = other.n, change = other.mean - piece.mean;
    piece.mean += change * m / (n + m);
    piece.square += other.square + change * change * n * m / (n + m);
    // The middles of the two are (n + m) / 2 values apart.
    piece.moment += other.moment + 0.5 * change * n * m;
    piece.n += m;
  }



  MomentParts
  loudest_moment(const double first, const double second, const double mixed)
  {
    const double half_difference = .5 * (first - second);
    if (!(std::hypot(half_difference, mixed) >
          going_round * .5 * (first + second)))
      return {{1., 0.}};
    const double      angle = .5 * std::atan2(mixed, half_difference);
    const MomentParts parts{{std::cos(angle), std::sin(angle)}};
    return std::abs(parts[1]) < least_part ? MomentParts{{1., 0.}}
           : parts[0] < least_part         ? MomentParts{{0., 1.}}
                                           : parts;
  }



  double
  leading_edge_factor(const StepSums &sums)
  {
    return sums.pressing > 0. ? sums.edge / sums.pressing : no_quotient;
  }



  void
  ForceStatistics::add(const StepSums &sums, const bool is_apart)
  {
    ForceStatistics step;
    step.n_steps         = 1.;
    step.mean_normal     = sums.normal;
    step.min_normal      = sums.normal;
    step.max_normal      = sums.normal;
    step.mean_tangential = sums.tangential;
    step.mean_edge       = sums.edge;
    step.mean_pressing   = sums.pressing;
    step.mean_friction   = sums.friction;
    step.mean_first      = sums.first_moment;
    step.mean_second     = sums.second_moment;
    step.n_apart         = is_apart ? 1. : 0.;
    add(step);
  }



  void
  ForceStatistics::add(const ForceStatistics &other)
  {
    if (other.n_steps == 0.)
      return;
    if (n_steps == 0.)
      {
        *this = other;
        return;
      }
    SignalPiece pressing = normal(), pulling = tangential(),
                first = first_moment(), second = second_moment();
    const double n = n_steps, m = other.n_steps;
    mixed_moments += other.mixed_moments + (other.mean_first - mean_first) *
                                             (other.mean_second - mean_second) *
                                             n * m / (n + m);
    join(other.normal(), pressing);
    join(other.tangential(), pulling);
    join(other.first_moment(), first);
    join(other.second_moment(), second);
    mean_normal       = pressing.mean;
    square_normal     = pressing.square;
    moment_normal     = pressing.moment;
    mean_tangential   = pulling.mean;
    square_tangential = pulling.square;
    moment_tangential = pulling.moment;
    mean_first        = first.mean;
    square_first      = first.square;
    moment_first      = first.moment;
    mean_second       = second.mean;
    square_second     = second.square;
    moment_second     = second.moment;
    mean_edge += (other.mean_edge - mean_edge) * m / (n + m);
    mean_pressing += (other.mean_pressing - mean_pressing) * m / (n + m);
    mean_friction += (other.mean_friction - mean_friction) * m / (n + m);
    min_normal = std::min(min_normal, other.min_normal);
    max_normal = std::max(max_normal, other.max_normal);
    n_apart += other.n_apart;
    n_steps += m;
  }



  double
  ForceStatistics::rms_normal() const
  {
    return rms_of(normal());
  }

  double
  ForceStatistics::rms_tangential() const
  {
    return rms_of(tangential());
  }

  double
  ForceStatistics::macroscopic_friction() const
  {
    return mean_pressing > 0. ? mean_friction / mean_pressing : no_quotient;
  }

  double
  ForceStatistics::leading_edge_factor() const
  {
    return mean_pressing > 0. ? mean_edge / mean_pressing : no_quotient;
  }



  SignalPiece
  ForceStatistics::normal() const
  {
    return {n_steps, mean_normal, moment_normal, square_normal};
  }

  SignalPiece
  ForceStatistics::tangential() const
  {
    return {n_steps, mean_tangential, moment_tangential, square_tangential};
  }

  SignalPiece
  ForceStatistics::first_moment() const
  {
    return {n_steps, mean_first, moment_first, square_first};
  }

  SignalPiece
  ForceStatistics::second_moment() const
  {
    return {n_steps, mean_second, moment_second, square_second};
  }

  SignalPiece
  ForceStatistics::moment(const MomentParts &parts) const
  {
    const auto [a, b] = parts;
    // Rounding may leave less than nothing.
    return {n_steps,
            a * mean_first + b * mean_second,
            a * moment_first + b * moment_second,
            std::max(0.,
                     a * a * square_first + 2. * a * b * mixed_moments +
                       b * b * square_second)};
  }

  double
  rms_of(const SignalPiece &piece)
  {
    return piece.n > 0. ? std::sqrt(piece.square / piece.n) : 0.;
  }



  ForceStatistics
  statistics_of(const std::vector<ForceStatistics> &stretches,
                const unsigned int                  first,
                const unsigned int                  end)
  {
    ForceStatistics result;
    for (unsigned int k = first; k < end; ++k)
      result.add(stretches.at(k));
    return result;
  }



  const std::vector<double> &
  QuarterVibrations::of(const JudgedForce force) const
  {
    switch (force)
      {
      case JudgedForce::normal:
        return normal;
      case JudgedForce::tangential:
        return tangential;
      case JudgedForce::moment:
        return moment;
      case JudgedForce::node:
        break;
      }
    unknown_choice("judged force");
  }



  double
  change_of_rms(const std::vector<double> &quarters)
  {
    return (std::hypot(quarters.at(2), quarters.at(3)) -
            std::hypot(quarters.at(0), quarters.at(1))) /
           M_SQRT2;
  }

  double
  share_of_change(const std::vector<double> &quarters)
  {
    const double size = worst_of(std::hypot(quarters.at(0), quarters.at(1)),
                                 std::hypot(quarters.at(2), quarters.at(3))) /
                        M_SQRT2;
    return size > 0. ? change_of_rms(quarters) / size : 0.;
  }



  QuarterVibrations
  vibrations_of(const std::vector<ForceStatistics> &stretches,
                const unsigned int                  first,
                const unsigned int                  end)
  {
    const auto quarters = [&](const auto &piece_of) {
      std::vector<SignalPiece> pieces;
      for (unsigned int k = first; k < end; ++k)
        pieces.push_back(piece_of(stretches.at(k)));
      return rms_beside_slow_part(pieces, 4);
    };
    const auto moment = [&](const MomentParts &parts) {
      return quarters(
        [&](const ForceStatistics &s) { return s.moment(parts); });
    };
    const auto square = [&](const MomentParts &parts) {
      double sum = 0.;
      for (const double rms : moment(parts))
        sum += rms * rms;
      return sum;
    };
    // What the slow part leaves of the product is told by that between both.
    const double along = square({{1., 0.}}), across = square({{0., 1.}}),
                 between = square({{M_SQRT1_2, M_SQRT1_2}});
    QuarterVibrations result;
    result.normal     = quarters(std::mem_fn(&ForceStatistics::normal));
    result.tangential = quarters(std::mem_fn(&ForceStatistics::tangential));
    result.parts =
      loudest_moment(along, across, between - .5 * (along + across));
    result.moment = moment(result.parts);
    return result;
  }
} // namespace squeal
