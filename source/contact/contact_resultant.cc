// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/contact/contact_resultant.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace squeal
{
  namespace
  {
    using Vector = dealii::Tensor<1, 3>;

    constexpr double not_known = std::numeric_limits<double>::quiet_NaN();

    /** Below this length of the mean of unit normals a face looks to no side:
     * half a cylinder has 0.64. */
    constexpr double least_side = 0.5;

    /** Below this length of the mean of unit vectors there is no common
     * direction: a pad all round the axis. */
    constexpr double least_direction = 1e-6;

    /** Components below this part of a unit vector are rounding: they must not
     * mix friction into the force across it. */
    constexpr double least_component = 1e-12;

    /** A normal this close to an axis of the scene is along it: of rounded
     * coordinates in mesh files. */
    constexpr double all_but_along = 1e-3;

    /** Sliding this close to an axis of the scene, by the cosine, takes it for
     * its own: 30 degrees. */
    constexpr double near_axis = 0.866;

    Vector
    direction_of(Vector v)
    {
      const double size = v.norm();
      for (unsigned int c = 0; c < 3; ++c)
        if (std::abs(v[c]) < least_component * size)
          v[c] = 0.;
      return v / v.norm();
    }

    /** Means over the face, by areas. */
    struct MeanDirections
    {
      explicit MeanDirections(const ContactGeometry &g)
      {
        double area = 0.;
        for (std::size_t j = 0; j < g.points.size(); ++j)
          {
            area += g.areas[j];
            normal += g.areas[j] * g.frames[j].normal;
            sliding += g.areas[j] * g.frames[j].sliding;
          }
        normal /= area;
        sliding /= area;
      }

      Vector normal, sliding; /**< at most 1 long */
    };

    /** The axis of the scene, with its sign, that @p v is nearest to. */
    Vector
    nearest_axis(const Vector &v)
    {
      unsigned int largest = 0;
      for (unsigned int c = 1; c < 3; ++c)
        if (std::abs(v[c]) > std::abs(v[largest]))
          largest = c;
      Vector axis;
      axis[largest] = v[largest] < 0. ? -1. : 1.;
      return axis;
    }

    /** What a force along the unit vector @p a has along @p b. */
    double
    component(const Vector &a, const Vector &b)
    {
      const double c = a * b;
      return std::abs(c) < least_component ? 0. : c;
    }

    /** The part of the coordinate axis y, or x, that lies across @p normal. */
    Vector
    some_direction(const Vector &normal)
    {
      Vector axis;
      axis[std::abs(normal[1]) < 0.9 ? 1 : 0] = 1.;
      return direction_of(axis - (axis * normal) * normal);
    }

    /** @p v turned as the shortest turn takes @p from to @p to, unit vectors
     * that are not opposite. */
    Vector
    turned(const Vector &v, const Vector &from, const Vector &to)
    {
      const Vector axis = dealii::cross_product_3d(from, to);
      if (!(axis.norm() > least_component))
        return v;
      return v + dealii::cross_product_3d(axis, v) +
             dealii::cross_product_3d(axis, dealii::cross_product_3d(axis, v)) /
               (1. + from * to);
    }
  } // namespace



  ContactFrame
  mean_frame(const ContactGeometry &g)
  {
    const MeanDirections mean(g);
    ContactFrame         frame;
    // A ring all round has no side that it looks to.
    frame.normal = mean.normal.norm() > least_direction
                     ? direction_of(mean.normal)
                     : g.frames[0].normal;
    const Vector sliding =
      mean.sliding - (mean.sliding * frame.normal) * frame.normal;
    frame.sliding    = sliding.norm() > least_direction
                         ? direction_of(sliding)
                         : some_direction(frame.normal);
    frame.transverse = dealii::cross_product_3d(frame.sliding, frame.normal);
    return frame;
  }



  bool
  looks_to_one_side(const ContactGeometry &g)
  {
    return MeanDirections(g).normal.norm() > least_side;
  }

  bool
  slides_one_way(const ContactGeometry &g)
  {
    return MeanDirections(g).sliding.norm() > least_side;
  }

  double
  transverse_sense(const ContactGeometry &first, const ContactGeometry &other)
  {
    return mean_frame(first).normal * mean_frame(other).normal < 0. ? -1. : 1.;
  }



  std::vector<Vector>
  tractions(const ContactGeometry &g, const Eigen::VectorXd &forces)
  {
    std::vector<Vector> result;
    for (std::size_t j = 0; j < g.points.size(); ++j)
      result.push_back((forces[3 * j + 1] * g.frames[j].sliding +
                        forces[3 * j + 2] * g.frames[j].transverse) /
                       g.areas[j]);
    return result;
  }



  Eigen::MatrixXd
  resultant_rows(const ContactGeometry &g)
  {
    const ContactFrame mean = mean_frame(g);
    const bool one_way = slides_one_way(g), has_side = looks_to_one_side(g);
    Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(3, 3 * g.points.size());
    for (std::size_t j = 0; j < g.points.size(); ++j)
      {
        const ContactFrame &frame = g.frames[j];
        const auto          project =
          [&](const unsigned int row, const Vector &axis, const bool pressure) {
            if (pressure)
              rows(row, 3 * j) = component(frame.normal, axis);
            rows(row, 3 * j + 1) = component(frame.sliding, axis);
            rows(row, 3 * j + 2) = component(frame.transverse, axis);
          };
        if (one_way)
          {
            project(0, mean.transverse, has_side);
            project(1, mean.sliding, has_side);
          }
        else
          rows(0, 3 * j + 2) = rows(1, 3 * j + 1) = 1.;
        if (has_side)
          project(2, mean.normal, true);
        else
          rows(2, 3 * j) = 1.;
      }
    return rows;
  }

  Eigen::MatrixXd
  sum_rows(const ContactGeometry &g)
  {
    Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(2, 3 * g.points.size());
    for (std::size_t j = 0; j < g.points.size(); ++j)
      rows(0, 3 * j) = rows(1, 3 * j + 1) = 1.;
    return rows;
  }

  std::array<double, 3>
  resultant_force(const ContactGeometry &g, const Eigen::VectorXd &forces)
  {
    const Eigen::Vector3d force = resultant_rows(g) * forces;
    return {{force[0], force[1], force[2]}};
  }



  ContactResultant
  contact_resultant(const ContactGeometry &g, const Eigen::VectorXd &forces)
  {
    ContactResultant        r{};
    const ContactFrame      frame = mean_frame(g);
    const std::vector<bool> edge  = leading_edge(g);
    double total = 0., pressing = 0., edge_area = 0., edge_force = 0.;
    r.force = resultant_force(g, forces);
    Vector face, moment;
    for (std::size_t j = 0; j < g.points.size(); ++j)
      {
        const double n = forces[3 * j], a = g.areas[j];
        r.peak_pressure = std::max(r.peak_pressure, n / a);
        total += a;
        pressing += n;
        face += a * Vector(g.points[j]);
        moment += n * Vector(g.points[j]);
        if (edge[j])
          {
            edge_area += a;
            edge_force += n;
          }
      }
    // Of a curved face these are not the resultant, whose parts turn.
    r.mean_pressure       = pressing / total;
    const bool is_pressed = pressing > 0.;
    r.centre              = {{not_known, not_known}};
    if (is_pressed)
      {
        const Vector arm = moment / pressing - face / total;
        r.centre         = {{arm * frame.transverse, arm * frame.sliding}};
      }
    r.leading_edge_factor =
      is_pressed && looks_to_one_side(g) && slides_one_way(g)
        ? edge_force / edge_area / r.mean_pressure
        : not_known;
    return r;
  }



  FaceAxes::FaceAxes(const ContactGeometry &g)
  {
    const ContactFrame mean = mean_frame(g);
    axes                    = {{mean.transverse, mean.sliding, mean.normal}};
    const Vector up         = nearest_axis(mean.normal),
                 on         = nearest_axis(mean.sliding);
    if ((mean.normal - up).norm() < all_but_along &&
        mean.sliding * on > near_axis)
      axes = {{dealii::cross_product_3d(on, up), on, up}};
    const Vector sliding = MeanDirections(g).sliding;
    mean_sliding         = {{sliding * axes[0], sliding * axes[1]}};
    for (const ContactFrame &frame : g.frames)
      {
        const Vector a = turned(axes[0], axes[2], frame.normal),
                     b = turned(axes[1], axes[2], frame.normal);
        projections.push_back({{a * frame.sliding,
                                a * frame.transverse,
                                b * frame.sliding,
                                b * frame.transverse}});
      }
  }

  bool
  FaceAxes::is_global() const
  {
    return axes[0][0] == 1. && axes[1][1] == 1.;
  }

  const std::array<Vector, 3> &
  FaceAxes::directions() const
  {
    return axes;
  }

  std::array<double, 2>
  FaceAxes::sliding() const
  {
    return mean_sliding;
  }

  std::array<double, 3>
  FaceAxes::place(const dealii::Point<3> &x) const
  {
    return {{axes[0] * x, axes[1] * x, axes[2] * x}};
  }

  std::array<double, 2>
  FaceAxes::components(const unsigned int j,
                       const double       along,
                       const double       across) const
  {
    const auto &p = projections[j];
    return {{p[0] * along + p[1] * across, p[2] * along + p[3] * across}};
  }
} // namespace squeal
