// SPDX-License-Identifier: LGPL-2.1-or-later

// Estimated frequency errors are within a factor 3 of the true ones, whatever
// the degree, the mesh and the materials, and the same on any number of ranks.

#include "check.h"
#include "worst.h"

#include <squeal/base/mumps.h>
#include <squeal/discretization/assembly.h>
#include <squeal/discretization/eigenvalue_error.h>
#include <squeal/discretization/point_evaluator.h>

#include <deal.II/base/mpi.h>

#include <deal.II/distributed/tria.h>

#include <Eigen/Dense>

#include <algorithm>

using namespace squeal;
using squeal::testing::check;

namespace
{
  constexpr double pi = 3.14159265358979323846;

  /** Modes of free bodies are sought about omega^2 = -below_rigid. */
  const double below_rigid = std::pow(2. * pi * 1000., 2);

  struct Modes
  {
    Block           shapes;
    Eigen::VectorXd omega_squared;
  };

  /** The lowest modes by inverse iteration with a block of vectors about
   * omega^2 = -shift. */
  Modes
  lowest_modes(const Discretization &d,
               const unsigned int    n_modes,
               const double          shift   = 0.,
               const LowRankMatrix  *springs = nullptr)
  {
    const auto          bodies = assemble_bodies(d);
    Triplets            entries;
    std::vector<double> density;
    for (unsigned int b = 0; b < bodies.size(); ++b)
      {
        const auto &body = d.scene().bodies[b];
        density.push_back(body.density);
        bodies[b].stiffness->append_to(
          entries,
          body.material_model == BodyParameters::MaterialModel::isotropic
            ? body.young_modulus
            : 1.,
          true);
        bodies[b].mass->append_to(entries, shift * body.density, true);
      }
    if (springs != nullptr)
      springs->append_to(entries, 1., true);
    MumpsFactorization<double> inverse(
      d.space(), MumpsFactorization<double>::Symmetry::symmetric);
    inverse.factorize(entries.rows, entries.columns, entries.values);

    const RowSpace &space = *d.space();
    Block           X(space.n_owned(), n_modes + 12);
    for (int j = 0; j < X.cols(); ++j)
      for (int i = 0; i < X.rows(); ++i)
        X(i, j) = std::sin((space.first_owned() + i + 1.) * (0.7 * j + 1.3));
    Modes           result;
    Eigen::VectorXd last = Eigen::VectorXd::Zero(n_modes);
    for (unsigned int iteration = 0; iteration < 100; ++iteration)
      {
        Block MX = Block::Zero(X.rows(), X.cols());
        for (unsigned int b = 0; b < bodies.size(); ++b)
          MX += density[b] * bodies[b].mass->multiply(X);
        const Block     Y = inverse.solve(MX);
        Eigen::MatrixXd M = space.dot(X, MX), H = space.dot(MX, Y);
        Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> ritz(
          -0.5 * (H + H.transpose()), 0.5 * (M + M.transpose()));
        const Eigen::VectorXd values =
          -ritz.eigenvalues().head(n_modes).cwiseInverse().array() - shift;
        result = {X * ritz.eigenvectors().leftCols(n_modes), values};
        const double change =
          ((values - last).array() / (values.array() + shift))
            .abs()
            .maxCoeff<Eigen::PropagateNaN>();
        if (change < 1e-13)
          break;
        last = values;
        X    = Y * ritz.eigenvectors();
        X    = X * space.norms(X).cwiseInverse().asDiagonal();
      }
    return result;
  }



  BodyParameters
  block(const std::string                 &name,
        const Vector3                     &position,
        const Vector3                     &size,
        const std::array<unsigned int, 3> &cells)
  {
    BodyParameters result;
    result.name     = name;
    result.position = position;
    result.size     = size;
    result.cells    = cells;
    return result;
  }

  SupportParameters
  clamp(const std::string &body, const std::string &face)
  {
    SupportParameters result;
    result.name = "clamp";
    result.body = body;
    result.face = face;
    return result;
  }

