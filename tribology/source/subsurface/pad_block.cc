// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/mumps.h>
#include <squeal/tribology/subsurface/pad_block.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/tria.h>

#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>

namespace squeal::tribology
{
  namespace
  {
    using dealii::Point;

    constexpr unsigned int degree     = 3;
    constexpr unsigned int back_id    = 5;  // of a coloured box
    constexpr unsigned int n_sides    = 4;  // have the numbers before
    constexpr unsigned int n_together = 16; // patches, for the memory
    constexpr int          none       = -1;
    constexpr double       roundoff   = 1e-9; // of a cell

    using Sparse = Eigen::SparseMatrix<double, Eigen::RowMajor>;

    /** Cells that double from the finest at the first end, or at both ends,
     * to the coarsest. */
    std::vector<double>
    graded(const double length,
           const double finest,
           const double coarsest,
           const bool   both_ends)
    {
      const double        n_ends = both_ends ? 2. : 1.;
      std::vector<double> ends;
      double              rest = length;
      for (double h = finest; h < coarsest && rest - n_ends * h > n_ends * h;
           h *= 2.)
        {
          ends.push_back(h);
          rest -= n_ends * h;
        }
      const double        n = std::max(1., std::ceil(rest / coarsest - 1e-6));
      std::vector<double> sizes = ends;
      sizes.insert(sizes.end(), std::size_t(n), rest / n);
      if (both_ends)
        sizes.insert(sizes.end(), ends.rbegin(), ends.rend());
      return sizes;
    }



    /** Elasticity of the block with shear modulus 1, cubic elements. */
    class BlockModel
    {
    public:
      explicit BlockModel(const PadBlock &block)
        : block(block)
        , element(dealii::FE_Q<3>(degree), 3)
        , dofs(mesh)
      {
        const double x = block.face.x_max - block.face.x_min;
        const double y = block.face.y_max - block.face.y_min;
        const auto   f = block.finest_cell, c = block.coarsest_cell;
        dealii::GridGenerator::subdivided_hyper_rectangle(
          mesh,
          {graded(x, f, c, true),
           graded(y, f, c, true),
           graded(block.thickness, f, c, false)},
          Point<3>(block.face.x_min, block.face.y_min, 0.),
          Point<3>(block.face.x_max, block.face.y_max, block.thickness),
          true);
        dofs.distribute_dofs(element);
        number_free();
        factorize();
      }

      /** Displacements of all unknowns for the loads of a patch: columns. */
      Eigen::MatrixXd
      solve(const std::vector<Patch> &patches) const
      {
        Eigen::MatrixXd force =
          Eigen::MatrixXd::Zero(dofs.n_dofs(), 3 * patches.size());
        Eigen::MatrixXd motion = force;
        add_sides(patches, force);
        hold_back(patches, motion);
        // what the back, moved, does to the rest
        force -= to_back * motion;
        Eigen::MatrixXd right(n_free, force.cols());
        for (Eigen::Index i = 0; i < force.rows(); ++i)
          if (free[i] != none)
            right.row(free[i]) = force.row(i);
        const Eigen::MatrixXd left = factor->solve(right);
        for (Eigen::Index i = 0; i < force.rows(); ++i)
          if (free[i] != none)
            motion.row(i) = left.row(free[i]);
        return motion;
      }

      /** Takes displacements to stresses at points, six rows each: means over
       * the cells that meet there. */
      Sparse
      observation(const std::vector<BlockPoint> &points) const
      {
        std::vector<Eigen::Triplet<double>>          entries;
        std::vector<dealii::types::global_dof_index> indices(
          element.dofs_per_cell);
        for (std::size_t k = 0; k < points.size(); ++k)
          {
            const Point<3>    p(points[k][0], points[k][1], points[k][2]);
            std::vector<Cell> around;
            for (const auto &cell : dofs.active_cell_iterators())
              if (cell->bounding_box().point_inside(p, roundoff))
                around.push_back(cell);
            AssertThrow(!around.empty(), dealii::ExcMessage("outside"));
            for (const Cell &cell : around)
              {
                dealii::FEValues<3> values(
                  element,
                  dealii::Quadrature<3>(cell->bounding_box().real_to_unit(p)),
                  dealii::update_gradients);
                values.reinit(cell);
                cell->get_dof_indices(indices);
                for (unsigned int i = 0; i < indices.size(); ++i)
                  {
                    const auto s = stress_of(values, i);
                    for (unsigned int c = 0; c < 6; ++c)
                      entries.emplace_back(
                        6 * k + c, indices[i], s[c] / around.size());
                  }
              }
          }
        Sparse result(6 * points.size(), dofs.n_dofs());
        result.setFromTriplets(entries.begin(), entries.end());
        return result;
      }

