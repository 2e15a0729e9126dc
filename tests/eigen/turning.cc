// SPDX-License-Identifier: LGPL-2.1-or-later

// Turning bodies in the fixed frame: the in-plane doublets of a thin ring
// against Bryan (1890), the bending doublets of a disc against the frame that
// turns with it, where Coriolis and centrifugal forces take the place of the
// convective terms.

#include "scenes.h"
#include "worst.h"

#include <squeal/discretization/centrifugal_stress.h>

#include <deal.II/base/mpi.h>

#include <Eigen/Eigenvalues>

#include <algorithm>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  using Complex = std::complex<double>;

  /** Frequencies in rad/s, ascending, each once. */
  std::vector<double>
  turning_frequencies(const SceneParameters &scene,
                      const unsigned int     degree,
                      const double           lowest,
                      const double           highest)
  {
    Model               model(scene, degree, highest);
    const ComplexPairs  pairs = model.solve(band(lowest, highest));
    std::vector<double> result;
    for (const Complex lambda : pairs.lambda)
      {
        check_below(std::abs(lambda.real()),
                    1e-7 * std::abs(lambda),
                    "turning alone does not damp");
        result.push_back(lambda.imag());
      }
    return result;
  }

  /** Thin ring, m nodal diameters: in the fixed frame omega_m
   * +- m Omega (m^2 - 1) / (m^2 + 1), inextensional. */
  void
  test_ring()
  {
    SceneParameters s;
    s.bodies                   = {make_annulus({{48, 1, 1}}, .006)};
    s.bodies[0].inner_radius   = .099;
    s.bodies[0].outer_radius   = .101;
    const double speed         = 10.;
    const auto   rest          = turning_frequencies(s, 3, 60., 450.);
    s.bodies[0].rotation_speed = speed;
    const auto   turning       = turning_frequencies(s, 3, 60., 450.);
    unsigned int n_found       = 0;
    for (const int m : {2, 3})
      {
        // omega_m^2 = (E h^2 / 12 rho R^4) m^2 (m^2 - 1)^2 / (m^2 + 1)
        const double omega = std::sqrt(210e9 / 7800. / 12.) * .002 / .01 * m *
                             (m * m - 1.) / std::sqrt(m * m + 1.);
        const double shift   = m * speed * (m * m - 1.) / (m * m + 1.);
        const auto   nearest = [](const std::vector<double> &all, double w) {
          return *std::min_element(
            all.begin(), all.end(), [w](double a, double b) {
              return std::abs(a - w) < std::abs(b - w);
            });
        };
        const double still = nearest(rest, omega);
        check_close(
          still, omega, 3e-3, "ring at rest, m = " + std::to_string(m));
        const double up   = nearest(turning, still + shift),
                     down = nearest(turning, still - shift);
        // (h/R)^2 = 4e-4 of extension and shear, (Omega/omega)^2 = 2e-4
        check_close(.5 * (up - down),
                    shift,
                    1e-3,
                    "Bryan's split, m = " + std::to_string(m));
        ++n_found;
      }
    check(n_found == 2, "both doublets");
  }



  /** Frequencies in the turning frame: M u'' + 2 Omega M (e_z x u') -
   * Omega^2 M u_xy + (K + Omega^2 S) u = 0 with the stiffness of the
   * centrifugal stress, projected on modes and their responses to the Coriolis
   * forces. */
  std::vector<double>
  corotating_frequencies(const SceneParameters &scene,
                         const unsigned int     degree,
                         const double           highest,
                         const double           speed)
  {
    const Model         model(scene, degree, highest);
    const UndampedModes modes = undamped_modes(model.pencil, model.inverse);
    const TurningAxes   axes  = turning_axes(model.discretization, 0);
    const double        rho   = scene.bodies[0].density;
    Block               V(modes.shapes.rows(), 2 * modes.shapes.cols());
    V << modes.shapes,
      model.inverse.solve(Block(rho * axes.coriolis->multiply(modes.shapes)));
    for (int pass = 0; pass < 2; ++pass)
      for (Eigen::Index j = 0; j < V.cols(); ++j)
        {
          if (j > 0)
            {
              const Block Mj = model.pencil.multiply_mass(Block(V.col(j)));
              const Eigen::VectorXd c = V.leftCols(j).transpose() * Mj;
              V.col(j) -= V.leftCols(j) * c;
            }
          V.col(j) /= std::sqrt(
            V.col(j).dot(model.pencil.multiply_mass(Block(V.col(j))).col(0)));
        }
    const Eigen::MatrixXd
      K = V.transpose() * model.pencil.multiply_undamped_stiffness(V),
      G = rho * V.transpose() * axes.coriolis->multiply(V),
      N = rho * V.transpose() *
          (axes.centrifugal->multiply(V) -
           centrifugal_stress_stiffness(model.discretization, 0)->multiply(V));
    check_below((G + G.transpose()).norm(),
                1e-12 * G.norm(),
                "Coriolis forces do no work");
    const Eigen::Index n = V.cols();
    Eigen::MatrixXd    A = Eigen::MatrixXd::Zero(2 * n, 2 * n);
    A.topRightCorner(n, n).setIdentity();
    A.bottomLeftCorner(n, n)      = -(K - speed * speed * N);
    A.bottomRightCorner(n, n)     = -2. * speed * G;
    const Eigen::VectorXcd lambda = A.eigenvalues();
    std::vector<double>    result;
    for (const Complex l : lambda)
      if (l.imag() > 0. && l.imag() < 2. * M_PI * highest)
        result.push_back(l.imag());
    std::sort(result.begin(), result.end());
    return result;
  }

  void
  test_disc()
  {
    SceneParameters s;
    s.bodies                   = {make_annulus({{24, 3, 1}})};
    s.supports                 = {make_clamp("disc", "inner")};
    const double speed         = 100.;
    const auto   inside        = corotating_frequencies(s, 3, 3400., speed);
    s.bodies[0].rotation_speed = speed;
    const auto fixed           = turning_frequencies(s, 3, 1000., 3400.);
    check(inside.size() >= 7 && fixed.size() >= 7, "(0,0) to (0,3)");
    const auto nearest = [&fixed](const double w) {
      Worst best;
      for (const double f : fixed)
        best.add(std::abs(f / w - 1.));
      return best.smallest();
    };
    check_below(nearest(inside[0]), 1e-6, "(0,0) is the same in both frames");
    for (const int m : {1, 2, 3})
      {
        const double a = inside[2 * m - 1], b = inside[2 * m], c = m * speed;
        // the one of the two that runs forwards gains m Omega
        check_below(std::min(std::max(nearest(a + c), nearest(b - c)),
                             std::max(nearest(a - c), nearest(b + c))),
                    1e-6,
                    "(0," + std::to_string(m) +
                      ") of the turning disc, split in its own frame " +
                      number(b / a - 1.));
      }
  }

  /** A plate that is clamped at its bore and turns with @p speed, rad/s; its
   * damping has the stiffness damping @p beta, s. */
  SceneParameters
  turning_plate(const double speed, const double beta)
  {
    SceneParameters s;
    s.bodies                    = {make_annulus({{24, 2, 1}}, .002)};
    s.bodies[0].inner_radius    = .04;
    s.bodies[0].outer_radius    = .14;
    s.bodies[0].rotation_speed  = speed;
    s.supports                  = {make_clamp("disc", "inner")};
    s.damping.model             = DampingParameters::Model::whole_model;
    s.damping.stiffness_damping = beta;
    return s;
  }

  /** The material is damped by the rate of strain that it sees: every wave
   * decays as in the frame of the disc, with beta times the elastic share of
   * its stiffness over 2, whichever way it runs and whatever the speed. */
  void
  test_material_damping()
  {
    const double beta     = 1e-5;
    const auto   pairs_at = [beta](const double speed, const double highest) {
      Model model(turning_plate(speed, beta), 2, highest);
      return model.solve(band(5., highest));
    };
    // What comes down into the band is higher at rest.
    const ComplexPairs still = pairs_at(0., 3000.);
    for (const double speed : {100., 300., 900.})
      {
        const ComplexPairs pairs = pairs_at(speed, 400.);
        check(pairs.size() >= 4, "waves of a turning plate");
        for (const Complex lambda : pairs.lambda)
          {
            Worst off;
            for (const Complex rest : still.lambda)
              off.add(std::abs(lambda.real() / rest.real() - 1.));
            // The stress of the turning changes the shapes a little.
            check_below(off.smallest(),
                        speed < 500. ? 1e-2 : 5e-2,
                        "decay of " + number(lambda.imag() / (2. * M_PI)) +
                          " Hz, " + number(lambda.real()) + " 1/s at " +
                          number(speed) + " rad/s is one at rest");
          }
      }
  }

  /** What nothing holds has no stiffness while it turns, and nothing grows. */
  void
  test_free_ring()
  {
    SceneParameters s;
    s.bodies                   = {make_annulus({{24, 1, 1}}, .006)};
    s.bodies[0].inner_radius   = .099;
    s.bodies[0].outer_radius   = .101;
    s.bodies[0].rotation_speed = 300.;
    const Model         model(s, 3, 200.);
    const UndampedModes modes = undamped_modes(model.pencil, model.inverse);
    check(modes.omega_squared.size() >= 6, "the motions of a free ring");
    for (int i = 0; i < 6; ++i)
      check_below(std::abs(modes.omega_squared[i]),
                  1e-5 * 300. * 300.,
                  "stiffness of a free motion of a turning ring");
  }

  /** A layer turns with what it lies on: a ring whose outer half is a layer is
   * the same ring. */
  void
  test_layer()
  {
    SceneParameters whole;
    whole.bodies                   = {make_annulus({{24, 2, 1}}, .006)};
    whole.bodies[0].inner_radius   = .098;
    whole.bodies[0].outer_radius   = .102;
    whole.bodies[0].rotation_speed = 10.;
    SceneParameters coated         = whole;
    coated.bodies[0].outer_radius  = .1;
    coated.bodies[0].cells         = {{24, 1, 1}};
    BodyParameters layer           = whole.bodies[0];
    layer.name                     = "coat";
    layer.shape                    = BodyParameters::Shape::layer;
    layer.layer_body               = coated.bodies[0].name;
    layer.layer_face               = "outer";
    layer.thickness                = .002;
    layer.rotation_speed           = 0.;
    coated.bodies.push_back(layer);
    const auto one = turning_frequencies(whole, 2, 100., 900.),
               two = turning_frequencies(coated, 2, 100., 900.);
    check(one.size() >= 4 && two.size() == one.size(), "as many modes");
    for (std::size_t i = 0; i < one.size(); ++i)
      // The stress of the turning is that of each body alone.
      check_close(two[i], one[i], 1e-6, "frequency of a layered ring");
  }

  /** A lumped mass turns with the angle of its body. */
  void
  test_turned_mass()
  {
    SceneParameters s;
    BodyParameters  block;
    block.name          = "block";
    block.shape         = BodyParameters::Shape::block;
    block.size          = {{.04, .02, .01}};
    block.cells         = {{2, 2, 1}};
    block.rotation_axis = {{0., 0., 1.}};
    s.bodies            = {block};
    LumpedMassParameters mass;
    mass.name        = "weight";
    mass.body        = "block";
    mass.point       = {{.02, .01, .01}};
    mass.mass        = .05;
    s.lumped_masses  = {mass};
    s.supports       = {make_clamp("block", "x_min")};
    const auto still = turning_frequencies(s, 2, 100., 60e3);
    for (const double angle : {30., 90., 200.})
      {
        s.bodies[0].angle = angle;
        const auto turned = turning_frequencies(s, 2, 100., 60e3);
        check(turned.size() == still.size() && still.size() > 3,
              "as many modes at an angle");
        for (std::size_t i = 0; i < still.size(); ++i)
          check_close(turned[i],
                      still[i],
                      1e-8,
                      "frequency of a block with a weight at an angle");
      }
  }
} // namespace



int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize init(argc, argv, 1);
  test_ring();
  test_disc();
  test_material_damping();
  test_free_ring();
  test_layer();
  test_turned_mass();
}
