// SPDX-License-Identifier: LGPL-2.1-or-later
#include "eigenvalue_error_cell.h"
#include "point_forces_in_cells.h"

#include <squeal/base/assignment.h>
#include <squeal/discretization/affine_system.h>
#include <squeal/discretization/pair_error.h>

#include <deal.II/distributed/tria.h>

#include <Eigen/Eigenvalues>

namespace squeal
{
  using Complex = std::complex<double>;

  namespace
  {
    /** Steps in which eigenvalues are followed as the mesh's part comes on. */
    constexpr unsigned int n_steps = 32;

    /** Right and left residuals of all pairs from the columns of
     * columns_of(). */
    std::pair<ComplexBlock, ComplexBlock>
    complex_residuals(const Eigen::MatrixXd &r)
    {
      const Eigen::Index n = r.cols() / 4;
      ComplexBlock       x(r.rows(), n), y(r.rows(), n);
      for (Eigen::Index k = 0; k < n; ++k)
        {
          x.col(k).real() = r.col(4 * k);
          x.col(k).imag() = r.col(4 * k + 1);
          y.col(k).real() = r.col(4 * k + 2);
          y.col(k).imag() = r.col(4 * k + 3);
        }
      return {std::move(x), std::move(y)};
    }

    Eigen::MatrixXcd
    sum_over_ranks(const RowSpace &space, const Eigen::MatrixXcd &part)
    {
      Eigen::MatrixXd sums(part.rows(), 2 * part.cols());
      sums << part.real(), part.imag();
      space.sum(sums);
      Eigen::MatrixXcd result(part.rows(), part.cols());
      result.real() = sums.leftCols(part.cols());
      result.imag() = sums.rightCols(part.cols());
      return result;
    }

    /** How far the eigenvalues of diag(lambda) + @p E lie from @p lambda, each
     * followed while E grows from nothing. */
    Eigen::VectorXcd
    shifts_of_all(const Eigen::VectorXcd &lambda, const Eigen::MatrixXcd &E)
    {
      Eigen::VectorXcd now = lambda;
      for (unsigned int step = 1; step <= n_steps; ++step)
        {
          Eigen::MatrixXcd A = double(step) / n_steps * E;
          A.diagonal() += lambda;
          const Eigen::VectorXcd next =
            Eigen::ComplexEigenSolver<Eigen::MatrixXcd>(A, false).eigenvalues();
          std::vector<std::vector<double>> distance(now.size());
          for (Eigen::Index i = 0; i < now.size(); ++i)
            for (Eigen::Index j = 0; j < now.size(); ++j)
              distance[i].push_back(std::abs(now[i] - next[j]));
          const std::vector<int> of = smallest_assignment(distance);
          for (Eigen::Index i = 0; i < now.size(); ++i)
            now[i] = next[of[i]];
        }
      return now - lambda;
    }
  } // namespace

  Complex
  stiffness_factor(const SceneParameters &scene,
                   const unsigned int     body,
                   const Complex          lambda)
  {
    const auto            &b = scene.bodies[body];
    const TermCoefficients c = elastic_coefficients(
      scene, 1., b.stiffness_damping, b.structural_damping);
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
  estimate_pair_errors(const Discretization           &d,
                       const PairShapes               &pairs,
                       const std::vector<PointForces> &forces)
  {
    const Eigen::Index n = pairs.lambda.size();
    const unsigned int n_cells =
      d.has_mesh() ? d.triangulation().n_active_cells() : 0;
    PairErrors result;
    result.lambda = result.first_order = result.at_points =
      Eigen::VectorXcd::Zero(n);
    result.cell = Eigen::MatrixXcd::Zero(n, n_cells);
    if (n_cells == 0 || n == 0)
      return result;

    const auto                            &scene = d.scene();
    std::vector<CellErrorProblem::Inertia> inertia;
    for (unsigned int b = 0; b < scene.bodies.size(); ++b)
      inertia.push_back(inertia_of_columns(scene, b, pairs.lambda));
    CellErrorProblem    problem(d, columns_of(pairs), inertia);
    const ForcesInCells in_cells = forces_in_cells(d, forces);
    Eigen::VectorXcd    weight(n);
    // What the mesh adds inside, and at pointwise forces.
    Eigen::MatrixXcd E         = Eigen::MatrixXcd::Zero(n, n);
    Eigen::VectorXcd at_points = Eigen::VectorXcd::Zero(n);
    for (const auto &cell : d.dof_handler().active_cell_iterators())
      {
        if (!cell->is_locally_owned())
          continue;
        const unsigned int i         = cell->active_cell_index();
        const bool         pointwise = in_cells.pointwise[i];
        const auto [x, y]            = complex_residuals(
          problem.residuals(cell, in_cells.forces[i], in_cells.pointwise));
        for (Eigen::Index k = 0; k < n; ++k)
          weight[k] =
            0.5 * (d.degree() + 1.) *
            stiffness_factor(scene, cell->material_id(), pairs.lambda[k]);
        Eigen::MatrixXcd part = y.transpose() * x * weight.asDiagonal();
        part.array().colwise() /= pairs.derivative.array();
        if (pointwise)
          at_points += part.diagonal();
        else
          {
            E += part;
            result.cell.col(i) = part.diagonal();
          }
      }
    result.at_points   = sum_over_ranks(*d.space(), at_points);
    E                  = sum_over_ranks(*d.space(), E);
    result.first_order = E.diagonal();
    result.lambda      = shifts_of_all(pairs.lambda, E);
    return result;
  }
} // namespace squeal
