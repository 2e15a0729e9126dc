// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/results/map_style.h>
#include <squeal/tribology/damage/map_picture.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace squeal::tribology
{
  namespace
  {
    struct Range
    {
      double lower = 1e300, upper = -1e300;
    };



    Range
    range_of(const FaceMap &map)
    {
      Range range;
      for (const double v : map.values)
        if (std::isfinite(v) && (!map.logarithmic || v > 0.))
          {
            range.lower = std::min(range.lower, v);
            range.upper = std::max(range.upper, v);
          }
      if (range.lower > range.upper)
        return {map.logarithmic ? .1 : 0., 1.};
      if (map.logarithmic)
        range.lower = std::max(range.lower, range.upper * 1e-6);
      if (map.diverging)
        {
          range.upper = std::max(std::abs(range.lower), std::abs(range.upper));
          range.lower = -range.upper;
        }
      if (range.upper - range.lower <= 1e-12 * std::abs(range.upper))
        {
          const double half = std::max(.5 * std::abs(range.upper), 1e-300);
          range             = map.logarithmic
                                ? Range{range.upper / 2., range.upper * 2.}
                                : Range{range.lower - half, range.upper + half};
        }
      return range;
    }



    void
    set_colours(Drawing &drawing, const FaceMap &map)
    {
      const Range range = range_of(map);
      drawing.add(map.diverging ? two_sided_palette() : sequential_palette());
      drawing.add(map.logarithmic ? "set logscale cb" : "unset logscale cb");
      drawing.add("set cbrange [" + plot_number(range.lower) + ":" +
                  plot_number(range.upper) + "]");
      drawing.add("set cblabel " + in_quotes(map.label) + " offset 1");
    }
  } // namespace



  Drawing
  draw_maps(const ContactGrid &grid, const std::vector<FaceMap> &maps)
  {
    Drawing           drawing;
    const std::size_t n_columns = std::min<std::size_t>(maps.size(), 3);
    const std::size_t n_rows    = (maps.size() + n_columns - 1) / n_columns;
    drawing.width               = static_cast<int>(560 * n_columns + 40);
    drawing.height              = static_cast<int>(500 * n_rows);
    drawing.font_size           = 14.;
    drawing.add("set multiplot layout " + std::to_string(n_rows) + "," +
                std::to_string(n_columns));
    drawing.add("set size ratio -1");
    drawing.add("unset key");
    drawing.add("set style fill solid 1.0 noborder");
    drawing.add("set xlabel 'x in mm'");
    drawing.add("set ylabel 'y in mm (sliding direction)'");
    drawing.add("set format cb '%g'");
    for (const FaceMap &map : maps)
      {
        std::ostringstream data;
        std::ostringstream grey;
        for (std::size_t k = 0; k < grid.n_nodes(); ++k)
          {
            const Patch &c        = grid.cell(k);
            const bool   is_there = std::isfinite(map.values[k]) &&
                                  (!map.logarithmic || map.values[k] > 0.);
            std::ostringstream &out = is_there ? data : grey;
            for (const double edge : {.5 * (c.x_min + c.x_max),
                                      .5 * (c.y_min + c.y_max),
                                      c.x_min,
                                      c.x_max,
                                      c.y_min,
                                      c.y_max})
              out << plot_number(1e3 * edge) << ' ';
            out << (is_there ? plot_number(map.values[k]) : "0") << '\n';
          }
        set_colours(drawing, map);
        drawing.add("set title " + in_quotes(map.title));
        std::string plot;
        if (!grey.str().empty())
          plot = drawing.add_data(grey.str()) +
                 " using 1:2:3:4:5:6 with boxxyerror lc rgb " +
                 no_value_colour();
        if (!data.str().empty())
          plot += (plot.empty() ? "" : ", ") + drawing.add_data(data.str()) +
                  " using 1:2:3:4:5:6:7 with boxxyerror lc palette";
        drawing.add("plot " + plot);
      }
    drawing.add("unset multiplot");
    return drawing;
  }



  Drawing
  draw_matrix(const std::vector<double> &ranges,
              const std::vector<double> &means,
              const std::vector<double> &counts,
              const std::string         &title)
  {
    Drawing drawing;
    drawing.width     = 900;
    drawing.height    = 700;
    drawing.font_size = 14.;
    std::ostringstream data;
    const double       dr = .5 * (ranges[1] - ranges[0]);
    const double       dm = .5 * (means[1] - means[0]);
    FaceMap            colours;
    colours.label       = "cycles";
    colours.logarithmic = true;
    for (std::size_t i = 0; i < ranges.size(); ++i)
      for (std::size_t j = 0; j < means.size(); ++j)
        if (const double c = counts[i * means.size() + j]; c > 0.)
          {
            for (const double v : {means[j],
                                   ranges[i],
                                   means[j] - dm,
                                   means[j] + dm,
                                   ranges[i] - dr,
                                   ranges[i] + dr})
              data << plot_number(1e-6 * v) << ' ';
            data << plot_number(c) << '\n';
            colours.values.push_back(c);
          }
    drawing.add("unset key");
    drawing.add("set style fill solid 1.0 noborder");
    drawing.add("set title " + in_quotes(title));
    drawing.add("set xlabel 'mean stress of a cycle in MPa'");
    drawing.add(
      "set ylabel 'range of a cycle, largest less least stress, in MPa'");
    set_colours(drawing, colours);
    if (data.str().empty())
      data << "0 0 0 0 0 0 1\n";
    drawing.add("plot " + drawing.add_data(data.str()) +
                " using 1:2:3:4:5:6:7 with boxxyerror lc palette");
    return drawing;
  }
} // namespace squeal::tribology
