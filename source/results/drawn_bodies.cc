// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>

#include <squeal/results/drawn_bodies.h>

#include <cmath>

namespace squeal
{
  namespace
  {
    constexpr int position_bits = 20;
  }



  Rounding::Rounding(const double largest, const int bits)
  {
    int exponent = 0;
    std::frexp(largest, &exponent);
    step = largest > 0. ? std::ldexp(1., exponent - bits) : 1.;
  }



  void
  on_root(const RowSpace &space, const std::function<void()> &action)
  {
    std::string   text;
    unsigned long head[2] = {0, 0}; // kind of failure, length of the text
    if (space.rank() == 0)
      try
        {
          action();
        }
      catch (const InputError &e)
        {
          text    = e.what();
          head[0] = 1;
        }
      catch (const std::exception &e)
        {
          text    = e.what();
          head[0] = 2;
        }
    head[1] = text.size();
    MPI_Bcast(head, 2, MPI_UNSIGNED_LONG, 0, space.communicator());
    if (head[0] == 0)
      return;
    text.resize(head[1]);
    MPI_Bcast(&text[0], head[1], MPI_CHAR, 0, space.communicator());
    if (head[0] == 1)
      throw InputError(text);
    throw ComputationError(text);
  }



  DrawnBodies::DrawnBodies(const Discretization &discretization,
                           const DisplayMesh    &mesh,
                           const bool            surface)
  {
    const auto &g       = mesh.geometry();
    auto        corners = surface ? g.quads : g.hexahedra;

    std::vector<std::int32_t> number(g.n_points(), -1);
    for (auto &corner : corners)
      {
        if (number[corner] < 0)
          {
            number[corner] = drawn_points.size();
            drawn_points.push_back(corner);
          }
        corner = number[corner];
      }

    const auto               &body = surface ? g.quad_body : g.hexahedron_body;
    const unsigned int        n_corners = surface ? 4 : 8;
    const std::uint8_t        vtk_quad = 9, vtk_hexahedron = 12;
    std::vector<std::int32_t> ends(body.size());
    for (unsigned int i = 0; i < ends.size(); ++i)
      ends[i] = (i + 1) * n_corners;

    common.n_points = drawn_points.size();
    common.n_cells  = body.size();
    common.scalars  = "body";
    common.points   = point_vector(
      "Points",
      [&g](const unsigned int i) { return g.points[i]; },
      Rounding(mesh.size(), position_bits));
    common.cell_data = vtk::data_array("body", 1, body);
    if (discretization.space()->n_ranks() > 1 && !surface)
      common.cell_data += vtk::data_array("subdomain", 1, g.hexahedron_rank);
    common.cells =
      vtk::data_array("connectivity", 1, corners) +
      vtk::data_array("offsets", 1, ends) +
      vtk::data_array("types",
                      1,
                      std::vector<std::uint8_t>(
                        body.size(), surface ? vtk_quad : vtk_hexahedron));
    std::vector<std::string> names;
    for (const auto &b : discretization.scene().bodies)
      names.push_back(b.name);
    common.field_data = vtk::texts("body_names", names);
  }



  const vtk::UnstructuredGrid &
  DrawnBodies::grid() const
  {
    return common;
  }

  std::string
  DrawnBodies::point_vector(const std::string                         &name,
                            const std::function<double(unsigned int)> &value,
                            const Rounding &rounded) const
  {
    std::vector<float> values;
    values.reserve(3 * drawn_points.size());
    for (const unsigned int p : drawn_points)
      for (unsigned int i = 3 * p; i < 3 * p + 3; ++i)
        values.push_back(rounded(value(i)));
    return vtk::data_array(name, 3, values);
  }
} // namespace squeal
