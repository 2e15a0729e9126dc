// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_statistics_quantity_text_h
#define squeal_tribology_statistics_quantity_text_h

#include <string>

namespace squeal::tribology
{
  /** Name and unit of the quantity that a column of a table holds, as a reader
   * writes them: of `damage_m5_per_s` "damage (slope 5)" and "1/s". */
  struct QuantityText
  {
    explicit QuantityText(const std::string &column);

    /** "damage (slope 5) in 1/s"; the name alone without a unit. */
    std::string with_unit() const;

    std::string name, unit;
  };
} // namespace squeal::tribology

#endif
