// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/results/chart_layout.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace squeal
{
  namespace
  {
    using Style = ChartSeries::Style;

    /** All values that the axis must show. */
    std::vector<double>
    values_along(const Chart &chart, const bool horizontal)
    {
      std::vector<double> values;
      for (const ChartSeries &s : chart.series)
        {
          const std::vector<double> &own = horizontal ? s.x : s.y;
          values.insert(values.end(), own.begin(), own.end());
          for (const ChartSeries::Box &box : s.boxes)
            {
              values.push_back(horizontal ? box.x_min : box.y_min);
              values.push_back(horizontal ? box.x_max : box.y_max);
            }
          if (s.style == Style::bars && !horizontal)
            values.push_back(0.);
          if (s.style == Style::bars && horizontal)
            for (const double x : s.x)
              {
                values.push_back(x - 0.5 * s.width);
                values.push_back(x + 0.5 * s.width);
              }
        }
      for (const ReferenceLine &line : chart.lines)
        if (line.vertical == horizontal)
          values.push_back(line.value);
      return values;
    }

    /** Names of places leave the panel more than half of what the chart may
     * use. */
    AxisSettings
    with_short_names(AxisSettings    settings,
                     const PixelBox &outer,
                     const double    font)
    {
      const double all = outer.x_max - outer.x_min,
                   room =
                     std::min(0.35 * all, 0.5 * all - 5. * text_height(font));
      for (AxisSettings::Mark &mark : settings.marks)
        mark.text = shortened(mark.text, room, font);
      return settings;
    }

    /** Small boxes along a line. */
    void
    block_line(std::vector<PixelBox> &boxes,
               const double           x0,
               const double           y0,
               const double           x1,
               const double           y1)
    {
      for (int k = 1; k < 12; ++k)
        {
          const double x = x0 + k / 12. * (x1 - x0);
          const double y = y0 + k / 12. * (y1 - y0);
          if (std::isfinite(x) && std::isfinite(y))
            boxes.push_back({x - 3., y - 3., x + 3., y + 3.});
        }
    }
  } // namespace



  bool
  has_markers(const ChartSeries &series)
  {
    return series.style == Style::points || series.style == Style::lines_points;
  }



  bool
  has_line(const ChartSeries &series)
  {
    return series.style == Style::lines || series.style == Style::steps ||
           series.style == Style::lines_points;
  }



  ChartLayout::ChartLayout(const Chart    &chart,
                           const PixelBox &outer,
                           const double    font_size)
    : outer(outer)
    , inner(outer)
    , x_axis(chart.x, values_along(chart, true))
    , y_axis(with_short_names(chart.y, outer, font_size),
             values_along(chart, false))
    , chart(chart)
    , font(font_size)
  {
    choose_margins();
    for (const ReferenceLine &line : chart.lines)
      {
        const double x = pixel_x(line.value), y = pixel_y(line.value);
        if (line.vertical)
          block({x - 2., inner.y_min, x + 2., inner.y_max});
        else
          block({inner.x_min, y - 2., inner.x_max, y + 2.});
      }
  }



  double
  ChartLayout::pixel_x(const double value) const
  {
    return inner.x_min + x_axis.position(value) * (inner.x_max - inner.x_min);
  }



  double
  ChartLayout::pixel_y(const double value) const
  {
    return inner.y_min + y_axis.position(value) * (inner.y_max - inner.y_min);
  }



  void
  ChartLayout::block(const PixelBox &box)
  {
    obstacles.push_back(box);
  }



  /** Rows of entries as wide as the panel, from its left upper corner. */
  void
  ChartLayout::place_legend()
  {
    legend.clear();
    const double row   = 1.15 * text_height(font);
    const bool   above = chart.legend == Chart::Legend::above;
    double       x = 0., widest = 0.;
    int          n_rows = 0;
    for (const ChartSeries &series : chart.series)
      {
        if (series.label.empty() || chart.legend == Chart::Legend::none)
          continue;
        const double width = 4.2 * font + text_width(series.label, font);
        if (n_rows == 0 || !above ||
            x + width > inner.x_max - inner.x_min + 2. * font)
          {
            ++n_rows;
            x = 0.;
          }
        legend.push_back({&series, x, (n_rows - 0.5) * row});
        x += width;
        widest = std::max(widest, width);
      }
    legend_height = n_rows * row;

    const bool right = chart.legend == Chart::Legend::upper_right ||
                       chart.legend == Chart::Legend::lower_right;
    const bool low = chart.legend == Chart::Legend::lower_left ||
                     chart.legend == Chart::Legend::lower_right;
    const double left = above   ? inner.x_min
                        : right ? inner.x_max - widest
                                : inner.x_min + font;
    const double top  = above ? inner.y_max + legend_height + 0.5 * font
                        : low ? inner.y_min + legend_height + 0.5 * font
                              : inner.y_max - 0.5 * font;
    for (LegendEntry &entry : legend)
      {
        entry.x += left;
        entry.y = top - entry.y;
      }
    if (!above && !legend.empty())
      {
        legend_box = {
          left - 0.3 * font, top - legend_height, left + widest, top};
        block(legend_box);
      }
  }



  void
  ChartLayout::choose_margins()
  {
    double widest = 0.;
    for (const Axis::Tick &tick : y_axis.ticks())
      widest = std::max(widest, text_width(tick.text, font));
    double last = 0.;
    if (!x_axis.ticks().empty())
      last = 0.5 * text_width(x_axis.ticks().back().text, font);

    const double line = text_height(font);
    inner.x_min += widest + (chart.y.label.empty() ? 1.4 : 2.9) * line;
    inner.x_max -= std::max(1.2 * line, last + 0.3 * line);
    inner.y_min += (chart.x.label.empty() ? 1.8 : 3.4) * line;
    inner.y_max -= (chart.title.empty() ? 0.8 : 2.2) * line;
    place_legend();
    if (chart.legend == Chart::Legend::above)
      {
        // the rows are known only once the width is
        inner.y_max -= legend_height;
        place_legend();
      }
  }



  void
  ChartLayout::block_series(std::vector<PixelBox> &boxes,
                            const ChartSeries     &series) const
  {
    const double half = has_markers(series) ? 3.2 * series.marker_size : 2.;
    for (std::size_t i = 0; i < series.x.size(); ++i)
      {
        const double x = pixel_x(series.x[i]), y = pixel_y(series.y[i]);
        if (!std::isfinite(x) || !std::isfinite(y))
          continue;
        boxes.push_back({x - half, y - half, x + half, y + half});
        if (series.style == Style::bars)
          {
            const double zero = std::max(inner.y_min, pixel_y(0.));
            boxes.push_back({pixel_x(series.x[i] - 0.5 * series.width),
                             std::min(zero, y),
                             pixel_x(series.x[i] + 0.5 * series.width),
                             std::max(zero, y)});
          }
        if (i == 0 || !has_line(series))
          continue;
        const double x0 = pixel_x(series.x[i - 1]);
        const double y0 = pixel_y(series.y[i - 1]);
        if (series.style == Style::steps)
          {
            block_line(boxes, x0, y0, x, y0);
            block_line(boxes, x, y0, x, y);
          }
        else
          block_line(boxes, x0, y0, x, y);
      }
  }



  PixelBox
  ChartLayout::place_of_text(const ReferenceLine &line,
                             const double         font_size) const
  {
    std::vector<PixelBox> taken = obstacles;
    for (const ChartSeries &series : chart.series)
      block_series(taken, series);

    const double width  = text_width(line.text, font_size);
    const double height = text_height(font_size);
    PixelBox     best;
    double       least = std::numeric_limits<double>::infinity();
    for (const bool at_end : {true, false})
      for (const double side : {1., -1.})
        {
          const double   x = line.vertical
                               ? pixel_x(line.value) +
                                 (side > 0. ? 0.4 * font : -0.4 * font - width)
                             : at_end ? inner.x_max - 0.3 * font - width
                                      : inner.x_min + 0.3 * font;
          const double   y = !line.vertical
                               ? pixel_y(line.value) + side * 0.58 * height
                             : at_end ? inner.y_max - 0.6 * height
                                      : inner.y_min + 0.6 * height;
          const PixelBox box{x, y - 0.5 * height, x + width, y + 0.5 * height};
          // what sticks out of the panel counts as covered
          double covered = width * height - box.overlap(inner);
          for (const PixelBox &other : taken)
            covered += box.overlap(other);
          if (covered < least - 1e-6)
            {
              least = covered;
              best  = box;
            }
        }
    return best;
  }



  std::vector<ChartLayout::Name>
  ChartLayout::place_names(const double font_size) const
  {
    std::vector<PixelBox>   boxes = obstacles;
    std::vector<PointLabel> labels;
    std::vector<Ink>        inks;
    for (const ChartSeries &series : chart.series)
      {
        block_series(boxes, series);
        for (std::size_t i = 0; i < series.names.size(); ++i)
          if (!series.names[i].empty() && x_axis.contains(series.x.at(i)) &&
              y_axis.contains(series.y.at(i)))
            {
              labels.push_back({pixel_x(series.x[i]),
                                pixel_y(series.y[i]),
                                series.names[i],
                                {},
                                false});
              inks.push_back(series.ink);
            }
      }
    squeal::place_labels(labels, boxes, inner, font_size);

    std::vector<Name> names;
    for (std::size_t i = 0; i < labels.size(); ++i)
      names.push_back({labels[i], inks[i]});
    return names;
  }
} // namespace squeal
