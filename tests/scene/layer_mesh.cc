// SPDX-License-Identifier: LGPL-2.1-or-later

// A layer is as thick as asked along the normals of its face, flat or round, of
// squeal's own bodies and of files of first and second order; it shares the
// nodes of the face; turned and mirrored it is the same; what it covers is
// refused to everything else.

#include <squeal/base/exceptions.h>
#include <squeal/discretization/assembly.h>
#include <squeal/parameters/checks.h>

#include <deal.II/base/mpi.h>

#include <deal.II/distributed/tria.h>

#include <deal.II/fe/mapping.h>

#include <Eigen/Eigenvalues>

#include "gmsh_annulus.h"
#include "scenes.h"

using namespace squeal;
using namespace squeal::testing;

namespace
{
  BodyParameters
  make_layer(const std::string &body,
             const std::string &face,
             const double       thickness,
             const unsigned int n = 2)
  {
    BodyParameters layer;
    layer.name           = "layer";
    layer.shape          = BodyParameters::Shape::layer;
    layer.layer_body     = body;
    layer.layer_face     = face;
    layer.thickness      = thickness;
    layer.element_layers = n;
    layer.young_modulus  = 1e9;
    layer.poisson_ratio  = .4;
    layer.density        = 1200.;
    return layer;
  }

  SceneParameters
  with_layer(const BodyParameters &body,
             const std::string    &face,
             const double          thickness,
             const unsigned int    n = 2)
  {
    SceneParameters scene;
    scene.bodies = {body, make_layer(body.name, face, thickness, n)};
    return scene;
  }

  /** Volumes of all bodies, m^3. */
  std::vector<double>
  volumes(const SceneParameters &scene,
          const unsigned int     degree,
          const unsigned int     refinements = 0)
  {
    DiscretizationParameters p;
    p.refinements = refinements;
    const Discretization d(scene, p, degree, MPI_COMM_SELF);
    std::vector<double>  result;
    for (const auto &matrices : assemble_bodies(d))
      result.push_back(matrices.volume);
    return result;
  }

  /** Eigenvalues of the free scene beyond its six rigid motions. */
  Eigen::VectorXd
  spectrum(const SceneParameters &scene, const unsigned int degree)
  {
    const Discretization  d(scene, {}, degree, MPI_COMM_SELF);
    const auto            matrices = assemble_bodies(d);
    const unsigned int    n        = d.space()->n_global();
    const Eigen::MatrixXd one      = Eigen::MatrixXd::Identity(n, n);
    Eigen::MatrixXd       K = Eigen::MatrixXd::Zero(n, n), M = K;
    for (std::size_t b = 0; b < matrices.size(); ++b)
      {
        K +=
          scene.bodies[b].young_modulus * matrices[b].stiffness->multiply(one);
        M += scene.bodies[b].density * matrices[b].mass->multiply(one);
      }
    return Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd>(
             K, M, Eigen::EigenvaluesOnly)
      .eigenvalues()
      .tail(n - 6);
  }

  double
  difference(const Eigen::VectorXd &a, const Eigen::VectorXd &b)
  {
    if (a.size() != b.size())
      return 1.;
    return (a - b).cwiseQuotient(b).cwiseAbs().maxCoeff<Eigen::PropagateNaN>();
  }

  const BodyParameters pad =
    make_block("pad", {{.1, 0., .01}}, {{.03, .02, .01}}, {{3, 2, 1}});

