// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/unknown_choice.h>
#include <squeal/results/chart.h>
#include <squeal/results/chart_layout.h>

#include <algorithm>
#include <cmath>

namespace squeal
{
  namespace
  {
    using Style = ChartSeries::Style;

    constexpr const char *rule_colour = "#404040";
    constexpr const char *grid_colour = "#e4e4e4";

    int
    point_type(const ChartSeries &series)
    {
      const int hollow = series.hollow ? 1 : 0;
      switch (series.marker)
        {
        case ChartSeries::Marker::square:
          return 5 - hollow;
        case ChartSeries::Marker::triangle:
          return 9 - hollow;
        case ChartSeries::Marker::diamond:
          return 13 - hollow;
        case ChartSeries::Marker::circle:
          return 7 - hollow;
        }
      unknown_choice("marker");
    }

    std::string
    ink_of(const Ink ink)
    {
      return " lc rgb " + in_quotes(colour_code(ink));
    }

    /** Writes the commands that draw one chart. */
    class Panel
    {
    public:
      Panel(const Chart &chart, const PixelBox &outer, Drawing &drawing)
        : chart(chart)
        , layout(chart, outer, drawing.font_size)
        , inner(layout.inner)
        , drawing(drawing)
        , font(drawing.font_size)
      {
      }

      void draw();

    private:
      void        draw_axes();
      void        draw_titles();
      void        draw_ticks(const Axis &axis, bool horizontal);
      void        draw_strips();
      void        draw_reference_line(const ReferenceLine &line);
      void        draw_annotation(const Annotation &note);
      void        draw_legend_entry(const ChartLayout::LegendEntry &entry);
      void        draw_names();
      void        draw_series();
      std::string series_data(const ChartSeries &series) const;

      /** Adds a text; @p more are further options of a label. */
      void text(double             x,
                double             y,
                const std::string &words,
                const std::string &align,
                double             size,
                const std::string &more = "");
      /** A place on the canvas as gnuplot reads it. */
      std::string at(double x, double y) const;

      const Chart    &chart;
      ChartLayout     layout;
      const PixelBox &inner;
      Drawing        &drawing;
      double          font;
    };



    std::string
    Panel::at(const double x, const double y) const
    {
      return " screen " + plot_number(x / drawing.width) + ", screen " +
             plot_number(y / drawing.height);
    }



    void
    Panel::text(const double       x,
                const double       y,
                const std::string &words,
                const std::string &align,
                const double       size,
                const std::string &more)
    {
      drawing.add("set label " + in_quotes(words) + " at" + at(x, y) + ' ' +
                  align + " font " + in_quotes("," + plot_number(size)) +
                  " front " + more);
    }



    void
    Panel::draw_ticks(const Axis &axis, const bool horizontal)
    {
      const std::string name = horizontal ? "x" : "y";
      const double      length =
        horizontal ? inner.x_max - inner.x_min : inner.y_max - inner.y_min;
      std::string list;
      double      free_from = -1e9;
      for (const Axis::Tick &tick : axis.ticks())
        {
          // a text that would touch the one before stays away
          const double half =
            0.5 * (horizontal ? text_width(tick.text, font) + 0.8 * font
                              : 0.95 * text_height(font));
          const double place = tick.position * length;
          const bool   fits  = !tick.text.empty() && place - half >= free_from;
          if (fits)
            free_from = place + half;
          const bool own_colour = fits && tick.highlighted;
          list += (list.empty() ? "" : ", ") +
                  in_quotes(fits && !own_colour ? tick.text : "") + ' ' +
                  plot_number(tick.position) +
                  (tick.text.empty() ? " 1" : " 0");
          if (own_colour)
            text(horizontal ? inner.x_min + place : inner.x_min - 1.35 * font,
                 horizontal ? inner.y_min - text_height(font)
                            : inner.y_min + place,
                 tick.text,
                 horizontal ? "center" : "right",
                 font,
                 "tc rgb " + in_quotes(colour_code(Ink::vermillion)));
        }
      drawing.add("set " + name + "tics (" + list +
                  ") nomirror out scale 0.8, 0.4 tc rgb '#000000'");
    }



    void
    Panel::draw_axes()
    {
      drawing.add("set lmargin at screen " +
                  plot_number(inner.x_min / drawing.width));
      drawing.add("set rmargin at screen " +
                  plot_number(inner.x_max / drawing.width));
      drawing.add("set bmargin at screen " +
                  plot_number(inner.y_min / drawing.height));
      drawing.add("set tmargin at screen " +
                  plot_number(inner.y_max / drawing.height));
      drawing.add("set xrange [0:1]\nset yrange [0:1]\nset clip two");
      drawing.add("set border 3 lw 1.2 lc rgb " + in_quotes(rule_colour));
      drawing.add(chart.grid ? "set grid xtics ytics back lt 1 lw 1 lc rgb " +
                                 in_quotes(grid_colour)
                             : "unset grid");
      draw_ticks(layout.x_axis, true);
      draw_ticks(layout.y_axis, false);
    }



