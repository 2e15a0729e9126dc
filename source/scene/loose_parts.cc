// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/base/number_text.h>
#include <squeal/scene/loose_parts.h>

#include <deal.II/base/bounding_box.h>

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <set>

namespace squeal
{
  namespace
  {
    using Box = dealii::BoundingBox<3>;

    /** Parts of the mesh that share vertices; named by one vertex each. */
    class Parts
    {
    public:
      Parts(const SceneParameters &scene, const CoarseMesh &mesh)
        : scene(scene)
        , mesh(mesh)
        , parent(mesh.vertices.size() + 1)
        , ground(mesh.vertices.size())
        , of_body(scene.bodies.size())
      {
        std::iota(parent.begin(), parent.end(), 0);
        for (const auto &cell : mesh.cells)
          for (const unsigned int v : cell.vertices)
            unite(v, cell.vertices[0]);
        for (const auto &cell : mesh.cells)
          ++of_body[cell.material_id][root(cell.vertices[0])];
      }

      void check();

    private:
      unsigned int
      root(unsigned int v)
      {
        while (parent[v] != v)
          v = parent[v] = parent[parent[v]];
        return v;
      }

      void
      unite(const unsigned int a, const unsigned int b)
      {
        parent[root(a)] = root(b);
      }

      bool is_meshed(const std::string &body) const;
      /** The parts that a face belongs to, with the box round it on each. */
      std::map<unsigned int, Box> parts_at(const std::string &body,
                                           const std::string &face);
      void hold(const std::string &body, const std::string &face);
      template <typename Pair>
      void              unite_across(const Pair &pair);
      void              unite_what_is_held();
      [[noreturn]] void refuse(const unsigned int body,
                               const unsigned int part) const;

      const SceneParameters    &scene;
      const CoarseMesh         &mesh;
      std::vector<unsigned int> parent;
      const unsigned int        ground;
      /** Numbers of cells of the parts of each body. */
      std::vector<std::map<unsigned int, unsigned int>> of_body;
    };



    bool
    Parts::is_meshed(const std::string &body) const
    {
      return body != "ground" && scene.bodies[body_index(scene, body)].shape !=
                                   BodyParameters::Shape::rigid;
    }

    std::map<unsigned int, Box>
    Parts::parts_at(const std::string &body, const std::string &face)
    {
      std::map<unsigned int, Box> boxes;
      const unsigned int          id = face_id(mesh, scene, body, face);
      for (const auto &quad : mesh.boundary.boundary_quads)
        if (quad.boundary_id == id)
          {
            std::vector<dealii::Point<3>> corners;
            for (const unsigned int v : quad.vertices)
              corners.push_back(mesh.vertices[v]);
            Box box(corners);
            box.extend(.02 * corners[0].distance(corners[3]));
            const auto [it, is_new] =
              boxes.emplace(root(quad.vertices[0]), box);
            if (!is_new)
              it->second.merge_with(box);
          }
      return boxes;
    }

    void
    Parts::hold(const std::string &body, const std::string &face)
    {
      if (is_meshed(body))
        for (const auto &[part, box] : parts_at(body, face))
          unite(part, ground);
    }

    template <typename Pair>
    void
    Parts::unite_across(const Pair &pair)
    {
      if (!is_meshed(pair.source_body))
        return hold(pair.target_body, pair.target_face);
      if (!is_meshed(pair.target_body))
        return hold(pair.source_body, pair.source_face);
      const auto sources = parts_at(pair.source_body, pair.source_face),
                 targets = parts_at(pair.target_body, pair.target_face);
      for (const auto &[source, source_box] : sources)
        for (const auto &[target, target_box] : targets)
          if (source_box.get_neighbor_type(target_box) !=
              dealii::NeighborType::not_neighbors)
            unite(source, target);
    }

    void
    Parts::unite_what_is_held()
    {
      for (const auto &tie : scene.ties)
        unite_across(tie);
      for (const auto &contact : scene.contacts)
        unite_across(contact);
      for (const auto &support : scene.supports)
        if (support.kind != SupportParameters::Kind::free)
          hold(support.body, support.face);
      for (const auto &spring : scene.springs)
        if (spring.kind == SpringParameters::Kind::area)
          hold(spring.body, spring.face);
    }

    void
    Parts::check()
    {
      bool all_whole = true;
      for (const auto &parts : of_body)
        all_whole = all_whole && parts.size() <= 1;
      if (all_whole)
        return;
      unite_what_is_held();
      for (unsigned int b = 0; b < of_body.size(); ++b)
        {
          // The others must hang on the ground or on the largest part.
          unsigned int most = 0, anchor = ground;
          for (const auto &[part, n_cells] : of_body[b])
            if (root(part) == root(ground))
              {
                anchor = ground;
                break;
              }
            else if (n_cells > most)
              {
                most   = n_cells;
                anchor = part;
              }
          for (const auto &[part, n_cells] : of_body[b])
            if (root(part) != root(anchor))
              refuse(b, part);
        }
    }

