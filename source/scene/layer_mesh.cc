// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>

#include <squeal/scene/layer_mesh.h>
#include <squeal/scene/turning.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

namespace squeal
{
  namespace
  {
    using dealii::Point;
    using dealii::Tensor;
    using Vector = Tensor<1, 3>;

    /** Corners of the faces of a cell, along its first direction first. */
    constexpr unsigned int corners_of_layer_face[6][4] = {{0, 2, 4, 6},
                                                          {1, 3, 5, 7},
                                                          {0, 1, 4, 5},
                                                          {2, 3, 6, 7},
                                                          {0, 1, 2, 3},
                                                          {4, 5, 6, 7}};

    /** A quadrilateral of the face, its two directions and the way out of the
     * body right-handed. */
    struct LayerQuad
    {
      std::array<unsigned int, 4> corner; /**< vertices of the body below */
      /** Nodes at 0, 1/2 and 1 of both directions, the first one fastest. */
      std::array<Point<3>, 9> node;
      bool                    is_curved;
    };

    /** Number of the corner c among the nine nodes. */
    unsigned int
    node_of_corner(const unsigned int c)
    {
      return 2 * (c & 1) + 6 * (c >> 1);
    }

    void
    set_straight_nodes(const BodyMesh &mesh, LayerQuad &quad)
    {
      std::array<Point<3>, 4> x;
      for (unsigned int c = 0; c < 4; ++c)
        x[c] = mesh.vertices[quad.corner[c]];
      for (unsigned int n = 0; n < 9; ++n)
        {
          const double u = .5 * (n % 3), v = .5 * (n / 3);
          quad.node[n] = Point<3>(
            (1. - u) * (1. - v) * Vector(x[0]) + u * (1. - v) * Vector(x[1]) +
            (1. - u) * v * Vector(x[2]) + u * v * Vector(x[3]));
        }
    }

    void
    set_curved_nodes(const CellNodes   &nodes,
                     const unsigned int f,
                     LayerQuad         &quad)
    {
      unsigned int k = 0;
      for (unsigned int n = 0; n < 27; ++n)
        if (std::array<unsigned int, 3>{{n % 3, n / 3 % 3, n / 9}}[f / 2] ==
            2 * (f % 2))
          quad.node[k++] = nodes[n];
    }

    /** Normal at a node, along the first direction times the second. */
    Vector
    normal_at(const LayerQuad &quad, const unsigned int node)
    {
      // derivatives of the parabolas through 0, 1/2, 1 at these points
      constexpr double slope[3][3] = {
        {-3., 4., -1.}, {-1., 0., 1.}, {1., -4., 3.}};
      Vector du, dv;
      for (unsigned int k = 0; k < 3; ++k)
        {
          du += slope[node % 3][k] * Vector(quad.node[k + 3 * (node / 3)]);
          dv += slope[node / 3][k] * Vector(quad.node[node % 3 + 3 * k]);
        }
      const Vector normal = dealii::cross_product_3d(du, dv);
      return normal / normal.norm();
    }

    /** Turns the two directions so that the third one leaves the cell. */
    void
    point_outwards(const Point<3> &centre_of_cell, LayerQuad &quad)
    {
      if (normal_at(quad, 4) * (quad.node[4] - centre_of_cell) > 0.)
        return;
      std::swap(quad.corner[1], quad.corner[2]);
      for (const auto &[a, b] : {std::make_pair(1, 3), {2, 6}, {5, 7}})
        std::swap(quad.node[a], quad.node[b]);
    }



    /** The axis of a round body at the bottom of the stack. */
    std::optional<Point<3>>
    axis_below(const SceneParameters &scene, const BodyParameters &layer)
    {
      const BodyParameters &bottom = bottom_body(scene, layer);
      if (bottom.shape != BodyParameters::Shape::annulus &&
          bottom.shape != BodyParameters::Shape::cylinder)
        return {};
      const Point<3> x = turned_position(bottom);
      return Point<3>(x[0], x[1], 0.);
    }