    private:
      using Cell = dealii::DoFHandler<3>::active_cell_iterator;

      double
      lame() const
      {
        return 2. * block.poisson_ratio / (1. - 2. * block.poisson_ratio);
      }

      /** Stress by a unit of a cell's unknown, at the first point. */
      Eigen::Matrix<double, 6, 1>
      stress_of(const dealii::FEValues<3> &values, const unsigned int i) const
      {
        const unsigned int c = element.system_to_component_index(i).first;
        const auto         g = values.shape_grad(i, 0);
        Eigen::Matrix3d    s = Eigen::Matrix3d::Zero();
        for (unsigned int d = 0; d < 3; ++d)
          {
            s(c, d) += g[d];
            s(d, c) += g[d];
            s(d, d) += lame() * g[c];
          }
        Eigen::Matrix<double, 6, 1> result;
        result << s(0, 0), s(1, 1), s(2, 2), s(0, 1), s(1, 2), s(0, 2);
        return result;
      }

      void
      number_free()
      {
        const dealii::IndexSet back =
          dealii::DoFTools::extract_boundary_dofs(dofs, {}, {back_id});
        free.assign(dofs.n_dofs(), none);
        for (unsigned int i = 0; i < dofs.n_dofs(); ++i)
          if (!back.is_element(i))
            free[i] = n_free++;
      }

      void
      factorize()
      {
        const unsigned int                           n = element.dofs_per_cell;
        std::vector<dealii::types::global_dof_index> indices(n);
        std::vector<int>                             rows, columns;
        std::vector<double>                          entries;
        std::vector<Eigen::Triplet<double>>          held;
        std::map<std::array<long, 3>, Eigen::MatrixXd> of_size;
        const std::size_t most = mesh.n_active_cells() * n * (n + 1) / 2;
        rows.reserve(most);
        columns.reserve(most);
        entries.reserve(most);
        for (const auto &cell : dofs.active_cell_iterators())
          {
            std::array<long, 3> size;
            for (unsigned int d = 0; d < 3; ++d)
              size[d] = std::lround(cell->extent_in_direction(d) /
                                    (1e-6 * block.finest_cell));
            Eigen::MatrixXd &matrix = of_size[size];
            if (matrix.size() == 0)
              matrix = stiffness(cell);
            cell->get_dof_indices(indices);
            for (unsigned int i = 0; i < n; ++i)
              for (unsigned int j = 0; j < n; ++j)
                {
                  const int a = free[indices[i]], b = free[indices[j]];
                  if (a == none || b > a)
                    continue;
                  if (b == none)
                    held.emplace_back(indices[i], indices[j], matrix(i, j));
                  else
                    {
                      rows.push_back(a);
                      columns.push_back(b);
                      entries.push_back(matrix(i, j));
                    }
                }
          }
        to_back.resize(dofs.n_dofs(), dofs.n_dofs());
        to_back.setFromTriplets(held.begin(), held.end());
        using Factor = MumpsFactorization<double>;
        factor       = std::make_unique<Factor>(
          std::make_shared<RowSpace>(static_cast<unsigned int>(n_free)),
          Factor::Symmetry::symmetric);
        factor->factorize(
          std::move(rows), std::move(columns), std::move(entries));
      }

      Eigen::MatrixXd
      stiffness(const Cell &cell) const
      {
        const dealii::QGauss<3> gauss(degree + 1);
        dealii::FEValues<3>     values(
          element, gauss, dealii::update_gradients | dealii::update_JxW_values);
        values.reinit(cell);
        const unsigned int n = element.dofs_per_cell;
        Eigen::MatrixXd    matrix(n, n);
        for (unsigned int i = 0; i < n; ++i)
          for (unsigned int j = 0; j < n; ++j)
            {
              const unsigned int c = element.system_to_component_index(i).first;
              const unsigned int d = element.system_to_component_index(j).first;
              double             k = 0.;
              for (const unsigned int q : values.quadrature_point_indices())
                {
                  const auto &a = values.shape_grad(i, q),
                             &b = values.shape_grad(j, q);
                  k += values.JxW(q) * (lame() * a[c] * b[d] + a[d] * b[c] +
                                        (c == d ? a * b : 0.));
                }
              matrix(i, j) = k;
            }
        return matrix;
      }