  void
  flat()
  {
    const SceneParameters scene = with_layer(pad, "z_max", .002, 3);
    const CoarseMesh      mesh  = make_coarse_mesh(scene);
    check(mesh.cells.size() == 6 + 18, "cells of pad and layer");
    check(mesh.vertices.size() == 24 + 36, "the face's vertices are shared");
    check(mesh.face_names[1] == std::vector<std::string>({"outer", "sides"}),
          "the faces of a layer have names");
    unsigned int n_outer = 0, n_sides = 0, n_covered = 0;
    for (const auto &quad : mesh.boundary.boundary_quads)
      {
        n_outer += quad.boundary_id == face_id(1, 0);
        n_sides += quad.boundary_id == face_id(1, 1);
        n_covered += quad.boundary_id == face_id(mesh, scene, "pad", "z_max");
      }
    check(n_outer == 6 && n_sides == 30, "outer face and sides");
    check(n_covered == 0, "what it covers is no boundary any more");
    check(axis_of_face(mesh, face_id(1, 0)) == 2,
          "the outer face looks along z");
    const auto v = volumes(scene, 1);
    check_close(v[1], .03 * .02 * .002, 1e-12, "volume of the layer");

    // The same as a block tied to the pad.
    SceneParameters tied;
    tied.bodies = {
      pad,
      make_block("layer", {{.1, 0., .02}}, {{.03, .02, .002}}, {{3, 2, 3}})};
    const BodyParameters &layer  = scene.bodies[1];
    tied.bodies[1].young_modulus = layer.young_modulus;
    tied.bodies[1].poisson_ratio = layer.poisson_ratio;
    tied.bodies[1].density       = layer.density;
    tied.ties                    = {make_tie("layer", "z_min", "pad", "z_max")};
    check(difference(spectrum(scene, 1), spectrum(tied, 1)) < 1e-9,
          "a layer is a block that is tied on");
  }

  void
  turned_and_mirrored()
  {
    const Eigen::VectorXd expected =
      spectrum(with_layer(pad, "y_max", .002), 1);
    check(difference(spectrum(with_layer(pad, "y_min", .002), 1), expected) <
            1e-9,
          "mirrored, the layer is the same");
    BodyParameters turned = pad;
    turned.angle          = 33.;
    turned.rotation_axis  = {{1., 2., -.5}};
    check(difference(spectrum(with_layer(turned, "y_max", .002), 1), expected) <
            1e-9,
          "turned with its body, the layer is the same");
  }

  void
  round()
  {
    BodyParameters ring;
    ring.name         = "ring";
    ring.shape        = BodyParameters::Shape::annulus;
    ring.inner_radius = .1;
    ring.outer_radius = .2;
    ring.height       = .05;
    ring.cells        = {{12, 2, 1}};
    const double t    = .01;
    const auto   area = [](const double a, const double b) {
      return M_PI * (b * b - a * a);
    };
    for (const unsigned int refinements : {0u, 1u})
      {
        const std::string when = refinements ? ", refined" : "";
        auto v = volumes(with_layer(ring, "outer", t), 3, refinements);
        check_close(
          v[1], .05 * area(.2, .2 + t), 2e-6, "round an annulus" + when);
        check_close(v[0], .05 * area(.1, .2), 2e-6, "the annulus" + when);
        v = volumes(with_layer(ring, "inner", t), 3, refinements);
        check_close(v[1], .05 * area(.1 - t, .1), 2e-6, "inside of it" + when);
        v = volumes(with_layer(ring, "top", t), 3, refinements);
        check_close(v[1], t * area(.1, .2), 2e-6, "on top of it" + when);
      }
    BodyParameters cylinder = ring;
    cylinder.shape          = BodyParameters::Shape::cylinder;
    cylinder.cells          = {{16, 1, 1}};
    auto v                  = volumes(with_layer(cylinder, "side", t), 3);
    check_close(v[1], .05 * area(.2, .2 + t), 1e-5, "round a cylinder");
    check_close(v[0], .05 * area(0., .2), 1e-5, "the cylinder");
    v = volumes(with_layer(cylinder, "top", t), 3);
    check_close(v[1], t * area(0., .2), 1e-5, "on top of a cylinder");

    // A stack: a layer on a layer.
    SceneParameters stack = with_layer(ring, "outer", t);
    stack.bodies.push_back(make_layer("layer", "outer", t));
    stack.bodies[2].name = "second";
    v                    = volumes(stack, 3);
    check_close(v[2], .05 * area(.2 + t, .2 + 2. * t), 2e-6, "a second layer");
  }

