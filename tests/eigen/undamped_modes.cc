// SPDX-License-Identifier: LGPL-2.1-or-later

// No mode is missed silently: the inertia notices hidden ones, two Lanczos
// algorithms agree, and a shift on an eigenvalue does no harm.

#include "scenes.h"

#include <squeal/base/exceptions.h>

#include <deal.II/base/mpi.h>

#include <Eigen/Eigenvalues>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  SceneParameters
  clamped_disc()
  {
    SceneParameters s;
    s.bodies   = {make_annulus({{12, 2, 1}})};
    s.supports = {make_clamp("disc", "inner")};
    return s;
  }

  double
  frequency(const double omega_squared)
  {
    return std::sqrt(omega_squared) / (2. * M_PI);
  }

  void
  check_modes(const Model         &model,
              const UndampedModes &m,
              const double         residual = 1e-6)
  {
    // The tolerance of 1e-10 is that of the inverted operator in the mass norm;
    // the residual of the stiff end of the spectrum is larger.
    check_below(m.residual.head(m.n_certified).maxCoeff<Eigen::PropagateNaN>(),
                residual,
                "residuals of the modes");
    const Eigen::MatrixXd G =
      m.shapes.transpose() * model.pencil.multiply_mass(m.shapes);
    check_below((G - Eigen::MatrixXd::Identity(G.rows(), G.cols())).norm(),
                1e-9,
                "modes are mass-orthonormal");
  }

  UndampedModes
  test_algorithms(const Model &model)
  {
    const UndampedModes lanczos = undamped_modes(model.pencil, model.inverse);
    check(lanczos.n_certified >= 12,
          "modes in the band: " + std::to_string(lanczos.n_certified));
    check_modes(model, lanczos);

    ModeOptions options;
    options.algorithm = ModeAlgorithm::arpack;
    const UndampedModes other =
      undamped_modes(model.pencil, model.inverse, options);
    check(other.n_certified == lanczos.n_certified, "as many by ARPACK");
    check_modes(model, other);
    const unsigned int n = lanczos.n_certified;
    check_below((other.omega_squared.head(n).array() /
                   lanczos.omega_squared.head(n).array() -
                 1.)
                  .abs()
                  .maxCoeff<Eigen::PropagateNaN>(),
                1e-9,
                "ARPACK and block Lanczos agree");
    return lanczos;
  }

  void
  test_hidden_mode(const Model &model, const UndampedModes &modes)
  {
    for (const unsigned int hidden : {0u, 5u, modes.n_certified - 1})
      {
        ModeOptions options;
        options.deflated = modes.shapes.col(hidden);
        check_throws<ComputationError>(
          [&] { undamped_modes(model.pencil, model.inverse, options); },
          "inertia",
          "hidden mode " + std::to_string(hidden) + " is missed by name");
      }
  }

  /** Hundreds of modes from a shift in the middle: rounding errors must not
   * grow with the number of vectors. */
  void
  test_wide_band()
  {
    SceneParameters s = clamped_disc();
    s.bodies          = {make_annulus({{24, 4, 1}})};
    const Model         model(s, 2, 9000.);
    const UndampedModes few  = undamped_modes(model.pencil, model.inverse),
                        many = undamped_modes(model.pencil,
                                              std::pow(2. * M_PI * 120e3, 2));
    check(many.n_certified > 300,
          "a wide band has " + std::to_string(many.n_certified) + " modes");
    // The lowest of them lie four decades below the limit.
    check_modes(model, many, 1e-5);
    check_below((many.omega_squared.head(few.n_certified).array() /
                   few.omega_squared.head(few.n_certified).array() -
                 1.)
                  .abs()
                  .maxCoeff<Eigen::PropagateNaN>(),
                1e-9,
                "the first of them as from a narrow band");
  }

  /** Bands that hold more and more of the 216 unknowns of a clamped block, up
   * to all of them: the modes of the dense matrices. */
  void
  test_most_unknowns()
  {
    SceneParameters s;
    BodyParameters  block;
    block.name          = "block";
    block.shape         = BodyParameters::Shape::block;
    block.size          = {{.02, .03, .1}};
    block.cells         = {{1, 1, 4}};
    block.density       = 1500.;
    block.poisson_ratio = .4;
    block.young_modulus = 1e9;
    s.bodies            = {block};
    s.supports          = {make_clamp("block", "z_min")};
    const Model narrow(s, 2, 1000.);
    const Block I = Block::Identity(216, 216);
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> dense(
      narrow.pencil.multiply_undamped_stiffness(I),
      narrow.pencil.multiply_mass(I));
    for (const double highest : {30e3, 40e3, 50e3, 60e3, 1e5})
      {
        const Model         model(s, 2, highest);
        const UndampedModes modes = undamped_modes(model.pencil, model.inverse);
        const unsigned int  n     = modes.n_certified;
        check_modes(model, modes, 1e-5);
        check(n > 90 && (highest < 1e5 || n == 216),
              "modes below " + number(highest) + ": " + number(n));
        check_below((modes.omega_squared.head(n).array() /
                       dense.eigenvalues().head(n).array() -
                     1.)
                      .abs()
                      .maxCoeff<Eigen::PropagateNaN>(),
                    1e-8,
                    "the modes of the dense matrices below " + number(highest));
      }
  }

  void
  test_shift_on_mode(const SceneParameters &scene, const UndampedModes &modes)
  {
    for (unsigned int k = 0; k < 5; ++k)
      {
        const double        f = frequency(modes.omega_squared[k + 3]);
        const Model         model(scene, 2, f);
        const UndampedModes again = undamped_modes(model.pencil, model.inverse);
        check(again.n_certified >= 2, "modes below a shift on a mode");
        check_below((again.omega_squared.head(again.n_certified).array() /
                       modes.omega_squared.head(again.n_certified).array() -
                     1.)
                      .abs()
                      .maxCoeff<Eigen::PropagateNaN>(),
                    1e-8,
                    "shift on the mode at " + number(f) + " Hz");
      }
  }

  /** A pivot that is exactly zero: two masses on springs of 1 and 4 N/m. */
  void
  test_exact_shift()
  {
    SceneParameters s;
    for (const double k : {1., 4.})
      {
        BodyParameters mass;
        mass.name  = "mass " + number(k);
        mass.shape = BodyParameters::Shape::rigid;
        mass.mass  = 1.;
        s.bodies.push_back(mass);
        SupportParameters guide;
        guide.name       = mass.name;
        guide.body       = mass.name;
        guide.kind       = SupportParameters::Kind::components;
        guide.components = {"x", "y", "rx", "ry", "rz"};
        s.supports.push_back(guide);
        SpringParameters spring;
        spring.name      = mass.name;
        spring.body      = mass.name;
        spring.stiffness = k;
        s.springs.push_back(spring);
      }
    const Discretization d(s, {}, 1, MPI_COMM_SELF);
    const auto           linearized = linearized_system(d, assemble_bodies(d));
    const Pencil         pencil(linearized.system, s);
    for (const double shift : {4., 1., 0.})
      {
        const ShiftedInverse inverse(pencil, shift);
        const UndampedModes  modes = undamped_modes(pencil, inverse);
        check(std::abs(modes.omega_squared[0] - 1.) < 1e-9 &&
                std::abs(modes.omega_squared[modes.omega_squared.size() - 1] -
                         4.) < 1e-9,
              "omega^2 = 1 and 4 with the shift at " + number(shift));
      }
  }
} // namespace



int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize init(argc, argv, 1);
  const SceneParameters                    scene = clamped_disc();
  const Model                              model(scene, 2, 9000.);
  const UndampedModes                      modes = test_algorithms(model);
  test_hidden_mode(model, modes);
  test_exact_shift();
  test_wide_band();
  test_most_unknowns();
  try
    {
      test_shift_on_mode(scene, modes);
    }
  catch (const ComputationError &e)
    {
      check(false, std::string("shift on a mode: ") + e.what());
    }
  return 0;
}
