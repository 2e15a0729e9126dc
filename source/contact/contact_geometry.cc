// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/base/number_text.h>
#include <squeal/contact/contact_geometry.h>
#include <squeal/discretization/face_quadrature.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace squeal
{
  namespace
  {
    using Point = dealii::Point<3>;
    using Row   = Functionals::Row;

    /** The rectangle along x and y around a face. m */
    struct FaceBox
    {
      double lower[2] = {1e300, 1e300}, upper[2] = {-1e300, -1e300};

      double
      area() const
      {
        return (upper[0] - lower[0]) * (upper[1] - lower[1]);
      }
    };

    FaceBox
    box_of_face(const CoarseMesh &mesh, const unsigned int id)
    {
      FaceBox box;
      for (const auto &quad : mesh.boundary.boundary_quads)
        if (quad.boundary_id == id)
          for (const unsigned int v : quad.vertices)
            for (unsigned int c = 0; c < 2; ++c)
              {
                box.lower[c] = std::min(box.lower[c], mesh.vertices[v][c]);
                box.upper[c] = std::max(box.upper[c], mesh.vertices[v][c]);
              }
      return box;
    }

    /** Grid over the box of the source face, edges included. */
    std::vector<Point>
    grid_points(const FaceQuadrature    &face,
                const FaceBox           &box,
                const ContactParameters &contact)
    {
      const double       z = face.centre()[2];
      std::vector<Point> points;
      const auto coordinate = [&](const unsigned int c, const unsigned int i) {
        const unsigned int n = contact.grid[c];
        return n == 1
                 ? 0.5 * (box.lower[c] + box.upper[c])
                 : box.lower[c] + (box.upper[c] - box.lower[c]) * i / (n - 1.);
      };
      for (unsigned int i = 0; i < contact.grid[0]; ++i)
        for (unsigned int j = 0; j < contact.grid[1]; ++j)
          points.emplace_back(coordinate(0, i), coordinate(1, j), z);
      return points;
    }

    /** Share of its box by which the area of a rectangle may be off: rounded
     * coordinates of a mesh file. */
    constexpr double area_tolerance = 1e-3;

    /** Refuses a grid some of whose points lie beside the face: the springs of
     * those would be lost. A single spring at the middle is one anywhere. */
    void
    check_grid_stands_on_face(const ContactParameters &contact,
                              const FaceQuadrature    &face,
                              const FaceBox           &box,
                              const std::vector<bool> &found)
    {
      const std::size_t n_found = std::count(found.begin(), found.end(), true);
      const bool        is_rectangle =
        std::abs(face.total_area() - box.area()) <= area_tolerance * box.area();
      if (n_found == found.size() && (is_rectangle || found.size() == 1))
        return;
      std::ostringstream per_area;
      per_area << std::setprecision(4)
               << found.size() * contact.normal_stiffness / face.total_area();
      throw InputError(
        "Scene/Contact " + contact.name +
        "/Spring layout: grid needs a rectangular source face with its edges "
        "along x and y, and '" +
        contact.source_face + "' of body '" + contact.source_body +
        "' is none (" + std::to_string(n_found) + " of " +
        std::to_string(found.size()) +
        " points lie on it): set 'Spring layout = quadrature' and 'Normal "
        "stiffness per area = " +
        per_area.str() +
        "' N/m^3, which in all is as stiff, or 'Formulation = mortar'");
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



  namespace
  {
    /** Points, areas and rows of the source side of @p contact. */
    void
    place_points(const Discretization    &d,
                 const PointEvaluator    &evaluator,
                 const ContactParameters &contact,
                 ContactGeometry         &g)
    {
      const auto        &scene  = d.scene();
      const unsigned int source = body_index(scene, contact.source_body);
      if (scene.bodies[source].shape == BodyParameters::Shape::rigid)
        {
          const auto &x = scene.bodies[source].position;
          const auto &p = contact.contact_point;
          g.points      = {Point(x[0] + p[0], x[1] + p[1], x[2] + p[2])};
          g.areas       = {1.};
          g.source_rows = evaluator.displacements(source, g.points, 1e-4).rows;
          return;
        }
      const unsigned int id = face_id(
        d.coarse_mesh(), scene, contact.source_body, contact.source_face);
      const FaceQuadrature face = face_quadrature(d, id);
      const FaceBox        box  = box_of_face(d.coarse_mesh(), id);
      const bool           is_grid =
        contact.layout == ContactParameters::SpringLayout::grid;
      g.points = is_grid ? grid_points(face, box, contact) : face.points;
      g.areas  = face.areas;
      if (is_grid)
        g.areas.assign(g.points.size(), face.total_area() / g.points.size());
      const auto side = evaluator.displacements(source, g.points, 1e-4);
      if (is_grid)
        check_grid_stands_on_face(contact, face, box, side.found);
      else if (std::count(side.found.begin(), side.found.end(), false) > 0)
        throw InputError("Scene/Contact " + contact.name +
                         ": points of the source face lie outside body '" +
                         contact.source_body + "'");
      g.source_rows = side.rows;
    }
  } // namespace



  ContactGeometry
  make_contact_geometry(const Discretization    &d,
                        const PointEvaluator    &evaluator,
                        const ContactParameters &contact)
  {
    const auto       &scene = d.scene();
    const std::string where = "Scene/Contact " + contact.name;
    ContactGeometry   g;
    place_points(d, evaluator, contact, g);
    g.target_rows.resize(g.points.size());
    if (contact.target_body != "ground")
      {
        const auto target = evaluator.displacements(
          body_index(scene, contact.target_body), g.points, 1e-4);
        for (std::size_t i = 0; i < g.points.size(); ++i)
          if (!target.found[i])
            throw InputError(where + ": the faces do not meet at (" +
                             rounded_text(g.points[i][0], 6) + ", " +
                             rounded_text(g.points[i][1], 6) + ", " +
                             rounded_text(g.points[i][2], 6) + ") m: body '" +
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
