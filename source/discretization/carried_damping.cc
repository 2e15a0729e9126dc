// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patterned_matrix.h"

#include <squeal/base/exceptions.h>
#include <squeal/discretization/carried_damping.h>
#include <squeal/scene/turning.h>

#include <deal.II/distributed/tria.h>

#include <Eigen/SparseCore>

namespace squeal
{
  namespace
  {
    Eigen::SparseMatrix<double>
    all_entries(const SparseMatrix &matrix)
    {
      Triplets entries;
      matrix.append_to(entries, 1., false);
      std::vector<Eigen::Triplet<double>> list;
      for (std::size_t k = 0; k < entries.values.size(); ++k)
        list.emplace_back(
          entries.rows[k], entries.columns[k], entries.values[k]);
      const int n = static_cast<int>(matrix.space().n_global());
      Eigen::SparseMatrix<double> result(n, n);
      result.setFromTriplets(list.begin(), list.end());
      return result;
    }

    /** (K D H + H D K) / 2 with a symmetric K, a diagonal D and a skew H. */
    class CarriedStiffness : public LinearOperator
    {
    public:
      CarriedStiffness(std::shared_ptr<const SparseMatrix> stiffness_matrix,
                       std::shared_ptr<const SparseMatrix> derivative,
                       Eigen::VectorXd                     inverse_mass)
        : K(std::move(stiffness_matrix))
        , H(std::move(derivative))
        , D(std::move(inverse_mass))
      {
      }

      Block
      multiply(const Block &X) const override
      {
        const Block HX = D.asDiagonal() * H->multiply(X),
                    KX = D.asDiagonal() * K->multiply(X);
        return .5 * (K->multiply(HX) + H->multiply(KX));
      }

      Block
      multiply_transposed(const Block &X) const override
      {
        return -multiply(X);
      }

      Block
      multiply_absolute(const Block &X) const override
      {
        const Block HX = D.asDiagonal() * H->multiply_absolute(X),
                    KX = D.asDiagonal() * K->multiply_absolute(X);
        return .5 * (K->multiply_absolute(HX) + H->multiply_absolute(KX));
      }

      bool
      is_symmetric() const override
      {
        return false;
      }

      void
      append_to(Triplets    &triplets,
                const double factor,
                const bool) const override
      {
        if (K->space().n_ranks() > 1)
          throw InputError("the entries of the stiffness damping of a body "
                           "with a 'Rotation speed' are known to one rank "
                           "only: run without mpirun");
        using Sparse      = Eigen::SparseMatrix<double>;
        const Sparse of_K = all_entries(*K), of_H = all_entries(*H),
                     DH = D.asDiagonal() * of_H, one = of_K * DH,
                     sum = .5 * factor * (one - Sparse(one.transpose()));
        for (int j = 0; j < sum.outerSize(); ++j)
          for (Sparse::InnerIterator it(sum, j); it; ++it)
            triplets.add(static_cast<int>(it.row()),
                         static_cast<int>(it.col()),
                         it.value());
      }

    private:
      std::shared_ptr<const SparseMatrix> K, H;
      Eigen::VectorXd                     D;
    };
  } // namespace



  std::shared_ptr<const LinearOperator>
  carried_stiffness(const Discretization                      &d,
                    const unsigned int                         body,
                    const std::shared_ptr<const SparseMatrix> &stiffness)
  {
    ElementMatrices element(d.dof_handler(), d.mapping(), true);
    std::vector<Discretization::CellIterator> cells;
    std::vector<CellRows>                     rows;
    for (const auto &cell : d.dof_handler().active_cell_iterators())
      if (cell->is_locally_owned() && cell->material_id() == body)
        {
          cells.push_back(cell);
          rows.push_back(cell_rows(d, cell, element));
        }
    PatternedMatrix H(d.space(), rows, false), M(d.space(), rows, true);
    H.transpose_sign     = -1.;
    const Vector3  &axis = carrier_of(d.scene(), body).centre_of_rotation();
    Eigen::MatrixXd gyroscopic, across, other;
    for (std::size_t c = 0; c < cells.size(); ++c)
      {
        element.reinit(cells[c]);
        element.rotation(axis[0], axis[1], gyroscopic, other);
        element.turning_axes(across, other);
        H.add(rows[c], .5 * gyroscopic - across);
        element.mass(other);
        M.add(rows[c], other);
      }
    // Rows of other bodies have no mass and no part in H.
    const Block mass =
      M.finish()->multiply(Block(Block::Ones(d.space()->n_owned(), 1)));
    const Eigen::VectorXd inverse =
      (mass.col(0).array() > 0.).select(mass.col(0).cwiseInverse(), 0.);
    return std::make_shared<CarriedStiffness>(stiffness, H.finish(), inverse);
  }
} // namespace squeal
