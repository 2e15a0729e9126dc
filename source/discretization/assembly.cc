// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/discretization/assembly.h>
#include <squeal/discretization/element_matrices.h>

#include <deal.II/base/quadrature_lib.h>

#include <deal.II/distributed/tria.h>

#include <Eigen/Dense>

#include <algorithm>
#include <numeric>

namespace squeal
{
  namespace
  {
    /**
     * Local rows of one cell: the free unknowns that its degrees of freedom
     * expand to, ascending, and the matrix T of the expansion (empty when
     * every degree of freedom is one unknown or held).
     */
    struct CellRows
    {
      std::vector<int> rows;
      std::vector<int> component; /**< 0..2 of each row, -1 if mixed */
      std::vector<int> source; /**< degree of freedom of each row, if simple */
      Eigen::MatrixXd  T;      /**< dofs x rows, if not simple */
      bool             simple = true;
    };

    CellRows
    cell_rows(const Discretization               &d,
              const Discretization::CellIterator &cell,
              const ElementMatrices              &element)
    {
      const unsigned int n = cell->get_fe().n_dofs_per_cell();
      std::vector<dealii::types::global_dof_index> dofs(n);
      cell->get_dof_indices(dofs);

      CellRows                         result;
      std::vector<std::array<int, 2>>  found; // row, dof
      std::vector<const Combination *> parts(n);
      const RowSpace                  &space = *d.space();
      for (unsigned int i = 0; i < n; ++i)
        {
          parts[i] = &d.expansion(dofs[i]);
          if (parts[i]->size() > 1 ||
              (parts[i]->size() == 1 && (*parts[i])[0].second != 1.))
            result.simple = false;
          for (const auto &[row, weight] : *parts[i])
            found.push_back(
              {{static_cast<int>(space.local(row)), static_cast<int>(i)}});
        }
      std::sort(found.begin(), found.end());
      for (const auto &[row, dof] : found)
        {
          const int c = static_cast<int>(element.component(dof));
          if (!result.rows.empty() && result.rows.back() == row)
            {
              result.simple = false;
              if (result.component.back() != c)
                result.component.back() = -1;
              continue;
            }
          result.rows.push_back(row);
          result.source.push_back(dof);
          result.component.push_back(c);
        }
      if (!result.simple)
        {
          result.T.setZero(n, result.rows.size());
          for (unsigned int i = 0; i < n; ++i)
            for (const auto &[row, weight] : *parts[i])
              {
                const auto it =
                  std::lower_bound(result.rows.begin(),
                                   result.rows.end(),
                                   static_cast<int>(space.local(row)));
                result.T(i, it - result.rows.begin()) += weight;
              }
        }
      return result;
    }



    /** One sparse matrix in the making: the pattern from all cells, then the
     * values, added by walking the sorted rows. */
    class PatternedMatrix
    {
    public:
      PatternedMatrix(const std::shared_ptr<const RowSpace> &space,
                      const std::vector<CellRows>           &cells,
                      const bool same_component_only)
        : row_space(space)
        , same_component(same_component_only)
      {
        const unsigned int                     n = space->n_local();
        std::vector<std::vector<unsigned int>> cells_of_row(n);
        for (unsigned int c = 0; c < cells.size(); ++c)
          for (const int row : cells[c].rows)
            cells_of_row[row].push_back(c);
        std::vector<int> mark(n, -1);
        starts.assign(n + 1, 0);
        for (unsigned int row = 0; row < n; ++row)
          {
            for (const unsigned int c : cells_of_row[row])
              {
                const auto &rows = cells[c].rows;
                const auto  end =
                  std::upper_bound(rows.begin(), rows.end(), int(row));
                const int component =
                  cells[c].component[end - rows.begin() - 1];
                for (auto it = rows.begin(); it != end; ++it)
                  if (mark[*it] != int(row) &&
                      couple(component, cells[c].component[it - rows.begin()]))
                    {
                      mark[*it] = row;
                      columns.push_back(*it);
                    }
              }
            std::sort(columns.begin() + starts[row], columns.end());
            starts[row + 1] = columns.size();
          }
        values.assign(columns.size(), 0.);
      }

      void
      add(const CellRows &cell, const Eigen::MatrixXd &element)
      {
        const Eigen::MatrixXd expanded =
          cell.simple ? Eigen::MatrixXd()
                      : Eigen::MatrixXd(cell.T.transpose() * element * cell.T);
        for (unsigned int a = 0; a < cell.rows.size(); ++a)
          {
            std::size_t k = starts[cell.rows[a]];
            for (unsigned int b = 0; b <= a; ++b)
              {
                if (!couple(cell.component[a], cell.component[b]))
                  continue;
                while (columns[k] < cell.rows[b])
                  ++k;
                values[k] +=
                  cell.simple
                    ? element(cell.source[b], cell.source[a]) * transpose_sign
                    : expanded(b, a) * transpose_sign;
              }
          }
      }

      /** Element matrices that change sign when transposed are read from the
       * other triangle (columns are contiguous in memory). */
      double transpose_sign = 1.;

