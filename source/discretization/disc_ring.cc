// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/discretization/disc_ring.h>
#include <squeal/scene/coarse_mesh.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace squeal
{
  namespace
  {
    using Point  = dealii::Point<3>;
    using Vector = dealii::Tensor<1, 3>;

    /** Area of a face over that of the circular ring between its radii. */
    constexpr double least_area = 0.95, largest_area = 1. + 1e-3;
    /** Distance of points of a flat face from its plane, over its radius. */
    constexpr double flatness = 1e-6;

    DiscRing
    ring_of_annulus(const SceneParameters &scene, const unsigned int body)
    {
      const BodyParameters &disc = scene.bodies[body];
      DiscRing              ring;
      ring.centre = Point(disc.position[0], disc.position[1], disc.position[2]);
      for (unsigned int c = 0; c < 3; ++c)
        ring.directions[c][c] = 1.;
      ring.inner_radius = disc.inner_radius;
      ring.outer_radius = disc.outer_radius;
      const bool down   = contact_face_looks_down(scene, body);
      ring.face         = down ? 0. : disc.height;
      ring.other_side   = down ? disc.height : 0.;
      return ring;
    }

    /** Corners of the faces of the coarse mesh with this id. */
    std::vector<std::array<Point, 4>>
    quads_of(const CoarseMesh &mesh, const unsigned int id)
    {
      std::vector<std::array<Point, 4>> quads;
      for (const auto &face : mesh.boundary.boundary_quads)
        if (face.boundary_id == id)
          {
            quads.emplace_back();
            for (unsigned int v = 0; v < 4; ++v)
              quads.back()[v] = mesh.vertices[face.vertices[v]];
          }
      return quads;
    }

    /** Twice the area of a quadrilateral along its normal; corners as deal.II
     * orders them, to within the sign. */
    Vector
    twice_area(const std::array<Point, 4> &q)
    {
      return dealii::cross_product_3d(Vector(q[3] - q[0]), Vector(q[2] - q[1]));
    }

    /** Unit vectors with @p axis the last one; the first two next to those of
     * the scene, x and y for z. */
    std::array<Vector, 3>
    directions_about(const Vector &axis)
    {
      unsigned int along = 0;
      for (unsigned int c = 1; c < 3; ++c)
        if (std::abs(axis[c]) > std::abs(axis[along]) + 1e-6)
          along = c;
      Vector first;
      first[(along + 1) % 3] = 1.;
      first -= (first * axis) * axis;
      first /= first.norm();
      return {{first, dealii::cross_product_3d(axis, first), axis}};
    }

    /** Axis and centre of a flat face, and its area; none where it is not
     * flat. */
    struct Plane
    {
      Point  centre;
      Vector axis;
      double area = 0.;
    };

    std::optional<Plane>
    plane_of(const std::vector<std::array<Point, 4>> &quads)
    {
      Plane  plane;
      Vector first_moment;
      for (const auto &q : quads)
        {
          Vector normal = 0.5 * twice_area(q);
          if (plane.axis * normal < 0.)
            normal = -normal;
          plane.axis += normal;
          const double area = normal.norm();
          plane.area += area;
          for (const Point &corner : q)
            first_moment += 0.25 * area * corner;
        }
      const double size = plane.axis.norm();
      if (!(size > 0.))
        return {};
      plane.axis /= size;
      plane.centre = Point(first_moment / plane.area);
      // Of the two senses the one with a positive leading component.
      for (unsigned int c = 3; c-- > 0;)
        if (std::abs(plane.axis[c]) > 1e-6)
          {
            if (plane.axis[c] < 0.)
              plane.axis = -plane.axis;
            break;
          }
      for (const auto &q : quads)
        for (const Point &corner : q)
          if (const Vector r = corner - plane.centre;
              !(std::abs(r * plane.axis) <=
                flatness * std::max(r.norm(), std::sqrt(plane.area))))
            return {};
      return plane;
    }

    /** Height of the side of a body that is farthest from the face, within the
     * radii of its ring. */
    double
    other_side(const CoarseMesh  &mesh,
               const unsigned int body,
               const DiscRing    &ring)
    {
      const double margin = 1e-3 * (ring.outer_radius - ring.inner_radius);
      double       result = 0.;
      for (const auto &cell : mesh.cells)
        if (cell.material_id == body)
          for (const unsigned int v : cell.vertices)
            {
              const Point &x = mesh.vertices[v];
              const double r = ring.radius_of(x),
                           h = (x - ring.centre) * ring.directions[2];
              if (r > ring.inner_radius + margin &&
                  r < ring.outer_radius - margin &&
                  std::abs(h) > std::abs(result))
                result = h;
            }
      return result;
    }

    std::optional<DiscRing>
    ring_on_face(const CoarseMesh  &mesh,
                 const unsigned int body,
                 const unsigned int id)
    {
      const auto quads = quads_of(mesh, id);
      const auto plane = plane_of(quads);
      if (!plane)
        return {};
      DiscRing ring;
      ring.centre     = plane->centre;
      ring.directions = directions_about(plane->axis);
      double least = std::numeric_limits<double>::infinity(), largest = 0.;
      for (const auto &q : quads)
        for (const Point &corner : q)
          {
            least   = std::min(least, ring.radius_of(corner));
            largest = std::max(largest, ring.radius_of(corner));
          }
      const double whole = M_PI * (largest * largest - least * least);
      if (!(plane->area >= least_area * whole &&
            plane->area <= largest_area * whole))
        return {};
      ring.inner_radius = least;
      ring.outer_radius = largest;
      ring.other_side   = other_side(mesh, body, ring);
      return ring;
    }

    /** Where pads slide on a body; of two sides the upper one, in whichever
     * order the pairs are. */
    std::optional<DiscRing>
    ring_of_target(const SceneParameters &scene,
                   const CoarseMesh      &mesh,
                   const unsigned int     body)
    {
      std::optional<DiscRing> result;
      for (const auto &contact : scene.contacts)
        if (contact.target_body == scene.bodies[body].name)
          {
            const auto ring = ring_on_face(
              mesh,
              body,
              face_id(mesh, scene, contact.target_body, contact.target_face));
            if (ring && (!result || ring->other_side < ring->face))
              result = ring;
          }
      return result;
    }

    /** Of all faces with names the ring that reaches out farthest; of two such
     * the upper one. */
    std::optional<DiscRing>
    widest_ring(const CoarseMesh &mesh, const unsigned int body)
    {
      std::optional<DiscRing> result;
      for (unsigned int f = 0; f < mesh.face_names[body].size(); ++f)
        if (const auto ring = ring_on_face(mesh, body, face_id(body, f)))
          {
            const double wider =
              result ? ring->outer_radius / result->outer_radius - 1. : 1.;
            if (wider > 1e-6 ||
                (wider > -1e-6 && ring->other_side < ring->face))
              result = ring;
          }
      return result;
    }
  } // namespace



  double
  DiscRing::angle_of(const Point &point) const
  {
    const Vector r = point - centre;
    return std::atan2(r * directions[1], r * directions[0]);
  }

  double
  DiscRing::radius_of(const Point &point) const
  {
    const Vector r = point - centre;
    return std::hypot(r * directions[1], r * directions[0]);
  }

  Point
  DiscRing::point(const double radius,
                  const double angle,
                  const double height) const
  {
    return centre + radius * radial(angle) + height * directions[2];
  }

  Vector
  DiscRing::radial(const double angle) const
  {
    return std::cos(angle) * directions[0] + std::sin(angle) * directions[1];
  }

  Vector
  DiscRing::tangential(const double angle) const
  {
    return -std::sin(angle) * directions[0] + std::cos(angle) * directions[1];
  }



  bool
  contact_face_looks_down(const SceneParameters &scene, const unsigned int body)
  {
    const std::string &name = scene.bodies[body].name;
    for (const auto &contact : scene.contacts)
      for (const auto &[of, face] :
           {std::tie(contact.target_body, contact.target_face),
            std::tie(contact.source_body, contact.source_face)})
        if (of == name && (face == "bottom" || face == "top"))
          return face == "bottom";
    return false;
  }



  std::vector<std::optional<DiscRing>>
  disc_rings(const Discretization &discretization)
  {
    const SceneParameters               &scene = discretization.scene();
    const CoarseMesh                    &mesh  = discretization.coarse_mesh();
    std::vector<std::optional<DiscRing>> rings(scene.bodies.size());
    for (unsigned int b = 0; b < rings.size(); ++b)
      if (scene.bodies[b].shape == BodyParameters::Shape::annulus)
        rings[b] = ring_of_annulus(scene, b);
      else if (scene.bodies[b].has_mesh_file())
        rings[b] = scene.contacts.empty() ? widest_ring(mesh, b)
                                          : ring_of_target(scene, mesh, b);
    return rings;
  }

  unsigned int
  main_disc(const SceneParameters                      &scene,
            const std::vector<std::optional<DiscRing>> &rings)
  {
    // One of a contact, of the first pair that has one.
    for (const auto &contact : scene.contacts)
      {
        unsigned int found = -1u;
        for (const auto &name : {contact.source_body, contact.target_body})
          for (unsigned int b = 0; b < scene.bodies.size(); ++b)
            if (scene.bodies[b].name == name && rings[b])
              found = b;
        if (found != -1u)
          return found;
      }
    for (unsigned int b = 0; b < rings.size(); ++b)
      if (rings[b])
        return b;
    return -1u;
  }
} // namespace squeal
