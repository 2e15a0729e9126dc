// SPDX-License-Identifier: LGPL-2.1-or-later

// The quads are the closed surfaces of the bodies, seen from outside, and move
// with them.

#include <squeal/results/surface_quads.h>

#include <deal.II/base/mpi.h>

#include "check.h"
#include "shape_scene.h"
#include "worst.h"

#include <algorithm>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  Eigen::Vector3d
  vector(const std::array<double, 3> &x)
  {
    return {x[0], x[1], x[2]};
  }

  /** Volume inside the quads of the bodies from @p first to @p last by
   * Gauss' theorem, m^3: negative where the quads are seen from inside. */
  double
  enclosed_volume(const std::vector<SurfaceQuad> &quads,
                  const unsigned int              first,
                  const unsigned int              last)
  {
    double volume = 0.;
    for (const auto &quad : quads)
      if (quad.body >= first && quad.body <= last)
        for (const unsigned int v : {1, 2})
          volume +=
            vector(quad.corners[0])
              .dot(vector(quad.corners[v]).cross(vector(quad.corners[v + 1]))) /
            6.;
    return volume;
  }

  void
  check_quads(const Discretization &discretization,
              const unsigned int    n,
              const bool            is_root)
  {
    const LinearMotion real(0.3), imaginary(1.7);
    const Block        re = unknowns(discretization, real);
    const Block        im = unknowns(discretization, imaginary);
    const SurfaceQuads surface(discretization, n);
    const double       phase   = 0.7;
    const auto         at_rest = surface.evaluate(re);
    const auto         quads   = surface.evaluate(re, im, phase);
    check_close(surface.size(),
                std::sqrt(.32 * .32 + .24 * .24 + .03 * .03),
                1e-12,
                "size of the scene");
    if (!is_root)
      {
        check(quads.empty(), "the quads are on rank 0");
        return;
      }

    Worst error;
    for (unsigned int q = 0; q < quads.size(); ++q)
      for (unsigned int v = 0; v < 4; ++v)
        {
          const auto   x = vector(quads[q].corners[v]);
          const auto   b = quads[q].body;
          const double still =
            (vector(at_rest[q].displacements[v]) - real.at(b, x)).norm();
          const double turned = (vector(quads[q].displacements[v]) -
                                 std::cos(phase) * real.at(b, x) +
                                 std::sin(phase) * imaginary.at(b, x))
                                  .norm();
          error.add(still);
          error.add(turned);
        }
    check(error.largest() < 1e-12, "corners move with the bodies");

    const unsigned int tied_faces = 5 * 4 * 2 + 3 * 3;
    check(quads.size() == (12 * 2 * (3 + 1) + tied_faces) * n * n + 6,
          "faces of the surface only, cut into n x n");
    check_close(enclosed_volume(quads, 1, 2), 1.2e-5, 1e-12, "tied blocks");
    check_close(enclosed_volume(quads, 3, 3),
                std::pow(0.06 * surface.size(), 3),
                1e-12,
                "rigid body");
    const double pi = std::acos(-1.), chords = 12. * n;
    check_close(enclosed_volume(quads, 0, 0),
                0.01 * (.12 * .12 - .05 * .05) * chords / 2. *
                  std::sin(2. * pi / chords),
                // the mapping of degree 2 is on the circle at n <= 2
                n <= 2 ? 1e-12 : 1e-3,
                "disc of straight pieces that end on the circle");
    Worst largest;
    for (const auto &quad : quads)
      for (const auto &u : quad.displacements)
        largest.add(vector(u).norm());
    check_close(
      largest_displacement(quads), largest.largest(), 1e-14, "largest motion");
  }
} // namespace

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const bool                               is_root =
    dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
  const SceneParameters scene          = shape_scene();
  const auto            discretization = refined(scene, 2);
  for (const unsigned int n : {1, 2, 5})
    check_quads(*discretization, n, is_root);

  // Phase: u = a e^(i beta) with a real is largest at -beta.
  const Block  a    = unknowns(*discretization, LinearMotion(2.));
  const double beta = 0.4;
  check_close(phase_of_largest_motion(*discretization->space(),
                                      std::cos(beta) * a,
                                      std::sin(beta) * a),
              -beta,
              1e-12,
              "phase of the largest motion");
}