      std::shared_ptr<const SparseMatrix>
      finish()
      {
        return std::make_shared<const SparseMatrix>(
          row_space,
          std::move(starts),
          std::move(columns),
          std::move(values),
          transpose_sign > 0 ? SparseMatrix::Symmetry::symmetric
                             : SparseMatrix::Symmetry::skew);
      }

    private:
      bool
      couple(const int a, const int b) const
      {
        return !same_component || a == b || a < 0 || b < 0;
      }

      std::shared_ptr<const RowSpace> row_space;
      bool                            same_component;
      std::vector<std::size_t>        starts;
      std::vector<int>                columns;
      std::vector<double>             values;
    };



    BodyMatrices
    assemble_meshed_body(const Discretization &d, const unsigned int body)
    {
      const auto     &p = d.scene().bodies[body];
      ElementMatrices element(
        d.dof_handler(), d.mapping(), d.has_lumped_mass());
      std::vector<Discretization::CellIterator> cells;
      std::vector<CellRows>                     rows;
      for (const auto &cell : d.dof_handler().active_cell_iterators())
        if (cell->is_locally_owned() && cell->material_id() == body)
          {
            cells.push_back(cell);
            rows.push_back(cell_rows(d, cell, element));
          }

      const bool          turning = p.rotation_speed != 0.;
      const ElasticTensor C       = elastic_tensor(p);
      PatternedMatrix     K(d.space(), rows, false), M(d.space(), rows, true);
      PatternedMatrix     G(
        d.space(), turning ? rows : std::vector<CellRows>(), true);
      PatternedMatrix N(
        d.space(), turning ? rows : std::vector<CellRows>(), true);
      G.transpose_sign = -1.;
      Eigen::MatrixXd matrix, second;
      for (unsigned int c = 0; c < cells.size(); ++c)
        {
          element.reinit(cells[c]);
          element.stiffness(C, matrix);
          K.add(rows[c], matrix);
          element.mass(matrix);
          M.add(rows[c], matrix);
          if (turning)
            {
              const Vector3 &axis = p.centre_of_rotation();
              element.rotation(axis[0], axis[1], matrix, second);
              G.add(rows[c], matrix);
              N.add(rows[c], second);
            }
        }
      BodyMatrices result;
      result.stiffness = K.finish();
      result.mass      = M.finish();
      if (turning)
        {
          result.gyroscopic = G.finish();
          result.convective = N.finish();
        }
      return result;
    }



    void
    compute_volume(const Discretization &d, std::vector<BodyMatrices> &bodies)
    {
      const dealii::QGauss<3> quadrature(d.degree() + 1);
      dealii::FEValues<3>     values(d.mapping(),
                                 d.dof_handler().get_fe(),
                                 quadrature,
                                 dealii::update_quadrature_points |
                                   dealii::update_JxW_values);
      std::vector<double>     moments(4 * bodies.size(), 0.);
      for (const auto &cell : d.dof_handler().active_cell_iterators())
        if (cell->is_locally_owned())
          {
            values.reinit(cell);
            double *m = &moments[4 * cell->material_id()];
            for (unsigned int q = 0; q < quadrature.size(); ++q)
              {
                m[0] += values.JxW(q);
                for (unsigned int c = 0; c < 3; ++c)
                  m[1 + c] += values.JxW(q) * values.quadrature_point(q)[c];
              }
          }
      MPI_Allreduce(MPI_IN_PLACE,
                    moments.data(),
                    static_cast<int>(moments.size()),
                    MPI_DOUBLE,
                    MPI_SUM,
                    d.space()->communicator());
      for (unsigned int b = 0; b < bodies.size(); ++b)
        if (moments[4 * b] > 0.)
          {
            bodies[b].volume = moments[4 * b];
            for (unsigned int c = 0; c < 3; ++c)
              bodies[b].centre[c] = moments[4 * b + 1 + c] / moments[4 * b];
          }
    }



    BodyMatrices
    rigid_body(const Discretization &d, const unsigned int body)
    {
      const auto  &p = d.scene().bodies[body];
      Triplets     lower;
      BodyMatrices result;
      for (unsigned int motion = 0; motion < 6; ++motion)
        {
          const unsigned int row = d.rigid_row(body, motion);
          if (row != -1u && d.space()->rank() == 0)
            lower.add(d.space()->local(row),
                      d.space()->local(row),
                      motion < 3 ? p.mass : p.inertia[motion - 3]);
        }
      result.mass = std::make_shared<SparseMatrix>(d.space(), lower);
      for (unsigned int c = 0; c < 3; ++c)
        result.centre[c] = p.position[c];
      return result;
    }
  } // namespace



  std::vector<BodyMatrices>
  assemble_bodies(const Discretization &d)
  {
    std::vector<BodyMatrices> result;
    for (unsigned int b = 0; b < d.scene().bodies.size(); ++b)
      result.push_back(d.scene().bodies[b].shape == BodyParameters::Shape::rigid
                         ? rigid_body(d, b)
                         : assemble_meshed_body(d, b));
    if (d.has_mesh())
      compute_volume(d, result);
    return result;
  }
} // namespace squeal
