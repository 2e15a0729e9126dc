// SPDX-License-Identifier: LGPL-2.1-or-later
#include "eigenvalue_error_cell.h"
#include "point_forces_in_cells.h"

#include <squeal/discretization/affine_system.h>
#include <squeal/discretization/pair_error.h>

#include <deal.II/distributed/tria.h>

#include <limits>

namespace squeal
{
  using Complex = std::complex<double>;

  Complex
  stiffness_factor(const SceneParameters &scene,
                   const unsigned int     body,
                   const Complex          lambda)
  {
    const auto      &b = scene.bodies[body];
    TermCoefficients c = elastic_coefficients(
      scene, 1., b.stiffness_damping, b.structural_damping);
    if (b.has_modulus_table())
      c.stiffness.imag(b.table_loss_factor);
    return c.stiffness + lambda * c.damping;
  }

  Complex
  inertia_factor(const SceneParameters &scene,
                 const unsigned int     body,
                 const Complex          lambda)
  {
    return -(lambda * lambda + mass_damping_of(scene, body) * lambda) /
           stiffness_factor(scene, body, lambda);
  }



  Block
  columns_of(const PairShapes &pairs)
  {
    Block columns(pairs.right.rows(), 4 * pairs.lambda.size());
    for (Eigen::Index k = 0; k < pairs.lambda.size(); ++k)
      {
        columns.col(4 * k)     = pairs.right.col(k).real();
        columns.col(4 * k + 1) = pairs.right.col(k).imag();
        columns.col(4 * k + 2) = pairs.left.col(k).real();
        columns.col(4 * k + 3) = pairs.left.col(k).imag();
      }
    return columns;
  }



  Eigen::SparseMatrix<double>
  inertia_of_columns(const SceneParameters  &scene,
                     const unsigned int      body,
                     const Eigen::VectorXcd &lambda)
  {
    Eigen::SparseMatrix<double> W(4 * lambda.size(), 4 * lambda.size());
    for (int k = 0; k < lambda.size(); ++k)
      {
        const Complex kappa = inertia_factor(scene, body, lambda[k]);
        for (const int i : {4 * k, 4 * k + 2})
          {
            W.insert(i, i)         = kappa.real();
            W.insert(i, i + 1)     = kappa.imag();
            W.insert(i + 1, i)     = -kappa.imag();
            W.insert(i + 1, i + 1) = kappa.real();
          }
      }
    return W;
  }



  PairErrors
  PairErrors::unknown(const Eigen::Index n)
  {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    PairErrors       result;
    result.lambda = result.at_points =
      Eigen::VectorXcd::Constant(n, std::complex<double>(nan, nan));
    return result;
  }



  PairErrors
  estimate_pair_errors(const Discretization           &d,
                       const PairShapes               &pairs,
                       const std::vector<PointForces> &forces)
  {
    const Eigen::Index n = pairs.lambda.size();
    const unsigned int n_cells =
      d.has_mesh() ? d.triangulation().n_active_cells() : 0;
    PairErrors result;
    result.lambda = result.at_points = Eigen::VectorXcd::Zero(n);
    result.cell                      = Eigen::MatrixXcd::Zero(n, n_cells);
    if (n_cells == 0 || n == 0)
      return result;

    const auto                            &scene = d.scene();
    std::vector<CellErrorProblem::Inertia> inertia;
    for (unsigned int b = 0; b < scene.bodies.size(); ++b)
      inertia.push_back(inertia_of_columns(scene, b, pairs.lambda));
    CellErrorProblem    problem(d, columns_of(pairs), inertia);
    const ForcesInCells in_cells = forces_in_cells(d, forces);
    // Columns: real and imaginary parts inside and at pointwise forces.
    Eigen::MatrixXd sums = Eigen::MatrixXd::Zero(n, 4);
    for (const auto &cell : d.dof_handler().active_cell_iterators())
      {
        if (!cell->is_locally_owned())
          continue;
        const unsigned int    i         = cell->active_cell_index();
        const bool            pointwise = in_cells.pointwise[i];
        const Eigen::MatrixXd r =
          problem.residuals(cell, in_cells.forces[i], in_cells.pointwise);
        for (Eigen::Index k = 0; k < n; ++k)
          {
            Eigen::VectorXcd x = r.col(4 * k).cast<Complex>(),
                             y = r.col(4 * k + 2).cast<Complex>();
            x.imag()           = r.col(4 * k + 1);
            y.imag()           = r.col(4 * k + 3);
            const Complex part =
              0.5 * (d.degree() + 1.) *
              stiffness_factor(scene, cell->material_id(), pairs.lambda[k]) *
              (y.transpose() * x)(0, 0) / pairs.derivative[k];
            sums(k, pointwise ? 2 : 0) += part.real();
            sums(k, pointwise ? 3 : 1) += part.imag();
            if (!pointwise)
              result.cell(k, i) = part;
          }
      }
    d.space()->sum(sums);
    result.lambda.real()    = sums.col(0);
    result.lambda.imag()    = sums.col(1);
    result.at_points.real() = sums.col(2);
    result.at_points.imag() = sums.col(3);
    return result;
  }
} // namespace squeal
