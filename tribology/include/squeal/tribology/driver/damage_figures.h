// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_driver_damage_figures_h
#define squeal_tribology_driver_damage_figures_h

#include <squeal/results/run_record.h>
#include <squeal/tribology/driver/damage_study.h>

#include <string>
#include <vector>

namespace squeal::tribology
{
  /** What the first screen says of the pair of @p study, whose damage.csv is
   * @p table: largest pressure and damage with their errors. */
  RunRecord::Pairs damage_figures(const DamageStudy         &study,
                                  const Table               &table,
                                  const std::vector<double> &exponents);

  /** Where the damage is largest and how large, in words. */
  std::string damage_headline(const DamageStudy       &study,
                              const Table             &table,
                              const Table             &sums,
                              const FatigueParameters &fatigue);

  /** Mean damage over that of the silent run, for each slope with its name;
   * the numbers alone are added to @p figures. */
  std::string ratios_to_silent(const Table               &sums,
                               const std::vector<double> &exponents,
                               RunRecord::Pairs          &figures);
} // namespace squeal::tribology

#endif
