// SPDX-License-Identifier: LGPL-2.1-or-later
// Every chart is a picture of the stated size that names what is unstable, and
// without gnuplot a run goes on.
#include <squeal/base/exceptions.h>
#include <squeal/base/files.h>
#include <squeal/base/run_log.h>
#include <squeal/results/chart_layout.h>
#include <squeal/results/contact_map.h>
#include <squeal/results/plots.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <sstream>

#include "check.h"

using namespace squeal;
using namespace squeal::testing;
namespace fs = std::filesystem;

namespace
{
  const std::string folder = "plots_test/";

  std::uint32_t
  big_endian(const std::string &bytes, const std::size_t at)
  {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i)
      value = value << 8 | static_cast<unsigned char>(bytes.at(at + i));
    return value;
  }

  void
  check_png(const std::string  &name,
            const std::uint32_t width,
            const std::uint32_t height)
  {
    const std::string bytes = read_file(folder + name + ".png");
    check(bytes.compare(0, 8, "\x89PNG\r\n\x1a\n") == 0 &&
            big_endian(bytes, 16) == width && big_endian(bytes, 20) == height &&
            bytes.find("IEND") != std::string::npos,
          name + ".png is a whole PNG of " + std::to_string(width) + " x " +
            std::to_string(height));
  }

  bool
  svg_says(const std::string &name, const std::string &text)
  {
    return read_file(folder + name + ".svg").find(text) != std::string::npos;
  }

  PlottedPair
  pair(const double frequency, const double sigma, const std::string &name)
  {
    PlottedPair p;
    p.frequency      = frequency;
    p.sigma          = sigma;
    p.name           = name;
    p.is_unstable    = sigma > 0.;
    p.residual       = 1e-12;
    p.error_estimate = 0.;
    p.energy_shares  = {0.2, 0.8};
    return p;
  }

  void
  test_charts(const Plotter &plotter)
  {
    const std::vector<PlottedPair> pairs = {
      pair(913., -2., "support 1"),
      pair(0., -300., "divergence"),
      pair(3520., 94., "(0,3)+ <it's {a}^_test>"),
      pair(5003.9, 438.6, "(0,4)+"),
      pair(5004.1, -531., "(0,4)+"),
      pair(9000., NAN, "no value")};

    check(plot_spectrum(plotter, pairs, folder + "spectrum"), "spectrum");
    check_png("spectrum", 1400, 900);
    check(svg_says("spectrum", "5004 Hz  (0,4)+") &&
            svg_says("spectrum", "3520 Hz  (0,3)+ &lt;it's {a}^_test") &&
            !svg_says("spectrum", "support 1"),
          "it names the unstable pairs, letter by letter, and no other");

    check(plot_damping_chart(plotter, pairs, 1., folder + "damping"),
          "damping chart");
    check_png("damping", 1400, 900);
    check(svg_says("damping", "threshold −1 %") &&
            svg_says("damping", "unstable, within the threshold") &&
            svg_says("damping", "unstable, beyond the threshold"),
          "3520 Hz (-0.43 %) is within, 5004 Hz (-1.4 %) beyond 1 %");

    check(plot_energy_shares(
            plotter, {"disc", "support"}, pairs, folder + "shares"),
          "energy shares");
    check_png("shares", 1400, 500);
    check(svg_says("shares", "913 Hz  support 1") &&
            svg_says("shares", ">disc<") && svg_says("shares", ">support<"),
          "they name every pair and body");
    check(plot_energy_shares(plotter,
                             {"disc", "support"},
                             std::vector<PlottedPair>(100, pairs[0]),
                             folder + "many"),
          "a hundred pairs");
    check(svg_says("many", "(60 of 100 pairs)"), "are cut, and it is said");

    check(plot_error_estimates(plotter, pairs, 1e-8, 1e-9, folder + "errors"),
          "error estimates");
    check_png("errors", 1400, 900);
    check(svg_says("errors", "tolerance of residual") &&
            svg_says("errors", "10⁻⁸") && !svg_says("errors", "discretisation"),
          "they show both tolerances and only what is known");

    check(plot_work_precision(
            plotter,
            {{"uniform", {1., 10.}, {1e3, 1e4}, {.1, .01}, {}},
             {"adaptive", {1., 2.}, {1e3, 2e3}, {.1, 1e-4}, {"a", "b"}}},
            1e-3,
            folder + "work"),
          "work-precision");
    check_png("work", 1700, 900);
    check(plot_enrichment_decay(plotter,
                                {{140, 1e-3, 1e-2}, {150, 1e-9, 1e-10}},
                                1e-8,
                                1e-8,
                                folder + "decay"),
          "enrichment");
    check_png("decay", 1400, 900);
  }

  /** Pads that are alike tie in their names, which are as long as all bodies
   * are many; the bars keep their room. */
  void
  test_long_names(const Plotter &plotter)
  {
    const std::string name =
      "lining_u rocks, lining_l rocks, plate_u rocks, plate_l rocks "
      "(lining_u, lining_l, plate_u, plate_l) number 7";
    PlottedPair long_name   = pair(2345., 3., name);
    long_name.energy_shares = {.25, .25, .25, .25};
    PlottedPair stable      = long_name;
    stable.is_unstable      = false;
    check(plot_energy_shares(plotter,
                             {"lining_u", "lining_l", "plate_u", "plate_l"},
                             {long_name, stable},
                             folder + "long"),
          "bars of long names");
    check(svg_says("long", "2345 Hz  lining_u") && svg_says("long", "…") &&
            svg_says("long", "number 7") && !svg_says("long", name),
          "are cut in their middle");
    for (const double width : {1400., 700., 300.})
      {
        Chart chart;
        chart.y.lower = 0.;
        chart.y.upper = 1.;
        chart.y.label = "pair";
        chart.y.marks = {{.5, name, true}};
        const ChartLayout layout(chart, {0., 0., width, 500.}, 14.);
        check(layout.inner.x_max - layout.inner.x_min > .5 * width,
              "the panel has more than half of " + std::to_string(width));
      }
  }

  /** Of pairs that the mesh leaves open nothing else is said. */
  void
  test_open_growth(const Plotter &plotter)
  {
    std::vector<PlottedPair> pairs = {pair(913., -2., "decays"),
                                      pair(2000., 3., "grows")};
    const auto               drawn = [&]() {
      return plot_spectrum(plotter, pairs, folder + "open");
    };
    check(drawn() && !svg_says("open", "growth open by the mesh"),
          "nothing is open");
    for (PlottedPair &p : pairs)
      p.is_open = true;
    check(drawn() && svg_says("open", "growth open by the mesh") &&
            svg_says("open", "913 Hz  decays") &&
            svg_says("open", "2000 Hz  grows"),
          "open pairs are named as such");
    check(!svg_says("open", ">stable<") && !svg_says("open", ">unstable<"),
          "and neither stable nor unstable");
  }

  /** A lumped scene with frequencies far below those of a brake. */
  void
  test_low_frequencies(const Plotter &plotter)
  {
    check(plot_spectrum(plotter, {pair(0.2268, 0.2, "mass 1")}, folder + "low"),
          "a lumped scene");
    check(svg_says("low", "frequency in Hz") &&
            svg_says("low", "0.227 Hz  mass 1"),
          "has Hz on its axis and digits that tell its frequency");
  }

  void
  test_nothing(const Plotter &plotter)
  {
    check(plot_spectrum(plotter, {}, folder + "none") &&
            plot_damping_chart(plotter, {}, 1., folder + "none") &&
            plot_energy_shares(plotter, {}, {}, folder + "none") &&
            plot_error_estimates(plotter, {}, 1e-8, 1e-8, folder + "none") &&
            plot_work_precision(plotter, {}, 0., folder + "none") &&
            plot_enrichment_decay(plotter, {}, 1e-8, 1e-8, folder + "none"),
          "charts of nothing are drawn");
  }

  /** Every style and legend of the general chart. */
  void
  test_general_chart(const Plotter &plotter)
  {
    Chart chart;
    chart.title = "all styles";
    for (const ChartSeries::Style style : {ChartSeries::Style::points,
                                           ChartSeries::Style::lines,
                                           ChartSeries::Style::lines_points,
                                           ChartSeries::Style::steps,
                                           ChartSeries::Style::bars})
      {
        ChartSeries s;
        s.label = "style " + std::to_string(chart.series.size());
        s.style = style;
        s.x     = {1., 2., 3.};
        s.y     = {1., NAN, -2.};
        s.names = {"name", "", ""};
        chart.series.push_back(s);
      }
    chart.lines       = {{true, 2., "vertical", Ink::grey, true}};
    chart.annotations = {{0.5, 0.9, "noted", Ink::sky, {}}};
    for (const Chart::Legend legend : {Chart::Legend::none,
                                       Chart::Legend::above,
                                       Chart::Legend::upper_left,
                                       Chart::Legend::lower_right})
      {
        chart.legend = legend;
        check(plotter.draw(draw_charts({chart, chart}, 1400, 700, 2),
                           folder + "general"),
              "a general chart");
        check(svg_says("general", ">style 3<") ==
                (legend != Chart::Legend::none),
              "has the legend asked for");
      }
    check(svg_says("general", ">vertical<") && svg_says("general", ">noted<"),
          "and its texts");
  }

  void
  test_failures(const Plotter &plotter, const RunLog &log)
  {
    Drawing broken;
    broken.add("plot 'no_such_file.txt'");
    check(!plotter.draw(broken, folder + "broken") &&
            !fs::exists(folder + "broken.png") && log.warnings().size() >= 1 &&
            log.warnings().back().find("broken") != std::string::npos,
          "a picture that fails is a warning, and no file");
    for (const auto &entry : fs::directory_iterator(folder))
      check(entry.path().filename().string()[0] != '.',
            "no part of " + entry.path().filename().string() + " is left");

    setenv("PATH", "/no_such_folder", 1);
    std::ostringstream console;
    RunLog             other(true, console);
    const Plotter      missing(other);
    check(!missing.is_available() && other.warnings().size() == 1 &&
            other.warnings()[0].find("gnuplot-nox") != std::string::npos,
          "without gnuplot there is one warning that names the package");
    check(!plot_spectrum(missing, {}, folder + "missing") &&
            other.warnings().size() == 1,
          "and no further one");
  }

  /** The contact of imported matrices may be a node, or a row of them. */
  void
  test_map_of_a_node(const Plotter &plotter)
  {
    for (const std::vector<PlanarPoint> &places :
         {std::vector<PlanarPoint>{{{.02, .01}}},
          std::vector<PlanarPoint>{{{.02, .01}}, {{.03, .01}}}})
      {
        DrawnFace face;
        face.places = places;
        for (const PlanarPoint &place : places)
          face.points.push_back({{place[0], place[1], 0.}});
        face.areas.assign(places.size(), 1e-4);
        ContactMap::Panel panel;
        panel.values.assign(places.size(), 2.);
        check(ContactMap(face).plot(plotter, {panel}, folder + "node"),
              "a map of " + std::to_string(places.size()) + " nodes is drawn");
      }
  }
} // namespace

int
main()
{
  fs::remove_all(folder);
  fs::create_directories(folder);
  std::ostringstream console;
  RunLog             log(true, console);
  unsigned int       n_announced = 0;
  const Plotter      plotter(log, [&](const std::string &) { ++n_announced; });
  check(plotter.is_available(), "gnuplot is there: " + console.str());
  test_charts(plotter);
  test_long_names(plotter);
  test_open_growth(plotter);
  test_low_frequencies(plotter);
  test_nothing(plotter);
  test_general_chart(plotter);
  test_map_of_a_node(plotter);
  check(log.warnings().empty(), "no warning so far");
  test_failures(plotter, log);
  fs::remove_all(folder);
}