    void
    Parts::refuse(const unsigned int body, const unsigned int part) const
    {
      const unsigned int n_cells = of_body[body].at(part);
      const auto        &x       = mesh.vertices[part];
      throw InputError(
        "body '" + scene.bodies[body].name + "': mesh file '" +
        scene.bodies[body].mesh_file + "' falls into " +
        std::to_string(of_body[body].size()) +
        " parts that share no nodes, and nothing holds the part of " +
        std::to_string(n_cells) + (n_cells == 1 ? " cell" : " cells") +
        " with a node at (" + rounded_text(x[0], 6) + ", " +
        rounded_text(x[1], 6) + ", " + rounded_text(x[2], 6) +
        ") m: name its face in a tie, a contact or a support, or merge "
        "coincident nodes (Coherence Mesh)");
    }


    /** A face of the surface of a body. */
    struct SurfaceFace
    {
      unsigned int                    id;
      std::array<dealii::Point<3>, 4> corners;
      dealii::Point<3>                centre;
      double place; /**< of the centre along a skew line, m */
    };

    /** The faces of a body, sorted along a line that is skew to the planes of
     * most meshes, so that few are at one place of it. */
    std::vector<SurfaceFace>
    sorted_surface(const CoarseMesh &mesh, const unsigned int body)
    {
      const dealii::Tensor<1, 3> line(dealii::Point<3>(.5377, .6180, .5733));
      std::vector<SurfaceFace>   faces;
      for (const auto &quad : mesh.boundary.boundary_quads)
        if (quad.boundary_id / max_faces_per_body == body)
          {
            SurfaceFace face{quad.boundary_id, {}, {}, 0.};
            for (unsigned int v = 0; v < 4; ++v)
              {
                face.corners[v] = mesh.vertices[quad.vertices[v]];
                face.centre += .25 * face.corners[v];
              }
            face.place = face.centre * line;
            faces.push_back(face);
          }
      std::sort(faces.begin(), faces.end(), [](const auto &a, const auto &b) {
        return a.place < b.place;
      });
      return faces;
    }

    bool
    lies_on(const SurfaceFace &a, const SurfaceFace &b, const double tolerance)
    {
      return std::all_of(
        a.corners.begin(), a.corners.end(), [&](const auto &x) {
          return std::any_of(
            b.corners.begin(), b.corners.end(), [&](const auto &y) {
              return x.distance(y) <= tolerance;
            });
        });
    }

    /** Pairs of faces of the body that a tie or a contact puts together. */
    std::set<std::pair<unsigned int, unsigned int>>
    paired_faces(const SceneParameters &scene,
                 const CoarseMesh      &mesh,
                 const std::string     &body)
    {
      std::set<std::pair<unsigned int, unsigned int>> result;
      const auto add = [&](const auto &pair) {
        if (pair.source_body != body || pair.target_body != body)
          return;
        const unsigned int a = face_id(mesh, scene, body, pair.source_face),
                           b = face_id(mesh, scene, body, pair.target_face);
        result.insert({{a, b}, {b, a}});
      };
      for (const auto &tie : scene.ties)
        add(tie);
      for (const auto &contact : scene.contacts)
        add(contact);
      return result;
    }

    /** Centres of the faces that lie on another one and are not paired. m */
    std::vector<dealii::Point<3>>
    centres_of_slits(
      const std::vector<SurfaceFace>                        &faces,
      const std::set<std::pair<unsigned int, unsigned int>> &paired)
    {
      std::vector<dealii::Point<3>> centres;
      for (std::size_t i = 0; i < faces.size(); ++i)
        {
          const auto  &face = faces[i];
          const double tolerance =
            1e-5 * face.corners[0].distance(face.corners[3]);
          for (std::size_t j = i + 1;
               j < faces.size() && faces[j].place - face.place <= tolerance;
               ++j)
            if (lies_on(face, faces[j], tolerance) &&
                paired.count({face.id, faces[j].id}) == 0)
              centres.push_back(face.centre);
        }
      return centres;
    }
  } // namespace



  void
  refuse_loose_parts(const SceneParameters &scene, const CoarseMesh &mesh)
  {
    Parts(scene, mesh).check();
  }

  std::vector<std::string>
  remarks_on_slits(const SceneParameters &scene, const CoarseMesh &mesh)
  {
    std::vector<std::string> remarks;
    for (unsigned int b = 0; b < scene.bodies.size(); ++b)
      {
        const auto &body = scene.bodies[b];
        if (body.mesh_file.empty())
          continue;
        const auto centres = centres_of_slits(
          sorted_surface(mesh, b), paired_faces(scene, mesh, body.name));
        if (centres.empty())
          continue;
        const auto &x = centres.front();
        remarks.push_back(
          "body '" + body.name + "': mesh file '" + body.mesh_file + "' has " +
          std::to_string(centres.size()) +
          (centres.size() == 1 ? " pair" : " pairs") +
          " of faces that lie on each other with nodes of their own, the first "
          "at (" +
          rounded_text(x[0], 6) + ", " + rounded_text(x[1], 6) + ", " +
          rounded_text(x[2], 6) +
          ") m: the body is slit open there; merge coincident nodes (Coherence "
          "Mesh) unless that is meant");
      }
    return remarks;
  }
} // namespace squeal