    /** The normals of a quadrilateral of squeal's own cylinders are radial. */
    bool
    lies_on_cylinder(const LayerQuad &quad, const Point<3> &axis)
    {
      const auto radius = [&](const unsigned int c) {
        const Point<3> &x = quad.node[node_of_corner(c)];
        return std::hypot(x[0] - axis[0], x[1] - axis[1]);
      };
      for (unsigned int c = 1; c < 4; ++c)
        if (!(std::abs(radius(c) - radius(0)) <= 1e-10 * radius(0)))
          return false;
      return std::abs(normal_at(quad, 4)[2]) < 1e-10;
    }

    Vector
    radial_normal(const LayerQuad   &quad,
                  const unsigned int node,
                  const Point<3>    &axis)
    {
      Vector r(
        {quad.node[node][0] - axis[0], quad.node[node][1] - axis[1], 0.});
      r /= r.norm();
      return r * normal_at(quad, node) < 0. ? -1. * r : r;
    }



    class Extrusion
    {
    public:
      Extrusion(const SceneParameters &s,
                const unsigned int     number,
                const BodyMesh        &mesh)
        : scene(s)
        , layer(s.bodies[number])
        , below(mesh)
        , n_layers(layer.element_layers)
        , axis(axis_below(s, layer))
      {
      }

      LayerMesh make();

    private:
      /** Where a node is: a corner, or between two or among four of them. */
      using Place = std::array<unsigned int, 4>;

      [[noreturn]] void
      fail(const std::string &text) const
      {
        throw InputError("Scene/Body " + layer.name + ": the layer on face '" +
                         layer.layer_face + "' of body '" + layer.layer_body +
                         "' " + text);
      }

      void         find_quads();
      void         collect_normals();
      static Place place_of(const LayerQuad &quad, const unsigned int node);
      Vector    offset_at(const LayerQuad &quad, const unsigned int node) const;
      CellNodes nodes_of(const LayerQuad   &quad,
                         const unsigned int l,
                         const bool         is_curved) const;
      void      add_vertices(LayerMesh &result);
      void      add_cells(const bool is_curved, BodyMesh &mesh) const;
      void      add_boundary(BodyMesh &mesh) const;

      const SceneParameters               &scene;
      const BodyParameters                &layer;
      const BodyMesh                      &below;
      const unsigned int                   n_layers;
      const std::optional<Point<3>>        axis;
      unsigned int                         face = 0; /**< its number below */
      std::vector<LayerQuad>               quads;
      std::map<Place, std::vector<Vector>> normals;
      /** Vertices of the layer at the face, by those of the body below. */
      std::map<unsigned int, unsigned int> vertex;
    };

    void
    Extrusion::find_quads()
    {
      const auto name = std::find(
        below.face_names.begin(), below.face_names.end(), layer.layer_face);
      if (name == below.face_names.end())
        {
          std::string list;
          for (const auto &known : below.face_names)
            list += (list.empty() ? "" : ", ") + known;
          fail("has nothing to lie on: the faces of '" + layer.layer_body +
               "' are " + (list.empty() ? "none" : list));
        }
      face = name - below.face_names.begin();
      std::set<Place> wanted;
      for (const auto &quad : below.boundary)
        if (quad.boundary_id == face)
          {
            Place place;
            std::copy(
              quad.vertices.begin(), quad.vertices.end(), place.begin());
            std::sort(place.begin(), place.end());
            wanted.insert(place);
          }
      for (unsigned int c = 0; c < below.cells.size(); ++c)
        for (unsigned int f = 0; f < 6; ++f)
          {
            LayerQuad quad;
            Point<3>  centre;
            for (unsigned int v = 0; v < 4; ++v)
              quad.corner[v] =
                below.cells[c].vertices[corners_of_layer_face[f][v]];
            Place place = quad.corner;
            std::sort(place.begin(), place.end());
            if (wanted.count(place) == 0)
              continue;
            for (const unsigned int v : below.cells[c].vertices)
              centre += Vector(below.vertices[v]) / 8.;
            const auto curved = below.curved.find(c);
            quad.is_curved    = curved != below.curved.end();
            if (quad.is_curved)
              set_curved_nodes(curved->second, f, quad);
            else
              set_straight_nodes(below, quad);
            point_outwards(centre, quad);
            quads.push_back(quad);
          }
      if (quads.empty())
        fail("has nothing to lie on: the face has no cells");
      if (quads.size() != wanted.size())
        fail("has cells on both sides: the face lies inside of the body");
    }



