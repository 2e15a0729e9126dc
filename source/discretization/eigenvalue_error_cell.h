// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_source_discretization_eigenvalue_error_cell_h
#define squeal_source_discretization_eigenvalue_error_cell_h

#include <squeal/discretization/discretization.h>
#include <squeal/discretization/element_matrices.h>

#include <deal.II/base/polynomial.h>
#include <deal.II/base/quadrature_lib.h>

#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_values.h>

#include <Eigen/Sparse>

#include <array>
#include <map>
#include <vector>

namespace squeal
{
  /**
   * The polynomials of degree p + 1 on the unit cell that vanish at the nodes
   * of degree p: products of three factors, each a Lagrange polynomial of
   * degree p or the bubble of degree p + 1 that vanishes at its nodes, at
   * least one of them the bubble.
   */
  class EnrichmentSpace
  {
  public:
    explicit EnrichmentSpace(const unsigned int degree);

    unsigned int
    size() const
    {
      return index.size();
    }

    /** The functions (columns) at points of the unit cell (rows), or their
     * derivatives along the unit direction @p derivative. */
    Eigen::MatrixXd evaluate(const std::vector<dealii::Point<3>> &points,
                             const int derivative = -1) const;

    /** Whether function @p a is zero on face @p face. */
    bool vanishes_on(const unsigned int a, const unsigned int face) const;

  private:
    unsigned int                                         degree;
    std::vector<dealii::Polynomials::Polynomial<double>> factors;
    std::vector<std::array<unsigned int, 3>>             index;
  };



  /** The local problems of estimate_mode_errors(). */
  class CellErrorProblem
  {
  public:
    using Cell = Discretization::CellIterator;

    /** A force on the modes at a point of the unit cell: 3 x n_modes, N. */
    struct Force
    {
      dealii::Point<3> unit_point;
      Eigen::MatrixXd  force;
    };

    /** W: the inertia forces on the modes u are density times u W, 1/s^2. */
    using Inertia = Eigen::SparseMatrix<double>;

    /** @p inertia: one for all bodies, or one for each. */
    CellErrorProblem(const Discretization       &discretization,
                     const Block                &modes,
                     const std::vector<Inertia> &inertia);

    /**
     * L^-1 r of every mode in @p cell, where L L^T is the stiffness of the
     * enrichment space and r what the mode leaves over there: the squared norm
     * of a column is twice the elastic energy a_K(e, e) of the mode's error, J,
     * and products of two columns are those of two errors. On faces to cells of
     * @p set_apart (by active cell index) the cell's own traction is taken for
     * right.
     */
    Eigen::MatrixXd residuals(const Cell               &cell,
                              const std::vector<Force> &forces,
                              const std::vector<bool>  &set_apart);

  private:
    /** Nine components [3 i + j] at points (rows) for the modes (columns). */
    using TensorField = std::array<Eigen::MatrixXd, 9>;
    /** Nodal values of x, y, z (rows) for the modes (columns). */
    using CellValues = std::array<Eigen::MatrixXd, 3>;
    /** Components x, y, z at points (rows) for the modes (columns), Pa. */
    using Tractions = std::array<Eigen::MatrixXd, 3>;
    struct Material
    {
      ElasticTensor C;
      double        density;
      double        modulus; /**< largest elastic constant, Pa */
    };

    static Material material_of(const BodyParameters &body);
    CellValues      cell_values(const Cell &cell) const;
    TensorField     stresses(const dealii::FEValuesBase<3> &points,
                             const CellValues              &values,
                             const Material                &material) const;
    /** Tractions of the stresses there, on faces with the normals of
     * @p normals. */
    Tractions tractions(const dealii::FEValuesBase<3> &points,
                        const dealii::FEValuesBase<3> &normals,
                        const CellValues              &values,
                        const Material                &material) const;
    void      assemble_stiffness(const Material &material);
    void      assemble_volume(const Cell &cell, const Material &material);
    void      add_forces(const std::vector<Force> &forces);
    void      add_face(const Cell              &cell,
                       const unsigned int       face,
                       const Material          &material,
                       const std::vector<bool> &set_apart);
    void      add_traction(const dealii::FEValuesBase<3> &own,
                           const dealii::FEValuesBase<3> &other,
                           const Cell                    &neighbour,
                           const Eigen::MatrixXd         &trace,
                           const Material                &material,
                           const bool                     own_traction);
    void      hold_supported(const Cell        &cell,
                             const unsigned int face,
                             const Material    &material);
    const Eigen::MatrixXd &trace(const Cell        &cell,
                                 const unsigned int face,
                                 const int          subface);

    const Discretization                    &discretization;
    std::vector<Inertia>                     inertia;
    dealii::FE_Q<3>                          fe;
    EnrichmentSpace                          space;
    dealii::QGauss<3>                        quadrature;
    dealii::QGauss<2>                        face_quadrature;
    dealii::FEValues<3>                      volume;
    dealii::FEFaceValues<3>                  own_face, other_face;
    dealii::FESubfaceValues<3>               own_subface, other_subface;
    std::vector<Material>                    materials; /**< of each body */
    std::array<std::vector<unsigned int>, 3> dof_of;    /**< [comp][scalar] */
    Eigen::MatrixXd nodal; /**< relevant dofs x modes */

    // The enrichment functions at the quadrature points, on the unit cell.
    Eigen::MatrixXd                                          unit_values;
    std::array<Eigen::MatrixXd, 3>                           unit_derivatives;
    std::map<std::pair<bool, unsigned int>, Eigen::MatrixXd> traces;

    // Of the present cell.
    CellValues                     values;
    Eigen::VectorXd                weights;
    std::array<Eigen::MatrixXd, 3> gradients, weighted_gradients;
    Eigen::MatrixXd                stiffness, residual;
  };
} // namespace squeal

#endif