    void
    Panel::draw_titles()
    {
      const double line = text_height(font);
      if (!chart.title.empty())
        text(inner.x_min,
             layout.outer.y_max - 1.0 * line,
             chart.title,
             "left",
             1.12 * font,
             "");
      if (!chart.x.label.empty())
        text(0.5 * (inner.x_min + inner.x_max),
             layout.outer.y_min + 0.9 * line,
             chart.x.label,
             "center",
             font);
      if (!chart.y.label.empty())
        text(layout.outer.x_min + 0.9 * line,
             0.5 * (inner.y_min + inner.y_max),
             chart.y.label,
             "center",
             font,
             "rotate by 90");
    }



    void
    Panel::draw_strips()
    {
      const auto clamped = [](const double position) {
        return plot_number(std::min(1., std::max(0., position)));
      };
      for (const Strip &strip : chart.strips)
        {
          const Axis &axis = strip.vertical ? layout.x_axis : layout.y_axis;
          const std::string from =
            strip.lower ? clamped(axis.position(*strip.lower)) : "0";
          const std::string to =
            strip.upper ? clamped(axis.position(*strip.upper)) : "1";
          const std::string corners =
            strip.vertical ? from + ", graph 0 to graph " + to + ", graph 1"
                           : "0, graph " + from + " to graph 1, graph " + to;
          drawing.add("set object rectangle from graph " + corners +
                      " behind fs solid 1 noborder fc rgb " +
                      in_quotes(strip.tint));
        }
    }



    void
    Panel::draw_reference_line(const ReferenceLine &line)
    {
      const Axis       &axis  = line.vertical ? layout.x_axis : layout.y_axis;
      const std::string place = plot_number(axis.position(line.value));
      const std::string ends =
        line.vertical ? place + ", graph 0 to graph " + place + ", graph 1"
                      : "0, graph " + place + " to graph 1, graph " + place;
      drawing.add("set arrow from graph " + ends + " nohead back lw 1.8" +
                  (line.dashed ? " dt 2" : "") + ink_of(line.ink));
      if (line.text.empty())
        return;

      const double   size = font - 2.;
      const PixelBox box  = layout.place_of_text(line, size);
      text(0.5 * (box.x_min + box.x_max),
           0.5 * (box.y_min + box.y_max),
           line.text,
           "center",
           size,
           "tc rgb " + in_quotes(text_colour(line.ink)));
      layout.block(box);
    }



    void
    Panel::draw_annotation(const Annotation &note)
    {
      const double size   = font - 1.;
      const double width  = text_width(note.text, size);
      const double half   = 0.5 * text_height(size);
      const double x      = inner.x_min + note.x * (inner.x_max - inner.x_min);
      const double y      = inner.y_min + note.y * (inner.y_max - inner.y_min);
      const bool   left   = note.align == Annotation::Align::left;
      const bool   centre = note.align == Annotation::Align::centre;
      text(x,
           y,
           note.text,
           left ? "left" : (centre ? "center" : "right"),
           size,
           "tc rgb " + in_quotes(text_colour(note.ink)));
      const double start = left ? x : x - (centre ? 0.5 : 1.) * width;
      layout.block({start, y - half, start + width, y + half});
    }



    void
    Panel::draw_legend_entry(const ChartLayout::LegendEntry &entry)
    {
      const ChartSeries &series = *entry.series;
      const double       x0 = entry.x, x1 = entry.x + 2. * font;
      if (has_line(series))
        drawing.add("set arrow from" + at(x0, entry.y) + " to" +
                    at(x1, entry.y) + " nohead front lw 2.5" +
                    (series.dashed ? " dt 2" : "") + ink_of(series.ink));
      if (has_markers(series))
        drawing.add("set label '' at" + at(0.5 * (x0 + x1), entry.y) +
                    " front point pt " + std::to_string(point_type(series)) +
                    " ps " + plot_number(series.marker_size) + "*marker_scale" +
                    " lw 2" + ink_of(series.ink));
      if (!has_line(series) && !has_markers(series))
        drawing.add("set object rectangle from" +
                    at(x0 + 0.5 * font, entry.y - 0.5 * font) + " to" +
                    at(x1, entry.y + 0.5 * font) +
                    " front fs solid 1 noborder fc rgb " +
                    in_quotes(colour_code(series.ink)));
      text(x1 + 0.5 * font, entry.y, series.label, "left", font);
    }



