// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tests_contact_turned_block_h
#define squeal_tests_contact_turned_block_h

#include "scenes.h"
#include "worst.h"

#include <fstream>

namespace squeal
{
  namespace testing
  {
    /**
     * A block as make_block() describes it, from a Gmsh file (format 2.2):
     * nodes off the sides are turned about the vertical axis through the
     * centre, so that edges cross those of a straight mesh at an angle, rad.
     */
    inline BodyParameters
    make_turned_block(const BodyParameters &block, const double angle)
    {
      const auto &n    = block.cells;
      const auto  node = [&](const int i, const int j, const int k) {
        return 1 + i + (int(n[0]) + 1) * (j + (int(n[1]) + 1) * k);
      };
      const std::string file = block.name + ".msh";
      std::ofstream     out(file);
      out.precision(17);
      out << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n7\n";
      const std::array<std::string, 6> names{
        {"x_min", "x_max", "y_min", "y_max", "z_min", "z_max"}};
      for (unsigned int f = 0; f < 6; ++f)
        out << "2 " << f + 1 << " \"" << names[f] << "\"\n";
      out << "3 7 \"solid\"\n$EndPhysicalNames\n$Nodes\n"
          << (n[0] + 1) * (n[1] + 1) * (n[2] + 1) << "\n";
      for (unsigned int k = 0; k <= n[2]; ++k)
        for (unsigned int j = 0; j <= n[1]; ++j)
          for (unsigned int i = 0; i <= n[0]; ++i)
            {
              double x            = block.size[0] * (double(i) / n[0] - .5),
                     y            = block.size[1] * (double(j) / n[1] - .5);
              const bool   inside = i > 0 && i < n[0] && j > 0 && j < n[1];
              const double turn = inside ? angle : 0., x_old = x;
              x = std::cos(turn) * x - std::sin(turn) * y;
              y = std::sin(turn) * x_old + std::cos(turn) * y;
              out << node(i, j, k) << ' ' << x << ' ' << y << ' '
                  << block.size[2] * k / n[2] << "\n";
            }
      std::vector<std::string> elements;
      const auto add = [&](const std::string &head, const std::vector<int> &v) {
        std::string line = head;
        for (const int i : v)
          line += ' ' + std::to_string(i);
        elements.push_back(line);
      };
      for (int k = 0; k < int(n[2]); ++k)
        for (int j = 0; j < int(n[1]); ++j)
          for (int i = 0; i < int(n[0]); ++i)
            {
              std::array<int, 8> v;
              for (int c = 0; c < 8; ++c)
                v[c] = node(i + (c & 1), j + ((c >> 1) & 1), k + (c >> 2));
              add("5 2 7 1", {v[0], v[1], v[3], v[2], v[4], v[5], v[7], v[6]});
              if (i == 0)
                add("3 2 1 1", {v[0], v[2], v[6], v[4]});
              if (i + 1 == int(n[0]))
                add("3 2 2 1", {v[1], v[3], v[7], v[5]});
              if (j == 0)
                add("3 2 3 1", {v[0], v[1], v[5], v[4]});
              if (j + 1 == int(n[1]))
                add("3 2 4 1", {v[2], v[3], v[7], v[6]});
              if (k == 0)
                add("3 2 5 1", {v[0], v[1], v[3], v[2]});
              if (k + 1 == int(n[2]))
                add("3 2 6 1", {v[4], v[5], v[7], v[6]});
            }
      out << "$EndNodes\n$Elements\n" << elements.size() << "\n";
      for (std::size_t e = 0; e < elements.size(); ++e)
        out << e + 1 << ' ' << elements[e] << "\n";
      out << "$EndElements\n";

      BodyParameters body = block;
      body.shape          = BodyParameters::Shape::gmsh;
      body.mesh_file      = file;
      return body;
    }

    /** Refines one cell of a body that reaches its top. */
    inline void
    refine_one_cell(Discretization    &d,
                    const unsigned int body,
                    const double       x,
                    const double       y)
    {
      std::vector<double> marks(d.triangulation().n_active_cells(), 0.);
      Worst               height;
      double              nearest = 1e300;
      dealii::CellId      chosen;
      for (const auto &cell : d.dof_handler().active_cell_iterators())
        if (cell->material_id() == body)
          height.add(cell->center()[2]);
      for (const auto &cell : d.dof_handler().active_cell_iterators())
        if (const double distance =
              std::hypot(cell->center()[0] - x, cell->center()[1] - y);
            cell->material_id() == body &&
            cell->center()[2] > height.largest() - 1e-9 && distance < nearest)
          {
            nearest = distance;
            chosen  = cell->id();
          }
      for (const auto &cell : d.dof_handler().active_cell_iterators())
        if (cell->id() == chosen)
          marks[cell->active_cell_index()] = 1.;
      d.refine(marks, .9);
    }
  } // namespace testing
} // namespace squeal

#endif
