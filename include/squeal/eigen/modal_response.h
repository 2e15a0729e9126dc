// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_eigen_modal_response_h
#define squeal_eigen_modal_response_h

#include <squeal/base/mumps.h>
#include <squeal/eigen/complex_pairs.h>

#include <memory>

namespace squeal
{
  /**
   * Receptances C^T Q(i omega)^-1 B of the full problem, from a complex LU of
   * the dynamic stiffness Q(i omega) = K + i omega C - omega^2 M at each
   * frequency.
   */
  class DirectResponse
  {
  public:
    /** @p forces and @p observations: one column a point, rows of the
     * pencil. */
    DirectResponse(const Pencil &pencil,
                   const Block  &forces,
                   const Block  &observations);

    /** Responses x forces at @p omega in rad/s. Throws ComputationError where
     * the dynamic stiffness is singular. */
    Eigen::MatrixXcd solve(const double omega) const;

  private:
    const Pencil &pencil;
    Block         forces, observations;
  };



  /**
   * Receptances by superposition of complex modes,
   * H(s) = sum_k c_k b_k / (s - lambda_k) + R_0 + s R_1 + s^2 R_2, s = i omega,
   * c_k = C^T x_k, b_k = y_k^T B / (y_k^T (2 lambda_k M + C) x_k), each
   * conjugate pair with both members. Left vectors are not right ones where
   * contact slides. The residual terms R stand for the modes that are left out;
   * each is found from one exact solution. With structural damping eigenvalues
   * do not come in conjugates: the partner of lambda_k is then taken as
   * -lambda_k - y^T C x / y^T M x with the same vectors, exact where damping
   * does not couple the modes.
   */
  class ModalResponse
  {
  public:
    /** @p pairs hold all modes from 0 Hz up to some frequency. Members of a
     * multiple eigenvalue are made biorthogonal. */
    ModalResponse(const Pencil       &pencil,
                  const ComplexPairs &pairs,
                  const Block        &forces,
                  const Block        &observations);

    /** R_0: makes H(0) equal to @p exact. */
    void set_flexibility(const Eigen::MatrixXcd &exact);
    /** R_1 and R_2: makes H(i omega) equal to @p exact, after
     * set_flexibility(). */
    void set_inertia(const double omega, const Eigen::MatrixXcd &exact);

    /** Responses x forces. */
    Eigen::MatrixXcd receptance(const double omega) const;

    /** c_k b_k of response @p i and force @p j for every pair, m/(N s). */
    Eigen::VectorXcd residues(const unsigned int i, const unsigned int j) const;
    /** C^T x_k: responses x pairs. */
    const Eigen::MatrixXcd &shapes() const;

  private:
    Eigen::MatrixXcd superposition(const std::complex<double> s) const;

    Eigen::VectorXcd lambda, partner;
    Eigen::VectorXd  has_partner;   /**< 0 for real eigenvalues */
    Eigen::MatrixXcd observed;      /**< responses x pairs */
    Eigen::MatrixXcd participation; /**< pairs x forces */
    Eigen::MatrixXcd flexibility, first, second;
    bool             is_real; /**< M, C and K are */
  };
} // namespace squeal

#endif
