// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/files.h>
#include <squeal/results/contact_map.h>
#include <squeal/results/map_style.h>
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

    /** Ranges of both axes, mm, @p margin beyond the face, and their ticks: with
     * equal scales a narrow face has little room for numbers. All panels have
     * the same, whatever arrows they have. A face of one place is as wide as
     * that of its @p area, m^2. */
    std::string
    axes_of(const std::vector<PlanarPoint> &places,
            const double                    margin,
            const double                    area)
    {
      std::array<double, 2> lower, extent;
      for (unsigned int c = 0; c < 2; ++c)
        {
          const auto ends = std::minmax_element(
            places.begin(), places.end(), [c](const auto &a, const auto &b) {
              return a[c] < b[c];
            });
          lower[c]  = 1e3 * (*ends.first)[c];
          extent[c] = 1e3 * ((*ends.second)[c] - (*ends.first)[c]);
        }
      const bool   is_point = extent[0] == 0. && extent[1] == 0.;
      const double longer   = std::max(
        {extent[0], extent[1], 1e-6, is_point ? 1e3 * std::sqrt(area) : 0.});
      const double beyond =
        std::max(1e3 * margin, is_point ? longer : 0.04 * longer);
      std::string text;
      for (unsigned int c = 0; c < 2; ++c)
        {
          const double most =
            std::max(1.5, std::floor((c == 0 ? 5. : 7.) * extent[c] / longer));
          const double least = std::max(extent[c], beyond) / most,
                       power = std::pow(10., std::floor(std::log10(least)));
          double step        = 10. * power;
          for (const double round : {5., 2., 1.})
            if (round * power >= least)
              step = round * power;
          text += std::string(text.empty() ? "" : "\n") + "set " + "xy"[c] +
                  "tics " + plot_number(step) + "\nset " + "xy"[c] + "range [" +
                  plot_number(lower[c] - beyond) + ":" +
                  plot_number(lower[c] + extent[c] + beyond) + "]";
        }
      return text;
    }



    std::string
    place_text(const PlanarPoint &place)
    {
      return plot_number(1e3 * place[0]) + ' ' + plot_number(1e3 * place[1]);
    }

    bool
    has_value(const ContactMap::Panel &panel, const std::size_t point)
    {
      const double v = panel.values[point];
      return std::isfinite(v) && (!panel.logarithmic || v > 0.) &&
             (panel.kinds.empty() ||
              panel.kinds.at(static_cast<std::size_t>(v)) != "open");
    }

    /** Closed polygons of the cells that have a value, or none, in mm. */
    std::string
    cell_data(const std::vector<PointCell> &cells,
              const ContactMap::Panel      &panel,
              const bool                    with_value)
    {
      std::string data;
      for (const auto &[point, corners] : cells)
        if (!corners.empty() && has_value(panel, point) == with_value)
          {
            for (std::size_t k = 0; k <= corners.size(); ++k)
              data += place_text(corners[k % corners.size()]) + ' ' +
                      plot_number(panel.values[point]) + '\n';
            data += '\n';
          }
      return data;
    }

    /** Range of the colours of a panel. */
    std::array<double, 2>
    colour_range(const ContactMap::Panel &panel)
    {
      if (panel.lower < panel.upper)
        return {{panel.lower, panel.upper}};
      double lower = panel.logarithmic ? HUGE_VAL : 0., upper = 0.;
      for (std::size_t j = 0; j < panel.values.size(); ++j)
        if (has_value(panel, j))
          {
            lower = std::min(lower, panel.values[j]);
            upper = std::max(upper, panel.values[j]);
          }
      if (!panel.logarithmic)
        return {{lower, lower < upper ? upper : lower + 1.}};
      if (upper == 0.)
        return {{.1, 1.}};
      constexpr double most_decades = 1e-6;
      lower                         = std::max(lower, most_decades * upper);
      return lower < upper ? std::array<double, 2>{{lower, upper}}
                           : std::array<double, 2>{{.5 * upper, 2. * upper}};
    }

    bool
    share_a_bar(const std::vector<ContactMap::Panel> &panels)
    {
      return panels.size() > 1 &&
             std::all_of(panels.begin(), panels.end(), [&](const auto &p) {
               return p.label == panels[0].label && p.kinds.empty() &&
                      p.logarithmic == panels[0].logarithmic &&
                      panels[0].kinds.empty() &&
                      colour_range(p) == colour_range(panels[0]);
             });
    }

    /** Palette, range and bar of a panel. */
    std::string
    colours_of(const ContactMap::Panel &panel, const bool has_shared_bar)
    {
      // beside a bar of its own the axis of the next panel leaves no room
      const std::string label =
        "set cblabel " + in_quotes(has_shared_bar ? panel.label : "") + "\n";
      if (!panel.kinds.empty())
        return label + palette_of_kinds(panel.kinds);
      const auto range = colour_range(panel);
      return label + "set palette maxcolors 0\n" + sequential_palette() +
             "\nset cbtics autofreq\n" + (panel.logarithmic ? "" : "un") +
             "set logscale cb\nset format cb '" +
             (panel.logarithmic ? "1e%T" : "%g") + "'\nset cbrange [" +
             plot_number(range[0]) + ":" + plot_number(range[1]) + "]";
    }

    /** With the unit of the colours where no shared bar says it. */
    std::string
    title_of(const ContactMap::Panel &panel, const bool has_shared_bar)
    {
      if (has_shared_bar || panel.label.empty())
        return panel.title;
      return panel.title + ", " + panel.label;
    }

    /** The longest arrow, whatever the panel and the cell of the node: those
     * of one traction are of one length. */
    double
    longest_arrow(const std::vector<ContactMap::Panel> &panels)
    {
      double longest = 0.;
      for (const auto &panel : panels)
        for (std::size_t j = 0; j < panel.arrows_x.size(); ++j)
          longest =
            std::max(longest, std::hypot(panel.arrows_x[j], panel.arrows_y[j]));
      return longest;
    }

    /** Drawn as @p length, m, where they are as long as @p longest. */
    std::string
    arrow_data(const DrawnFace         &face,
               const ContactMap::Panel &panel,
               const double             length,
               const double             longest)
    {
      std::string arrows;
      for (std::size_t j = 0; j < panel.arrows_x.size() && longest > 0.; ++j)
        arrows += place_text(face.places[j]) + ' ' +
                  place_text({length / longest * panel.arrows_x[j],
                              length / longest * panel.arrows_y[j]}) +
                  '\n';
      return arrows;
    }

    /** The outline of the face, mm; empty where no quads tell it. */
    std::string
    outline_data(const DrawnFace &face)
    {
      std::string data;
      for (const auto &[a, b] : outline_of(face.quads))
        data += place_text(face.places[a]) + '\n' + place_text(face.places[b]) +
                "\n\n";
      return data;
    }

    /** An arrow in the strip above the panels, and what it means. */
    std::string
    sliding_arrow(const PlanarPoint &sliding, const Drawing &drawing)
    {
      const double length = std::hypot(sliding[0], sliding[1]);
      if (length == 0.)
        return "";
      const double half = 15. / length, x = 34., y = drawing.height - 26.;
      const auto   screen = [&](const double sign) {
        return "screen " +
               plot_number((x + sign * half * sliding[0]) / drawing.width) +
               ",screen " +
               plot_number((y + sign * half * sliding[1]) / drawing.height);
      };
      return "set arrow 1 from " + screen(-1.) + " to " + screen(1.) +
             " filled size screen " + plot_number(11. / drawing.width) +
             ",22 lw 3 lc rgb '#333333' front\nset label 1 'the target slides' "
             "at screen " +
             plot_number(60. / drawing.width) + ",screen " +
             plot_number(y / drawing.height) + " left front";
    }

    /** Draws the data above each other, each in its way; empty ones not. */
    std::string
    plot_command(
      const std::array<std::pair<std::string, std::string>, 4> &layers,
      Drawing                                                  &drawing)
    {
      std::string command;
      for (const auto &[data, way] : layers)
        if (!data.empty())
          command +=
            (command.empty() ? "plot " : ", ") + drawing.add_data(data) + way;
      return command;
    }

    /** Places the bar that all panels share beside them. */
    std::string
    shared_bar(const Drawing &drawing, const double right, const double top)
    {
      return "set colorbox user origin screen " +
             plot_number(right + 25. / drawing.width) + ",screen " +
             plot_number(0.15 * top) + " size screen " +
             plot_number(28. / drawing.width) + ",screen " +
             plot_number(0.7 * top);
    }

    constexpr int panel_width = 560, panel_height = 520, strip = 52, bar = 150;
  } // namespace



  ContactMap::ContactMap(const DrawnFace &drawn)
    : face(drawn)
    , cells(quarter_cells(face.places, face.quads))
  {
    for (const auto &quad : face.quads)
      polygons.emplace_back(quad.begin(), quad.end());
    if (!face.quads.empty())
      return;
    polygons = delaunay_polygons(face.places);
    std::vector<double> reaches;
    for (const double area : face.areas)
      reaches.push_back(reach * std::sqrt(area));
    const auto nearest = nearest_cells(face.places, reaches);
    for (std::size_t j = 0; j < nearest.size(); ++j)
      cells.push_back({j, nearest[j]});
  }



  bool
  ContactMap::plot(const Plotter            &plotter,
                   const std::vector<Panel> &panels,
                   const std::string        &path,
                   const unsigned int        n_columns) const
  {
    // as many in each row as possible
    const unsigned int n       = panels.size();
    const unsigned int rows    = (n + n_columns - 1) / n_columns;
    const unsigned int columns = (n + rows - 1) / rows;
    const bool         one_bar = share_a_bar(panels);
    Drawing            drawing;
    drawing.width      = panel_width * columns + (one_bar ? bar : 0);
    drawing.height     = panel_height * rows + strip;
    const double right = double(panel_width * columns) / drawing.width,
                 top   = double(panel_height * rows) / drawing.height;
    drawing.add("set multiplot");
    drawing.add("set size ratio -1\nunset key");
    drawing.add("set style fill solid noborder");
    drawing.add("set xlabel " + in_quotes(face.axes[0] + " in mm") +
                "\nset ylabel " + in_quotes(face.axes[1] + " in mm"));
    drawing.add(sliding_arrow(face.sliding, drawing));
    const double longest = longest_arrow(panels);
    const double area =
      std::accumulate(face.areas.begin(), face.areas.end(), 0.);
    const double length = std::min(2.4 * std::sqrt(area / face.areas.size()),
                                   0.3 * std::sqrt(area));
    drawing.add(axes_of(face.places, longest > 0. ? 0.5 * length : 0., area));
    const std::string outline = outline_data(face);
    for (std::size_t k = 0; k < panels.size(); ++k)
      {
        const Panel &panel = panels[k];
        drawing.add(
          "set origin " + plot_number(right * (k % columns) / columns) + "," +
          plot_number(top * (rows - 1 - k / columns) / rows) + "\nset size " +
          plot_number(right / columns) + "," + plot_number(top / rows));
        drawing.add("set title " + in_quotes(title_of(panel, one_bar)));
        drawing.add(colours_of(panel, one_bar));
        if (one_bar && k == 0)
          drawing.add(shared_bar(drawing, right, top));
        else if (one_bar)
          drawing.add("unset colorbox");
        if (k == 1)
          drawing.add("unset arrow 1\nunset label 1");
        drawing.add(plot_command(
          {{{cell_data(cells, panel, false),
             " using 1:2 with polygons fc rgb " + no_value_colour()},
            {cell_data(cells, panel, true),
             " using 1:2:3 with polygons fc palette"},
            {outline, " using 1:2 with lines lw 1.2 lc rgb '#333333'"},
            {arrow_data(face, panel, length, longest),
             " using 1:2:3:4 with vectors filled lc rgb 'black'"}}},
          drawing));
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
    for (const auto &point : face.points)
      coordinates.insert(coordinates.end(), point.begin(), point.end());
    const auto add_cell = [&](const std::vector<int> &nodes,
                              const std::uint8_t      type) {
      connectivity.insert(connectivity.end(), nodes.begin(), nodes.end());
      offsets.push_back(connectivity.size());
      types.push_back(type);
    };
    for (const std::vector<int> &polygon : polygons)
      add_cell(polygon, vtk_polygon);
    for (std::size_t j = 0; polygons.empty() && j < face.points.size(); ++j)
      add_cell({int(j)}, vtk_vertex);
    grid.n_points = face.points.size();
    grid.n_cells  = types.size();
    grid.points   = vtk::data_array("points", 3, coordinates);
    grid.cells    = vtk::data_array("connectivity", 1, connectivity) +
                 vtk::data_array("offsets", 1, offsets) +
                 vtk::data_array("types", 1, types);
    for (const auto &[name, values] : fields)
      grid.point_data +=
        vtk::data_array(name, values.size() / face.points.size(), values);
    write_atomically(path,
                     [&](std::ostream &out) { vtk::write_vtu(out, grid); });
  }
} // namespace squeal
