// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/contact/contact_geometry.h>
#include <squeal/discretization/face_quadrature.h>

#include <cmath>

namespace squeal
{
  namespace
  {
    using Point = dealii::Point<3>;
    using Row   = Functionals::Row;

    /** Grid over the bounding box of the source face, edges included; points
     * beside a face that is no rectangle are left out. */
    std::vector<Point>
    grid_points(const FaceQuadrature    &face,
                const CoarseMesh        &mesh,
                const unsigned int       id,
                const ContactParameters &contact)
    {
      double lower[2] = {1e300, 1e300}, upper[2] = {-1e300, -1e300};
      for (const auto &quad : mesh.boundary.boundary_quads)
        if (quad.boundary_id == id)
          for (const unsigned int v : quad.vertices)
            for (unsigned int c = 0; c < 2; ++c)
              {
                lower[c] = std::min(lower[c], mesh.vertices[v][c]);
                upper[c] = std::max(upper[c], mesh.vertices[v][c]);
              }
      const double       z = face.centre()[2];
      std::vector<Point> points;
      const auto coordinate = [&](const unsigned int c, const unsigned int i) {
        const unsigned int n = contact.grid[c];
        return n == 1 ? 0.5 * (lower[c] + upper[c])
                      : lower[c] + (upper[c] - lower[c]) * i / (n - 1.);
      };
      for (unsigned int i = 0; i < contact.grid[0]; ++i)
        for (unsigned int j = 0; j < contact.grid[1]; ++j)
          points.emplace_back(coordinate(0, i), coordinate(1, j), z);
      return points;
    }

    void
    keep_found(ContactGeometry &geometry, PointEvaluator::Result &source)
    {
      std::size_t n = 0;
      for (std::size_t i = 0; i < geometry.points.size(); ++i)
        if (source.found[i])
          {
            geometry.points[n] = geometry.points[i];
            source.rows[n]     = source.rows[i];
            ++n;
          }
      geometry.points.resize(n);
      source.rows.resize(n);
    }
  } // namespace



  void
  slip_directions(const SceneParameters              &scene,
                  const ContactParameters            &contact,
                  const std::vector<Point>           &points,
                  std::vector<std::array<double, 2>> &direction,
                  std::vector<double>                &speed_ratio)
  {
    direction.assign(points.size(), {{0., 1.}});
    speed_ratio.assign(points.size(), 1.);
    if (contact.friction_direction !=
          ContactParameters::FrictionDirection::slip ||
        contact.target_body == "ground")
      return;
    const auto &axis =
      scene.bodies[body_index(scene, contact.target_body)].position;
    double mean = 0.;
    for (const auto &x : points)
      mean += std::hypot(x[0] - axis[0], x[1] - axis[1]) / points.size();
    for (std::size_t i = 0; i < points.size(); ++i)
      {
        const double dx = points[i][0] - axis[0], dy = points[i][1] - axis[1];
        const double r = std::hypot(dx, dy);
        if (r == 0.)
          throw InputError("Scene/Contact " + contact.name +
                           ": a contact point lies on the disc axis, where "
                           "there is no sliding direction");
        direction[i]   = {{-dy / r, dx / r}};
        speed_ratio[i] = r / mean;
      }
  }



  ContactGeometry
  make_contact_geometry(const Discretization    &d,
                        const PointEvaluator    &evaluator,
                        const ContactParameters &contact)
  {
    const auto        &scene  = d.scene();
    const unsigned int source = body_index(scene, contact.source_body);
    const std::string  where  = "Scene/Contact " + contact.name;
    ContactGeometry    g;
    if (scene.bodies[source].shape == BodyParameters::Shape::rigid)
      {
        const auto &x = scene.bodies[source].position;
        const auto &p = contact.contact_point;
        g.points      = {Point(x[0] + p[0], x[1] + p[1], x[2] + p[2])};
        g.areas       = {1.};
      }
    else
      {
        const unsigned int id = face_id(
          d.coarse_mesh(), scene, contact.source_body, contact.source_face);
        const FaceQuadrature face = face_quadrature(d, id);
        if (contact.layout == ContactParameters::SpringLayout::quadrature)
          {
            g.points = face.points;
            g.areas  = face.areas;
          }
        else
          {
            g.points = grid_points(face, d.coarse_mesh(), id, contact);
            g.areas.assign(g.points.size(),
                           face.total_area() / g.points.size());
          }
      }

    auto source_side = evaluator.displacements(source, g.points, 1e-4);
    keep_found(g, source_side);
    if (g.points.empty())
      throw InputError(where + "/Grid: no contact point lies on face '" +
                       contact.source_face + "'");
    g.source_rows = source_side.rows;
    g.target_rows.resize(g.points.size());
    if (contact.target_body != "ground")
      {
        const auto target = evaluator.displacements(
          body_index(scene, contact.target_body), g.points, 1e-4);
        for (std::size_t i = 0; i < g.points.size(); ++i)
          if (!target.found[i])
            throw InputError(where + ": the faces do not meet at (" +
                             std::to_string(g.points[i][0]) + ", " +
                             std::to_string(g.points[i][1]) + ", " +
                             std::to_string(g.points[i][2]) + ") m: body '" +
                             contact.source_body + "' is outside '" +
                             contact.target_body + "'");
        g.target_rows = target.rows;
      }

    slip_directions(scene, contact, g.points, g.slip_direction, g.speed_ratio);
    std::vector<Row> normal, tangential, transverse;
    for (std::size_t i = 0; i < g.points.size(); ++i)
      {
        const auto &[tx, ty] = g.slip_direction[i];
        const auto &s        = g.source_rows[i];
        const auto &t        = g.target_rows[i];
        normal.push_back(combine({{1., &t[2]}, {-1., &s[2]}}));
        tangential.push_back(
          combine({{tx, &t[0]}, {ty, &t[1]}, {-tx, &s[0]}, {-ty, &s[1]}}));
        transverse.push_back(
          combine({{ty, &t[0]}, {-tx, &t[1]}, {-ty, &s[0]}, {tx, &s[1]}}));
      }
    g.normal = std::make_shared<Functionals>(d.space(), std::move(normal));
    g.tangential =
      std::make_shared<Functionals>(d.space(), std::move(tangential));
    g.transverse =
      std::make_shared<Functionals>(d.space(), std::move(transverse));
    return g;
  }



  ContactState
  uniform_state(const ContactGeometry &geometry, const ContactStatus status)
  {
    const std::size_t n = geometry.points.size();
    return {std::vector<ContactStatus>(n, status),
            std::vector<double>(n, 1. / n)};
  }
} // namespace squeal
