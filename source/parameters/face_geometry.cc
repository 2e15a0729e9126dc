// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/unknown_choice.h>
#include <squeal/parameters/face_geometry.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace squeal
{
  namespace prm
  {
    namespace
    {
      using Shape = BodyParameters::Shape;

      const double relative_tolerance = 1e-6;

      const char *const axis_names[] = {"x", "y", "z"};

      /** A length for a message: eight digits show a gap of 1e-6. */
      std::string
      shown(const double length)
      {
        std::ostringstream text;
        text << std::setprecision(8) << length;
        return text.str();
      }



      double
      tolerance(const FlatFace &a, const FlatFace &b)
      {
        return relative_tolerance * std::max(a.body_size, b.body_size);
      }



      /** Smallest and largest distance of the points of @p face from
       * @p centre in its plane. */
      std::array<double, 2>
      distances(const FlatFace &face, const std::array<double, 2> &centre)
      {
        if (face.is_round)
          {
            const double d = std::hypot(face.centre[0] - centre[0],
                                        face.centre[1] - centre[1]);
            return {
              {std::max({0., d - face.outer_radius, face.inner_radius - d}),
               d + face.outer_radius}};
          }
        std::array<double, 2> nearest, farthest;
        for (unsigned int i = 0; i < 2; ++i)
          {
            const double below = centre[i] - face.lower[i];
            const double above = face.upper[i] - centre[i];
            nearest[i]         = std::max({0., -below, -above});
            farthest[i]        = std::max(std::abs(below), std::abs(above));
          }
        return {{std::hypot(nearest[0], nearest[1]),
                 std::hypot(farthest[0], farthest[1])}};
      }



      bool
      boxes_overlap(const FlatFace &a, const FlatFace &b)
      {
        for (unsigned int i = 0; i < 2; ++i)
          if (a.upper[i] <= b.lower[i] || b.upper[i] <= a.lower[i])
            return false;
        return true;
      }
    } // namespace



    std::vector<std::string>
    faces_of(const Shape shape)
    {
      switch (shape)
        {
        case Shape::annulus:
          return {"inner", "outer", "bottom", "top"};
        case Shape::block:
          return {"x_min", "x_max", "y_min", "y_max", "z_min", "z_max"};
        case Shape::cylinder:
          return {"side", "bottom", "top"};
        case Shape::layer:
          return {"outer", "sides"};
        case Shape::gmsh:
        case Shape::abaqus:
        case Shape::nastran:
        case Shape::rigid:
          return {};
        }
      unknown_choice("shape");
    }



    double
    Box::size() const
    {
      return std::max(
        {upper[0] - lower[0], upper[1] - lower[1], upper[2] - lower[2]});
    }



    bool
    turns_about_own_axis(const BodyParameters &round)
    {
      const Vector3 &centre = round.centre_of_rotation();
      return centre[0] == round.position[0] && centre[1] == round.position[1];
    }



    std::optional<Box>
    box_of(const BodyParameters &body)
    {
      if (body.has_mesh_file() || body.shape == Shape::rigid ||
          body.shape == Shape::layer ||
          (body.angle != 0. &&
           (body.shape == Shape::block || !turns_about_own_axis(body))))
        return {};
      const Vector3 extent =
        body.shape == Shape::block
          ? body.size
          : Vector3{
              {2. * body.outer_radius, 2. * body.outer_radius, body.height}};
      Box box;
      for (unsigned int i = 0; i < 3; ++i)
        {
          box.lower[i] = body.position[i] - (i < 2 ? 0.5 * extent[i] : 0.);
          box.upper[i] = box.lower[i] + extent[i];
        }
      return box;
    }



    std::optional<FlatFace>
    flat_face(const BodyParameters &body, const std::string &name)
    {
      const std::optional<Box> box = box_of(body);
      if (!box || name.empty())
        return {};

      FlatFace face;
      face.is_round = body.shape != Shape::block;
      if (face.is_round && name != "top" && name != "bottom")
        return {};
      face.axis = face.is_round ? 2 : static_cast<unsigned int>(name[0] - 'x');
      face.sign = name == "top" || name.substr(1) == "_max" ? 1 : -1;
      face.position =
        face.sign > 0 ? box->upper[face.axis] : box->lower[face.axis];
      for (unsigned int i = 0, k = 0; i < 3; ++i)
        if (i != face.axis)
          {
            face.lower[k]  = box->lower[i];
            face.upper[k]  = box->upper[i];
            face.centre[k] = 0.5 * (box->lower[i] + box->upper[i]);
            ++k;
          }
      face.inner_radius = body.shape == Shape::annulus ? body.inner_radius : 0.;
      face.outer_radius = body.outer_radius;
      face.body_size    = box->size();
      return face;
    }



    std::string
    fault_of_touching(const FlatFace &source, const FlatFace &target)
    {
      if (source.axis != target.axis)
        return "the source face is normal to " +
               std::string(axis_names[source.axis]) + ", the target face to " +
               axis_names[target.axis];
      if (source.sign == target.sign)
        return "both faces look along " +
               std::string(source.sign > 0 ? "+" : "-") +
               axis_names[source.axis];
      if (!(std::abs(source.position - target.position) <=
            tolerance(source, target)))
        return "the source face is at " + std::string(axis_names[source.axis]) +
               " = " + shown(source.position) + " m, the target face at " +
               axis_names[source.axis] + " = " + shown(target.position) + " m";

      const FlatFace &ring  = target.is_round ? target : source;
      const FlatFace &other = target.is_round ? source : target;
      const auto      range = distances(other, ring.centre);
      if (!boxes_overlap(source, target) ||
          (ring.is_round &&
           (range[0] >= ring.outer_radius || range[1] <= ring.inner_radius)))
        return "they lie side by side in their plane";
      return "";
    }



    std::string
    fault_of_footprint(const FlatFace &source, const FlatFace &target)
    {
      const double slack = tolerance(source, target);
      if (target.is_round)
        {
          const auto range = distances(source, target.centre);
          if (range[0] < target.inner_radius - slack ||
              range[1] > target.outer_radius + slack)
            return "the source face reaches from radius " + shown(range[0]) +
                   " to " + shown(range[1]) + " m, the target face only from " +
                   shown(target.inner_radius) + " to " +
                   shown(target.outer_radius) + " m";
          return "";
        }
      for (unsigned int i = 0; i < 2; ++i)
        if (source.lower[i] < target.lower[i] - slack ||
            source.upper[i] > target.upper[i] + slack)
          {
            const unsigned int axis = i + (i >= target.axis ? 1 : 0);
            return "the source face reaches from " +
                   std::string(axis_names[axis]) + " = " +
                   shown(source.lower[i]) + " to " + shown(source.upper[i]) +
                   " m, the target face only from " + shown(target.lower[i]) +
                   " to " + shown(target.upper[i]) + " m";
          }
      return "";
    }
  } // namespace prm
} // namespace squeal
