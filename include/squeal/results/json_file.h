// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_results_json_file_h
#define squeal_results_json_file_h

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace squeal
{
  /**
   * Writes @p json, indented, by way of write_atomically(). Texts that are no
   * UTF-8 are repaired: a file name must not end a run.
   *
   * A number that is NaN or infinite has no spelling in JSON and would turn
   * into null without a word: throws ComputationError with its place, such as
   * "/images/0/cracks/length_mm". What is missing on purpose is null.
   */
  void write_json(const std::string &path, const nlohmann::ordered_json &json);

  /** The same of keys in alphabetical order. */
  void write_json(const std::string &path, const nlohmann::json &json);
} // namespace squeal

#endif
