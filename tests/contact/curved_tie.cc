// SPDX-License-Identifier: LGPL-2.1-or-later

// A tie between arcs and facets lets every rigid motion pass, so that a free
// tied body has six zero eigenvalues; a ring of two rings has the frequencies
// of the whole one as the facets become small; what lies too far apart is
// refused.

#include "../scene/gmsh_annulus.h"
#include "scenes.h"
#include "worst.h"

#include <squeal/base/exceptions.h>
#include <squeal/contact/mortar.h>

#include <deal.II/base/mpi.h>

#include <Eigen/Eigenvalues>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  BodyParameters
  ring(const std::string &name,
       const double       inner,
       const double       outer,
       const unsigned int n)
  {
    BodyParameters body;
    body.name         = name;
    body.shape        = BodyParameters::Shape::annulus;
    body.inner_radius = inner;
    body.outer_radius = outer;
    body.height       = .02;
    body.cells        = {{n, 1, 1}};
    return body;
  }

  /** The same with straight edges, from a file. */
  BodyParameters
  facets(BodyParameters body)
  {
    const std::string file = body.name + std::to_string(body.cells[0]) + ".msh";
    AnnulusFile(body, 8).write_2(file);
    body.shape     = BodyParameters::Shape::gmsh;
    body.mesh_file = file;
    body.position  = {{0., 0., 0.}};
    return body;
  }

  /** Hub of arcs within a rim of facets. @p hub_leads: the hub is the source.
   */
  SceneParameters
  two_rings(const unsigned int n_hub,
            const unsigned int n_rim,
            const bool         hub_leads)
  {
    SceneParameters scene;
    scene.bodies = {ring("hub", .05, .08, n_hub),
                    facets(ring("rim", .08, .12, n_rim))};
    TieParameters tie;
    tie.name = "shrink fit";
    tie.kind = TieParameters::Kind::mortar;
    if (hub_leads)
      {
        tie.source_body = "hub";
        tie.source_face = "outer";
        tie.target_body = "rim";
        tie.target_face = "inner";
      }
    else
      {
        tie.source_body = "rim";
        tie.source_face = "inner";
        tie.target_body = "hub";
        tie.target_face = "outer";
      }
    scene.ties = {tie};
    return scene;
  }

  /** Flat rings whose rims are an arc and a polygon. */
  SceneParameters
  stacked(const unsigned int n)
  {
    SceneParameters scene;
    scene.bodies                = {ring("plate", .05, .12, n),
                                   facets(ring("vane", .05, .12, n))};
    scene.bodies[1].position[2] = .02;
    TieParameters tie;
    tie.name        = "glue";
    tie.kind        = TieParameters::Kind::mortar;
    tie.source_body = "plate";
    tie.source_face = "top";
    tie.target_body = "vane";
    tie.target_face = "z_min";
    scene.ties      = {tie};
    return scene;
  }

  /** Rigid motions of the target are those of the source face. */
  void
  rigid_motions_pass(const SceneParameters &scene,
                     const unsigned int     degree,
                     const std::string     &what)
  {
    const Discretization d(scene, {}, degree, MPI_COMM_SELF);
    const auto           tie = make_tie_coupling(d, PointEvaluator(d), 0);
    const Block          R   = rigid_motions(d);
    Worst                worst;
    for (std::size_t j = 0; j < tie.nodes.size(); ++j)
      for (unsigned int c = 0; c < 3; ++c)
        for (Eigen::Index k = 0; k < 6; ++k)
          {
            double value = -R(tie.source_rows[j][c], k);
            for (const auto &[row, weight] : tie.target_rows[j][c])
              value += weight * R(row, k);
            worst.add(std::abs(value) / (k < 3 ? 1. : .12));
          }
    check_below(worst.largest(), 1e-12, what + ": rigid motions pass");
    check(tie.distance > 1e-5 || tie.beside > 1e-4,
          what + ": the faces differ by " + number(1e3 * tie.distance) +
            " mm, or beside each other by " + number(100. * tie.beside) + " %");
    check(remarks_on_ties(d).size() == 1 &&
            remarks_on_ties(d)[0].find(" mm at most") != std::string::npos,
          what + ": the log says so");
  }

  /** All eigenvalues of the free assembly, ascending. */
  Eigen::VectorXd
  spectrum(const SceneParameters &scene, const unsigned int degree)
  {
    const Discretization  d(scene, {}, degree, MPI_COMM_SELF);
    const auto            linearized = linearized_system(d, assemble_bodies(d));
    const Pencil          pencil(linearized.system, scene);
    const unsigned int    n   = linearized.system.space->n_global();
    const Block           one = Block::Identity(n, n);
    const Eigen::MatrixXd K   = pencil.multiply_undamped_stiffness(one),
                          M   = pencil.multiply_mass(one);
    return Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd>(
             .5 * (K + K.transpose()),
             .5 * (M + M.transpose()),
             Eigen::EigenvaluesOnly)
      .eigenvalues();
  }

  /** A rotor of two plates with 21 vanes between them that share no nodes: one
   * body of 21 parts. */
  SceneParameters
  ventilated_rotor()
  {
    const unsigned int n = 21;
    std::ofstream      out("vanes.msh");
    out << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n3\n"
           "2 1 \"below\"\n2 2 \"above\"\n3 3 \"vanes\"\n"
           "$EndPhysicalNames\n$Nodes\n"
        << 8 * n << "\n"
        << std::setprecision(17);
    for (unsigned int v = 0; v < n; ++v)
      for (unsigned int k = 0; k < 8; ++k)
        {
          const bool   is_outer = k % 4 == 1 || k % 4 == 2;
          const double x = is_outer ? .1 : .07, y = k % 4 < 2 ? -.004 : .004,
                       turn = 2. * M_PI * (v + .3) / n;
          out << 8 * v + k + 1 << ' ' << x * std::cos(turn) - y * std::sin(turn)
              << ' ' << x * std::sin(turn) + y * std::cos(turn) << ' '
              << (k < 4 ? .02 : .035) << "\n";
        }
    out << "$EndNodes\n$Elements\n" << 3 * n << "\n";
    for (unsigned int v = 0; v < n; ++v)
      {
        const auto nodes = [&](const std::vector<unsigned int> &corners) {
          for (const unsigned int c : corners)
            out << ' ' << 8 * v + c;
          out << "\n";
        };
        out << 3 * v + 1 << " 5 2 3 1";
        nodes({1, 2, 3, 4, 5, 6, 7, 8});
        out << 3 * v + 2 << " 3 2 1 1";
        nodes({1, 2, 3, 4});
        out << 3 * v + 3 << " 3 2 2 1";
        nodes({5, 6, 7, 8});
      }
    out << "$EndElements\n";

    SceneParameters scene;
    scene.bodies                = {ring("lower", .05, .12, n),
                                   ring("upper", .05, .12, n),
                                   ring("vanes", 0., 0., n)};
    scene.bodies[1].position[2] = .035;
    scene.bodies[2].shape       = BodyParameters::Shape::gmsh;
    scene.bodies[2].mesh_file   = "vanes.msh";
    using Kind                  = TieParameters::Kind;
    scene.ties = {make_tie("vanes", "below", "lower", "top", Kind::mortar),
                  make_tie("vanes", "above", "upper", "bottom", Kind::mortar)};
    return scene;
  }

  void
  free_assembly(const SceneParameters &scene,
                const std::string     &what,
                const unsigned int     degree = 2)
  {
    const Eigen::VectorXd values = spectrum(scene, degree);
    check_below(values.head(6).cwiseAbs().maxCoeff<Eigen::PropagateNaN>() /
                  values[values.size() - 1],
                1e-13,
                what + ": six eigenvalues are zero, over the largest");
    check(values[6] > 1e3 * std::abs(values[5]) && values[6] > 1e6,
          what + ": the seventh is not");
  }

  /** Those below 4.5 kHz, Hz; the first six are of rigid motions. */
  Eigen::VectorXd
  frequencies(const SceneParameters &scene)
  {
    const Model         model(scene, 2, 4.5e3);
    const UndampedModes modes = undamped_modes(model.pencil, model.inverse);
    return modes.omega_squared.head(modes.n_certified).cwiseAbs().cwiseSqrt() /
           (2. * M_PI);
  }

  void
  frequencies_converge()
  {
    SceneParameters whole;
    whole.bodies                = {ring("disc", .05, .12, 16)};
    whole.bodies[0].cells       = {{16, 2, 1}};
    const Eigen::VectorXd exact = frequencies(whole);
    double                last  = 0.;
    for (const unsigned int n : {16, 32})
      {
        const Eigen::VectorXd found = frequencies(two_rings(16, n, false));
        check(found.size() == exact.size() && exact.size() > 8,
              "as many modes as the whole ring: " + std::to_string(n));
        const double error = (found.tail(found.size() - 6).array() /
                                exact.tail(found.size() - 6).array() -
                              1.)
                               .abs()
                               .maxCoeff<Eigen::PropagateNaN>();
        std::cout << "        " << n << " facets: " << error << std::endl;
        if (last > 0.)
          check_below(error, .4 * last, "twice the facets, less error");
        last = error;
      }
    check_below(last, .01, "32 facets");
  }
} // namespace



int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize init(argc, argv, 1);
  for (const unsigned int degree : {1, 2, 3})
    {
      const std::string p = ", p = " + std::to_string(degree);
      rigid_motions_pass(two_rings(16, 20, false), degree, "facets lead" + p);
      rigid_motions_pass(two_rings(16, 20, true), degree, "arcs lead" + p);
      if (degree > 1)
        rigid_motions_pass(stacked(24), degree, "flat faces" + p);
    }
  free_assembly(two_rings(12, 16, false), "facets lead");
  free_assembly(two_rings(12, 16, true), "arcs lead");
  free_assembly(ventilated_rotor(), "21 vanes between two plates", 1);
  frequencies_converge();
  SceneParameters apart        = two_rings(16, 20, false);
  apart.bodies[0].outer_radius = .07;
  check_throws<InputError>(
    [&]() {
      const Discretization d(apart, {}, 2, MPI_COMM_SELF);
      make_tie_coupling(d, PointEvaluator(d), 0);
    },
    "has no target opposite",
    "refused: faces 10 mm apart");
}
