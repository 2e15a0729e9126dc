// SPDX-License-Identifier: LGPL-2.1-or-later

// An annulus imported in second order is squeal's own of degree 2: its nodes
// lie where a mapping of degree 2 takes the cylinders'. Refinement, everywhere
// or in places, keeps the shape of curved cells.

#include <squeal/discretization/assembly.h>
#include <squeal/discretization/face_quadrature.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>

#include <deal.II/distributed/tria.h>

#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping.h>

#include <Eigen/Eigenvalues>

#include "../scene/gmsh_annulus.h"
#include "scenes.h"
#include "worst.h"

using namespace squeal;
using namespace squeal::testing;

namespace
{
  const std::array<unsigned int, 3> n_cells{{8, 1, 1}};

  BodyParameters
  unmoved()
  {
    BodyParameters body;
    body.name   = "disc";
    body.shape  = BodyParameters::Shape::annulus;
    body.height = .03;
    body.cells  = n_cells;
    return body;
  }

  /** A turned and displaced disc that a file describes. */
  SceneParameters
  imported(const std::string &file)
  {
    SceneParameters scene;
    scene.bodies              = {unmoved()};
    scene.bodies[0].shape     = BodyParameters::Shape::gmsh;
    scene.bodies[0].mesh_file = file;
    scene.bodies[0].position  = {{.1, .2, .3}};
    scene.bodies[0].angle     = 17.;
    return scene;
  }

  /** All eigenvalues of the free body. */
  Eigen::VectorXd
  spectrum(const SceneParameters &scene)
  {
    const Discretization  d(scene, {}, 2, MPI_COMM_SELF);
    const auto            matrices = assemble_bodies(d);
    const unsigned int    n        = d.space()->n_global();
    const Eigen::MatrixXd one      = Eigen::MatrixXd::Identity(n, n);
    return Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd>(
             matrices[0].stiffness->multiply(one),
             matrices[0].mass->multiply(one),
             Eigen::EigenvaluesOnly)
      .eigenvalues();
  }

  void
  equal_order()
  {
    SceneParameters own;
    own.bodies                     = {unmoved()};
    const Eigen::VectorXd expected = spectrum(own);
    const auto            error    = [&](const std::string &file) {
      const Eigen::VectorXd found = spectrum(imported(file));
      if (found.size() != expected.size())
        check(false, file + ": number of unknowns");
      // The six rigid motions are zero up to rounding of the largest one.
      const auto n = expected.size() - 6;
      return (found - expected)
        .tail(n)
        .cwiseQuotient(expected.tail(n))
        .cwiseAbs()
        .maxCoeff<Eigen::PropagateNaN>();
    };
    for (const unsigned int n_nodes : {20, 27})
      {
        const AnnulusFile file(unmoved(), n_nodes);
        file.write_2("two.msh");
        file.write_4("four.msh");
        for (const std::string name : {"two.msh", "four.msh"})
          check_below(error(name),
                      1e-8,
                      std::to_string(n_nodes) + " nodes, " + name +
                        ": eigenvalues of the own annulus");
      }
    AnnulusFile(unmoved(), 8).write_2("flat.msh");
    check(error("flat.msh") > 1e-3, "first order is another body");
  }

  double
  volume(const Discretization &d)
  {
    dealii::FEValues<3> values(d.mapping(),
                               d.dof_handler().get_fe(),
                               dealii::QGauss<3>(4),
                               dealii::update_JxW_values);
    double              sum = 0.;
    for (const auto &cell : d.dof_handler().active_cell_iterators())
      {
        values.reinit(cell);
        for (const double w : values.get_JxW_values())
          sum += w;
      }
    return sum;
  }

  void
  shape_of_refined_cells()
  {
    AnnulusFile(unmoved(), 27).write_2("two.msh", [](auto x) {
      // no symmetry is left, and the faces z = const are round
      const double y = x[1];
      x[0] += 3. * y * y * y + .2 * x[2];
      x[2] += 2. * x[0] * x[0] * (1. + y);
      return x;
    });
    const SceneParameters    scene = imported("two.msh");
    DiscretizationParameters p;
    const Discretization     coarse(scene, p, 2, MPI_COMM_SELF);
    const double             exact = volume(coarse);
    const double area = face_quadrature(coarse, face_id(0, 1), 8).total_area();
    for (const unsigned int degree : {2, 3, 4})
      {
        p.refinements = 1;
        Discretization fine(scene, p, degree, MPI_COMM_SELF);
        const auto     same = [&](const std::string &what) {
          const std::string degrees = ", degree " + std::to_string(degree);
          check_close(volume(fine), exact, 1e-12, what + ": volume" + degrees);
          // quadrature of a root, which refinement makes more exact
          check_close(face_quadrature(fine, face_id(0, 1), 8).total_area(),
                      area,
                      1e-9,
                      what + ": area of the outer face" + degrees);
        };
        same("refined everywhere");
        std::vector<double> indicators(fine.triangulation().n_active_cells(),
                                       0.);
        indicators[5] = 1.;
        fine.refine(indicators, .5);
        check(fine.triangulation().has_hanging_nodes(), "hanging nodes");
        same("refined in one place");
      }
    check(axis_of_face(coarse.coarse_mesh(), face_id(0, 3)) == -1u,
          "a face that only the middle nodes make round is not flat");
  }

  void
  flat_faces_stay_flat()
  {
    AnnulusFile(unmoved(), 20).write_2("two.msh");
    const CoarseMesh mesh = make_coarse_mesh(imported("two.msh"));
    check(axis_of_face(mesh, face_id(0, 3)) == 2, "z_max looks along z");
    check(axis_of_face(mesh, face_id(0, 1)) == -1u, "the rim does not");
    check(mesh.curved.size() == mesh.cells.size(), "all cells are curved");
  }
} // namespace

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  flat_faces_stay_flat();
  shape_of_refined_cells();
  equal_order();
}
