// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tests_mesh_texts_h
#define squeal_tests_mesh_texts_h

#include <squeal/scene/coarse_mesh.h>
#include <squeal/scene/mesh_file.h>

#include "check.h"

#include <array>
#include <fstream>
#include <iomanip>
#include <sstream>
#include <string>
#include <vector>

namespace squeal
{
  namespace testing
  {
    /** Pairs of corners, from 1, whose middle points follow the corners of a
     * hexahedron; from the manuals of the three programs. */
    using Edges = std::array<std::array<int, 2>, 12>;
    constexpr Edges edges_of_gmsh{{{{1, 2}},
                                   {{1, 4}},
                                   {{1, 5}},
                                   {{2, 3}},
                                   {{2, 6}},
                                   {{3, 4}},
                                   {{3, 7}},
                                   {{4, 8}},
                                   {{5, 6}},
                                   {{5, 8}},
                                   {{6, 7}},
                                   {{7, 8}}}};
    constexpr Edges edges_of_abaqus{{{{1, 2}},
                                     {{2, 3}},
                                     {{3, 4}},
                                     {{1, 4}},
                                     {{5, 6}},
                                     {{6, 7}},
                                     {{7, 8}},
                                     {{5, 8}},
                                     {{1, 5}},
                                     {{2, 6}},
                                     {{3, 7}},
                                     {{4, 8}}}};
    constexpr Edges edges_of_nastran{{{{1, 2}},
                                      {{2, 3}},
                                      {{3, 4}},
                                      {{1, 4}},
                                      {{1, 5}},
                                      {{2, 6}},
                                      {{3, 7}},
                                      {{4, 8}},
                                      {{5, 6}},
                                      {{6, 7}},
                                      {{7, 8}},
                                      {{5, 8}}}};

    /** The nodes of a cell in another program's order; Abaqus has the centre
     * before the faces S1 to S6: z min, z max, y min, x max, y max, x min. */
    inline std::vector<unsigned int>
    reordered(const std::vector<unsigned int> &gmsh, const Edges &order)
    {
      std::vector<unsigned int> result(gmsh.begin(), gmsh.begin() + 8);
      if (gmsh.size() > 8)
        for (const auto &edge : order)
          for (unsigned int e = 0; e < 12; ++e)
            if (edges_of_gmsh[e] == edge)
              result.push_back(gmsh[8 + e]);
      if (gmsh.size() == 27)
        for (const int i : {26, 20, 25, 21, 23, 24, 22})
          result.push_back(gmsh[i]);
      return result;
    }

