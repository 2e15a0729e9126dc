// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/number_text.h>
#include <squeal/discretization/disc_ring.h>
#include <squeal/discretization/face_quadrature.h>
#include <squeal/discretization/ring_remarks.h>
#include <squeal/scene/coarse_mesh.h>

#include <deal.II/base/geometry_info.h>

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
    /** The same of a face that may be meant as a ring. */
    constexpr double nearly_a_ring = 0.8;
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
    std::vector<Point>
    corners_of(const CoarseMesh &mesh, const unsigned int id)
    {
      std::vector<Point> corners;
      for (const auto &face : mesh.boundary.boundary_quads)
        if (face.boundary_id == id)
          for (const unsigned int v : face.vertices)
            corners.push_back(mesh.vertices[v]);
      return corners;
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

    /** Axis and centre of a flat face, and its area as its cells are curved;
     * none where it is not flat. */
    struct Plane
    {
      Point  centre;
      Vector axis;
      double area = 0.;
    };

    std::optional<Plane>
    plane_of(const Discretization     &d,
             const unsigned int        id,
             const std::vector<Point> &corners)
    {
      if (corners.empty())
        return {};
      const FaceQuadrature face = face_quadrature(d, id);
      Plane plane{face.centre(), face.normal(), face.total_area()};
      // Of the two senses the one with a positive leading component.
      for (unsigned int c = 3; c-- > 0;)
        if (std::abs(plane.axis[c]) > 1e-6)
          {
            if (plane.axis[c] < 0.)
              plane.axis = -plane.axis;
            break;
          }
      for (const auto *points : {&corners, &face.points})
        for (const Point &point : *points)
          if (const Vector r = point - plane.centre;
              !(std::abs(r * plane.axis) <=
                flatness * std::max(r.norm(), std::sqrt(plane.area))))
            return {};
      return plane;
    }

    /** Height of the side of a body that is farthest from the face, within the
     * radii of its ring: of the corners there, and where one cell goes across
     * the ring, of the middles of its edges. */
    double
    other_side(const CoarseMesh  &mesh,
               const unsigned int body,
               const DiscRing    &ring)
    {
      const double margin  = 1e-3 * (ring.outer_radius - ring.inner_radius);
      double       corners = 0., middles = 0.;
      const auto   take = [&](const Point &x, double &farthest) {
        const double r = ring.radius_of(x),
                     h = (x - ring.centre) * ring.directions[2];
        if (r > ring.inner_radius + margin && r < ring.outer_radius - margin &&
            std::abs(h) > std::abs(farthest))
          farthest = h;
      };
      using Info = dealii::GeometryInfo<3>;
      for (const auto &cell : mesh.cells)
        if (cell.material_id == body)
          {
            const auto corner = [&](const unsigned int v) {
              return mesh.vertices[cell.vertices[v]];
            };
            for (const unsigned int v : Info::vertex_indices())
              take(corner(v), corners);
            for (unsigned int l = 0; l < Info::lines_per_cell; ++l)
              take(corner(Info::line_to_cell_vertices(l, 0)) +
                     0.5 * (corner(Info::line_to_cell_vertices(l, 1)) -
                            corner(Info::line_to_cell_vertices(l, 0))),
                   middles);
          }
      return std::abs(corners) > flatness * ring.outer_radius ? corners
                                                              : middles;
    }

    /** A flat face as a ring, and how much of the ring between its radii it
     * covers; none where it is not flat. */
    struct CoveredRing
    {
      DiscRing ring;
      double   share = 0.;

      bool
      is_whole() const
      {
        return share >= least_area && share <= largest_area;
      }
    };

    std::optional<CoveredRing>
    covered_ring(const Discretization &d,
                 const unsigned int    body,
                 const unsigned int    id)
    {
      const std::vector<Point> corners = corners_of(d.coarse_mesh(), id);
      const auto               plane   = plane_of(d, id, corners);
      if (!plane)
        return {};
      DiscRing ring;
      ring.centre     = plane->centre;
      ring.directions = directions_about(plane->axis);
      double least = std::numeric_limits<double>::infinity(), largest = 0.;
      for (const Point &corner : corners)
        {
          least   = std::min(least, ring.radius_of(corner));
          largest = std::max(largest, ring.radius_of(corner));
        }
      ring.inner_radius = least;
      ring.outer_radius = largest;
      ring.other_side   = other_side(d.coarse_mesh(), body, ring);
      return CoveredRing{
        ring, plane->area / (M_PI * (largest * largest - least * least))};
    }

    std::optional<DiscRing>
    ring_on_face(const Discretization &d,
                 const unsigned int    body,
                 const unsigned int    id)
    {
      const auto covered = covered_ring(d, body, id);
      return covered && covered->is_whole() ? covered->ring
                                            : std::optional<DiscRing>();
    }

    /** Faces of an imported body that may be the ring of a disc: those that
     * pads slide on, without a contact any that has a name. */
    std::vector<unsigned int>
    faces_for_rings(const SceneParameters &scene,
                    const CoarseMesh      &mesh,
                    const unsigned int     body)
    {
      std::vector<unsigned int> faces;
      for (const auto &contact : scene.contacts)
        if (contact.target_body == scene.bodies[body].name)
          faces.push_back(
            face_id(mesh, scene, contact.target_body, contact.target_face));
      if (scene.contacts.empty())
        for (unsigned int f = 0; f < mesh.face_names[body].size(); ++f)
          faces.push_back(face_id(body, f));
      return faces;
    }

    /** Where pads slide on a body; of two sides the upper one, in whichever
     * order the pairs are. */
    std::optional<DiscRing>
    ring_of_target(const Discretization            &d,
                   const unsigned int               body,
                   const std::vector<unsigned int> &faces)
    {
      std::optional<DiscRing> result;
      for (const unsigned int id : faces)
        {
          const auto ring = ring_on_face(d, body, id);
          if (ring && (!result || ring->other_side < ring->face))
            result = ring;
        }
      return result;
    }

    /** The ring that reaches out farthest; of two such the upper one. */
    std::optional<DiscRing>
    widest_ring(const Discretization            &d,
                const unsigned int               body,
                const std::vector<unsigned int> &faces)
    {
      std::optional<DiscRing> result;
      for (const unsigned int id : faces)
        if (const auto ring = ring_on_face(d, body, id))
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
    std::vector<std::optional<DiscRing>> rings(scene.bodies.size());
    for (unsigned int b = 0; b < rings.size(); ++b)
      if (scene.bodies[b].shape == BodyParameters::Shape::annulus)
        rings[b] = ring_of_annulus(scene, b);
      else if (scene.bodies[b].has_mesh_file())
        {
          const auto faces =
            faces_for_rings(scene, discretization.coarse_mesh(), b);
          rings[b] = scene.contacts.empty()
                       ? widest_ring(discretization, b, faces)
                       : ring_of_target(discretization, b, faces);
        }
    return rings;
  }

  std::vector<std::string>
  remarks_on_rings(const Discretization &discretization)
  {
    const SceneParameters   &scene = discretization.scene();
    const CoarseMesh        &mesh  = discretization.coarse_mesh();
    const auto               rings = disc_rings(discretization);
    std::vector<std::string> remarks;
    for (unsigned int b = 0; b < rings.size(); ++b)
      if (scene.bodies[b].has_mesh_file() && !rings[b])
        for (const unsigned int id : faces_for_rings(scene, mesh, b))
          if (const auto covered = covered_ring(discretization, b, id);
              covered && covered->share >= nearly_a_ring &&
              covered->share < least_area)
            remarks.push_back(
              "body '" + scene.bodies[b].name + "': its face '" +
              mesh.face_names[b][id - face_id(b, 0)] + "' covers " +
              rounded_text(100. * covered->share, 3) +
              " % of a flat ring, too little for a disc: its modes have no "
              "nodal diameters in their names");
    return remarks;
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
