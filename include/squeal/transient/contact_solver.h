// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_transient_contact_solver_h
#define squeal_transient_contact_solver_h

#include <squeal/base/named_numbers.h>
#include <squeal/contact/contact_geometry.h>
#include <squeal/transient/kept_inverse.h>
#include <squeal/transient/rising_friction.h>

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
    double          speed;    /**< that those of nodes are measured by, m/s */
    /** mu >= 0 of every node; empty: `friction` at all of them. */
    Eigen::VectorXd nodal_friction = {};
    /** Of every node, for those whose friction follows the slip rate of this
     * step instead; empty: of none. */
    std::vector<RisingFriction> rising = {};

    double
    friction_at(const unsigned int node) const
    {
      return nodal_friction.size() > 0 ? nodal_friction[node] : friction;
    }
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
   *   parallel to lambda_t, and none where |lambda_t| < mu lambda_n;
   * mu is given, or that of the slip rate |s| / duration where it rises.
   *
   * Semi-smooth Newton iterations (Alart and Curnier 1991). The inverse of the
   * Jacobian of one contact state is kept; nodes whose status or slip direction
   * has changed since are a low-rank change of it (Woodbury), until they are
   * too many. Where the iterations cycle, projected Gauss-Seidel sweeps (Jean
   * 1999) take over until Newton's method converges.
   *
   * The residual is the largest violation of the projected law, |lambda -
   * P(lambda + rho (gap or slip))|, over the mean nodal force.
   */
  class ContactSolver
  {
  public:
    /** @p delassus: symmetric, positive definite on each node, m/N. @p force:
     * the mean nodal force, N, that residuals are measured in. */
    enum class Precision
    {
      single, /**< of the kept inverse, which only has to contract; full from
                   when it does not */
      full
    };
    enum class Method
    {
      newton,
      gauss_seidel /**< projected sweeps alone */
    };
    ContactSolver(Eigen::MatrixXd delassus,
                  Eigen::VectorXd initial_gap,
                  Eigen::VectorXd speed_ratio,
                  const double    force,
                  const double    tolerance = 1e-8,
                  const Precision precision = Precision::single,
                  const Method    method    = Method::newton);

    /** Another operator for the solutions to come. What is kept of the one
     * before still serves where the two are close, as it only has to contract;
     * it is renewed where iterations become slow, and dropped where the nodes
     * have become much stiffer or softer. */
    void set_operator(const Eigen::MatrixXd &delassus);

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

    /** Inverses computed anew so far. */
    unsigned int n_inversions() const;

    /** @name What later iterations depend on, for checkpoints */
    //@{
    NamedNumbers memory() const;
    /** Throws InputError, before anything is changed but the rows, where sizes
     * are not those of this solver. */
    void restore(const NamedNumbers &memory);
    //@}

  private:
    struct Projection; // of one node

    /** Newton's method with the law scaled as it is. */
    bool iterate(const ContactStep &step,
                 Eigen::VectorXd   &lambda,
                 ContactReport     &report);
    /** Multiplies what the law is scaled by at each node. */
    void scale_law(const double factor);

    Projection project(const ContactStep     &step,
                       const Eigen::VectorXd &lambda,
                       const unsigned int     node) const;
    /** Violation, states and rows from u; returns the residual. */
    double   check_law(const ContactStep &step, const Eigen::VectorXd &lambda);
    double   evaluate(const ContactStep &step, const Eigen::VectorXd &lambda);
    NodeRows rows_of(const Projection &p) const;
    /** Sets the three rows @p J of node @p j. */
    void set_jacobian(const unsigned int                        j,
                      const NodeRows                           &rows,
                      Eigen::Ref<KeptInverse<double>::Jacobian> J) const;
    void invert();
    /** The operator of `base`. */
    void set_inverse();
    void set_update();
    void extend_update(const std::vector<unsigned int> &nodes);
    /** Makes the operator fit the states at hand. */
    void adapt(const bool renew);
    void sweep(const ContactStep &step, Eigen::VectorXd &lambda);
    /** Sweeps until the law holds. */
    ContactReport            sweep_to_the_end(const ContactStep &step,
                                              Eigen::VectorXd   &lambda);
    [[noreturn]] static void throw_no_solution(const ContactReport &report);

    /** An operator and what the law is scaled by at each node. */
    struct Operator
    {
      Operator() = default;
      Operator(Eigen::MatrixXd delassus, const Eigen::VectorXd &speed_ratio);

      Eigen::MatrixXd W;
      Eigen::VectorXd rho_normal, rho_tangential; /**< N/m */
    };
    /** The one that the inverse and its changes are made of. */
    const Operator &kept_operator() const;

    Operator              now;
    Operator              kept; /**< empty: `now` */
    const Eigen::VectorXd gap, ratio;
    const double          mean_force, tolerance;

    Eigen::VectorXd            u, violation;
    std::vector<ContactStatus> states;
    std::vector<NodeRows>      rows; /**< at the last evaluation */
    unsigned int               n_inverted = 0;

    KeptInverse<float>        single;
    KeptInverse<double>       full;
    bool                      is_single;
    const bool                starts_single;
    const Method              method;
    bool                      has_inverse = false;
    std::vector<NodeRows>     base, updated;
    std::vector<unsigned int> changed;
  };
} // namespace squeal

#endif