    /** An Abaqus file without parts that holds what a Gmsh file holds; an
     * element set for each physical volume and a surface for each physical
     * surface. */
    inline std::string
    abaqus_text(const MeshFile &file)
    {
      std::ostringstream out;
      out << std::setprecision(17) << "*Heading\n a disc\n** nodes\n*Node\n";
      for (unsigned int n = 0; n < file.nodes.size(); ++n)
        out << n + 1 << ", " << file.nodes[n][0] << ", " << file.nodes[n][1]
            << ", " << file.nodes[n][2] << "\n";
      std::string type;
      for (const auto &element : file.elements)
        if (element.kind == MeshFile::Kind::hexahedron)
          {
            const auto nodes = reordered(element.nodes, edges_of_abaqus);
            if (type.empty())
              out << "*Element, type="
                  << (type = "C3D" + std::to_string(nodes.size()) +
                             (nodes.size() < 27 ? "R" : ""))
                  << ", elset=all cells\n";
            out << element.tag;
            for (unsigned int i = 0; i < nodes.size(); ++i)
              out << (i % 10 == 9 ? ",\n " : ", ") << nodes[i] + 1;
            out << "\n";
          }
      for (const auto &[tag, name] : file.volume_names)
        {
          out << "*Elset, elset=" << name << "\n";
          for (const auto &cell : file.elements)
            if (cell.kind == MeshFile::Kind::hexahedron &&
                file.groups[cell.group] == std::vector<int>{tag})
              out << cell.tag << ",\n";
        }
      // S1 to S6 by their corners in the manual
      static const int corners[6][4] = {{1, 2, 3, 4},
                                        {5, 8, 7, 6},
                                        {1, 5, 6, 2},
                                        {2, 6, 7, 3},
                                        {3, 7, 8, 4},
                                        {4, 8, 5, 1}};
      std::map<std::set<unsigned int>, std::string> face_of;
      for (const auto &cell : file.elements)
        if (cell.kind == MeshFile::Kind::hexahedron)
          for (unsigned int s = 0; s < 6; ++s)
            {
              std::set<unsigned int> key;
              for (const int c : corners[s])
                key.insert(cell.nodes[c - 1]);
              face_of[key] =
                std::to_string(cell.tag) + ", S" + std::to_string(s + 1);
            }
      for (const auto &[tag, name] : file.surface_names)
        {
          out << "*Surface, type=ELEMENT, name=" << name << "\n";
          for (const auto &face : file.elements)
            if (face.kind == MeshFile::Kind::quadrilateral &&
                file.groups[face.group] == std::vector<int>{tag})
              out << face_of.at({face.nodes.begin(), face.nodes.begin() + 4})
                  << "\n";
        }
      return out.str();
    }

    enum class Format
    {
      small,
      large,
      free
    };

    /** One entry with its continuation lines. */
    inline std::string
    bulk_entry(const std::vector<std::string> &fields, const Format format)
    {
      std::ostringstream out;
      const unsigned int n     = format == Format::large ? 4 : 8;
      const int          width = format == Format::large ? 16 : 8;
      for (std::size_t i = 1, line = 0; i < fields.size(); i += n, ++line)
        {
          const std::string mark = "+E" + std::to_string(line);
          if (format == Format::free)
            out << (line == 0 ? fields[0] : "");
          else
            out << std::left << std::setw(8)
                << (format == Format::large
                      ? (line == 0 ? fields[0] + "*"
                                   : "*E" + std::to_string(line - 1))
                    : line == 0 ? fields[0]
                                : "+E" + std::to_string(line - 1));
          for (std::size_t k = i; k < i + n; ++k)
            {
              const std::string field = k < fields.size() ? fields[k] : "";
              if (format == Format::free)
                out << "," << field;
              else
                out << std::left << std::setw(width) << field;
            }
          if (i + n < fields.size())
            out << (format == Format::free ? "," + mark : mark);
          out << "\n";
        }
      return out.str();
    }

    /** A real number of at most @p width characters. */
    inline std::string
    bulk_number(const double x, const unsigned int width)
    {
      for (int digits = 17; digits > 0; --digits)
        {
          std::ostringstream out;
          out << std::setprecision(digits) << std::fixed << x;
          std::string text = out.str();
          if (const auto zero = text.find("0.");
              zero == 0 || (zero == 1 && text[0] == '-'))
            text.erase(zero, 1);
          if (text.size() <= width)
            return text;
        }
      return "0.";
    }

    /** Bulk data of what a Gmsh file holds; properties are the physical
     * groups, surfaces are skins of CQUAD4. */
    inline std::string
    nastran_text(const MeshFile &file, const Format format)
    {
      std::string text = "SOL 103\nCEND\nECHO=NONE\nBEGIN BULK\n$ a disc\n";
      for (unsigned int n = 0; n < file.nodes.size(); ++n)
        {
          std::vector<std::string> entry{"GRID", std::to_string(n + 1), ""};
          for (unsigned int c = 0; c < 3; ++c)
            entry.push_back(
              bulk_number(file.nodes[n][c], format == Format::small ? 8 : 16));
          text += bulk_entry(entry, format);
        }
      for (const auto &element : file.elements)
        {
          const bool is_cell = element.kind == MeshFile::Kind::hexahedron;
          std::vector<std::string> entry{
            is_cell ? "CHEXA" : "CQUAD4",
            std::to_string(element.tag),
            std::to_string(file.groups[element.group][0])};
          const auto nodes =
            is_cell ? reordered(element.nodes, edges_of_nastran)
                    : std::vector<unsigned int>(element.nodes.begin(),
                                                element.nodes.begin() + 4);
          for (const unsigned int n : nodes)
            entry.push_back(std::to_string(n + 1));
          text += bulk_entry(entry, format);
        }
      return text + "ENDDATA\n";
    }

