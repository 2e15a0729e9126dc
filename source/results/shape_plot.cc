// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/number_text.h>
#include <squeal/results/axis.h>
#include <squeal/results/label_layout.h>
#include <squeal/results/shape_plot.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace squeal
{
  namespace
  {
    /** Pieces of a surface: more would be smaller than what the eye sees. */
    constexpr std::size_t n_pieces = 14000;

    /** Maps a part of the canvas plane into a box of pixels, the same scale
     * along both directions. */
    class Fit
    {
    public:
      Fit(const std::vector<CanvasQuad> &quads, const PixelBox &box)
      {
        const double huge = std::numeric_limits<double>::max();
        PixelBox     seen{huge, huge, -huge, -huge};
        for (const CanvasQuad &quad : quads)
          for (const auto &corner : quad.corners)
            {
              seen.x_min = std::min(seen.x_min, corner[0]);
              seen.x_max = std::max(seen.x_max, corner[0]);
              seen.y_min = std::min(seen.y_min, corner[1]);
              seen.y_max = std::max(seen.y_max, corner[1]);
            }
        const double w = seen.x_max - seen.x_min, h = seen.y_max - seen.y_min;
        if (quads.empty() || !(w > 0.) || !(h > 0.))
          return;
        scale =
          std::min((box.x_max - box.x_min) / w, (box.y_max - box.y_min) / h);
        x_shift =
          0.5 * (box.x_min + box.x_max - scale * (seen.x_min + seen.x_max));
        y_shift =
          0.5 * (box.y_min + box.y_max - scale * (seen.y_min + seen.y_max));
      }

      std::array<double, 2>
      pixels(const std::array<double, 2> &point) const
      {
        return {{x_shift + scale * point[0], y_shift + scale * point[1]}};
      }

    private:
      double scale   = 1.;
      double x_shift = 0.;
      double y_shift = 0.;
    };

    std::string
    pixel_text(const std::array<double, 2> &pixels)
    {
      return plot_number(pixels[0]) + ' ' + plot_number(pixels[1]);
    }

    /** One quad as pm3d takes it: two scan lines of two points each. */
    void
    add_pixel_quad(std::string                                &rows,
                   const std::array<std::array<double, 2>, 4> &corners,
                   const unsigned int                          colour)
    {
      const std::string tail = " 0 " + std::to_string(colour) + '\n';
      rows += pixel_text(corners[0]) + tail + pixel_text(corners[1]) + tail +
              '\n' + pixel_text(corners[3]) + tail + pixel_text(corners[2]) +
              tail + "\n\n";
    }

    unsigned int
    darker(const unsigned int colour)
    {
      return (colour & 0xfefefe) / 2 + (colour & 0xfcfcfc) / 4;
    }

    /** Appends @p quads in their order. Each is grown by half a pixel, or the
     * smoothing of the edges would let the background shine through. */
    void
    add_quads(std::string                   &rows,
              const std::vector<CanvasQuad> &quads,
              const Fit                     &fit)
    {
      for (const CanvasQuad &quad : quads)
        {
          std::array<std::array<double, 2>, 4> corners, inside;
          std::array<double, 2>                centre = {{0., 0.}};
          for (unsigned int i = 0; i < 4; ++i)
            {
              corners[i] = fit.pixels(quad.corners[i]);
              for (unsigned int d = 0; d < 2; ++d)
                centre[d] += 0.25 * corners[i][d];
            }
          inside = corners;
          for (unsigned int i = 0; i < 4; ++i)
            {
              const double dx = corners[i][0] - centre[0];
              const double dy = corners[i][1] - centre[1];
              const double r  = std::max(1e-6, std::hypot(dx, dy));
              corners[i][0] += 0.6 * dx / r;
              corners[i][1] += 0.6 * dy / r;
              inside[i][0] -= std::min(0.5, 0.5 * r) * dx / r;
              inside[i][1] -= std::min(0.5, 0.5 * r) * dy / r;
            }
          add_pixel_quad(rows, corners, quad.colour);
          for (unsigned int i = 0; i < 4; ++i)
            if (quad.has_edge[i])
              {
                const unsigned int j = (i + 1) % 4;
                add_pixel_quad(rows,
                               {{corners[i], corners[j], inside[j], inside[i]}},
                               darker(quad.colour));
              }
        }
    }

    std::array<double, 2>
    on_canvas(const std::array<double, 3> &x, const Viewpoint &viewpoint)
    {
      const auto place = project(x, viewpoint);
      return {{place[0], place[1]}};
    }

    /** Appends thin grey lines: drawn first, they are seen where nothing
     * covers them. */
    void
    add_lines_at_rest(std::string        &rows,
                      const ShapePicture &picture,
                      const Fit          &fit)
    {
      constexpr double       half_width = 0.9; // pixels
      constexpr unsigned int grey       = 0x8a8f96;
      for (const SpaceLine &line : picture.undeformed)
        {
          const auto a    = fit.pixels(on_canvas(line[0], picture.viewpoint)),
                     b    = fit.pixels(on_canvas(line[1], picture.viewpoint));
          const double dx = b[0] - a[0], dy = b[1] - a[1],
                       size = std::hypot(dx, dy);
          if (size < 1e-9)
            continue;
          const double nx = -half_width * dy / size,
                       ny = half_width * dx / size;
          add_pixel_quad(rows,
                         {{{{a[0] - nx, a[1] - ny}},
                           {{b[0] - nx, b[1] - ny}},
                           {{b[0] + nx, b[1] + ny}},
                           {{a[0] + nx, a[1] + ny}}}},
                         grey);
        }
    }

    std::string
    path_data(const std::vector<CanvasPath> &paths, const Fit &fit)
    {
      std::string rows;
      for (const CanvasPath &path : paths)
        {
          for (const auto &point : path)
            rows += pixel_text(fit.pixels(point)) + " 0\n";
          rows += "\n\n";
        }
      return rows;
    }

    std::vector<CanvasPath>
    as_paths(const std::vector<CanvasLine> &lines)
    {
      std::vector<CanvasPath> paths;
      for (const CanvasLine &line : lines)
        paths.push_back({line[0], line[1]});
      return paths;
    }

    void
    add_text(Drawing           &drawing,
             const double       x,
             const double       y,
             const std::string &words,
             const std::string &align,
             const double       size,
             const std::string &more = "")
    {
      drawing.add("set label " + in_quotes(words) + " at screen " +
                  plot_number(x / drawing.width) + ", screen " +
                  plot_number(y / drawing.height) + ' ' + align + " font " +
                  in_quotes("," + plot_number(size)) + " front " + more);
    }

    /** Names of the bodies beside their highest points, and how many times as
     * far as the others they are drawn. */
    void
    add_names(Drawing            &drawing,
              const ShapePicture &picture,
              const Fit          &fit,
              const PixelBox     &bounds)
    {
      std::vector<PointLabel> labels;
      for (const PicturedBody &body : picture.bodies)
        if (!body.name.empty())
          {
            const auto place =
              fit.pixels(on_canvas(body.top, picture.viewpoint));
            labels.push_back(
              {place[0],
               place[1],
               body.name +
                 (body.times > 1.
                    ? " (motion drawn " + plot_number(body.times) + " times)"
                    : std::string()),
               {}});
          }
      place_labels(labels, {}, bounds, drawing.font_size);
      drawing.add("set style textbox opaque noborder margins 0.6,0.4");
      for (const PointLabel &label : labels)
        add_text(drawing,
                 0.5 * (label.box.x_min + label.box.x_max),
                 0.5 * (label.box.y_min + label.box.y_max),
                 label.text,
                 "center",
                 drawing.font_size,
                 "boxed");
    }

    /** Adds the scale of colours in @p box to the quads. */
    void
    add_colour_bar(Drawing           &drawing,
                   std::string       &rows,
                   const PixelBox    &box,
                   const std::string &label)
    {
      const int               n = 128;
      std::vector<CanvasQuad> quads;
      const auto              height_of = [&](const double value) {
        return box.y_min + 0.5 * (1. + value) * (box.y_max - box.y_min);
      };
      for (int i = 0; i < n; ++i)
        {
          const double y0 = height_of(-1. + 2. * i / n);
          const double y1 = height_of(-1. + 2. * (i + 1) / n);
          quads.push_back({{{{{box.x_min, y0}},
                             {{box.x_max, y0}},
                             {{box.x_max, y1}},
                             {{box.x_min, y1}}}},
                           diverging_colour(-1. + (2. * i + 1.) / n)});
        }
      add_quads(rows, quads, Fit(quads, box));
      for (const double value : {-1., -0.5, 0., 0.5, 1.})
        add_text(drawing,
                 box.x_max + 0.6 * drawing.font_size,
                 height_of(value),
                 plain_number(value, 1),
                 "left",
                 drawing.font_size);
      add_text(drawing,
               box.x_max + 5.2 * drawing.font_size,
               0.5 * (box.y_min + box.y_max),
               label,
               "center",
               drawing.font_size,
               "rotate by 90");
    }

    /** "+z" of "z", "-z" of itself. */
    std::string
    signed_direction(const std::string &name)
    {
      return name[0] == '-' ? name : "+" + name;
    }

    /** The directions of space in the corner of the oblique view. */
    void
    add_directions(Drawing                          &drawing,
                   const Viewpoint                  &viewpoint,
                   const std::array<std::string, 3> &names,
                   const double                      x,
                   const double                      y)
    {
      const double length = 3.4 * drawing.font_size;
      for (unsigned int d = 0; d < 3; ++d)
        {
          std::array<double, 3> axis = {{0., 0., 0.}};
          axis[d]                    = 1.;
          const auto   end           = project(axis, viewpoint);
          const double ex = x + length * end[0], ey = y + length * end[1];
          drawing.add("set arrow from screen " +
                      plot_number(x / drawing.width) + ", screen " +
                      plot_number(y / drawing.height) + " to screen " +
                      plot_number(ex / drawing.width) + ", screen " +
                      plot_number(ey / drawing.height) +
                      " front lw 2 lc rgb '#404040' size screen "
                      "0.008,20 filled");
          add_text(drawing,
                   x + 1.35 * length * end[0],
                   y + 1.35 * length * end[1],
                   names[d],
                   "center",
                   drawing.font_size - 1.);
        }
    }
  } // namespace



  bool
  plot_shape(const Plotter      &plotter,
             const ShapePicture &picture,
             const std::string  &path)
  {
    const bool   has_face = !picture.face.empty();
    const double range =
      largest_value(has_face ? picture.face : picture.surface);

    Drawing drawing;
    drawing.width       = has_face ? 1700 : 1200;
    drawing.height      = 900;
    const double font   = drawing.font_size;
    const double line   = text_height(font);
    const double right  = drawing.width - 9. * font;
    const double middle = has_face ? 0.56 * right : right;
    const double top    = drawing.height - 3.6 * line;

    std::string rows;
    const auto  shape =
      view_from(picture.surface, picture.viewpoint, range, n_pieces);
    const PixelBox oblique{2. * line, 2. * line, middle - line, top - line};
    const Fit      fit(shape, oblique);
    add_lines_at_rest(rows, picture, fit);
    add_quads(rows, shape, fit);
    add_names(drawing, picture, fit, {line, line, middle, top});
    add_colour_bar(drawing,
                   rows,
                   {right + font, 3. * line, right + 2.5 * font, top - line},
                   picture.value_label);
    add_directions(
      drawing, picture.viewpoint, picture.directions, 3. * line, 2.2 * line);
    add_text(
      drawing, line, drawing.height - line, picture.title, "left", 1.2 * font);
    add_text(drawing,
             line,
             drawing.height - 2.2 * line,
             picture.subtitle +
               (picture.drawn_largest > 0. && !picture.undeformed.empty()
                  ? "; largest motion drawn as " +
                      rounded_text(1e3 * picture.drawn_largest, 2) +
                      " mm, grey: at rest"
                  : std::string()),
             "left",
             font);

    std::string nodal_lines, edges, contact;
    if (has_face)
      {
        const auto face = view_from_above(picture.face, range, n_pieces);
        const Fit  fit(face, {middle + line, 2. * line, right - line, top});
        add_quads(rows, face, fit);
        nodal_lines = path_data(as_paths(zero_lines(picture.face)), fit);
        edges       = path_data(outline(picture.face), fit);
        contact     = path_data(outline(picture.contact), fit);
        add_text(drawing,
                 0.5 * (middle + right),
                 1.0 * line,
                 std::string("contact face of the disc ") +
                   (picture.face_looks_down ? "(below) " : "") + "seen from " +
                   signed_direction(picture.directions[2]) + ", " +
                   picture.directions[0] +
                   " to the right; nodal lines black, contact dashed",
                 "center",
                 font - 1.);
      }

    drawing.add("set view map\nunset colorbox\nunset border\nunset tics");
    drawing.add("unset key\nset pm3d scansforward corners2color c1");
    drawing.add("set lmargin at screen 0\nset rmargin at screen 1");
    drawing.add("set bmargin at screen 0\nset tmargin at screen 1");
    drawing.add("set xrange [0:" + std::to_string(drawing.width) + "]");
    drawing.add("set yrange [0:" + std::to_string(drawing.height) + "]");
    std::string plot = "splot " + drawing.add_data(rows) +
                       " using 1:2:3:4 with pm3d fc rgb variable";
    const auto add_lines = [&](const std::string &lines,
                               const std::string &style) {
      if (!lines.empty())
        plot +=
          ", " + drawing.add_data(lines) + " using 1:2:3 with lines " + style;
    };
    // without any line after the surface gnuplot forgets the arrows' shafts
    if (edges.empty())
      edges = "-9 -9 0\n-8 -9 0\n";
    add_lines(edges, "lw 1.5 lc rgb '#404040'");
    add_lines(nodal_lines, "lw 2 lc rgb '#000000'");
    add_lines(contact, "lw 2 dt (6,5) lc rgb '#000000'");
    drawing.add(plot);
    return plotter.draw(drawing, path);
  }
} // namespace squeal
