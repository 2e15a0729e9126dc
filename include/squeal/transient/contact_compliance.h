// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_transient_contact_compliance_h
#define squeal_transient_contact_compliance_h

#include <squeal/base/low_rank_matrix.h>
#include <squeal/eigen/undamped_modes.h>

#include <Eigen/Dense>

#include <map>
#include <vector>

namespace squeal
{
  /**
   * What forces at the unknowns that a turning contact can meet move there:
   * entries of the inverse of a shifted matrix. A column is solved for when the
   * contact gets to its unknown, alone, so that its bits do not depend on when
   * that is.
   */
  class ContactCompliance
  {
  public:
    /** Unknowns @p rows in ascending order; @p inverse must live on. Throws
     * InputError where all columns together are too large for the memory. */
    ContactCompliance(const ShiftedInverse     &inverse,
                      std::vector<unsigned int> rows,
                      const unsigned int        n_unknowns);

    /** B A^-1 B^T. */
    Eigen::MatrixXd product(const Functionals &B);

    unsigned int n_columns() const; /**< solved for so far */

  private:
    const Eigen::VectorXd &column(const unsigned int row);

    const ShiftedInverse                   &inverse;
    const std::vector<unsigned int>         rows;
    const unsigned int                      n_unknowns;
    std::map<unsigned int, Eigen::VectorXd> columns;
  };
} // namespace squeal

#endif
