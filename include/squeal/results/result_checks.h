// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_results_result_checks_h
#define squeal_results_result_checks_h

#include <squeal/parameters/analysis_parameters.h>
#include <squeal/results/table.h>

#include <map>
#include <string>
#include <vector>

namespace squeal
{
  class RunLog;

  /** One expected value of the parameter file and what came out. */
  struct ResultCheck
  {
    std::string name;
    bool        passed    = false;
    bool        has_value = false; /**< a number was found to compare */
    double      got       = 0.;
    double      expected  = 0.;
    double      tolerance = 0.; /**< absolute, as applied */
    std::size_t n_rows    = 0;  /**< rows that were compared */
    std::string reason;         /**< why there is no value, or no row */

    /** "ok      name: got ..., expected ..., tolerance ...". */
    std::string line() const;
  };

  /**
   * Rows of @p table that meet @p condition: "column = text", also with !=, <,
   * <=, > and >=, several of them joined by " and "; numbers are compared as
   * numbers. An empty condition selects all rows. Throws InputError for a
   * column that does not exist or a condition that cannot be read.
   */
  std::vector<std::size_t> select_rows(const Table       &table,
                                       const std::string &condition);

  /**
   * Compares the expected values of a parameter file with the result @p tables,
   * known by their file names.
   *
   * A check takes the rows that `where` selects and of these, if `nearest` is
   * given, the one nearest to its number. *Every* row left must hold
   * |got - expected| <= max(relative_tolerance |expected|,
   * absolute_tolerance); the worst is reported. The column "count" stands for
   * the number of rows; where that is 0 the line says so, and names the text
   * that is in no row of the table. A check that selects no row (other than by
   * "count"), or names a table or column that does not exist, fails and says
   * so.
   */
  std::vector<ResultCheck> evaluate_result_checks(
    const std::vector<ResultCheckParameters>   &checks,
    const std::map<std::string, const Table *> &tables);

  /** Prints one line a check. */
  void print_result_checks(const std::vector<ResultCheck> &checks, RunLog &log);

  /** Throws CheckError that names what failed, if anything did. */
  void require_passed(const std::vector<ResultCheck> &checks);
} // namespace squeal

#endif
