// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/transient/explicit_transient.h>

#include <Eigen/Eigenvalues>

#include <cmath>
#include <random>
#include <sstream>

namespace squeal
{
  namespace
  {
    constexpr unsigned int lanczos_steps     = 150;
    constexpr double       lanczos_tolerance = 1e-3;

    /** The mass of each unknown. Throws InputError. */
    Eigen::VectorXd
    diagonal_mass(const Pencil &pencil)
    {
      const Eigen::Index n = pencil.space()->n_owned();
      Block              x = Block::Ones(n, 2);
      for (Eigen::Index i = 0; i < n; i += 2)
        x(i, 1) = -1.;
      const Block           M_x  = pencil.multiply_mass(x);
      const Eigen::VectorXd mass = M_x.col(0);
      const double          off =
        (M_x.col(1) - mass.cwiseProduct(x.col(1))).cwiseAbs().maxCoeff();
      if (!(off <= 1e-10 * mass.maxCoeff()) || !(mass.minCoeff() > 0.))
        throw InputError("Discretization/Mass: the explicit integrator needs a "
                         "positive diagonal mass; set it to lumped, and avoid "
                         "ties between meshes that do not match and rigid "
                         "bodies");
      return mass;
    }

    /** The largest eigenvalue of M^-1 C, 1/s: with the largest of M^-1 K it
     * bounds the step from below, whatever the two have in common. */
    double
    largest_damping(const Pencil &pencil, const Eigen::VectorXd &mass)
    {
      return std::pow(largest_frequency(pencil.combined(0., 1., 0.), mass), 2);
    }
  } // namespace



  double
  largest_frequency(const Pencil &pencil, const Eigen::VectorXd &mass)
  {
    const Eigen::VectorXd scale = mass.cwiseSqrt().cwiseInverse();
    const Eigen::Index    n     = mass.size();
    const unsigned int    steps =
      static_cast<unsigned int>(std::min<Eigen::Index>(n, lanczos_steps));
    std::mt19937                     generator(1);
    std::normal_distribution<double> normal;
    Block                            Q = Block::Zero(n, steps + 1);
    Q.col(0) =
      Eigen::VectorXd::NullaryExpr(n, [&]() { return normal(generator); });
    Q.col(0).normalize();
    Eigen::MatrixXd T       = Eigen::MatrixXd::Zero(steps, steps);
    double          largest = 0.;
    for (unsigned int k = 0; k < steps; ++k)
      {
        Eigen::VectorXd x =
          scale.cwiseProduct(Eigen::VectorXd(pencil.multiply_undamped_stiffness(
            Block(scale.cwiseProduct(Q.col(k))))));
        T(k, k) = x.dot(Q.col(k));
        for (unsigned int pass = 0; pass < 2; ++pass)
          x -= Q.leftCols(k + 1) * (Q.leftCols(k + 1).transpose() * x);
        const double                                         size = x.norm();
        const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> ritz(
          T.topLeftCorner(k + 1, k + 1));
        const double residual = size * std::abs(ritz.eigenvectors()(k, k));
        largest               = ritz.eigenvalues()[k] + residual;
        if (residual <= lanczos_tolerance * largest || k + 1 == steps)
          break;
        T(k, k + 1) = T(k + 1, k) = size;
        Q.col(k + 1)              = x / size;
      }
    return std::sqrt(largest);
  }



  double
  critical_step(const double omega,
                const double alpha,
                const double beta,
                const double beta_2)
  {
    const double c = alpha + beta * omega * omega, k = beta_2 * omega * omega;
    // The root of k h^2 + c h - 2 in a form without cancellation.
    return 4. / (c + std::sqrt(c * c + 8. * k));
  }



  ExplicitTransient::ExplicitTransient(FullContactModel            m,
                                       const double                time_step,
                                       TransientDrive              d,
                                       const double                nodal_force,
                                       const double                tolerance,
                                       const ContactSolver::Method method,
                                       const double                b)
    : FullTransient(std::move(m), time_step, std::move(d))
    , beta_2(b)
    , mass(diagonal_mass(*model.pencil))
    , stable_step(critical_step(
        largest_frequency(*model.pencil, mass),
        has_damping_matrix ? largest_damping(*model.pencil, mass) : alpha,
        beta,
        beta_2))
    , stiffness(model.pencil->undamped_entries(0.), mass.size())
  {
    if (dt > stable_step)
      {
        std::ostringstream text;
        text << "Transient/Time step: " << dt
             << " s is above the largest stable step of the explicit "
                "integrator, "
             << stable_step << " s";
        throw InputError(text.str());
      }
    set_contact(nodal_force, tolerance, method);
  }