      /** Tractions that free the sides from the stress of the half-space. */
      void
      add_sides(const std::vector<Patch> &patches, Eigen::MatrixXd &force) const
      {
        const dealii::QGauss<2> gauss(degree + 2);
        dealii::FEFaceValues<3> values(
          element,
          gauss,
          dealii::update_values | dealii::update_quadrature_points |
            dealii::update_normal_vectors | dealii::update_JxW_values);
        std::vector<dealii::types::global_dof_index> indices(
          element.dofs_per_cell);
        Eigen::MatrixXd traction(3, force.cols());
        for (const auto &cell : dofs.active_cell_iterators())
          for (const unsigned int f : cell->face_indices())
            {
              const auto &face = cell->face(f);
              if (!face->at_boundary() || face->boundary_id() >= n_sides)
                continue;
              values.reinit(cell, f);
              cell->get_dof_indices(indices);
              for (const unsigned int q : values.quadrature_point_indices())
                {
                  half_space_traction(patches,
                                      values.quadrature_point(q),
                                      values.normal_vector(q),
                                      traction);
                  for (unsigned int i = 0; i < indices.size(); ++i)
                    if (element.has_support_on_face(i, f))
                      force.row(indices[i]) -=
                        values.JxW(q) * values.shape_value(i, q) *
                        traction.row(
                          element.system_to_component_index(i).first);
                }
            }
      }

      void
      half_space_traction(const std::vector<Patch>   &patches,
                          const Point<3>             &p,
                          const dealii::Tensor<1, 3> &n,
                          Eigen::MatrixXd            &traction) const
      {
        for (std::size_t k = 0; k < patches.size(); ++k)
          {
            const PatchInfluence s = patch_influence(
              patches[k], p[0], p[1], p[2], block.poisson_ratio);
            auto t   = traction.middleCols<3>(3 * k);
            t.row(0) = n[0] * s.row(0) + n[1] * s.row(3) + n[2] * s.row(5);
            t.row(1) = n[0] * s.row(3) + n[1] * s.row(1) + n[2] * s.row(4);
            t.row(2) = n[0] * s.row(5) + n[1] * s.row(4) + n[2] * s.row(2);
          }
      }

      /** Displacements that bring the back of the half-space home. */
      void
      hold_back(const std::vector<Patch> &patches,
                Eigen::MatrixXd          &motion) const
      {
        const auto &places = element.get_unit_support_points();
        std::vector<dealii::types::global_dof_index> indices(
          element.dofs_per_cell);
        std::vector<char> is_done(dofs.n_dofs(), 0);
        for (const auto &cell : dofs.active_cell_iterators())
          {
            cell->get_dof_indices(indices);
            for (unsigned int i = 0; i < indices.size(); ++i)
              {
                const auto row = indices[i];
                if (free[row] != none || is_done[row])
                  continue;
                is_done[row]     = 1;
                const Point<3> p = cell->bounding_box().unit_to_real(places[i]);
                const unsigned int c =
                  element.system_to_component_index(i).first;
                for (std::size_t k = 0; k < patches.size(); ++k)
                  motion.block<1, 3>(row, 3 * k) =
                    -patch_displacement(
                       patches[k], p[0], p[1], p[2], block.poisson_ratio)
                       .row(c);
              }
          }
      }

      const PadBlock            block;
      dealii::Triangulation<3>  mesh;
      const dealii::FESystem<3> element;
      dealii::DoFHandler<3>     dofs;
      std::vector<int>          free; /**< number of an unknown, or none */
      int                       n_free = 0;
      Sparse                    to_back;
      std::unique_ptr<MumpsFactorization<double>> factor;
    };
  } // namespace



  Eigen::MatrixXd
  block_correction(const PadBlock                &block,
                   const std::vector<Patch>      &patches,
                   const std::vector<BlockPoint> &points)
  {
    const BlockModel model(block);
    const Sparse     observed = model.observation(points);
    Eigen::MatrixXd  result(observed.rows(), 3 * patches.size());
    for (std::size_t k = 0; k < patches.size(); k += n_together)
      {
        const auto first = patches.begin() + k;
        const auto n = std::min<std::size_t>(n_together, patches.size() - k);
        result.middleCols(3 * k, 3 * n) =
          observed * model.solve({first, first + n});
      }
    return result;
  }
} // namespace squeal::tribology
