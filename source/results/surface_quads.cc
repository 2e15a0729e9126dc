// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/results/surface_quads.h>

#include <algorithm>
#include <cmath>

namespace squeal
{
  SurfaceQuads::SurfaceQuads(const Discretization &discretization,
                             const unsigned int    n_subdivisions)
    : mesh(discretization, n_subdivisions)
  {
  }



  std::vector<SurfaceQuad>
  SurfaceQuads::evaluate(const Block &column) const
  {
    AssertDimension(column.cols(), 1);
    const Eigen::MatrixXd    u = mesh.displacements(column);
    const auto              &g = mesh.geometry();
    std::vector<SurfaceQuad> quads(g.quad_body.size());
    for (unsigned int q = 0; q < quads.size(); ++q)
      {
        quads[q].body = g.quad_body[q];
        for (unsigned int v = 0; v < 4; ++v)
          for (unsigned int c = 0; c < 3; ++c)
            {
              const unsigned int row       = 3 * g.quads[4 * q + v] + c;
              quads[q].corners[v][c]       = g.points[row];
              quads[q].displacements[v][c] = u(row, 0);
            }
      }
    return quads;
  }



  std::vector<SurfaceQuad>
  SurfaceQuads::evaluate(const Block &real,
                         const Block &imaginary,
                         const double phase) const
  {
    if (imaginary.cols() == 0)
      return evaluate(std::cos(phase) * real);
    return evaluate(std::cos(phase) * real - std::sin(phase) * imaginary);
  }



  double
  SurfaceQuads::size() const
  {
    return mesh.size();
  }



  double
  largest_displacement(const std::vector<SurfaceQuad> &quads)
  {
    double largest = 0.;
    for (const auto &quad : quads)
      for (const auto &u : quad.displacements)
        largest = std::max(largest, std::hypot(u[0], u[1], u[2]));
    return largest;
  }
} // namespace squeal
