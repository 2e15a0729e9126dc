// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/analyses/operating_matrix/operating_chart.h>
#include <squeal/base/number_text.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <iomanip>
#include <map>
#include <set>
#include <sstream>

namespace squeal
{
  namespace
  {
    /** Value of a column, 0 where it is that of the scene. */
    double
    value(const Table &table, const std::size_t row, const std::string &column)
    {
      return table.is_missing(row, column) ? 0. : table.real(row, column);
    }

    /** Distinct values of a column, ascending. */
    std::vector<double>
    values(const Table &table, const std::string &column)
    {
      std::set<double> result;
      for (std::size_t i = 0; i < table.n_rows(); ++i)
        result.insert(value(table, i, column));
      return {result.begin(), result.end()};
    }

    std::size_t
    place(const std::vector<double> &all, const double x)
    {
      return std::lower_bound(all.begin(), all.end(), x) - all.begin();
    }

    /** White to dark orange; grey where nothing is unstable. */
    std::string
    colour(const double sigma, const double largest, const bool unstable)
    {
      if (!unstable)
        return "#eef2f4";
      const double share =
        largest > 0. ? std::sqrt(std::clamp(sigma / largest, 0., 1.)) : 0.;
      const auto mixed = [&](const int light, const int dark) {
        return static_cast<int>(light + share * (dark - light));
      };
      char text[8];
      std::snprintf(text,
                    sizeof text,
                    "#%02x%02x%02x",
                    mixed(255, 213),
                    mixed(240, 94),
                    mixed(210, 0));
      return text;
    }

    /** Ticks of an axis with one place a value. */
    std::string
    ticks(const std::vector<double> &all, const double unit)
    {
      std::ostringstream text;
      text << std::setprecision(4);
      for (std::size_t i = 0; i < all.size(); ++i)
        text << (i ? ", '" : "'") << all[i] / unit << "' " << i;
      return "(" + text.str() + ")";
    }

    struct Axes
    {
      std::vector<double> pressures, temperatures, speeds;
    };

    void
    add_tiles(const Table       &table,
              const std::string &direction,
              const double       speed,
              const Axes        &axes,
              const double       largest,
              Drawing           &drawing)
    {
      drawing.add("unset object");
      drawing.add("unset label");
      for (std::size_t i = 0; i < table.n_rows(); ++i)
        {
          if (table.text(i, "direction") != direction ||
              value(table, i, "speed_m_per_s") != speed)
            continue;
          const double x =
            place(axes.pressures, value(table, i, "pressure_pa"));
          const double y =
            place(axes.temperatures, value(table, i, "temperature_c"));
          const double sigma    = table.real(i, "sigma_per_s");
          const bool   unstable = table.integer(i, "n_unstable") > 0;
          drawing.add("set object rectangle from " + plot_number(x - .5) + "," +
                      plot_number(y - .5) + " to " + plot_number(x + .5) + "," +
                      plot_number(y + .5) + " fc rgb " +
                      in_quotes(colour(sigma, largest, unstable)) +
                      " fs solid border lc rgb 'white' behind");
          const std::string text =
            unstable ? rounded_text(table.real(i, "frequency_hz") / 1000., 3) +
                         "\\n" + rounded_text(sigma, 3)
                     : "-";
          drawing.add("set label \"" + text + "\" at " + plot_number(x) + "," +
                      plot_number(y + (unstable ? .12 : 0.)) + " center front");
        }
    }
  } // namespace



  Drawing
  operating_chart(const Table &table)
  {
    const Axes                            axes{values(table, "pressure_pa"),
                    values(table, "temperature_c"),
                    values(table, "speed_m_per_s")};
    std::set<std::string, std::greater<>> directions; // forward first
    double                                largest = 0.;
    for (std::size_t i = 0; i < table.n_rows(); ++i)
      {
        directions.insert(table.text(i, "direction"));
        largest = std::max(largest, table.real(i, "sigma_per_s"));
      }
    Drawing drawing;
    drawing.width  = 1400;
    drawing.height = 200 + 500 * static_cast<int>(axes.speeds.size());
    drawing.add("set multiplot layout " + std::to_string(axes.speeds.size()) +
                "," + std::to_string(directions.size()));
    drawing.add("unset key");
    drawing.add("set xtics scale 0 " + ticks(axes.pressures, 1e6));
    const bool has_temperatures = !table.is_missing(0, "temperature_c");
    drawing.add(has_temperatures
                  ? "set ytics scale 0 " + ticks(axes.temperatures, 1.)
                  : "unset ytics");
    drawing.add("set xlabel 'pressure in MPa'");
    if (has_temperatures)
      drawing.add("set ylabel 'temperature in degrees Celsius'");
    drawing.add("set xrange [-0.5:" + plot_number(axes.pressures.size() - .5) +
                "]");
    drawing.add(
      "set yrange [-0.5:" + plot_number(axes.temperatures.size() - .5) + "]");
    for (const double speed : axes.speeds)
      for (const std::string &direction : directions)
        {
          add_tiles(table, direction, speed, axes, largest, drawing);
          drawing.add(
            "set title " +
            in_quotes(direction +
                      (speed > 0. ? ", " + rounded_text(speed, 4) + " m/s"
                                  : std::string()) +
                      ": frequency in kHz, sigma in 1/s"));
          drawing.add("plot NaN notitle");
        }
    drawing.add("unset multiplot");
    return drawing;
  }
} // namespace squeal
