// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/model/doublets.h>
#include <squeal/results/chart.h>

#include <cmath>
#include <map>
#include <tuple>
#include <vector>

namespace squeal
{
  namespace
  {
    /** What stands before the numbers in the name of a disc mode. */
    std::string
    family(const std::string &name)
    {
      const std::string prefix = name.substr(0, name.find('('));
      return prefix == "T"   ? "tangential"
             : prefix == "R" ? "radial"
                             : "bending";
    }
  } // namespace



  Table
  doublet_table(const Table &modes)
  {
    using Type = Table::Type;
    Table table(
      {{"family",
        Type::text,
        "",
        "bending, or tangential or radial in the plane"},
       {"nodal_circles", Type::integer, "", "of both"},
       {"nodal_diameters", Type::integer, "", "of both"},
       {"frequency_plus_hz",
        Type::real,
        "Hz",
        "with an antinode at the pad",
        7},
       {"frequency_minus_hz", Type::real, "Hz", "with a node at the pad", 7},
       {"split_hz", Type::real, "Hz", "the first less the second", 4}});
    using Key = std::tuple<std::string, long long, long long>;
    std::map<Key, std::vector<std::size_t>> plus, minus;
    // A near tie leaves open what its names differ in: no member of a doublet.
    for (std::size_t i = 0; i < modes.n_rows(); ++i)
      if (!modes.is_missing(i, "nodal_diameters") &&
          !modes.is_missing(i, "nodal_circles") &&
          modes.integer(i, "nodal_diameters") > 0 &&
          !modes.text(i, "parity").empty())
        (modes.text(i, "parity") == "+"
           ? plus
           : minus)[{family(modes.text(i, "name")),
                     modes.integer(i, "nodal_circles"),
                     modes.integer(i, "nodal_diameters")}]
          .push_back(i);
    const auto frequency = [&](const std::size_t row) {
      return modes.real(row, "frequency_hz");
    };
    for (const auto &[key, candidates] : plus)
      {
        // A support near by makes several modes of one name: the two that are
        // closest to each other are the doublet.
        double f = 0., g = 1e300;
        for (const std::size_t i : candidates)
          for (const std::size_t j : minus[key])
            if (std::abs(frequency(i) - frequency(j)) < std::abs(f - g))
              {
                f = frequency(i);
                g = frequency(j);
              }
        if (!minus[key].empty())
          table.add_row({std::get<0>(key),
                         std::get<1>(key),
                         std::get<2>(key),
                         f,
                         g,
                         f - g});
      }
    return table;
  }



  Chart
  doublet_chart(const Table &doublets)
  {
    static const Ink inks[] = {
      Ink::blue, Ink::vermillion, Ink::green, Ink::purple};
    Chart chart;
    chart.title   = "Split of the doublets";
    chart.x.label = "nodal diameters";
    chart.y.label = "f(+) - f(-) in Hz";
    chart.lines   = {{false, 0., "", Ink::black, false}};
    for (std::size_t i = 0; i < doublets.n_rows(); ++i)
      {
        const long long   circles = doublets.integer(i, "nodal_circles");
        const std::string label =
          doublets.text(i, "family") + ", " + std::to_string(circles) +
          (circles == 1 ? " nodal circle" : " nodal circles");
        if (chart.series.empty() || chart.series.back().label != label)
          {
            ChartSeries next;
            next.label = label;
            next.style = ChartSeries::Style::lines_points;
            next.ink   = inks[chart.series.size() % 4];
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
