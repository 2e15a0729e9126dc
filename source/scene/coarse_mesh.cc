// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/scene/coarse_mesh.h>
#include <squeal/scene/layer_mesh.h>
#include <squeal/scene/loose_parts.h>
#include <squeal/scene/matching_faces.h>
#include <squeal/scene/tied_faces.h>

#include <algorithm>
#include <cctype>
#include <map>

namespace squeal
{
  namespace
  {
    std::string
    listed(const std::vector<std::string> &names)
    {
      std::string text;
      for (const auto &name : names)
        text += (text.empty() ? "" : ", ") + name;
      return text.empty() ? "none" : text;
    }

    /** Replaces the source vertices by their partners; the joined faces stop
     * being boundary. */
    void
    join(CoarseMesh                                 &mesh,
         const std::map<unsigned int, unsigned int> &partner,
         const unsigned int                          source_id,
         const unsigned int                          target_id)
    {
      const auto replace = [&](auto &vertices) {
        for (auto &v : vertices)
          if (const auto it = partner.find(v); it != partner.end())
            v = it->second;
      };
      for (auto &cell : mesh.cells)
        replace(cell.vertices);
      auto &quads = mesh.boundary.boundary_quads;
      quads.erase(std::remove_if(quads.begin(),
                                 quads.end(),
                                 [&](const auto &q) {
                                   return q.boundary_id == source_id ||
                                          q.boundary_id == target_id;
                                 }),
                  quads.end());
      for (auto &quad : quads)
        replace(quad.vertices);
    }

    /** Drops vertices that no cell uses any more. */
    void
    compress(CoarseMesh &mesh)
    {
      std::vector<unsigned int>     number(mesh.vertices.size(), -1u);
      std::vector<dealii::Point<3>> kept;
      for (auto &cell : mesh.cells)
        for (auto &v : cell.vertices)
          {
            if (number[v] == -1u)
              {
                number[v] = kept.size();
                kept.push_back(mesh.vertices[v]);
              }
            v = number[v];
          }
      for (auto &quad : mesh.boundary.boundary_quads)
        for (auto &v : quad.vertices)
          v = number[v];
      mesh.vertices = std::move(kept);
    }
    bool
    are_linked(const SceneParameters &scene,
               const std::string     &a,
               const std::string     &b)
    {
      const auto links = [&](const auto &pair) {
        return (pair.source_body == a && pair.target_body == b) ||
               (pair.source_body == b && pair.target_body == a);
      };
      return std::any_of(scene.ties.begin(), scene.ties.end(), links) ||
             std::any_of(scene.contacts.begin(), scene.contacts.end(), links);
    }

    /** Nodes that two volumes of a Gmsh file share would glue them in most
     * codes; here every body has its own. Refuses to choose for the user. */
    void
    check_shared_nodes(const SceneParameters &scene,
                       const BodyParameters  &body,
                       const BodyMesh        &mesh)
    {
      for (const BodyParameters &other : scene.bodies)
        if (other.name != body.name && other.mesh_file == body.mesh_file &&
            std::count(mesh.touching_volumes.begin(),
                       mesh.touching_volumes.end(),
                       other.physical_volume) > 0 &&
            !are_linked(scene, body.name, other.name))
          throw InputError("bodies '" + body.name + "' and '" + other.name +
                           "': share nodes in mesh file '" + body.mesh_file +
                           "': glue them by a tie, let them touch by a "
                           "contact, or duplicate the nodes between them");
    }
    /** A tie of a mesh file must be one of the scene, or a contact: without it
     * the parts would come apart. */
    void
    check_file_tie(const SceneParameters            &scene,
                   const BodyParameters             &body,
                   const std::array<std::string, 3> &tie)
    {
      const auto is = [&](const std::string &name,
                          const std::string &face,
                          const std::string &surface) {
        for (const BodyParameters &other : scene.bodies)
          if (other.name == name && other.mesh_file == body.mesh_file)
            return std::equal(face.begin(),
                              face.end(),
                              surface.begin(),
                              surface.end(),
                              [](const char a, const char b) {
                                return std::toupper(a) == std::toupper(b);
                              });
        return false;
      };
      const auto joins = [&](const auto &pair) {
        return (is(pair.source_body, pair.source_face, tie[1]) &&
                is(pair.target_body, pair.target_face, tie[2])) ||
               (is(pair.source_body, pair.source_face, tie[2]) &&
                is(pair.target_body, pair.target_face, tie[1]));
      };
      if (std::none_of(scene.ties.begin(), scene.ties.end(), joins) &&
          std::none_of(scene.contacts.begin(), scene.contacts.end(), joins))
        throw InputError("mesh file '" + body.mesh_file + "' ties '" + tie[1] +
                         "' to '" + tie[2] + "'" +
                         (tie[0].empty() ? "" : " (" + tie[0] + ")") +
                         ", the scene does not: add a tie or a contact of "
                         "these faces");
    }



