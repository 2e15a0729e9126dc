// SPDX-License-Identifier: LGPL-2.1-or-later

// `Angle` turns the centre of gravity and the inertia of a rigid body: on two
// springs it has the frequencies of the turned tensor, a hub of a disc those of
// one that is described where it has turned to, and a hub that is not round is
// told of as a rotor that stands still at one angle.

#include "scenes.h"
#include "worst.h"

#include <squeal/base/run_log.h>
#include <squeal/base/timers.h>
#include <squeal/model/cea_solution.h>
#include <squeal/model/rotor_symmetry.h>

#include <deal.II/base/mpi.h>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  BodyParameters
  make_rigid(const std::string &name,
             const Vector3     &position,
             const Vector3     &inertia)
  {
    BodyParameters body;
    body.name            = name;
    body.shape           = BodyParameters::Shape::rigid;
    body.position        = position;
    body.inertia         = inertia;
    body.rotation_centre = Vector3{{0., 0., 0.}};
    return body;
  }

  /** Squares of the angular frequencies, 1/s^2, ascending. */
  std::vector<double>
  squares_of(const SceneParameters &scene)
  {
    Parameters p;
    p.scene                         = scene;
    p.discretization.degree         = 1;
    p.discretization.estimate_error = false;
    p.eigen.highest_frequency       = 3000.;
    Timers              timers;
    RunLog              log(false);
    const squeal::Model model(p, timers);
    const auto squares = solve_modes(model, log, timers).modes.omega_squared;
    return {squares.begin(), squares.end()};
  }

  void
  check_same(const std::vector<double> &found,
             const std::vector<double> &expected,
             const std::string         &claim)
  {
    check(found.size() == expected.size() && !found.empty(),
          claim + ": " + std::to_string(found.size()) + " modes");
    for (std::size_t i = 0; i < found.size(); ++i)
      check_close(found[i], expected[i], 1e-9, claim);
  }

  /** A body that tilts about x and y alone, at all angles. */
  void
  on_two_springs(const double degrees)
  {
    const double                 arm = .03;
    const std::array<double, 3>  J{{1e-3, 3e-3, 2e-3}};
    const std::array<Vector3, 2> points{{{{.05, .02, 0.}}, {{-.01, .04, 0.}}}};
    const std::array<double, 2>  k{{1e6, 3e6}};
    SceneParameters              scene;
    scene.bodies          = {make_rigid("mass", {{arm, 0., 0.}}, J)};
    scene.bodies[0].angle = degrees;
    SupportParameters guide;
    guide.name          = "guide";
    guide.body          = "mass";
    guide.kind          = SupportParameters::Kind::components;
    guide.components    = {"x", "y", "z", "rz"};
    scene.supports      = {guide};
    const double    phi = degrees * M_PI / 180.;
    Eigen::Matrix2d R   = Eigen::Rotation2Dd(phi).toRotationMatrix(), K;
    K.setZero();
    for (unsigned int i = 0; i < 2; ++i)
      {
        SpringParameters spring;
        spring.name        = "spring " + std::to_string(i);
        spring.body        = "mass";
        spring.first_point = spring.last_point = points[i];
        spring.stiffness                       = k[i];
        scene.springs.push_back(spring);
        const Eigen::Vector2d tilt(points[i][1] - arm * std::sin(phi),
                                   arm * std::cos(phi) - points[i][0]);
        K += k[i] * tilt * tilt.transpose();
      }
    const Eigen::Matrix2d M =
      R * Eigen::Vector2d(J[0], J[1]).asDiagonal() * R.transpose();
    const Eigen::VectorXd expected =
      Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::Matrix2d>(K, M)
        .eigenvalues();
    check_same(squares_of(scene),
               {expected.begin(), expected.end()},
               "tensor at " + std::to_string(degrees) + " deg");
  }



  SceneParameters
  disc_on_hub(const BodyParameters &hub)
  {
    SceneParameters scene;
    scene.bodies = {make_annulus({{8, 1, 1}}), hub};
    scene.ties   = {make_tie("disc", "inner", "hub", "")};
    SpringParameters bed;
    bed.name        = "bed";
    bed.kind        = SpringParameters::Kind::area;
    bed.body        = "disc";
    bed.face        = "bottom";
    bed.stiffnesses = {{1e9, 3e9, 2e9}};
    scene.springs   = {bed};
    return scene;
  }

  void
  hub_of_a_disc()
  {
    BodyParameters hub =
      make_rigid("hub", {{.03, 0., .005}}, {{1e-4, 2e-3, 3e-3}});
    const auto at_rest = squares_of(disc_on_hub(hub));
    hub.angle          = 90.;
    const auto turned  = squares_of(disc_on_hub(hub));
    check_same(turned,
               squares_of(disc_on_hub(
                 make_rigid("hub", {{0., .03, .005}}, {{2e-3, 1e-4, 3e-3}}))),
               "as described at 90 deg");
    check(std::abs(turned[0] / at_rest[0] - 1.) > 1e-3,
          "which is not as at 0 deg");
  }



  /** What is said of the rotor of a brake whose disc sits on @p hub. */
  std::string
  said_of(const BodyParameters &hub)
  {
    SceneParameters scene = coarse_brake(.3);
    scene.supports.clear();
    scene.bodies.push_back(hub);
    scene.ties.push_back(make_tie("disc", "inner", "hub", ""));
    return frozen_rotors(Discretization(
      scene, squeal::testing::Model::parameters(0), 1, MPI_COMM_SELF));
  }

  void
  rotors()
  {
    const auto has = [](const std::string &text, const std::string &part) {
      return text.find(part) != std::string::npos;
    };
    const Vector3     on_axis = {{0., 0., -.03}}, round = {{1e-3, 1e-3, 5e-4}};
    const std::string none = said_of(make_rigid("hub", on_axis, round));
    check(none.empty(), "a round hub on the axis: " + none);
    const std::string eccentric =
      said_of(make_rigid("hub", {{.02, 0., 0.}}, round));
    check(has(eccentric, "every 360"), "beside the axis: " + eccentric);
    const std::string flat =
      said_of(make_rigid("hub", on_axis, {{1e-3, 3e-3, 4e-3}}));
    check(has(flat, "every 180"), "with two inertias across: " + flat);
    BodyParameters tilted  = make_rigid("hub", on_axis, round);
    tilted.rotation_axis   = {{1., 0., 0.}};
    tilted.angle           = 30.;
    tilted.rotation_centre = on_axis;
    check(has(said_of(tilted), "every 360"), "tilted: " + said_of(tilted));
  }
} // namespace



int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize init(argc, argv, 1);
  for (const double degrees : {0., 37., 90., -200.})
    on_two_springs(degrees);
  hub_of_a_disc();
  rotors();
}
