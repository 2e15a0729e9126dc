// SPDX-License-Identifier: LGPL-2.1-or-later

// Frequencies of a free disc converge with order 2p; doublets do not split; a
// nearly incompressible block does not lock at p = 2.

#include "scenes.h"
#include "worst.h"

#include <deal.II/base/mpi.h>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  Eigen::VectorXd
  elastic_frequencies(const SceneParameters &scene,
                      const unsigned int     degree,
                      const unsigned int     refinements,
                      const double           highest,
                      const unsigned int     n_rigid)
  {
    const Model model(scene, degree, highest, MPI_COMM_SELF, refinements);
    const UndampedModes modes  = undamped_modes(model.pencil, model.inverse);
    const double        lowest = modes.frequency(n_rigid);
    if (n_rigid > 0)
      check_below(modes.omega_squared.head(n_rigid)
                      .cwiseAbs()
                      .maxCoeff<Eigen::PropagateNaN>() /
                    modes.omega_squared[n_rigid],
                  1e-6,
                  "six rigid motions (first frequency " + number(lowest) +
                    " Hz)");
    Eigen::VectorXd f(modes.n_certified - n_rigid);
    for (unsigned int i = 0; i < f.size(); ++i)
      f[i] = modes.frequency(n_rigid + i);
    return f;
  }

  void
  test_order()
  {
    SceneParameters scene;
    scene.bodies                 = {make_annulus({{12, 2, 1}}, .03)};
    const double          top    = 7000.;
    const Eigen::VectorXd coarse = elastic_frequencies(scene, 2, 0, top, 6),
                          fine   = elastic_frequencies(scene, 2, 1, top, 6),
                          exact  = elastic_frequencies(scene, 4, 0, top, 6);
    check(exact.size() >= 4, "several modes in the band");
    for (unsigned int i = 0; i < std::min<Eigen::Index>(6, coarse.size()); ++i)
      {
        const double e1    = coarse[i] / exact[i] - 1.,
                     e2    = fine[i] / exact[i] - 1.;
        const double order = std::log2(e1 / e2);
        check(e1 > e2 && e2 > 0. && order > 3.2 && order < 4.8,
              "free disc, mode " + std::to_string(i) + " at " +
                number(exact[i]) + " Hz: errors " + number(e1) + ", " +
                number(e2) + ", order " + number(order) + " of 4");
      }
    for (const auto &f : {coarse, fine})
      {
        Worst        worst;
        unsigned int n_doublets = 0;
        for (Eigen::Index i = 0; i + 1 < f.size(); ++i)
          if (const double split = f[i + 1] / f[i] - 1.; split < 1e-3)
            {
              worst.add(split);
              ++n_doublets;
            }
        check(n_doublets >= 2, "doublets found: " + std::to_string(n_doublets));
        check_below(
          worst.largest(), 1e-8, "doublets of the free disc do not split");
      }
  }

  /** A free block: without the singular edges of a clamp both degrees would be
   * close to the exact values, and locking would show. */
  void
  test_locking()
  {
    SceneParameters scene;
    scene.bodies = {
      make_block("pad", {{0., 0., 0.}}, {{.01, .01, .01}}, {{4, 4, 4}})};
    scene.bodies[0].young_modulus = 1e9;
    scene.bodies[0].density       = 2500.;
    std::vector<double> differences;
    for (const double nu : {.3, .49})
      {
        scene.bodies[0].poisson_ratio = nu;
        const Eigen::VectorXd f2 = elastic_frequencies(scene, 2, 0, 30e3, 6),
                              f3 = elastic_frequencies(scene, 3, 0, 30e3, 6);
        check(f3.size() >= 4 && f2.size() >= 4,
              "modes: " + std::to_string(f3.size()));
        const Eigen::Index n = std::min(f2.size(), f3.size());
        differences.push_back((f2.head(n).array() / f3.head(n).array() - 1.)
                                .abs()
                                .maxCoeff<Eigen::PropagateNaN>());
      }
    // Locking would make p = 2 far worse near incompressibility than at 0.3.
    check_below(
      differences[1], 3. * differences[0], "nu = 0.49 does not lock at p = 2");
  }
} // namespace



int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize init(argc, argv, 1);
  test_locking();
  test_order();
  return 0;
}