  SceneParameters
  disc(const std::array<unsigned int, 3> &cells)
  {
    SceneParameters scene;
    scene.bodies.resize(1);
    scene.bodies[0].name  = "disc";
    scene.bodies[0].shape = BodyParameters::Shape::annulus;
    scene.bodies[0].cells = cells;
    scene.supports.push_back(clamp("disc", "inner"));
    return scene;
  }

  /** @p ok if both are within the factor or below 1e-6. */
  void
  check_factor(const Eigen::VectorXd &estimated,
               const Eigen::VectorXd &exact,
               const double           factor,
               const std::string     &text)
  {
    testing::Worst low, high;
    for (int j = 0; j < exact.size(); ++j)
      if (!(std::abs(exact[j]) <= 1e-6))
        {
          low.add(estimated[j] / exact[j]);
          high.add(estimated[j] / exact[j]);
        }
    check(low.smallest() > 1. / factor && high.largest() < factor,
          text + ": estimated over true error " +
            std::to_string(low.smallest()) + " to " +
            std::to_string(high.largest()));
  }



  /** The clamped disc: bending (0, 0..4), from a Fourier x p-FEM code. */
  void
  test_disc(const std::array<unsigned int, 3> &cells,
            const unsigned int                 degree,
            const unsigned int                 n_cycles)
  {
    const std::array<double, 9> reference{{1629.68,
                                           1638.31,
                                           1638.31,
                                           1839.64,
                                           1839.64,
                                           2557.49,
                                           2557.49,
                                           3853.4,
                                           3853.4}};
    const SceneParameters       scene = disc(cells);
    Discretization d(scene, DiscretizationParameters(), degree, MPI_COMM_SELF);
    double         first_error = 0.;
    for (unsigned int cycle = 0; cycle < n_cycles; ++cycle)
      {
        const Modes      modes = lowest_modes(d, reference.size());
        const ModeErrors errors =
          estimate_mode_errors(d, modes.shapes, modes.omega_squared);
        Eigen::VectorXd exact(reference.size());
        for (unsigned int j = 0; j < reference.size(); ++j)
          exact[j] =
            std::sqrt(modes.omega_squared[j]) / (2. * pi * reference[j]) - 1.;
        check_factor(errors.frequency,
                     exact,
                     2.,
                     "disc, p = " + std::to_string(degree) + ", " +
                       std::to_string(d.n_dofs()) + " dofs, largest error " +
                       std::to_string(exact.maxCoeff<Eigen::PropagateNaN>()));
        if (cycle == 0)
          first_error = exact.maxCoeff<Eigen::PropagateNaN>();
        else
          check(exact.maxCoeff<Eigen::PropagateNaN>() <
                  (cycle == 1 ? 0.75 : 0.55) * first_error,
                "refinement by the indicators lowers the largest error");
        if (cycle + 1 < n_cycles)
          d.refine(errors.cell, 0.5);
      }
  }



  /** Errors of @p d (degree 2) against degree 5 on the same mesh. */
  Eigen::VectorXd
  errors_by_high_degree(const Discretization  &d,
                        const Eigen::VectorXd &omega_squared,
                        const double           shift)
  {
    const auto            fine = d.with_degree(5);
    const Eigen::VectorXd exact =
      lowest_modes(*fine, omega_squared.size(), shift).omega_squared;
    return (omega_squared.array() / exact.array()).sqrt() - 1.;
  }