    void
    Panel::draw_names()
    {
      const double size = font - chart.smaller_names;
      for (const ChartLayout::Name &name : layout.place_names(size))
        {
          const PointLabel &label = name.label;
          const PixelBox   &box   = label.box;
          text(0.5 * (box.x_min + box.x_max),
               0.5 * (box.y_min + box.y_max),
               label.text,
               "center",
               size,
               "tc rgb " + in_quotes(text_colour(name.ink)));
          if (label.needs_leader)
            drawing.add("set arrow from" + at(label.x, label.y) + " to" +
                        at(std::min(box.x_max, std::max(box.x_min, label.x)),
                           std::min(box.y_max, std::max(box.y_min, label.y))) +
                        " nohead back lw 1" + ink_of(name.ink));
        }
    }



    std::string
    Panel::series_data(const ChartSeries &series) const
    {
      std::string content;
      const auto  box_line = [&](const double x0,
                                const double x1,
                                const double y0,
                                const double y1) {
        for (const double value :
             {0.5 * (x0 + x1), 0.5 * (y0 + y1), x0, x1, y0, y1})
          content += plot_number(std::min(1., std::max(0., value))) + ' ';
        content += '\n';
      };
      for (const ChartSeries::Box &box : series.boxes)
        box_line(layout.x_axis.position(box.x_min),
                 layout.x_axis.position(box.x_max),
                 layout.y_axis.position(box.y_min),
                 layout.y_axis.position(box.y_max));
      for (std::size_t i = 0; i < series.x.size(); ++i)
        {
          const double x = layout.x_axis.position(series.x[i]);
          const double y = layout.y_axis.position(series.y[i]);
          if (series.style == Style::bars)
            {
              const double zero = layout.y_axis.position(0.);
              box_line(layout.x_axis.position(series.x[i] - 0.5 * series.width),
                       layout.x_axis.position(series.x[i] + 0.5 * series.width),
                       std::isfinite(zero) ? std::min(zero, y) : 0.,
                       std::isfinite(zero) ? std::max(zero, y) : y);
            }
          else if (std::isfinite(x) && std::isfinite(y))
            content += plot_number(x) + ' ' + plot_number(y) + '\n';
          else
            content += '\n';
        }
      // an empty file would be an error
      return content.find_first_not_of('\n') == std::string::npos ? "-9 -9\n"
                                                                  : content;
    }



    void
    Panel::draw_series()
    {
      std::string items;
      const auto  add_item = [&](const ChartSeries &series,
                                const std::string &style) {
        items += (items.empty() ? "plot " : ", ") +
                 drawing.add_data(series_data(series)) + ' ' + style +
                 ink_of(series.ink) + " notitle";
      };
      for (const ChartSeries &series : chart.series)
        {
          const bool is_box =
            series.style == Style::bars || series.style == Style::boxes;
          if (is_box && (!series.x.empty() || !series.boxes.empty()))
            add_item(series,
                     "using 1:2:3:4:5:6 with boxxyerror fs solid 1 border "
                     "rgb '#ffffff'");
          if (has_line(series))
            add_item(series,
                     std::string("using 1:2 with ") +
                       (series.style == Style::steps ? "steps" : "lines") +
                       " lw 2.5" + (series.dashed ? " dt 2" : ""));
          if (has_markers(series))
            add_item(series,
                     "using 1:2 with points pt " +
                       std::to_string(point_type(series)) + " ps " +
                       plot_number(series.marker_size) + "*marker_scale" +
                       " lw 2");
        }
      drawing.add(items.empty() ? "plot -1 notitle" : items);
    }



    void
    Panel::draw()
    {
      drawing.add("unset label\nunset arrow\nunset object\nunset key");
      draw_axes();
      draw_titles();
      draw_strips();
      for (const ReferenceLine &line : chart.lines)
        draw_reference_line(line);
      for (const Annotation &note : chart.annotations)
        draw_annotation(note);
      const PixelBox &box = layout.legend_box;
      if (box.x_max > box.x_min)
        drawing.add("set object rectangle from" + at(box.x_min, box.y_min) +
                    " to" + at(box.x_max, box.y_max) +
                    " front fs solid 1 noborder fc rgb '#ffffff'");
      for (const ChartLayout::LegendEntry &entry : layout.legend)
        draw_legend_entry(entry);
      draw_names();
      draw_series();
    }
  } // namespace



  Drawing
  draw_charts(const std::vector<Chart> &charts,
              const int                 width,
              const int                 height,
              const unsigned int        n_columns)
  {
    Drawing drawing;
    drawing.width  = width;
    drawing.height = height;
    drawing.add("set multiplot");
    const std::size_t n_rows = (charts.size() + n_columns - 1) / n_columns;
    for (std::size_t i = 0; i < charts.size(); ++i)
      {
        const double   w   = static_cast<double>(width) / n_columns;
        const double   h   = static_cast<double>(height) / n_rows;
        const double   x   = (i % n_columns) * w;
        const double   top = height - (i / n_columns) * h;
        const PixelBox outer{x, top - h, x + w, top};
        Panel(charts[i], outer, drawing).draw();
      }
    drawing.add("unset multiplot");
    return drawing;
  }
} // namespace squeal