  Eigen::MatrixXd
  ExplicitTransient::delassus()
  {
    // Unknown by unknown: each belongs to a few nodes.
    std::vector<Eigen::Triplet<double>> entries;
    for (unsigned int r = 0; r < B->n_rows(); ++r)
      for (const auto &[column, weight] : B->rows()[r])
        entries.emplace_back(r, column, weight);
    Eigen::SparseMatrix<double> columns(B->n_rows(), mass.size());
    columns.setFromTriplets(entries.begin(), entries.end());
    Eigen::MatrixXd W = Eigen::MatrixXd::Zero(B->n_rows(), B->n_rows());
    using Entry       = Eigen::SparseMatrix<double>::InnerIterator;
    for (Eigen::Index k = 0; k < columns.outerSize(); ++k)
      for (Entry i(columns, k); i; ++i)
        for (Entry j(columns, k); j; ++j)
          W(j.row(), i.row()) += j.value() * i.value() / mass[k];
    return (beta_2 + 0.5) * dt * dt * W;
  }



  void
  ExplicitTransient::initialize()
  {
    K_u               = stiffness_times(u);
    Eigen::VectorXd f = applied(0., lambda) - K_u - beta * stiffness_times(v);
    if (has_damping_matrix)
      f -= damping_matrix_times(v);
    if (model.inertia)
      f += inertial_force(0.);
    a                = f.cwiseQuotient(mass) - alpha * v;
    w                = v - beta_2 * dt * a;
    energies.kinetic = 0.5 * w.dot(mass.cwiseProduct(w));
    energies.elastic = 0.5 * K_u.dot(u - dt * w - (beta_2 - 0.5) * dt * dt * a);
  }

  std::vector<std::pair<std::string, Eigen::VectorXd *>>
  ExplicitTransient::further_state()
  {
    return {{"lagged_velocities", &w}, {"elastic_forces", &K_u}};
  }

  double
  ExplicitTransient::largest_step() const
  {
    return stable_step;
  }



  void
  ExplicitTransient::multiply_by_stiffness()
  {
    if (n_steps > 0 && beta_2 == 0.5)
      K_w = -K_u;
    stiffness.multiply(u, K_u);
    if (n_steps > 0 && beta_2 == 0.5)
      K_w = (K_w + K_u) / dt;
    else
      stiffness.multiply(w, K_w);
  }



  ContactReport
  ExplicitTransient::advance()
  {
    const double          t     = time();
    const Eigen::VectorXd f     = external_force(t);
    const Eigen::VectorXd g     = inertial_force(t);
    const Eigen::VectorXd C_w   = damping_matrix_times(w);
    const double          reach = (beta_2 + 0.5) * dt * dt;
    const Eigen::Index    n     = u.size();
    multiply_by_stiffness();
    Eigen::VectorXd a_now(n);
    predicted.resize(n);
    for (Eigen::Index i = 0; i < n; ++i)
      {
        a_now[i] = (f[i] - K_u[i] - beta * K_w[i]) / mass[i] - alpha * w[i];
        if (g.size() > 0)
          a_now[i] += g[i] / mass[i];
        if (has_damping_matrix)
          a_now[i] -= C_w[i] / mass[i];
        predicted[i] = u[i] + dt * w[i] + reach * a_now[i];
      }
    ContactStep step = contact_step(t + dt);
    turn(step);
    step.free_motion     = relative(predicted) + model.motion_offset;
    step.previous_motion = nodes_motion;

    Eigen::VectorXd     next   = extrapolated_forces();
    const ContactReport report = solver->solve(step, next);
    Block               pull   = Block::Zero(n, 1);
    B->add_transposed(Eigen::MatrixXd(next), pull);

    // One pass over the vectors: a step is bound by memory traffic.
    Eigen::VectorXd moved(n), u_next(n);
    double damping = 0., load = 0., numerical = 0., kinetic = 0., elastic = 0.;
    for (Eigen::Index i = 0; i < n; ++i)
      {
        const double a_i = a_now[i] - pull(i) / mass[i];
        moved[i]         = dt * w[i] + 0.5 * dt * dt * a_i;
        u_next[i]        = u[i] + dt * w[i] + reach * a_i;
        damping += moved[i] * (alpha * mass[i] * w[i] + beta * K_w[i]);
        load += moved[i] * f[i];
        numerical += (a_i + a[i]) * K_u[i];
        elastic += u_next[i] * K_u[i];
        w[i] += dt * a_i;
        kinetic += mass[i] * w[i] * w[i];
        v[i]     = w[i] + beta_2 * dt * a_i;
        a_now[i] = a_i;
      }
    energies.damping += damping;
    if (has_damping_matrix)
      energies.damping += moved.dot(C_w);
    energies.load += load;
    if (g.size() > 0)
      energies.driving += moved.dot(g);
    energies.numerical -= 0.5 * (beta_2 - 0.5) * dt * dt * numerical;
    enter_contact_work(step, next, relative(moved));
    a                = a_now;
    energies.kinetic = 0.5 * kinetic;
    energies.elastic = 0.5 * elastic;
    finish_step(step, u_next, next);
    return report;
  }
} // namespace squeal