  void
  test_stiff_and_soft_blocks()
  {
    SceneParameters scene;
    scene.bodies = {
      block("pad", {{0., 0., 0.}}, {{.01, .01, .01}}, {{2, 2, 2}}),
      block("support", {{0., 0., .01}}, {{.01, .01, .05}}, {{2, 2, 4}})};
    scene.bodies[0].young_modulus = 1e10;
    scene.bodies[0].density       = 2500.;
    scene.bodies[1].young_modulus = 1.67e12;
    scene.bodies[1].density       = 6.86e4;
    scene.ties.resize(1);
    auto &tie       = scene.ties[0];
    tie.source_body = "pad";
    tie.source_face = "z_max";
    tie.target_body = "support";
    tie.target_face = "z_min";
    scene.supports.push_back(clamp("pad", "z_min"));
    const Discretization d(scene, DiscretizationParameters(), 2, MPI_COMM_SELF);
    const Modes          modes = lowest_modes(d, 8);
    const ModeErrors     errors =
      estimate_mode_errors(d, modes.shapes, modes.omega_squared);
    check_factor(errors.frequency,
                 errors_by_high_degree(d, modes.omega_squared, 0.),
                 3.,
                 "soft pad tied to a stiff, heavy block");
  }

  void
  test_free_orthotropic_block()
  {
    SceneParameters scene;
    scene.bodies = {
      block("plate", {{0., 0., 0.}}, {{.1, .06, .01}}, {{4, 3, 1}})};
    auto &body          = scene.bodies[0];
    body.material_model = BodyParameters::MaterialModel::orthotropic;
    body.young_moduli   = {{130e9, 10e9, 10e9}};
    body.shear_moduli   = {{3.5e9, 5e9, 5e9}};
    body.poisson_ratios = {{0.4, 0.3, 0.3}};
    body.density        = 1600.;
    const Discretization d(scene, DiscretizationParameters(), 2, MPI_COMM_SELF);
    const Modes          modes = lowest_modes(d, 14, below_rigid);
    const ModeErrors     errors =
      estimate_mode_errors(d, modes.shapes, modes.omega_squared);
    check(errors.frequency.head(6).cwiseAbs().maxCoeff<Eigen::PropagateNaN>() ==
            0.,
          "rigid-body modes have no error");
    check_factor(
      errors.frequency.tail(8),
      errors_by_high_degree(d, modes.omega_squared, below_rigid).tail(8),
      3.,
      "free orthotropic plate");
  }



  /** A block on a bed of n x n point springs at its bottom. */
  struct SprungBlock
  {
    SprungBlock(const unsigned int n)
    {
      scene.bodies = {
        block("block", {{0., 0., 0.}}, {{.04, .04, .02}}, {{2, 2, 1}})};
      set.spacing = n > 1 ? 0.01 / (n - 1) : 1e300;
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = 0; j < n; ++j)
          set.points.emplace_back(n > 1 ? -.005 + i * set.spacing : .007,
                                  n > 1 ? -.005 + j * set.spacing : .004,
                                  0.);
    }

    Modes
    solve(const Discretization &d, const unsigned int n_modes)
    {
      const auto found = PointEvaluator(d).displacements(0, set.points);
      std::vector<Functionals::Row> rows;
      for (const auto &three : found.rows)
        rows.insert(rows.end(), three.begin(), three.end());
      const auto functionals =
        std::make_shared<const Functionals>(d.space(), rows);
      const Eigen::VectorXd stiffness =
        Eigen::VectorXd::Constant(rows.size(), 3e9 / set.points.size());
      const LowRankMatrix springs(functionals, stiffness, functionals);
      const Modes modes = lowest_modes(d, n_modes, below_rigid, &springs);
      set.forces =
        stiffness.asDiagonal() * functionals->apply(Block(-modes.shapes));
      return modes;
    }

