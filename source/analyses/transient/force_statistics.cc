// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/analyses/transient/force_statistics.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace squeal
{
  namespace
  {
    /** Takes @p m numbers of mean @p other, whose squares about it add up to
     * @p other_square, to @p n others. Differences of means, as those of mean
     * squares would drown small vibrations. */
    void
    join(const double n,
         const double m,
         const double other,
         const double other_square,
         double      &mean,
         double      &square)
    {
      const double change = other - mean;
      mean += change * m / (n + m);
      square += other_square + change * change * n * m / (n + m);
    }

    constexpr double no_quotient = std::numeric_limits<double>::quiet_NaN();

    double
    root_mean(const double square, const double n)
    {
      return n > 0. ? std::sqrt(square / n) : 0.;
    }
  } // namespace



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
    const double n = n_steps, m = other.n_steps;
    join(
      n, m, other.mean_normal, other.square_normal, mean_normal, square_normal);
    join(n,
         m,
         other.mean_tangential,
         other.square_tangential,
         mean_tangential,
         square_tangential);
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
} // namespace squeal
