// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/discretization/face_quadrature.h>

#include <deal.II/base/quadrature_lib.h>

#include <deal.II/distributed/tria.h>

#include <deal.II/fe/fe_values.h>

#include <numeric>

namespace squeal
{
  double
  FaceQuadrature::total_area() const
  {
    return std::accumulate(areas.begin(), areas.end(), 0.);
  }

  dealii::Point<3>
  FaceQuadrature::centre() const
  {
    dealii::Point<3> sum;
    for (std::size_t i = 0; i < points.size(); ++i)
      for (unsigned int c = 0; c < 3; ++c)
        sum[c] += areas[i] * points[i][c] / total_area();
    return sum;
  }



  dealii::Tensor<1, 3>
  FaceQuadrature::normal() const
  {
    dealii::Tensor<1, 3> sum;
    for (std::size_t i = 0; i < points.size(); ++i)
      sum += areas[i] * normals[i];
    return sum / sum.norm();
  }



  std::vector<double>
  all_gather(const std::vector<double> &mine, const MPI_Comm comm)
  {
    int size = static_cast<int>(mine.size()), n_ranks;
    MPI_Comm_size(comm, &n_ranks);
    std::vector<int> sizes(n_ranks), offsets(n_ranks, 0);
    MPI_Allgather(&size, 1, MPI_INT, sizes.data(), 1, MPI_INT, comm);
    for (int r = 1; r < n_ranks; ++r)
      offsets[r] = offsets[r - 1] + sizes[r - 1];
    std::vector<double> all(offsets.back() + sizes.back());
    MPI_Allgatherv(mine.data(),
                   size,
                   MPI_DOUBLE,
                   all.data(),
                   sizes.data(),
                   offsets.data(),
                   MPI_DOUBLE,
                   comm);
    return all;
  }



  FaceQuadrature
  face_quadrature(const Discretization &d,
                  const unsigned int    id,
                  const unsigned int    n_points)
  {
    const dealii::QGauss<2> quadrature(n_points > 0 ? n_points
                                                    : d.degree() + 1);
    dealii::FEFaceValues<3> values(d.mapping(),
                                   d.dof_handler().get_fe(),
                                   quadrature,
                                   dealii::update_quadrature_points |
                                     dealii::update_normal_vectors |
                                     dealii::update_JxW_values);
    std::vector<double>     mine;
    for (const auto &cell : d.dof_handler().active_cell_iterators())
      if (cell->is_locally_owned())
        for (const unsigned int f : cell->face_indices())
          if (cell->face(f)->at_boundary() &&
              cell->face(f)->boundary_id() == id)
            {
              values.reinit(cell, f);
              for (unsigned int q = 0; q < quadrature.size(); ++q)
                {
                  const auto &x = values.quadrature_point(q);
                  const auto &n = values.normal_vector(q);
                  mine.insert(
                    mine.end(),
                    {x[0], x[1], x[2], values.JxW(q), n[0], n[1], n[2]});
                }
            }
    const std::vector<double> all = all_gather(mine, d.space()->communicator());
    if (all.empty())
      {
        const unsigned int body = id / max_faces_per_body,
                           face = id % max_faces_per_body;
        throw InputError("body '" + d.scene().bodies[body].name +
                         "': its face '" +
                         d.coarse_mesh().face_names[body][face] +
                         "' lies inside, joined by a conforming tie or under "
                         "a layer: nothing can act on it; 'Kind = mortar' "
                         "keeps the faces of a tie");
      }
    FaceQuadrature result;
    for (std::size_t k = 0; k < all.size(); k += 7)
      {
        result.points.emplace_back(all[k], all[k + 1], all[k + 2]);
        result.areas.push_back(all[k + 3]);
        result.normals.push_back(
          dealii::Point<3>(all[k + 4], all[k + 5], all[k + 6]));
      }
    return result;
  }
} // namespace squeal
