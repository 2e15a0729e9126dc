// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_analyses_operating_matrix_operating_condition_h
#define squeal_analyses_operating_matrix_operating_condition_h

#include <squeal/parameters/parameters.h>

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace squeal
{
  /** What one model is solved at, about a steady sliding of its own; what is
   * not given is that of the scene. */
  struct OperatingCondition
  {
    std::optional<double> pressure;    /**< of all loads that press, Pa */
    std::optional<double> speed;       /**< of all pairs that slide, m/s */
    std::optional<double> temperature; /**< of all tables, degrees Celsius */
    bool                  backward = false;
  };

  /** All of an analysis: directions, within them speeds, pressures and then
   * temperatures. */
  std::vector<OperatingCondition> operating_conditions(
    const OperatingMatrixParameters &parameters);

  /** "forward, 1e6 Pa, 100 degrees Celsius". */
  std::string text_of(const OperatingCondition &condition);

  /** @p parameters under a condition, with the moduli of the tables there and
   * at the reference frequency: the contact of steady sliding depends on them,
   * too. Throws InputError where a table does not cover it. */
  Parameters parameters_of(const Parameters         &parameters,
                           const OperatingCondition &condition);

  /** Numbers of the conditions of one pressure and one temperature: bodies and
   * loads are the same, which speed and direction do not change. */
  std::map<std::pair<std::optional<double>, std::optional<double>>, std::vector<std::size_t>> with_same_bodies(
    const std::vector<OperatingCondition> &all);
} // namespace squeal

#endif
