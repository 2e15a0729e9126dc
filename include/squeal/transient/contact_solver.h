// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_transient_contact_solver_h
#define squeal_transient_contact_solver_h

#include <squeal/contact/contact_geometry.h>

#include <Eigen/Dense>

#include <vector>

namespace squeal
{
  /** What one solution needs besides the operators. */
  struct ContactStep
  {
    /** Relative motion of the nodes without contact forces, m; three a node:
     * normal, along and across the sliding. */
    Eigen::VectorXd free_motion;
    /** The relative motion from which slip is counted, m. */
    Eigen::VectorXd previous_motion;
    double          duration; /**< s, over which the target slides on */
    double          friction; /**< mu >= 0 */
    double          speed;    /**< |V| at the centre of the face, m/s */
  };

  /** How a solution went. */
  struct ContactReport
  {
    unsigned int iterations = 0; /**< of Newton's method */
    unsigned int sweeps     = 0; /**< of Gauss and Seidel's */
    double       residual   = 0.;
  };

  /**
   * Signorini's conditions and Coulomb's law at the nodes of a face over the
   * Delassus operator W: with the motion u = a - W lambda,
   *   0 <= lambda_n complementary to g = g_0 - u_n >= 0,
   *   |lambda_t| <= mu lambda_n, slip s = duration V + (u - u_previous)_t
   *   parallel to lambda_t, and none where |lambda_t| < mu lambda_n.
   *
   * Semi-smooth Newton iterations (Alart and Curnier 1991) on the closed nodes;
   * the factor is kept as long as no status changes and it still contracts.
   * Where they cycle, projected Gauss-Seidel sweeps (Jean 1999) take over until
   * Newton's method converges.
   *
   * The residual is the largest violation of the projected law, |lambda -
   * P(lambda + rho (gap or slip))|, over the mean nodal force.
   */
  class ContactSolver
  {
  public:
    /** @p delassus: symmetric, positive definite on each node, m/N. @p force:
     * the mean nodal force, N, that residuals are measured in. */
    ContactSolver(Eigen::MatrixXd delassus,
                  Eigen::VectorXd initial_gap,
                  Eigen::VectorXd speed_ratio,
                  const double    force,
                  const double    tolerance = 1e-8);

    /** Starts at @p lambda and improves it. Throws ComputationError where no
     * solution is found. */
    ContactReport solve(const ContactStep &step, Eigen::VectorXd &lambda);

    /** Newton's method alone: false, with @p lambda spoilt, where it does not
     * converge. */
    bool newton(const ContactStep &step,
                Eigen::VectorXd   &lambda,
                ContactReport     &report);

    /** Of the last solution. */
    const std::vector<ContactStatus> &status() const;
    /** u = a - W lambda of the last solution. */
    const Eigen::VectorXd &motion() const;

  private:
    struct Projection; // of one node
    Projection project(const ContactStep     &step,
                       const Eigen::VectorXd &lambda,
                       const unsigned int     node) const;
    double     evaluate(const ContactStep &step, const Eigen::VectorXd &lambda);
    void factorize(const ContactStep &step, const Eigen::VectorXd &lambda);
    void sweep(const ContactStep &step, Eigen::VectorXd &lambda);
    /** Takes the forces off open nodes; true where there were any. */
    bool release_open(Eigen::VectorXd &lambda) const;

    const Eigen::MatrixXd W;
    const Eigen::VectorXd gap, ratio;
    const double          mean_force, tolerance;
    Eigen::VectorXd       rho_normal, rho_tangential; /**< N/m, of each node */

    Eigen::VectorXd                      u, violation;
    std::vector<ContactStatus>           states, factored_states;
    std::vector<int>                     closed; /**< rows of the factor */
    Eigen::PartialPivLU<Eigen::MatrixXd> factor;
  };
} // namespace squeal

#endif
