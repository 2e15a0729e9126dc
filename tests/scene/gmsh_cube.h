// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tests_gmsh_cube_h
#define squeal_tests_gmsh_cube_h

#include <squeal/scene/coarse_mesh.h>

#include "check.h"

#include <array>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace squeal
{
  namespace testing
  {
    using Corner = std::array<int, 3>;

    /** A cube of 2 x 2 x 2 cells with edge length 1, its lower half the
     * physical volume "lower", the other one "upper"; the sides "left" (x = 0)
     * and "right" (x = 1), and "middle" between the two volumes. */
    struct Cube
    {
      /** Node numbers of the 8 corners of each cell, in Gmsh's order. */
      std::array<std::array<int, 8>, 8>     cells;
      std::array<std::array<double, 3>, 27> nodes;
      int                                   n_nodes = 27;

      Cube()
      {
        for (int n = 0; n < 27; ++n)
          nodes[n] = {{0.5 * (n % 3), 0.5 * (n / 3 % 3), 0.5 * (n / 9)}};
        for (int c = 0; c < 8; ++c)
          cells[c] = cell({{c % 2, c / 2 % 2, c / 4}});
      }

      static int
      node(const Corner &ijk)
      {
        return 1 + ijk[0] + 3 * ijk[1] + 9 * ijk[2];
      }

      static std::array<int, 8>
      cell(const Corner &o)
      {
        static const std::array<Corner, 8> order{{{{0, 0, 0}},
                                                  {{1, 0, 0}},
                                                  {{1, 1, 0}},
                                                  {{0, 1, 0}},
                                                  {{0, 0, 1}},
                                                  {{1, 0, 1}},
                                                  {{1, 1, 1}},
                                                  {{0, 1, 1}}}};
        std::array<int, 8>                 result;
        for (unsigned int v = 0; v < 8; ++v)
          result[v] = node(
            {{o[0] + order[v][0], o[1] + order[v][1], o[2] + order[v][2]}});
        return result;
      }

      /** The 4 quads of the plane @p normal = @p level. */
      static std::vector<std::array<int, 4>>
      plane(const int normal, const int level)
      {
        const int a = (normal + 1) % 3, b = (normal + 2) % 3;
        std::vector<std::array<int, 4>> quads;
        for (int i = 0; i < 2; ++i)
          for (int j = 0; j < 2; ++j)
            {
              quads.emplace_back();
              unsigned int v = 0;
              for (const auto &[da, db] :
                   {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}})
                {
                  Corner ijk;
                  ijk[normal]       = level;
                  ijk[a]            = i + da;
                  ijk[b]            = j + db;
                  quads.back()[v++] = node(ijk);
                }
            }
        return quads;
      }
    };

    inline const std::string names =
      "$PhysicalNames\n5\n2 1 \"left\"\n2 2 \"right side\"\n"
      "2 3 \"middle\"\n3 11 \"lower\"\n3 12 \"upper\"\n"
      "$EndPhysicalNames\n";

    template <typename Numbers>
    std::string
    spaced(const Numbers &numbers)
    {
      std::ostringstream text;
      for (const auto &n : numbers)
        text << ' ' << n;
      return text.str();
    }

    inline std::string
    version_2(const Cube &cube)
    {
      std::ostringstream out;
      out << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n"
          << names << "$Nodes\n"
          << cube.n_nodes << "\n";
      for (int n = 0; n < cube.n_nodes; ++n)
        out << n + 1 << spaced(cube.nodes[n]) << "\n";
      out << "$EndNodes\n$Elements\n21\n1 15 2 0 1 1\n";
      int tag = 2;
      for (const auto &[physical, level, normal] :
           {std::array<int, 3>{{1, 0, 0}}, {{2, 2, 0}}, {{3, 1, 2}}})
        for (const auto &quad : Cube::plane(normal, level))
          out << tag++ << " 3 2 " << physical << " 7" << spaced(quad) << "\n";
      for (unsigned int c = 0; c < 8; ++c)
        out << tag++ << " 5 2 " << (c < 4 ? 11 : 12) << " 1"
            << spaced(cube.cells[c]) << "\n";
      out << "$EndElements\n";
      return out.str();
    }

    /** With nodes in several blocks, a parametric one among them, numbers with
     * gaps and the line ends of Windows. */
    inline std::string
    version_4(const Cube &cube)
    {
      std::ostringstream out;
      out
        << "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n"
        << names
        << "$Entities\n1 1 3 2\n1 0 0 0 0\n1 0 0 0 1 1 1 0 2 1 -1\n"
           "5 0 0 0 0 1 1 1 1 0\n6 1 0 0 1 1 1 1 2 0\n7 0 0 .5 1 1 .5 1 3 0\n"
           "1 0 0 0 1 1 .5 1 11 6 5 6 7\n2 0 0 .5 1 1 1 1 12 0\n$EndEntities\n"
        << "$Nodes\n2 " << cube.n_nodes << " 10 " << 10 * cube.n_nodes << "\n";
      for (int block = 0; block < 2; ++block)
        {
          const int begin = block * 10, end = block == 0 ? 10 : cube.n_nodes;
          out << (block == 0 ? "2 5 1 " : "3 1 0 ") << end - begin << "\n";
          for (int n = begin; n < end; ++n)
            out << 10 * (n + 1) << "\n";
          for (int n = begin; n < end; ++n)
            out << spaced(cube.nodes[n]) << (block == 0 ? " 0.1 0.2" : "")
                << "\n";
        }
      out << "$EndNodes\n$Periodic\n0\n$EndPeriodic\n"
          << "$Elements\n6 21 1 21\n0 1 15 1\n1 10\n";
      int        tag     = 2;
      const auto element = [&](const auto &nodes) {
        out << tag++;
        for (const int n : nodes)
          out << ' ' << 10 * n;
        out << " \n";
      };
      for (const auto &[entity, level, normal] :
           {std::array<int, 3>{{5, 0, 0}}, {{6, 2, 0}}, {{7, 1, 2}}})
        {
          out << "2 " << entity << " 3 4\n";
          for (const auto &quad : Cube::plane(normal, level))
            element(quad);
        }
      for (unsigned int half = 0; half < 2; ++half)
        {
          out << "3 " << half + 1 << " 5 4\n";
          for (unsigned int c = 0; c < 4; ++c)
            element(cube.cells[4 * half + c]);
        }
      out << "$EndElements\n";
      std::string text;
      for (const char c : out.str())
        text += c == '\n' ? std::string("\r\n") : std::string(1, c);
      return text;
    }

    inline BodyMesh
    read(const std::string &text, const std::string &volume = "")
    {
      std::ofstream("mesh.msh", std::ios::binary) << text;
      BodyParameters body;
      body.name            = "pad";
      body.shape           = BodyParameters::Shape::gmsh;
      body.mesh_file       = "mesh.msh";
      body.physical_volume = volume;
      body.position        = {{10., 20., 30.}};
      return read_mesh_body(body);
    }

    inline std::string
    replaced(std::string text, const std::string &old, const std::string &by)
    {
      const auto at = text.find(old);
      if (at == std::string::npos)
        check(false, "the test changes '" + old + "'");
      return text.replace(at, old.size(), by);
    }

    /** The cube in format 2.2 with a 22nd element. */
    inline std::string
    with_element(const Cube &cube, const std::string &element)
    {
      return replaced(
        replaced(version_2(cube), "$Elements\n21", "$Elements\n22"),
        "$EndElements",
        "22 " + element + "\n$EndElements");
    }
  } // namespace testing
} // namespace squeal

#endif
