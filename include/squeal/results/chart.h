// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_results_chart_h
#define squeal_results_chart_h

#include <squeal/results/axis.h>
#include <squeal/results/label_layout.h>
#include <squeal/results/plotter.h>

#include <optional>
#include <string>
#include <vector>

namespace squeal
{
  /** Points of one kind: (x_i, y_i) and how they are drawn. */
  struct ChartSeries
  {
    enum class Style
    {
      points,
      lines,
      lines_points,
      steps, /**< constant from each point to the next */
      bars,  /**< from zero to y, across x +- width/2 */
      boxes  /**< boxes[i], for stacked or lying bars */
    };
    enum class Marker
    {
      circle,
      square,
      triangle,
      diamond
    };
    struct Box
    {
      double x_min, x_max, y_min, y_max;
    };

    std::string         label; /**< in the legend; "" leaves it out */
    std::vector<double> x;
    std::vector<double> y;
    Style               style       = Style::points;
    Ink                 ink         = Ink::blue;
    Marker              marker      = Marker::circle;
    bool                hollow      = false;
    bool                dashed      = false;
    double              marker_size = 1.5;
    double              width       = 0.8; /**< of bars, in units of x */
    std::vector<Box>    boxes;
    /** Text beside point i; empty, or one (possibly empty) text a point. */
    std::vector<std::string> names;
  };

  /** A straight line across the panel with a text at its end. */
  struct ReferenceLine
  {
    bool        vertical = false;
    double      value    = 0.;
    std::string text;
    Ink         ink    = Ink::grey;
    bool        dashed = true;
  };

  /** A tinted strip across the panel; the tint is light. */
  struct Strip
  {
    bool                  vertical = true; /**< between two values of x */
    std::optional<double> lower;           /**< else the end of the axis */
    std::optional<double> upper;
    std::string           tint = "#fbeee6";
  };

  /** A text at a place of the panel: (0, 0) lower left, (1, 1) upper right. */
  struct Annotation
  {
    enum class Align
    {
      left,
      centre,
      right
    };
    double      x = 0.;
    double      y = 0.;
    std::string text;
    Ink         ink   = Ink::grey;
    Align       align = Align::left;
  };

  /**
   * A chart with two axes. Fill in what is wanted; ranges, ticks, margins and
   * the places of the names follow when it is drawn.
   */
  struct Chart
  {
    enum class Legend
    {
      none,
      above, /**< a row between title and panel */
      upper_left,
      upper_right,
      lower_left,
      lower_right
    };

    std::string                title;
    AxisSettings               x;
    AxisSettings               y;
    std::vector<ChartSeries>   series;
    std::vector<ReferenceLine> lines;
    std::vector<Strip>         strips;
    std::vector<Annotation>    annotations;
    Legend                     legend = Legend::above;
    bool                       grid   = true;
    /** Marker names as text of this many points less than the axis. */
    double smaller_names = 2.;
  };

  /** Draws @p charts side by side, @p n_columns in a row. */
  Drawing draw_charts(const std::vector<Chart> &charts,
                      int                       width     = 1400,
                      int                       height    = 900,
                      unsigned int              n_columns = 1);
} // namespace squeal

#endif