    /** Meshes of bodies and where their vertices are in that of the scene. */
    struct PlacedBodies
    {
      std::vector<BodyMesh>                  meshes;
      std::vector<std::vector<unsigned int>> vertices;
    };

    /** The mesh of a layer, whose first vertices are those of the body below;
     * what it covers stops being boundary. */
    BodyMesh
    layer_on_body_below(const SceneParameters &scene,
                        const unsigned int     b,
                        PlacedBodies          &bodies,
                        CoarseMesh            &mesh)
    {
      const BodyParameters &layer = scene.bodies[b];
      const unsigned int    below = body_index(scene, layer.layer_body);
      const LayerMesh result = make_layer_mesh(scene, b, bodies.meshes[below]);
      const unsigned int covered =
        face_id(mesh, scene, layer.layer_body, layer.layer_face);
      for (const unsigned int v : result.shared)
        bodies.vertices[b].push_back(bodies.vertices[below][v]);
      auto &quads = mesh.boundary.boundary_quads;
      quads.erase(std::remove_if(quads.begin(),
                                 quads.end(),
                                 [&](const auto &quad) {
                                   return quad.boundary_id == covered;
                                 }),
                  quads.end());
      return result.mesh;
    }

    void
    place_body(const SceneParameters &scene,
               const unsigned int     b,
               PlacedBodies          &bodies,
               CoarseMesh            &mesh)
    {
      bodies.vertices.emplace_back();
      const BodyMesh body =
        scene.bodies[b].shape == BodyParameters::Shape::layer
          ? layer_on_body_below(scene, b, bodies, mesh)
          : make_body_mesh(scene.bodies[b]);
      check_shared_nodes(scene, scene.bodies[b], body);
      for (const auto &tie : body.file_ties)
        check_file_tie(scene, scene.bodies[b], tie);
      for (const auto &remark : body.remarks)
        if (std::count(mesh.remarks.begin(), mesh.remarks.end(), remark) == 0)
          mesh.remarks.push_back(remark);
      for (const auto &[cell, nodes] : body.curved)
        mesh.curved[mesh.cells.size() + cell] = nodes;
      for (const unsigned int face : body.round_faces)
        mesh.round_faces.insert(face_id(b, face));
      mesh.face_names.push_back(body.face_names);
      auto &place = bodies.vertices[b];
      for (std::size_t v = place.size(); v < body.vertices.size(); ++v)
        {
          place.push_back(mesh.vertices.size());
          mesh.vertices.push_back(body.vertices[v]);
        }
      for (auto cell : body.cells)
        {
          for (auto &v : cell.vertices)
            v = place[v];
          cell.material_id = b;
          mesh.cells.push_back(cell);
        }
      for (auto quad : body.boundary)
        {
          for (auto &v : quad.vertices)
            v = place[v];
          quad.boundary_id = face_id(b, quad.boundary_id);
          mesh.boundary.boundary_quads.push_back(quad);
        }
      bodies.meshes.push_back(body);
    }
  } // namespace



