// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_setup_feature_columns_h
#define squeal_tribology_setup_feature_columns_h

#include <squeal/results/table.h>
#include <squeal/tribology/setup/damage_parameters.h>

#include <string>
#include <vector>

namespace squeal::tribology
{
  /** Mean direction of cracks against the sliding direction: what stands for
   * their angle, and like it is against that direction. */
  inline constexpr const char *along_sliding_column = "crack_along_sliding";

  /** Whether a value is the mean over the length of the cracks of a cell. */
  bool is_mean_along_cracks(const std::string &column);

  /** The features that a correlation takes from a table: those of 'Features',
   * else all columns that are no text, no place and no covariate. Throws
   * InputError where the angle of cracks is named, which is no number. */
  std::vector<std::string> feature_columns(
    const Table                 &table,
    const CorrelationParameters &parameters);

  /** Throws InputError "@p file:line: ..." for the first value of a column of
   * @p table that is no finite number. Values may be missing. */
  void require_finite_numbers(const Table       &table,
                              const std::string &column,
                              const std::string &file);

  /** The columns of a table of features that hold texts alone (remarks) and are
   * neither features nor covariates. Throws InputError where such a column
   * holds numbers beside texts: a mark for a missing value must not take a
   * feature out. */
  std::vector<std::string> columns_of_texts(
    const Table                 &table,
    const CorrelationParameters &parameters,
    const std::string           &file);
} // namespace squeal::tribology

#endif