    Extrusion::Place
    Extrusion::place_of(const LayerQuad &quad, const unsigned int node)
    {
      const unsigned int u = node % 3, v = node / 3;
      Place              place;
      for (unsigned int c = 0; c < 4; ++c)
        {
          // the corner at the end that is nearest, the first of equal ones
          const unsigned int i = u == 1 ? (c & 1) : u / 2;
          const unsigned int j = v == 1 ? (c >> 1) : v / 2;
          place[c]             = quad.corner[i + 2 * j];
        }
      std::sort(place.begin(), place.end());
      return place;
    }

    void
    Extrusion::collect_normals()
    {
      for (const LayerQuad &quad : quads)
        {
          const bool is_round = axis && lies_on_cylinder(quad, *axis);
          for (unsigned int n = 0; n < 9; ++n)
            normals[place_of(quad, n)].push_back(
              is_round ? radial_normal(quad, n, *axis) : normal_at(quad, n));
        }
    }

    Vector
    Extrusion::offset_at(const LayerQuad &quad, const unsigned int node) const
    {
      const auto     &n = normals.at(place_of(quad, node));
      Eigen::MatrixXd A(n.size(), 3);
      for (std::size_t i = 0; i < n.size(); ++i)
        for (unsigned int c = 0; c < 3; ++c)
          A(i, c) = n[i][c];
      // Normals of a smooth face differ by the mesh only: they have a mean,
      // those on both sides of a sharp edge a common solution.
      Eigen::JacobiSVD<Eigen::MatrixXd> svd(
        A, Eigen::ComputeThinU | Eigen::ComputeThinV);
      svd.setThreshold(0.1);
      const Eigen::Vector3d m = svd.solve(Eigen::VectorXd::Ones(n.size()));
      const Eigen::VectorXd components = A * m;
      if (!(components.minCoeff() > 0.9 && components.maxCoeff() < 1.1 &&
            m.norm() < 2.))
        fail("has no thickness where the face folds: name the parts of the "
             "face apart, or round the edge with more cells");
      return Vector({m[0], m[1], m[2]});
    }

    CellNodes
    Extrusion::nodes_of(const LayerQuad   &quad,
                        const unsigned int l,
                        const bool         is_curved) const
    {
      // Bilinear cells take the middles of their corners.
      std::array<Point<3>, 9> x;
      std::array<Vector, 9>   m;
      LayerQuad               straight = quad;
      for (unsigned int c = 0; c < 4; ++c)
        m[node_of_corner(c)] = offset_at(quad, node_of_corner(c));
      if (!is_curved)
        set_straight_nodes(below, straight);
      for (unsigned int n = 0; n < 9; ++n)
        {
          x[n] = straight.node[n];
          if (n % 2 == 0 && n != 4)
            continue;
          const double u = .5 * (n % 3), v = .5 * (n / 3);
          m[n] = is_curved ? offset_at(quad, n)
                           : (1. - u) * (1. - v) * m[0] + u * (1. - v) * m[2] +
                               (1. - u) * v * m[6] + u * v * m[8];
        }
      CellNodes nodes;
      for (unsigned int k = 0; k < 3; ++k)
        for (unsigned int n = 0; n < 9; ++n)
          nodes[n + 9 * k] =
            x[n] + layer.thickness * (2 * l + k) / (2. * n_layers) * m[n];
      return nodes;
    }



