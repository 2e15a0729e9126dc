// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/base/number_text.h>
#include <squeal/contact/contact_geometry.h>
#include <squeal/discretization/face_quadrature.h>
#include <squeal/scene/turning.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <numeric>
#include <sstream>

namespace squeal
{
  namespace
  {
    using Point = dealii::Point<3>;
    using Row   = Functionals::Row;

    /** The rectangle around a flat face, along two directions in its plane. m
     */
    struct FaceBox
    {
      dealii::Tensor<1, 3> axis[2];
      double lower[2] = {1e300, 1e300}, upper[2] = {-1e300, -1e300};

      double
      area() const
      {
        return (upper[0] - lower[0]) * (upper[1] - lower[1]);
      }
    };

    /** The directions of a grid on a face with the unit @p normal: those of the
     * coordinate axes that lie in it, else those of its first edge, the one
     * that is nearer to x, then y, in front. */
    void
    set_axes(const dealii::Tensor<1, 3> &normal,
             const dealii::Tensor<1, 3> &edge,
             FaceBox                    &box)
    {
      unsigned int n_axes = 0;
      for (unsigned int c = 0; c < 3; ++c)
        if (std::abs(normal[c]) < 1e-12 && n_axes < 2)
          box.axis[n_axes++][c] = 1.;
      if (n_axes == 2)
        return;
      box.axis[0]      = edge / edge.norm();
      box.axis[1]      = dealii::cross_product_3d(normal, box.axis[0]);
      const auto order = [&](const unsigned int k) {
        return std::make_pair(std::abs(box.axis[k][0]),
                              std::abs(box.axis[k][1]));
      };
      if (order(1) > order(0))
        std::swap(box.axis[0], box.axis[1]);
    }

    FaceBox
    box_of_face(const CoarseMesh           &mesh,
                const unsigned int          id,
                const dealii::Tensor<1, 3> &normal)
    {
      FaceBox box;
      bool    has_axes = false;
      for (const auto &quad : mesh.boundary.boundary_quads)
        if (quad.boundary_id == id)
          {
            if (!has_axes)
              set_axes(normal,
                       mesh.vertices[quad.vertices[1]] -
                         mesh.vertices[quad.vertices[0]],
                       box);
            has_axes = true;
            for (const unsigned int v : quad.vertices)
              for (unsigned int c = 0; c < 2; ++c)
                {
                  const double x = mesh.vertices[v] * box.axis[c];
                  box.lower[c]   = std::min(box.lower[c], x);
                  box.upper[c]   = std::max(box.upper[c], x);
                }
          }
      return box;
    }

    /** Grid over the box of the source face, edges included. */
    std::vector<Point>
    grid_points(const FaceQuadrature    &face,
                const FaceBox           &box,
                const ContactParameters &contact)
    {
      const auto         normal = face.normal();
      const Point        origin(normal * (face.centre() * normal));
      std::vector<Point> points;
      const auto coordinate = [&](const unsigned int c, const unsigned int i) {
        const unsigned int n = contact.grid[c];
        return n == 1
                 ? 0.5 * (box.lower[c] + box.upper[c])
                 : box.lower[c] + (box.upper[c] - box.lower[c]) * i / (n - 1.);
      };
      for (unsigned int i = 0; i < contact.grid[0]; ++i)
        for (unsigned int j = 0; j < contact.grid[1]; ++j)
          points.push_back(origin + coordinate(0, i) * box.axis[0] +
                           coordinate(1, j) * box.axis[1]);
      return points;
    }

