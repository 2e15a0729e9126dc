// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_output_pair_table_h
#define squeal_output_pair_table_h

#include <squeal/eigen/complex_pairs.h>
#include <squeal/results/table.h>

#include <functional>
#include <string>
#include <vector>

namespace squeal
{
  /** All that a row of eigenvalues.csv says of a complex pair. */
  struct PairRow
  {
    /** Takes eigenvalue, residual, error and condition of pair @p i. */
    PairRow(const ComplexPairs &pairs, const unsigned int i);

    std::size_t          point = 0; /**< of the parameters, from 0 */
    unsigned int         index;     /**< of the pair, from 1 */
    std::string          branch;    /**< of a sweep */
    std::complex<double> lambda;    /**< 1/s */
    Cell                 residual;  /**< nothing where it is not formed */
    double               error_estimate, condition;
    bool                 is_unstable; /**< sigma beyond its error */
    std::string          name;
    std::vector<double>  energy_shares; /**< one a body */
    double               energy_per_cycle = 0.;
    Cell                 contact_participation; /**< nothing without contact */
    std::string          partners[2];
    std::string          contact_state;
    double               discretisation_error; /**< NaN: not estimated */
    std::complex<double> mesh_error; /**< lambda - lambda_h, 1/s; or NaN */
  };

  /** One column: declared here and nowhere else. */
  struct PairColumn
  {
    Table::Column                        column;
    std::function<Cell(const PairRow &)> value;
  };

  /** The columns before and behind the energy shares of the bodies, in the
   * order of the file. A new one goes to the end of the second list. */
  const std::vector<PairColumn> &pair_columns_before_shares();
  const std::vector<PairColumn> &pair_columns_behind_shares();

  /**
   * eigenvalues.csv of every analysis that has one. A sweep puts the values of
   * its axes behind the number of the point and its own columns at the end.
   */
  class PairTable
  {
  public:
    PairTable(const std::vector<std::string>   &bodies,
              const std::vector<Table::Column> &axes   = {},
              const std::vector<Table::Column> &at_end = {});

    /** The row with the cells of the columns that only the caller has. */
    void add(const PairRow           &row,
             const std::vector<Cell> &axes   = {},
             const std::vector<Cell> &at_end = {});

    const Table &table() const;

  private:
    Table result;
  };
} // namespace squeal

#endif
