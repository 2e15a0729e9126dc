// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/results/map_style.h>
#include <squeal/tribology/damage/range_mean_picture.h>

#include <algorithm>
#include <sstream>

namespace squeal::tribology
{
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
    const double       dr   = .5 * (ranges[1] - ranges[0]);
    const double       dm   = .5 * (means[1] - means[0]);
    double             most = 1.;
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
            most = std::max(most, c);
          }
    drawing.add("unset key");
    drawing.add("set style fill solid 1.0 noborder");
    drawing.add("set title " + in_quotes(title));
    drawing.add("set xlabel 'mean stress of a cycle in MPa'");
    drawing.add(
      "set ylabel 'range of a cycle, largest less least stress, in MPa'");
    drawing.add(sequential_palette());
    drawing.add("set format cb '%g'");
    drawing.add("set logscale cb\nset cblabel 'cycles' offset 1");
    // half a cycle is the least that is counted
    drawing.add("set cbrange [0.5:" + plot_number(most) + "]");
    if (data.str().empty())
      data << "0 0 0 0 0 0 1\n";
    drawing.add("plot " + drawing.add_data(data.str()) +
                " using 1:2:3:4:5:6:7 with boxxyerror lc palette");
    return drawing;
  }
} // namespace squeal::tribology