    /** Makes the body of a file's text. */
    inline BodyMesh
    mesh_of(const std::string              &text,
            const BodyParameters::Shape     shape,
            const std::string              &volume = "",
            const std::vector<std::string> &faces  = {})
    {
      BodyParameters body;
      body.name            = "disc";
      body.shape           = shape;
      body.mesh_file       = shape == BodyParameters::Shape::gmsh     ? "in.msh"
                             : shape == BodyParameters::Shape::abaqus ? "in.inp"
                                                                      : "in.bdf";
      body.physical_volume = volume;
      body.mesh_faces      = faces;
      std::ofstream(body.mesh_file, std::ios::binary) << text;
      return read_mesh_body(body);
    }



    /** An Abaqus file of two cells, mm and tonnes. */
    inline const std::string two_cells = R"(*HEADING
two cells on top of each other
*NODE, NSET=all
1, 0, 0, 0
2, 1, 0, 0
3, 1, 1, 0
4, 0, 1, 0
5, 0, 0, 1
6, 1, 0, 1
7, 1, 1, 1
8, 0, 1, 1
9, 0, 0, 2
10, 1, 0, 2
11, 1, 1, 2
12, 0, 1, 2
*ELEMENT, TYPE=C3D8I, ELSET=low
10, 1, 2, 3, 4, 5, 6, 7, 8
*ELEMENT, TYPE=C3D8R, ELSET=high
20, 5, 6, 7, 8, 9, 10, 11, 12
*NSET, NSET=floor, GENERATE
1, 4, 1
*NSET, NSET="roof"
 9, 10, 11,
 12
*ELSET, ELSET=both
low, high
*SURFACE, NAME=skin
both,
*SURFACE, NAME=Side
both, S4
*SURFACE, NAME=points, TYPE=NODE
roof,
*MATERIAL, NAME=Steel
*DENSITY
7.85e-9,
*ELASTIC
210000., .3
*SOLID SECTION, ELSET=both, MATERIAL=STEEL
,
*STEP
*FREQUENCY
10,
*END STEP
)";

    /** A Nastran file of one cell, mm and tonnes. */
    inline const std::string one_cell = R"(BEGIN BULK
GRID    1               0.      0.      0.
GRID    2               1.      0.      0.
GRID    3               1.      1.      0.
GRID    4               0.      1.      0.
GRID    5               0.      0.      1.
GRID    6               1.      0.      1.
GRID    7               1.      1.      1.
GRID    8               0.      1.      1.
GRID,21,,.5,0.,-.05
CHEXA   1       7       1       2       3       4       5       6       +A
+A      7       8       21
PSOLID  7       3
MAT1*   3               2.1+5                           .3
*       7.85-9
PLOAD4  5       1       1.0                             1       3
SET1,11,5,THRU,8
SET3,12,ELEM,1
RBE2,99,1,123,2,3
ENDDATA
)";

    /** @p text with the first @p old replaced. */
    inline std::string
    replaced_word(std::string        text,
                  const std::string &old,
                  const std::string &by)
    {
      const auto at = text.find(old);
      check(at != std::string::npos, "the test changes '" + old + "'");
      return text.replace(at, old.size(), by);
    }
  } // namespace testing
} // namespace squeal

#endif
