// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_discretization_element_matrices_h
#define squeal_discretization_element_matrices_h

#include <squeal/parameters/scene_parameters.h>

#include <deal.II/base/quadrature_lib.h>

#include <deal.II/dofs/dof_handler.h>

#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_values.h>

#include <Eigen/Core>

#include <array>
#include <memory>
#include <vector>

namespace squeal
{
  /** Elastic constants C_ijkl as [3 i + j][3 k + l], Pa. */
  using ElasticTensor = std::array<std::array<double, 9>, 9>;

  /** Hooke's law with Young modulus 1 Pa (isotropic), or in full
   * (orthotropic, along its own axes). */
  ElasticTensor elastic_tensor(const BodyParameters &body);

  /** elastic_tensor() with the Young modulus of an isotropic body, Pa. */
  ElasticTensor elastic_constants(const BodyParameters &body);

  /** The largest of elastic_constants(), Pa. */
  double largest_elastic_constant(const BodyParameters &body);

  /**
   * Stiffness and mass matrices of one hexahedron of degree p. The integrals
   * H_kl = int dphi_a/dx_k dphi_b/dx_l are products of dense matrices
   * (degrees >= 3 spend their time in BLAS-3), from which the stiffness of any
   * elastic law is combined: K_(a i)(b j) = sum_kl C_ikjl (H_kl)_ab.
   *
   * Rows are ordered as the degrees of freedom of an FESystem of three FE_Q.
   */
  class ElementMatrices
  {
  public:
    /** @p lumped_mass: collocation at the Gauss-Lobatto nodes. */
    ElementMatrices(const dealii::DoFHandler<3> &dofs,
                    const dealii::Mapping<3, 3> &mapping,
                    const bool                   lumped_mass = false);

    /** Computes H_kl and the scalar mass on @p cell. */
    void reinit(const dealii::DoFHandler<3>::active_cell_iterator &cell);

    /** 3n x 3n stiffness for the elastic law @p C. */
    void stiffness(const ElasticTensor &C, Eigen::MatrixXd &K) const;

    /** 3n x 3n mass for density 1. */
    void mass(Eigen::MatrixXd &M) const;

    /**
     * Terms of a body that turns about the axis through (x0, y0) along z, in
     * the fixed frame, for density 1 and 1 rad/s: with d = x d/dy - y d/dx,
     * gyroscopic G = 2 int phi_a d phi_b made skew (its symmetric part is a
     * flux through the boundary, zero for an axisymmetric body) and convective
     * N = - int d phi_a d phi_b.
     */
    void rotation(const double     x0,
                  const double     y0,
                  Eigen::MatrixXd &G,
                  Eigen::MatrixXd &N) const;

    /**
     * Terms of a body in axes that turn with it about z, for density 1 and
     * 1 rad/s: Coriolis G_(a i)(b j) = int phi_a phi_b (e_z x e_j)_i, skew, and
     * centrifugal N, the mass of the components x and y.
     */
    void turning_axes(Eigen::MatrixXd &G, Eigen::MatrixXd &N) const;

    /** Centrifugal forces int phi_a (x - x0, y - y0, 0)_i about the axis
     * through (x0, y0) along z, for density 1 and 1 rad/s: 3n, m^4. */
    Eigen::VectorXd centrifugal_load(const double x0, const double y0) const;

    /** What the stress sigma = C : grad u of the displacements @p u, 3n, adds to
     * the stiffness: S_(a i)(b i) = int sigma_kl dphi_a/dx_k dphi_b/dx_l. */
    void stress_stiffness(const ElasticTensor   &C,
                          const Eigen::VectorXd &u,
                          Eigen::MatrixXd       &S) const;

    /** Component 0..2 of degree of freedom @p i of a cell. */
    unsigned int
    component(const unsigned int i) const
    {
      return component_of[i];
    }

  private:
    /** Sets the diagonal scalar mass. */
    void lump_mass(const dealii::Triangulation<3>::active_cell_iterator &cell);

    /** Spreads scalar matrices over the components: out_(a i)(b j) = s_ab for
     * i = j. */
    void spread(const Eigen::MatrixXd &scalar, Eigen::MatrixXd &out) const;

    dealii::FE_Q<3>                               fe;
    dealii::QGauss<3>                             quadrature;
    dealii::FEValues<3>                           fe_values;
    std::unique_ptr<dealii::FEValues<3>>          at_nodes; /**< if lumped */
    std::vector<unsigned int>                     component_of, scalar_of;
    std::array<std::vector<unsigned int>, 3>      dof_of; /**< [comp][scalar] */
    std::array<Eigen::MatrixXd, 3>                gradients, weighted;
    Eigen::MatrixXd                               values, weighted_values;
    std::array<std::array<Eigen::MatrixXd, 3>, 3> H;
    Eigen::MatrixXd                               scalar_mass;
  };
} // namespace squeal

#endif
