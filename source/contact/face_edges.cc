// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/contact/contact_resultant.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace squeal
{
  namespace
  {
    using Vector = dealii::Tensor<1, 3>;

    /** Cosine between the sliding and the outward normal of an edge within the
     * face from which on the edge lies along the sliding: a little more than 45
     * degrees, so that of a square that slides along its diagonal both edges in
     * front count. */
    constexpr double least_cosine = 0.7;

    /** Of the spacing of points without pieces between them: how far those of
     * an outermost row may be from the outermost one, along the sliding. */
    constexpr double row_width = 0.25;

    /** An edge of a piece that no other piece has. */
    struct BoundaryEdge
    {
      unsigned int a, b;
      Vector       inward; /**< from its middle to that of the piece */
    };

    std::vector<BoundaryEdge>
    boundary_edges(const ContactGeometry &g)
    {
      std::map<std::pair<unsigned int, unsigned int>, std::vector<BoundaryEdge>>
        edges;
      for (const auto &quad : g.quads)
        {
          Vector middle;
          for (const unsigned int j : quad)
            middle += .25 * Vector(g.points[j]);
          for (unsigned int k = 0; k < 4; ++k)
            {
              const unsigned int a = quad[k], b = quad[(k + 1) % 4];
              const Vector       half =
                .5 * (Vector(g.points[a]) + Vector(g.points[b]));
              edges[std::minmax(a, b)].push_back({a, b, middle - half});
            }
        }
      std::vector<BoundaryEdge> result;
      for (const auto &[nodes, all] : edges)
        if (all.size() == 1)
          result.push_back(all[0]);
      return result;
    }

    /** Nodes of edges that the sliding times @p sense crosses inwards. */
    std::vector<bool>
    edges_crossed_inwards(const ContactGeometry &g, const double sense)
    {
      std::vector<bool> result(g.points.size(), false);
      for (const BoundaryEdge &edge : boundary_edges(g))
        {
          const Vector along  = g.points[edge.b] - g.points[edge.a],
                       inward = edge.inward - (edge.inward * along) /
                                                along.norm_square() * along,
                       sliding =
                         g.frames[edge.a].sliding + g.frames[edge.b].sliding;
          if (sense * (sliding * inward) >
              least_cosine * sliding.norm() * inward.norm())
            result[edge.a] = result[edge.b] = true;
        }
      return result;
    }

    /** Points of the outermost row where @p direction begins. */
    std::vector<bool>
    outermost_row(const ContactGeometry &g, const Vector &direction)
    {
      std::vector<double> along;
      for (const auto &p : g.points)
        along.push_back(direction * Vector(p));
      const double area = std::accumulate(g.areas.begin(), g.areas.end(), 0.);
      const double limit =
        *std::min_element(along.begin(), along.end()) +
        row_width * std::sqrt(area / static_cast<double>(along.size()));
      std::vector<bool> result;
      for (const double s : along)
        result.push_back(s <= limit);
      return result;
    }

    std::vector<bool>
    edge_of(const ContactGeometry &g, const double sense)
    {
      if (!slides_one_way(g))
        return std::vector<bool>(g.points.size(), false);
      const std::vector<bool> crossed = edges_crossed_inwards(g, sense);
      return std::find(crossed.begin(), crossed.end(), true) != crossed.end()
               ? crossed
               : outermost_row(g, sense * mean_frame(g).sliding);
    }
  } // namespace



  std::vector<bool>
  leading_edge(const ContactGeometry &g)
  {
    return edge_of(g, 1.);
  }

  std::vector<bool>
  trailing_edge(const ContactGeometry &g)
  {
    return edge_of(g, -1.);
  }
} // namespace squeal
