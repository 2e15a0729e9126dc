// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_results_chart_layout_h
#define squeal_results_chart_layout_h

#include <squeal/results/chart.h>

#include <vector>

namespace squeal
{
  /** Whether the series is drawn with a marker at each point. */
  bool has_markers(const ChartSeries &series);

  /** Whether the points of the series are joined. */
  bool has_line(const ChartSeries &series);

  /**
   * Where everything of a chart stands, in pixels of the canvas: the panel
   * between the margins, its axes, the legend and the names of points. Texts
   * that are drawn inside the panel are told to block() before place_names().
   */
  class ChartLayout
  {
  public:
    struct LegendEntry
    {
      const ChartSeries *series;
      double             x, y; /**< left end, middle height */
    };

    struct Name
    {
      PointLabel label;
      Ink        ink;
    };

    ChartLayout(const Chart &chart, const PixelBox &outer, double font_size);

    double pixel_x(double value) const;
    double pixel_y(double value) const;

    /** Keeps names off a part of the panel. */
    void block(const PixelBox &box);

    /** Where the text of @p line covers least: beside a vertical line, on or
     * under a horizontal one, near one of its ends. */
    PixelBox place_of_text(const ReferenceLine &line, double font_size) const;

    /** The names of all series at their places. */
    std::vector<Name> place_names(double font_size) const;

    PixelBox                 outer; /**< what the chart may use */
    PixelBox                 inner; /**< the panel between the axes */
    Axis                     x_axis;
    Axis                     y_axis;
    std::vector<LegendEntry> legend;
    PixelBox                 legend_box; /**< of a legend inside the panel */

  private:
    void choose_margins();
    void place_legend();
    void block_series(std::vector<PixelBox> &boxes,
                      const ChartSeries     &series) const;

    const Chart          &chart;
    double                font;
    double                legend_height = 0.;
    std::vector<PixelBox> obstacles;
  };
} // namespace squeal

#endif
