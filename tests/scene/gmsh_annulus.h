// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tests_gmsh_annulus_h
#define squeal_tests_gmsh_annulus_h

#include <squeal/parameters/scene_parameters.h>

#include <array>
#include <cmath>
#include <fstream>
#include <iomanip>
#include <sstream>
#include <string>
#include <vector>

namespace squeal
{
  namespace testing
  {
    /** Writes an annulus as a mesh of first or second order whose nodes lie on
     * cylinders, with the faces "inner", "outer", "z_min", "z_max". */
    class AnnulusFile
    {
    public:
      /** @p n_nodes of a cell: 8, 20 or 27. */
      AnnulusFile(const BodyParameters &body, const unsigned int n_nodes)
        : body(body)
        , n_nodes(n_nodes)
        , n{{2 * body.cells[0], 2 * body.cells[1], 2 * body.cells[2]}}
      {
      }

      /** Changes nodes before they are written. */
      template <typename Change>
      void
      write_2(const std::string &name, const Change &change) const
      {
        std::ofstream out(name);
        out << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n" << names();
        out << "$Nodes\n" << n_points() << "\n" << std::setprecision(17);
        for (unsigned int p = 0; p < n_points(); ++p)
          out << p + 1 << spaced(change(point(p))) << "\n";
        out << "$EndNodes\n$Elements\n"
            << quads().size() + cells().size() << "\n";
        unsigned int tag = 1;
        for (const auto &[face, quad] : quads())
          out << tag++ << ' ' << type_of_quad() << " 2 " << face << " 1"
              << spaced(quad) << "\n";
        for (const auto &cell : cells())
          out << tag++ << ' ' << type_of_cell() << " 2 9 1" << spaced(cell)
              << "\n";
        out << "$EndElements\n";
      }

      void
      write_2(const std::string &name) const
      {
        write_2(name, [](const auto &x) { return x; });
      }

      void
      write_4(const std::string &name) const
      {
        std::ofstream out(name);
        out << "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n"
            << names() << "$Entities\n0 0 4 1\n";
        for (unsigned int face = 1; face <= 4; ++face)
          out << face << " -1 -1 -1 1 1 1 1 " << face << " 0\n";
        out << "9 -1 -1 -1 1 1 1 1 9 0\n$EndEntities\n$Nodes\n1 " << n_points()
            << " 1 " << n_points() << "\n3 9 0 " << n_points() << "\n"
            << std::setprecision(17);
        for (unsigned int p = 0; p < n_points(); ++p)
          out << p + 1 << "\n";
        for (unsigned int p = 0; p < n_points(); ++p)
          out << spaced(point(p)) << "\n";
        out << "$EndNodes\n$Elements\n5 " << quads().size() + cells().size()
            << " 1 " << quads().size() + cells().size() << "\n";
        unsigned int tag = 1;
        for (unsigned int face = 1; face <= 4; ++face)
          {
            std::string  lines;
            unsigned int count = 0;
            for (const auto &[id, quad] : quads())
              if (id == face)
                {
                  lines += std::to_string(tag++) + spaced(quad) + "\n";
                  ++count;
                }
            out << "2 " << face << ' ' << type_of_quad() << ' ' << count << "\n"
                << lines;
          }
        out << "3 9 " << type_of_cell() << ' ' << cells().size() << "\n";
        for (const auto &cell : cells())
          out << tag++ << spaced(cell) << "\n";
        out << "$EndElements\n";
      }

    private:
      using Point = std::array<double, 3>;
      using Nodes = std::vector<unsigned int>;

      static std::string
      names()
      {
        return "$PhysicalNames\n5\n2 1 \"inner\"\n2 2 \"outer\"\n2 3 "
               "\"z_min\"\n2 4 \"z_max\"\n3 9 \"disc\"\n$EndPhysicalNames\n";
      }

      template <typename Numbers>
      static std::string
      spaced(const Numbers &numbers)
      {
        std::ostringstream text;
        text << std::setprecision(17);
        for (const auto &x : numbers)
          text << ' ' << x;
        return text.str();
      }

      unsigned int
      type_of_cell() const
      {
        return n_nodes == 8 ? 5 : n_nodes == 20 ? 17 : 12;
      }

      unsigned int
      type_of_quad() const
      {
        return n_nodes == 8 ? 3 : n_nodes == 20 ? 16 : 10;
      }

      /** The lattice has nodes that cells of 8 and 20 nodes leave unused. */
      unsigned int
      n_points() const
      {
        return n[0] * (n[1] + 1) * (n[2] + 1);
      }

      unsigned int
      number(const unsigned int i,
             const unsigned int j,
             const unsigned int k) const
      {
        return 1 + i % n[0] + n[0] * (j + (n[1] + 1) * k);
      }

      Point
      point(const unsigned int p) const
      {
        const double theta = 2. * M_PI * (p % n[0]) / n[0];
        const double r =
          body.inner_radius + (body.outer_radius - body.inner_radius) *
                                (p / n[0] % (n[1] + 1)) / n[1];
        return {
          {body.position[0] + r * std::cos(theta),
           body.position[1] + r * std::sin(theta),
           body.position[2] + body.height * (p / n[0] / (n[1] + 1)) / n[2]}};
      }

      /** Nodes of a cell at 0, 1, 2 of (r, theta, z), in Gmsh's order. */
      std::vector<Nodes>
      cells() const
      {
        static const char *const order =
          "000 200 220 020 002 202 222 022 100 010 001 210 201 120 221 021 "
          "102 012 212 122 110 101 011 211 121 112 111";
        std::vector<Nodes> result;
        for (unsigned int k = 0; k < n[2]; k += 2)
          for (unsigned int j = 0; j < n[1]; j += 2)
            for (unsigned int i = 0; i < n[0]; i += 2)
              {
                result.emplace_back();
                for (unsigned int a = 0; a < n_nodes; ++a)
                  result.back().push_back(number(i + order[4 * a + 1] - '0',
                                                 j + order[4 * a] - '0',
                                                 k + order[4 * a + 2] - '0'));
              }
        return result;
      }

      /** Faces and their nodes. */
      std::vector<std::pair<unsigned int, Nodes>>
      quads() const
      {
        static const std::array<std::array<unsigned int, 2>, 9> order{
          {{{0, 0}},
           {{2, 0}},
           {{2, 2}},
           {{0, 2}},
           {{1, 0}},
           {{2, 1}},
           {{1, 2}},
           {{0, 1}},
           {{1, 1}}}};
        const unsigned int n_corners = n_nodes == 8 ? 4 : n_nodes == 20 ? 8 : 9;
        std::vector<std::pair<unsigned int, Nodes>> result;
        const auto add = [&](const unsigned int face, const auto &place) {
          result.push_back({face, {}});
          for (unsigned int a = 0; a < n_corners; ++a)
            result.back().second.push_back(place(order[a][0], order[a][1]));
        };
        for (unsigned int i = 0; i < n[0]; i += 2)
          {
            for (unsigned int k = 0; k < n[2]; k += 2)
              for (const unsigned int j : {0u, n[1]})
                add(j == 0 ? 1 : 2,
                    [&](auto a, auto b) { return number(i + a, j, k + b); });
            for (unsigned int j = 0; j < n[1]; j += 2)
              for (const unsigned int k : {0u, n[2]})
                add(k == 0 ? 3 : 4,
                    [&](auto a, auto b) { return number(i + a, j + b, k); });
          }
        return result;
      }

      const BodyParameters              body;
      const unsigned int                n_nodes;
      const std::array<unsigned int, 3> n;
    };
  } // namespace testing
} // namespace squeal

#endif
