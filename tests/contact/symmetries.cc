// SPDX-License-Identifier: LGPL-2.1-or-later

// Signs of contact and friction by symmetries: the spectrum of a scene does not
// change when the whole scene is turned about any axis, when it is mirrored
// with its sliding, when a pad presses from below instead of from above, when
// pairs are renumbered, and when lengths are in other units. Dense matrices, so
// that no solver is in between.

#include "placed_scene.h"

#include <deal.II/base/mpi.h>

#include <Eigen/Eigenvalues>

#include <functional>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  /** All eigenvalues with a positive imaginary part, ascending. */
  std::vector<std::complex<double>>
  spectrum(const SceneParameters &scene, const unsigned int degree = 1)
  {
    const Discretization d(scene, {}, degree, MPI_COMM_SELF);
    const auto      system = linearized_system(d, assemble_bodies(d)).system;
    const int       n      = system.space->n_global();
    Eigen::MatrixXd M = Eigen::MatrixXd::Zero(n, n), C = M, K = M;
    const Block     unit = Block::Identity(n, n);
    for (const AffineTerm &term : system.terms)
      {
        const TermCoefficients c = term.coefficients(scene);
        if (c.is_zero())
          continue;
        const Eigen::MatrixXd A = term.matrix->multiply(unit);
        M += c.mass * A;
        C += c.damping * A;
        K += c.stiffness.real() * A;
      }
    const Eigen::LLT<Eigen::MatrixXd> mass(0.5 * (M + M.transpose()));
    check(mass.info() == Eigen::Success, "the mass is positive definite");
    Eigen::MatrixXd S = Eigen::MatrixXd::Zero(2 * n, 2 * n);
    // Of one size: velocities over a typical frequency.
    const double w = 1e5;
    S.topRightCorner(n, n).diagonal().setConstant(w);
    S.bottomLeftCorner(n, n)              = -mass.solve(K) / w;
    S.bottomRightCorner(n, n)             = -mass.solve(C);
    const Eigen::VectorXcd            all = S.eigenvalues();
    std::vector<std::complex<double>> result;
    for (const auto &lambda : all)
      if (lambda.imag() > 0.)
        result.push_back(lambda);
    std::sort(result.begin(), result.end(), [](const auto a, const auto b) {
      return a.imag() < b.imag();
    });
    return result;
  }

  unsigned int
  n_growing(const std::vector<std::complex<double>> &all)
  {
    return std::count_if(all.begin(), all.end(), [](const auto lambda) {
      return lambda.real() > 1.;
    });
  }

  /** Every eigenvalue of @p a, or the mean of those that all but coincide with
   * it, is one of @p b. */
  void
  same(const std::vector<std::complex<double>> &a,
       const std::vector<std::complex<double>> &b,
       const std::string                       &claim)
  {
    check(a.size() == b.size() && a.size() > 50, claim + ": as many");
    Worst      worst;
    const auto mean_near = [](const std::vector<std::complex<double>> &all,
                              const std::complex<double>               to) {
      std::complex<double> sum = 0.;
      unsigned int         n   = 0;
      for (const auto lambda : all)
        if (std::abs(lambda - to) < 1e-4 * std::abs(to))
          {
            sum += lambda;
            ++n;
          }
      return sum / double(n);
    };
    for (const auto lambda : a)
      worst.add(std::abs(mean_near(b, lambda) - mean_near(a, lambda)) /
                std::abs(lambda));
    std::cout << "        " << claim << ": " << worst.largest() << std::endl;
    check(worst.largest() <= 1e-9, claim);
  }

  void
  test_formulation(Options o, const std::string &name)
  {
    for (const Direction direction : {Direction::given, Direction::slip})
      {
        o.direction = direction;
        const std::string claim =
          name + (direction == Direction::slip ? ", slip" : ", given");
        const auto straight = spectrum(scene_of(o));
        check(n_growing(straight) > 0,
              claim + ": friction makes " +
                std::to_string(n_growing(straight)) + " pairs grow");
        same(straight,
             spectrum(scene_of(o, turned(.7, {1., 2., 3.}))),
             claim + ", turned about an oblique axis");
        same(straight,
             spectrum(scene_of(o, turned(M_PI / 2., {1., 0., 0.}))),
             claim + ", the target looks along -y");
        same(straight,
             spectrum(scene_of(o, turned(-M_PI / 2., {0., 1., 0.}))),
             claim + ", the target looks along -x");
        same(straight,
             spectrum(scene_of(o, turned(M_PI, {1., 0., 0.}))),
             claim + ", turned upside down");
        Options mirrored = o;
        mirrored.y       = -o.y;
        mirrored.sense   = -o.sense;
        same(straight, spectrum(scene_of(mirrored)), claim + ", mirrored in y");
        Options below = o;
        below.above   = false;
        below.below   = true;
        same(straight, spectrum(scene_of(below)), claim + ", pad below");
        Options backwards = o;
        backwards.sense   = -1.;
        backwards.mu      = -o.mu;
        same(straight,
             spectrum(scene_of(backwards)),
             claim + ", -mu against the other direction");
        Options opposite = o;
        opposite.sense   = -1.;
        const auto other = spectrum(scene_of(opposite));
        Worst      difference;
        for (std::size_t i = 0; i < std::min(other.size(), straight.size());
             ++i)
          difference.add(std::abs(other[i] - straight[i]) /
                         std::abs(straight[i]));
        check(difference.largest() > 1e-6,
              claim + ": the sense of sliding tells");
      }
  }

  /** Two pads, on two sides. */
  void
  test_two_pads(Options o, const std::string &name)
  {
    o.below             = true;
    const auto straight = spectrum(scene_of(o));
    check(n_growing(straight) > 0, name + ": two pads make a pair grow");
    Options renumbered     = o;
    renumbered.is_reversed = true;
    same(straight, spectrum(scene_of(renumbered)), name + ", renumbered");
    same(straight,
         spectrum(scene_of(o, turned(2., {-1., .5, 1.}))),
         name + ", two pads turned");
    same(straight,
         spectrum(scene_of(o, turned(M_PI, {0., 1., 0.}))),
         name + ", the pads exchanged");
    Placing millimetres;
    millimetres.factor = 1e3;
    same(straight,
         spectrum(scene_of(o, millimetres)),
         name + ", lengths in millimetres");
  }
} // namespace



int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  Options                                  grid, quadrature, mortar, nodes;
  quadrature.layout  = Layout::quadrature;
  mortar.formulation = Formulation::mortar;
  nodes.formulation  = Formulation::node_to_surface;
  for (const auto &[options, name] :
       std::vector<std::pair<Options, std::string>>{
         {grid, "springs on a grid"},
         {quadrature, "springs at quadrature points"},
         {mortar, "mortar"},
         {nodes, "node to surface"}})
    {
      test_formulation(options, name);
      test_two_pads(options, name);
    }
}
