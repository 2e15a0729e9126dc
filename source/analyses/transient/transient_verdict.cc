// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/analyses/transient/transient_verdict.h>
#include <squeal/transient/growth_rule.h>

#include <algorithm>
#include <cmath>

namespace squeal
{
  namespace
  {
    /** "860.2 +- 1082 1/s": of a fit, whether it counts or not. */
    std::string
    rate_text(const double rate, const GrowthFit &fit)
    {
      return rounded_text(rate, 4) + " +- " + rounded_text(fit.rate_ci, 2) +
             " 1/s";
    }

    /** What a vibration that stays is: it may be even and still not repeat
     * itself. */
    std::string
    kind_of_cycle(const TransientFigures &f)
    {
      return f.beyond_samples > 0. ? "sustained vibration"
             : f.repetition < least_repetition
               ? "sustained vibration without a period"
               : "limit cycle";
    }

    /** How it is related to steady sliding about which nothing that is known
     * grows. */
    std::string
    beside(const TransientFigures &f)
    {
      return f.has_unseen_motions
               ? "stands beside it (unless a motion above the cut-off grows)"
               : "stands beside it";
    }
  } // namespace



  LinearizedMotion
  motions_of_run(const LinearizedMotion    &linear,
                 const GrowthOutside       &growth,
                 const TransientParameters &t)
  {
    LinearizedMotion result;
    result.lambda = linear.lambda;
    if (t.integrator == TransientParameters::Integrator::reduced)
      return result;
    for (const MotionOutside &m : growth.motions)
      result.lambda[m.index] = m.of_bodies;
    return result;
  }

  GrowthOutside
  growth_of_run(const GrowthOutside &growth, const TransientParameters &t)
  {
    GrowthOutside result = growth;
    if (t.integrator != TransientParameters::Integrator::reduced)
      result.motions.erase(
        std::remove_if(result.motions.begin(),
                       result.motions.end(),
                       [](const MotionOutside &m) {
                         return m.owner == MotionOutside::Owner::reduction;
                       }),
        result.motions.end());
    return result;
  }



  std::string
  reason_for_no_cycle(const TransientFigures &f)
  {
    if (nothing_vibrates(f))
      return "nothing vibrates";
    if (f.dies_out)
      return "the vibration dies out";
    return "the vibration is uneven, " + rounded_text(f.least_rms, 3) + " to " +
           rounded_text(f.most_rms, 3) + " N rms of the " +
           f.loudest.force_name + of_judged(f.loudest) +
           " in the quarters of the second half of the run";
  }



  std::string
  limit_cycle_text(const TransientFigures &f)
  {
    if (f.has_limit_cycle && f.beyond_samples > 0.)
      return "a frequency that its samples do not tell, as " +
             (f.is_beyond_in_steps
                ? "the force vibrates at " + rounded_text(f.beyond_samples, 5) +
                    " Hz in the steps"
                : "a motion at " + rounded_text(f.beyond_samples, 5) +
                    " Hz grows");
    if (f.has_limit_cycle)
      return rounded_text(f.frequency, 5) +
             (std::isfinite(f.frequency_ci)
                ? " +- " + rounded_text(f.frequency_ci, 2) + " Hz"
                : " Hz, in a run too short for an interval") +
             (f.largest_line > 1.5 * f.frequency
                ? ", largest line at " + rounded_text(f.largest_line, 5) + " Hz"
                : "") +
             ", repeats itself to " + rounded_text(f.repetition, 3) +
             (f.loudest.is_by_moment()
                ? ", of the " + f.loudest.force_name + of_judged(f.loudest) +
                    ": in their sum it cancels"
              : f.loudest.force == JudgedForce::node
                ? ", of the " + f.loudest.force_name + of_judged(f.loudest) +
                    ": in the sum over the nodes and in both moments it cancels"
              : f.loudest.force == JudgedForce::tangential
                ? ", of the tangential force" + of_judged(f.loudest) +
                    (f.most_rms_of_sum > least_vibration * f.mean_normal
                       ? ": the normal force vibrates by " +
                           rounded_text(f.most_rms_of_sum, 2) + " N rms only"
                       : ": the normal force is steady")
              : f.loudest.name.empty()
                ? ""
                : ", of the normal force" + of_judged(f.loudest));
    return "none: " + reason_for_no_cycle(f);
  }



  std::string
  text_of_moment(const TransientFigures &f)
  {
    if (f.loudest.force == JudgedForce::node)
      return "the " + f.loudest.force_name + of_judged(f.loudest) +
             " vibrates by up to " + rounded_text(f.most_rms, 3) +
             " N rms, the sum over all nodes by up to " +
             rounded_text(f.most_rms_of_sum, 3) +
             " N, and both moments are as steady: rms, lines, repetition and "
             "limit cycle are those of the node, and the phase is left empty";
    if (!f.loudest.is_by_moment())
      return "";
    return "the " + f.loudest.force_name + of_judged(f.loudest) +
           " vibrates by up to " + rounded_text(f.most_rms, 3) +
           " N rms over the radius of gyration of the face, their sum by up "
           "to " +
           rounded_text(f.most_rms_of_sum, 3) +
           " N: rms, lines, repetition and limit cycle are those of the "
           "former, and the phase is left empty";
  }



  std::string
  text_of_sampling(const double frequency,
                   const double interval,
                   const bool   is_in_steps)
  {
    return (is_in_steps ? "the force vibrates most, in the steps, at "
                        : "the fastest growth about steady sliding is that of "
                          "a motion at ") +
           rounded_text(frequency, 5) +
           " Hz, and 'Transient/Sample interval' = " +
           rounded_text(interval, 3) + " s tells no line above " +
           rounded_text(highest_line(interval), 5) +
           " Hz: lines, repetition and phase are left empty, and neither "
           "sound nor spectrum is written";
  }



