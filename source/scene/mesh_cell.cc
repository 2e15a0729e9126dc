// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/scene/mesh_cell.h>

#include <algorithm>

namespace squeal
{
  namespace
  {
    using dealii::Point;
    using dealii::Tensor;

    /** Gmsh's nodes of a hexahedron as nodes of CellNodes. Source: reference
     * manual, "Node ordering". */
    constexpr std::array<unsigned int, 27> node_of_gmsh{
      {0,  2,  8,  6,  18, 20, 26, 24, 1,  3,  9,  5,  11, 7,
       17, 15, 19, 21, 23, 25, 4,  10, 12, 14, 16, 22, 13}};

    /** Corners of the edge or face whose middle a node is; all 8 of the cell's
     * centre, itself of a corner. */
    std::vector<unsigned int>
    corners_round(const unsigned int node)
    {
      std::vector<unsigned int> corners{node};
      for (const unsigned int step : {1, 3, 9})
        if (node / step % 3 == 1)
          {
            std::vector<unsigned int> both;
            for (const unsigned int n : corners)
              both.insert(both.end(), {n - step, n + step});
            corners = both;
          }
      return corners;
    }

    /** Middles of the edges round a face or the cell. */
    std::vector<unsigned int>
    edges_round(const unsigned int node)
    {
      std::vector<unsigned int> edges;
      for (const unsigned int a : {1, 3, 9})
        if (node / a % 3 == 1)
          {
            std::vector<unsigned int> ends{node};
            for (const unsigned int b : {1, 3, 9})
              if (b != a && node / b % 3 == 1)
                {
                  std::vector<unsigned int> both;
                  for (const unsigned int n : ends)
                    both.insert(both.end(), {n - b, n + b});
                  ends = both;
                }
            edges.insert(edges.end(), ends.begin(), ends.end());
          }
      return edges;
    }

    Tensor<1, 3>
    sum_of(const CellNodes &x, const std::vector<unsigned int> &nodes)
    {
      Tensor<1, 3> sum;
      for (const unsigned int n : nodes)
        sum += x[n];
      return sum;
    }

    /** What 8 or 20 nodes make of a node that is not given: the mean of an
     * edge's ends; half the edges less a quarter of the corners elsewhere, a
     * quarter of both in the centre. */
    Point<3>
    completed(const CellNodes &x, const unsigned int node)
    {
      const auto corners = corners_round(node);
      if (corners.size() == 2)
        return Point<3>(.5 * sum_of(x, corners));
      const double share = corners.size() == 4 ? .5 : .25;
      return Point<3>(share * sum_of(x, edges_round(node)) -
                      .25 * sum_of(x, corners));
    }
  } // namespace



  CellNodes
  nodes_of_hexahedron(const MeshFile &file, const MeshFile::Element &element)
  {
    CellNodes nodes;
    for (unsigned int i = 0; i < 27; ++i)
      nodes[node_of_gmsh[i]] = i < element.nodes.size()
                                 ? file.nodes[element.nodes[i]]
                                 : completed(nodes, node_of_gmsh[i]);
    return nodes;
  }



  std::vector<unsigned int>
  in_gmsh_order(const std::vector<unsigned int> &nodes, const NodeOrder order)
  {
    // Edges as pairs of corners 0 to 7: Gmsh 01 03 04 12 15 23 26 37 45 47 56
    // 67; Abaqus 01 12 23 30, 45 56 67 74, then the four along z; Nastran has
    // these before 45. Gmsh's faces are z min, y min, x min, x max, y max, z
    // max, then the centre; Abaqus has the centre first, then S1 to S6.
    static const std::array<unsigned int, 19> abaqus{{8,
                                                      11,
                                                      16,
                                                      9,
                                                      17,
                                                      10,
                                                      18,
                                                      19,
                                                      12,
                                                      15,
                                                      13,
                                                      14, // edges
                                                      21,
                                                      23,
                                                      26,
                                                      24,
                                                      25,
                                                      22,
                                                      20}},
      nastran{{8, 11, 12, 9, 13, 10, 14, 15, 16, 19, 17, 18}};
    const auto &position = order == NodeOrder::abaqus ? abaqus : nastran;
    std::vector<unsigned int> result(nodes);
    for (unsigned int i = 8; i < nodes.size(); ++i)
      result[i] = nodes[position[i - 8]];
    return result;
  }

  std::array<unsigned int, 2>
  ends_of_nastran_edge(const unsigned int position)
  {
    const unsigned int i = position - 8, k = i % 4;
    if (i < 4)
      return {{k, (k + 1) % 4}};
    if (i < 8)
      return {{k, k + 4}};
    return {{k + 4, (k + 1) % 4 + 4}};
  }

  const std::array<std::array<unsigned int, 4>, 6> &
  faces_of_gmsh_cell()
  {
    static const std::array<std::array<unsigned int, 4>, 6> faces{
      {{{0, 1, 2, 3}},
       {{4, 7, 6, 5}},
       {{0, 4, 5, 1}},
       {{1, 5, 6, 2}},
       {{2, 6, 7, 3}},
       {{3, 7, 4, 0}}}};
    return faces;
  }

  void
  add_faces_of_nodes(MeshFile                &file,
                     const std::vector<bool> &holds,
                     const unsigned int       group)
  {
    for (std::size_t e = 0, n = file.elements.size(); e < n; ++e)
      if (file.elements[e].kind == MeshFile::Kind::hexahedron)
        for (const auto &corners : faces_of_gmsh_cell())
          {
            const MeshFile::Element  &cell = file.elements[e];
            std::vector<unsigned int> nodes;
            for (const unsigned int c : corners)
              nodes.push_back(cell.nodes[c]);
            if (std::all_of(nodes.begin(),
                            nodes.end(),
                            [&](const unsigned int v) { return holds[v]; }))
              file.elements.push_back(
                {cell.tag, MeshFile::Kind::quadrilateral, group, nodes, -1});
          }
  }



  std::optional<long>
  SharedPoints::disagrees(const MeshFile::Element &element,
                          const CellNodes         &nodes)
  {
    std::array<unsigned int, 27> vertex{};
    for (unsigned int i = 0; i < 8; ++i)
      vertex[node_of_gmsh[i]] = element.nodes[i];
    for (unsigned int n = 0; n < 27; ++n)
      {
        const auto corners = corners_round(n);
        if (corners.size() != 2 && corners.size() != 4)
          continue;
        std::vector<unsigned int> key;
        for (const unsigned int c : corners)
          key.push_back(vertex[c]);
        std::sort(key.begin(), key.end());
        const auto [it, is_new] =
          known.emplace(key, Known{nodes[n], element.tag});
        if (!is_new &&
            it->second.x.distance(nodes[n]) >
              1e-9 * nodes[corners.front()].distance(nodes[corners.back()]))
          return it->second.element;
      }
    return {};
  }
} // namespace squeal
