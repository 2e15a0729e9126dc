// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/driver/doublets.h>
#include <squeal/results/chart.h>

#include <algorithm>
#include <map>
#include <tuple>

namespace squeal
{
  namespace
  {
    /** Largest share of the kinetic energy that one body has. */
    double
    purity(const Table &modes, const std::size_t row)
    {
      double result = 0.;
      for (const auto &column : modes.columns())
        if (column.name.rfind("ke_share_", 0) == 0)
          result = std::max(result, modes.real(row, column.name));
      return result;
    }
  } // namespace



  Table
  doublet_table(const Table &modes)
  {
    using Type = Table::Type;
    Table table(
      {{"nodal_circles", Type::integer, "", "of both"},
       {"nodal_diameters", Type::integer, "", "of both"},
       {"frequency_plus_hz",
        Type::real,
        "Hz",
        "with an antinode at the pad",
        7},
       {"frequency_minus_hz", Type::real, "Hz", "with a node at the pad", 7},
       {"split_hz", Type::real, "Hz", "the first less the second", 4}});
    // Of several modes of one name, which a support near by makes, the purest.
    std::map<std::tuple<long long, long long, std::string>, std::size_t> best;
    for (std::size_t i = 0; i < modes.n_rows(); ++i)
      {
        if (modes.is_missing(i, "nodal_diameters") ||
            modes.integer(i, "nodal_diameters") == 0)
          continue;
        const auto key   = std::make_tuple(modes.integer(i, "nodal_circles"),
                                         modes.integer(i, "nodal_diameters"),
                                         modes.text(i, "parity"));
        const auto found = best.find(key);
        if (found == best.end() ||
            purity(modes, i) > purity(modes, found->second))
          best[key] = i;
      }
    for (const auto &[key, plus] : best)
      {
        const auto &[circles, diameters, parity] = key;
        const auto minus = best.find(std::make_tuple(circles, diameters, "-"));
        if (parity != "+" || minus == best.end())
          continue;
        const double f = modes.real(plus, "frequency_hz"),
                     g = modes.real(minus->second, "frequency_hz");
        table.add_row({circles, diameters, f, g, f - g});
      }
    return table;
  }



  Chart
  doublet_chart(const Table &doublets)
  {
    static const Ink inks[] = {Ink::blue, Ink::vermillion, Ink::green};
    Chart            chart;
    chart.title   = "Split of the doublets";
    chart.x.label = "nodal diameters";
    chart.y.label = "f(+) - f(-) in Hz";
    chart.lines   = {{false, 0., "", Ink::black, false}};
    for (std::size_t i = 0; i < doublets.n_rows(); ++i)
      {
        const long long   circles = doublets.integer(i, "nodal_circles");
        const std::string label =
          std::to_string(circles) +
          (circles == 1 ? " nodal circle" : " nodal circles");
        if (chart.series.empty() || chart.series.back().label != label)
          {
            ChartSeries next;
            next.label = label;
            next.style = ChartSeries::Style::lines_points;
            next.ink   = inks[chart.series.size() % 3];
            next.marker =
              static_cast<ChartSeries::Marker>(chart.series.size() % 4);
            chart.series.push_back(next);
          }
        chart.series.back().x.push_back(doublets.integer(i, "nodal_diameters"));
        chart.series.back().y.push_back(doublets.real(i, "split_hz"));
      }
    return chart;
  }
} // namespace squeal
