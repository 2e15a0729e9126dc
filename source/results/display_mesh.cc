// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/results/display_mesh.h>
#include <squeal/scene/turning.h>

#include <deal.II/base/quadrature_lib.h>

#include <deal.II/distributed/tria.h>

#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_tools.h>
#include <deal.II/fe/fe_values.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace squeal
{
  /** What one rank contributes; points are numbered over all ranks, the
   * corners of rigid bodies first. */
  struct DisplayMesh::Parts
  {
    unsigned int                        n_rigid_points = 0;
    std::vector<double>                 points;
    std::vector<Eigen::Triplet<double>> entries; /**< of the map */
    std::vector<std::int32_t>           hexahedra, quads;
    std::vector<std::int32_t>           hexahedron_body, quad_body;
  };



  namespace
  {
    /** The (n + 1)^3 points of a cell. Their numbers over the whole mesh are
     * those of the degrees of freedom of Lagrange elements of degree n. */
    class CellLattice
    {
    public:
      explicit CellLattice(const unsigned int n)
        : n(n)
        , fe(dealii::QIterated<1>(dealii::QTrapezoid<1>(), n))
        , position(dealii::FETools::lexicographic_to_hierarchic_numbering<3>(n))
        , indices(fe.n_dofs_per_cell())
      {
      }

      void
      reinit(const dealii::DoFHandler<3>::active_cell_iterator &cell,
             const unsigned int                                 first_number)
      {
        cell->get_dof_indices(indices);
        for (auto &i : indices)
          i += first_number;
      }

      /** A single cube whose corners are numbered from @p first on. */
      void
      reinit(const std::int32_t first)
      {
        Assert(n == 1, dealii::ExcInternalError());
        std::iota(indices.begin(), indices.end(), first);
      }

      std::int32_t
      at(const std::array<unsigned int, 3> &ijk) const
      {
        return indices[position[(ijk[2] * (n + 1) + ijk[1]) * (n + 1) +
                                ijk[0]]];
      }

      void
      append_hexahedra(std::vector<std::int32_t> &out) const
      {
        for (unsigned int k = 0; k < n; ++k)
          for (unsigned int j = 0; j < n; ++j)
            for (unsigned int i = 0; i < n; ++i)
              for (const unsigned int dz : {0, 1})
                for (const auto &[dx, dy] : counter_clockwise)
                  out.push_back(at({{i + dx, j + dy, k + dz}}));
      }

      /** Face 0..5 is x min, x max, y min, ... of the cell. */
      void
      append_quads(const unsigned int         face,
                   std::vector<std::int32_t> &out) const
      {
        const unsigned int normal = face / 2;
        const bool         upper  = face % 2 == 1;
        // first x second = normal; swapped where the normal points inwards
        const unsigned int          first  = (normal + (upper ? 1 : 2)) % 3;
        const unsigned int          second = (normal + (upper ? 2 : 1)) % 3;
        std::array<unsigned int, 3> ijk;
        ijk[normal] = upper ? n : 0;
        for (unsigned int b = 0; b < n; ++b)
          for (unsigned int a = 0; a < n; ++a)
            for (const auto &[da, db] : counter_clockwise)
              {
                ijk[first]  = a + da;
                ijk[second] = b + db;
                out.push_back(at(ijk));
              }
      }

      const unsigned int    n;
      const dealii::FE_Q<3> fe;

    private:
      static constexpr std::array<std::pair<unsigned int, unsigned int>, 4>
        counter_clockwise{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};

      const std::vector<unsigned int>              position;
      std::vector<dealii::types::global_dof_index> indices;
    };



    /** Nonzero values of the shape functions at a lattice point. */
    std::vector<std::pair<unsigned int, double>>
    shape_values(const dealii::FiniteElement<3> &fe,
                 const dealii::Point<3>         &unit_point)
    {
      std::vector<std::pair<unsigned int, double>> values;
      for (unsigned int a = 0; a < fe.n_dofs_per_cell(); ++a)
        {
          const double value = fe.shape_value(a, unit_point);
          if (std::abs(value) > 1e-13)
            values.emplace_back(a, value);
        }
      return values;
    }



    template <typename T>
    std::vector<T>
    gather_to_root(const std::vector<T> &mine,
                   const MPI_Datatype    type,
                   const RowSpace       &space)
    {
      const int        n = mine.size();
      std::vector<int> count(space.n_ranks()), first(space.n_ranks(), 0);
      MPI_Gather(
        &n, 1, MPI_INT, count.data(), 1, MPI_INT, 0, space.communicator());
      for (unsigned int r = 1; r < count.size(); ++r)
        first[r] = first[r - 1] + count[r - 1];
      std::vector<T> all(space.rank() == 0 ? first.back() + count.back() : 0);
      MPI_Gatherv(mine.data(),
                  n,
                  type,
                  all.data(),
                  count.data(),
                  first.data(),
                  type,
                  0,
                  space.communicator());
      return all;
    }
  } // namespace



  DisplayMesh::DisplayMesh(const Discretization &discretization,
                           const unsigned int    n_subdivisions)
    : space(discretization.space())
  {
    Assert(n_subdivisions > 0, dealii::ExcMessage("no subdivisions"));
    Parts parts;
    for (const auto &body : discretization.scene().bodies)
      if (body.shape == BodyParameters::Shape::rigid)
        parts.n_rigid_points += 8;

    if (discretization.has_mesh())
      add_mesh(discretization, n_subdivisions, parts);
    find_size(discretization, parts);
    if (space->rank() == 0)
      add_rigid_bodies(discretization, parts);

    map.resize(parts.points.size(), space->n_local());
    map.setFromTriplets(parts.entries.begin(), parts.entries.end());
    gather(parts);
  }



  void
  DisplayMesh::add_mesh(const Discretization &discretization,
                        const unsigned int    n_subdivisions,
                        Parts                &parts) const
  {
    CellLattice           lattice(n_subdivisions);
    dealii::DoFHandler<3> numbers(discretization.triangulation());
    numbers.distribute_dofs(lattice.fe);
    const auto        &unit_points = lattice.fe.get_unit_support_points();
    const unsigned int first_on_rank =
      space->rank() == 0 ? parts.n_rigid_points : 0;
    const auto &owned = numbers.locally_owned_dofs();
    parts.points.resize(3 * (first_on_rank + owned.n_elements()));

    const auto &dofs   = discretization.dof_handler();
    const auto &fe     = dofs.get_fe();
    const auto &scalar = fe.base_element(0);
    std::vector<std::vector<std::pair<unsigned int, double>>> values;
    for (const auto &p : unit_points)
      values.push_back(shape_values(scalar, p));
    dealii::FEValues<3> fe_values(discretization.mapping(),
                                  lattice.fe,
                                  dealii::Quadrature<3>(unit_points),
                                  dealii::update_quadrature_points);

    std::vector<dealii::types::global_dof_index> points(unit_points.size()),
      indices(fe.n_dofs_per_cell());
    std::vector<bool> done(owned.n_elements(), false);
    for (const auto &cell : numbers.active_cell_iterators())
      if (cell->is_locally_owned())
        {
          const Discretization::CellIterator dof_cell(
            &discretization.triangulation(),
            cell->level(),
            cell->index(),
            &dofs);
          fe_values.reinit(cell);
          cell->get_dof_indices(points);
          dof_cell->get_dof_indices(indices);
          for (unsigned int q = 0; q < points.size(); ++q)
            {
              if (!owned.is_element(points[q]))
                continue;
              const unsigned int k = owned.index_within_set(points[q]);
              if (done[k])
                continue;
              done[k] = true;
              for (unsigned int c = 0; c < 3; ++c)
                {
                  const unsigned int row = 3 * (first_on_rank + k) + c;
                  parts.points[row]      = fe_values.quadrature_point(q)[c];
                  for (const auto &[a, value] : values[q])
                    for (const auto &[free, weight] : discretization.expansion(
                           indices[fe.component_to_system_index(c, a)]))
                      parts.entries.emplace_back(
                        row, space->local(free), value * weight);
                }
            }

          lattice.reinit(cell, parts.n_rigid_points);
          lattice.append_hexahedra(parts.hexahedra);
          for (const unsigned int f : cell->face_indices())
            if (cell->face(f)->at_boundary())
              lattice.append_quads(f, parts.quads);
          parts.hexahedron_body.resize(parts.hexahedra.size() / 8,
                                       cell->material_id());
          parts.quad_body.resize(parts.quads.size() / 4, cell->material_id());
        }
  }



  void
  DisplayMesh::find_size(const Discretization &discretization,
                         const Parts          &parts)
  {
    // lower corner and the negative of the upper one: both are minima
    std::array<double, 6> box;
    box.fill(std::numeric_limits<double>::max());
    const auto include = [&](const double *point) {
      for (unsigned int c = 0; c < 3; ++c)
        {
          box[c]     = std::min(box[c], point[c]);
          box[3 + c] = std::min(box[3 + c], -point[c]);
        }
    };
    const unsigned int first =
      space->rank() == 0 ? 3 * parts.n_rigid_points : 0;
    for (unsigned int i = first; i < parts.points.size(); i += 3)
      include(&parts.points[i]);
    for (const auto &body : discretization.scene().bodies)
      if (body.shape == BodyParameters::Shape::rigid)
        {
          const dealii::Point<3> centre = centre_of_gravity(body);
          include(&centre[0]);
        }
    MPI_Allreduce(
      MPI_IN_PLACE, box.data(), 6, MPI_DOUBLE, MPI_MIN, space->communicator());
    diagonal = std::hypot(box[0] + box[3], box[1] + box[4], box[2] + box[5]);
    if (!(diagonal > 0.))
      diagonal = 1.;
  }



  void
  DisplayMesh::add_rigid_bodies(const Discretization &discretization,
                                Parts                &parts) const
  {
    const double half_edge = 0.03 * diagonal;
    CellLattice  cube(1);
    parts.points.resize(
      std::max<std::size_t>(parts.points.size(), 3 * parts.n_rigid_points));
    const auto  &bodies = discretization.scene().bodies;
    unsigned int point  = 0;
    for (unsigned int b = 0; b < bodies.size(); ++b)
      if (bodies[b].shape == BodyParameters::Shape::rigid)
        {
          const dealii::Point<3> centre = centre_of_gravity(bodies[b]);
          const auto             add    = [&](const unsigned int row,
                               const unsigned int motion,
                               const double       weight) {
            const unsigned int free = discretization.rigid_row(b, motion);
            if (free != -1u)
              parts.entries.emplace_back(row, space->local(free), weight);
          };
          for (unsigned int v = 0; v < 8; ++v)
            {
              std::array<double, 3> arm;
              for (unsigned int c = 0; c < 3; ++c)
                arm[c] = (v >> c & 1) ? half_edge : -half_edge;
              for (unsigned int c = 0; c < 3; ++c)
                {
                  const unsigned int row = 3 * (point + v) + c;
                  const unsigned int d = (c + 1) % 3, e = (c + 2) % 3;
                  parts.points[row] = centre[c] + arm[c];
                  // u + r x arm
                  add(row, c, 1.);
                  add(row, 3 + d, arm[e]);
                  add(row, 3 + e, -arm[d]);
                }
            }
          cube.reinit(point);
          cube.append_hexahedra(parts.hexahedra);
          for (unsigned int f = 0; f < 6; ++f)
            cube.append_quads(f, parts.quads);
          parts.hexahedron_body.resize(parts.hexahedra.size() / 8, b);
          parts.quad_body.resize(parts.quads.size() / 4, b);
          point += 8;
        }
  }



  void
  DisplayMesh::gather(const Parts &parts)
  {
    gathered.points    = gather_to_root(parts.points, MPI_DOUBLE, *space);
    gathered.hexahedra = gather_to_root(parts.hexahedra, MPI_INT32_T, *space);
    gathered.quads     = gather_to_root(parts.quads, MPI_INT32_T, *space);
    gathered.hexahedron_body =
      gather_to_root(parts.hexahedron_body, MPI_INT32_T, *space);
    gathered.quad_body = gather_to_root(parts.quad_body, MPI_INT32_T, *space);
    gathered.hexahedron_rank = gather_to_root(
      std::vector<std::int32_t>(parts.hexahedron_body.size(), space->rank()),
      MPI_INT32_T,
      *space);

    const int n = parts.points.size();
    rows_of_rank.resize(space->n_ranks());
    MPI_Allgather(
      &n, 1, MPI_INT, rows_of_rank.data(), 1, MPI_INT, space->communicator());
    first_of_rank.assign(space->n_ranks(), 0);
    std::partial_sum(
      rows_of_rank.begin(), rows_of_rank.end() - 1, first_of_rank.begin() + 1);
  }



  Eigen::MatrixXd
  DisplayMesh::displacements(const Block &owned) const
  {
    const Eigen::MatrixXd mine = map * space->gather(owned);
    if (space->n_ranks() == 1)
      return mine;
    Eigen::MatrixXd all;
    if (space->rank() == 0)
      all.resize(gathered.points.size(), owned.cols());
    for (int j = 0; j < owned.cols(); ++j)
      MPI_Gatherv(mine.col(j).data(),
                  mine.rows(),
                  MPI_DOUBLE,
                  space->rank() == 0 ? all.col(j).data() : nullptr,
                  rows_of_rank.data(),
                  first_of_rank.data(),
                  MPI_DOUBLE,
                  0,
                  space->communicator());
    return all;
  }



  double
  phase_of_largest_motion(const RowSpace &space,
                          const Block    &real,
                          const Block    &imaginary)
  {
    if (imaginary.cols() == 0)
      return 0.;
    Block both(real.rows(), 2);
    both << real, imaginary;
    const Eigen::MatrixXd products = space.dot(both, both);
    // sum u^2 = |sum u^2| e^(i alpha): the ellipses' long axes at -alpha/2
    return -0.5 *
           std::atan2(2. * products(0, 1), products(0, 0) - products(1, 1));
  }
} // namespace squeal
