// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/model/turning_modes.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace squeal
{
  namespace
  {
    /** The scene with no body turning: its terms are there with the factor
     * Omega. */
    SceneParameters
    at_rest(SceneParameters scene)
    {
      for (auto &body : scene.bodies)
        body.rotation_speed = 0.;
      return scene;
    }

    /** X^T K X with the stiffness of the bodies at rest. */
    Eigen::MatrixXd
    stiffness_at_rest(const Model &model, const Block &X)
    {
      const Pencil pencil(model.linearized().system,
                          at_rest(model.parameters().scene));
      return pencil.space()->dot(X, pencil.multiply_undamped_stiffness(X));
    }

    /** X^T C X of the gyroscopic forces, skew; X orthonormal in the mass. */
    Eigen::MatrixXd
    gyroscopic_forces(const Model &model, const Block &X)
    {
      const auto &scene  = model.parameters().scene;
      const auto &system = model.linearized().system;
      const auto  of     = [&](const SceneParameters &s) {
        const Pencil pencil(system, s);
        return pencil.space()->dot(
          X, Block(pencil.apply(ComplexBlock(X)).damping.real()));
      };
      const Eigen::MatrixXd C = of(scene) - of(at_rest(scene));
      return .5 * (C - C.transpose());
    }

    double
    largest_speed(const SceneParameters &scene)
    {
      double result = 0.;
      for (const auto &body : scene.bodies)
        result = std::max(result, std::abs(body.rotation_speed));
      return result;
    }
  } // namespace



  bool
  has_turning_body(const SceneParameters &scene)
  {
    return largest_speed(scene) > 0.;
  }



  double
  limit_of_turning_modes(const Model         &model,
                         const UndampedModes &modes,
                         const double         highest)
  {
    if (modes.shapes.cols() == 0)
      return highest * highest;
    // Of a doublet the forces are 2 c times a turn by a right angle.
    const Eigen::MatrixXd C = gyroscopic_forces(model, modes.shapes);
    const double          carried =
      .5 * std::sqrt(std::max(0.,
                              Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(
                                C.transpose() * C, Eigen::EigenvaluesOnly)
                                .eigenvalues()
                                .maxCoeff()));
    return highest * (highest + 2. * carried);
  }



  FreeMotions
  free_motions_at_rest(const Model &model, const double limit)
  {
    const Pencil        pencil(model.linearized().system,
                        at_rest(model.parameters().scene));
    const UndampedModes modes = undamped_modes(pencil, 1e-2 * limit);
    return find_free_motions(pencil, modes, limit);
  }



  std::string
  beyond_critical_speed(const Model &model, const ModeSolution &solution)
  {
    const auto  &scene = model.parameters().scene;
    const auto  &modes = solution.modes;
    const double least = 1e-9 * solution.inverse->shift();
    if (!has_turning_body(scene) || modes.omega_squared.size() == 0 ||
        modes.omega_squared[0] >= -least)
      return "";
    // K - s^2 Omega^2 N is singular at the critical share s of the speed.
    const Eigen::MatrixXd K = stiffness_at_rest(model, modes.shapes);
    // Modes that have lost their stiffness may have been combined for names.
    const Eigen::MatrixXd N =
      K - solution.pencil->space()->dot(
            modes.shapes,
            solution.pencil->multiply_undamped_stiffness(modes.shapes));
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> of_K(K);
    const double Omega = largest_speed(scene);
    // A free body's own motions, of at most (Omega/omega)^2 of elastic ones,
    // have a stiffness far below that of turning.
    Eigen::Index first = 0;
    while (first < K.rows() && of_K.eigenvalues()[first] < .1 * Omega * Omega)
      ++first;
    const Eigen::Index n = K.rows() - first;
    if (n == 0)
      return "";
    const Eigen::MatrixXd V =
      of_K.eigenvectors().rightCols(n) *
      of_K.eigenvalues().tail(n).cwiseSqrt().cwiseInverse().asDiagonal();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> of_N(
      V.transpose() * N * V, Eigen::EigenvaluesOnly);
    const double largest = of_N.eigenvalues()[n - 1];
    if (!(largest > 1.))
      return "";
    return "the bodies turn with up to " + rounded_text(Omega, 6) +
           " rad/s, beyond the critical speed of " +
           rounded_text(Omega / std::sqrt(largest), 6) +
           " rad/s: in the fixed frame waves that run against the turning are "
           "carried forwards, and what rubs on them may feed them" +
           (solution.pencil->has_structural_damping()
              ? "; loss factors have the wrong sign on them"
              : "");
  }
} // namespace squeal
