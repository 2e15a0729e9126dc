// SPDX-License-Identifier: LGPL-2.1-or-later

// The smallest change of a number that stops a squeal.

#include "stopping_change.h"

#include <squeal/eigen/direct_solver.h>
#include <squeal/eigen/unstable_pair.h>

#include <algorithm>
#include <cmath>

namespace squeal
{
  namespace
  {
    /** Changes are looked at from this share on, each so much larger. */
    constexpr double first_change = 0.005, growth = 1.25;
    /** A pair of another frequency than this, relative, is another pair. */
    constexpr double same_frequency = 0.03;
    /** What is added to the smallest change that stabilises, so that it does
     * not stand on the edge. */
    constexpr double margin_of_change = 1.1;
    void
    take_worse(WorstPair &worst, const GrowingPair &pair)
    {
      if (!worst || pair.sigma > worst->sigma)
        worst = pair;
    }

    /** The followed pair nearest to a frequency, or none where it is another
     * pair even if all its stiffness or mass goes on to @p share. */
    std::vector<FollowedPair>::const_iterator
    nearest_followed(const std::vector<FollowedPair> &followed,
                     const double                     frequency,
                     const double                     share)
    {
      auto   result = followed.end();
      double least  = 0.;
      for (auto p = followed.begin(); p != followed.end(); ++p)
        {
          const double reach =
            same_frequency +
            0.5 * std::abs(std::log((1. + share) / (1. + p->share)));
          const double distance = std::abs(frequency - p->frequency);
          if (distance <= reach * p->frequency &&
              (result == followed.end() || distance < least))
            {
              result = p;
              least  = distance;
            }
        }
      return result;
    }

    /** The worst pair that did not squeal before; those that did are followed
     * to @p share. */
    WorstPair
    newcomer(const std::vector<GrowingPair> &pairs,
             const double                    share,
             std::vector<FollowedPair>      &followed)
    {
      WorstPair  worst;
      const auto before = followed;
      for (const auto &p : pairs)
        if (const auto known = nearest_followed(before, p.frequency, share);
            known != before.end())
          followed[known - before.begin()] = {p.frequency, share};
        else
          take_worse(worst, p);
      return worst;
    }

    /** Enters in @p change the smallest share at which nothing squeals, between
     * @p low, where something does, and @p high, and a little more. */
    void
    locate(const ChangedScene &scene,
           const double        sign,
           double              low,
           double              high,
           const double        largest,
           StoppingChange     &change)
    {
      WorstPair  worst;
      const auto is_quiet = [&](const double share) {
        return scene
          .unstable(change.number, sign * share, change.followed, worst)
          .empty();
      };
      while (high - low > 1e-3 * high)
        {
          const double middle             = 0.5 * (low + high);
          (is_quiet(middle) ? high : low) = middle;
        }
      high = std::min(margin_of_change * high, largest);
      if (is_quiet(high))
        {
          change.share = sign * high;
          change.worst = worst;
        }
    }
  } // namespace



  ChangedScene::ChangedScene(const SweepModel &m,
                             const PeakPair   &p,
                             const double      largest)
    : model(m)
    , peak(p)
  {
    // As far as frequencies move with the whole stiffness or mass.
    const double most = 1. / std::sqrt(1. - largest);
    wide              = {m.band().lowest / most, m.band().highest * most};
  }

  std::vector<GrowingPair>
  ChangedScene::unstable(const unsigned int               number,
                         const double                     share,
                         const std::vector<FollowedPair> &followed,
                         WorstPair                       &worst) const
  {
    const ComplexPairs       pairs = solve(number, 1. + share);
    std::vector<GrowingPair> result;
    worst.reset();
    for (unsigned int i = 0; i < pairs.size(); ++i)
      {
        const GrowingPair pair{pairs.frequency(i), pairs.sigma(i)};
        if (!is_in_band(pair.frequency) &&
            nearest_followed(followed, pair.frequency, share) == followed.end())
          continue;
        take_worse(worst, pair);
        if (is_unstable(pairs, i))
          result.push_back(pair);
      }
    return result;
  }

  DirectAnswer
  ChangedScene::solve_directly(const StoppingChange &change) const
  {
    Band reach = model.band();
    for (const auto &[f, share] : change.followed)
      reach = {std::min(reach.lowest, f), std::max(reach.highest, f)};
    const ComplexPairs pairs =
      direct_pairs(
        model,
        place(change.number, 1. + change.share),
        model.grid().scene(peak.point, change.number, 1. + change.share),
        reach)
        .pairs;
    const double small = rounding();
    DirectAnswer result;
    result.rounding = small;
    for (unsigned int i = 0; i < pairs.size(); ++i)
      {
        const GrowingPair pair{pairs.frequency(i), pairs.sigma(i)};
        if (pair.frequency < 0.)
          continue;
        if (is_in_band(pair.frequency) ||
            nearest_followed(change.followed, pair.frequency, change.share) !=
              change.followed.end())
          take_worse(result.worst, pair);
        else if (pair.sigma > small)
          take_worse(result.outside, pair);
      }
    return result;
  }

  bool
  ChangedScene::is_in_band(const double frequency) const
  {
    return frequency >= model.band().lowest &&
           frequency <= model.band().highest;
  }

  double
  ChangedScene::rounding() const
  {
    return growth_as_good_as_zero * model.band().highest;
  }

  SweepPoint
  ChangedScene::place(const unsigned int number, const double factor) const
  {
    // An axis of a single entry moves the point, so that the basis of the right
    // cell is used; other numbers leave it where it is.
    const SweepGrid &grid  = model.grid();
    SweepPoint       point = peak.point;
    for (unsigned int a = 0, first = 0; a < grid.n_axes(); ++a)
      {
        const std::size_t n = grid.axis(a).entries.size();
        if (number == first && n == 1)
          point[a] = grid.is_logarithmic(a) ? point[a] + std::log10(factor)
                                            : point[a] * factor;
        first += n;
        point[a] = std::min(std::max(point[a], grid.lower(a)), grid.upper(a));
      }
    return point;
  }

  ComplexPairs
  ChangedScene::solve(const unsigned int number, const double factor) const
  {
    return solve_point_in_cell(model.reduced(),
                               place(number, factor),
                               model.system().coefficients(model.grid().scene(
                                 peak.point, number, factor)),
                               wide);
  }



  StoppingChange
  smallest_change(const ChangedScene &scene,
                  const Influence    &influence,
                  const double        largest,
                  const double        sign)
  {
    StoppingChange change;
    change.number = influence.number;
    change.entry  = influence.entry;
    change.value  = influence.value;
    WorstPair                 worst;
    std::vector<FollowedPair> followed;
    for (const auto &p : scene.unstable(change.number, 0., {}, worst))
      followed.push_back({p.frequency, 0.});
    double before = 0.;
    for (double share = first_change;; share *= growth)
      {
        const bool is_last = share >= largest;
        share              = std::min(share, largest);
        const auto pairs =
          scene.unstable(change.number, sign * share, followed, worst);
        const bool was_stopped = change.share != 0.;
        if (!was_stopped && pairs.empty())
          {
            change.followed = followed;
            locate(scene, sign, before, share, largest, change);
          }
        const WorstPair other = newcomer(pairs, sign * share, followed);
        if (other &&
            (!change.tuned_in || other->sigma > change.tuned_in->sigma))
          {
            change.tuned_in    = other;
            change.tuned_in_at = sign * share;
          }
        change.up_to = sign * share;
        if (is_last || (was_stopped && !pairs.empty()))
          return change;
        before = share;
      }
  }
} // namespace squeal
