// SPDX-License-Identifier: LGPL-2.1-or-later

// The face of a pad as the damage maps take it: how far a node of a face that
// is no rectangle lies from its edge, where the leading edge is whatever the
// direction of sliding, which criteria have a limit of their own, and that
// areas must fit the places of their nodes.

#include <squeal/base/exceptions.h>
#include <squeal/tribology/criteria/multiaxial.h>
#include <squeal/tribology/history/contact_grid.h>
#include <squeal/tribology/history/face_areas.h>

#include "check.h"
#include "worst.h"

#include <cmath>

using namespace squeal;
using namespace squeal::testing;
using namespace squeal::tribology;

namespace
{
  constexpr double       radius    = 0.01; // m
  constexpr unsigned int n_rings   = 6;
  constexpr unsigned int n_sectors = 48;

  /** A disc of rings of nodes about a middle one. */
  HistoryLayout
  round_face(const bool with_quads)
  {
    HistoryLayout layout;
    const double  area = M_PI * radius * radius / (1 + n_rings * n_sectors);
    layout.points.push_back({{0., 0., 0.}});
    for (unsigned int i = 1; i <= n_rings; ++i)
      for (unsigned int k = 0; k < n_sectors; ++k)
        {
          const double r = radius * i / n_rings, a = 2. * M_PI * k / n_sectors;
          layout.points.push_back({{r * std::cos(a), r * std::sin(a), 0.}});
        }
    layout.areas.assign(layout.points.size(), area);
    const auto node = [](const unsigned int i, const unsigned int k) {
      return i == 0 ? 0u : 1 + (i - 1) * n_sectors + k % n_sectors;
    };
    for (unsigned int i = 0; with_quads && i < n_rings; ++i)
      for (unsigned int k = 0; k < n_sectors; ++k)
        layout.quads.push_back(
          {{node(i, k), node(i + 1, k), node(i + 1, k + 1), node(i, k + 1)}});
    return layout;
  }

  void
  check_edge_distance(const bool with_quads)
  {
    const ContactGrid grid(round_face(with_quads));
    // The polygon lies this much inside the circle.
    const double polygon = radius * (1. - std::cos(M_PI / n_sectors));
    Worst        worst;
    for (std::size_t j = 0; j < grid.n_nodes(); ++j)
      {
        const auto [x, y] = grid.place(j);
        worst.add(
          std::abs(grid.edge_distance(j) - (radius - std::hypot(x, y))));
      }
    check(worst.largest() < 1.01 * polygon,
          "distances to the edge of a round face");
  }

  void
  check_leading_edge()
  {
    HistoryLayout layout = round_face(true);
    for (const double degrees : {0., 90., 180., 300.})
      {
        const double a = degrees * M_PI / 180.;
        layout.sliding = {{.9 * std::cos(a), .9 * std::sin(a)}};
        const ContactGrid grid(layout);
        check(std::abs(grid.sliding()[0] - std::cos(a)) < 1e-12 &&
                std::abs(grid.sliding()[1] - std::sin(a)) < 1e-12,
              "the direction has the length 1");
        Worst behind, ahead;
        for (std::size_t j = 0; j < grid.n_nodes(); ++j)
          {
            const auto [x, y] = grid.place(j);
            const double way  = x * std::cos(a) + y * std::sin(a);
            if (way < -.99 * radius)
              ahead.add(grid.share_of_way(j));
            if (way > .99 * radius)
              behind.add(grid.share_of_way(j));
          }
        check(ahead.largest() < .05 && behind.smallest() > .95,
              "the way across the face begins at the leading edge");
      }
    layout.sliding = {{0., 0.}};
    check(std::isnan(ContactGrid(layout).share_of_way(0)),
          "where the disc slides all round there is no leading edge");
  }

  /** Pictures show the whole face of a grid, whether its nodes are those of a
   * mesh or the middles of cells. */
  void
  check_drawn_face(const bool are_middles)
  {
    constexpr unsigned int n_x = 5, n_y = 4;
    constexpr double       step = 1e-3; // m
    HistoryLayout          layout;
    std::vector<double>    values;
    for (unsigned int j = 0; j < n_y; ++j)
      for (unsigned int i = 0; i < n_x; ++i)
        {
          const double x = i == 0 || i + 1 == n_x ? .5 : 1.,
                       y = j == 0 || j + 1 == n_y ? .5 : 1.;
          layout.points.push_back({{step * i, step * j, 0.}});
          layout.areas.push_back(step * step * (are_middles ? 1. : x * y));
          values.push_back(layout.points.size());
        }
    const ContactGrid         grid(layout);
    const DrawnFace           face  = grid.drawn_face();
    const std::vector<double> drawn = grid.drawn_values(values);
    check(drawn.size() == face.places.size() &&
            face.points.size() == drawn.size() &&
            face.areas.size() == drawn.size(),
          "a value for each drawn point");
    Worst x, y;
    bool  are_near = true;
    for (std::size_t k = 0; k < drawn.size(); ++k)
      {
        const auto [px, py] = face.places[k];
        x.add(px);
        y.add(py);
        const auto node = static_cast<std::size_t>(drawn[k]) - 1;
        are_near        = are_near &&
                   std::abs(px - grid.place(node)[0]) < .51 * step &&
                   std::abs(py - grid.place(node)[1]) < .51 * step;
      }
    const double beyond = are_middles ? .5 * step : 0.;
    check(std::abs(x.smallest() + beyond) < 1e-12 &&
            std::abs(x.largest() - (n_x - 1) * step - beyond) < 1e-12 &&
            std::abs(y.smallest() + beyond) < 1e-12 &&
            std::abs(y.largest() - (n_y - 1) * step - beyond) < 1e-12,
          "the drawn face ends where the face does");
    check(are_near, "each point has the value of the nearest node");
    double area = 0.;
    for (const auto &quad : face.quads)
      {
        const auto &a = face.places[quad[0]], &b = face.places[quad[2]];
        area += (b[0] - a[0]) * (b[1] - a[1]);
      }
    double sum = 0.;
    for (const double a : layout.areas)
      sum += a;
    check_close(area, sum, 1e-12, "its pieces cover the face once");
    check(grid.quads().size() == (n_x - 1) * (n_y - 1),
          "between nodes there are as many as before");
  }

