// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/output/contact_output.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace squeal
{
  namespace
  {
    constexpr double not_known = std::numeric_limits<double>::quiet_NaN();

    /** Below this length of the mean of unit vectors there is no common
     * direction: a pad all round the axis. */
    constexpr double least_direction = 1e-6;

    /** Coordinates x, y along and across the sliding. */
    struct SlidingFrame
    {
      std::array<double, 2> along;

      double
      sliding(const double x, const double y) const
      {
        return along[0] * x + along[1] * y;
      }

      /** s = t x n. */
      double
      transverse(const double x, const double y) const
      {
        return along[1] * x - along[0] * y;
      }
    };
  } // namespace



  std::array<double, 2>
  sliding_direction(const ContactGeometry &g)
  {
    std::array<double, 2> d{{0., 0.}};
    double                area = 0.;
    for (std::size_t j = 0; j < g.points.size(); ++j)
      {
        area += g.areas[j];
        for (unsigned int c = 0; c < 2; ++c)
          d[c] += g.areas[j] * g.frames[j].sliding[c];
      }
    const double size = std::hypot(d[0], d[1]);
    if (!(size > least_direction * area))
      return {{0., 1.}};
    // Rounding must not mix friction into the force across it.
    if (std::abs(d[0]) < 1e-12 * size)
      return {{0., std::copysign(1., d[1])}};
    if (std::abs(d[1]) < 1e-12 * size)
      return {{std::copysign(1., d[0]), 0.}};
    return {{d[0] / size, d[1] / size}};
  }



  std::string
  sliding_text(const ContactGeometry &g)
  {
    const auto [x, y] = sliding_direction(g);
    if (std::abs(x) < 1e-6)
      return y > 0. ? "+y" : "-y";
    if (std::abs(y) < 1e-6)
      return x > 0. ? "+x" : "-x";
    return "(" + rounded_text(x, 3) + ", " + rounded_text(y, 3) + ")";
  }



  std::array<double, 3>
  resultant_force(const ContactGeometry &g, const Eigen::VectorXd &forces)
  {
    const SlidingFrame        frame{sliding_direction(g)};
    const std::vector<double> q = tractions(g, forces);
    double                    x = 0., y = 0., normal = 0.;
    for (std::size_t j = 0; j < g.points.size(); ++j)
      {
        x += q[2 * j] * g.areas[j];
        y += q[2 * j + 1] * g.areas[j];
        normal += forces[3 * j];
      }
    return {{frame.transverse(x, y), frame.sliding(x, y), normal}};
  }



  std::vector<std::array<double, 3>>
  node_points(const ContactGeometry &g)
  {
    std::vector<std::array<double, 3>> result;
    for (const auto &p : g.points)
      result.push_back({{p[0], p[1], p[2]}});
    return result;
  }

  ContactMap
  contact_map(const ContactGeometry &g)
  {
    return ContactMap(node_points(g), g.areas);
  }



  std::vector<bool>
  leading_edge(const ContactGeometry &g)
  {
    const SlidingFrame  frame{sliding_direction(g)};
    std::vector<double> along;
    for (const auto &p : g.points)
      along.push_back(frame.sliding(p[0], p[1]));
    const auto        ends  = std::minmax_element(along.begin(), along.end());
    const double      limit = *ends.first + 1e-6 * (*ends.second - *ends.first);
    std::vector<bool> result;
    for (const double s : along)
      result.push_back(s <= limit);
    return result;
  }



  std::vector<double>
  tractions(const ContactGeometry &g, const Eigen::VectorXd &forces)
  {
    std::vector<double> result;
    for (std::size_t j = 0; j < g.points.size(); ++j)
      {
        const auto q = (forces[3 * j + 1] * g.frames[j].sliding +
                        forces[3 * j + 2] * g.frames[j].transverse) /
                       g.areas[j];
        result.push_back(q[0]);
        result.push_back(q[1]);
      }
    return result;
  }



  ContactResultant
  contact_resultant(const ContactGeometry &g, const Eigen::VectorXd &forces)
  {
    ContactResultant        r{};
    const SlidingFrame      frame{sliding_direction(g)};
    const std::vector<bool> edge  = leading_edge(g);
    double                  total = 0., edge_area = 0., edge_force = 0.;
    r.force = resultant_force(g, forces);
    std::array<double, 2> face{{0., 0.}}, moment{{0., 0.}};
    for (std::size_t j = 0; j < g.points.size(); ++j)
      {
        const double n = forces[3 * j], a = g.areas[j];
        r.peak_pressure = std::max(r.peak_pressure, n / a);
        total += a;
        for (unsigned int c = 0; c < 2; ++c)
          {
            face[c] += a * g.points[j][c];
            moment[c] += n * g.points[j][c];
          }
        if (edge[j])
          {
            edge_area += a;
            edge_force += n;
          }
      }
    r.mean_pressure                  = r.force[2] / total;
    const bool            is_pressed = r.force[2] > 0.;
    std::array<double, 2> arm{{not_known, not_known}};
    for (unsigned int c = 0; c < 2 && is_pressed; ++c)
      arm[c] = moment[c] / r.force[2] - face[c] / total;
    r.centre = {
      {frame.transverse(arm[0], arm[1]), frame.sliding(arm[0], arm[1])}};
    r.leading_edge_factor =
      is_pressed ? edge_force / edge_area / r.mean_pressure : not_known;
    return r;
  }



  Table
  contact_table(const ContactGeometry            &g,
                const Eigen::VectorXd            &forces,
                const Eigen::VectorXd            &motion,
                const Eigen::VectorXd            &initial_gap,
                const std::vector<ContactStatus> &status)
  {
    using Type = Table::Type;
    Table table({{"node", Type::integer, "", "number of the node, from 0"},
                 {"x_m", Type::real, "m", "place"},
                 {"y_m", Type::real, "m", "place"},
                 {"z_m", Type::real, "m", "place"},
                 {"area_m2", Type::real, "m2", "tributary area"},
                 {"status", Type::text, "", "open, stick or slip"},
                 {"pressure_pa", Type::real, "Pa", "compression positive"},
                 {"traction_x_pa", Type::real, "Pa", "target on source"},
                 {"traction_y_pa", Type::real, "Pa", "target on source"},
                 {"gap_m", Type::real, "m", "opening"},
                 {"normal_n", Type::real, "N", "force of the node"}});
    const std::vector<double> q       = tractions(g, forces);
    const char *const         names[] = {"open", "stick", "slip"};
    for (std::size_t j = 0; j < g.points.size(); ++j)
      table.add_row({j,
                     g.points[j][0],
                     g.points[j][1],
                     g.points[j][2],
                     g.areas[j],
                     names[static_cast<int>(status[j])],
                     forces[3 * j] / g.areas[j],
                     q[2 * j],
                     q[2 * j + 1],
                     initial_gap[j] - motion[3 * j],
                     forces[3 * j]});
    return table;
  }
} // namespace squeal