  unsigned int
  face_id(const unsigned int body, const unsigned int face)
  {
    return body * max_faces_per_body + face;
  }

  unsigned int
  body_index(const SceneParameters &scene, const std::string &name)
  {
    std::vector<std::string> names;
    for (unsigned int b = 0; b < scene.bodies.size(); ++b)
      {
        if (scene.bodies[b].name == name)
          return b;
        names.push_back(scene.bodies[b].name);
      }
    throw InputError("Scene/Bodies: there is no body '" + name +
                     "'; bodies are: " + listed(names));
  }

  unsigned int
  face_id(const CoarseMesh      &mesh,
          const SceneParameters &scene,
          const std::string     &body,
          const std::string     &face)
  {
    const unsigned int b     = body_index(scene, body);
    const auto        &names = mesh.face_names[b];
    const auto         it    = std::find(names.begin(), names.end(), face);
    if (it == names.end())
      throw InputError("body '" + body + "' has no face '" + face +
                       "'; its faces are: " + listed(names));
    return face_id(b, it - names.begin());
  }



  unsigned int
  axis_of_face(const CoarseMesh &mesh, const unsigned int face)
  {
    if (mesh.round_faces.count(face) > 0)
      return -1u;
    dealii::Tensor<1, 3> area;
    double               total = 0.;
    for (const auto &quad : mesh.boundary.boundary_quads)
      if (quad.boundary_id == face)
        {
          const auto &v = quad.vertices; // lexicographic
          const auto  vector =
            0.5 *
            dealii::cross_product_3d(mesh.vertices[v[3]] - mesh.vertices[v[0]],
                                     mesh.vertices[v[2]] - mesh.vertices[v[1]]);
          area += vector * (area * vector < 0. ? -1. : 1.);
          total += vector.norm();
        }
    for (unsigned int c = 0; c < 3; ++c)
      if (std::abs(area[c]) > (1. - 1e-9) * total)
        return c;
    return -1u;
  }



  CoarseMesh
  make_coarse_mesh(const SceneParameters &scene)
  {
    CoarseMesh mesh;
    if (scene.bodies.size() > 250)
      throw InputError("Scene/Bodies: at most 250 bodies are supported");
    PlacedBodies bodies;
    for (unsigned int b = 0; b < scene.bodies.size(); ++b)
      place_body(scene, b, bodies, mesh);

    for (const auto &tie : scene.ties)
      {
        const unsigned int source =
          face_id(mesh, scene, tie.source_body, tie.source_face);
        const auto &target_body =
          scene.bodies[body_index(scene, tie.target_body)];
        if (target_body.shape == BodyParameters::Shape::rigid)
          {
            mesh.tie_is_conforming.push_back(false);
            continue;
          }
        const unsigned int target =
          face_id(mesh, scene, tie.target_body, tie.target_face);
        const auto        partner = matching_vertices(mesh, source, target);
        const std::string use     = other_use_of_tied_faces(scene, tie);
        const bool        join_it = !partner.empty() &&
                             tie.kind != TieParameters::Kind::mortar &&
                             use.empty();
        if (partner.empty() && tie.kind == TieParameters::Kind::conforming)
          throw InputError("Scene/Tie " + tie.name + ": the face meshes of '" +
                           tie.source_body + "' and '" + tie.target_body +
                           "' do not match: give both the same cells or set "
                           "Kind = mortar");
        if (!use.empty() && tie.kind == TieParameters::Kind::conforming)
          throw InputError("Scene/Tie " + tie.name + ": '" + use +
                           "' is on a face that a conforming tie joins, so "
                           "that it lies inside: set Kind = mortar");
        if (join_it)
          join(mesh, partner, source, target);
        mesh.tie_is_conforming.push_back(join_it);
      }
    refuse_loose_parts(scene, mesh);
    for (const auto &remark : remarks_on_slits(scene, mesh))
      mesh.remarks.push_back(remark);
    check_supports_on_ties(scene, mesh);
    compress(mesh);
    return mesh;
  }
} // namespace squeal
