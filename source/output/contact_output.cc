// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/output/contact_output.h>

#include <cmath>
#include <limits>

namespace squeal
{
  namespace
  {
    /** "+y", or "(0.5, 0.866)", of the first @p n components. */
    std::string
    direction_text(const dealii::Tensor<1, 3> &d, const unsigned int n)
    {
      std::string text;
      for (unsigned int c = 0; c < n; ++c)
        {
          if (std::abs(std::abs(d[c]) - 1.) < 1e-6)
            return std::string(d[c] > 0. ? "+" : "-") + "xyz"[c];
          text += (c > 0 ? ", " : "(") +
                  rounded_text(std::abs(d[c]) < 1e-6 ? 0. : d[c], 3);
        }
      return text + ")";
    }
  } // namespace



  std::string
  sliding_text(const ContactGeometry &g)
  {
    const dealii::Tensor<1, 3> d = mean_frame(g).sliding;
    return direction_text(d, std::abs(d[2]) < 1e-6 ? 2 : 3);
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
    const FaceAxes              axes(g);
    const dealii::Tensor<1, 3> &first  = axes.directions()[0],
                               &second = axes.directions()[1],
                               sliding = mean_frame(g).sliding;
    DrawnFace face;
    face.points = node_points(g);
    face.areas  = g.areas;
    face.quads  = g.quads;
    for (const auto &x : g.points)
      face.places.push_back({axes.place(x)[0], axes.place(x)[1]});
    face.sliding = {sliding * first, sliding * second};
    if (!axes.is_global())
      face.axes = {{"across the sliding", "along the sliding"}};
    return ContactMap(face);
  }



  double
  pressure_on_map(const double pressure)
  {
    return pressure > 0. ? 1e-6 * pressure
                         : std::numeric_limits<double>::quiet_NaN();
  }

  std::vector<std::string>
  status_names()
  {
    return {"open", "stick", "slip"};
  }



  Table
  contact_table(const ContactGeometry            &g,
                const Eigen::VectorXd            &forces,
                const Eigen::VectorXd            &motion,
                const Eigen::VectorXd            &initial_gap,
                const std::vector<ContactStatus> &status)
  {
    using Type = Table::Type;
    Table      table({{"node", Type::integer, "", "number of the node, from 0"},
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
    const auto q     = tractions(g, forces);
    const auto names = status_names();
    for (std::size_t j = 0; j < g.points.size(); ++j)
      table.add_row({j,
                     g.points[j][0],
                     g.points[j][1],
                     g.points[j][2],
                     g.areas[j],
                     names[static_cast<int>(status[j])],
                     forces[3 * j] / g.areas[j],
                     q[j][0],
                     q[j][1],
                     initial_gap[j] - motion[3 * j],
                     forces[3 * j]});
    if (FaceAxes(g).is_global())
      return table;
    table.add_column({"traction_z_pa", Type::real, "Pa", "target on source"});
    for (std::size_t j = 0; j < q.size(); ++j)
      table.set(j, "traction_z_pa", q[j][2]);
    return table;
  }
} // namespace squeal
