// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/number_text.h>
#include <squeal/parameters/choices.h>
#include <squeal/parameters/text.h>
#include <squeal/tribology/driver/damage_figures.h>

#include <algorithm>
#include <cmath>

namespace squeal::tribology
{
  namespace
  {
    /** Of the largest damage, by which the others may be lower where no place
     * has the most. */
    constexpr double alike = 0.005;

    double
    largest(const Table &table, const std::string &column)
    {
      double value = NAN;
      for (const double v : table.reals(column))
        if (!(v <= value))
          value = v;
      return value;
    }



    constexpr double least_shown = 1e-3;

    std::string
    percent_text(const double share)
    {
      return rounded_text(100. * std::max(share, least_shown), 2) + " %";
    }

    /** The relative standard error @p share in percent, or that nobody knows. */
    std::string
    error_text(const double share)
    {
      return std::isnan(share) ? " (sampling error not known)"
                               : " +- " + percent_text(share);
    }

    std::string
    why_no_damage(const Table &table, const FatigueParameters &fatigue)
    {
      using MeanStress   = FatigueParameters::MeanStress;
      const double range = largest(table, "largest_range_pa");
      if (!(range > 0.))
        return "the contact forces do not vary";
      const std::string up_to =
        "with ranges of up to " + rounded_text(1e-6 * range, 3) + " MPa ";
      if (fatigue.quantity == FatigueParameters::Quantity::pressure &&
          (fatigue.mean_stress == MeanStress::swt ||
           fatigue.mean_stress == MeanStress::walker))
        return up_to +
               "all cycles of the pressure are compressive, in which '" +
               choice_name(fatigue.mean_stress) +
               "' sees no damage: take another 'Mean stress'";
      return up_to + "no cycle counts" +
             (fatigue.endurance_limit > 0.
                ? ": the largest stays below 'Endurance limit' = " +
                    rounded_text(1e-6 * fatigue.endurance_limit, 3) + " MPa"
                : " by 'Mean stress = " + choice_name(fatigue.mean_stress) +
                    "'");
    }
  } // namespace



  RunRecord::Pairs
  damage_figures(const DamageStudy         &study,
                 const Table               &table,
                 const std::vector<double> &exponents)
  {
    const HistoryDamage &damage = study.damage;
    const std::string    slope  = slope_name(exponents.back());
    return {
      {"nodes", std::to_string(study.grid.n_nodes())},
      {"samples", std::to_string(damage.samples)},
      {"largest pressure in MPa",
       rounded_text(1e-6 * largest(table, "peak_pressure_pa"), 4) +
         (std::isnan(damage.least_peak)
            ? ""
            : ", " + rounded_text(1e-6 * damage.least_peak, 4) +
                " in the calmest quarter of the history")},
      {"largest damage per second, " + slope,
       rounded_text(largest(table, "damage_" + slope + "_per_s"), 4) +
         error_text(damage.nodes[damage.worst_node(exponents.size() - 1)]
                      .sampling_error.back())},
      {"sampling error of the mean damage, " + slope,
       std::isnan(damage.sampling_error.back())
         ? "not known: too few samples"
         : percent_text(damage.sampling_error.back())},
      {"part of the mean damage lost between samples, " +
         slope_name(*std::max_element(exponents.begin(), exponents.end())),
       PeakLoss::figure(damage.lost)},
      {"points kept by a counter", std::to_string(damage.deepest)}};
  }



  std::string
  damage_headline(const DamageStudy       &study,
                  const Table             &table,
                  const Table             &sums,
                  const FatigueParameters &fatigue)
  {
    const std::string column =
      "damage_" + slope_name(fatigue.exponents.front()) + "_per_s";
    const std::vector<double> damage = table.reals(column);
    const std::size_t         worst  = study.damage.worst_node();
    const std::string        &pair   = study.reader.layout().pair;
    const std::string face = pair.empty() ? "the face" : "the face of " + pair;
    if (!(damage[worst] > 0.))
      return "no damage on " + face + ": " + why_no_damage(table, fatigue);
    const double      error = study.damage.sampling_error.front();
    const std::string slope =
      " (slope " + slope_name(fatigue.exponents.front()) + ")" +
      (fatigue.constants.empty() ? ", an index" : "") +
      (std::isnan(error) ? ""
                         : std::string("; error of the mean: ") +
                             (error < least_shown ? "below " : "") +
                             percent_text(error) + " (sampling)");
    const double least = *std::min_element(damage.begin(), damage.end());
    if (least >= (1. - alike) * damage[worst])
      return "the same damage all over " + face + slope;
    const auto   place = study.grid.place(worst);
    const double along = study.grid.share_of_way(worst);
    return "most damage " +
           std::string(!std::isfinite(along) ? "at one place"
                       : along < 0.25        ? "near the leading edge"
                       : along <= 0.75       ? "in the middle"
                                             : "near the trailing edge") +
           " of " + face + ", at x = " + rounded_text(1e3 * place[0], 3) +
           " mm, y = " + rounded_text(1e3 * place[1], 3) + " mm: " +
           rounded_text(damage[worst] / sums.real(0, "mean_" + column), 3) +
           " times the mean of the face" + slope;
  }



  std::string
  ratios_to_silent(const Table               &sums,
                   const std::vector<double> &exponents,
                   RunRecord::Pairs          &figures)
  {
    std::vector<std::string> ratios;
    for (const double m : exponents)
      {
        const std::string mean   = "mean_damage_" + slope_name(m);
        const double      damage = sums.real(0, mean + "_per_s"),
                     quiet       = sums.real(1, mean + "_per_s");
        std::string ratio        = "infinitely many";
        if (quiet > 0.)
          {
            const auto share = [&](const std::size_t i, const double of) {
              return of > 0. ? sums.real(i, mean + "_error_per_s") / of : 0.;
            };
            const double error = std::hypot(share(0, damage), share(1, quiet));
            ratio              = rounded_text(damage / quiet, 3) +
                    (std::isnan(error) ? "" : error_text(error));
          }
        ratios.push_back(ratio + " (slope " + slope_name(m) + ")");
        figures.emplace_back("squealing over silent, " + slope_name(m), ratio);
      }
    return prm::join(ratios, ", ");
  }
} // namespace squeal::tribology