    void
    Extrusion::add_vertices(LayerMesh &result)
    {
      std::map<unsigned int, Vector> offsets;
      for (const LayerQuad &quad : quads)
        for (unsigned int c = 0; c < 4; ++c)
          offsets.emplace(quad.corner[c], offset_at(quad, node_of_corner(c)));
      for (const auto &[v, offset] : offsets)
        {
          vertex[v] = result.shared.size();
          result.shared.push_back(v);
        }
      for (unsigned int l = 0; l <= n_layers; ++l)
        for (const auto &[v, offset] : offsets)
          result.mesh.vertices.push_back(
            below.vertices[v] + layer.thickness * l / n_layers * offset);
    }

    void
    Extrusion::add_cells(const bool is_curved, BodyMesh &mesh) const
    {
      const unsigned int n = vertex.size();
      for (const LayerQuad &quad : quads)
        for (unsigned int l = 0; l < n_layers; ++l)
          {
            dealii::CellData<3> cell;
            for (unsigned int c = 0; c < 4; ++c)
              {
                cell.vertices[c]     = l * n + vertex.at(quad.corner[c]);
                cell.vertices[c + 4] = cell.vertices[c] + n;
              }
            const CellNodes nodes = nodes_of(quad, l, is_curved);
            if (!(range_of_jacobian(nodes).first > 0.))
              fail("turns inside out: 'Thickness' is more than the radius of a "
                   "hollow of the face");
            if (is_curved && squeal::is_curved(nodes))
              mesh.curved[mesh.cells.size()] = nodes;
            mesh.cells.push_back(cell);
          }
    }

    void
    Extrusion::add_boundary(BodyMesh &mesh) const
    {
      const unsigned int n   = vertex.size();
      const auto         add = [&](const std::array<unsigned int, 4> &v,
                           const unsigned int                 face) {
        dealii::CellData<2> quad;
        for (unsigned int c = 0; c < 4; ++c)
          quad.vertices[c] = v[c];
        quad.boundary_id = face;
        mesh.boundary.push_back(quad);
      };
      std::map<std::array<unsigned int, 2>, unsigned int> n_quads;
      for (const LayerQuad &quad : quads)
        {
          std::array<unsigned int, 4> v;
          for (unsigned int c = 0; c < 4; ++c)
            v[c] = vertex.at(quad.corner[c]);
          for (const auto &[a, b] :
               {std::make_pair(0, 1), {0, 2}, {1, 3}, {2, 3}})
            ++n_quads[{{std::min(v[a], v[b]), std::max(v[a], v[b])}}];
          for (auto &w : v)
            w += n_layers * n;
          add(v, 0);
        }
      for (const auto &[edge, number] : n_quads)
        if (number == 1)
          for (unsigned int l = 0; l < n_layers; ++l)
            add({{edge[0] + l * n,
                  edge[1] + l * n,
                  edge[0] + (l + 1) * n,
                  edge[1] + (l + 1) * n}},
                1);
    }

    LayerMesh
    Extrusion::make()
    {
      find_quads();
      collect_normals();
      const bool is_curved =
        std::any_of(quads.begin(), quads.end(), [](const LayerQuad &quad) {
          return quad.is_curved;
        });
      LayerMesh result;
      result.mesh.face_names = {"outer", "sides"};
      add_vertices(result);
      add_cells(is_curved, result.mesh);
      add_boundary(result.mesh);
      if (below.round_faces.count(face) > 0)
        result.mesh.round_faces.insert(0);
      if (!result.mesh.curved.empty())
        result.mesh.round_faces.insert(1);
      return result;
    }
  } // namespace



  LayerMesh
  make_layer_mesh(const SceneParameters &scene,
                  const unsigned int     number,
                  const BodyMesh        &below)
  {
    return Extrusion(scene, number, below).make();
  }



  const BodyParameters &
  bottom_body(const SceneParameters &scene, const BodyParameters &body)
  {
    return body.shape == BodyParameters::Shape::layer
             ? bottom_body(scene,
                           scene.bodies[body_index(scene, body.layer_body)])
             : body;
  }
} // namespace squeal
