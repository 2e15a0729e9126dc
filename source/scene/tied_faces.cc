// SPDX-License-Identifier: LGPL-2.1-or-later

// What else of a scene is on the faces that a tie joins.

#include <squeal/base/exceptions.h>
#include <squeal/scene/tied_faces.h>

#include <algorithm>

namespace squeal
{
  namespace
  {
    using Components = std::array<bool, 3>;

    /** How far a point may be off the straight cells of a face on which it is
     * to lie, over their size: faces are round. */
    constexpr double beside_face = 0.02;

    Components
    held_by(const CoarseMesh        &mesh,
            const SceneParameters   &scene,
            const SupportParameters &support)
    {
      using Kind = SupportParameters::Kind;
      Components held{};
      if (support.kind == Kind::clamped)
        held.fill(true);
      if (support.kind == Kind::guided || support.kind == Kind::held)
        if (const unsigned int axis = axis_of_face(
              mesh, face_id(mesh, scene, support.body, support.face));
            axis < 3)
          held[axis] = true;
      for (unsigned int c = 0; c < 3; ++c)
        if (std::count(support.components.begin(),
                       support.components.end(),
                       std::string(1, "xyz"[c])) > 0)
          held[c] = true;
      return held;
    }

    /** Whether @p x is on the triangle of these corners, about. */
    bool
    is_on(const std::array<dealii::Point<3>, 3> &corners,
          const dealii::Point<3>                &x)
    {
      const auto a = corners[1] - corners[0], b = corners[2] - corners[0],
                 r        = x - corners[0];
      const auto   n      = dealii::cross_product_3d(a, b);
      const double square = n.norm_square();
      if (!(square > 0.))
        return false;
      const double s = dealii::cross_product_3d(r, b) * n / square,
                   t = dealii::cross_product_3d(a, r) * n / square;
      return s > -beside_face && t > -beside_face && s + t < 1. + beside_face &&
             std::abs(r * n) / square <
               beside_face * std::max(a.norm(), b.norm()) / std::sqrt(square);
    }

    bool
    has_point(const CoarseMesh       &mesh,
              const unsigned int      face,
              const dealii::Point<3> &x)
    {
      const auto corner = [&](const auto &quad, const unsigned int v) {
        return mesh.vertices[quad.vertices[v]];
      };
      return std::any_of(
        mesh.boundary.boundary_quads.begin(),
        mesh.boundary.boundary_quads.end(),
        [&](const auto &quad) {
          return quad.boundary_id == face &&
                 (is_on({{corner(quad, 0), corner(quad, 1), corner(quad, 3)}},
                        x) ||
                  is_on({{corner(quad, 0), corner(quad, 3), corner(quad, 2)}},
                        x));
        });
    }

    bool
    is_rigid(const SceneParameters &scene, const std::string &body)
    {
      return body != "ground" && scene.bodies[body_index(scene, body)].shape ==
                                   BodyParameters::Shape::rigid;
    }

    /** What the supports of the target hold at a place of its tied face. */
    Components
    held_on_target(const CoarseMesh       &mesh,
                   const SceneParameters  &scene,
                   const TieParameters    &tie,
                   const dealii::Point<3> &x)
    {
      Components result{};
      for (const auto &support : scene.supports)
        if (support.body == tie.target_body &&
            support.kind != SupportParameters::Kind::free &&
            !is_rigid(scene, support.body) &&
            has_point(
              mesh, face_id(mesh, scene, support.body, support.face), x))
          {
            const Components held = held_by(mesh, scene, support);
            for (unsigned int c = 0; c < 3; ++c)
              result[c] = result[c] || held[c];
          }
      return result;
    }

    /** Throws InputError where @p support holds nodes of the source face that
     * the target leaves free. */
    void
    check_support(const CoarseMesh             &mesh,
                  const SceneParameters        &scene,
                  const TieParameters          &tie,
                  const std::set<unsigned int> &source,
                  const SupportParameters      &support)
    {
      const Components             held  = held_by(mesh, scene, support);
      const std::set<unsigned int> nodes = vertices_of_face(
        mesh, face_id(mesh, scene, support.body, support.face));
      for (const unsigned int v : source)
        {
          if (nodes.count(v) == 0)
            continue;
          const Components there =
            held_on_target(mesh, scene, tie, mesh.vertices[v]);
          for (unsigned int c = 0; c < 3; ++c)
            if (held[c] && !there[c])
              throw InputError(
                "Scene/Tie " + tie.name + ": 'Scene/Support " + support.name +
                "' holds nodes of its source face '" + tie.source_face +
                "' of body '" + tie.source_body +
                "', which follow the target and cannot be held as well: "
                "exchange source and target of the tie, support body '" +
                tie.target_body +
                "' there too, or give both faces the same cells and set Kind = "
                "conforming");
        }
    }
  } // namespace



  std::set<unsigned int>
  vertices_of_face(const CoarseMesh &mesh, const unsigned int id)
  {
    std::set<unsigned int> result;
    for (const auto &quad : mesh.boundary.boundary_quads)
      if (quad.boundary_id == id)
        result.insert(quad.vertices.begin(), quad.vertices.end());
    return result;
  }



  std::string
  other_use_of_tied_faces(const SceneParameters &scene,
                          const TieParameters   &tie)
  {
    const auto is_tied = [&tie](const std::string &body,
                                const std::string &face) {
      return (body == tie.source_body && face == tie.source_face) ||
             (body == tie.target_body && face == tie.target_face);
    };
    const auto uses = [&](const auto &pair) {
      return is_tied(pair.source_body, pair.source_face) ||
             is_tied(pair.target_body, pair.target_face);
    };
    for (const auto &support : scene.supports)
      if (support.kind != SupportParameters::Kind::free &&
          is_tied(support.body, support.face))
        return "Scene/Support " + support.name;
    for (const auto &load : scene.loads)
      if (is_tied(load.body, load.face))
        return "Scene/Load " + load.name;
    for (const auto &spring : scene.springs)
      if (spring.kind == SpringParameters::Kind::area &&
          is_tied(spring.body, spring.face))
        return "Scene/Spring " + spring.name;
    for (const auto &contact : scene.contacts)
      if (uses(contact))
        return "Scene/Contact " + contact.name;
    for (const auto &other : scene.ties)
      if (other.name != tie.name && uses(other))
        return "Scene/Tie " + other.name;
    return "";
  }



  void
  check_supports_on_ties(const SceneParameters &scene, const CoarseMesh &mesh)
  {
    for (std::size_t i = 0; i < scene.ties.size(); ++i)
      if (!mesh.tie_is_conforming[i])
        {
          const TieParameters         &tie    = scene.ties[i];
          const std::set<unsigned int> source = vertices_of_face(
            mesh, face_id(mesh, scene, tie.source_body, tie.source_face));
          for (const auto &support : scene.supports)
            if (support.kind != SupportParameters::Kind::free &&
                !is_rigid(scene, support.body))
              check_support(mesh, scene, tie, source, support);
        }
  }
} // namespace squeal
