// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/number_text.h>
#include <squeal/tribology/damage/damage_table.h>
#include <squeal/tribology/damage/peak_loss.h>

#include <algorithm>
#include <cmath>

namespace squeal::tribology
{
  namespace
  {
    /** Share of the damage whose loss is said. */
    constexpr double worth_saying = 0.05;
    /** Share of the damage of unseen extrema, beyond which nothing is known of
     * what is lost. */
    constexpr double largest_unseen = 0.2;

    std::size_t
    largest_of(const std::vector<double> &exponents)
    {
      return std::max_element(exponents.begin(), exponents.end()) -
             exponents.begin();
    }



    CountingRules
    rules_of_one(CountingRules rules, const std::size_t number)
    {
      rules.curves = {rules.curves[number]};
      return rules;
    }
  } // namespace



  PeakLoss::PeakLoss(const FatigueParameters &fatigue,
                     const std::size_t        n_nodes)
    : number(largest_of(fatigue.exponents))
    , rules(rules_of_one(counting_rules(fatigue), number))
    , counters(n_nodes, DamageCounter(rules))
    , sharpeners(n_nodes, PeakSharpener(fatigue.exponents[number]))
  {
  }



  void
  PeakLoss::add(const std::size_t node,
                const double     *stresses,
                const std::size_t n)
  {
    values.clear();
    sharpeners[node].add(stresses, n, values);
    counters[node].add(values.data(), values.size());
  }



  std::size_t
  PeakLoss::exponent() const
  {
    return number;
  }



  LostDamage
  PeakLoss::finish(const std::vector<double> &damages,
                   const std::vector<double> &areas)
  {
    double sampled = 0., sharpened = 0., unseen = 0.;
    for (std::size_t k = 0; k < counters.size(); ++k)
      {
        values.clear();
        sharpeners[k].finish(values);
        counters[k].add(values.data(), values.size());
        counters[k].finish();
        const double all = areas[k] * counters[k].damages()[0];
        sampled += areas[k] * damages[k];
        sharpened += all;
        // 0 of an infinite damage is none.
        if (const double share = sharpeners[k].unseen_share(); share > 0.)
          unseen += share * all;
      }
    LostDamage lost;
    lost.is_known = !(unseen > largest_unseen * sharpened);
    // A mean stress beyond the strength is all damage.
    if (std::isinf(sharpened))
      lost.share = 1.;
    else if (sampled > 0. && sharpened > sampled)
      lost.share = 1. - sampled / sharpened;
    return lost;
  }



  std::string
  PeakLoss::figure(const LostDamage &lost)
  {
    if (!lost.is_known)
      return "not known: too few samples a pulse";
    return lost.share < 1e-3 ? "below 0.1 %"
                             : rounded_text(100. * lost.share, 2) + " %";
  }



  std::string
  PeakLoss::note(const LostDamage &lost, const double exponent)
  {
    if (!lost.is_known)
      return "the samples do not show the peaks of the cycles: more than a "
             "fifth of the mean damage of slope " +
             slope_name(exponent) +
             " comes from pulses of fewer than three samples, and it is not "
             "known how much is lost between them; record at least five "
             "samples while a contact is closed";
    if (!(lost.share > worth_saying))
      return "";
    // A sine with n samples a period loses m (pi/n)^2 / 6.
    const auto enough = static_cast<unsigned int>(
      std::ceil(M_PI * std::sqrt(exponent / (6. * worth_saying))));
    return "the samples miss the peaks of the cycles: about " +
           rounded_text(100. * lost.share, 2) +
           " % of the mean damage of slope " + slope_name(exponent) +
           " is lost between them; record more of them (a sine with " +
           std::to_string(enough) + " samples a period loses 5 %)";
  }
} // namespace squeal::tribology
