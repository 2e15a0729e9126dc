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

    /** Known cells for each term of a measured cause, and its terms. */
    constexpr std::size_t cells_of_term = 15, least_terms = 2, most_terms = 8;

    /** Where a cell lies along one axis of the grid. */
    struct OnAxis
    {
      std::size_t n, k;          /**< cells; number of this one */
      double      before, after; /**< distances from the outermost cells */
      double      length;        /**< of all cells */

      /** The same seen from the other end. */
      OnAxis
      reversed() const
      {
        return {n, n - 1 - k, after, before, length};
      }

      /** -1 to 1. */
      double
      centred() const
      {
        return n > 1 ? (before - after) / (before + after) : 0.;
      }
    };

    OnAxis
    on_axis(const std::size_t          n,
            const std::size_t          k,
            const std::vector<double> &at,
            const double               spacing)
    {
      const double before = at.empty() ? double(k) : at[k] - at.front(),
                   after  = at.empty() ? double(n - 1 - k) : at.back() - at[k];
      return {n, k, before, after, n * spacing};
    }



    /** Where a cell lies, seen along the sliding direction. */
    struct Place
    {
      OnAxis across, along; /**< the latter from the leading edge on */

      /** Cells between this one and the rim. */
      std::size_t
      rim() const
      {
        return std::min(std::min(across.k, across.n - 1 - across.k),
                        std::min(along.k, along.n - 1 - along.k));
      }

      double
      rim_decay() const
      {
        const double distance = std::min(std::min(across.before, across.after),
                                         std::min(along.before, along.after));
        return std::exp(-distance /
                        (decay_part * std::min(across.length, along.length)));
      }

      double
      leading_decay() const
      {
        return std::exp(-along.before / (decay_part * along.length));
      }
    };



    Place
    place(const GridMap    &grid,
          const std::size_t cell,
          const LeadingEdge leading)
    {
      const auto   spacing = grid.spacing();
      const OnAxis column =
                     on_axis(grid.n_x, cell % grid.n_x, grid.xs, spacing[0]),
                   row =
                     on_axis(grid.n_y, cell / grid.n_x, grid.ys, spacing[1]);
      switch (leading)
        {
        case LeadingEdge::lowest_y:
          return {column, row};
        case LeadingEdge::highest_y:
          return {column, row.reversed()};
        case LeadingEdge::lowest_x:
          return {row, column};
        case LeadingEdge::highest_x:
          return {row, column.reversed()};
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
          return {[](const Place &p) { return p.along.centred(); },
                  [](const Place &p) {
                    return p.along.centred() * p.along.centred();
                  },
                  [](const Place &p) { return p.across.centred(); },
                  [](const Place &p) {
                    return p.across.centred() * p.across.centred();
                  },
                  [](const Place &p) {
                    return p.along.centred() * p.across.centred();
                  }};
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
          return {[](const Place &p) { return p.along.k == 0; },
                  [](const Place &p) { return p.along.k == 1; },
                  [](const Place &p) { return p.along.k == 2; },
                  [](const Place &p) { return p.leading_decay(); },
                  [](const Place &p) {
                    return p.leading_decay() * p.across.centred();
                  },
                  [](const Place &p) {
                    return p.leading_decay() * p.across.centred() *
                           p.across.centred();
                  },
                  [](const Place &p) { return p.along.k == p.along.n - 1; },
                  [](const Place &p) { return p.across.k == 0; },
                  [](const Place &p) { return p.across.k == p.across.n - 1; }};
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



    /** Of the known values of a map. */
    struct Spread
    {
      double mean = 0., deviation = 0.;

      bool
      is_none() const
      {
        return !(deviation > 1e-12 * std::abs(mean));
      }
    };

    Spread
    spread_of(const GridMap &map)
    {
      double n = 0., sum = 0., squares = 0.;
      for (const double v : map.values)
        if (std::isfinite(v))
          {
            n += 1.;
            sum += v;
          }
      if (n == 0.)
        return {};
      for (const double v : map.values)
        if (std::isfinite(v))
          squares += (v - sum / n) * (v - sum / n);
      return {sum / n, std::sqrt(squares / n)};
    }

    /** The known values less their mean over their standard deviation; 0 for a
     * map that is the same everywhere. */
    Eigen::VectorXd
    standardised(const GridMap &map)
    {
      const Spread    spread = spread_of(map);
      Eigen::VectorXd result(map.size());
      for (std::size_t k = 0; k < map.size(); ++k)
        result(k) = !std::isfinite(map.values[k]) ? NAN
                    : spread.is_none()
                      ? 0.
                      : (map.values[k] - spread.mean) / spread.deviation;
      return result;
    }



    /** A cubic spline of a standardised map, from which any smooth effect of it
     * is made; its knots are quantiles, so that a few extreme cells do not take
     * them all. NaN where the map is. */
    std::vector<Eigen::VectorXd>
    curves(const Eigen::VectorXd &map)
    {
      std::vector<double> known;
      for (const double v : map)
        if (std::isfinite(v))
          known.push_back(v);
      std::sort(known.begin(), known.end());
      const std::size_t n =
        std::clamp(known.size() / cells_of_term, least_terms, most_terms);
      std::vector<Eigen::VectorXd> columns;
      Eigen::ArrayXd               power = Eigen::ArrayXd::Ones(map.size());
      for (std::size_t k = 0; k < std::min<std::size_t>(n, 3); ++k)
        {
          power *= map.array();
          columns.emplace_back(power);
        }
      for (std::size_t knot = 4; knot <= n; ++knot)
        {
          const double at = known[(known.size() - 1) * (knot - 3) / (n - 2)];
          columns.push_back(map);
          for (double &v : columns.back())
            if (std::isfinite(v))
              v = std::pow(std::max(0., v - at), 3);
        }
      return columns;
    }
  } // namespace



  bool
  is_same_everywhere(const GridMap &map)
  {
    return spread_of(map).is_none();
  }

  SharedCauses
  shared_causes(const GridMap                    &grid,
                const std::vector<SharedCause>   &choice,
                const LeadingEdge                 leading_edge,
                const std::vector<MeasuredCause> &measured)
  {
    SharedCauses      causes;
    const std::size_t n                  = grid.n_x * grid.n_y;
    causes.leading_edge                  = leading_edge;
    std::vector<Eigen::VectorXd> columns = {Eigen::VectorXd::Ones(n)};
    for (const SharedCause cause : choice)
      {
        causes.names.push_back(words(cause));
        for (const Term &term : terms(cause))
          {
            columns.emplace_back(n);
            for (std::size_t cell = 0; cell < n; ++cell)
              columns.back()(cell) = term(place(grid, cell, leading_edge));
          }
      }
    for (const MeasuredCause &cause : measured)
      {
        causes.names.push_back(cause.name);
        for (Eigen::VectorXd &column : curves(standardised(cause.map)))
          columns.push_back(std::move(column));
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
        const Place p = place(map, cell, leading_edge);
        leading.values.push_back(p.leading_decay());
        rim.values.push_back(p.rim_decay());
      }
    const auto a = common_values(leading, map), b = common_values(rim, map);
    return {pearson(a[0], a[1]), pearson(b[0], b[1]), leading_edge};
  }
} // namespace squeal::tribology