  namespace
  {
    /** In the window of the fit. */
    double
    periods_of(const BranchResult &b)
    {
      return b.frequency * (b.fit.end - b.fit.start);
    }

    bool
    is_too_short(const BranchResult &b)
    {
      return periods_of(b) < fewest_periods;
    }
  } // namespace

  std::string
  reason_for_no_rate(const TransientFigures &f)
  {
    if (f.leading < 0)
      return "not fitted: no pair in the band";
    const GrowthFit &fit = f.branches[f.leading].fit;
    if (!(fit.end > fit.start))
      return "not fitted: the leading pair has no linear phase of its own";
    if (is_too_short(f.branches[f.leading]))
      return "not fitted: the linear phase leaves " +
             rounded_text(periods_of(f.branches[f.leading]), 2) +
             " periods of the leading pair, and a rate takes at least " +
             rounded_text(fewest_periods, 1);
    return "left out: a fit of " + rate_text(fit.rate, fit) +
           " tells no rate of the leading pair";
  }



  std::string
  growth_text(const TransientFigures &f)
  {
    if (f.leading < 0 || !f.branches[f.leading].fit.is_valid)
      return "";
    const BranchResult &b = f.branches[f.leading];
    return (b.fit.rate > 0. ? "grows by " : "decays by ") +
           rate_text(std::abs(b.fit.rate), b.fit) + " at " +
           rounded_text(b.fit.frequency, 5) + " Hz";
  }



  std::string
  left_out_text(const TransientFigures &f)
  {
    unsigned int n = 0;
    std::string  which;
    for (const BranchResult &b : f.branches)
      if (!b.fit.is_valid && b.fit.end > b.fit.start)
        {
          ++n;
          which +=
            (which.empty() ? "" : "; ") + rounded_text(b.frequency, 5) + " Hz";
        }
    return n == 0 ? ""
                  : "growth rates of " + std::to_string(n) + " of " +
                      std::to_string(f.branches.size()) +
                      " pairs are left out, whose amplitudes are traces of "
                      "other motions (another frequency, or an interval "
                      "wider than half of the rate) or last for less than " +
                      rounded_text(fewest_periods, 1) + " periods: " + which;
  }



  std::string
  explained_verdict(const TransientFigures &f, const TriggerOutcome &trigger)
  {
    if (f.verdict == "unstable")
      return f.verdict +
             (f.vibrates_by_reduction ? "; " + f.growing_outside : "");
    const std::string about =
      (f.growing_outside.empty()
         ? f.verdict + " about steady sliding"
         : f.verdict + " in the band; " + f.growing_outside);
    if (trigger.text == "squeal after the trigger")
      return about + "; squeals after the trigger: a " +
             (f.has_limit_cycle ? kind_of_cycle(f) : "vibration that lasts") +
             " " + beside(f);
    if (trigger.text == "squeal by itself")
      return about + "; squeals without the trigger";
    if (f.has_limit_cycle)
      return about + "; a " + kind_of_cycle(f) + " " + beside(f);
    return f.growing_outside.empty() ? f.verdict : about;
  }



  std::string
  transient_headline(const TransientFigures &f, const TriggerOutcome &trigger)
  {
    const std::string growth = growth_text(f);
    std::string       text =
      explained_verdict(f, trigger) + (growth.empty() ? "" : ", " + growth);
    if (f.has_limit_cycle) // which the verdict names where it is not unstable
      return text + (f.verdict == "unstable" ? ", " + kind_of_cycle(f) : "") +
             (f.beyond_samples > 0. ? " of " : " at ") + limit_cycle_text(f);
    text += "; no limit cycle: " + reason_for_no_cycle(f);
    return f.verdict == "unstable"
             ? text
             : text + "; normal force" + of_judged(f.loudest) + " " +
                 (f.min_normal < 1e-6 * f.mean_normal
                    ? "0"
                    : rounded_text(f.min_normal, 3)) +
                 " to " + rounded_text(f.max_normal, 3) + " N";
  }



  namespace
  {
    /** Whether the sliding turns round in the stretch of a row, or next to it,
     * so that its mean friction is of both directions. */
    bool
    turns_round(const Table &speeds, const std::size_t row)
    {
      const std::size_t first = row == 0 ? 0 : row - 1,
                        last  = std::min(row + 1, speeds.n_rows() - 1);
      return speeds.real(first, "speed_m_per_s") *
               speeds.real(last, "speed_m_per_s") <=
             0.;
    }
  } // namespace



  std::string
  least_friction_text(const Table &speeds)
  {
    const auto friction = [&speeds](const std::size_t i) {
      return std::abs(speeds.real(i, "macroscopic_friction"));
    };
    std::size_t least = speeds.n_rows();
    for (std::size_t i = 0; i < speeds.n_rows(); ++i)
      if (!speeds.is_missing(i, "macroscopic_friction") &&
          !turns_round(speeds, i) &&
          (least == speeds.n_rows() || friction(i) < friction(least)))
        least = i;
    if (least == speeds.n_rows())
      return "";
    return "least macroscopic friction " + rounded_text(friction(least), 3) +
           ", at " + rounded_text(speeds.real(least, "speed_m_per_s"), 3) +
           " m/s";
  }



  bool
  squeals(const TransientFigures &f, const TriggerOutcome &trigger)
  {
    return !f.vibrates_by_reduction &&
           (trigger.text.rfind("squeal", 0) == 0 || f.has_limit_cycle);
  }
} // namespace squeal