    SceneParameters scene;
    PointForces     set;
  };

  void
  test_springs()
  {
    SprungBlock          bed(11);
    const Discretization d(
      bed.scene, DiscretizationParameters(), 2, MPI_COMM_SELF);
    const Modes modes = bed.solve(d, 8);
    const auto  with =
      estimate_mode_errors(d, modes.shapes, modes.omega_squared, {bed.set});
    // A finer mesh, as springs close to each other act like a bed.
    DiscretizationParameters finer;
    finer.refinements = 2;
    const Discretization  fine(bed.scene, finer, 3, MPI_COMM_SELF);
    const Eigen::VectorXd exact =
      (modes.omega_squared.array() / bed.solve(fine, 8).omega_squared.array())
        .sqrt() -
      1.;
    check_factor(with.frequency, exact, 3., "block on a bed of springs");

    const auto without =
      estimate_mode_errors(d, modes.shapes, modes.omega_squared);
    check((without.frequency.array() / exact.array())
              .minCoeff<Eigen::PropagateNaN>() < 1. / 3.,
          "with the springs left out the estimate is not within a factor 3: " +
            std::to_string((without.frequency.array() / exact.array())
                             .minCoeff<Eigen::PropagateNaN>()));

    SprungBlock          lone(1);
    const Discretization e(
      lone.scene, DiscretizationParameters(), 2, MPI_COMM_SELF);
    const Modes tethered = lone.solve(e, 8);
    const auto  errors   = estimate_mode_errors(
      e, tethered.shapes, tethered.omega_squared, {lone.set});
    check(errors.at_points.minCoeff<Eigen::PropagateNaN>() >= 0. &&
            errors.at_points.maxCoeff<Eigen::PropagateNaN>() > 0.,
          "the error at a lone point spring is reported apart");
    unsigned int n_left_out = 0;
    for (const double c : errors.cell)
      n_left_out += c == 0. ? 1 : 0;
    check(n_left_out == 1, "a lone point spring drives no refinement");
  }



  /** Two ranks against one, with a hanging mesh between them. */
  void
  test_ranks()
  {
    const SceneParameters scene = disc({{16, 3, 1}});
    Discretization d(scene, DiscretizationParameters(), 2, MPI_COMM_WORLD);
    Discretization alone(scene, DiscretizationParameters(), 2, MPI_COMM_SELF);
    for (unsigned int cycle = 0; cycle < 3; ++cycle)
      {
        const Modes a = lowest_modes(d, 9), b = lowest_modes(alone, 9);
        const auto  here = estimate_mode_errors(d, a.shapes, a.omega_squared);
        const auto  there =
          estimate_mode_errors(alone, b.shapes, b.omega_squared);
        // Doublets may be turned: only their sum is the same.
        const Eigen::VectorXd difference = here.frequency - there.frequency;
        testing::Worst        worst;
        worst.add(std::abs(difference[0]));
        for (unsigned int j = 1; j < 9; j += 2)
          worst.add(std::abs(difference[j] + difference[j + 1]));
        check(worst.largest() <
                1e-6 * there.frequency.maxCoeff<Eigen::PropagateNaN>(),
              "two ranks estimate as one does");
        // Not every cell of a ring of equal ones need be above the threshold:
        // marks by radius are the same for all ranks.
        std::vector<double> marks(d.triangulation().n_active_cells(), 0.),
          marks_alone(alone.triangulation().n_active_cells(), 0.);
        for (const auto &[disc, m] :
             {std::make_pair(&d, &marks), std::make_pair(&alone, &marks_alone)})
          for (const auto &cell : disc->dof_handler().active_cell_iterators())
            if (cell->is_locally_owned())
              (*m)[cell->active_cell_index()] =
                cell->center()[0] > 0. &&
                    std::hypot(cell->center()[0], cell->center()[1]) < 0.07
                  ? 1.
                  : 1e-6;
        d.refine(marks, 0.99);
        alone.refine(marks_alone, 0.99);
      }
  }
} // namespace



int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize init(argc, argv, 1);
  if (dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) > 1)
    {
      test_ranks();
      return 0;
    }
  test_disc({{24, 4, 1}}, 2, 3);
  test_disc({{16, 4, 1}}, 3, 3);
  test_disc({{12, 3, 1}}, 4, 2);
  test_stiff_and_soft_blocks();
  test_free_orthotropic_block();
  test_springs();
  return 0;
}
