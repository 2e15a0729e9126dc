// SPDX-License-Identifier: LGPL-2.1-or-later
// Drawn shapes: what is behind is hidden, nodal lines are where the value is
// zero, and the picture is written.
#include <squeal/base/files.h>
#include <squeal/base/run_log.h>
#include <squeal/results/shape_plot.h>
#include <squeal/results/shape_view.h>

#include <cmath>
#include <filesystem>
#include <sstream>

#include "check.h"
#include "worst.h"

using namespace squeal;
using namespace squeal::testing;

namespace
{
  constexpr double pi = 3.14159265358979323846;

  using Point = std::array<double, 3>;

  using TestQuad = SurfaceQuad;

  /** The upper face of an annulus that moves as r^2 cos(m theta), held at its
   * inner edge but for rounding errors. */
  std::vector<TestQuad>
  annulus(const int m, const double shift)
  {
    const int             n = 96, n_r = 6;
    std::vector<TestQuad> quads;
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n_r; ++j)
        {
          TestQuad quad;
          quad.body = 7;
          for (int k = 0; k < 4; ++k)
            {
              const int    a     = i + (k == 2 || k == 3);
              const int    b     = j + (k == 1 || k == 2);
              const double theta = 2. * pi * (a % n) / n;
              const double r     = 0.05 + 0.07 * b / n_r;
              quad.corners[k] = {r * std::cos(theta), r * std::sin(theta), 0.};
              quad.displacements[k] = {0.,
                                       0.,
                                       b == 0
                                         ? 1e-18 * std::cos(37. * a)
                                         : r * r * std::cos(m * theta + shift)};
            }
          quads.push_back(quad);
        }
    return quads;
  }

  void
  test_projection()
  {
    const Viewpoint front{0., 0.};
    const auto      p = project({1., 2., 3.}, front);
    check(p[0] == 2. && p[1] == 3. && p[2] == 1.,
          "from +x, y is right, z is up and x is near");
    const auto q = project({1., 2., 3.}, {90., 0.});
    check(std::abs(q[0] + 1.) < 1e-15 && std::abs(q[2] - 2.) < 1e-15,
          "from +y, x is left");
    const auto r = project({1., 2., 3.}, {0., 90.});
    check(std::abs(r[2] - 3.) < 1e-15, "from above, z is near");
  }

  void
  test_hiding()
  {
    const auto face = [](const double x, const double value) {
      ShapeQuad quad;
      quad.corners = {{{x, 0., 0.}, {x, 1., 0.}, {x, 1., 1.}, {x, 0., 1.}}};
      quad.values  = {value, value, value, value};
      return quad;
    };
    const auto seen = view_from({face(2., 1.), face(1., -1.)}, {0., 0.}, 1., 2);
    check(seen.size() == 2 &&
            (seen[0].colour & 0xff) > (seen[0].colour >> 16) &&
            (seen[1].colour & 0xff) < (seen[1].colour >> 16),
          "the far (blue) face is drawn before the near (red) one");
    check(view_from({face(2., 1.)}, {180., 0.}, 1., 1).empty(),
          "a face that looks away is left out");
    check(view_from({face(2., 1.)}, {0., 0.}, 1., 100).size() == 100,
          "a face is cut into the pieces asked for");
  }

  void
  test_colours()
  {
    check(diverging_colour(-9.) == diverging_colour(-1.) &&
            diverging_colour(9.) == diverging_colour(1.),
          "values beyond the range are moved to its end");
    const auto lightness = [](const double value) {
      const unsigned int c = diverging_colour(value);
      return 0.2126 * (c >> 16) + 0.7152 * (c >> 8 & 0xff) +
             0.0722 * (c & 0xff);
    };
    bool falling = true;
    for (double v = 0.; v < 0.999; v += 0.05)
      falling = falling && lightness(v) > lightness(v + 0.05) &&
                lightness(-v) > lightness(-v - 0.05);
    check(falling, "colours darken towards both ends: readable without hue");
  }

  void
  test_nodal_lines(const int m, const double shift, const std::string &where)
  {
    const ShapePicture picture = make_shape_picture(annulus(m, shift), 7, 0.01);
    const auto         lines   = zero_lines(picture.face);
    Worst              error;
    double             length = 0.;
    for (const CanvasLine &line : lines)
      {
        length += std::hypot(line[1][0] - line[0][0], line[1][1] - line[0][1]);
        for (const auto &end : line)
          error.add(std::abs(std::cos(m * std::atan2(end[1], end[0]) + shift)));
      }
    // 2 m radial lines of 70 mm; a chord of the mesh bends them by its
    // sagitta
    check_close(length,
                2 * m * 0.07,
                1e-2,
                "length of the nodal lines, m = " + std::to_string(m) + ", " +
                  where);
    check(error.largest() < 1e-2, "they lie where the shape is zero");
  }

  void
  test_outline()
  {
    const ShapePicture picture = make_shape_picture(annulus(2, 0.), 7, 0.01);
    double             length  = 0.;
    const auto         paths   = outline(picture.face);
    check(paths.size() == 2, "each circle is one path");
    for (const CanvasPath &path : paths)
      for (std::size_t i = 1; i < path.size(); ++i)
        length +=
          std::hypot(path[i][0] - path[i - 1][0], path[i][1] - path[i - 1][1]);
    check_close(
      length, 2. * pi * (0.05 + 0.12), 1e-3, "the outline is the two circles");
  }

  /** The face below has another shape than the one on top. */
  void
  test_contact_face_below()
  {
    auto quads = annulus(5, 0.);
    for (TestQuad quad : annulus(3, 0.1))
      {
        for (Point &corner : quad.corners)
          corner[2] = -0.01;
        quads.push_back(quad);
      }
    for (const bool down : {false, true})
      {
        const auto picture = make_shape_picture(quads, 7, 0.01, down);
        double     length  = 0.;
        for (const CanvasLine &line : zero_lines(picture.face))
          length +=
            std::hypot(line[1][0] - line[0][0], line[1][1] - line[0][1]);
        check_close(length,
                    2 * (down ? 3 : 5) * 0.07,
                    1e-2,
                    "nodal lines are those of the contact face, " +
                      std::string(down ? "below" : "on top"));
        check((picture.viewpoint.elevation < 0.) == down,
              "which the eye looks at");
      }
  }

  /** A flange above the ring is not what the pads touch. */
  void
  test_contact_face_below_a_flange()
  {
    auto         quads = annulus(3, 0.1);
    const double ring  = quads[0].corners[0][2];
    auto         pad   = quads[0];
    pad.body           = 8;
    for (TestQuad flange : annulus(5, 0.))
      {
        for (Point &corner : flange.corners)
          corner[2] += 0.03;
        quads.push_back(flange);
      }
    quads.push_back(pad);
    const auto picture = make_shape_picture(quads, 7, 0.01);
    check(picture.face.size() == 96 * 6 && picture.contact.size() == 1,
          "the face is the ring below a flange");
    Worst off;
    for (const ShapeQuad &quad : picture.face)
      off.add(std::abs(quad.corners[0][2] - ring));
    check(off.largest() < 1e-12, "where the pad touches it");
  }

  /** Corners of a box of two cells along x, seen from outside. */
  void
  test_feature_edges()
  {
    std::vector<TestQuad> quads;
    const auto            add = [&](const std::array<Point, 4> &corners) {
      TestQuad quad{};
      quad.corners = corners;
      quads.push_back(quad);
    };
    for (const double x : {0., 1.})
      for (const double z : {0., 1.})
        {
          add({{{{x, 0., z}},
                {{x + 1., 0., z}},
                {{x + 1., 1., z}},
                {{x, 1., z}}}});
          add({{{{x, z, 0.}},
                {{x + 1., z, 0.}},
                {{x + 1., z, 1.}},
                {{x, z, 1.}}}});
        }
    for (const double x : {0., 2.})
      add({{{{x, 0., 0.}}, {{x, 1., 0.}}, {{x, 1., 1.}}, {{x, 0., 1.}}}});
    double sum = 0.;
    for (const SpaceLine &line : feature_edges(quads, 35.))
      sum += std::abs(line[1][0] - line[0][0]) +
             std::abs(line[1][1] - line[0][1]) +
             std::abs(line[1][2] - line[0][2]);
    check_close(sum, 4 * (2. + 1. + 1.), 1e-12, "edges of a box of two cells");
  }

  void
  test_picture()
  {
    auto quads = annulus(3, 0.4);
    for (TestQuad pad : std::vector<TestQuad>(quads.begin(), quads.begin() + 6))
      {
        pad.body = 8;
        quads.push_back(pad);
      }
    ShapePicture picture = make_shape_picture(quads, 7, 0.01);
    check(picture.surface.size() == quads.size() &&
            picture.face.size() == 96 * 6 && picture.contact.size() == 6,
          "the face is the disc's, the contact what others have on it");
    Worst highest;
    for (const ShapeQuad &quad : picture.surface)
      for (const Point &corner : quad.corners)
        highest.add(std::abs(corner[2]));
    check_close(
      highest.largest(), 0.01, 1e-12, "the largest displacement is as asked");

    for (TestQuad &quad : quads)
      for (Point &u : quad.displacements)
        for (double &component : u)
          component *= quad.body == 8 ? 0.03 : 1.;
    const auto own = make_shape_picture(quads, 7, 0.01, false, {"", "x"});
    check(own.bodies.size() == 9 && own.bodies[1].name == "x" &&
            own.bodies[7].times == 1. && own.bodies[8].times == 20.,
          "a body that hardly moves has a scale of its own");
    Worst before, after;
    for (std::size_t k = quads.size() - 6; k < quads.size(); ++k)
      for (unsigned int i = 0; i < 4; ++i)
        {
          before.add(picture.surface[k].corners[i][2]);
          after.add(own.surface[k].corners[i][2]);
        }
    check_close(after.largest() / before.largest(),
                0.6,
                1e-9,
                "and no more than the largest motion");
    check_close(own.surface[0].values[0],
                picture.surface[0].values[0],
                1e-12,
                "colours are those of the true motion",
                1.);

    std::ostringstream console;
    RunLog             log(true, console);
    const Plotter      plotter(log);
    picture.title = "2594 Hz (0,3)-";
    check(plot_shape(plotter, picture, "shape_view_test"), "it is drawn");
    const std::size_t with_face =
      std::filesystem::file_size("shape_view_test.png");
    picture.face.clear();
    check(plot_shape(plotter, picture, "shape_view_test"),
          "so is a scene without a disc");
    check(with_face > 30000 &&
            read_file("shape_view_test.png").compare(1, 3, "PNG") == 0,
          "and there is something on it");
    check(plot_shape(plotter, {}, "shape_view_test"), "nothing is drawn too");
    check(log.warnings().empty(), "without a warning");
    std::filesystem::remove("shape_view_test.png");
  }
} // namespace

int
main()
{
  test_projection();
  test_hiding();
  test_colours();
  test_nodal_lines(3, 0.1, "across the mesh lines");
  test_nodal_lines(4, 0., "along the mesh lines");
  test_nodal_lines(2, 0.5 * pi, "along the mesh lines");
  test_outline();
  test_contact_face_below();
  test_contact_face_below_a_flange();
  test_feature_edges();
  test_picture();
}
