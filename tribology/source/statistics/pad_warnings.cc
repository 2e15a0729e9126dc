// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/number_text.h>
#include <squeal/tribology/statistics/feature_rows.h>
#include <squeal/tribology/statistics/pad_tables.h>

#include <cmath>
#include <map>

namespace squeal::tribology
{
  std::vector<std::string>
  warnings_of_few_cells(const std::vector<PadLink> &links)
  {
    constexpr double                                           few = 20.;
    std::map<std::pair<std::size_t, std::string>, std::string> lines;
    for (const PadLink &l : links)
      {
        const ConditionalLink &c = l.test.conditional;
        const std::string      start =
          "pad " + std::to_string(l.pad + 1) + ", feature '" + l.feature +
          "': " + std::to_string(l.test.n_cells) + " cells are known";
        std::string text;
        if (!c.is_known && std::isfinite(l.test.r))
          text = start + ", too few beside " + std::to_string(c.n_taken) +
                 " terms of 'Shared causes' and 'Covariates': nothing can be "
                 "decided; show more of the pad or take out less";
        else if (c.is_known && c.n_effective < few)
          text = start + ", worth " + rounded_text(c.n_effective, 2) +
                 " independent ones: only strong links can be found";
        if (!text.empty())
          lines.emplace(std::pair(l.pad, l.feature), text);
      }
    std::vector<std::string> warnings;
    for (const auto &[key, text] : lines)
      warnings.push_back(text);
    return warnings;
  }



  std::vector<std::string>
  warnings_of_coarse_features(const std::vector<PadMaps>  &pads,
                              const CorrelationParameters &p)
  {
    std::vector<std::string> warnings;
    for (std::size_t i = 0; i < pads.size(); ++i)
      if (pads[i].coarseness > FeatureRows::coarse)
        warnings.push_back(
          "pad " + std::to_string(i + 1) + ": the cells of '" +
          p.feature_tables[i] + "' are " + rounded_text(pads[i].coarseness, 2) +
          " times as long as those of the nodes: each tells of the nodes next "
          "to its centre only; take finer 'Cells' of images");
    return warnings;
  }



  std::vector<std::string>
  warnings_of_assumed_edges(const std::vector<PadMaps>  &pads,
                            const CorrelationParameters &p)
  {
    std::vector<std::string> warnings;
    for (std::size_t i = 0; i < pads.size(); ++i)
      if (pads[i].is_edge_assumed)
        warnings.push_back(
          "pad " + std::to_string(i + 1) + ": '" + p.damage_tables[i] +
          "' has no columns sliding_x and sliding_y: the leading edge is taken "
          "for the one at the lowest y; 'Leading edge' names another one");
    return warnings;
  }
} // namespace squeal::tribology
