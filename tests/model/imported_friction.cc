// SPDX-License-Identifier: LGPL-2.1-or-later

// Imported friction as K(1) - K(0) of two degrees of freedom, with and without
// an unknown that a huge number holds: K is that of the coefficient, and the
// undamped, frictionless problem is K(0) whatever it is. Friction in C follows
// the coefficient, of its symmetric part the size.

#include <squeal/discretization/affine_system.h>
#include <squeal/model/imported_system.h>

#include <deal.II/base/mpi.h>

#include "../check.h"
#include "../scene/import_helpers.h"

#include <cmath>

using namespace squeal;
using namespace squeal::testing;
using Role = MatrixPartParameters::Role;

namespace
{
  /** Lines of Abaqus for the unknowns (1, 2) and (1, 3). */
  std::string
  lines_of(const Eigen::Matrix2d &A, const bool is_held)
  {
    std::string text;
    for (int i = 0; i < 2; ++i)
      for (int j = 0; j < 2; ++j)
        if (A(i, j) != 0.)
          text += "1," + std::to_string(i + 2) + ", 1," +
                  std::to_string(j + 2) + ", " + std::to_string(A(i, j)) + "\n";
    return text + (is_held ? "2,1, 2,1, 1.0e36\n" : "");
  }

  void
  add_part(SceneParameters   &scene,
           const std::string &name,
           const std::string &text,
           const Role         role,
           const double       factor = 1.)
  {
    scene.matrix_parts.push_back(
      part_of(write_text(name + ".mtx", text), role));
    scene.matrix_parts.back().name   = name;
    scene.matrix_parts.back().factor = factor;
  }

  Eigen::Matrix2d
  K_of(const double mu)
  {
    Eigen::Matrix2d K;
    K << 2e8, 1e8 - mu * 1.25e8, 1e8, 2e8;
    return K;
  }

  void
  test_friction(const bool is_held)
  {
    SceneParameters scene;
    add_part(scene,
             "mass",
             lines_of(Eigen::Matrix2d::Identity(), false) +
               (is_held ? "2,1, 2,1, 1.\n" : ""),
             Role::mass);
    add_part(scene, "k", lines_of(K_of(0.), is_held), Role::stiffness);
    add_part(scene, "f1", lines_of(K_of(1.), is_held), Role::friction);
    add_part(scene, "f0", lines_of(K_of(0.), is_held), Role::friction, -1.);
    const ImportedModel    model  = read_imported_model(scene);
    const LinearizedSystem system = imported_parts(model);
    check(model.n_dofs == 2, "the held unknown is taken out");
    const std::string claim = is_held ? ", one held" : "";
    for (const double mu : {0.4, 1., 1.2, -0.5})
      {
        scene.friction_coefficient = mu;
        const Pencil          pencil(system.system, scene);
        const Eigen::Matrix2d I = Eigen::Matrix2d::Identity();
        const Eigen::Matrix2d K =
          pencil.apply(ComplexBlock(I.cast<std::complex<double>>()))
            .stiffness.real();
        check((K - K_of(mu)).norm() <= 1e-14 * K_of(0.).norm(),
              "K with friction at " + std::to_string(mu) + claim);
        check(
          (pencil.multiply_undamped_stiffness(Block(I)) - K_of(0.)).norm() <=
            1e-14 * K_of(0.).norm(),
          "K without friction at " + std::to_string(mu) + claim);
      }
    check(friction_terms(system.system).terms.size() == 2,
          "both parts are friction" + claim);
  }

  void
  test_damping()
  {
    const std::string banner = "%%MatrixMarket matrix coordinate real ",
                      mark   = std::string("% ") + damping_mark + "\n";
    SceneParameters scene;
    add_part(
      scene, "mass", banner + "symmetric\n2 2 2\n1 1 1\n2 2 1\n", Role::mass);
    add_part(
      scene, "k", banner + "symmetric\n2 2 2\n1 1 4\n2 2 9\n", Role::stiffness);
    add_part(scene,
             "across",
             banner + "symmetric\n" + mark + "2 2 1\n1 1 3\n",
             Role::friction,
             2.);
    add_part(scene,
             "coupled",
             banner + "general\n" + mark + "2 2 1\n1 2 5\n",
             Role::friction);
    scene.damping.model           = DampingParameters::Model::whole_model;
    const LinearizedSystem system = imported_parts(read_imported_model(scene));
    for (const double mu : {0.3, -0.3})
      {
        scene.friction_coefficient = mu;
        const Eigen::Matrix2cd I   = Eigen::Matrix2cd::Identity();
        const auto             products =
          Pencil(system.system, scene).apply(ComplexBlock(I));
        Eigen::Matrix2d C;
        C << 6. * std::abs(mu), 5. * mu, 0., 0.;
        check((products.damping - C).norm() <= 1e-15,
              "friction in C at " + std::to_string(mu));
        check(products.stiffness(0, 0) == 4. && products.stiffness(0, 1) == 0.,
              "and not in K");
      }
  }
} // namespace



int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize init(argc, argv, 1);
  test_friction(false);
  test_friction(true);
  test_damping();
}
