// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/analyses/transient/force_statistics.h>
#include <squeal/base/unknown_choice.h>
#include <squeal/base/worst_of.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace squeal
{
  namespace
  {
    /** Puts the values of @p other behind those of @p piece. Differences of
     * means, as those of mean squares would drown small vibrations. */
    void
    join(const SignalPiece &other, SignalPiece &piece)
    {
      const double n = piece.n, m = other.n, change = other.mean - piece.mean;
      piece.mean += change * m / (n + m);
      piece.square += other.square + change * change * n * m / (n + m);
      // The middles of the two are (n + m) / 2 values apart.
      piece.moment += other.moment + 0.5 * change * n * m;
      piece.n += m;
    }

    constexpr double no_quotient = std::numeric_limits<double>::quiet_NaN();

    double
    root_mean(const double square, const double n)
    {
      return n > 0. ? std::sqrt(square / n) : 0.;
    }
  } // namespace



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
                first  = of(JudgedForce::first_moment),
                second = of(JudgedForce::second_moment);
    join(other.normal(), pressing);
    join(other.tangential(), pulling);
    join(other.of(JudgedForce::first_moment), first);
    join(other.of(JudgedForce::second_moment), second);
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
    const double n = n_steps, m = other.n_steps;
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
    return root_mean(square_normal, n_steps);
  }

  double
  ForceStatistics::rms_tangential() const
  {
    return root_mean(square_tangential, n_steps);
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
  ForceStatistics::of(const JudgedForce force) const
  {
    switch (force)
      {
      case JudgedForce::normal:
        return normal();
      case JudgedForce::tangential:
        return tangential();
      case JudgedForce::first_moment:
        return {n_steps, mean_first, moment_first, square_first};
      case JudgedForce::second_moment:
        return {n_steps, mean_second, moment_second, square_second};
      }
    unknown_choice("judged force");
  }

  double
  ForceStatistics::rms(const JudgedForce force) const
  {
    return root_mean(of(force).square, n_steps);
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
      case JudgedForce::first_moment:
        return first_moment;
      case JudgedForce::second_moment:
        return second_moment;
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
    const auto quarters = [&](const JudgedForce force) {
      std::vector<SignalPiece> pieces;
      for (unsigned int k = first; k < end; ++k)
        pieces.push_back(stretches.at(k).of(force));
      return rms_beside_slow_part(pieces, 4);
    };
    return {quarters(JudgedForce::normal),
            quarters(JudgedForce::tangential),
            quarters(JudgedForce::first_moment),
            quarters(JudgedForce::second_moment)};
  }
} // namespace squeal