  void
  imported()
  {
    BodyParameters ring;
    ring.name         = "ring";
    ring.inner_radius = .1;
    ring.outer_radius = .2;
    ring.height       = .05;
    ring.cells        = {{12, 2, 1}};
    const double t = .01, exact = .05 * M_PI * (.21 * .21 - .04);
    for (const unsigned int n_nodes : {8, 20, 27})
      {
        AnnulusFile(ring, n_nodes).write_2("ring.msh");
        BodyParameters body = ring;
        body.shape          = BodyParameters::Shape::gmsh;
        body.mesh_file      = "ring.msh";
        const std::string what =
          "on a file of " + std::to_string(n_nodes) + " nodes";
        const auto       scene = with_layer(body, "outer", t);
        const CoarseMesh mesh  = make_coarse_mesh(scene);
        check(mesh.curved.size() == (n_nodes == 8 ? 0 : 24 + 24),
              what + ": the layer is of the order of the face");
        // Of 12 facets the area is that of the polygon.
        const double h        = M_PI / 12.;
        const double expected = n_nodes == 8
                                  ? .05 * 12. * std::tan(h) *
                                      (std::pow(.2 * std::cos(h) + t, 2) -
                                       std::pow(.2 * std::cos(h), 2))
                                  : exact;
        check_close(volumes(scene, 3)[1],
                    expected,
                    n_nodes == 8 ? 1e-10 : 2e-4,
                    what + ": thickness along the normals");
        check_close(volumes(scene, 3, 1)[1],
                    expected,
                    n_nodes == 8 ? 1e-10 : 2e-4,
                    what + ": refined");
        check_close(volumes(with_layer(body, "z_max", t), 3)[1],
                    volumes(scene, 3)[0] / .05 * t,
                    1e-10,
                    what + ": on the flat face");
      }
  }

  void
  bad()
  {
    const auto refuses = [](const SceneParameters &scene,
                            const std::string     &part,
                            const std::string     &what) {
      check_throws<InputError>([&]() { prm::check_scene(scene); }, part, what);
    };
    SceneParameters scene = with_layer(pad, "z_max", .002);
    prm::check_scene(scene);
    scene.supports = {make_clamp("pad", "z_max")};
    refuses(scene,
            "covered by the layer 'layer': take the face 'outer'",
            "a support on a covered face");
    scene.supports = {make_clamp("layer", "outer")};
    prm::check_scene(scene);
    scene.supports = {make_clamp("layer", "inner")};
    refuses(scene, "outer, sides", "a face that a layer does not have");
    scene.supports.clear();
    std::swap(scene.bodies[0], scene.bodies[1]);
    refuses(scene, "must stand before the layer", "a layer before its body");
    scene                      = with_layer(pad, "z_max", .002);
    scene.bodies[1].layer_face = "back";
    refuses(scene, "'back'", "a face that the body does not have");
    scene                      = with_layer(pad, "z_max", .002);
    scene.bodies[0].layer_face = "z_min";
    refuses(scene, "is for 'Shape = layer'", "a layer face of a block");
    scene.bodies[0].layer_face.clear();
    scene.bodies.push_back(make_layer("pad", "z_max", .001));
    scene.bodies[2].name = "second";
    refuses(scene, "covered by the layer", "two layers on one face");

    BodyParameters ring;
    ring.name         = "ring";
    ring.shape        = BodyParameters::Shape::annulus;
    ring.inner_radius = .1;
    ring.outer_radius = .2;
    ring.height       = .05;
    check_throws<InputError>(
      [&]() { make_coarse_mesh(with_layer(ring, "inner", .11)); },
      "turns inside out",
      "a layer thicker than the hollow");
  }
} // namespace

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  flat();
  turned_and_mirrored();
  round();
  imported();
  bad();
}