  /** 7 x 5 nodes of a mesh, or middles of cells, 1 mm apart. */
  HistoryLayout
  rectangular_face(const bool are_middles)
  {
    HistoryLayout layout;
    for (unsigned int j = 0; j < 5; ++j)
      for (unsigned int i = 0; i < 7; ++i)
        {
          const double x = are_middles || i % 6 != 0 ? 1. : .5,
                       y = are_middles || j % 4 != 0 ? 1. : .5;
          layout.points.push_back({{1e-3 * i, 1e-3 * j, 0.}});
          layout.areas.push_back(1e-6 * x * y);
        }
    return layout;
  }

  /** Nodes on a ring of @p width about a circle of 100 mm. */
  HistoryLayout
  thin_ring(const double width)
  {
    constexpr unsigned int n = 600;
    HistoryLayout          layout;
    for (unsigned int k = 0; k < n; ++k)
      for (const double r : {.1 - .25 * width, .1 + .25 * width})
        {
          const double a = 2. * M_PI * k / n;
          layout.points.push_back({{r * std::cos(a), r * std::sin(a), 0.}});
          layout.areas.push_back(M_PI * .1 * width / n);
        }
    return layout;
  }

  HistoryLayout
  scaled(HistoryLayout layout, const double length, const double area)
  {
    for (auto &point : layout.points)
      for (double &x : point)
        x *= length;
    for (double &a : layout.areas)
      a *= area;
    return layout;
  }

  /** Areas in m^2 belong to places in m, on grids and elsewhere. */
  void
  check_areas()
  {
    const auto refused = [](const HistoryLayout &layout,
                            const std::string   &what) {
      check_throws<InputError>([&] { require_areas_of_face(layout, "a.h5"); },
                               "a.h5: the areas of the contact nodes add up to",
                               what);
    };
    for (const HistoryLayout &face : {rectangular_face(false),
                                      rectangular_face(true),
                                      round_face(false),
                                      thin_ring(1e-3)})
      {
        require_areas_of_face(face, "a.h5");
        refused(scaled(face, 1e3, 1.), "coordinates in mm");
        refused(scaled(face, 1., 1e6), "areas in mm^2");
        const HistoryLayout all_in_mm = scaled(face, 1e3, 1e6);
        require_areas_of_face(all_in_mm, "areas of faces in mm fit");
        check(doubt_of_length(face, "a.h5").empty(), "a pad is short");
        check(doubt_of_length(all_in_mm, "a.h5").find("a.h5: the face is ") ==
                0,
              "one in mm is long: " + doubt_of_length(all_in_mm, "a.h5"));
      }
    refused(scaled(rectangular_face(true), 1., 2.), "twice the area of a grid");
    for (const double slot : {2e-3, 8e-3, .1})
      {
        // the nodes from the fourth column on are a part of their own
        HistoryLayout parts = rectangular_face(true);
        for (auto &point : parts.points)
          point[0] += point[0] > 2.5e-3 ? slot : 0.;
        require_areas_of_face(parts, "two parts of a face on one grid");
        refused(scaled(parts, 1e3, 1.), "two parts in mm");
        refused(scaled(parts, 1., 1e6), "two parts with areas in mm^2");
      }

    // A node of a half cylinder stands for more than its shadow.
    HistoryLayout curved;
    for (unsigned int j = 0; j < 6; ++j)
      for (unsigned int i = 0; i < 9; ++i)
        {
          const double a = M_PI * i / 8.;
          curved.points.push_back(
            {{.01 * std::cos(a), 2e-3 * j, .01 * std::sin(a)}});
          curved.areas.push_back(.01 * M_PI / 8. * 2e-3);
        }
    require_areas_of_face(curved, "a half cylinder");

    HistoryLayout beam;
    for (unsigned int i = 0; i < 5; ++i)
      beam.points.push_back({{1e-3 * i, 0., 0.}});
    beam.areas.assign(5, 1e-3 * 1.);
    require_areas_of_face(beam, "nodes on a line have any width");
    beam.points.resize(1);
    beam.areas = {1.};
    require_areas_of_face(beam, "one node");
  }

  void
  check_limits()
  {
    using C = SubsurfaceParameters::Criterion;
    SubsurfaceParameters p;
    check(!has_limit(C::rankine, p) && !has_limit(C::dang_van, p),
          "nothing given: all values are indices");
    p.tensile_strength = 2e7;
    check(has_limit(C::rankine, p) && has_limit(C::drucker_prager, p) &&
            !has_limit(C::dang_van, p),
          "a tensile strength is a limit of static criteria alone");
    p.axial_limit = 1e7;
    check(has_limit(C::dang_van, p), "an axial limit is one of all");
  }
} // namespace

int
main()
{
  check_edge_distance(true);
  check_edge_distance(false);
  check_leading_edge();
  check_drawn_face(true);
  check_drawn_face(false);
  check_areas();
  check_limits();
}
