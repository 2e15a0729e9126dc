// SPDX-License-Identifier: LGPL-2.1-or-later

// A lumped mass belongs to the body that carries it: the shares of the kinetic
// energy are those of the whole mass matrix, in real and complex shapes, and
// two equal masses hold half of it each, however one of them is made up.

#include "scenes.h"
#include "worst.h"

#include <squeal/base/timers.h>
#include <squeal/discretization/point_evaluator.h>
#include <squeal/model/model.h>

#include <deal.II/base/mpi.h>

#include <random>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  LumpedMassParameters
  make_lumped_mass(const std::string &body,
                   const Vector3     &point,
                   const double       mass)
  {
    LumpedMassParameters lumped;
    lumped.name  = "on " + body;
    lumped.body  = body;
    lumped.point = point;
    lumped.mass  = mass;
    return lumped;
  }

  /** A rigid body of @p mass that moves along z only. */
  void
  add_carriage(const std::string &name, const double mass, SceneParameters &s)
  {
    BodyParameters body;
    body.name  = name;
    body.shape = BodyParameters::Shape::rigid;
    body.mass  = mass;
    s.bodies.push_back(body);
    SupportParameters guide;
    guide.name       = "guide of " + name;
    guide.body       = name;
    guide.kind       = SupportParameters::Kind::components;
    guide.components = {"x", "y", "rx", "ry", "rz"};
    s.supports.push_back(guide);
  }

  void
  test_two_masses()
  {
    // 1 kg and 0.1 + 0.9 kg that swing against or with each other
    Parameters p;
    add_carriage("whole", 1., p.scene);
    add_carriage("made up", 0.1, p.scene);
    p.scene.lumped_masses = {make_lumped_mass("made up", {{0., 0., 0.}}, 0.9)};
    Timers              timers;
    const squeal::Model model(p, timers);
    check(model.n_unknowns() == 2, "two unknowns");
    Block real(2, 2);
    real << 1., 1., 1., -1.;
    // the second one moves by 0.6 + 0.8 i, of modulus 1
    ComplexBlock complex(2, 1);
    complex << 1., std::complex<double>(0.6, 0.8);
    Worst half;
    for (const Eigen::MatrixXd &shares :
         {model.energy_shares(real), model.energy_shares(complex)})
      half.add(
        largest_abs(shares - Eigen::MatrixXd::Constant(2, shares.cols(), 0.5)));
    check_within(half, 1e-14, "two masses of 1 kg hold half of the energy");

    // by an imaginary part alone: the share of a real shape
    ComplexBlock turned(2, 1);
    turned << std::complex<double>(0., 2.), std::complex<double>(0., 1.);
    check_close(model.energy_shares(turned)(0, 0),
                0.8,
                1e-14,
                "the phase of a shape does not matter");
  }

  void
  test_meshed_brake()
  {
    // pad tied to a support: shapes expand to more unknowns than are solved
    Parameters p;
    p.scene               = coarse_brake(0.4);
    const Vector3 on_pad  = {{.109, .002, .004}};
    const Vector3 on_disc = {{.07, .01, -.002}};
    p.scene.lumped_masses = {make_lumped_mass("pad", on_pad, 0.02),
                             make_lumped_mass("disc", on_disc, 0.5)};
    Timers              timers;
    const squeal::Model model(p, timers);
    const Pencil        pencil(model.linearized().system, p.scene);
    const unsigned int  n = model.n_unknowns();

    std::mt19937                     random(3);
    std::normal_distribution<double> normal;
    const ComplexBlock shapes = ComplexBlock::NullaryExpr(n, 4, [&]() {
      return std::complex<double>(normal(random), normal(random));
    });
    const Block        real = shapes.real(), imaginary = shapes.imag();

    const auto energy = [](const Block &x, const Block &Mx) {
      return Eigen::RowVectorXd(x.cwiseProduct(Mx).colwise().sum());
    };
    const auto expanded = [&](const Block &x) {
      return model.linearized().expand(x);
    };
    const PointEvaluator evaluator(*model.discretization());
    // of one body: its mass matrix and the speed of the point on it
    const auto energy_of = [&](const unsigned int b, const Block &x) {
      const Block        full = expanded(x);
      Eigen::RowVectorXd result =
        p.scene.bodies[b].density *
        energy(full, model.body_matrices()[b].mass->multiply(full));
      for (const auto &lumped : p.scene.lumped_masses)
        if (lumped.body == p.scene.bodies[b].name)
          {
            const auto u = evaluator
                             .displacements(b,
                                            {dealii::Point<3>(lumped.point[0],
                                                              lumped.point[1],
                                                              lumped.point[2])})
                             .rows[0];
            const Functionals motion(model.discretization()->space(),
                                     {u[0], u[1], u[2]});
            result += lumped.mass * motion.apply(full).colwise().squaredNorm();
          }
      return result;
    };

    const Eigen::MatrixXd    of_real    = model.energy_shares(real);
    const Eigen::MatrixXd    of_complex = model.energy_shares(shapes);
    const Eigen::RowVectorXd total_real =
      energy(real, pencil.multiply_mass(real));
    const Eigen::RowVectorXd total_complex =
      total_real + energy(imaginary, pencil.multiply_mass(imaginary));
    Worst error;
    for (unsigned int b = 0; b < 3; ++b)
      {
        const Eigen::RowVectorXd e  = energy_of(b, real);
        const Eigen::RowVectorXd ei = energy_of(b, imaginary);
        for (Eigen::Index j = 0; j < 4; ++j)
          {
            error.add(std::abs(of_real(b, j) - e[j] / total_real[j]),
                      "real shape of " + p.scene.bodies[b].name);
            error.add(
              std::abs(of_complex(b, j) - (e[j] + ei[j]) / total_complex[j]),
              "complex shape of " + p.scene.bodies[b].name);
          }
      }
    check_within(error, 1e-12, "shares are those of the whole mass matrix");
    for (const Eigen::MatrixXd &shares : {of_real, of_complex})
      check_below(
        largest_abs(shares.colwise().sum() - Eigen::RowVectorXd::Ones(4)),
        1e-14,
        "they add up to 1");

    // what sweeps keep: one form for each body and each lumped mass
    const auto      forms = model.energy_forms(real);
    Eigen::MatrixXd sum   = Eigen::MatrixXd::Zero(4, 4);
    for (std::size_t i = 0; i < forms.size(); ++i)
      sum += model.inertia()[i].term.coefficients(p.scene).mass * forms[i];
    check(forms.size() == 5 &&
            (sum - real.transpose() * pencil.multiply_mass(real)).norm() <
              1e-12 * sum.norm(),
          "the forms on a basis make up the whole mass matrix");
  }
} // namespace

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test_two_masses();
  test_meshed_brake();
}
