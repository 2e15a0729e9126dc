// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/number_text.h>
#include <squeal/base/unknown_choice.h>
#include <squeal/cycle/cycle_search.h>

#include <algorithm>
#include <cmath>

namespace squeal
{
  namespace
  {
    /** The rms of a force whose harmonics have the differences of those of @p a
     * and @p b, as far as both go. */
    double
    rms_of_difference(const std::vector<double> &a,
                      const std::vector<double> &b)
    {
      double sum = 0.;
      for (std::size_t k = 0; k < std::min(a.size(), b.size()); ++k)
        sum += .5 * (a[k] - b[k]) * (a[k] - b[k]);
      return std::sqrt(sum);
    }
  } // namespace



  double
  error_by_steps(const double with_all, const double with_half)
  {
    return 2. * std::abs(with_all - with_half);
  }

  std::string
  with_error(const double value, const double error)
  {
    const double shown  = std::max(error, 1e-12 * std::abs(value));
    const int    digits = std::max(
      3, 1 + static_cast<int>(std::ceil(std::log10(std::abs(value) / shown))));
    return rounded_text(value, std::min(digits, 8)) + " +- " +
           rounded_text(error, 2);
  }

  double
  CycleResult::frequency_error() const
  {
    const double from_shift =
      std::abs(multipliers.trivial - 1.) / std::max(motion.orbit.n_steps(), 1u);
    return std::max(
      {error_by_steps(figures.frequency, coarse_figures.frequency),
       motion.left_open.period * figures.frequency,
       from_shift * figures.frequency});
  }

  double
  CycleResult::rms_normal_error() const
  {
    return std::max(
      {force_error(&ForceFigures::rms_normal),
       error_by_steps(rms_of_difference(figures.normal_harmonics,
                                        coarse_forces().normal_harmonics),
                      0.),
       motion.left_open.motion * figures.rms_normal});
  }

  double
  CycleResult::force_error(double ForceFigures::*number) const
  {
    return error_by_steps(figures.*number, coarse_forces().*number);
  }

  const ForceFigures &
  CycleResult::coarse_forces() const
  {
    return coarse_figures.pairs.empty() ? coarse_figures
                                        : coarse_figures.pairs[figures.loudest];
  }

  CycleStatus
  CycleResult::found() const
  {
    return coarse.status == CycleStatus::converged ? motion.status
                                                   : coarse.status;
  }

  std::string
  CycleResult::status() const
  {
    return cycle_status_text(found());
  }

  std::string
  cycle_status_text(const CycleStatus status)
  {
    switch (status)
      {
      case CycleStatus::converged:
        return "periodic";
      case CycleStatus::not_converged:
        return "not converged";
      case CycleStatus::steady_sliding:
        return "steady sliding";
      case CycleStatus::no_period:
        return "no period";
      case CycleStatus::aperiodic:
        return "aperiodic";
      }
    unknown_choice("status of a cycle");
  }

  bool
  CycleResult::may_settle() const
  {
    return !has_converged() && broken_off.empty() && run.lasts &&
           coarse.status != CycleStatus::aperiodic &&
           coarse.status != CycleStatus::steady_sliding;
  }
} // namespace squeal
