// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/unknown_choice.h>
#include <squeal/cycle/trigger_threshold.h>

#include <algorithm>

namespace squeal
{
  namespace
  {
    using Status = TriggerThreshold::Status;

    /** Of the smallest impulse tried at first: below it none is tried. */
    constexpr double smallest_share = 1e-6;

    MotionFate
    try_impulse(const FateOfImpulse &fate,
                const double         impulse,
                TriggerThreshold    &threshold)
    {
      threshold.trials.push_back({impulse, fate(impulse)});
      return threshold.trials.back().fate;
    }

    void
    bisect(const FateOfImpulse &fate,
           const double         tolerance,
           TriggerThreshold    &t)
    {
      t.status              = Status::bracketed;
      const double smallest = smallest_share * t.upper;
      while (t.upper - t.lower > tolerance * t.upper)
        if (t.upper < smallest)
          {
            t.status = Status::none_returns;
            return;
          }
        else
          switch (const double middle = t.middle();
                  try_impulse(fate, middle, t))
            {
            case MotionFate::returns:
              t.lower = middle;
              break;
            case MotionFate::squeals:
              t.upper = middle;
              break;
            case MotionFate::undecided:
              t.status = Status::undecided;
              return;
            }
    }

    unsigned int
    changes_along(std::vector<TriggerThreshold::Trial> trials)
    {
      std::sort(trials.begin(), trials.end(), [](const auto &a, const auto &b) {
        return a.impulse < b.impulse;
      });
      unsigned int n    = 0;
      MotionFate   last = MotionFate::returns;
      for (const auto &trial : trials)
        if (trial.fate != MotionFate::undecided && trial.fate != last)
          {
            ++n;
            last = trial.fate;
          }
      return n;
    }
  } // namespace



  std::string
  threshold_text(const Status status)
  {
    switch (status)
      {
      case Status::bracketed:
        return "threshold";
      case Status::undecided:
        return "threshold, undecided inside its bracket";
      case Status::no_squeal:
        return "no squeal at the largest impulse";
      case Status::undecided_at_largest:
        return "undecided at the largest impulse";
      case Status::none_returns:
        return "squeal at every impulse tried";
      case Status::not_there:
        return "another threshold with half the steps";
      }
    unknown_choice("status of a threshold");
  }



  TriggerThreshold
  find_threshold(const FateOfImpulse       &fate,
                 const std::vector<double> &ladder,
                 const double               tolerance)
  {
    TriggerThreshold t;
    const MotionFate largest = try_impulse(fate, ladder.back(), t);
    for (std::size_t i = 0; i + 1 < ladder.size(); ++i)
      try_impulse(fate, ladder[i], t);
    t.n_changes = changes_along(t.trials);
    t.upper     = ladder.back();
    for (const auto &trial : t.trials)
      if (trial.fate == MotionFate::squeals)
        t.upper = std::min(t.upper, trial.impulse);
    for (const auto &trial : t.trials)
      if (trial.fate == MotionFate::returns && trial.impulse < t.upper)
        t.lower = std::max(t.lower, trial.impulse);
    if (largest == MotionFate::squeals)
      bisect(fate, tolerance, t);
    else
      t.status = largest == MotionFate::returns ? Status::no_squeal
                                                : Status::undecided_at_largest;
    return t;
  }



  TriggerThreshold
  find_threshold_near(const FateOfImpulse    &fate,
                      const TriggerThreshold &near,
                      const double            tolerance)
  {
    TriggerThreshold t;
    t.n_changes  = near.n_changes;
    t.lower      = near.lower;
    t.upper      = near.upper;
    double width = near.upper - near.lower;
    // An end that is undecided is no end of a bracket.
    for (; try_impulse(fate, t.lower, t) != MotionFate::returns; width *= 2.)
      {
        if (t.trials.back().fate == MotionFate::squeals)
          t.upper = t.lower;
        t.lower -= width;
        if (!(t.lower > .5 * near.lower))
          {
            t.status = Status::not_there;
            return t;
          }
      }
    for (width = near.upper - near.lower;
         t.upper >= near.upper &&
         try_impulse(fate, t.upper, t) != MotionFate::squeals;
         width *= 2.)
      {
        if (t.trials.back().fate == MotionFate::returns)
          t.lower = t.upper;
        t.upper += width;
        if (!(t.upper < 2. * near.upper))
          {
            t.status = Status::not_there;
            return t;
          }
      }
    bisect(fate, tolerance, t);
    return t;
  }
} // namespace squeal
