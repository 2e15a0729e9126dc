// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_parameters_number_access_h
#define squeal_parameters_number_access_h

#include <squeal/parameters/parameters.h>

#include <map>
#include <string>
#include <vector>

namespace squeal
{
  /** with_value() for several numbers at once, of which single ones may be no
   * valid scene: a pad and its support that move together. */
  Parameters with_values(const Parameters               &parameters,
                         const std::vector<std::string> &paths,
                         const std::vector<double>      &values);

  /** What the entries of numbers are written as when these have other
   * @p values: path and text, of a list all of its components. Throws
   * InputError as get_number() does. */
  std::map<std::string, std::string> changed_entries(
    const Parameters               &parameters,
    const std::vector<std::string> &paths,
    const std::vector<double>      &values);
} // namespace squeal

#endif