    /** The meshes of the grid between those points. */
    std::vector<std::array<unsigned int, 4>>
    grid_quads(const ContactParameters &contact)
    {
      std::vector<std::array<unsigned int, 4>> quads;
      const unsigned int                       n = contact.grid[1];
      for (unsigned int i = 0; i + 1 < contact.grid[0]; ++i)
        for (unsigned int j = 0; j + 1 < n; ++j)
          {
            const unsigned int first = n * i + j;
            quads.push_back({{first, first + n, first + n + 1, first + 1}});
          }
      return quads;
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
        "/Spring layout: grid needs a flat rectangular source face, its edges "
        "along the coordinate axes if the normal is along one, and '" +
        contact.source_face + "' of body '" + contact.source_body +
        "' is none (" + std::to_string(n_found) + " of " +
        std::to_string(found.size()) +
        " points lie on it): set 'Spring layout = quadrature' and 'Normal "
        "stiffness per area = " +
        per_area.str() +
        "' N/m^3, which in all is as stiff, or 'Formulation = mortar'");
    }
  } // namespace



  namespace
  {
    /** Points, areas and rows of the source side of @p contact. Returns the
     * outward normals of the source; a rigid one looks down by definition. */
    std::vector<dealii::Tensor<1, 3>>
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
          g.points      = {turned_point(scene.bodies[source],
                                   {x[0] + p[0], x[1] + p[1], x[2] + p[2]})};
          g.areas       = {1.};
          g.source_rows = evaluator.displacements(source, g.points, 1e-4).rows;
          return {Point(0., 0., -1.)};
        }
      const unsigned int id = face_id(
        d.coarse_mesh(), scene, contact.source_body, contact.source_face);
      const FaceQuadrature face = face_quadrature(d, id);
      const FaceBox box = box_of_face(d.coarse_mesh(), id, face.normal());
      const bool    is_grid =
        contact.layout == ContactParameters::SpringLayout::grid;
      g.points = is_grid ? grid_points(face, box, contact) : face.points;
      g.areas  = face.areas;
      if (is_grid)
        {
          g.areas.assign(g.points.size(), face.total_area() / g.points.size());
          g.quads = grid_quads(contact);
        }
      const auto side = evaluator.displacements(source, g.points, 1e-4);
      if (is_grid)
        check_grid_stands_on_face(contact, face, box, side.found);
      else if (std::count(side.found.begin(), side.found.end(), false) > 0)
        throw InputError("Scene/Contact " + contact.name +
                         ": points of the source face lie outside body '" +
                         contact.source_body + "'");
      g.source_rows = side.rows;
      if (is_grid)
        return std::vector<dealii::Tensor<1, 3>>(g.points.size(),
                                                 face.normal());
      return face.normals;
    }
  } // namespace



  void
  set_frames(const Discretization                    &d,
             const ContactParameters                 &contact,
             const std::vector<dealii::Tensor<1, 3>> &source_normals,
             ContactGeometry                         &g)
  {
    const ContactFrames all =
      contact_frames(d, contact, g.points, source_normals);
    g.frames      = all.frames;
    g.speed_ratio = all.speed_ratio;
    std::vector<Row> normal, tangential, transverse;
    for (std::size_t i = 0; i < g.points.size(); ++i)
      {
        const auto along = [&](const dealii::Tensor<1, 3> &direction) {
          std::vector<std::pair<double, const Row *>> parts;
          for (unsigned int c = 0; c < 3; ++c)
            if (direction[c] != 0.)
              {
                parts.emplace_back(direction[c], &g.target_rows[i][c]);
                parts.emplace_back(-direction[c], &g.source_rows[i][c]);
              }
          return combine(parts);
        };
        normal.push_back(along(g.frames[i].normal));
        tangential.push_back(along(g.frames[i].sliding));
        transverse.push_back(along(g.frames[i].transverse));
      }
    g.normal = std::make_shared<Functionals>(d.space(), std::move(normal));
    g.tangential =
      std::make_shared<Functionals>(d.space(), std::move(tangential));
    g.transverse =
      std::make_shared<Functionals>(d.space(), std::move(transverse));
  }



  ContactGeometry
  make_contact_geometry(const Discretization    &d,
                        const PointEvaluator    &evaluator,
                        const ContactParameters &contact)
  {
    const auto       &scene = d.scene();
    const std::string where = "Scene/Contact " + contact.name;
    ContactGeometry   g;
    const auto        normals = place_points(d, evaluator, contact, g);
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

    set_frames(d, contact, normals, g);
    return g;
  }



  Functionals
  relative_motion(const std::vector<ContactGeometry> &contacts)
  {
    Assert(!contacts.empty(), dealii::ExcInternalError());
    std::vector<Row> rows;
    for (const ContactGeometry &g : contacts)
      for (std::size_t j = 0; j < g.points.size(); ++j)
        for (const auto &part : {g.normal, g.tangential, g.transverse})
          rows.push_back(part->rows()[j]);
    return Functionals(contacts.back().normal->space_pointer(),
                       std::move(rows));
  }



  ContactState
  uniform_state(const ContactGeometry &geometry, const ContactStatus status)
  {
    const auto  &areas = geometry.areas;
    const double total = std::accumulate(areas.begin(), areas.end(), 0.);
    ContactState state{std::vector<ContactStatus>(areas.size(), status), {}};
    for (const double area : areas)
      state.force_share.push_back(area / total);
    return state;
  }
} // namespace squeal
