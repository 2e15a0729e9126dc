// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_cycle_harmonic_balance_h
#define squeal_cycle_harmonic_balance_h

#include <squeal/cycle/cycle_friction.h>
#include <squeal/cycle/shooting.h>

#include <Eigen/Dense>

#include <vector>

namespace squeal
{
  /** A periodic motion by its contact forces at equal parts of the period. */
  struct HarmonicMotion
  {
    Eigen::MatrixXd forces;    /**< lambda, N: three a node x samples */
    Eigen::VectorXd positions; /**< m sqrt(kg): mean coordinates of the motions
                                  that nothing holds (omega = 0) */
    double omega = 0.;         /**< rad/s */
    /** Damping added to that of every mode, 1/s: 0 in a motion of the model. */
    double excess_damping = 0.;

    /** Of the last evaluation: B u, m, and its rate, m/s. */
    Eigen::MatrixXd                         motion, rate;
    std::vector<std::vector<ContactStatus>> status; /**< samples x nodes */
    double residual = 0.; /**< of the law at the samples, over the mean
                             force */
    unsigned int iterations = 0;
    bool         converged  = false;
  };

  /** Energies of a period, J, each positive. */
  struct PeriodLedger
  {
    double damping   = 0.; /**< taken by the modes' damping */
    double friction  = 0.; /**< taken by slip */
    double driving   = 0.; /**< given by the sliding targets */
    double numerical = 0.; /**< taken by normal forces that move a gap: what the
                              law misses between the samples */
    /** What does not add up, over the driving work. */
    double imbalance() const;
  };

  /**
   * Periodic motions by harmonic balance with alternating frequency and time:
   * the unknowns are the contact forces at N = 2 H + 1 equal parts of the
   * period, whose response is taken harmonic by harmonic,
   *   u_k = a_k - H(k omega) lambda_k,
   *   H(w) = Psi (diag(omega_m^2) - w^2 + i w D)^-1 Psi^T + G,
   * statics for k = 0, where motions that nothing holds keep their mean
   * position as an unknown and their mean force balances the load. The exact
   * law holds at all N samples (collocation) with the slip rate by the spectral
   * derivative:
   *   lambda_n = max(0, lambda_n - rho g),
   *   lambda_t = P(lambda_t + rho v_t).
   * Semi-smooth Newton's method on all closed samples at once; open ones are
   * eliminated. The matrix is dense: memory and time grow with the square and
   * the cube of (closed nodes x samples).
   *
   * Cameron and Griffin 1989 (doi:10.1115/1.3176036); Nacivet et al. 2003
   * (doi:10.1016/S0022-460X(02)01447-5).
   */
  class HarmonicBalance
  {
  public:
    /** Which number is held beside the phase. */
    enum class Held
    {
      no_excess, /**< the frequency is free: a motion of the model */
      frequency, /**< the excess damping is free */
      amplitude /**< both are free: the first harmonic of the mode that vibrates
                   most at the start keeps its size */
    };

    /** References are kept. @p force: N, that residuals are measured in.
     * Throws InputError for fewer than three or an even number of samples. */
    HarmonicBalance(const ReducedContactModel &model,
                    CycleFriction              friction,
                    const double               force,
                    const unsigned int         n_samples);

    /** Improves @p start, whose forces are sampled anew where their number is
     * another one. `converged` says how it went.
     * Throws InputError where the matrix would be larger than 6000. */
    HarmonicMotion solve(HarmonicMotion     start,
                         const Held         held       = Held::no_excess,
                         const double       tolerance  = 1e-9,
                         const unsigned int iterations = 60) const;

    /** Motion, rate, status and residual of given forces. */
    void evaluate(HarmonicMotion &m) const;

    /** The largest violation of the law on @p factor times as many samples of
     * the trigonometric polynomials, over the mean force. */
    double violation_between(const HarmonicMotion &m,
                             const unsigned int    factor = 8) const;

    PeriodLedger ledger(const HarmonicMotion &m) const;

    /** Harmonics 0 .. H of the modes' coordinates: modes x (H + 1). */
    Eigen::MatrixXcd modal_harmonics(const HarmonicMotion &m) const;

  private:
    struct Law;
    struct Jacobian;
    class Receptance;

    Receptance receptance(const unsigned int k, const HarmonicMotion &m) const;
    Eigen::MatrixXcd relative_motion(const Eigen::MatrixXcd &q,
                                     const Eigen::MatrixXcd &lambda) const;
    Law              law_at(const unsigned int     node,
                            const Eigen::Vector3d &lambda,
                            const Eigen::Vector3d &u,
                            const Eigen::Vector3d &rate,
                            const double           omega) const;

    const ReducedContactModel &model;
    const CycleFriction        friction;
    const double               force;
    const unsigned int         n;    /**< samples */
    std::vector<int>           free; /**< modes that nothing holds */
  };

  /** The start that a periodic motion by shooting gives. */
  HarmonicMotion harmonic_start(const ReducedContactModel &model,
                                const PeriodicMotion      &motion);

  /** Values at other equal parts of a period by their harmonics. */
  Eigen::MatrixXd resampled(const Eigen::MatrixXd &values,
                            const unsigned int     n);

  /** Harmonics 0 .. H, H = (samples - 1)/2, of each row of @p values:
   * x = x_0 + 2 Re sum_k x_k e^{i k theta}. */
  Eigen::MatrixXcd harmonics_of(const Eigen::MatrixXd &values);
} // namespace squeal

#endif
