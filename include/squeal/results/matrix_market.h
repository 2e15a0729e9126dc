// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_results_matrix_market_h
#define squeal_results_matrix_market_h

#include <squeal/base/linear_operator.h>

#include <complex>
#include <memory>
#include <string>
#include <vector>

namespace squeal
{
  /** One term factor * operator of a matrix that is written. */
  struct MatrixTerm
  {
    std::complex<double>                  factor;
    std::shared_ptr<const LinearOperator> matrix;
  };

  /**
   * Writes the sum of @p terms as a MatrixMarket file (format of NIST,
   * `matrix coordinate`): rows and columns from 1 in the order of @p space,
   * ascending, each place once, zeros left out, every number with as many
   * digits (17 at most) as bring the same double back. The file is `symmetric`
   * and holds the lower triangle where every term is symmetric, else
   * `general`; `complex` where a factor is, else `real`. Without terms it is a
   * matrix of zeros. @p comment becomes one `%` line.
   *
   * Collective over the ranks of @p space: the entries are gathered on its rank
   * 0, which writes if it is @p is_root. Throws InputError where the file
   * cannot be written (nothing half written is left behind), and on every rank
   * where the entries are more than one rank can receive (2^31 - 1).
   */
  void write_matrix_market(const std::string             &path,
                           const bool                     is_root,
                           const RowSpace                &space,
                           const std::vector<MatrixTerm> &terms,
                           const std::string             &comment);

  /** Writes a full complex matrix (`matrix array complex general`: the columns
   * one after the other, a number a line), with the digits as above. Not
   * collective. */
  void write_matrix_market(const std::string      &path,
                           const Eigen::MatrixXcd &values,
                           const std::string      &comment);
} // namespace squeal

#endif
