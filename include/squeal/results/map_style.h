// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_results_map_style_h
#define squeal_results_map_style_h

#include <string>
#include <vector>

namespace squeal
{
  /** @name Colours of all maps, as commands of gnuplot */
  //@{
  /** Dark to light with even steps for the eye, told apart in grey too
   * (viridis: van der Walt and Smith, 2015). */
  std::string sequential_palette();
  /** Blue to orange over white, for values of either sign. */
  std::string two_sided_palette();
  /** One colour a kind, and a bar with their names beside it; "open" is the
   * grey of no value. */
  std::string palette_of_kinds(const std::vector<std::string> &kinds);
  /** Of places that have no value: "'#d0d0d0'". */
  std::string no_value_colour();
  //@}
} // namespace squeal

#endif
