// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/discretization/face_quadrature.h>
#include <squeal/discretization/load_vector.h>

namespace squeal
{
  namespace
  {
    Block
    rigid_load(const Discretization &d,
               const LoadParameters &load,
               const unsigned int    body)
    {
      const auto first = d.space()->first_owned(), n = d.space()->n_owned();
      Block      f = Block::Zero(n, 1);
      for (unsigned int motion = 0; motion < 6; ++motion)
        if (const unsigned int row = d.rigid_row(body, motion);
            row != -1u && row >= first && row < first + n)
          f(row - first, 0) =
            motion < 3 ? load.force[motion] : load.moment[motion - 3];
      return f;
    }
  } // namespace



  Block
  load_vector(const Discretization &d,
              const PointEvaluator &evaluator,
              const LoadParameters &load)
  {
    const unsigned int body = body_index(d.scene(), load.body);
    if (d.scene().bodies[body].shape == BodyParameters::Shape::rigid)
      return rigid_load(d, load, body);
    const FaceQuadrature face = face_quadrature(
      d, face_id(d.coarse_mesh(), d.scene(), load.body, load.face));
    const auto   rows  = evaluator.displacements(body, face.points, 1e-4);
    const double area  = face.total_area();
    const auto   first = d.space()->first_owned(), n = d.space()->n_owned();
    Block        f = Block::Zero(n, 1);
    for (std::size_t q = 0; q < face.points.size(); ++q)
      for (unsigned int c = 0; c < 3; ++c)
        for (const auto &[row, weight] : rows.rows[q][c])
          if (row >= first && row < first + n)
            f(row - first, 0) +=
              (load.force[c] / area - load.pressure * face.normals[q][c]) *
              face.areas[q] * weight;
    return f;
  }
} // namespace squeal
