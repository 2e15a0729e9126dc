// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/files.h>
#include <squeal/results/contact_map.h>
#include <squeal/results/vtk_xml.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <ostream>

namespace squeal
{
  namespace
  {
    /** Coordinates that differ by more than @p tolerance, ascending. */
    std::vector<double>
    distinct(std::vector<double> all, const double tolerance)
    {
      std::sort(all.begin(), all.end());
      std::vector<double> result;
      for (const double x : all)
        if (result.empty() || x - result.back() > tolerance)
          result.push_back(x);
      return result;
    }

    std::size_t
    index_of(const std::vector<double> &all, const double x)
    {
      std::size_t best = 0;
      for (std::size_t i = 1; i < all.size(); ++i)
        if (std::abs(all[i] - x) < std::abs(all[best] - x))
          best = i;
      return best;
    }

    double
    middle(const std::vector<double> &all, const std::size_t i, const int side)
    {
      const std::size_t k = i + side;
      return k < all.size() ? 0.5 * (all[i] + all[k]) : all[i];
    }
  } // namespace



  ContactMap::ContactMap(const std::vector<std::array<double, 3>> &p,
                         const Values                             &areas)
    : points(p)
  {
    double              total = 0.;
    std::vector<double> x, y;
    for (std::size_t j = 0; j < points.size(); ++j)
      {
        x.push_back(points[j][0]);
        y.push_back(points[j][1]);
        total += areas[j];
      }
    const double tolerance   = 1e-6 * std::sqrt(total);
    x                        = distinct(x, tolerance);
    y                        = distinct(y, tolerance);
    const bool       is_grid = x.size() * y.size() == points.size();
    std::vector<int> node(x.size() * y.size(), -1);
    for (std::size_t j = 0; j < points.size(); ++j)
      {
        const double half = 0.5 * std::sqrt(areas[j]);
        Box          box{points[j][0] - half,
                points[j][0] + half,
                points[j][1] - half,
                points[j][1] + half};
        if (is_grid)
          {
            const std::size_t a    = index_of(x, points[j][0]),
                              b    = index_of(y, points[j][1]);
            node[a + x.size() * b] = j;
            box                    = {middle(x, a, -1),
                                      middle(x, a, 1),
                                      middle(y, b, -1),
                                      middle(y, b, 1)};
          }
        boxes.push_back(box);
      }
    if (!is_grid || std::count(node.begin(), node.end(), -1) > 0)
      return;
    for (std::size_t b = 0; b + 1 < y.size(); ++b)
      for (std::size_t a = 0; a + 1 < x.size(); ++a)
        {
          const std::size_t k = a + x.size() * b;
          quads.push_back({{node[k],
                            node[k + 1],
                            node[k + 1 + x.size()],
                            node[k + x.size()]}});
        }
  }



  bool
  ContactMap::plot(const Plotter            &plotter,
                   const std::vector<Panel> &panels,
                   const std::string        &path,
                   const unsigned int        n_columns) const
  {
    const unsigned int columns =
      std::min<std::size_t>(n_columns, panels.size());
    const unsigned int rows = (panels.size() + columns - 1) / columns;
    Drawing            drawing;
    drawing.width  = 620 * columns;
    drawing.height = 560 * rows;
    drawing.add("set multiplot layout " + std::to_string(rows) + "," +
                std::to_string(columns));
    drawing.add("set palette defined (0 '#ffffff', 0.25 '#c6dbef', 0.5 "
                "'#6baed6', 0.75 '#2171b5', 0.9 '#d55e00', 1 '#7f2704')");
    drawing.add("set size ratio -1\nunset key\nset style fill solid noborder");
    drawing.add("set xlabel 'x in mm'\nset ylabel 'y in mm (sliding)'");
    // One scale for all arrows: those of one traction are of one length,
    // whatever the panel and the cell of the node.
    double longest = 0., area = 0.;
    for (const Panel &panel : panels)
      for (std::size_t j = 0; j < panel.arrows_x.size(); ++j)
        longest =
          std::max(longest, std::hypot(panel.arrows_x[j], panel.arrows_y[j]));
    for (const Box &b : boxes)
      area += (b.x_max - b.x_min) * (b.y_max - b.y_min);
    const double length =
      std::min(2.4 * std::sqrt(area / boxes.size()), 0.3 * std::sqrt(area));
    for (const Panel &panel : panels)
      {
        std::string data, arrows;
        double      lower = panel.lower, upper = panel.upper;
        if (!(lower < upper))
          {
            const auto ends =
              std::minmax_element(panel.values.begin(), panel.values.end());
            lower = std::min(0., *ends.first);
            upper = *ends.second > lower ? *ends.second : lower + 1.;
          }
        for (std::size_t j = 0; j < boxes.size(); ++j)
          {
            const Box &b = boxes[j];
            for (const double value : {points[j][0],
                                       points[j][1],
                                       b.x_min,
                                       b.x_max,
                                       b.y_min,
                                       b.y_max})
              data += plot_number(1e3 * value) + ' ';
            data += plot_number(panel.values[j]) + '\n';
            if (longest > 0. && !panel.arrows_x.empty())
              {
                const double scale = length / longest;
                arrows += plot_number(1e3 * points[j][0]) + ' ' +
                          plot_number(1e3 * points[j][1]) + ' ' +
                          plot_number(1e3 * scale * panel.arrows_x[j]) + ' ' +
                          plot_number(1e3 * scale * panel.arrows_y[j]) + '\n';
              }
          }
        drawing.add("set title " + quoted(panel.title));
        drawing.add("set cblabel " + quoted(panel.label));
        drawing.add("set cbrange [" + plot_number(lower) + ":" +
                    plot_number(upper) + "]");
        std::string command = "plot " + drawing.add_data(data) +
                              " using 1:2:3:4:5:6:7 with boxxyerror lc palette";
        if (!arrows.empty())
          command += ", " + drawing.add_data(arrows) +
                     " using 1:2:3:4 with vectors filled lc rgb 'black'";
        drawing.add(command);
      }
    drawing.add("unset multiplot");
    return plotter.draw(drawing, path);
  }



  void
  ContactMap::write_vtu(
    const std::string                                 &path,
    const std::vector<std::pair<std::string, Values>> &fields) const
  {
    vtk::UnstructuredGrid     grid;
    std::vector<double>       coordinates;
    std::vector<std::int32_t> connectivity, offsets;
    std::vector<std::uint8_t> types;
    for (const auto &point : points)
      coordinates.insert(coordinates.end(), point.begin(), point.end());
    for (const auto &quad : quads)
      {
        connectivity.insert(connectivity.end(), quad.begin(), quad.end());
        offsets.push_back(connectivity.size());
        types.push_back(9);
      }
    for (std::size_t j = 0; quads.empty() && j < points.size(); ++j)
      {
        connectivity.push_back(j);
        offsets.push_back(connectivity.size());
        types.push_back(1);
      }
    grid.n_points = points.size();
    grid.n_cells  = types.size();
    grid.points   = vtk::data_array("points", 3, coordinates);
    grid.cells    = vtk::data_array("connectivity", 1, connectivity) +
                 vtk::data_array("offsets", 1, offsets) +
                 vtk::data_array("types", 1, types);
    for (const auto &[name, values] : fields)
      grid.point_data +=
        vtk::data_array(name, values.size() / points.size(), values);
    write_atomically(path,
                     [&](std::ostream &out) { vtk::write_vtu(out, grid); });
  }
} // namespace squeal
