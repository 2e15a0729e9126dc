// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/unknown_choice.h>
#include <squeal/tribology/statistics/association.h>
#include <squeal/tribology/statistics/shared_causes.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace squeal::tribology
{
  namespace
  {
    /** Part of the pad over which a concentration decays. */
    constexpr double decay_part = .15;

    /** Rings of cells from the rim on that have a term each. */
    constexpr std::size_t n_rings = 6;

    /** Where a cell lies, seen along the sliding direction. */
    struct Place
    {
      std::size_t n_across, n_along;
      std::size_t i, j; /**< across; from the leading edge on */

      /** Across and along, -1 to 1. */
      double
      across() const
      {
        return n_across > 1 ? 2. * i / (n_across - 1.) - 1. : 0.;
      }

      double
      along() const
      {
        return n_along > 1 ? 2. * j / (n_along - 1.) - 1. : 0.;
      }

      /** Cells between this one and the rim. */
      std::size_t
      rim() const
      {
        return std::min(std::min(i, n_across - 1 - i),
                        std::min(j, n_along - 1 - j));
      }

      double
      rim_decay() const
      {
        return std::exp(-double(rim()) /
                        (decay_part * std::min(n_across, n_along)));
      }

      double
      leading_decay() const
      {
        return std::exp(-double(j) / (decay_part * n_along));
      }
    };



    Place
    place(const std::size_t n_x,
          const std::size_t n_y,
          const std::size_t cell,
          const LeadingEdge leading)
    {
      const std::size_t column = cell % n_x, row = cell / n_x;
      switch (leading)
        {
        case LeadingEdge::lowest_y:
          return {n_x, n_y, column, row};
        case LeadingEdge::highest_y:
          return {n_x, n_y, column, n_y - 1 - row};
        case LeadingEdge::lowest_x:
          return {n_y, n_x, row, column};
        case LeadingEdge::highest_x:
          return {n_y, n_x, row, n_x - 1 - column};
        case LeadingEdge::automatic:
          break;
        }
      unknown_choice("leading edge");
    }



    using Term = std::function<double(const Place &)>;

    std::vector<Term>
    terms(const SharedCause cause)
    {
      switch (cause)
        {
        case SharedCause::position:
          return {[](const Place &p) { return p.along(); },
                  [](const Place &p) { return p.along() * p.along(); },
                  [](const Place &p) { return p.across(); },
                  [](const Place &p) { return p.across() * p.across(); },
                  [](const Place &p) { return p.along() * p.across(); }};
        case SharedCause::rim:
          {
            // any function of the distance near the rim, a decay deeper in
            std::vector<Term> rings;
            for (std::size_t ring = 0; ring < n_rings; ++ring)
              rings.emplace_back(
                [ring](const Place &p) { return p.rim() == ring; });
            rings.emplace_back([](const Place &p) { return p.rim_decay(); });
            return rings;
          }
        case SharedCause::edges:
          return {[](const Place &p) { return p.j == 0; },
                  [](const Place &p) { return p.j == 1; },
                  [](const Place &p) { return p.j == 2; },
                  [](const Place &p) { return p.leading_decay(); },
                  [](const Place &p) { return p.leading_decay() * p.across(); },
                  [](const Place &p) {
                    return p.leading_decay() * p.across() * p.across();
                  },
                  [](const Place &p) { return p.j == p.n_along - 1; },
                  [](const Place &p) { return p.i == 0; },
                  [](const Place &p) { return p.i == p.n_across - 1; }};
        }
      return {};
    }



    std::string
    words(const SharedCause cause)
    {
      switch (cause)
        {
        case SharedCause::position:
          return "position along and across the sliding direction";
        case SharedCause::rim:
          return "distance to the rim";
        case SharedCause::edges:
          return "leading, trailing and side edges";
        }
      return "";
    }



    /** The known values less their mean over their standard deviation; 0 for a
     * map that is the same everywhere. */
    Eigen::VectorXd
    standardised(const GridMap &map)
    {
      double n = 0., sum = 0., squares = 0.;
      for (const double v : map.values)
        if (std::isfinite(v))
          {
            n += 1.;
            sum += v;
          }
      for (const double v : map.values)
        if (std::isfinite(v))
          squares += (v - sum / n) * (v - sum / n);
      const double    deviation = n > 0. ? std::sqrt(squares / n) : 0.;
      Eigen::VectorXd result(map.size());
      for (std::size_t k = 0; k < map.size(); ++k)
        result(k) = !std::isfinite(map.values[k]) ? NAN
                    : deviation > 1e-12 * std::abs(sum / n)
                      ? (map.values[k] - sum / n) / deviation
                      : 0.;
      return result;
    }
  } // namespace



  SharedCauses
  shared_causes(const std::size_t                 n_x,
                const std::size_t                 n_y,
                const std::vector<SharedCause>   &choice,
                const LeadingEdge                 leading_edge,
                const std::vector<MeasuredCause> &measured)
  {
    SharedCauses      causes;
    const std::size_t n                  = n_x * n_y;
    causes.leading_edge                  = leading_edge;
    std::vector<Eigen::VectorXd> columns = {Eigen::VectorXd::Ones(n)};
    for (const SharedCause cause : choice)
      {
        causes.names.push_back(words(cause));
        for (const Term &term : terms(cause))
          {
            columns.emplace_back(n);
            for (std::size_t cell = 0; cell < n; ++cell)
              columns.back()(cell) = term(place(n_x, n_y, cell, leading_edge));
          }
      }
    for (const MeasuredCause &cause : measured)
      {
        causes.names.push_back(cause.name);
        const Eigen::VectorXd map = standardised(cause.map);
        columns.push_back(map);
        columns.push_back(map.array().square());
      }
    causes.values.resize(n, columns.size());
    for (std::size_t c = 0; c < columns.size(); ++c)
      causes.values.col(c) = columns[c];
    return causes;
  }



  ReferenceLinks
  reference_links(const GridMap &map, const LeadingEdge leading_edge)
  {
    GridMap leading{map.n_x, map.n_y, {}}, rim = leading;
    for (std::size_t cell = 0; cell < map.size(); ++cell)
      {
        const Place p = place(map.n_x, map.n_y, cell, leading_edge);
        leading.values.push_back(p.leading_decay());
        rim.values.push_back(p.rim_decay());
      }
    const auto a = common_values(leading, map), b = common_values(rim, map);
    return {pearson(a[0], a[1]), pearson(b[0], b[1]), leading_edge};
  }
} // namespace squeal::tribology
