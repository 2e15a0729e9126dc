// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/files.h>
#include <squeal/results/contact_map.h>
#include <squeal/results/vtk_xml.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <ostream>

namespace squeal
{
  namespace
  {
    /** How far a cell of that area may reach: those at corners of a face whose
     * cells are four times as long as wide do. */
    constexpr double reach = 2.;

    constexpr std::uint8_t vtk_vertex = 1, vtk_polygon = 7;

    std::vector<PlanarPoint>
    in_plane(const std::vector<std::array<double, 3>> &points)
    {
      std::vector<PlanarPoint> result;
      for (const auto &p : points)
        result.push_back({p[0], p[1]});
      return result;
    }



    /** Ticks of both axes, mm: with equal scales a narrow face has little room
     * for numbers. */
    std::string
    ticks_of(const std::vector<PlanarPoint> &places)
    {
      std::array<double, 2> extent{};
      for (unsigned int c = 0; c < 2; ++c)
        {
          const auto ends = std::minmax_element(
            places.begin(), places.end(), [c](const auto &a, const auto &b) {
              return a[c] < b[c];
            });
          extent[c] = 1e3 * ((*ends.second)[c] - (*ends.first)[c]);
        }
      const double longer = std::max(extent[0], extent[1]);
      std::string  text;
      for (unsigned int c = 0; c < 2; ++c)
        {
          const double most =
            std::max(1.5, std::floor((c == 0 ? 7. : 9.) * extent[c] / longer));
          const double least = std::max(extent[c], 1e-6) / most,
                       power = std::pow(10., std::floor(std::log10(least)));
          double step        = 10. * power;
          for (const double round : {5., 2., 1.})
            if (round * power >= least)
              step = round * power;
          text += std::string(text.empty() ? "" : "\n") + "set " + "xy"[c] +
                  "tics " + plot_number(step);
        }
      return text;
    }



    /** Closed outlines of the cells, mm, at the height of their values. */
    std::string
    outline_data(const std::vector<std::vector<PlanarPoint>> &cells,
                 const std::vector<double>                   &values)
    {
      std::string data;
      for (std::size_t j = 0; j < cells.size(); ++j)
        {
          for (std::size_t k = 0; k <= cells[j].size() && !cells[j].empty();
               ++k)
            {
              const PlanarPoint &corner = cells[j][k % cells[j].size()];
              data += plot_number(1e3 * corner[0]) + ' ' +
                      plot_number(1e3 * corner[1]) + ' ' +
                      plot_number(values[j]) + '\n';
            }
          data += '\n';
        }
      return data;
    }
  } // namespace



  ContactMap::ContactMap(const std::vector<std::array<double, 3>> &p,
                         const Values                             &areas)
    : ContactMap(p, areas, in_plane(p))
  {
    axis_labels =
      "set xlabel 'x in mm'\nset ylabel 'y in mm (sliding)' offset -1";
  }

  ContactMap::ContactMap(const std::vector<std::array<double, 3>> &p,
                         const Values                             &areas,
                         const std::vector<std::array<double, 2>> &where)
    : points(p)
    , areas(areas)
    , places(where.begin(), where.end())
    , axis_labels(
        "set xlabel 'across the sliding in mm'\nset ylabel 'along the "
        "sliding in mm' offset -1")
    , polygons(delaunay_polygons(places))
  {
    std::vector<double> reaches;
    for (const double area : areas)
      reaches.push_back(reach * std::sqrt(area));
    cells = nearest_cells(places, reaches);
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
    drawing.add("set view map\nset size ratio -1\nunset key\nunset ztics");
    drawing.add("set style fill solid noborder");
    drawing.add(axis_labels);
    drawing.add(ticks_of(places));
    // One scale for all arrows: those of one traction are of one length,
    // whatever the panel and the cell of the node.
    double longest = 0.;
    for (const Panel &panel : panels)
      for (std::size_t j = 0; j < panel.arrows_x.size(); ++j)
        longest =
          std::max(longest, std::hypot(panel.arrows_x[j], panel.arrows_y[j]));
    const double area = std::accumulate(areas.begin(), areas.end(), 0.);
    const double length =
      std::min(2.4 * std::sqrt(area / areas.size()), 0.3 * std::sqrt(area));
    for (const Panel &panel : panels)
      {
        const auto ends =
          std::minmax_element(panel.values.begin(), panel.values.end());
        double lower = panel.lower, upper = panel.upper;
        if (!(lower < upper))
          {
            lower = std::min(0., *ends.first);
            upper = *ends.second > lower ? *ends.second : lower + 1.;
          }
        std::string arrows;
        for (std::size_t j = 0; j < panel.arrows_x.size() && longest > 0.; ++j)
          arrows +=
            plot_number(1e3 * places[j][0]) + ' ' +
            plot_number(1e3 * places[j][1]) + ' ' +
            plot_number(1e3 * length / longest * panel.arrows_x[j]) + ' ' +
            plot_number(1e3 * length / longest * panel.arrows_y[j]) + '\n';
        drawing.add("set title " + in_quotes(panel.title));
        drawing.add("set cblabel " + in_quotes(panel.label));
        drawing.add("set cbrange [" + plot_number(lower) + ":" +
                    plot_number(upper) + "]");
        // Seen from above, where the height counts for the colour only.
        drawing.add("set zrange [" + plot_number(std::min(0., *ends.first)) +
                    ":" + plot_number(std::max(*ends.second, upper)) + "]");
        const std::string outlines =
          drawing.add_data(outline_data(cells, panel.values));
        std::string command =
          "splot " + outlines + " using 1:2:3 with polygons fc palette z, " +
          outlines + " using 1:2:3 with lines lw 0.5 lc rgb '#cccccc'";
        if (!arrows.empty())
          command +=
            ", " + drawing.add_data(arrows) +
            " using 1:2:(0):3:4:(0) with vectors filled lc rgb 'black'";
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
    const auto add_cell = [&](const std::vector<int> &nodes,
                              const std::uint8_t      type) {
      connectivity.insert(connectivity.end(), nodes.begin(), nodes.end());
      offsets.push_back(connectivity.size());
      types.push_back(type);
    };
    for (const std::vector<int> &polygon : polygons)
      add_cell(polygon, vtk_polygon);
    for (std::size_t j = 0; polygons.empty() && j < points.size(); ++j)
      add_cell({int(j)}, vtk_vertex);
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
