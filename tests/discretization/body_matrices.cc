// SPDX-License-Identifier: LGPL-2.1-or-later

// Stiffness does no work in rigid motions, whatever the material, the degree
// and the refinement; the mass of a body is density times volume.

#include "scenes.h"

#include <squeal/discretization/element_matrices.h>

#include <deal.II/base/mpi.h>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  BodyParameters
  orthotropic(BodyParameters body)
  {
    body.material_model = BodyParameters::MaterialModel::orthotropic;
    body.young_moduli   = {{9e9, 9e9, 3e9}};
    body.shear_moduli   = {{1.2e9, 1.2e9, 3.4e9}};
    body.poisson_ratios = {{0.2, 0.25, 0.3}};
    return body;
  }

  /** Largest ||A r|| over || |A| |r| || of the rigid motions. */
  double
  rigid_force(const LinearOperator &K, const Block &R)
  {
    return (K.multiply(R).colwise().norm().array() /
            K.multiply_absolute(R).colwise().norm().array())
      .maxCoeff<Eigen::PropagateNaN>();
  }

  void
  test_elements(const BodyParameters &body, const unsigned int degree)
  {
    SceneParameters scene;
    scene.bodies = {body};
    const Discretization d(scene, {}, degree, MPI_COMM_SELF);
    ElementMatrices      element(d.dof_handler(), d.mapping());
    Eigen::MatrixXd      K, M;
    double               mass = 0.;
    for (const auto &cell : d.dof_handler().active_cell_iterators())
      {
        element.reinit(cell);
        element.stiffness(elastic_tensor(body), K);
        element.mass(M);
        const auto           &fe    = d.dof_handler().get_fe();
        const Eigen::MatrixXd whole = K.selfadjointView<Eigen::Upper>();
        check((whole - K).norm() <= 1e-13 * K.norm(), "K is symmetric");
        Eigen::MatrixXd R(fe.n_dofs_per_cell(), 6);
        for (unsigned int i = 0; i < fe.n_dofs_per_cell(); ++i)
          {
            const auto x = d.mapping().transform_unit_to_real_cell(
              cell, fe.unit_support_point(i));
            const unsigned int c = element.component(i);
            for (unsigned int k = 0; k < 6; ++k)
              {
                dealii::Tensor<1, 3> e;
                e[k % 3] = 1.;
                R(i, k)  = (k < 3 ? e : dealii::cross_product_3d(e, x))[c];
              }
          }
        check_below((K * R).norm() / (K.cwiseAbs() * R.cwiseAbs()).norm(),
                    1e-13,
                    body.name + " p = " + std::to_string(degree) +
                      ": element stiffness annihilates rigid motions");
        const Eigen::MatrixXd RMR = R.transpose() * M * R;
        check(std::abs(RMR(0, 1)) < 1e-14 * RMR(0, 0),
              "components are apart in the mass");
        mass += RMR(0, 0);
        if (degree > 2)
          break;
      }
  }

  void
  test_body(const BodyParameters &body,
            const unsigned int    degree,
            const double          volume,
            const double          tolerance)
  {
    SceneParameters scene;
    scene.bodies = {body};
    const Discretization d(scene, {}, degree, MPI_COMM_SELF);
    const auto           matrices = assemble_bodies(d);
    const Block          R        = rigid_motions(d);
    check_below(rigid_force(*matrices[0].stiffness, R),
                1e-13,
                body.name + ": stiffness annihilates rigid motions");
    const Eigen::MatrixXd RMR = R.transpose() * matrices[0].mass->multiply(R);
    for (unsigned int c = 0; c < 3; ++c)
      {
        check_close(RMR(c, c),
                    volume,
                    tolerance,
                    body.name + ": mass totals the body's mass");
        check_close(RMR(c, c),
                    matrices[0].volume,
                    1e-12,
                    body.name + ": mass is density times mesh volume");
      }
    // r x u of a rotation against a translation: the static moment.
    check_close(RMR(0, 5),
                -matrices[0].centre[1] * matrices[0].volume,
                1e-12,
                body.name + ": static moment",
                volume);
  }

  void
  test_hanging_nodes(const BodyParameters &body,
                     const unsigned int    degree,
                     const double          tolerance)
  {
    SceneParameters scene;
    scene.bodies = {body};
    Discretization d(scene, {}, degree, MPI_COMM_SELF);
    const auto     volume = assemble_bodies(d)[0].volume;
    for (unsigned int cycle = 0; cycle < 2; ++cycle)
      {
        std::vector<double> marks(d.triangulation().n_active_cells(), 0.);
        marks[0] = 1.;
        d.refine(marks, 0.9);
      }
    const auto         matrices = assemble_bodies(d);
    const unsigned int n        = d.space()->n_global();
    check(n < d.n_dofs(), body.name + ": hanging nodes are no unknowns");
    const Block R = rigid_motions(d);
    check_below(rigid_force(*matrices[0].stiffness, R),
                tolerance,
                body.name + " p = " + std::to_string(degree) +
                  ": rigid motions in the kernel with hanging nodes");
    const Eigen::MatrixXd RMR = R.transpose() * matrices[0].mass->multiply(R);
    check_close(RMR(2, 2),
                matrices[0].volume,
                1e-12,
                body.name + ": mass with hanging nodes");
    check_close(volume, matrices[0].volume, 1e-4, body.name + ": volume kept");
  }
} // namespace



int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize init(argc, argv, 1);
  BodyParameters                           block =
    make_block("block", {{1., 2., 3.}}, {{.3, .2, .1}}, {{2, 2, 2}});
  BodyParameters annulus = make_annulus({{8, 2, 1}});
  BodyParameters cylinder;
  cylinder.name         = "cylinder";
  cylinder.shape        = BodyParameters::Shape::cylinder;
  cylinder.outer_radius = .05;
  cylinder.height       = .1;
  cylinder.cells        = {{8, 2, 2}};

  for (const unsigned int degree : {1, 2, 3})
    for (const auto &body : {block, orthotropic(block), orthotropic(annulus)})
      test_elements(body, degree);

  test_body(block, 1, .3 * .2 * .1, 1e-13);
  test_body(orthotropic(block), 2, .3 * .2 * .1, 1e-13);
  const double ring = M_PI * (.12 * .12 - .05 * .05) * .01;
  test_body(annulus, 2, ring, 1e-3);
  test_body(orthotropic(annulus), 3, ring, 1e-5);
  test_body(cylinder, 2, M_PI * .05 * .05 * .1, 1e-3);

  test_hanging_nodes(block, 1, 1e-13);
  test_hanging_nodes(orthotropic(block), 2, 1e-13);
  test_hanging_nodes(block, 3, 1e-13);
  test_hanging_nodes(annulus, 2, 1e-4);
  test_hanging_nodes(annulus, 3, 1e-5);
  return 0;
}
