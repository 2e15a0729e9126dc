// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/number_text.h>
#include <squeal/parameters/text.h>
#include <squeal/tribology/statistics/feature_rows.h>
#include <squeal/tribology/statistics/pad_tables.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace squeal::tribology
{
  namespace
  {
    /** Whose the reason is, and what is to be said of it. */
    using SubjectAndText = std::pair<std::string, std::string>;

    SubjectAndText
    reason_of_silence(const PadLink &l)
    {
      const std::string index   = "index '" + l.index + "'",
                        feature = "feature '" + l.feature + "'",
                        constant =
                          "it is the same in all cells: nothing can be decided",
                        explained =
                          "it is a combination of the terms of 'Shared causes' "
                          "and 'Covariates' that are taken out: nothing is "
                          "left to decide on; take out less";
      switch (l.test.conditional.silence)
        {
        case Silence::index_constant:
          return {index, constant};
        case Silence::feature_constant:
          return {feature, constant};
        case Silence::index_explained:
          return {index, explained};
        case Silence::feature_explained:
          return {feature, explained};
        case Silence::few_cells:
          break;
        }
      const std::size_t n       = l.test.n_cells,
                        n_taken = l.test.conditional.n_taken;
      const std::string known =
        counted(n, "cell") + (n == 1 ? " is" : " are") + " known, too few";
      return {
        feature,
        n_taken == 0
          ? known + ": nothing can be decided; show more of the pad"
          : known + " beside " + std::to_string(n_taken) +
              " terms of 'Shared causes' and 'Covariates': nothing can be "
              "decided; show more of the pad or take out less"};
    }



    /** Without a text where there is nothing to say. */
    SubjectAndText
    weakness_of(const PadLink &l)
    {
      constexpr double       few = 20.;
      const ConditionalLink &c   = l.test.conditional;
      if (!c.is_known)
        return reason_of_silence(l);
      if (c.n_effective < few)
        return {"feature '" + l.feature + "'",
                std::to_string(l.test.n_cells) + " cells are known, worth " +
                  rounded_text(c.n_effective, 2) +
                  " independent ones: only strong links can be found"};
      return {};
    }
  } // namespace



  std::vector<std::string>
  warnings_of_weak_links(const std::vector<PadLink> &links)
  {
    std::map<std::pair<std::size_t, std::string>, std::string> lines;
    for (const PadLink &l : links)
      if (const auto &[subject, text] = weakness_of(l); !text.empty())
        lines.emplace(std::pair(l.pad, subject),
                      "pad " + std::to_string(l.pad + 1) + ", " + subject +
                        ": " + text);
    std::vector<std::string> warnings;
    for (const auto &[key, text] : lines)
      warnings.push_back(text);
    return warnings;
  }



  std::vector<std::string>
  warnings_of_links_by_steps(const std::vector<PadLink>  &links,
                             const CorrelationParameters &p)
  {
    constexpr double most    = 0.5; // of the sum behind a link
    std::size_t      n_found = 0, n = 0;
    std::string      example;
    for (const PadLink &l : links)
      {
        const bool is_found = l.test.conditional.p <= p.level;
        n_found += is_found;
        if (!is_found || !(l.test.conditional.of_one_line > most))
          continue;
        if (++n == 1)
          example = "'" + l.index + "' with '" + l.feature + "' on pad " +
                    std::to_string(l.pad + 1) + ", " +
                    rounded_text(100. * l.test.conditional.of_one_line, 2) +
                    " %";
      }
    if (n == 0)
      return {};
    return {std::to_string(n) + " of " + std::to_string(n_found) +
            " links with a small p-value rest for the most part on one row or "
            "column of cells (" +
            example +
            "): a step that both maps have there is one event, and may be "
            "chance; give the pad by segments, or the step as a covariate"};
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
  warnings_of_assumed_places(const std::vector<PadMaps>  &pads,
                             const CorrelationParameters &p)
  {
    std::vector<std::string> warnings;
    for (std::size_t i = 0; i < pads.size(); ++i)
      if (pads[i].is_place_assumed)
        warnings.push_back(
          "pad " + std::to_string(i + 1) + ": the places of '" +
          p.feature_tables[i] + "' lie on the face of '" + p.damage_tables[i] +
          "' as they stand, and counted from its centre as well: they are "
          "taken as they stand, and every link is wrong if they count from "
          "the centre; then give the table a column 'image' with 'pad' in "
          "each row");
    return warnings;
  }



  std::vector<std::string>
  warnings_of_texts(const std::vector<PadMaps>  &pads,
                    const CorrelationParameters &p)
  {
    std::vector<std::string> warnings;
    for (std::size_t i = 0; i < pads.size(); ++i)
      if (!pads[i].texts.empty())
        warnings.push_back("pad " + std::to_string(i + 1) +
                           ": these columns of '" + p.feature_tables[i] +
                           "' hold no numbers and are no features: " +
                           prm::join(pads[i].texts, ", "));
    return warnings;
  }



  std::vector<std::string>
  warnings_of_doubled_rows(const std::vector<PadMaps>  &pads,
                           const CorrelationParameters &p)
  {
    std::vector<std::string> warnings;
    for (std::size_t i = 0; i < pads.size(); ++i)
      if (!pads[i].doubled_rows.empty())
        warnings.push_back("pad " + std::to_string(i + 1) + ": in '" +
                           p.feature_tables[i] + "' " + pads[i].doubled_rows +
                           ", stand at the place of an earlier one with other "
                           "values: their mean counts");
    return warnings;
  }



  std::vector<std::string>
  warnings_of_constant_covariates(const std::vector<PadMaps> &pads)
  {
    std::vector<std::string> warnings;
    for (std::size_t i = 0; i < pads.size(); ++i)
      if (!pads[i].constant_covariates.empty())
        warnings.push_back("pad " + std::to_string(i + 1) +
                           ": these covariates have one value in all cells and "
                           "take nothing out: " +
                           prm::join(pads[i].constant_covariates, ", "));
    return warnings;
  }



  std::vector<std::string>
  warnings_of_long_pads(const std::vector<PadMaps>  &pads,
                        const CorrelationParameters &p)
  {
    constexpr double         longest_face = 2.; // m, as of histories
    std::vector<std::string> warnings;
    for (std::size_t i = 0; i < pads.size(); ++i)
      {
        const Patch &face = pads[i].grid->face();
        const double length =
          std::max(face.x_max - face.x_min, face.y_max - face.y_min);
        if (length > longest_face)
          warnings.push_back(
            "pad " + std::to_string(i + 1) + ": the face of '" +
            p.damage_tables[i] + "' is " + rounded_text(length, 3) +
            " m long: if its places are in mm, give them in m");
      }
    return warnings;
  }



  std::vector<std::string>
  warnings_of_lacking_covariates(const std::vector<PadMaps> &pads)
  {
    std::vector<std::string> warnings;
    for (std::size_t i = 0; i < pads.size(); ++i)
      {
        std::size_t n_seen = 0, n_lacking = 0;
        for (std::size_t cell = 0; cell < pads[i].coverage.size(); ++cell)
          if (std::any_of(pads[i].features.begin(),
                          pads[i].features.end(),
                          [cell](const auto &feature) {
                            return std::isfinite(feature.second.values[cell]);
                          }))
            {
              ++n_seen;
              n_lacking += !pads[i].causes.values.row(cell).allFinite();
            }
        if (n_lacking > 0)
          warnings.push_back(
            "pad " + std::to_string(i + 1) +
            ": 'Covariates' are not known in " + std::to_string(n_lacking) +
            " of " + std::to_string(n_seen) +
            " cells that have features: the verdicts are of the other " +
            std::to_string(n_seen - n_lacking) +
            ", although 'cells' counts all with index and feature");
      }
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
