// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/transient/steady_sliding.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace squeal
{
  namespace
  {
    /** Stiffness that stands in for that of rigid motions while they are
     * solved for; what it holds goes back into the load. */
    constexpr double auxiliary_frequency = 3.; // Hz
  }                                            // namespace

  unsigned int
  SteadySliding::n_closed() const
  {
    return std::count_if(status.begin(), status.end(), [](const auto s) {
      return s != ContactStatus::open;
    });
  }

  Eigen::Vector3d
  SteadySliding::resultant() const
  {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (Eigen::Index i = 0; i < forces.size(); i += 3)
      sum += forces.segment<3>(i);
    return sum;
  }



  SteadySliding
  steady_sliding(const ReducedContactModel &model,
                 const double               friction,
                 const double               load_factor)
  {
    const double    auxiliary = std::pow(2. * M_PI * auxiliary_frequency, 2);
    Eigen::VectorXd held      = Eigen::VectorXd::Zero(model.n_modes());
    Eigen::VectorXd compliance(model.n_modes());
    for (unsigned int k = 0; k < model.n_modes(); ++k)
      {
        if (model.omega_squared[k] == 0.)
          held[k] = auxiliary;
        compliance[k] = 1. / (model.omega_squared[k] + held[k]);
      }
    const Eigen::MatrixXd &Psi = model.participation;
    const Eigen::MatrixXd  W =
      Psi * compliance.asDiagonal() * Psi.transpose() + model.flexibility;

    // The target slides so far that the slip has its direction.
    ContactStep step;
    step.previous_motion = Eigen::VectorXd::Zero(Psi.rows());
    step.duration        = 1e6;
    step.friction        = friction;
    step.speed           = 1.;
    // The size of forces: that of the load on the rigid motions or, held
    // bodies, of what would close the gap.
    const Eigen::VectorXd load_motion =
      Psi * compliance.cwiseProduct(model.load) + model.load_motion;
    double approach = 0., flexibility = 0.;
    for (unsigned int j = 0; j < model.n_nodes(); ++j)
      {
        approach = std::max(approach, load_factor * load_motion[3 * j]);
        for (unsigned int i = 0; i < model.n_nodes(); ++i)
          flexibility = std::max(flexibility, std::abs(W(3 * j, 3 * i)));
      }
    const double force =
      std::max(approach / flexibility, 1e-12) / model.n_nodes();
    ContactSolver solver(W, model.initial_gap, model.speed_ratio, force, 1e-10);

    SteadySliding result;
    result.forces           = Eigen::VectorXd::Zero(Psi.rows());
    result.coordinates      = Eigen::VectorXd::Zero(model.n_modes());
    const Eigen::VectorXd f = load_factor * model.load;
    for (unsigned int i = 0;; ++i)
      {
        const Eigen::VectorXd q_free =
          compliance.cwiseProduct(f + held.cwiseProduct(result.coordinates));
        step.free_motion = Psi * q_free + load_factor * model.load_motion;
        result.report    = solver.solve(step, result.forces);
        const Eigen::VectorXd q =
          q_free - compliance.cwiseProduct(Psi.transpose() * result.forces);
        const double change = held.cwiseProduct(q - result.coordinates).norm();
        result.coordinates  = q;
        if (change <= 1e-11 * f.norm())
          break;
        if (i > 200 || !(change < 1e6 * f.norm()))
          throw ComputationError(
            "there is no steady sliding: nothing presses the bodies of the "
            "contact together, or the friction wedges or sprags");
      }
    result.motion = solver.motion();
    result.status = solver.status();
    return result;
  }



  LinearizedMotion
  linearize(const ReducedContactModel &model,
            const SteadySliding       &steady,
            const double               friction,
            const double               speed)
  {
    std::vector<int> normal, transverse;
    Eigen::VectorXd  kappa(3 * model.n_nodes());
    for (unsigned int j = 0; j < model.n_nodes(); ++j)
      if (steady.status[j] != ContactStatus::open)
        {
          normal.push_back(3 * j);
          transverse.push_back(3 * j + 2);
        }
    const Eigen::Index    n = model.n_modes(), m = normal.size();
    const Eigen::MatrixXd Psi_n = model.participation(normal, Eigen::all);
    const Eigen::MatrixXd Psi_s = model.participation(transverse, Eigen::all);
    std::vector<int>      tangential = normal;
    for (int &i : tangential)
      ++i;
    const Eigen::MatrixXd Psi_t = model.participation(tangential, Eigen::all);
    Eigen::VectorXd       rate(m);
    for (Eigen::Index i = 0; i < m; ++i)
      rate[i] = friction * steady.forces[normal[i]] /
                (speed * model.speed_ratio[normal[i] / 3]);
    // lambda_s = rate Psi_s v; G_nn lambda_n + mu G_nt lambda_n + G_ns lambda_s
    // = Psi_n q.
    const Eigen::MatrixXd                     &G = model.flexibility;
    const Eigen::PartialPivLU<Eigen::MatrixXd> factor(
      Eigen::MatrixXd(G(normal, normal) + friction * G(normal, tangential)));
    const Eigen::MatrixXd lambda_s = rate.asDiagonal() * Psi_s;
    const Eigen::MatrixXd by_q     = factor.solve(Psi_n);
    const Eigen::MatrixXd by_v =
      -factor.solve(Eigen::MatrixXd(G(normal, transverse) * lambda_s));
    const Eigen::MatrixXd drag = (Psi_n + friction * Psi_t).transpose();
    Eigen::MatrixXd       A    = Eigen::MatrixXd::Zero(2 * n, 2 * n);
    A.topRightCorner(n, n).setIdentity();
    A.bottomLeftCorner(n, n) = -drag * by_q;
    A.bottomLeftCorner(n, n).diagonal() -= model.omega_squared;
    A.bottomRightCorner(n, n) = -drag * by_v - Psi_s.transpose() * lambda_s;
    A.bottomRightCorner(n, n).diagonal() -= model.damping;

    // Positions in the unit of velocities: the matrix is balanced, and the left
    // vectors come from the inverse of the right ones.
    const double unit = std::sqrt(std::max(1., model.omega_squared.mean()));
    A.topRightCorner(n, n) *= unit;
    A.bottomLeftCorner(n, n) /= unit;
    const Eigen::EigenSolver<Eigen::MatrixXd> solver(A);
    const Eigen::MatrixXcd inverse = solver.eigenvectors().inverse();

    std::vector<int> kept;
    for (Eigen::Index k = 0; k < 2 * n; ++k)
      if (solver.eigenvalues()[k].imag() >= 0.)
        kept.push_back(k);
    std::sort(kept.begin(), kept.end(), [&](const int a, const int b) {
      return solver.eigenvalues()[a].imag() < solver.eigenvalues()[b].imag();
    });
    LinearizedMotion result;
    result.lambda.resize(kept.size());
    result.left.resize(kept.size(), 2 * n);
    for (std::size_t i = 0; i < kept.size(); ++i)
      {
        result.lambda[i] = solver.eigenvalues()[kept[i]];
        const double size =
          solver.eigenvectors().col(kept[i]).tail(n).norm() / std::sqrt(2.);
        result.left.row(i) = size * inverse.row(kept[i]);
        result.left.row(i).head(n) *= unit;
      }
    return result;
  }
} // namespace squeal
